// SPDX-License-Identifier: MIT
// Writes docs/viewer.png: the page itself, on stairs, with gizmos and settings.
// usage: node viewer/picture.mjs FILE
import { openBrowser, openPage } from './page.mjs';

const query = 'scene=T02&clip=walk&method=both&time=2.65&panel=settings' +
	'&show=placed legs,support plane,locks,footholds,targets';
const host = await openBrowser();
const { page } = await openPage( host, query, { deviceScaleFactor: 1 } );
await page.screenshot( { path: process.argv[ 2 ] ?? 'docs/viewer.png' } );
await host.close();
