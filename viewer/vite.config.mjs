// SPDX-License-Identifier: MIT
// Builds the page into a folder that works from any path: all addresses are relative.
import { defineConfig } from 'vite';

export default defineConfig( {
	base: './',
	publicDir: '../build/viewer-public',
	build: {
		outDir: '../build/viewer',
		emptyOutDir: true,
		target: 'es2022',
		// The WASM module is a file of its own, streamed by the browser.
		assetsInlineLimit: 0,
		chunkSizeWarningLimit: 900,
	},
	server: { fs: { allow: [ '..' ] } },
} );
