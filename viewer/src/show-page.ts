// SPDX-License-Identifier: MIT
// Which of the library's drawings are shown: a switch for each, by the library's own table.
import GUI from 'lil-gui';
import type { DrawInfo } from './library';
import { make } from './page';

/// The colours that stand for a category in its switch: what is drawn has more of them.
const swatches: Record<string, string> = {
	'animated legs': '#8a919e', 'placed legs': '#ffc857', 'probes': '#4fa3d1', 'hits': '#2bd4c4', 'sweeps': '#3e7cb1',
	'sole points': '#ff8fa3', 'support plane': '#7bc950', 'locks': '#ff4f4f', 'reach': '#b388eb', 'pelvis': '#f5b700',
	'footholds': '#9ee493', 'targets': '#ff66c4', 'flags': '#9aa4b2',
};

export class ShowPage
{
	private readonly on: Record<string, boolean>;
	private readonly gui: GUI;

	constructor( page: HTMLElement, private readonly infos: readonly DrawInfo[], shown: readonly string[], private readonly changed: () => void )
	{
		this.on = Object.fromEntries( infos.map( ( info ) => [ info.name, shown.includes( info.name ) || shown.includes( 'all' ) ] ) );
		page.append( make( 'p', { class: 'note' }, 'What the library itself shows of a frame: any engine can draw the same, ' +
			'through include/sole/draw.h.' ), make( 'div', { class: 'page-tools' },
			make( 'button', { onclick: () => this.setAll( true ) }, 'Show all' ),
			make( 'button', { onclick: () => this.setAll( false ) }, 'Show none' ) ) );
		this.gui = new GUI( { container: page, title: 'Show' } );
		this.gui.domElement.querySelector( '.lil-title' )?.remove();
		for ( const info of infos )
		{
			const row = this.gui.add( this.on, info.name ).onChange( changed );
			row.domElement.title = info.text;
			row.domElement.classList.add( 'swatch' );
			row.domElement.style.setProperty( '--swatch', swatches[ info.name ] ?? 'gray' );
		}
	}

	setAll( on: boolean ): void
	{
		this.infos.forEach( ( info ) => { this.on[ info.name ] = on; } );
		this.gui.controllers.forEach( ( controller ) => controller.updateDisplay() );
		this.changed();
	}

	get names(): string[]
	{
		return this.infos.filter( ( info ) => this.on[ info.name ] ).map( ( info ) => info.name );
	}

	get mask(): number
	{
		return this.infos.reduce( ( mask, info ) => ( this.on[ info.name ] ? mask | info.category : mask ), 0 );
	}
}
