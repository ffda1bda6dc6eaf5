// SPDX-License-Identifier: MIT
// A ground as the library casts at it: one that stands still, or pieces that move. World space, metres.
import * as THREE from 'three';
import type { Ground, Pieces, Sole } from '../../build/wasm/sole.js';
import { isThere, PieceMotion, type SamplePiece } from './motion';

/// Whoever makes grounds: a module of the library.
export type GroundMaker = Pick<Sole, 'createGround' | 'createPieces'>;

/// A part of a ground that moves as a whole, or stands still.
export interface GroundPart
{
	positions: Float32Array;
	indices: Uint32Array;
	piece: SamplePiece;
}

const HIGHEST = 1e3; // m: places are looked for from there
const DEEPEST = 2e3;
const RIDDEN = 0.15; // m: who is no higher over a piece rides it
const MOMENT = 1 / 240; // s, over which speeds are found

/// A piece that moves, and where it is.
interface Mover
{
	index: number;
	piece: SamplePiece;
	motion: PieceMotion;
	place: THREE.Vector3;
	turn: THREE.Quaternion;
	before: THREE.Vector3;
}

export class GroundHandle
{
	/// What answers a character's questions.
	readonly answers: Ground | Pieces;
	/// Bodies that feet may stand on and that move.
	supports: { surface: number; translation: number[]; rotation: number[] }[] = [];
	private readonly grounds: Ground[];
	private readonly pieces: Pieces | null;
	private readonly movers: Mover[];
	private readonly coming: { index: number; piece: SamplePiece }[];

	/// @param twoSided for files: their triangles are wound as their makers cared
	constructor( maker: GroundMaker, parts: readonly GroundPart[], twoSided: boolean )
	{
		this.grounds = parts.map( ( { positions, indices, piece } ) =>
			maker.createGround( { meshes: [ { positions, indices, twoSided, layer: piece.layer } ] } ) );
		this.pieces = parts.length > 1 ? maker.createPieces( parts.map( ( { piece }, index ) =>
			( { ground: this.grounds[ index ]!, surface: piece.surface } ) ) ) : null;
		this.answers = this.pieces ?? this.grounds[ 0 ]!;
		const listed = parts.map( ( { piece }, index ) => ( { index, piece } ) );
		this.coming = listed.filter( ( { piece } ) => piece.from !== undefined || piece.until !== undefined );
		this.movers = listed.filter( ( { piece } ) => piece.keys !== undefined ).map( ( { index, piece } ) => ( {
			index, piece, motion: new PieceMotion( piece.keys! ), place: new THREE.Vector3(), turn: new THREE.Quaternion(),
			before: new THREE.Vector3() } ) );
		this.move( 0 );
	}

	/// All pieces to where they are at a time of the scene.
	move( time: number ): void
	{
		this.coming.forEach( ( { index, piece } ) => this.pieces?.move( index, { there: isThere( piece, time ) } ) );
		for ( const mover of this.movers )
		{
			mover.before.copy( mover.place );
			this.moveOne( mover, time );
		}
		this.supports = this.movers.filter( ( { piece } ) => isThere( piece, time ) ).map( ( { piece, place, turn } ) =>
			( { surface: piece.surface, translation: place.toArray(), rotation: turn.toArray() } ) );
	}

	private moveOne( { index, motion, place, turn }: Mover, time: number ): void
	{
		const [ early, late ] = [ new THREE.Vector3(), new THREE.Vector3() ];
		const [ from, to ] = [ new THREE.Quaternion(), new THREE.Quaternion() ];
		motion.read( time - MOMENT, early, from );
		motion.read( time + MOMENT, late, to );
		motion.read( time, place, turn );
		const turned = to.multiply( from.invert() );
		const rate = ( turned.w < 0 ? -1 : 1 ) / MOMENT; // twice the half angle, over two moments
		this.pieces?.move( index, { translation: place, rotation: turn, velocity: late.sub( early ).multiplyScalar( 0.5 / MOMENT ),
			spin: [ turned.x * rate, turned.y * rate, turned.z * rate ] } );
	}

	private look( x: number, z: number, top: number, length: number, mask: number ): ReturnType<Ground[ 'cast' ]>
	{
		return this.answers.cast( { start: [ x, top, z ], direction: [ 0, -1, 0 ], length, mask } );
	}

	/// The highest ground at a place that is not above a ceiling.
	findFloor( x: number, z: number, ceiling: number, mask: number ): number | null
	{
		return this.look( x, z, Math.min( ceiling, HIGHEST ), DEEPEST, mask )?.point[ 1 ] ?? null;
	}

	/// How fast what is under a place moves, m/s.
	findVelocity( x: number, z: number, ceiling: number, mask: number ): number[]
	{
		const still = [ 0, 0, 0 ];
		return this.movers.length > 0 ? this.look( x, z, ceiling, DEEPEST, mask )?.velocity ?? still : still;
	}

	/// The surface of what a root rides on, or -1.
	findRidden( root: { x: number; y: number; z: number }, mask: number ): number
	{
		return this.movers.length > 0 ? this.look( root.x, root.z, root.y + RIDDEN, 2 * RIDDEN, mask )?.surface ?? -1 : -1;
	}

	/// How far who rides a surface was carried by the last move. A piece that turns carries nobody's root.
	findCarried( surface: number ): THREE.Vector3 | null
	{
		const mover = this.movers.find( ( { piece, motion } ) => piece.surface === surface && motion.turns === false );
		return mover === undefined ? null : mover.place.clone().sub( mover.before );
	}

	dispose(): void
	{
		this.pieces?.dispose();
		this.grounds.forEach( ( ground ) => ground.dispose() );
	}
}
