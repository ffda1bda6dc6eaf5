// SPDX-License-Identifier: MIT
// The other methods as the page shows them: their own settings, under the names of the originals, and what their frames
// show of themselves. And what a frame of the page costs.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { openBrowser, usePage } from '../page.mjs';

const SOLVER_BUDGET = 0.2; // ms a character
const MOST_CALLS = 60;
const changed = { homebrew: [ 'smoothTime', 0.01 ], iksetting: [ 'pelvisUpAndDownSpeed', 0.01 ], effector: [ 'footAdjustment', 8 ], ozz: [ 'footHeight', 0.01 ] };

let host;
before( async () => { host = await openBrowser(); } );
after( () => host?.close() );

const onPage = ( query, run ) => usePage( host, query, run, { viewport: { width: 1000, height: 640 } } );
const stepTo = ( page, time ) => page.evaluate( ( t ) => window.viewer.stepTo( t ), time );
const ankles = ( page ) => page.evaluate( () => window.viewer.feet().map( ( foot ) => foot.joints.at( -1 ) ) );
const changes = ( page ) => page.evaluate( () => window.viewer.changes() );
const open = ( page ) => page.locator( '#page-settings .settings:not( [hidden] )' );
const row = ( page, name ) => open( page ).locator( '.lil-controller', { has: page.locator( `.lil-name:text-is("${name}")` ) } ).first();

async function setRow( page, name, value )
{
	await row( page, name ).locator( 'input' ).fill( value );
	await row( page, name ).locator( 'input' ).press( 'Enter' );
	await page.locator( '#canvas' ).focus();
}

test( 'every method has its own settings, which say what they are and change its feet', async () =>
{
	for ( const [ method, [ name, value ] ] of Object.entries( changed ) )
	{
		await onPage( `scene=T02&mode=${method === 'effector' ? 'stand' : 'path'}&method=${method}&panel=settings`, async ( page ) =>
		{
			await page.locator( '.whose select' ).selectOption( method );
			const rows = await open( page ).locator( '.lil-controller' ).count();
			assert.ok( rows >= 10, `${rows}` );
			const words = await open( page ).locator( '.lil-controller' ).evaluateAll( ( elements ) => elements.map( ( element ) =>
			{
				element.dispatchEvent( new FocusEvent( 'focusin' ) );
				const card = element.closest( '.settings' ).querySelector( '.card' );
				return [ card.querySelector( 'p' ).textContent, card.querySelector( 'svg' ).children.length, card.querySelectorAll( 'dd' ).length ];
			} ) );
			assert.equal( new Set( words.map( ( [ text ] ) => text ) ).size, rows );
			words.forEach( ( [ text, drawn, facts ] ) => assert.ok( text.endsWith( '.' ) && drawn > 0 && facts === 4, text ) );
			await stepTo( page, 2 );
			const before = await ankles( page );
			await setRow( page, name, String( value ) );
			await stepTo( page, 0 );
			await stepTo( page, 2 );
			assert.notDeepEqual( await ankles( page ), before, method );
			assert.deepEqual( await changes( page ), { [ `${method}.${name}` ]: value } );
			assert.equal( await page.locator( '#tab-settings .count' ).textContent(), '1' );
			await page.keyboard.press( 'Control+z' );
			assert.deepEqual( await changes( page ), {} );
			await stepTo( page, 0 );
			await stepTo( page, 2 );
			assert.deepEqual( await ankles( page ), before, method );
		} );
	}
} );

test( 'settings of a method are in links and files, and leave Sole\'s alone', async () =>
{
	await onPage( 'scene=T02&method=ozz,sole&panel=settings&set=ozz.footHeight:0.2,leg.reach:0.9', async ( page ) =>
	{
		assert.deepEqual( await changes( page ), { 'ozz.footHeight': 0.2, 'leg.reach': 0.9 } );
		await page.locator( '.whose select' ).selectOption( 'ozz' );
		const [ download ] = await Promise.all( [ page.waitForEvent( 'download' ), open( page ).locator( 'button', { hasText: 'Save' } ).click() ] );
		const file = await download.path();
		assert.equal( JSON.parse( readFileSync( file, 'utf8' ) ).ozz.footHeight, 0.2 );
		await open( page ).locator( 'button', { hasText: 'Reset' } ).click();
		assert.deepEqual( await changes( page ), { 'leg.reach': 0.9 } );
		const load = ( text ) => open( page ).locator( 'input[type=file]' ).setInputFiles( { name: 'own.json', mimeType: 'application/json', buffer: Buffer.from( text ) } );
		await load( readFileSync( file, 'utf8' ) );
		await page.waitForFunction( () => window.viewer.changes()[ 'ozz.footHeight' ] === 0.2 );
		await load( '{"ozz": {"magic": 1}}' );
		await page.locator( '#messages p', { hasText: 'ozz.magic: is no setting' } ).waitFor();
		assert.deepEqual( await changes( page ), { 'ozz.footHeight': 0.2, 'leg.reach': 0.9 } );
		await page.locator( '#pick-beside' ).selectOption( 'none' );
		assert.equal( await page.locator( '.whose' ).isVisible(), false );
	} );
} );

