// SPDX-License-Identifier: MIT
// The second page of the panel: Sole's settings, and beside them those of the other methods that are shown, each under
// the names of the original. Others' defaults are fitted to the character, and theirs begin anew with another one.
import type { Method } from './body';
import { Inspector } from './inspector';
import type { Library, SettingInfo, SettingValues } from './library';
import type { MethodName } from './methods';
import { find, make } from './page';
import { methodLabels } from './pickers';
import { defaultsOf, flatten, nest, presets } from './settings';

interface Section
{
	box: HTMLElement;
	inspector: Inspector;
}

/// Of a method that has settings of its own.
export function hasOwnSettings( method: Method ): method is MethodName
{
	return method !== 'none' && method !== 'sole';
}

/// Text to values, where all of it is settings of this table.
function parseOwn( infos: readonly SettingInfo[], text: string ): SettingValues
{
	const values = { ...defaultsOf( infos ) };
	for ( const [ name, value ] of Object.entries( flatten( JSON.parse( text ) ) ) )
	{
		if ( !( name in values ) || typeof value !== 'number' || !Number.isFinite( value ) )
		{
			throw new Error( `${name}: is no setting of this method, or no number` );
		}
		values[ name ] = value;
	}
	return values;
}

export class SettingsPage
{
	readonly sole: Inspector;
	private readonly sections = new Map<Method, Section>();
	private readonly whose = make( 'select', { 'aria-label': 'Whose settings', onchange: () => this.select( this.whose.value as Method ) } );
	private readonly picker = make( 'label', { class: 'whose' }, 'Settings of', this.whose );
	/// Changes that an address has for methods that are not shown yet.
	private waiting: SettingValues = {};

	/// @param changed called when Sole's settings have changed, ownChanged when those of another method
	constructor( private readonly page: HTMLElement, library: Library, changed: () => void, private readonly ownChanged: ( method: MethodName ) => void )
	{
		page.append( this.picker );
		this.sole = this.addSection( 'sole', ( box ) => new Inspector( box, { infos: library.settingInfos, presets, fileName: 'settings.json',
			reader: '`sole`', format: library.formatSettings, parse: library.parseSettings }, changed, () => this.mark() ) );
		this.show( [], () => [] );
	}

	private addSection( method: Method, build: ( box: HTMLElement ) => Inspector ): Inspector
	{
		const box = this.page.appendChild( make( 'div', { class: 'settings' } ) );
		const inspector = build( box );
		this.sections.set( method, { box, inspector } );
		return inspector;
	}

	private addOwn( method: MethodName, infos: readonly SettingInfo[] ): void
	{
		this.addSection( method, ( box ) => new Inspector( box, { infos, presets: [], fileName: `${method}.json`, reader: 'this page',
			format: ( values ) => `${JSON.stringify( nest( values ), null, '\t' )}\n`, parse: ( text ) => parseOwn( infos, text ) },
		() => this.ownChanged( method ), () => this.mark() ) ).chooseChanges( this.waiting );
	}

	/// The methods that are shown now. @param infosOf their tables, with defaults as fitted
	show( methods: readonly Method[], infosOf: ( method: MethodName ) => readonly SettingInfo[] ): void
	{
		for ( const method of methods.filter( hasOwnSettings ) )
		{
			const infos = infosOf( method );
			const old = this.sections.get( method );
			if ( old === undefined || JSON.stringify( old.inspector.infos ) !== JSON.stringify( infos ) )
			{
				old?.box.remove();
				this.addOwn( method, infos );
			}
		}
		const shown: Method[] = [ 'sole', ...new Set( methods.filter( hasOwnSettings ) ) ];
		const before = this.whose.value as Method;
		this.whose.replaceChildren( ...shown.map( ( method ) => make( 'option', { value: method }, methodLabels[ method ] ) ) );
		this.picker.hidden = shown.length === 1;
		this.select( shown.includes( before ) ? before : 'sole' );
	}

	private select( method: Method ): void
	{
		this.whose.value = method;
		this.sections.forEach( ( section, name ) => { section.box.hidden = name !== method; } );
	}

	/// Of a method that is shown.
	valuesOf( method: MethodName ): SettingValues
	{
		return this.sections.get( method )!.inspector.values;
	}

	/// Whatever differs from its default.
	get changes(): SettingValues
	{
		return Object.assign( {}, ...[ ...this.sections.values() ].map( ( { inspector } ) => inspector.changes ) ) as SettingValues;
	}

	/// Changes on top of the defaults, of whoever has settings of these names.
	chooseChanges( changes: SettingValues ): void
	{
		this.waiting = changes;
		this.sections.forEach( ( { inspector } ) => inspector.chooseChanges( changes ) );
	}

	/// A file of Sole's settings, or of those of a method that is shown.
	async load( file: File ): Promise<void>
	{
		const text = await file.text();
		const method = [ ...this.sections.keys() ].find( ( name ) => new RegExp( `^\\s*\\{\\s*"${name}"` ).test( text ) );
		await ( this.sections.get( method ?? 'sole' )! ).inspector.load( file );
	}

	/// How many are changed, at the tab.
	private mark(): void
	{
		const count = Object.keys( this.changes ).length;
		const tab = find( 'tab-settings' );
		tab.querySelector( '.count' )?.remove();
		if ( count > 0 )
		{
			tab.append( make( 'span', { class: 'count', title: `${count} changed` }, String( count ) ) );
		}
	}
}
