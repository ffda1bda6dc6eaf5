// SPDX-License-Identifier: MIT
// Starts the page of a report: its data, its files, and the loop of pictures. `?manual=1` stands still, for tests.
import './report.css';
import { parseGlb } from '../src/files';
import { messageOf, say } from '../src/page';
import { baseName, readBytes, readData } from './data';
import { Report } from './report';

/// What scripts may do with the page.
export interface ManualReport
{
	/// To a time, and shows it.
	stepTo( time: number ): void;
	places(): ReturnType<Report[ 'places' ]>;
}

declare global
{
	interface Window
	{
		report?: ManualReport;
	}
}

function run( report: Report ): void
{
	let last = performance.now();
	const next = ( now: number ): void =>
	{
		report.tick( Math.min( ( now - last ) / 1000, 0.25 ) );
		last = now;
		requestAnimationFrame( next );
	};
	requestAnimationFrame( next );
}

async function start(): Promise<void>
{
	const data = readData();
	const [ character, ground ] = await Promise.all( [ parseGlb( baseName( data.character ), readBytes( 'character' ) ),
		parseGlb( baseName( data.ground ), readBytes( 'ground' ) ) ] );
	const report = new Report( data, character, ground, new URLSearchParams( location.search ).get( 'manual' ) === '1' );
	run( report );
	window.report = {
		stepTo: ( time ) =>
		{
			report.setTime( time );
			report.tick( 0 );
		},
		places: () => report.places(),
	};
	document.documentElement.dataset[ 'ready' ] = 'true';
}

start().catch( ( error: unknown ) => say( `The report can't be shown: ${messageOf( error )}`, true ) );
