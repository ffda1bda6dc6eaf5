// SPDX-License-Identifier: MIT
// Pictures at fixed times are as they were. SOLE_WRITE_PICTURES=1 stores what they are now.
import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { openBrowser, usePage } from '../page.mjs';

const pictures = new URL( './pictures/', import.meta.url );
const PICTURE = { width: 480, height: 320 };
const DIFFERENT = 24; // of 255: a pixel that is so much off is another
const MOST_DIFFERENT = 0.004; // share of the pixels: edges that fall differently

let host;
before( async () => { host = await openBrowser(); } );
after( () => host?.close() );

const shots = {
	stairs: 'scene=T02&method=both&time=3.2',
	gizmos: 'scene=T02&method=sole&time=3.2&show=all',
	slope: 'scene=T14-20&method=sole&time=1.5&theme=dark&show=support plane,locks',
};

/// Compared in the page: browsers read pictures.
function compare( page, ours, theirs )
{
	return page.evaluate( async ( [ a, b, least ] ) =>
	{
		const read = async ( text ) =>
		{
			const bitmap = await createImageBitmap( await ( await fetch( `data:image/png;base64,${text}` ) ).blob() );
			const canvas = new OffscreenCanvas( bitmap.width, bitmap.height );
			const context = canvas.getContext( '2d' );
			context.drawImage( bitmap, 0, 0 );
			return context.getImageData( 0, 0, bitmap.width, bitmap.height );
		};
		const [ x, y ] = [ await read( a ), await read( b ) ];
		let count = x.width === y.width && x.height === y.height ? 0 : Infinity;
		for ( let i = 0; i < x.data.length; i += 4 )
		{
			const off = Math.max( ...[ 0, 1, 2 ].map( ( k ) => Math.abs( x.data[ i + k ] - y.data[ i + k ] ) ) );
			count += off > least ? 1 : 0;
		}
		return count / ( x.width * x.height );
	}, [ ours.toString( 'base64' ), theirs.toString( 'base64' ), DIFFERENT ] );
}

for ( const [ name, query ] of Object.entries( shots ) )
{
	test( `the picture of ${name} is as it was`, async () =>
	{
		await usePage( host, query, async ( page ) =>
		{
			await page.evaluate( () => document.getElementById( 'view' ).style.setProperty( 'position', 'fixed' ) );
			await page.evaluate( ( { width, height } ) => Object.assign( document.getElementById( 'view' ).style,
				{ left: 0, top: 0, width: `${width}px`, height: `${height}px`, zIndex: 9 } ), PICTURE );
			const data = await page.evaluate( () => window.viewer.picture() );
			const shot = Buffer.from( data.split( ',' )[ 1 ], 'base64' );
			const file = new URL( `${name}.png`, pictures );
			if ( process.env.SOLE_WRITE_PICTURES === '1' )
			{
				writeFileSync( file, shot );
			}
			const different = await compare( page, shot, readFileSync( file ) );
			assert.ok( different < MOST_DIFFERENT, `${( 100 * different ).toFixed( 2 )} % of the pixels differ` );
		}, { viewport: { width: 800, height: 600 } } );
	} );
}
