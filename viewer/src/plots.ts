// SPDX-License-Identifier: MIT
// Figures of the last seconds as scrolling plots, a line per foot: height of the sole over the ground (below zero:
// inside it), how fast it slides while it stands, how far the leg is extended, and when it stands.
import { drawLine, drawRule, openSheet, type Sheet } from './chart';
import { find, make, onTheme, styleColor } from './page';

const SECONDS = 5;
const RATE = 60;
const SAMPLES = SECONDS * RATE;
const THICKNESS = 1.5; // pixels of the page

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
		const sheet = openSheet( plot.canvas );
		if ( sheet === null )
		{
			return;
		}
		const y = ( value: number ): number => sheet.height * ( 1 - ( value - plot.low ) / ( plot.high - plot.low ) );
		const first = SAMPLES - this.filled;
		const isLine = Number.isFinite( plot.line );
		if ( isLine )
		{
			drawRule( sheet, y( plot.line ), this.ink, 0.5 );
		}
		plot.rings.forEach( ( ring, index ) =>
		{
			const color = this.colors[ index % this.colors.length ]!;
			const value = ( k: number ): number => ring[ ( this.head + first + k ) % SAMPLES ]!;
			const x = ( k: number ): number => sheet.width * ( first + k ) / ( SAMPLES - 1 );
			isLine ? drawLine( sheet, this.filled, x, ( k ) => y( value( k ) ), color, THICKNESS )
				: this.drawBars( sheet, value, x, color, index, plot.rings.length );
		} );
	}

	private drawBars( sheet: Sheet, value: ( k: number ) => number, x: ( k: number ) => number, color: string, index: number, count: number ): void
	{
		const { context } = sheet;
		const row = sheet.height / count;
		context.fillStyle = color;
		for ( let k = 0; k < this.filled; ++k )
		{
			if ( value( k ) > 0 )
			{
				context.globalAlpha = value( k ) > 0.5 ? 1 : 0.35;
				const from = Math.round( x( k ) );
				context.fillRect( from, ( index + 0.2 ) * row, Math.round( x( k + 1 ) ) - from, 0.6 * row );
			}
		}
		context.globalAlpha = 1;
	}
}
