// SPDX-License-Identifier: MIT
// Plots along the time of a walk, two takes in each, with a cursor where time is; a press on one goes there.
import { drawLine, openSheet, type Sheet } from '../src/chart';
import { find, make, onTheme, styleColor } from '../src/page';
import { durationOf, type ReportData, type Take, type Walk } from './data';

// Room around what is drawn, in pixels of the page.
const LEFT = 38;
const BOTTOM = 15;
const RIGHT = 6;
const TOP = 5;

const DEGREES = 180 / Math.PI;
const HIGHEST = 0.2; // of leg length: a sole that is further over or under the ground leaves its plot, for centimetres count
const takeColors = [ '--before', '--after' ];
const thickness = [ 2.4, 1.3 ]; // pixels of the page: one shows behind the other where they are equal

interface Line
{
	take: number; // 0 before, 1 after
	value: ( frame: number ) => number;
}

interface Bar
{
	name: string;
	/// 0 none, up to 0.5 pale, 1 solid.
	value: ( frame: number ) => number;
}

interface PlotDef
{
	title: string;
	unit: string;
	lines: Line[];
	bars: Bar[];
	/// What lies further from zero is not drawn.
	most: number;
	/// A smaller range is not made to look large.
	span: number;
}

interface Plot extends PlotDef
{
	low: number;
	high: number;
	canvas: HTMLCanvasElement;
	cursor: HTMLElement;
	values: HTMLElement[];
}

/// The smallest round step of which no more than so many fit into a range.
function findStep( range: number, most: number ): number
{
	const rough = Math.max( range, 1e-9 ) / most;
	const power = 10 ** Math.floor( Math.log10( rough ) );
	return power * ( [ 1, 2, 5, 10 ].find( ( step ) => step * power >= rough ) ?? 10 );
}

function makeDefs( data: ReportData, walk: Walk, takes: readonly [ Take, Take ] ): PlotDef[]
{
	const both = ( value: ( take: Take, frame: number ) => number | null ): Line[] =>
		takes.map( ( take, index ) => ( { take: index, value: ( frame ) => value( take, frame ) ?? NaN } ) );
	const perLeg = ( title: string, unit: string, most: number, span: number, value: ( take: Take, leg: number, frame: number ) => number | null ): PlotDef[] =>
		data.legs.map( ( leg, index ) => ( { title: `${title}, ${leg.name}`, unit, bars: [], most, span,
			lines: both( ( take, frame ) => value( take, index, frame ) ) } ) );
	const scaled = ( number: number | null | undefined, factor: number ): number | null => ( number === null || number === undefined ? null : factor * number );
	const floor = takes[ 1 ].pelvis[ 1 ] ?? 0;
	return [
		...perLeg( 'Sole over the ground', 'mm', 1000 * HIGHEST * data.legLength, 20, ( take, leg, frame ) => scaled( take.legs[ leg ]!.height[ frame ], 1000 ) ),
		...perLeg( 'Knee', '°', Infinity, 10, ( take, leg, frame ) => scaled( take.legs[ leg ]!.bend[ frame ], DEGREES ) ),
		...perLeg( 'Knee acceleration', '°/s²', Infinity, 100, ( take, leg, frame ) => scaled( take.legs[ leg ]!.acceleration[ frame ], DEGREES ) ),
		{ title: `Contact: pale as in the clip, solid where ${takes[ 1 ].method} holds the foot`, unit: '', lines: [], most: 1, span: 0, bars: data.legs.map( ( leg, index ) => ( { name: leg.name,
			value: ( frame ) => ( takes[ 1 ].legs[ index ]!.planted[ frame ] === 1 ? 1 : ( walk.labels[ index ]![ frame ] ?? 0 ) > 0 ? 0.5 : 0 ) } ) ) },
		{ title: 'Pelvis over its start', unit: 'mm', bars: [], most: Infinity, span: 20, lines: both( ( take, frame ) => scaled( take.pelvis[ 3 * frame + 1 ]! - floor, 1000 ) ) },
	];
}

