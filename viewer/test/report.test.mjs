// SPDX-License-Identifier: MIT
// The page of a report as a user has it: opened from a file, without a server. The legs in its pictures are where the
// clips of the baked file have them, by a reader of its own; time can be reached everywhere; names do no harm.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { Matrix4, Quaternion, Vector3 } from 'three';
import { openBrowser, useAt } from '../page.mjs';

const sole = fileURLToPath( new URL( '../../build/release/tool/sole', import.meta.url ) );
const template = fileURLToPath( new URL( '../../build/report/template.html', import.meta.url ) );
const work = mkdtempSync( join( tmpdir(), 'sole-report-' ) );
const walk = [ 'mannequin', '--ground', 'T02', '--distance', '4' ];
const NEAR = 1e-4; // m: files keep floats

let host;

function makeReport( name, ...options )
{
	const file = join( work, name );
	execFileSync( sole, [ 'report', ...options, '--template', template, '-o', file ] );
	return file;
}

const onReport = ( file, run, options ) => useAt( host, `${pathToFileURL( file )}?manual=1`, run, options );
const stepTo = ( page, time ) => page.evaluate( ( t ) => window.report.stepTo( t ), time );
const places = ( page ) => page.evaluate( () => window.report.places() );
const clock = async ( page ) => Number.parseFloat( await page.locator( '#transport output' ).first().textContent() );

before( async () =>
{
	makeReport( 'r.html', ...walk );
	execFileSync( sole, [ 'bake', ...walk, '--method', 'none', '--method', 'sole', '-o', join( work, 'r.glb' ) ] );
	host = await openBrowser();
} );

after( async () =>
{
	await host?.close();
	rmSync( work, { recursive: true } );
} );

// ----------------------------------------------------------------------------------------------------------- a clip

/// A .glb's JSON and the floats of an accessor.
function readGlb( file )
{
	const bytes = readFileSync( file );
	const length = bytes.readUInt32LE( 12 );
	const json = JSON.parse( bytes.toString( 'utf8', 20, 20 + length ) );
	const floats = ( index ) =>
	{
		const accessor = json.accessors[ index ];
		const view = json.bufferViews[ accessor.bufferView ];
		const begin = 28 + length + ( view.byteOffset ?? 0 ) + ( accessor.byteOffset ?? 0 );
		const size = { SCALAR: 1, VEC3: 3, VEC4: 4 }[ accessor.type ];
		assert.equal( accessor.componentType, 5126 );
		return Array.from( { length: accessor.count * size }, ( _, i ) => bytes.readFloatLE( begin + 4 * i ) );
	};
	return { json, floats };
}

/// A channel's value between its keys.
function sample( times, values, size, time )
{
	const next = times.findIndex( ( key ) => key >= time );
	const b = next < 0 ? times.length - 1 : next;
	const a = Math.max( b - ( next > 0 ? 1 : 0 ), 0 );
	const share = b > a ? ( time - times[ a ] ) / ( times[ b ] - times[ a ] ) : 0;
	const from = values.slice( a * size, ( a + 1 ) * size );
	const to = values.slice( b * size, ( b + 1 ) * size );
	return size === 4 ? new Quaternion( ...from ).slerp( new Quaternion( ...to ), share ).toArray()
		: from.map( ( x, i ) => x + share * ( to[ i ] - x ) );
}

/// World place of a node of a file, as a clip has it.
function placeOf( { json, floats }, clip, name, time )
{
	const animation = json.animations.find( ( one ) => one.name === clip );
	const locals = json.nodes.map( ( node ) => ( { translation: [ 0, 0, 0 ], rotation: [ 0, 0, 0, 1 ], scale: [ 1, 1, 1 ], ...node } ) );
	for ( const { sampler, target } of animation.channels )
	{
		const { input, output } = animation.samplers[ sampler ];
		locals[ target.node ][ target.path ] = sample( floats( input ), floats( output ), target.path === 'rotation' ? 4 : 3, time );
	}
	const world = new Matrix4();
	for ( let node = json.nodes.findIndex( ( one ) => one.name === name ); node >= 0; )
	{
		const { translation, rotation, scale } = locals[ node ];
		world.premultiply( new Matrix4().compose( new Vector3( ...translation ), new Quaternion( ...rotation ), new Vector3( ...scale ) ) );
		node = json.nodes.findIndex( ( one ) => one.children?.includes( node ) );
	}
	return new Vector3().setFromMatrixPosition( world );
}

