// SPDX-License-Identifier: MIT
// The viewer as a user has it: every sample loads, every control does something, a keyboard reaches all of them, broken
// files leave the page alive, and the feet in the picture are where the library, here and natively, puts them.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, readdirSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';
import { folder, openBrowser, usePage } from '../page.mjs';

const sole = fileURLToPath( new URL( '../../build/release/tool/sole', import.meta.url ) );
const tuning = fileURLToPath( new URL( '../../docs/tuning.md', import.meta.url ) );
const BUDGET = 1.5e6; // bytes, compressed

let host;
const work = mkdtempSync( join( tmpdir(), 'sole-viewer-' ) );

before( async () => { host = await openBrowser(); } );
after( async () =>
{
	await host?.close();
	rmSync( work, { recursive: true } );
} );

const onPage = ( query, run, options ) => usePage( host, query, run, options );

function sizeOf( names )
{
	return names.reduce( ( sum, name ) => sum + gzipSync( readFileSync( join( folder, name ) ) ).length, 0 );
}

function drop( page, name, bytes )
{
	return page.evaluate( ( [ fileName, text ] ) =>
	{
		const data = new DataTransfer();
		data.items.add( new File( [ Uint8Array.from( atob( text ), ( c ) => c.charCodeAt( 0 ) ) ], fileName ) );
		window.dispatchEvent( new DragEvent( 'drop', { dataTransfer: data, bubbles: true, cancelable: true } ) );
	}, [ name, Buffer.from( bytes ).toString( 'base64' ) ] );
}

const message = ( page, text ) => page.locator( '#messages p', { hasText: text } ).waitFor( { timeout: 5000 } );
const stepTo = ( page, time ) => page.evaluate( ( t ) => window.viewer.stepTo( t ), time );
const feet = ( page ) => page.evaluate( () => window.viewer.feet() );
const tab = ( page, name ) => page.locator( `#tab-${name}` ).click();
const row = ( page, name ) => page.locator( '.lil-controller', { has: page.locator( `.lil-name:text-is("${name}")` ) } ).first();

function apart( a, b )
{
	return Math.hypot( a[ 0 ] - b[ 0 ], a[ 1 ] - b[ 1 ], a[ 2 ] - b[ 2 ] );
}

// ----------------------------------------------------------------------------------------------------------- budget

test( 'the page and what it starts with are small', () =>
{
	const all = readdirSync( folder, { recursive: true } ).map( String ).filter( ( name ) => statSync( join( folder, name ) ).isFile() );
	const first = all.filter( ( name ) => !name.startsWith( 'samples/' ) || /(samples\.json|mannequin\.glb|T02\.glb)$/.test( name ) );
	assert.ok( first.length >= 5 );
	const size = sizeOf( first );
	console.log( `page ${size} bytes compressed, with all samples ${sizeOf( all )}` );
	assert.ok( size < BUDGET );
} );