function makePlot( def: PlotDef, frames: number ): Plot
{
	let low = Infinity;
	let high = -Infinity;
	for ( const line of def.lines )
	{
		for ( let frame = 0; frame < frames; ++frame )
		{
			const value = line.value( frame );
			low = value < low ? value : low;
			high = value > high ? value : high;
		}
	}
	low = Math.max( low, -def.most );
	high = Math.min( high, def.most );
	const known = low <= high;
	const room = known ? Math.max( 0.06 * ( high - low ), 0.5 * ( def.span - high + low ) ) : 0;
	return { ...def, low: known ? low - room : 0, high: known ? high + room : 1,
		canvas: make( 'canvas', { role: 'img', 'aria-label': `${def.title}, along time` } ),
		cursor: make( 'div', { class: 'cursor' } ),
		values: def.lines.map( ( line ) => make( 'span', { class: line.take === 0 ? 'before' : 'after' } ) ) };
}

export class Timeline
{
	private plots: Plot[] = [];
	private frames = 0;
	private duration = 0;
	private fps = 1;
	private time = 0;

	/// @param go to a time
	constructor( private readonly go: ( time: number ) => void )
	{
		onTheme( () => this.draw() );
		addEventListener( 'resize', () => this.draw() );
	}

	show( data: ReportData, walk: Walk, takes: readonly [ Take, Take ] ): void
	{
		this.frames = walk.frames;
		this.fps = walk.fps;
		this.duration = durationOf( walk );
		this.plots = makeDefs( data, walk, takes ).map( ( def ) => makePlot( def, walk.frames ) );
		find( 'plots' ).replaceChildren( ...this.plots.map( ( plot ) => this.makeFigure( plot ) ) );
		this.draw();
	}

	private makeFigure( plot: Plot ): HTMLElement
	{
		const area = make( 'div', { class: 'area' }, plot.canvas, plot.cursor );
		const go = ( event: PointerEvent ): void =>
		{
			const box = plot.canvas.getBoundingClientRect();
			const share = ( event.clientX - box.left - LEFT ) / Math.max( box.width - LEFT - RIGHT, 1 );
			this.go( Math.min( Math.max( share, 0 ), 1 ) * this.duration );
		};
		area.addEventListener( 'pointerdown', ( event ) =>
		{
			area.setPointerCapture( event.pointerId );
			go( event );
		} );
		area.addEventListener( 'pointermove', ( event ) => { event.buttons > 0 && go( event ); } );
		const unit = plot.unit === '' ? plot.title : `${plot.title}, ${plot.unit}`;
		return make( 'figure', {}, make( 'figcaption', {}, make( 'span', {}, unit ), make( 'span', { class: 'values' }, ...plot.values ) ), area );
	}

	/// Where time is.
	setTime( time: number ): void
	{
		this.time = time;
		const share = this.duration > 0 ? time / this.duration : 0;
		const frame = Math.min( Math.round( time * this.fps ), this.frames - 1 );
		for ( const plot of this.plots )
		{
			plot.cursor.style.left = `calc( ${LEFT}px + ( 100% - ${LEFT + RIGHT}px ) * ${share} )`;
			plot.lines.forEach( ( line, index ) =>
			{
				const value = line.value( frame );
				plot.values[ index ]!.textContent = Number.isFinite( value ) ? value.toFixed( 0 ) : '–';
			} );
		}
	}

	private draw(): void
	{
		this.plots.forEach( ( plot ) => this.drawPlot( plot ) );
		this.setTime( this.time );
	}

