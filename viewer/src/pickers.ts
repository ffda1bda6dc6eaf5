// SPDX-License-Identifier: MIT
// The bar: which character, clip, ground and method; files of the user; the theme and a link to what is shown.
import type { Method } from './body';
import type { Sample } from './files';
import { find, getTheme, make, makeOpener, setTheme } from './page';

export const methodChoices: Record<string, { label: string; methods: Method[] }> = {
	both: { label: 'side by side', methods: [ 'none', 'sole' ] },
	sole: { label: 'Sole', methods: [ 'sole' ] },
	none: { label: 'as animated', methods: [ 'none' ] },
};

export const methodCaptions: Record<Method, string> = { none: 'as animated', sole: 'placed by Sole' };

export interface PickerEvents
{
	character: ( name: string ) => void;
	clip: ( name: string ) => void;
	ground: ( name: string ) => void;
	method: ( name: string ) => void;
	files: ( files: File[] ) => void;
	link: () => void;
}

type Option = readonly [ value: string, label: string ];

export class Pickers
{
	private readonly selects: Record<'character' | 'clip' | 'ground' | 'method', HTMLSelectElement>;

	constructor( samples: readonly Sample[], events: PickerEvents )
	{
		const choose = ( name: keyof PickerEvents & ( 'character' | 'clip' | 'ground' | 'method' ), label: string ): HTMLSelectElement =>
		{
			const select = make( 'select', { id: `pick-${name}`, onchange: () => events[ name ]( select.value ) } );
			find( 'pickers' ).append( make( 'label', {}, label, select ) );
			return select;
		};
		this.selects = { character: choose( 'character', 'Character' ), clip: choose( 'clip', 'Clip' ),
			ground: choose( 'ground', 'Ground' ), method: choose( 'method', 'Feet' ) };
		const named = ( kind: string ): Option[] => samples.filter( ( sample ) => sample.kind === kind )
			.map( ( sample ) => [ sample.name, kind === 'ground' ? `${sample.name}: ${sample.text}` : sample.name ] );
		this.fill( 'character', named( 'character' ) );
		this.fill( 'ground', named( 'ground' ) );
		this.fill( 'method', Object.entries( methodChoices ).map( ( [ name, choice ] ) => [ name, choice.label ] ) );
		const theme = make( 'button', { title: 'Light or dark', 'aria-label': 'Light or dark', onclick: () =>
			setTheme( getTheme() === 'dark' ? 'light' : 'dark' ) }, '◐' );
		find( 'tools' ).append(
			makeOpener( 'Open…', '.glb,.gltf,.vrm,.obj,.json', 'Open a character (GLB), a ground (GLB, OBJ) or settings (JSON); or drop it on the page', events.files ),
			make( 'button', { class: 'wide', title: 'Copy a link to this scene with these settings', onclick: events.link }, 'Link' ), theme );
	}

	fill( name: keyof Pickers[ 'selects' ], options: readonly Option[] ): void
	{
		this.selects[ name ].replaceChildren( ...options.map( ( [ value, label ] ) => make( 'option', { value }, label ) ) );
	}

	/// Chooses one; the user's own file is added where it is new.
	show( name: keyof Pickers[ 'selects' ], value: string ): void
	{
		const select = this.selects[ name ];
		if ( [ ...select.options ].every( ( option ) => option.value !== value ) )
		{
			select.append( make( 'option', { value }, value ) );
		}
		select.value = value;
	}

	value( name: keyof Pickers[ 'selects' ] ): string
	{
		return this.selects[ name ].value;
	}
}
