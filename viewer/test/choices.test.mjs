// SPDX-License-Identifier: MIT
// What there is to choose beyond a ground and a clip: methods beside each other, grounds that move, who gives the root
// its height, presets, and the bar of stages. Numbers, not pixels.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { openBrowser, usePage } from '../page.mjs';

let host;
before( async () => { host = await openBrowser(); } );
after( () => host?.close() );

const onPage = ( query, run ) => usePage( host, query, run, { viewport: { width: 800, height: 480 } } );
const stepTo = ( page, time ) => page.evaluate( ( t ) => window.viewer.stepTo( t ), time );
const feet = ( page ) => page.evaluate( () => window.viewer.feet() );
const figures = ( page ) => page.evaluate( () => window.viewer.figures() );
const rootOf = ( page ) => page.evaluate( () => window.viewer.root() );
const row = ( page, name ) => page.locator( '.lil-controller', { has: page.locator( `.lil-name:text-is("${name}")` ) } ).first();

function apart( a, b )
{
	return Math.hypot( a[ 0 ] - b[ 0 ], a[ 1 ] - b[ 1 ], a[ 2 ] - b[ 2 ] );
}

async function chooseGround( page, name )
{
	await page.locator( '#pick-ground' ).selectOption( name );
	await page.waitForFunction( ( wanted ) => window.viewer.shown().ground === wanted, name );
}

// ---------------------------------------------------------------------------------------------------------- methods

test( 'every method is shown beside another, its feet where it put them, its module loaded when it is asked for', async () =>
{
	await onPage( 'scene=T02&method=sole', async ( page ) =>
	{
		const loaded = () => page.evaluate( () => performance.getEntriesByType( 'resource' ).some( ( entry ) => entry.name.includes( 'sole-methods' ) ) );
		await stepTo( page, 2.5 );
		const places = [ ( await feet( page ) )[ 0 ].joints.at( -1 ) ];
		assert.equal( await loaded(), false );
		await page.locator( '#pick-beside' ).selectOption( 'sole' );
		for ( const method of [ 'homebrew', 'iksetting', 'effector', 'ozz' ] )
		{
			await page.locator( '#pick-method' ).selectOption( method );
			await page.waitForFunction( ( wanted ) => window.viewer.shown().methods.join() === `sole,${wanted}`, method );
			assert.equal( await page.locator( '#captions span' ).count(), 2 );
			await stepTo( page, 2.5 );
			for ( const foot of await feet( page ) )
			{
				assert.ok( apart( foot.joints.at( -1 ), foot.solved ) < 2e-5, `${method} ${foot.name}` );
			}
			places.push( ( await feet( page ) )[ 0 ].joints.at( -1 ) );
		}
		assert.equal( await loaded(), true );
		places.forEach( ( a, i ) => places.slice( i + 1 ).forEach( ( b ) => assert.ok( apart( a, b ) > 1e-4, `${i}` ) ) );
	} );
} );

test( 'an address names the methods, and who is not one is left out', async () =>
{
	const shown = [ [ 'ozz,magic,sole', [ 'ozz', 'sole' ] ], [ 'magic', [ 'none', 'sole' ] ] ];
	for ( const [ text, methods ] of shown )
	{
		await onPage( `scene=T01&method=${text}`, async ( page ) =>
		{
			assert.deepEqual( ( await page.evaluate( () => window.viewer.shown() ) ).methods, methods );
		} );
	}
} );

// ------------------------------------------------------------------------------------------------------------ moving

