// SPDX-License-Identifier: MIT
// The page's own elements: small helpers to make them, messages, tabs and the theme.

type Attributes = Record<string, string | boolean | ( ( event: Event ) => void )>;

/// An element with attributes, listeners ("onclick") and children.
export function make<K extends keyof HTMLElementTagNameMap>(
	tag: K, attributes: Attributes = {}, ...children: ( Node | string )[] ): HTMLElementTagNameMap[K]
{
	const element = document.createElement( tag );
	for ( const [ name, value ] of Object.entries( attributes ) )
	{
		if ( typeof value === 'function' )
		{
			element.addEventListener( name.slice( 2 ), value );
		}
		else if ( value === true || typeof value === 'string' )
		{
			element.setAttribute( name, value === true ? '' : value );
		}
	}
	element.append( ...children );
	return element;
}

export function find<T extends HTMLElement>( id: string ): T
{
	const element = document.getElementById( id );
	if ( element === null )
	{
		throw new Error( `the page has no element ${id}` );
	}
	return element as T;
}

/// A sentence for people. Bad news stay until they are closed, the rest goes by itself.
export function say( text: string, bad = false ): void
{
	const box = find( 'messages' );
	const close = make( 'button', { 'aria-label': 'Close the message', onclick: () => line.remove() }, '✕' );
	const line = make( 'p', { class: bad ? 'bad' : 'news' }, text, close );
	for ( const old of box.querySelectorAll( bad ? 'p' : 'p.news' ) )
	{
		old.remove();
	}
	box.append( line );
	if ( bad === false )
	{
		setTimeout( () => line.remove(), 5000 );
	}
}

/// What was said of files that are not shown now.
export function forgetMessages(): void
{
	find( 'messages' ).replaceChildren();
}

/// What a value thrown by anyone says.
export function messageOf( error: unknown ): string
{
	return error instanceof Error ? error.message : String( error );
}

/// A file for the user to keep.
export function save( name: string, content: BlobPart, type: string ): void
{
	const url = URL.createObjectURL( new Blob( [ content ], { type } ) );
	make( 'a', { href: url, download: name } ).click();
	setTimeout( () => URL.revokeObjectURL( url ), 1000 );
}

/// A button that opens files.
export function makeOpener( text: string, accept: string, title: string, opened: ( files: File[] ) => void ): HTMLElement
{
	const input = make( 'input', { type: 'file', accept, hidden: true, multiple: true, 'aria-label': title } );
	input.addEventListener( 'change', () =>
	{
		opened( [ ...( input.files ?? [] ) ] );
		input.value = '';
	} );
	return make( 'span', {}, input, make( 'button', { title, onclick: () => input.click() }, text ) );
}

// ------------------------------------------------------------------------------------------------------------ tabs

export interface Tab
{
	readonly page: HTMLElement;
	readonly button: HTMLButtonElement;
	select(): void;
}

const tabs: Tab[] = [];

/// A page of the panel behind a tab; arrow keys go from tab to tab.
export function addTab( id: string, name: string, shown?: ( visible: boolean ) => void ): Tab
{
	const page = make( 'section', { id: `page-${id}`, role: 'tabpanel', 'aria-labelledby': `tab-${id}` } );
	const button = make( 'button', { id: `tab-${id}`, role: 'tab', 'aria-controls': page.id, onclick: () => tab.select() },
		name );
	const tab: Tab = { page, button, select: () => tabs.forEach( ( other ) =>
	{
		other.page.hidden = other !== tab;
		other.button.setAttribute( 'aria-selected', String( other === tab ) );
		other.button.tabIndex = other === tab ? 0 : -1;
		other.page.dispatchEvent( new CustomEvent( 'shown', { detail: other === tab } ) );
	} ) };
	page.addEventListener( 'shown', ( event ) => shown?.( ( event as CustomEvent<boolean> ).detail ) );
	button.addEventListener( 'keydown', ( event ) =>
	{
		const step = event.key === 'ArrowRight' ? 1 : event.key === 'ArrowLeft' ? -1 : 0;
		if ( step !== 0 )
		{
			const next = tabs[ ( tabs.indexOf( tab ) + step + tabs.length ) % tabs.length ]!;
			next.select();
			next.button.focus();
		}
	} );
	tabs.push( tab );
	find( 'tabs' ).append( button );
	find( 'pages' ).append( page );
	return tab;
}

// ----------------------------------------------------------------------------------------------------------- theme

export type Theme = 'light' | 'dark';

const wantsDark = matchMedia( '(prefers-color-scheme: dark)' );
const listeners: ( ( theme: Theme ) => void )[] = [];
let chosen: Theme | undefined;

export function getTheme(): Theme
{
	return chosen ?? ( wantsDark.matches ? 'dark' : 'light' );
}

function applyTheme(): void
{
	document.documentElement.dataset[ 'theme' ] = getTheme();
	listeners.forEach( ( listener ) => listener( getTheme() ) );
}

/// Follows the system until the user chooses.
export function setTheme( theme: Theme ): void
{
	chosen = theme;
	applyTheme();
}

export function onTheme( listener: ( theme: Theme ) => void ): void
{
	listeners.push( listener );
	listener( getTheme() );
}

/// A colour of the style sheet.
export function styleColor( name: string ): string
{
	return getComputedStyle( document.documentElement ).getPropertyValue( name ).trim();
}

wantsDark.addEventListener( 'change', applyTheme );
applyTheme();
