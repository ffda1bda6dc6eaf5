// SPDX-License-Identifier: MIT
// The page's address: what to show, so that a link opens the same scene with the same settings.
//   ?scene=T02&clip=walk&method=both&show=locks,targets&set=contact.lockDistance:0.1&time=2.5
// manual=1 is for tests: nothing moves by itself, and pictures are the same every time.

export interface Address
{
	scene: string;
	character: string;
	clip: string | null;
	method: string | null;
	mode: string | null;
	show: string[];
	set: [ string, number ][];
	time: number | null;
	theme: string | null;
	panel: string | null;
	manual: boolean;
}

function readPairs( text: string ): [ string, number ][]
{
	return text.split( ',' ).filter( ( part ) => part.includes( ':' ) ).map( ( part ) =>
	{
		const [ name, value ] = part.split( ':' );
		return [ name!, Number( value ) ];
	} );
}

export function readAddress( search: string ): Address
{
	const query = new URLSearchParams( search );
	const time = query.get( 'time' );
	return {
		scene: query.get( 'scene' ) ?? 'T02',
		character: query.get( 'character' ) ?? 'mannequin',
		clip: query.get( 'clip' ),
		method: query.get( 'method' ),
		mode: query.get( 'mode' ),
		show: ( query.get( 'show' ) ?? '' ).split( ',' ).filter( ( name ) => name !== '' ),
		set: readPairs( query.get( 'set' ) ?? '' ),
		time: time === null ? null : Number( time ),
		theme: query.get( 'theme' ),
		panel: query.get( 'panel' ),
		manual: query.get( 'manual' ) === '1',
	};
}

/// The address of what is shown now.
export function writeAddress( parts: Record<string, string> ): string
{
	const query = new URLSearchParams( Object.entries( parts ).filter( ( [ , value ] ) => value !== '' ) );
	return `${location.origin}${location.pathname}?${query.toString().replaceAll( '%3A', ':' ).replaceAll( '%2C', ',' )}`;
}
