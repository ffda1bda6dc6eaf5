// SPDX-License-Identifier: MIT
// Figures of the last seconds as scrolling plots, a line per foot: height of the sole over the ground (below zero:
// inside it), how fast it slides while it stands, how far the leg is extended, and when it stands.
import { find, make, onTheme, styleColor } from './page';

const SECONDS = 5;
const RATE = 60;
const SAMPLES = SECONDS * RATE;

/// Of one foot, now.
export interface FootFigures
{
	name: string;
	gap: number; // m, of the lowest sole point
	slide: number; // m/s, while it stands
	extension: number;
	/// The clip has it on the floor, or it is there; and it is held in place.
	stands: boolean;
	held: boolean;
}

interface Plot
{
	title: string;
	unit: string;
	low: number;
	high: number;
	/// A value that is good, drawn across.
	line: number;
	read: ( figures: FootFigures ) => number;
	format: ( value: number ) => string;
	canvas: HTMLCanvasElement;
	value: HTMLElement;
	/// Per foot a ring of values.
	rings: Float32Array[];
}

type PlotDef = Pick<Plot, 'title' | 'unit' | 'low' | 'high' | 'line' | 'read' | 'format'>;

const defs: PlotDef[] = [
	{ title: 'Sole over ground', unit: 'mm', low: -60, high: 120, line: 0, read: ( f ) => 1000 * f.gap, format: ( v ) => v.toFixed( 0 ) },
	{ title: 'Slide while standing', unit: 'mm/s', low: 0, high: 400, line: 0, read: ( f ) => ( f.stands ? 1000 * f.slide : NaN ), format: ( v ) => v.toFixed( 0 ) },
	{ title: 'Contact, solid: held', unit: '', low: 0, high: 1, line: NaN, read: ( f ) => ( f.held ? 1 : f.stands ? 0.5 : 0 ), format: ( v ) => ( v > 0.5 ? 'held' : v > 0 ? 'down' : 'up' ) },
	{ title: 'Leg extension', unit: '%', low: 60, high: 105, line: 100, read: ( f ) => 100 * f.extension, format: ( v ) => v.toFixed( 0 ) },
];

export class Plots
{
	private readonly plots: Plot[];
	private names: string[] = [];
	private head = 0;
	private filled = 0;
	private colors: string[] = [];
	private ink = '';

	constructor()
	{
		this.plots = defs.map( ( def ) =>
		{
			const canvas = make( 'canvas', { role: 'img', 'aria-label': `${def.title}, a line per foot` } );
			const value = make( 'span', { class: 'key' } );
			const unit = def.unit === '' ? def.title : `${def.title}, ${def.unit}`;
			find( 'plots' ).append( make( 'figure', {}, make( 'figcaption', {}, make( 'span', {}, unit ), value ), canvas ) );
			return { ...def, canvas, value, rings: [] };
		} );
		onTheme( () =>
		{
			this.colors = [ '--left', '--right', '--good', '--changed', '--accent', '--bad' ].map( styleColor );
			this.ink = styleColor( '--soft' );
			this.draw();
		} );
	}

	clear(): void
	{
		this.filled = 0;
		this.plots.forEach( ( plot ) => { plot.rings = []; } );
	}

	add( feet: readonly FootFigures[] ): void
	{
		this.names = feet.map( ( foot ) => foot.name );
		for ( const plot of this.plots )
		{
			feet.forEach( ( foot, index ) =>
			{
				plot.rings[ index ] ??= new Float32Array( SAMPLES ).fill( NaN );
				plot.rings[ index ]![ this.head ] = plot.read( foot );
			} );
		}
		this.head = ( this.head + 1 ) % SAMPLES;
		this.filled = Math.min( this.filled + 1, SAMPLES );
	}

	/// The newest values, for who cannot see the lines.
	private label( plot: Plot ): void
	{
		const last = ( this.head + SAMPLES - 1 ) % SAMPLES;
		const words = plot.rings.slice( 0, 2 ).map( ( ring, index ) =>
		{
			const value = ring[ last ]!;
			return make( 'span', { style: `color: ${this.colors[ index ] ?? ''}` },
				`${this.names[ index ]?.slice( 0, 1 ) ?? ''} ${Number.isFinite( value ) ? plot.format( value ) : '–'} ` );
		} );
		plot.value.replaceChildren( ...words );
	}

	draw(): void
	{
		for ( const plot of this.plots )
		{
			this.label( plot );
			this.drawPlot( plot );
		}
	}

	private drawPlot( plot: Plot ): void
	{
		const canvas = plot.canvas;
		const scale = Math.min( devicePixelRatio, 2 );
		const width = Math.round( canvas.clientWidth * scale );
		const height = Math.round( canvas.clientHeight * scale );
		if ( width === 0 || height === 0 )
		{
			return;
		}
		if ( canvas.width !== width || canvas.height !== height )
		{
			canvas.width = width;
			canvas.height = height;
		}
		const context = canvas.getContext( '2d' )!;
		context.clearRect( 0, 0, width, height );
		const y = ( value: number ): number => height * ( 1 - ( value - plot.low ) / ( plot.high - plot.low ) );
		if ( Number.isFinite( plot.line ) )
		{
			context.fillStyle = this.ink;
			context.globalAlpha = 0.5;
			context.fillRect( 0, y( plot.line ), width, 1 );
			context.globalAlpha = 1;
		}
		plot.rings.forEach( ( ring, index ) =>
		{
			context.strokeStyle = context.fillStyle = this.colors[ index % this.colors.length ]!;
			Number.isFinite( plot.line ) ? this.drawLine( context, ring, width, y, scale ) : this.drawBars( context, ring, width, height, index, plot.rings.length );
		} );
	}

	/// Calls with each sample that there is, oldest first, and its place across.
	private walk( ring: Float32Array, width: number, visit: ( value: number, x: number ) => void ): void
	{
		for ( let k = SAMPLES - this.filled; k < SAMPLES; ++k )
		{
			visit( ring[ ( this.head + k ) % SAMPLES ]!, width * k / ( SAMPLES - 1 ) );
		}
	}

	private drawLine( context: CanvasRenderingContext2D, ring: Float32Array, width: number, y: ( value: number ) => number, scale: number ): void
	{
		context.lineWidth = 1.5 * scale;
		context.beginPath();
		let pen = false;
		this.walk( ring, width, ( value, x ) =>
		{
			Number.isFinite( value ) && pen ? context.lineTo( x, y( value ) ) : context.moveTo( x, y( value ) );
			pen = Number.isFinite( value );
		} );
		context.stroke();
	}

	private drawBars( context: CanvasRenderingContext2D, ring: Float32Array, width: number, height: number, index: number, count: number ): void
	{
		const row = height / count;
		this.walk( ring, width, ( value, x ) =>
		{
			if ( value > 0 )
			{
				context.globalAlpha = value > 0.5 ? 1 : 0.35;
				const from = Math.round( x );
				context.fillRect( from, ( index + 0.2 ) * row, Math.round( x + width / ( SAMPLES - 1 ) ) - from, 0.6 * row );
			}
		} );
		context.globalAlpha = 1;
	}
}