test( 'grounds move, come and go, carry who stands on them, and begin anew', async () =>
{
	await onPage( 'scene=T27-both&method=sole', async ( page ) =>
	{
		await stepTo( page, 1.5 );
		const [ x, y, z ] = await rootOf( page );
		assert.ok( apart( [ x, y, z ], [ 0, 0.5 * Math.sin( 0.75 * Math.PI ), 3 ] ) < 5e-3, `${[ x, y, z ]}` );
		for ( const foot of await figures( page ) )
		{
			assert.ok( foot.held && Math.abs( foot.gap ) < 2e-3 && foot.slide < 5e-3, JSON.stringify( foot ) );
		}
		await stepTo( page, 12.5 );
		assert.ok( Math.abs( ( await rootOf( page ) )[ 2 ] - 1 ) < 5e-3 );
		await chooseGround( page, 'T23-15' );
		await stepTo( page, 1.9 );
		assert.ok( Math.abs( ( await rootOf( page ) )[ 1 ] ) < 1e-3 );
		await stepTo( page, 3 );
		assert.ok( Math.abs( ( await rootOf( page ) )[ 1 ] - 0.15 ) < 1e-3 );
		await chooseGround( page, 'T30' );
		await stepTo( page, 1.25 );
		const heights = ( await feet( page ) ).map( ( foot ) => foot.points[ 0 ][ 1 ] - foot.points.at( -3 )[ 1 ] );
		assert.ok( heights.every( ( height ) => Math.abs( height ) > 0.03 ), `${heights}` ); // both feet lie on the slope
		await stepTo( page, 5 );
		assert.ok( Math.abs( ( await rootOf( page ) )[ 1 ] + 0.8 ) < 1e-3 );
		await stepTo( page, 12.3 );
		assert.ok( Math.abs( ( await rootOf( page ) )[ 1 ] ) < 1e-3 );
		await chooseGround( page, 'T28' );
		await stepTo( page, 0.6 );
		const turned = await feet( page );
		const heading = ( foot ) => Math.atan2( foot.points[ 9 ][ 0 ] - foot.points[ 0 ][ 0 ], foot.points[ 9 ][ 2 ] - foot.points[ 0 ][ 2 ] );
		await stepTo( page, 0.1 );
		const by = ( await feet( page ) ).map( ( foot, index ) => heading( turned[ index ] ) - heading( foot ) );
		assert.ok( Math.abs( by[ 0 ] - 0.5 * Math.PI / 4 ) < 0.1 && Math.abs( by[ 1 ] ) < 0.02, `${by}` );
	} );
} );

// ------------------------------------------------------------------------------------------------------------ height

test( 'the root keeps to the ground by what Sole tells, or stays as high as it is', async () =>
{
	await onPage( 'scene=T11-20&method=sole', async ( page ) =>
	{
		await stepTo( page, 3 );
		const under = await rootOf( page );
		for ( const [ height, near ] of [ [ 'sole', true ], [ 'none', false ] ] )
		{
			await row( page, 'automatic height' ).locator( 'select' ).selectOption( height === 'sole' ? 'what Sole tells' : 'none' );
			await stepTo( page, 0 );
			await stepTo( page, 3 );
			const off = Math.abs( ( await rootOf( page ) )[ 1 ] - under[ 1 ] );
			assert.ok( near ? off > 1e-6 && off < 0.05 : off > 0.2, `${height} ${off}` );
		}
	} );
} );

test( 'where the pelvis is left to the host, the page moves the character', async () =>
{
	await onPage( 'scene=T02&method=sole&set=pelvis.mode:1', async ( page ) =>
	{
		await stepTo( page, 2.5 );
		for ( const foot of await feet( page ) )
		{
			assert.ok( apart( foot.joints.at( -1 ), foot.solved ) < 2e-5, foot.name );
		}
	} );
} );

// --------------------------------------------------------------------------------------------------- what is told

test( 'ground that no probe meets is told by the set-up check, until it is met', async () =>
{
	await onPage( 'scene=T01&method=sole&panel=settings&set=probe.mask:2', async ( page ) =>
	{
		const unmet = async () => ( await page.evaluate( () => window.viewer.findings() ) ).filter( ( line ) => line.includes( 'no probe has met' ) ).length;
		await stepTo( page, 0.5 );
		assert.equal( await unmet(), 0 );
		await stepTo( page, 1.5 );
		assert.equal( await unmet(), 1 );
		assert.equal( await page.locator( '#tab-checks .count.bad' ).count(), 1 );
		await page.locator( '.page-tools button', { hasText: 'Reset' } ).click();
		await stepTo( page, 1.6 );
		assert.equal( await unmet(), 0 );
	} );
} );

