// SPDX-License-Identifier: MIT
// How the pieces of a ground move: keys that the program has sampled from its scenes. World space, metres, seconds;
// a place and a turn take a piece from where its triangles are to where it is.
import * as THREE from 'three';

export interface PieceKeys
{
	rate: number; // a second
	places: number[]; // 3 a key
	turns?: number[]; // x y z w a key; none: it never turns
}

/// As `sole sample --list --json` tells it.
export interface SamplePiece
{
	/// Of the file; or its own indices into the file's vertices, where it is not seen at the start.
	firstTriangle?: number;
	triangles?: number;
	indices?: number[];
	layer: number;
	surface: number;
	/// There from then on, and until then.
	from?: number;
	until?: number;
	keys?: PieceKeys;
}

/// Layers of pieces: what carries roots, and what carries feet.
export const ROOT_LAYERS = 1 | 2;
export const FEET_LAYERS = 1 | 4;

export function isThere( piece: SamplePiece, time: number ): boolean
{
	return time >= ( piece.from ?? 0 ) && time < ( piece.until ?? Infinity );
}

/// Between its keys; before the first and after the last it stands still.
export class PieceMotion
{
	private readonly nextTurn = new THREE.Quaternion();

	constructor( private readonly keys: PieceKeys )
	{
	}

	get turns(): boolean
	{
		return this.keys.turns !== undefined;
	}

	read( time: number, place: THREE.Vector3, turn: THREE.Quaternion ): void
	{
		const { rate, places, turns } = this.keys;
		const last = places.length / 3 - 1;
		const at = Math.min( Math.max( time * rate, 0 ), last );
		const first = Math.min( Math.floor( at ), last - 1 );
		const share = at - first;
		const mix = ( k: number ): number => places[ 3 * first + k ]! * ( 1 - share ) + places[ 3 * first + 3 + k ]! * share;
		place.set( mix( 0 ), mix( 1 ), mix( 2 ) );
		turn.identity();
		if ( turns !== undefined )
		{
			turn.fromArray( turns, 4 * first ).slerp( this.nextTurn.fromArray( turns, 4 * first + 4 ), share );
		}
	}
}
