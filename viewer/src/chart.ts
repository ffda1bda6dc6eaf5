// SPDX-License-Identifier: MIT
// What plots are drawn with: a canvas as large as it is seen, rules and lines. Places in pixels of the canvas.

const FINEST = 2; // pixels of the canvas to one of the page

export interface Sheet
{
	context: CanvasRenderingContext2D;
	width: number;
	height: number;
	/// Pixels of the canvas to one of the page.
	scale: number;
}

/// Cleared. NULL: the canvas is not seen.
export function openSheet( canvas: HTMLCanvasElement ): Sheet | null
{
	const scale = Math.min( devicePixelRatio, FINEST );
	const width = Math.round( canvas.clientWidth * scale );
	const height = Math.round( canvas.clientHeight * scale );
	if ( width === 0 || height === 0 )
	{
		return null;
	}
	if ( canvas.width !== width || canvas.height !== height )
	{
		canvas.width = width;
		canvas.height = height;
	}
	const context = canvas.getContext( '2d' )!;
	context.clearRect( 0, 0, width, height );
	return { context, width, height, scale };
}

/// Across the whole width.
export function drawRule( sheet: Sheet, y: number, color: string, opacity: number ): void
{
	sheet.context.fillStyle = color;
	sheet.context.globalAlpha = opacity;
	sheet.context.fillRect( 0, y, sheet.width, 1 );
	sheet.context.globalAlpha = 1;
}

/// Through points in turn, broken where a height is none.
/// @param thickness in pixels of the page
export function drawLine( sheet: Sheet, count: number, x: ( k: number ) => number, y: ( k: number ) => number, color: string, thickness: number ): void
{
	const { context } = sheet;
	context.strokeStyle = color;
	context.lineWidth = thickness * sheet.scale;
	context.beginPath();
	let pen = false;
	for ( let k = 0; k < count; ++k )
	{
		const height = y( k );
		Number.isFinite( height ) && pen ? context.lineTo( x( k ), height ) : context.moveTo( x( k ), height );
		pen = Number.isFinite( height );
	}
	context.stroke();
}
