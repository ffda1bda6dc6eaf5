// SPDX-License-Identifier: MIT
// Starts the page: the library, the samples, what the address asks for, and the loop of pictures.
import './style.css';
import { listSamples } from './files';
import { openLibrary } from './library';
import { offerManual } from './manual';
import { messageOf, say } from './page';
import { Viewer } from './viewer';

function run( viewer: Viewer ): void
{
	let last = performance.now();
	const next = ( now: number ): void =>
	{
		viewer.tick( Math.min( ( now - last ) / 1000, 0.25 ) );
		last = now;
		requestAnimationFrame( next );
	};
	requestAnimationFrame( next );
}

async function start(): Promise<void>
{
	const [ library, samples ] = await Promise.all( [ openLibrary(), listSamples() ] );
	const viewer = new Viewer( library, samples );
	await viewer.open();
	if ( viewer.address.manual )
	{
		viewer.draw();
	}
	else
	{
		run( viewer );
	}
	offerManual( viewer );
}

start().catch( ( error: unknown ) => say( `The page can't start: ${messageOf( error )}`, true ) );