test( 'flags are written at the foot', async () =>
{
	const cases = [ [ 'scene=T01&mode=stand&set=probe.sleep:0.2,contact.speedOn:1', 'asleep' ],
		[ 'scene=T29&set=pelvis.down:0', 'too low' ], [ 'scene=T26-50&set=pelvis.up:0,probe.stepUp:2,leg.fold:0.9', 'too high' ] ];
	for ( const [ query, flag ] of cases )
	{
		await onPage( `${query}&method=sole&show=flags`, async ( page ) =>
		{
			const seen = new Set();
			for ( let time = 0.5; time < 5 && !seen.has( flag ); time += 0.1 )
			{
				await stepTo( page, time );
				( await page.locator( '#labels span' ).allTextContents() ).forEach( ( text ) => text.split( ', ' ).forEach( ( word ) => seen.add( word ) ) );
			}
			assert.ok( seen.has( flag ), `${flag}: ${[ ...seen ]}` );
		} );
	}
} );

test( 'the presets of the ancestors are those of the files', async () =>
{
	await onPage( 'scene=T01&method=sole&panel=settings', async ( page ) =>
	{
		const presets = { 'As Homebrew Foot IK': 'homebrew', 'As IKSetting': 'iksetting', 'As And I Must Scream': 'effector', 'As the ozz sample': 'ozz' };
		for ( const [ label, name ] of Object.entries( presets ) )
		{
			const file = JSON.parse( readFileSync( new URL( `../../settings/${name}.json`, import.meta.url ) ) );
			await page.locator( '#page-settings select[aria-label=Preset]' ).selectOption( label );
			const changes = await page.evaluate( () => window.viewer.changes() );
			const wanted = Object.entries( file ).flatMap( ( [ stage, fields ] ) => Object.entries( fields ).map( ( [ field, value ] ) => [ `${stage}.${field}`, value ] ) );
			assert.ok( Object.keys( changes ).length > 8, label );
			wanted.forEach( ( [ key, value ] ) => assert.equal( changes[ key ] ?? value, value, `${label} ${key}` ) );
			assert.ok( Object.keys( changes ).every( ( key ) => wanted.some( ( [ other ] ) => other === key ) ), label );
			await stepTo( page, 0.3 );
		}
	} );
} );

// ------------------------------------------------------------------------------------------------------------ stages

test( 'the time per stage is shown as a bar, of the stages that the library runs', async () =>
{
	await onPage( 'scene=T02&method=sole', async ( page ) =>
	{
		assert.equal( await page.locator( '#stages' ).isVisible(), false );
		await page.locator( '#stage-times' ).click();
		await page.waitForFunction( () => performance.getEntriesByType( 'resource' ).some( ( entry ) => entry.name.includes( 'sole-stages' ) ) );
		await page.waitForFunction( () => { window.viewer.stepTo( window.viewer.time() + 0.5 ); return window.viewer.stageTimes().length > 0; } );
		const times = await page.evaluate( () => window.viewer.stageTimes() );
		assert.deepEqual( times.map( ( { name } ) => name ),
			[ 'gather', 'cast', 'sense', 'support', 'contact', 'foothold', 'lock', 'target', 'pelvis', 'leg and ankle', 'output' ] );
		assert.ok( times.every( ( { cost } ) => cost >= 0 ) && times.some( ( { cost } ) => cost > 0 ) );
		assert.equal( await page.locator( '#stages .bar span' ).count(), times.length );
		await page.locator( '#stage-times' ).click();
		assert.equal( await page.locator( '#stages' ).isVisible(), false );
		// What is recorded for `sole replay` is whole, whatever was measured.
		await page.locator( '#stage-times' ).click();
		assert.ok( await page.evaluate( () => window.viewer.trace( 1.5 ).length ) > 10000 );
	} );
} );