test( 'every method shows its frames in its own view', async () =>
{
	for ( const method of Object.keys( changed ) )
	{
		await onPage( `scene=T02&method=${method},sole&show=flags`, async ( page ) =>
		{
			await stepTo( page, 1.5 );
			const places = await page.locator( '#labels span:not( [hidden] )' ).evaluateAll( ( spans ) => spans.map( ( span ) => span.getBoundingClientRect().toJSON() ) );
			const middle = await page.locator( '#canvas' ).evaluate( ( canvas ) => canvas.clientWidth / 2 );
			assert.equal( places.length, 4, method );
			places.forEach( ( a, i ) => places.slice( i + 1 ).forEach( ( b ) =>
				assert.ok( a.right <= b.left || b.right <= a.left || a.bottom <= b.top || b.bottom <= a.top, `${method}: labels lie on each other` ) ) );
			places.forEach( ( { left, right }, index ) => assert.ok( index < 2 ? right <= middle : left >= middle, `${method} ${left} ${right}` ) );
		} );
	}
} );

test( 'a frame costs little script, and few draw calls', async () =>
{
	const cases = [ [ 'one character', 'scene=T02&method=sole' ], [ 'all gizmos', 'scene=T02&method=sole&show=all' ] ];
	for ( const [ what, query ] of cases )
	{
		await onPage( query, async ( page ) =>
		{
			// The quickest of some rounds: what else the machine does is no cost of the page.
			const rounds = await page.evaluate( () => Array.from( { length: 10 }, () => window.viewer.load( 60 ) ) );
			const { calls, triangles } = rounds[ 0 ];
			const [ script, solver ] = [ 'script', 'solver' ].map( ( name ) => Math.min( ...rounds.map( ( round ) => round[ name ] ) ) );
			console.log( `${what}: ${script.toFixed( 2 )} ms of script a frame, ${solver.toFixed( 3 )} of it Sole; ${calls} draw calls, ${triangles} triangles` );
			assert.ok( solver > 0 && solver < SOLVER_BUDGET, `${what} ${solver}` );
			assert.ok( script < 16.7, `${what} ${script}` );
			assert.ok( calls > 0 && calls < MOST_CALLS, `${what} ${calls}` );
		} );
	}
} );

test( 'two hundred cost Sole no more each than one', async () =>
{
	await onPage( 'scene=flat&method=sole', async ( page ) =>
	{
		const controller = page.locator( '.lil-controller', { has: page.locator( '.lil-name:text-is("characters")' ) } );
		await controller.locator( 'input' ).fill( '200' );
		await controller.locator( 'input' ).press( 'Enter' );
		await page.locator( '#canvas' ).focus();
		await page.waitForFunction( () => window.viewer.shown().characters === 200 );
		const rounds = await page.evaluate( () => Array.from( { length: 4 }, () => window.viewer.load( 5 ) ) );
		const [ script, solver ] = [ 'script', 'solver' ].map( ( name ) => Math.min( ...rounds.map( ( round ) => round[ name ] ) ) );
		console.log( `two hundred: ${script.toFixed( 1 )} ms of script a frame, ${solver.toFixed( 3 )} of it Sole for each; ${rounds[ 0 ].calls} draw calls` );
		assert.ok( solver > 0 && solver < SOLVER_BUDGET, `${solver}` );
		assert.ok( rounds[ 0 ].calls <= 3 * 200 + MOST_CALLS, `${rounds[ 0 ].calls}` );
	} );
} );
