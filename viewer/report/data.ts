// SPDX-License-Identifier: MIT
// What a report is about, as `sole report` wrote it into the page. SI units, world of the ground.

export interface Cell
{
	value: number | null;
	limit: number | null;
	/// The target; null: there is none.
	holds: boolean | null;
}

/// A figure, a cell for each take.
export interface Row
{
	name: string;
	title: string;
	unit: string;
	decimals: number;
	atLeast: boolean;
	cells: Cell[];
}

/// A number for each frame.
type Curve = ( number | null )[];

export interface LegCurves
{
	height: Curve; // of the lowest point of the sole over the ground
	bend: Curve; // of the knee, 0 when straight
	acceleration: Curve; // of the bend
	planted: number[]; // 1: held in its place
}

export interface Take
{
	method: string;
	summary: string;
	/// Its name in the file.
	clip: string;
	legs: LegCurves[];
	pelvis: number[]; // x, y, z a frame
}

export interface Walk
{
	clip: string;
	fps: number;
	frames: number;
	/// So many at the start are not measured.
	skip: number;
	speed: number;
	/// Per leg and frame: 0 in the air, 1 heel, 2 toe, 3 flat on the clip's own floor.
	labels: number[][];
	takes: Take[];
	rows: Row[];
}

export interface Change
{
	name: string;
	unit: string;
	value: number;
	default: number;
	text: string;
}

export interface ReportData
{
	version: string;
	character: string;
	ground: string;
	legLength: number;
	legs: { name: string; joints: string[] }[];
	walks: Walk[];
	settings: Change[];
}

function readText( id: string ): string
{
	const text = document.getElementById( id )?.textContent;
	if ( text === undefined || text === null )
	{
		throw new Error( 'this page is a template without data: fill it with "sole report"' );
	}
	return text;
}

export function readData(): ReportData
{
	return JSON.parse( readText( 'report' ) ) as ReportData;
}

/// A file that is part of the page.
export function readBytes( id: string ): ArrayBuffer
{
	const text = atob( readText( id ) );
	const bytes = new Uint8Array( text.length );
	for ( let i = 0; i < text.length; ++i )
	{
		bytes[ i ] = text.charCodeAt( i );
	}
	return bytes.buffer;
}

/// The last part of a path.
export function baseName( path: string ): string
{
	return path.slice( path.lastIndexOf( '/' ) + 1 );
}

export function durationOf( walk: Walk ): number
{
	return ( walk.frames - 1 ) / walk.fps;
}
