// SPDX-License-Identifier: MIT
// Time: play, pause, single steps, slow motion, from the start; and what a frame costs.
import { find, make } from './page';

/// Outlines in a box of 16, for fonts lack such signs.
const icons = {
	start: 'M4 3v10M13 3 6 8l7 5z', play: 'M5 3l8 5-8 5z', pause: 'M5 3v10M11 3v10', step: 'M3 3l7 5-7 5zM13 3v10',
};

function makeIcon( name: keyof typeof icons ): SVGElement
{
	const svg = document.createElementNS( 'http://www.w3.org/2000/svg', 'svg' );
	svg.setAttribute( 'viewBox', '0 0 16 16' );
	svg.setAttribute( 'class', 'icon' );
	svg.innerHTML = `<path d="${icons[ name ]}"/>`;
	return svg;
}

export const TIME_STEP = 1 / 60; // s
const RATES = [ 1, 0.5, 0.25, 0.1 ];

export class Transport
{
	playing = true;
	rate = 1;
	private readonly play = make( 'button', { onclick: () => this.toggle() } );
	private readonly slow = make( 'select', { 'aria-label': 'Speed of time' } );
	private readonly clock = make( 'output', { 'aria-label': 'Time' } );
	private readonly cost = make( 'output', { class: 'push rates', 'aria-label': 'Cost of a frame' } );

	/// @param step one frame on; @param restart from the beginning; @param more other buttons
	constructor( private readonly step: () => void, restart: () => void, ...more: HTMLElement[] )
	{
		this.slow.append( ...RATES.map( ( rate ) => make( 'option', { value: String( rate ) }, rate === 1 ? 'real time' : `${rate} ×` ) ) );
		this.slow.addEventListener( 'change', () => { this.rate = Number( this.slow.value ); } );
		find( 'transport' ).append(
			make( 'button', { title: 'From the start (R)', 'aria-label': 'From the start', onclick: restart }, makeIcon( 'start' ) ),
			this.play,
			make( 'button', { title: 'One frame on (.)', 'aria-label': 'One frame on', onclick: () => this.stepOnce() }, makeIcon( 'step' ) ),
			make( 'label', { class: 'speed' }, this.slow ), this.clock, this.cost, ...more );
		this.refresh();
	}

	private refresh(): void
	{
		this.play.replaceChildren( makeIcon( this.playing ? 'pause' : 'play' ) );
		this.play.setAttribute( 'aria-label', this.playing ? 'Pause' : 'Play' );
		this.play.title = this.playing ? 'Pause (space)' : 'Play (space)';
	}

	setPlaying( playing: boolean ): void
	{
		this.playing = playing;
		this.refresh();
	}

	toggle(): void
	{
		this.setPlaying( this.playing === false );
	}

	stepOnce(): void
	{
		this.setPlaying( false );
		this.step();
	}

	show( time: number, cost: string ): void
	{
		this.clock.textContent = `${time.toFixed( 2 )} s`;
		this.cost.textContent = cost;
	}
}
