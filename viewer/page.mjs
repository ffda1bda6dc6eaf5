// SPDX-License-Identifier: MIT
// The built page in a real browser, for tests and for pictures: a server of its folder below an odd path, and Chromium
// with one choice of how it draws, so that pictures are the same every time.
import assert from 'node:assert/strict';
import { createReadStream } from 'node:fs';
import { stat } from 'node:fs/promises';
import { createServer } from 'node:http';
import { extname, join, normalize } from 'node:path';
import { fileURLToPath } from 'node:url';
import { chromium } from 'playwright-core';

export const folder = fileURLToPath( new URL( '../build/viewer/', import.meta.url ) );
const PREFIX = '/some/where/';
const types = { '.html': 'text/html', '.js': 'text/javascript', '.css': 'text/css', '.json': 'application/json',
	'.wasm': 'application/wasm', '.glb': 'model/gltf-binary' };
const args = [ '--no-sandbox', '--disable-quic', '--no-first-run', '--disable-background-networking',
	'--disable-component-update', '--disable-sync', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader' ];

async function answer( request, response )
{
	const path = normalize( decodeURIComponent( new URL( request.url, 'http://here' ).pathname ) );
	const file = join( folder, path.slice( PREFIX.length ) || 'index.html' );
	const there = path.startsWith( PREFIX ) && ( await stat( file ).catch( () => null ) )?.isFile();
	if ( !there )
	{
		response.writeHead( 404 ).end();
		return;
	}
	response.writeHead( 200, { 'content-type': types[ extname( file ) ] ?? 'application/octet-stream' } );
	createReadStream( file ).pipe( response );
}

/// A browser and a server, until they are closed.
export async function openBrowser()
{
	const server = createServer( ( request, response ) => void answer( request, response ) );
	await new Promise( ( done ) => server.listen( 0, '127.0.0.1', done ) );
	const browser = await chromium.launch( { executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium', args } );
	return {
		browser,
		address: `http://127.0.0.1:${server.address().port}${PREFIX}`,
		async close()
		{
			await browser.close();
			server.close();
		},
	};
}

/// The page at an address, when it is ready. What it says on its console as an error ends up in `errors`, what it asks
/// for in `requests`.
export async function openAt( host, address, options = {} )
{
	const context = await host.browser.newContext( { viewport: { width: 1366, height: 768 }, colorScheme: 'light', ...options } );
	const page = await context.newPage();
	const errors = [];
	const requests = [];
	page.on( 'console', ( message ) => { if ( message.type() === 'error' ) { errors.push( message.text() ); } } );
	page.on( 'pageerror', ( error ) => errors.push( String( error ) ) );
	page.on( 'request', ( request ) => requests.push( request.url() ) );
	await page.goto( address );
	await page.waitForSelector( 'html[data-ready]', { state: 'attached', timeout: 20000 } ).catch( async ( error ) =>
	{
		throw new Error( `${error.message}\n${await page.locator( '#messages' ).innerText()}\n${errors.join( '\n' )}` );
	} );
	return { page, errors, requests, close: () => context.close() };
}

/// The viewer.
export function openPage( host, query, options )
{
	return openAt( host, `${host.address}?${query}`, options );
}

/// A page for one test, which ends without errors. Small, for pictures are drawn without a graphics card.
export async function useAt( host, address, run, options )
{
	const opened = await openAt( host, address, { viewport: { width: 900, height: 560 }, ...options } );
	try
	{
		await run( opened.page, opened.requests );
		assert.deepEqual( opened.errors, [] );
	}
	finally
	{
		await opened.close();
	}
}

export function usePage( host, query, run, options )
{
	return useAt( host, `${host.address}?manual=1&${query}`, run, options );
}
