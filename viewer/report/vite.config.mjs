// SPDX-License-Identifier: MIT
// Builds the page of a report into one file, for it is opened without a server: script and styles are put into it.
import { defineConfig } from 'vite';

/// A script element ends at the first "</script", wherever it stands; in JavaScript text it may be written otherwise.
function quote( code )
{
	return code.replaceAll( '</script', '<\\/script' ).replaceAll( '<!--', '<\\!--' );
}

const intoOneFile = {
	name: 'into-one-file',
	enforce: 'post',
	generateBundle( _, bundle )
	{
		const page = bundle[ 'template.html' ];
		const others = Object.values( bundle ).filter( ( part ) => part !== page );
		const styles = others.filter( ( part ) => part.fileName.endsWith( '.css' ) ).map( ( part ) => `<style>${part.source}</style>` );
		const scripts = others.filter( ( part ) => part.type === 'chunk' ).map( ( part ) => `<script type="module">${quote( part.code )}</script>` );
		if ( scripts.length !== 1 || others.length > 2 )
		{
			throw new Error( `a report is one script and one style sheet, not ${others.map( ( part ) => part.fileName ).join( ', ' )}` );
		}
		page.source = page.source.replace( /<script type="module"[^>]*src=.*?<\/script>\s*|<link rel="(stylesheet|modulepreload)".*?>\s*/g, '' )
			.replace( '</head>', () => `${styles.join( '' )}</head>` ).replace( '</body>', () => `${scripts.join( '' )}\n</body>` );
		others.forEach( ( part ) => { delete bundle[ part.fileName ]; } );
	},
};

export default defineConfig( {
	base: './',
	publicDir: false,
	plugins: [ intoOneFile ],
	build: {
		outDir: '../../build/report',
		emptyOutDir: true,
		target: 'es2022',
		modulePreload: false,
		chunkSizeWarningLimit: 900,
		rollupOptions: { input: new URL( './template.html', import.meta.url ).pathname },
	},
} );
