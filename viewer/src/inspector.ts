// SPDX-License-Identifier: MIT
// Every setting: its row in the panel, and a card that says what it is and draws what it changes. Names, units, ranges,
// defaults and sentences come from the library's table.
import GUI, { type Controller } from 'lil-gui';
import { History } from './history';
import type { Library, SettingInfo, SettingValues } from './library';
import { find, make, makeOpener, messageOf, save, say } from './page';
import { changesOf, defaultsOf, presets, sameSettings } from './settings';
import { SKETCH_BOX, sketchSetting } from './sketches';

const enumNames: Record<string, string[]> = {
	'probe.shape': [ 'ray', 'sphere' ],
	'probe.layout': [ 'economy', 'quality', 'single' ],
	'contact.pivot': [ 'nothing', 'ball', 'ankle' ],
	'pelvis.follow': [ 'steps', 'planted feet', 'lowest foot' ],
	'pelvis.mode': [ 'its joint', 'the root', 'nobody' ],
};

const unitWords: Record<string, string> = { 'L': 'leg lengths', 's': 's', 'rad': 'rad', 'L/s': 'leg lengths a second', '': 'share' };

/// As many digits as a value needs.
function formatNumber( value: number ): string
{
	return String( Number( value.toPrecision( 6 ) ) );
}

/// A step that gives a slider some hundred places.
function findStep( info: SettingInfo ): number
{
	const rough = ( info.maximum - info.minimum ) / 500;
	return Math.max( 10 ** Math.floor( Math.log10( rough ) ), 1e-4 );
}

export class Inspector
{
	readonly values: SettingValues;
	private readonly infos: readonly SettingInfo[];
	private readonly defaults: SettingValues;
	private readonly history: History<SettingValues>;
	private readonly controllers = new Map<string, Controller>();
	private readonly card = make( 'div', { id: 'card' } );
	private readonly undo = make( 'button', { onclick: () => this.take( this.history.undo() ), title: 'Undo (Ctrl+Z)' }, 'Undo' );
	private readonly redo = make( 'button', { onclick: () => this.take( this.history.redo() ), title: 'Redo (Ctrl+Shift+Z)' }, 'Redo' );
	private readonly preset = make( 'select', { 'aria-label': 'Preset', onchange: () => this.takePreset() } );
	private shown: SettingInfo;

	/// @param changed called with all values whenever one has changed
	constructor( page: HTMLElement, private readonly library: Library, private readonly changed: ( values: SettingValues ) => void )
	{
		const infos = this.infos = library.settingInfos;
		this.defaults = defaultsOf( infos );
		this.values = { ...this.defaults };
		this.history = new History( { ...this.values }, sameSettings );
		this.shown = infos[ 0 ]!;
		this.preset.append( make( 'option', { value: '' }, 'Preset…' ),
			...presets.map( ( preset ) => make( 'option', { value: preset.name }, preset.name ) ) );
		page.append( this.card, this.makeTools() );
		this.addRows( page );
		this.show( this.shown );
		this.refresh();
		addEventListener( 'keydown', ( event ) => this.hearKey( event ) );
	}

	private makeTools(): HTMLElement
	{
		const open = makeOpener( 'Load', '.json,application/json', 'Load settings as `sole` reads them',
			( files ) => void this.load( files[ 0 ] ) );
		const keep = make( 'button', { title: 'Save settings as `sole` reads them', onclick: () =>
			save( 'settings.json', this.library.formatSettings( this.values ), 'application/json' ) }, 'Save' );
		const reset = make( 'button', { title: 'All settings to their defaults', onclick: () => this.choose( this.defaults ) }, 'Reset' );
		return make( 'div', { class: 'page-tools' }, this.preset, this.undo, this.redo, open, keep, reset );
	}

	private addRows( page: HTMLElement ): void
	{
		const gui = new GUI( { container: page, title: 'Settings' } );
		gui.domElement.querySelector( '.lil-title' )?.remove();
		let folder: GUI | undefined;
		let stage = '';
		for ( const info of this.infos )
		{
			const [ ofStage, field ] = info.name.split( '.' ) as [ string, string ];
			if ( folder === undefined || ofStage !== stage )
			{
				folder = gui.addFolder( ofStage );
				stage = ofStage;
			}
			const row = this.addRow( folder, info ).name( field );
			row.onChange( () => this.update() );
			row.onFinishChange( () => this.finish() );
			const show = (): void => this.show( info );
			row.domElement.addEventListener( 'pointerenter', show );
			row.domElement.addEventListener( 'focusin', show );
			row.domElement.title = `${info.text} Double click on the name: back to ${formatNumber( info.default )}.`;
			row.$name.addEventListener( 'dblclick', () => this.choose( { ...this.values, [ info.name ]: info.default } ) );
			row.$name.id = `setting-${info.name}`;
			this.controllers.set( info.name, row );
		}
	}

