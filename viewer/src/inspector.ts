// SPDX-License-Identifier: MIT
// Settings of Sole or of another method: a row each in the panel, and a card that says what it is and draws what it
// changes. Names, units, ranges, defaults and sentences come from the tables of the modules.
import GUI, { type Controller } from 'lil-gui';
import { History } from './history';
import type { SettingInfo, SettingValues } from './library';
import { make, makeOpener, messageOf, save, say } from './page';
import { changesOf, defaultsOf, sameSettings, type Preset } from './settings';
import { SKETCH_BOX, sketchSetting } from './sketches';

const enumNames: Record<string, string[]> = {
	'probe.shape': [ 'ray', 'sphere' ],
	'probe.layout': [ 'economy', 'quality', 'single' ],
	'support.filter': [ 'by time', 'by call' ],
	'contact.pivot': [ 'nothing', 'ball', 'ankle' ],
	'pelvis.follow': [ 'steps', 'planted feet', 'lowest foot' ],
	'pelvis.mode': [ 'its joint', 'the root', 'nobody' ],
};

const unitWords: Record<string, string> = { 'L': 'leg lengths', 's': 's', 'rad': 'rad', 'L/s': 'leg lengths a second', '': 'share',
	'deg': 'degrees', '1/s': 'a second' };

/// Whose settings they are, and their text.
export interface SettingSource
{
	infos: readonly SettingInfo[];
	presets: readonly Preset[];
	/// Of what is saved.
	fileName: string;
	/// What reads such files.
	reader: string;
	format( values: SettingValues ): string;
	/// Throws with a sentence where the text is none of these settings.
	parse( text: string ): SettingValues;
}

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
	readonly infos: readonly SettingInfo[];
	private readonly defaults: SettingValues;
	private readonly history: History<SettingValues>;
	private readonly controllers = new Map<string, Controller>();
	private readonly card = make( 'div', { class: 'card' } );
	private readonly undo = make( 'button', { onclick: () => this.take( this.history.undo() ), title: 'Undo (Ctrl+Z)' }, 'Undo' );
	private readonly redo = make( 'button', { onclick: () => this.take( this.history.redo() ), title: 'Redo (Ctrl+Shift+Z)' }, 'Redo' );
	private readonly preset = make( 'select', { 'aria-label': 'Preset', onchange: () => this.takePreset() } );
	private shown: SettingInfo;

	/// @param page hidden while others' settings are shown
	/// @param changed called with all values whenever one has changed, marked while only what is shown has
	constructor( private readonly page: HTMLElement, private readonly source: SettingSource,
		private readonly changed: ( values: SettingValues ) => void, private readonly marked: () => void )
	{
		const infos = this.infos = source.infos;
		this.defaults = defaultsOf( infos );
		this.values = { ...this.defaults };
		this.history = new History( { ...this.values }, sameSettings );
		this.shown = infos[ 0 ]!;
		this.preset.append( make( 'option', { value: '' }, 'Preset…' ),
			...source.presets.map( ( preset ) => make( 'option', { value: preset.name }, preset.name ) ) );
		page.append( this.card, this.makeTools() );
		this.addRows( page );
		this.show( this.shown );
		this.refresh();
		addEventListener( 'keydown', ( event ) => this.hearKey( event ) );
	}

	private makeTools(): HTMLElement
	{
		const { fileName, reader } = this.source;
		const open = makeOpener( 'Load', '.json,application/json', `Load settings as ${reader} reads them`,
			( files ) => void this.load( files[ 0 ] ) );
		const keep = make( 'button', { title: `Save settings as ${reader} reads them`, onclick: () =>
			save( fileName, this.source.format( this.values ), 'application/json' ) }, 'Save' );
		const reset = make( 'button', { title: 'All settings to their defaults', onclick: () => this.choose( this.defaults ) }, 'Reset' );
		this.preset.hidden = this.source.presets.length === 0;
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
			row.$name.dataset[ 'unit' ] = info.unit === 'deg' ? '°' : info.unit;
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
		if ( info.kind === 'choice' )
		{
			// A choice whose values have no names yet has numbers; a switch is on or off.
			const count = info.maximum + 1;
			const names = enumNames[ info.name ] ?? ( count === 2 ? [ 'off', 'on' ] : Array.from( { length: count }, ( _, value ) => String( value ) ) );
			return folder.add( this.values, info.name, Object.fromEntries( names.map( ( name, value ) => [ name, value ] ) ) );
		}
		if ( info.kind === 'mask' )
		{
			// Without a slider: what matters is each bit.
			return folder.add( this.values, info.name ).min( 0 ).step( 1 );
		}
		return folder.add( this.values, info.name, info.minimum, info.maximum, findStep( info ) );
	}

	// ----------------------------------------------------------------------------------------------------- changes

	private update(): void
	{
		for ( const info of this.infos )
		{
			this.values[ info.name ] = Math.min( this.values[ info.name ]!, info.maximum );
		}
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
		const preset = this.source.presets.find( ( one ) => one.name === this.preset.value );
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
			this.choose( this.source.parse( await file.text() ) );
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
		if ( typing === false && this.page.hidden === false && ( event.ctrlKey || event.metaKey ) && event.key.toLowerCase() === 'z' )
		{
			this.take( event.shiftKey ? this.history.redo() : this.history.undo() );
			event.preventDefault();
		}
	}

	// -------------------------------------------------------------------------------------------------------- shown

	/// No more digits than there is room for, but where one is typing.
	private shorten( row: Controller, value: number ): void
	{
		const input = row.domElement.querySelector<HTMLInputElement>( '.lil-number.lil-has-slider input, .lil-has-slider input' );
		if ( input !== null && input !== document.activeElement )
		{
			input.value = String( Number( value.toPrecision( 4 ) ) );
		}
	}

	private refresh(): void
	{
		const changes = this.changes;
		for ( const [ name, row ] of this.controllers )
		{
			row.updateDisplay();
			this.shorten( row, this.values[ name ]! );
			row.domElement.classList.toggle( 'changed', name in changes );
		}
		this.undo.disabled = this.history.canUndo === false;
		this.redo.disabled = this.history.canRedo === false;
		const preset = this.source.presets.find( ( one ) => sameSettings( { ...this.defaults, ...one.values }, this.values ) );
		this.preset.value = preset?.name ?? '';
		this.marked();
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
