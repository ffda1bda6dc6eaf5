// SPDX-License-Identifier: MIT
// Time per stage, as a stacked bar. Clocks of browsers tick far more slowly than a stage runs, and the solver of the page
// is not to be slowed down by being watched: so a second of frames is recorded, and played some times over in a build of
// the library that tells when a stage has ended. Its module is loaded when the bar is first wanted.
import { loadStageMeter, type StageMeter } from '../../build/wasm/page/stages.js';
import stageModule from '../../build/wasm/page/sole-stages.wasm?url';
import type { Body } from './body';
import { find, make, messageOf, say } from './page';

const FRAMES = 60; // of one recording
const ROUNDS = 16; // it is played
const ROOM = 4 << 20; // bytes of a recording
const SHARE = 0.3; // of a new mean in what is shown
const NARROW = 0.07; // of the bar: names of narrower parts are in the legend alone

export interface StageTime
{
	name: string;
	cost: number; // microseconds a frame
}

export class StageTimes
{
	readonly button = make( 'button', { id: 'stage-times', 'aria-pressed': 'false', title: 'Time per stage of the solver',
		onclick: () => void this.toggle() }, 'Stages' );
	/// Mean costs, in the order in which the stages run.
	readonly times: StageTime[] = [];
	private readonly bar = make( 'div', { class: 'bar', role: 'img', 'aria-label': 'Time per stage' } );
	private readonly legend = make( 'ul' );
	private readonly box = find( 'stages' );
	private meter: StageMeter | null = null;
	private watched: Body | null = null;
	private frames = 0;

	constructor()
	{
		this.box.append( this.bar, this.legend );
	}

	get on(): boolean
	{
		return this.box.hidden === false;
	}

	private async toggle(): Promise<void>
	{
		this.box.hidden = this.on;
		this.button.setAttribute( 'aria-pressed', String( this.on ) );
		this.stop();
		this.times.length = 0;
		this.show();
		try
		{
			this.meter ??= await loadStageMeter( { url: new URL( stageModule, document.baseURI ) } );
		}
		catch ( error )
		{
			say( messageOf( error ), true );
		}
	}

	/// Whoever else wants to record may: the recording of now is given up.
	stop(): void
	{
		this.watched?.endTrace();
		this.watched = null;
	}

	/// After every frame of the body that is looked at.
	/// @param cost microseconds of gather, cast and solve
	hear( body: Body, cost: readonly number[] ): void
	{
		if ( this.on === false || this.meter === null )
		{
			return;
		}
		if ( body !== this.watched )
		{
			body.beginTrace( ROOM );
			this.watched = body;
			this.frames = 0;
			return;
		}
		this.frames += 1;
		if ( this.frames >= FRAMES )
		{
			this.watched = null;
			this.take( body.endTrace(), cost );
		}
	}

	private take( trace: Uint8Array, cost: readonly number[] ): void
	{
		const solved = trace.length > 0 ? this.meter!.measure( trace, ROUNDS ).stages : [];
		const all = solved.length > 0 ? [ { name: 'gather', cost: cost[ 0 ]! }, { name: 'cast', cost: cost[ 1 ]! }, ...solved ] : [];
		if ( all.length !== this.times.length )
		{
			this.times.splice( 0, this.times.length, ...all );
		}
		this.times.forEach( ( time, index ) => { time.cost += ( all[ index ]!.cost - time.cost ) * SHARE; } );
		this.show();
	}

	private show(): void
	{
		const sum = this.times.reduce( ( total, { cost } ) => total + cost, 0 );
		const color = ( index: number ): string => `hsl( ${Math.round( 360 * index / Math.max( this.times.length, 1 ) )} 62% 58% )`;
		this.bar.replaceChildren( ...this.times.map( ( { name, cost }, index ) => make( 'span', { title: `${name}: ${cost.toFixed( 2 )} µs`,
			style: `flex-grow: ${cost.toFixed( 4 )}; background: ${color( index )}` }, cost > NARROW * sum ? name : '' ) ) );
		const rows = this.times.map( ( { name, cost }, index ) => make( 'li', { style: `--swatch: ${color( index )}` }, `${name} ${cost.toFixed( 2 )}` ) );
		const words = this.times.length > 0 ? `${sum.toFixed( 1 )} µs a frame` : 'measured while Sole places the feet and time runs';
		this.legend.replaceChildren( make( 'li', { class: 'sum' }, words ), ...rows );
	}
}
