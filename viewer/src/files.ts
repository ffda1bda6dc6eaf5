// SPDX-License-Identifier: MIT
// Samples and the user's files: what there is, and three's objects of it. What is wrong with a file is said in a
// sentence that names it.
import * as THREE from 'three';
import { GLTFLoader, type GLTF } from 'three/addons/loaders/GLTFLoader.js';
import { OBJLoader } from 'three/addons/loaders/OBJLoader.js';
import type { SamplePiece } from './motion';
import { messageOf } from './page';

/// As `sole sample --list --json` tells it.
export interface Sample
{
	name: string;
	kind: 'character' | 'ground';
	text: string;
	triangles?: number;
	/// The first is the still world; the file has all of them where they are at the start.
	pieces?: SamplePiece[];
	/// s, after which a scene that moves begins anew
	duration?: number;
	path?: [ number, number ][];
}

const folder = 'samples';

async function fetchGood( address: string ): Promise<Response>
{
	const response = await fetch( address );
	if ( response.ok === false )
	{
		throw new Error( `${address}: not there (${response.status})` );
	}
	return response;
}

export async function listSamples(): Promise<Sample[]>
{
	return await ( await fetchGood( `${folder}/samples.json` ) ).json() as Sample[];
}

export async function fetchSample( name: string ): Promise<ArrayBuffer>
{
	return await ( await fetchGood( `${folder}/${name}.glb` ) ).arrayBuffer();
}

/// @param name for messages
export async function parseGlb( name: string, bytes: ArrayBuffer ): Promise<GLTF>
{
	const head = new TextDecoder().decode( bytes.slice( 0, 4 ) );
	if ( head !== 'glTF' && head.trimStart().startsWith( '{' ) === false )
	{
		throw new Error( `${name}: is no GLB file: it does not begin with "glTF". Export it as glTF binary.` );
	}
	try
	{
		return await new GLTFLoader().parseAsync( bytes, '' );
	}
	catch ( error )
	{
		const why = messageOf( error ).replace( /^THREE\.GLTFLoader: /, '' ).replace( /\.+$/, '' );
		throw new Error( /draco|meshopt|ktx2/i.test( why ) ? `${name}: its meshes are compressed. Export it anew, without compression.`
			: `${name}: can't be read: ${why}. Export it anew.` );
	}
}

function parseObj( name: string, bytes: ArrayBuffer ): THREE.Object3D
{
	const group = new OBJLoader().parse( new TextDecoder().decode( bytes ) );
	if ( group.children.length === 0 )
	{
		throw new Error( `${name}: has no faces: is it an OBJ file?` );
	}
	return group;
}

/// A file of the user as what it is: a character if it has a skin and is not asked for as ground.
export type Opened = { kind: 'character'; name: string; gltf: GLTF } | { kind: 'ground'; name: string; object: THREE.Object3D };

export async function openFile( file: File ): Promise<Opened>
{
	const name = file.name;
	const bytes = await file.arrayBuffer();
	if ( /\.obj$/i.test( name ) )
	{
		return { kind: 'ground', name, object: parseObj( name, bytes ) };
	}
	if ( /\.(glb|gltf|vrm)$/i.test( name ) === false )
	{
		throw new Error( `${name}: is neither GLB nor OBJ.` );
	}
	const gltf = await parseGlb( name, bytes );
	let skinned = false;
	gltf.scene.traverse( ( node ) => { skinned ||= ( node as THREE.SkinnedMesh ).isSkinnedMesh === true; } );
	return skinned ? { kind: 'character', name, gltf } : { kind: 'ground', name, object: gltf.scene };
}