	private addRow( folder: GUI, info: SettingInfo ): Controller
	{
		const names = enumNames[ info.name ];
		if ( info.kind === 'choice' && names !== undefined )
		{
			return folder.add( this.values, info.name, Object.fromEntries( names.map( ( name, value ) => [ name, value ] ) ) );
		}
		if ( info.kind !== 'number' )
		{
			return folder.add( this.values, info.name ).min( info.minimum ).max( info.maximum ).step( 1 );
		}
		return folder.add( this.values, info.name, info.minimum, info.maximum, findStep( info ) );
	}

	// ----------------------------------------------------------------------------------------------------- changes

	private update(): void
	{
		this.refresh();
		this.changed( this.values );
	}

	private finish(): void
	{
		this.history.push( { ...this.values } );
		this.refresh();
	}

	private take( values: SettingValues ): void
	{
		Object.assign( this.values, values );
		this.update();
	}

	/// New values that the user chose: can be undone.
	choose( values: SettingValues ): void
	{
		this.history.push( { ...values } );
		this.take( values );
	}

	/// Changes on top of the defaults.
	chooseChanges( changes: SettingValues ): void
	{
		const known = Object.entries( changes ).filter( ( [ name, value ] ) => name in this.defaults && Number.isFinite( value ) );
		this.choose( { ...this.defaults, ...Object.fromEntries( known ) } );
	}

	get changes(): SettingValues
	{
		return changesOf( this.infos, this.values );
	}

	private takePreset(): void
	{
		const preset = presets.find( ( one ) => one.name === this.preset.value );
		if ( preset !== undefined )
		{
			this.chooseChanges( preset.values );
		}
	}

	async load( file: File | undefined ): Promise<void>
	{
		if ( file === undefined )
		{
			return;
		}
		try
		{
			this.choose( this.library.parseSettings( await file.text() ) );
			say( `${file.name}: settings loaded.` );
		}
		catch ( error )
		{
			say( `${file.name}: ${messageOf( error )}`, true );
		}
	}

	private hearKey( event: KeyboardEvent ): void
	{
		const typing = event.target instanceof HTMLInputElement && event.target.type !== 'checkbox';
		if ( typing === false && ( event.ctrlKey || event.metaKey ) && event.key.toLowerCase() === 'z' )
		{
			this.take( event.shiftKey ? this.history.redo() : this.history.undo() );
			event.preventDefault();
		}
	}

	// -------------------------------------------------------------------------------------------------------- shown

	private refresh(): void
	{
		const changes = this.changes;
		for ( const [ name, row ] of this.controllers )
		{
			row.updateDisplay();
			row.domElement.classList.toggle( 'changed', name in changes );
		}
		this.undo.disabled = this.history.canUndo === false;
		this.redo.disabled = this.history.canRedo === false;
		const preset = presets.find( ( one ) => sameSettings( { ...this.defaults, ...one.values }, this.values ) );
		this.preset.value = preset?.name ?? '';
		const count = Object.keys( changes ).length;
		const mark = find( 'tab-settings' ).querySelector( '.count' );
		mark?.remove();
		if ( count > 0 )
		{
			find( 'tab-settings' ).append( make( 'span', { class: 'count', title: `${count} changed` }, String( count ) ) );
		}
		this.show( this.shown );
	}

	private show( info: SettingInfo ): void
	{
		this.shown = info;
		const value = this.values[ info.name ]!;
		const most = info.kind === 'mask' ? 1 : info.maximum;
		const range = info.kind === 'mask' ? 'bits' : `${formatNumber( info.minimum )} to ${formatNumber( info.maximum )}`;
		const facts: [ string, string ][] = [ [ 'unit', info.kind === 'number' ? unitWords[ info.unit ] ?? info.unit : info.kind ],
			[ 'range', range ], [ 'default', formatNumber( info.default ) ], [ 'now', formatNumber( value ) ] ];
		const list = make( 'dl', {}, ...facts.flatMap( ( [ name, words ] ) => [ make( 'dt', {}, name ), make( 'dd', {}, words ) ] ) );
		const sketch = document.createElementNS( 'http://www.w3.org/2000/svg', 'svg' );
		sketch.setAttribute( 'viewBox', SKETCH_BOX );
		sketch.setAttribute( 'role', 'img' );
		sketch.setAttribute( 'aria-label', `What ${info.name} changes` );
		sketch.innerHTML = sketchSetting( info.name, info.unit, value, most );
		this.card.replaceChildren( make( 'h2', {}, info.name ), sketch, make( 'p', {}, info.text ), list );
	}
}
