// SPDX-License-Identifier: MIT
// Moves a character's root over ground, knowing no more than a game would: along a way, as it is steered, or where it
// was put. Its height follows the ground as a capsule's does: steps up and down at once as far as a step may be high,
// and falls where there is nothing below. World space, metres, radians; heading 0 faces +Z, a quarter +X.

const STEP_HEIGHT = 0.45; // of leg length
const GRAVITY = 9.81; // m/s^2
const TURN_RATE = Math.PI; // rad/s
const STEER_TURN_RATE = 3.5; // rad/s
const DEEP = 20; // m: who has fallen so far begins anew

/// Height of the highest ground at a place that is not above a ceiling, or null.
export type FloorFcn = ( x: number, z: number, ceiling: number ) => number | null;

/// What gives the root its height: the ground under it, what Sole says of the ground that the body is over, or nobody.
export type HeightMode = 'ground' | 'sole' | 'none';

export type WalkMode = 'path' | 'keys' | 'stand';

/// What a player wants: a share of full speed, and where to.
export interface Steering
{
	amount: number;
	heading: number;
}

export interface Root
{
	x: number;
	y: number;
	z: number;
	heading: number;
}

function wrap( angle: number ): number
{
	return angle - 2 * Math.PI * Math.round( angle / ( 2 * Math.PI ) );
}

function turnTo( from: number, to: number, most: number ): number
{
	const away = wrap( to - from );
	return from + Math.max( -most, Math.min( most, away ) );
}

export class Walker
{
	readonly root: Root = { x: 0, y: 0, z: 0, heading: 0 };
	/// It was moved by a jump that is no motion.
	jumped = true;
	/// So fast it goes now, m/s.
	speed = 0;
	private fall = 0; // m/s
	private corner = 1;

	/// @param path corners of the way, x and z
	/// @param lane so far beside it, m; @param lead so far along it already, m
	constructor( private readonly path: [ number, number ][], private readonly floor: FloorFcn,
		private readonly legLength: number, private readonly lane = 0, private readonly lead = 0 )
	{
		this.begin();
	}

	/// At the start of the way, or as far along it as it has a lead, and never at its end.
	begin(): void
	{
		const lengths = this.path.slice( 1 ).map( ( to, i ) => Math.hypot( to[ 0 ] - this.path[ i ]![ 0 ], to[ 1 ] - this.path[ i ]![ 1 ] ) );
		let left = this.lead % Math.max( lengths.reduce( ( sum, length ) => sum + length, 0 ), 1e-3 );
		this.corner = 1;
		while ( this.corner < this.path.length - 1 && left > lengths[ this.corner - 1 ]! )
		{
			left -= lengths[ this.corner - 1 ]!;
			this.corner += 1;
		}
		const [ x, z ] = this.path[ this.corner - 1 ]!;
		const heading = this.headingTo( this.path[ this.corner ]!, x, z );
		this.put( x + left * Math.sin( heading ) + this.lane * Math.cos( heading ),
			z + left * Math.cos( heading ) - this.lane * Math.sin( heading ), heading );
	}

	/// Somewhere else, on the highest ground there.
	put( x: number, z: number, heading: number ): void
	{
		Object.assign( this.root, { x, z, heading, y: this.floor( x, z, 1e4 ) ?? this.root.y } );
		this.fall = 0;
		this.jumped = true;
	}

	/// Goes along with what it rides on: sideways; its height finds itself.
	carry( way: { x: number; z: number } | null ): void
	{
		this.root.x += way?.x ?? 0;
		this.root.z += way?.z ?? 0;
	}

	/// Dragged: goes there as a body that is pushed, its height by itself if that is wanted.
	drag( x: number, z: number ): void
	{
		this.root.x = x;
		this.root.z = z;
	}

	private headingTo( place: [ number, number ], x: number, z: number ): number
	{
		return Math.atan2( place[ 0 ] - x, place[ 1 ] - z );
	}

	private move( distance: number, heading: number ): void
	{
		this.root.x += distance * Math.sin( heading );
		this.root.z += distance * Math.cos( heading );
	}

	/// Along the way. Where the clip strides to another side than it faces, the body is turned against the way.
	private goAlong( speed: number, timeStep: number, stride: number ): void
	{
		const place = this.path[ this.corner ]!;
		const before = this.path[ this.corner - 1 ]!;
		const way = this.headingTo( place, before[ 0 ], before[ 1 ] );
		this.root.heading = turnTo( this.root.heading, way - stride, TURN_RATE * timeStep );
		this.move( speed * timeStep, this.root.heading + stride );
		const left = ( place[ 0 ] - this.root.x ) * Math.sin( way ) + ( place[ 1 ] - this.root.z ) * Math.cos( way );
		if ( left > 0 )
		{
			return;
		}
		this.corner += 1;
		if ( this.corner >= this.path.length )
		{
			this.begin();
		}
	}

	private goAsSteered( steering: Steering, speed: number, timeStep: number, stride: number ): void
	{
		if ( steering.amount > 0 )
		{
			this.root.heading = turnTo( this.root.heading, steering.heading - stride, STEER_TURN_RATE * timeStep );
		}
		this.move( steering.amount * speed * timeStep, this.root.heading + stride );
	}

	private lift( offset: number ): void
	{
		this.root.y += offset;
		this.fall = 0;
	}

	/// The height by itself.
	private settle( timeStep: number ): void
	{
		const root = this.root;
		const step = STEP_HEIGHT * this.legLength;
		const floor = this.floor( root.x, root.z, root.y + step );
		const reach = this.fall < 0 ? -this.fall * timeStep : step;
		if ( floor !== null && root.y - floor <= reach )
		{
			root.y = floor;
			this.fall = 0;
			return;
		}
		this.fall -= GRAVITY * timeStep;
		root.y += this.fall * timeStep;
		if ( this.fall * this.fall > 2 * GRAVITY * DEEP )
		{
			this.begin();
		}
	}

	/// One step of time.
	/// @param speed of the clip, m/s; @param stride the way it strides to against the way it faces
	/// @param offset how far the ground is over the root, by somebody who knows; null: looks by itself
	step( mode: WalkMode, steering: Steering, speed: number, stride: number, timeStep: number, height: HeightMode, offset: number | null ): void
	{
		const x = this.root.x;
		const z = this.root.z;
		this.jumped = false;
		if ( mode === 'path' && speed > 0 )
		{
			this.goAlong( speed, timeStep, stride );
		}
		else if ( mode === 'keys' )
		{
			this.goAsSteered( steering, speed, timeStep, stride );
		}
		if ( height !== 'none' && this.jumped === false )
		{
			height === 'sole' && offset !== null ? this.lift( offset ) : this.settle( timeStep );
		}
		this.speed = this.jumped || timeStep <= 0 ? 0 : Math.hypot( this.root.x - x, this.root.z - z ) / timeStep;
	}
}