	private drawPlot( plot: Plot ): void
	{
		const sheet = openSheet( plot.canvas );
		if ( sheet === null )
		{
			return;
		}
		const { scale } = sheet;
		const wide = sheet.width - ( LEFT + RIGHT ) * scale;
		const tall = sheet.height - ( BOTTOM + TOP ) * scale;
		const x = ( frame: number ): number => LEFT * scale + wide * frame / Math.max( this.frames - 1, 1 );
		const y = ( value: number ): number => TOP * scale + tall * ( 1 - ( value - plot.low ) / ( plot.high - plot.low ) );
		sheet.context.font = `${10 * scale}px ${getComputedStyle( document.body ).fontFamily}`;
		sheet.context.fillStyle = styleColor( '--soft' );
		this.drawTimes( sheet, x, TOP * scale + tall );
		if ( plot.lines.length > 0 )
		{
			this.drawHeights( sheet, plot, y );
		}
		sheet.context.save();
		sheet.context.beginPath();
		sheet.context.rect( 0, 0, sheet.width, TOP * scale + tall );
		sheet.context.clip();
		plot.lines.forEach( ( line ) => drawLine( sheet, this.frames, x, ( frame ) => y( line.value( frame ) ), styleColor( takeColors[ line.take ]! ), thickness[ line.take ]! ) );
		sheet.context.restore();
		plot.bars.forEach( ( bar, index ) => this.drawBar( sheet, bar, x, TOP * scale + tall * index / plot.bars.length, tall / plot.bars.length ) );
	}

	private drawTimes( sheet: Sheet, x: ( frame: number ) => number, bottom: number ): void
	{
		const { context, scale } = sheet;
		const step = findStep( this.duration, Math.max( sheet.width / scale / 60, 2 ) );
		context.textAlign = 'center';
		context.textBaseline = 'bottom';
		for ( let time = 0; time <= this.duration + 1e-9; time += step )
		{
			const at = Math.round( x( time * this.fps ) );
			context.globalAlpha = 0.18;
			context.fillRect( at, TOP * scale, 1, bottom - TOP * scale );
			context.globalAlpha = 1;
			context.fillText( `${Number( time.toFixed( 2 ) )} s`, Math.min( at, sheet.width - 12 * scale ), sheet.height );
		}
	}

	private drawHeights( sheet: Sheet, plot: Plot, y: ( value: number ) => number ): void
	{
		const { context, scale } = sheet;
		const step = findStep( plot.high - plot.low, 4 );
		context.textAlign = 'right';
		context.textBaseline = 'middle';
		for ( let k = Math.ceil( plot.low / step ); k * step <= plot.high; ++k )
		{
			const at = Math.round( y( k * step ) );
			// The ground, a straight knee, the start: zero is what all else is seen against.
			context.globalAlpha = k === 0 ? 0.6 : 0.18;
			context.fillRect( LEFT * scale, at, sheet.width - ( LEFT + RIGHT ) * scale, 1 );
			context.globalAlpha = 1;
			context.fillText( this.sayTick( k * step, step ), ( LEFT - 5 ) * scale, Math.min( Math.max( at, 6 * scale ), sheet.height - ( BOTTOM + 2 ) * scale ) );
		}
	}

	private sayTick( value: number, step: number ): string
	{
		return step >= 1000 && value !== 0 ? `${value / 1000}k` : String( Number( value.toPrecision( 6 ) ) );
	}

	private drawBar( sheet: Sheet, bar: Bar, x: ( frame: number ) => number, top: number, tall: number ): void
	{
		const { context, scale } = sheet;
		context.textAlign = 'right';
		context.textBaseline = 'middle';
		context.fillText( bar.name.slice( 0, 6 ), ( LEFT - 5 ) * scale, top + 0.5 * tall, ( LEFT - 6 ) * scale );
		const fill = ( least: number, color: string, opacity: number, high: number ): void =>
		{
			context.save();
			context.fillStyle = styleColor( color );
			context.globalAlpha = opacity;
			for ( let frame = 0; frame + 1 < this.frames; ++frame )
			{
				if ( bar.value( frame ) >= least )
				{
					const from = Math.round( x( frame ) );
					context.fillRect( from, top + 0.5 * ( 1 - high ) * tall, Math.round( x( frame + 1 ) ) - from, high * tall );
				}
			}
			context.restore();
		};
		fill( 0.5, '--before', 0.45, 0.7 );
		fill( 1, '--after', 1, 0.44 );
	}
}
