// SPDX-License-Identifier: MIT
// A ground: its triangles in the world, in pieces where some of them move, how it looks, and the way over it.
import * as THREE from 'three';
import type { Sample } from './files';
import type { GroundPart } from './ground-handle';
import { isThere, PieceMotion, type SamplePiece } from './motion';
import { onTheme } from './page';

const EDGE = 0.7; // m: a way that nobody has laid stays so far inside
const LONGEST = 24; // m

/// Positions and indices of all meshes below an object, in its world.
export function collectTriangles( object: THREE.Object3D ): { positions: Float32Array; indices: Uint32Array }
{
	object.updateMatrixWorld( true );
	const positions: number[] = [];
	const indices: number[] = [];
	const p = new THREE.Vector3();
	object.traverse( ( node ) =>
	{
		const mesh = node as THREE.Mesh;
		const place = mesh.isMesh === true ? mesh.geometry.getAttribute( 'position' ) : undefined;
		if ( place === undefined )
		{
			return;
		}
		const first = positions.length / 3;
		for ( let i = 0; i < place.count; ++i )
		{
			p.fromBufferAttribute( place, i ).applyMatrix4( mesh.matrixWorld );
			positions.push( p.x, p.y, p.z );
		}
		const index = mesh.geometry.getIndex();
		const flipped = mesh.matrixWorld.determinant() < 0;
		const count = ( index?.count ?? place.count ) - 2;
		for ( let i = 0; i < count; i += 3 )
		{
			const corner = [ 0, 1, 2 ].map( ( k ) => first + ( index?.getX( i + k ) ?? i + k ) );
			indices.push( corner[ 0 ]!, corner[ flipped ? 2 : 1 ]!, corner[ flipped ? 1 : 2 ]! );
		}
	} );
	return { positions: new Float32Array( positions ), indices: new Uint32Array( indices ) };
}

/// Lines every 10 cm and, stronger, every metre, on faces of all directions: heights and slopes can be read off. They
/// move with their piece.
const gridVertex = '#include <project_vertex>\n\tsolePlace = transformed;\n\tsoleNormal = normalize( objectNormal );';
const gridFragment = `#include <color_fragment>
	{
		vec3 wide = fwidth( solePlace );
		vec3 small = abs( fract( solePlace * 10.0 - 0.5 ) - 0.5 ) / max( wide * 10.0, vec3( 1e-5 ) );
		vec3 large = abs( fract( solePlace - 0.5 ) - 0.5 ) / max( wide, vec3( 1e-5 ) );
		vec3 facing = step( vec3( 0.6 ), abs( soleNormal ) );
		vec3 away = mix( vec3( 0.0 ), vec3( 1e3 ), facing );
		small += away;
		large += away;
		float fine = 1.0 - min( min( small.x, min( small.y, small.z ) ), 1.0 );
		float coarse = 1.0 - min( min( large.x, min( large.y, large.z ) ), 1.0 );
		float near = 1.0 - smoothstep( 0.01, 0.05, max( wide.x, max( wide.y, wide.z ) ) );
		diffuseColor.rgb *= 1.0 - 0.10 * fine * near - 0.22 * coarse;
	}`;

function makeMaterial(): THREE.MeshStandardMaterial
{
	const material = new THREE.MeshStandardMaterial( { roughness: 0.95, side: THREE.DoubleSide, flatShading: true } );
	material.onBeforeCompile = ( shader ) =>
	{
		const head = 'varying vec3 solePlace;\nvarying vec3 soleNormal;\n';
		shader.vertexShader = head + shader.vertexShader.replace( '#include <project_vertex>', gridVertex );
		shader.fragmentShader = head + shader.fragmentShader.replace( '#include <color_fragment>', gridFragment );
	};
	onTheme( ( theme ) => material.color.set( theme === 'dark' ? 0x6d7683 : 0xc9ccd2 ) );
	return material;
}

const material = makeMaterial();
const edgeMaterial = new THREE.LineBasicMaterial( { transparent: true, opacity: 0.4 } );
onTheme( ( theme ) => edgeMaterial.color.set( theme === 'dark' ? 0xd5dbe4 : 0x3a424e ) );
const EDGE_ANGLE = 25; // degrees between faces
const MOST_EDGED = 12000; // triangles: more are terrain, whose edges are no steps