// ----------------------------------------------------------------------------------------------------------- tests

test( 'the page asks for nothing but itself', async () =>
{
	const file = join( work, 'r.html' );
	assert.doesNotMatch( readFileSync( file, 'utf8' ), /<script[^>]* src=|<link[^>]* href="(?!data:)/ );
	await onReport( file, async ( page, requests ) =>
	{
		assert.deepEqual( requests.filter( ( address ) => !/^(blob|data):/.test( address ) ).length, 1 );
		assert.match( await page.title(), /walk over T02/ );
	} );
} );

test( 'ankles in both pictures are where the clips of the file have them', async () =>
{
	const glb = readGlb( join( work, 'r.glb' ) );
	await onReport( join( work, 'r.html' ), async ( page ) =>
	{
		const size = page.viewportSize();
		for ( const time of [ 0, 31 / 60, 1.2345, 2.8 ] )
		{
			await stepTo( page, time );
			const seen = await places( page );
			assert.deepEqual( seen.map( ( side ) => side.method ), [ 'none', 'sole' ] );
			seen.forEach( ( side, index ) => side.legs.forEach( ( leg ) =>
			{
				const wanted = placeOf( glb, `walk|${side.method}`, leg.name === 'left' ? 'foot_l' : 'foot_r', time );
				assert.ok( new Vector3( ...leg.joints.at( -1 ) ).distanceTo( wanted ) < NEAR, `${side.method} ${leg.name} at ${time}` );
				assert.ok( leg.pixel[ 0 ] > 0.5 * index * size.width && leg.pixel[ 0 ] < 0.5 * ( index + 1 ) * size.width );
			} ) );
		}
		const [ none, placed ] = await places( page );
		assert.notDeepEqual( none.legs, placed.legs );
	} );
} );

test( 'time goes by slider, plots, buttons and keys, and plays', async () =>
{
	await onReport( join( work, 'r.html' ), async ( page ) =>
	{
		const cursor = () => page.locator( '#plots .cursor' ).first().evaluate( ( element ) => element.getBoundingClientRect().x );
		const start = await cursor();
		await page.locator( '#scrub' ).focus();
		await page.keyboard.press( 'ArrowRight' );
		assert.equal( await page.locator( '#scrub' ).inputValue(), '1' );
		await page.keyboard.press( 'End' );
		assert.ok( await clock( page ) > 3 );
		assert.ok( await cursor() > start + 200 );
		const end = await places( page );
		const box = await page.locator( '#plots canvas' ).first().boundingBox();
		await page.mouse.click( box.x + 0.5 * box.width, box.y + 20 );
		const middle = await clock( page );
		assert.ok( middle > 1 && middle < 3, `${middle}` );
		assert.notDeepEqual( await places( page ), end );
		await page.locator( '#canvas' ).focus();
		await page.keyboard.press( '.' );
		assert.ok( Math.abs( await clock( page ) - middle - 1 / 60 ) < 0.011 );
		await page.keyboard.press( ',' );
		assert.equal( await clock( page ), middle );
		await page.keyboard.press( 'r' );
		assert.equal( await clock( page ), 0 );
		await page.locator( '#transport select' ).selectOption( '0.25' );
		await page.locator( '#transport button[aria-label=Play]' ).click();
		await page.waitForFunction( () => Number.parseFloat( document.querySelector( '#transport output' ).textContent ) > 0.1 );
		await page.locator( '#transport button[aria-label=Pause]' ).click();
	} );
} );

test( 'plots have lines, and the table has the figures and their targets', async () =>
{
	const table = JSON.parse( execFileSync( sole, [ 'bake', ...walk, '--json', '-o', join( work, 't.glb' ) ], { encoding: 'utf8' } ) );
	await onReport( join( work, 'r.html' ), async ( page ) =>
	{
		// Pixels of the colour of what is placed: #1769c4.
		const drawn = await page.locator( '#plots canvas' ).evaluateAll( ( all ) => all.map( ( canvas ) =>
		{
			const { data } = canvas.getContext( '2d' ).getImageData( 0, 0, canvas.width, canvas.height );
			let count = 0;
			for ( let i = 0; i < data.length; i += 4 )
			{
				count += Math.hypot( data[ i ] - 0x17, data[ i + 1 ] - 0x69, data[ i + 2 ] - 0xc4 ) < 40 ? 1 : 0;
			}
			return count;
		} ) );
		assert.equal( drawn.length, 8 );
		assert.ok( drawn.every( ( count ) => count > 200 ), `${drawn}` );
		const cells = await page.locator( '#figures tr', { hasText: 'penetration max' } ).locator( 'td' ).allTextContents();
		assert.equal( Number.parseFloat( cells[ 1 ] ).toFixed( 1 ), ( 1000 * table.clips[ 0 ].whole.penetration.max ).toFixed( 1 ) );
		assert.equal( cells[ 2 ], '≤ 10.0' );
		assert.match( await page.locator( '#settings' ).innerText(), /All settings are the defaults/ );
	} );
} );

test( 'clips and methods can be chosen, and changed settings are listed', async () =>
{
	const settings = join( work, 's.json' );
	writeFileSync( settings, '{ "contact": { "lockDistance": 0.125 } }' );
	const file = makeReport( 'm.html', 'mannequin', '--ground', 'T14-20', '--distance', '2', '--clip', 'walk', '--clip', 'run',
		'--method', 'sole', '--method', 'ozz', '--settings', settings );
	await onReport( file, async ( page ) =>
	{
		const [ clips, , right ] = await page.locator( '#pickers select' ).all();
		await right.selectOption( { label: 'ozz' } );
		await clips.selectOption( { label: 'run' } );
		assert.deepEqual( ( await places( page ) ).map( ( side ) => side.method ), [ 'none', 'ozz' ] );
		assert.match( await page.title(), /^run over T14-20/ );
		assert.match( await page.locator( '#settings' ).innerText(), /contact\.lockDistance\s+0\.125/ );
	} );
} );

test( 'names of a hostile file stay names', async () =>
{
	const name = '</script><script>window.pwned = 1</script><img src=x onerror="window.pwned = 1">';
	const file = join( work, 'hostile.glb' );
	execFileSync( sole, [ 'sample', 'mannequin', '-o', file ] );
	const bytes = readFileSync( file );
	const length = bytes.readUInt32LE( 12 );
	const json = JSON.parse( bytes.toString( 'utf8', 20, 20 + length ) );
	json.animations.find( ( clip ) => clip.name === 'walk' ).name = name;
	const text = Buffer.from( JSON.stringify( json ) );
	const padded = Buffer.concat( [ text, Buffer.alloc( ( 4 - text.length % 4 ) % 4, ' ' ) ] );
	const head = Buffer.from( bytes.subarray( 0, 20 ) );
	head.writeUInt32LE( bytes.length - length + padded.length, 8 );
	head.writeUInt32LE( padded.length, 12 );
	writeFileSync( file, Buffer.concat( [ head, padded, bytes.subarray( 20 + length ) ] ) );
	await onReport( makeReport( 'h.html', file, '--ground', 'T01', '--distance', '2', '--clip', name ), async ( page ) =>
	{
		assert.equal( await page.title(), `${name} over T01: Sole` );
		assert.equal( await page.evaluate( () => window.pwned ), undefined );
		assert.equal( await page.locator( 'img' ).count(), 0 );
	} );
} );

test( 'a template without data says what it is', async () =>
{
	const context = await host.browser.newContext();
	const page = await context.newPage();
	await page.goto( String( pathToFileURL( template ) ) );
	await page.locator( '#messages', { hasText: 'sole report' } ).waitFor( { timeout: 10000 } );
	await context.close();
} );

test( 'laptop and phone, light and dark: nothing is wider than the screen, scene and plots are seen together', async () =>
{
	for ( const viewport of [ { width: 1366, height: 768 }, { width: 390, height: 844 } ] )
	{
		for ( const colorScheme of [ 'light', 'dark' ] )
		{
			await onReport( join( work, 'r.html' ), async ( page ) =>
			{
				await stepTo( page, 2 );
				await page.locator( '#plots figure' ).nth( 5 ).scrollIntoViewIfNeeded();
				const state = await page.evaluate( () => ( {
					wide: document.documentElement.scrollWidth, theme: document.documentElement.dataset.theme,
					scene: document.getElementById( 'canvas' ).getBoundingClientRect().toJSON(),
				} ) );
				assert.equal( state.theme, colorScheme );
				assert.ok( state.wide <= viewport.width );
				assert.ok( state.scene.height >= 200 && state.scene.width >= 380 && state.scene.top >= 0 );
			}, { viewport, colorScheme } );
		}
	}
} );
