// SPDX-License-Identifier: MIT
// The bar: which character, clip, ground and method; files of the user; the theme and a link to what is shown.
import type { Method } from './body';
import type { Sample } from './files';
import { find, getTheme, make, makeOpener, setTheme } from './page';

export const methodLabels: Record<Method, string> = { sole: 'Sole', none: 'as animated', homebrew: 'Homebrew Foot IK',
	iksetting: 'IKSetting', effector: 'And I Must Scream', ozz: 'ozz sample' };

const NOTHING = ''; // beside

function isMethod( name: string ): name is Method
{
	return name in methodLabels;
}

/// One method or two, left to right: "both", "sole", "ozz,sole". What is none is left out.
export function readMethods( text: string | null ): Method[]
{
	const methods = ( text === null || text === 'both' ? 'none,sole' : text ).split( ',' ).filter( isMethod );
	return methods.length > 0 ? methods.slice( -2 ) : [ 'none', 'sole' ];
}

export interface PickerEvents
{
	character: ( name: string ) => void;
	clip: ( name: string ) => void;
	ground: ( name: string ) => void;
	method: () => void;
	files: ( files: File[] ) => void;
	link: () => void;
}

type Option = readonly [ value: string, label: string ];

export class Pickers
{
	private readonly selects: Record<'character' | 'clip' | 'ground' | 'method' | 'beside', HTMLSelectElement>;

	constructor( samples: readonly Sample[], events: PickerEvents )
	{
		const choose = ( name: keyof Pickers[ 'selects' ], label: string, changed: ( value: string ) => void ): HTMLSelectElement =>
		{
			const select = make( 'select', { id: `pick-${name}`, onchange: () => changed( select.value ) } );
			find( 'pickers' ).append( make( 'label', {}, label, select ) );
			return select;
		};
		this.selects = { character: choose( 'character', 'Character', events.character ), clip: choose( 'clip', 'Clip', events.clip ),
			ground: choose( 'ground', 'Ground', events.ground ), method: choose( 'method', 'Feet', events.method ),
			beside: choose( 'beside', 'beside', events.method ) };
		const named = ( kind: string ): Option[] => samples.filter( ( sample ) => sample.kind === kind )
			.map( ( sample ) => [ sample.name, kind === 'ground' ? `${sample.name}: ${sample.text}` : sample.name ] );
		this.fill( 'character', named( 'character' ) );
		this.fill( 'ground', named( 'ground' ) );
		const methods: Option[] = Object.entries( methodLabels );
		this.fill( 'method', methods );
		this.fill( 'beside', [ [ NOTHING, 'nothing' ], ...methods ] );
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

	/// The methods that are shown, left to right.
	get methods(): Method[]
	{
		return [ this.value( 'beside' ), this.value( 'method' ) ].filter( isMethod );
	}

	set methods( methods: readonly Method[] )
	{
		this.show( 'method', methods.at( -1 )! );
		this.show( 'beside', methods.length > 1 ? methods[ 0 ]! : NOTHING );
	}

	value( name: keyof Pickers[ 'selects' ] ): string
	{
		return this.selects[ name ].value;
	}
}