/// A straight way along the longer side of a ground.
function findWay( box: THREE.Box3 ): [ number, number ][]
{
	const size = box.getSize( new THREE.Vector3() );
	const middle = box.getCenter( new THREE.Vector3() );
	const half = 0.5 * Math.min( Math.max( Math.max( size.x, size.z ) - 2 * EDGE, 0.2 ), LONGEST );
	return size.z >= size.x ? [ [ middle.x, middle.z - half ], [ middle.x, middle.z + half ] ]
		: [ [ middle.x - half, middle.z ], [ middle.x + half, middle.z ] ];
}

const UNSEEN = 2; // layer of what carries roots alone

/// A piece as it is seen.
interface SeenPiece
{
	piece: SamplePiece;
	mesh: THREE.Mesh;
	motion: PieceMotion | null;
}

function takePiece( { firstTriangle = 0, triangles = 0, indices }: SamplePiece, ofFile: Uint32Array ): Uint32Array
{
	return indices !== undefined ? Uint32Array.from( indices ) : ofFile.slice( 3 * firstTriangle, 3 * ( firstTriangle + triangles ) );
}

export class GroundShape
{
	readonly group = new THREE.Group();
	readonly parts: readonly GroundPart[];
	readonly path: [ number, number ][];
	readonly box = new THREE.Box3();
	/// s, after which the scene begins anew; null: nothing in it moves.
	readonly duration: number | null;
	/// Files are wound as their makers cared, samples as they should be.
	readonly twoSided: boolean;
	private readonly seen: SeenPiece[];

	/// @param sample what is known of it beyond its triangles
	constructor( readonly name: string, object: THREE.Object3D, sample?: Sample )
	{
		const { positions, indices } = collectTriangles( object );
		if ( indices.length === 0 )
		{
			throw new Error( `${name}: has neither a skinned character nor triangles to walk on.` );
		}
		this.twoSided = sample === undefined;
		this.duration = sample?.duration ?? null;
		const whole: SamplePiece = { firstTriangle: 0, triangles: indices.length / 3, layer: 1, surface: -1 };
		const place = new THREE.BufferAttribute( positions, 3 );
		this.parts = ( sample?.pieces ?? [ whole ] ).map( ( piece ) => ( { positions, piece,
			indices: takePiece( piece, indices ) } ) );
		this.seen = this.parts.map( ( part ) => this.makeSeen( part, place ) );
		this.group.add( ...this.seen.map( ( { mesh } ) => mesh ) );
		this.box.setFromBufferAttribute( place );
		const path = sample?.path;
		this.path = path !== undefined && path.length > 1 ? path : findWay( this.box );
		this.move( 0 );
	}

	private makeSeen( { indices, piece }: GroundPart, place: THREE.BufferAttribute ): SeenPiece
	{
		const geometry = new THREE.BufferGeometry();
		geometry.setAttribute( 'position', place );
		geometry.setIndex( new THREE.BufferAttribute( indices, 1 ) );
		geometry.computeVertexNormals();
		const mesh = new THREE.Mesh( geometry, material );
		mesh.receiveShadow = true;
		mesh.castShadow = piece.keys !== undefined;
		if ( indices.length < 3 * MOST_EDGED )
		{
			mesh.add( new THREE.LineSegments( new THREE.EdgesGeometry( geometry, EDGE_ANGLE ), edgeMaterial ) );
		}
		return { piece, mesh, motion: piece.keys !== undefined ? new PieceMotion( piece.keys ) : null };
	}

	/// To how it is at a time of the scene.
	move( time: number ): void
	{
		for ( const { piece, mesh, motion } of this.seen )
		{
			mesh.visible = piece.layer !== UNSEEN && isThere( piece, time );
			motion?.read( time, mesh.position, mesh.quaternion );
		}
	}

	/// The place of the ground under a ray of the page.
	pick( caster: THREE.Raycaster ): THREE.Vector3 | null
	{
		const meshes = this.seen.map( ( { mesh } ) => mesh ).filter( ( mesh ) => mesh.visible );
		return caster.intersectObjects( meshes, false )[ 0 ]?.point ?? null;
	}

	dispose(): void
	{
		this.group.removeFromParent();
		this.seen.forEach( ( { mesh } ) =>
		{
			mesh.geometry.dispose();
			mesh.children.forEach( ( edges ) => ( edges as THREE.LineSegments ).geometry.dispose() );
		} );
	}
}