test( 'every address of the page is relative', () =>
{
	assert.doesNotMatch( readFileSync( join( folder, 'index.html' ), 'utf8' ), /(src|href)="\/|https?:/ );
} );

// ---------------------------------------------------------------------------------------------------------- samples

test( 'every ground loads, and feet come to stand on it', async () =>
{
	await onPage( 'scene=T01&method=sole', async ( page ) =>
	{
		const names = await page.evaluate( () => window.viewer.grounds() );
		assert.ok( names.length >= 40 );
		for ( const name of names )
		{
			await page.locator( '#pick-ground' ).selectOption( name );
			await page.waitForFunction( ( wanted ) => window.viewer.shown().ground === wanted, name );
			await stepTo( page, 0.3 );
			for ( const foot of await feet( page ) )
			{
				assert.ok( foot.joints.flat().every( Number.isFinite ), name );
			}
		}
		assert.equal( await page.locator( '#messages p.bad' ).count(), 0 );
	} );
} );

test( 'every clip of the mannequin plays', async () =>
{
	await onPage( 'scene=T02', async ( page ) =>
	{
		const clips = await page.locator( '#pick-clip option' ).allTextContents();
		assert.ok( clips.length >= 8 );
		for ( const clip of clips )
		{
			await page.locator( '#pick-clip' ).selectOption( clip );
			await stepTo( page, 0.5 );
			assert.ok( ( await feet( page ) ).every( ( foot ) => foot.joints.flat().every( Number.isFinite ) ), clip );
		}
	} );
} );

// ---------------------------------------------------------------------------------------------------------- numbers

test( 'feet in the picture are where the library put them, and the native library puts them there too', async () =>
{
	for ( const scene of [ 'T02', 'T14-20', 'rubble' ] )
	{
		await onPage( `scene=${scene}&method=sole`, async ( page ) =>
		{
			for ( const time of [ 0.5, 1.7, 3.1 ] )
			{
				await stepTo( page, time );
				for ( const foot of await feet( page ) )
				{
					assert.ok( apart( foot.joints.at( -1 ), foot.solved ) < 2e-5, `${scene} ${time} ${foot.name}` );
				}
			}
			const text = await page.evaluate( () => Array.from( window.viewer.trace( 3.1 ), ( byte ) => byte.toString( 16 ).padStart( 2, '0' ) ).join( '' ) );
			const file = join( work, `${scene}.trace` );
			writeFileSync( file, Buffer.from( text, 'hex' ) );
			const said = JSON.parse( execFileSync( sole, [ 'replay', file, '--json' ], { encoding: 'utf8' } ) );
			assert.equal( said.frames, Math.round( 3.1 * 60 ) + 1 );
		} );
	}
} );

test( 'a planted foot stands still and on the ground; an animated one does not', async () =>
{
	await onPage( 'scene=T02&method=sole', async ( page ) =>
	{
		// The largest gap of such a foot in the course of a second.
		const findWorst = ( kind ) => page.evaluate( ( which ) =>
		{
			let worst = 0;
			for ( let time = 2; time < 3; time += 1 / 20 )
			{
				window.viewer.stepTo( time );
				worst = Math.max( worst, ...window.viewer.figures().filter( ( foot ) => foot[ which ] ).map( ( foot ) => Math.abs( foot.gap ) ) );
			}
			return worst;
		}, kind );
		const placed = await findWorst( 'held' );
		await page.locator( '#pick-method' ).selectOption( 'none' );
		const animated = await findWorst( 'stands' );
		assert.ok( placed < 0.02, `${placed}` );
		assert.ok( animated > 0.05, `${animated}` );
	} );
} );

test( 'the same time is the same frame, whatever was before', async () =>
{
	await onPage( 'scene=T14-20&method=sole', async ( page ) =>
	{
		await stepTo( page, 2 );
		const before = await feet( page );
		await stepTo( page, 3.5 );
		await stepTo( page, 2 );
		assert.deepEqual( await feet( page ), before );
	} );
} );

// --------------------------------------------------------------------------------------------------------- controls

test( 'every control is driven once', async () =>
{
	await onPage( 'scene=T02&method=sole', async ( page ) =>
	{
		await stepTo( page, 1 );
		for ( const name of [ 'settings', 'show', 'checks', 'scene' ] )
		{
			await tab( page, name );
			const section = page.locator( `#page-${name}` );
			await section.evaluate( ( element ) =>
			{
				for ( const box of element.querySelectorAll( 'input[type=checkbox]' ) )
				{
					box.click();
					window.viewer.stepTo( 1 );
					box.click();
				}
				for ( const input of element.querySelectorAll( '.lil-number input' ) )
				{
					const value = input.value;
					for ( const wanted of [ '0.3', value ] )
					{
						input.value = wanted;
						input.dispatchEvent( new Event( 'input', { bubbles: true } ) );
						input.dispatchEvent( new Event( 'blur', { bubbles: true } ) );
					}
				}
				for ( const select of element.querySelectorAll( 'select' ) )
				{
					for ( let i = select.options.length - 1; i >= 0; --i )
					{
						select.selectedIndex = i;
						select.dispatchEvent( new Event( 'change', { bubbles: true } ) );
					}
				}
				for ( const button of element.querySelectorAll( '.page-tools button:not(:disabled), .checks button' ) )
				{
					if ( !/Load|Save/.test( button.textContent ) )
					{
						button.click();
					}
				}
			} );
			await stepTo( page, 1.2 );
		}
		for ( const method of [ 'sole', 'none' ] )
		{
			await page.locator( '#pick-method' ).selectOption( method );
			await stepTo( page, 0.2 );
		}
		for ( const button of await page.locator( '#transport button' ).all() )
		{
			await button.click();
		}
		await page.locator( '#transport select' ).selectOption( '0.25' );
		assert.equal( await page.locator( '#messages p.bad' ).count(), 0 );
	} );
} );

test( 'switches of stages change the feet and give them back', async () =>
{
	await onPage( 'scene=T14-20&method=sole', async ( page ) =>
	{
		await stepTo( page, 1.5 );
		const before = await feet( page );
		await row( page, 'align' ).locator( 'input' ).click();
		await stepTo( page, 0 );
		await stepTo( page, 1.5 );
		const toe = ( list ) => list[ 0 ].points;
		assert.notDeepEqual( toe( await feet( page ) ), toe( before ) );
		await row( page, 'align' ).locator( 'input' ).click();
		await stepTo( page, 0 );
		await stepTo( page, 1.5 );
		assert.deepEqual( await feet( page ), before );
	} );
} );

test( 'changed settings are marked, undone, saved as the program reads them and loaded again', async () =>
{
	await onPage( 'scene=T01&panel=settings', async ( page ) =>
	{
		const lockDistance = row( page, 'lockDistance' );
		await lockDistance.locator( 'input' ).fill( '0.1' );
		await lockDistance.locator( 'input' ).press( 'Enter' );
		await page.locator( '#canvas' ).focus();
		assert.deepEqual( await page.evaluate( () => window.viewer.changes() ), { 'contact.lockDistance': 0.1 } );
		assert.equal( await page.locator( '.lil-controller.changed' ).count(), 1 );
		assert.equal( await page.locator( '#tab-settings .count' ).textContent(), '1' );
		const [ download ] = await Promise.all( [ page.waitForEvent( 'download' ), page.locator( '.page-tools button', { hasText: 'Save' } ).click() ] );
		const file = join( work, 'settings.json' );
		await download.saveAs( file );
		execFileSync( sole, [ 'bake', 'mannequin', '--ground', 'T01', '--distance', '1', '--settings', file, '-o', join( work, 'm.glb' ) ] );
		await page.keyboard.press( 'Control+z' );
		assert.deepEqual( await page.evaluate( () => window.viewer.changes() ), {} );
		await page.keyboard.press( 'Control+Shift+z' );
		assert.deepEqual( await page.evaluate( () => window.viewer.changes() ), { 'contact.lockDistance': 0.1 } );
		await page.locator( '.page-tools button', { hasText: 'Reset' } ).click();
		assert.deepEqual( await page.evaluate( () => window.viewer.changes() ), {} );
		await page.locator( '#page-settings input[type=file]' ).setInputFiles( file );
		await message( page, 'settings loaded' );
		assert.deepEqual( await page.evaluate( () => window.viewer.changes() ), { 'contact.lockDistance': 0.1 } );
		await drop( page, 'bad.json', Buffer.from( '{"contact": {"lockDistance": 9}}' ) );
		await message( page, 'contact.lockDistance: is 9' );
	} );
} );

test( 'every setting says what it is', async () =>
{
	await onPage( 'scene=T01&panel=settings', async ( page ) =>
	{
		const said = await page.evaluate( () => [ ...document.querySelectorAll( '#page-settings .lil-controller' ) ].map( ( element ) =>
		{
			element.dispatchEvent( new FocusEvent( 'focusin' ) );
			const card = document.querySelector( '.card' );
			return { text: card.querySelector( 'p' ).textContent, drawn: card.querySelector( 'svg' ).children.length, facts: card.querySelectorAll( 'dd' ).length };
		} ) );
		const table = execFileSync( sole, [ 'settings' ], { encoding: 'utf8' } );
		assert.equal( said.length, table.trim().split( '\n' ).length );
		for ( const { text, drawn, facts } of said )
		{
			assert.ok( table.includes( text ) && drawn > 0 && facts === 4, text );
		}
	} );
} );

test( 'a keyboard reaches every control', async () =>
{
	for ( const name of [ 'scene', 'settings', 'show', 'checks' ] )
	{
		await onPage( `scene=T01&panel=${name}`, async ( page ) =>
		{
			const wanted = await page.evaluate( () =>
			{
				const all = [ ...document.querySelectorAll( 'button, select, input:not([type=file]), #canvas' ) ].filter( ( element ) =>
					element.checkVisibility() && !element.disabled && element.tabIndex >= 0 && element.closest( '[disabled]' ) === null );
				all.forEach( ( element, index ) => { element.dataset.order = String( index ); } );
				document.querySelector( '.skip' ).focus();
				return all.length;
			} );
			const reached = new Set();
			for ( let i = 0; i < wanted + 12; ++i )
			{
				await page.keyboard.press( 'Tab' );
				reached.add( await page.evaluate( () => document.activeElement?.dataset?.order ) );
			}
			reached.delete( undefined );
			assert.equal( reached.size, wanted, name );
		} );
	}
} );

test( 'keys walk, turn and play', async () =>
{
	await onPage( 'scene=T01&mode=keys&method=sole', async ( page ) =>
	{
		const before = await page.evaluate( () => window.viewer.root() );
		await page.locator( '#canvas' ).focus();
		await page.keyboard.down( 'ArrowUp' );
		await stepTo( page, 1 );
		await page.keyboard.up( 'ArrowUp' );
		const now = await page.evaluate( () => window.viewer.root() );
		assert.ok( apart( before, now ) > 0.4, `${apart( before, now )}` );
		await stepTo( page, 2 );
		assert.ok( apart( now, await page.evaluate( () => window.viewer.root() ) ) < 1e-6 );
	} );
} );

test( 'who stands is dragged over the ground', async () =>
{
	await onPage( 'scene=T01&mode=stand&method=sole', async ( page ) =>
	{
		const before = await page.evaluate( () => window.viewer.root() );
		const box = await page.locator( '#canvas' ).boundingBox();
		const x = box.x + box.width / 2;
		const y = box.y + box.height / 2;
		await page.mouse.move( x, y );
		await page.mouse.down();
		await page.mouse.move( x + 120, y + 60, { steps: 4 } );
		await page.mouse.up();
		assert.ok( apart( before, await page.evaluate( () => window.viewer.root() ) ) > 0.2 );
	} );
} );

test( 'two hundred walk at once', async () =>
{
	await onPage( 'scene=flat&method=sole', async ( page ) =>
	{
		await row( page, 'characters' ).locator( 'input' ).fill( '200' );
		await row( page, 'characters' ).locator( 'input' ).press( 'Enter' );
		await page.locator( '#canvas' ).focus();
		await page.waitForFunction( () => window.viewer.shown().characters === 200 );
		await stepTo( page, 0.1 );
		assert.ok( ( await feet( page ) ).every( ( foot ) => foot.joints.flat().every( Number.isFinite ) ) );
	} );
} );

// ------------------------------------------------------------------------------------------------------------ files

test( 'what was wrong with a file is forgotten with the next one that opens', async () =>
{
	await onPage( 'scene=T01&method=sole', async ( page ) =>
	{
		await drop( page, 'words.glb', Buffer.from( 'this is no model' ) );
		await message( page, 'words.glb: is no GLB file' );
		await drop( page, 'mine.glb', readFileSync( join( folder, 'samples/mannequin.glb' ) ) );
		await message( page, 'mine.glb: opened as character' );
		assert.equal( await page.locator( '#messages p' ).count(), 1 );
	} );
} );

test( 'broken files are refused in a sentence, and the page lives on', async () =>
{
	await onPage( 'scene=T02&method=sole', async ( page ) =>
	{
		const good = readFileSync( join( folder, 'samples/mannequin.glb' ) );
		const bads = [
			[ 'cut.glb', good.subarray( 0, 4000 ) ], [ 'words.glb', Buffer.from( 'this is no model' ) ], [ 'empty.glb', Buffer.alloc( 0 ) ],
			[ 'empty.obj', Buffer.from( '# nothing\n' ) ], [ 'what.txt', Buffer.from( 'x' ) ],
		];
		for ( const [ name, bytes ] of bads )
		{
			await drop( page, name, bytes );
			await message( page, name );
			await page.locator( '#messages p.bad button' ).first().click();
			await stepTo( page, 0.5 );
			assert.equal( ( await feet( page ) ).length, 2 );
		}
	} );
} );

test( 'files of the user are opened: a character, a ground of GLB and of OBJ', async () =>
{
	await onPage( 'scene=T01&method=sole', async ( page ) =>
	{
		await drop( page, 'mine.glb', readFileSync( join( folder, 'samples/mannequin.glb' ) ) );
		await message( page, 'opened as character' );
		await drop( page, 'stairs.glb', readFileSync( join( folder, 'samples/T03.glb' ) ) );
		await message( page, 'opened as ground' );
		await drop( page, 'wedge.obj', Buffer.from( 'v -4 0 -4\nv 4 0 -4\nv 4 1 4\nv -4 1 4\nf 1 3 2\nf 1 4 3\n' ) );
		await page.waitForFunction( () => window.viewer.shown().ground === 'wedge.obj' );
		await stepTo( page, 1 );
		const [ , height ] = await page.evaluate( () => window.viewer.root() );
		assert.ok( height > 0.05 && height < 1, `${height}` );
	} );
} );

// ------------------------------------------------------------------------------------------------------------ links

test( 'every link of the tuning page opens what it says', async () =>
{
	const links = [ ...readFileSync( tuning, 'utf8' ).matchAll( /http:\/\/localhost:4173\/\?([^)]*)\)/g ) ].map( ( match ) => match[ 1 ] );
	assert.ok( links.length >= 15 );
	await onPage( links[ 0 ], async ( page ) =>
	{
		const names = await page.evaluate( () => window.viewer.grounds() );
		const kinds = await page.evaluate( () => window.viewer.drawings() );
		const settings = await page.evaluate( () => window.viewer.settings() );
		for ( const link of links )
		{
			const query = new URLSearchParams( link );
			assert.ok( names.includes( query.get( 'scene' ) ), link );
			assert.ok( ( query.get( 'show' ) ?? '' ).split( ',' ).every( ( name ) => kinds.includes( name ) ), link );
			for ( const part of ( query.get( 'set' ) ?? '' ).split( ',' ).filter( Boolean ) )
			{
				assert.ok( settings.includes( part.split( ':' )[ 0 ] ), link );
			}
		}
	} );
	const query = new URLSearchParams( links.find( ( link ) => link.includes( 'set=' ) ) );
	await onPage( query.toString(), async ( page ) =>
	{
		const [ name, value ] = query.get( 'set' ).split( ':' );
		assert.deepEqual( await page.evaluate( () => window.viewer.changes() ), { [ name ]: Number( value ) } );
		assert.equal( ( await page.evaluate( () => window.viewer.shown() ) ).ground, query.get( 'scene' ) );
	} );
} );

// ----------------------------------------------------------------------------------------------------------- layout

test( 'laptop and phone, light and dark: nothing is wider than the screen, all controls can be read', async () =>
{
	for ( const viewport of [ { width: 1366, height: 768 }, { width: 390, height: 844 } ] )
	{
		for ( const colorScheme of [ 'light', 'dark' ] )
		{
			await onPage( 'scene=T02', async ( page ) =>
			{
				const state = await page.evaluate( () => ( {
					wide: document.documentElement.scrollWidth, theme: document.documentElement.dataset.theme,
					scene: document.getElementById( 'canvas' ).getBoundingClientRect().toJSON(),
				} ) );
				assert.equal( state.theme, colorScheme );
				assert.ok( state.wide <= viewport.width );
				assert.ok( state.scene.height >= 200 && state.scene.width >= 380 );
			}, { viewport, colorScheme } );
		}
	}
} );
