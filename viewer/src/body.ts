// SPDX-License-Identifier: MIT
// One body in the scene: a character with a method that places its feet, or leaves them.
import * as THREE from 'three';
import { POSE_FLOATS, type CharacterInstance, type CharacterModel } from './character';
import type { ClipFacts } from './clip';
import type { GroundHandle } from './ground-handle';
import { Listener, PLANTED, Placer, type BodyTold, type FootPlacer, type Frame, type RigHandle, type SettingValues, type Shape, type SettingsHandle } from './library';
import { MethodPlacer, type MethodName, type MethodWorld } from './methods';
import { FEET_LAYERS } from './motion';
import type { FootFigures } from './plots';
import type { FloorFcn } from './walker';

export type Method = 'none' | 'sole' | MethodName;

/// What a body needs to know of its surroundings.
export interface World
{
	rig: RigHandle;
	ground: GroundHandle;
	/// Where one of the methods is an ancestor.
	methods: MethodWorld | null;
	settings: SettingsHandle;
	floor: FloorFcn;
	weight: number;
}

/// One leg as the picture has it, and where the library put it. World.
export interface FootReport
{
	name: string;
	joints: number[][]; // hip to ankle
	points: number[][]; // of the sole
	/// Where the ankle is by the library; null where no feet are placed.
	solved: number[] | null;
}

function makePlacer( method: Method, { rig, settings, methods }: World ): FootPlacer | null
{
	if ( method === 'sole' )
	{
		return new Placer( rig, settings );
	}
	return method === 'none' || methods === null ? null : new MethodPlacer( methods, method, new Listener( rig ) );
}

const NEAR_GROUND = 0.02; // m: an unlabelled foot that is lower stands

const SIDEWAYS = [ 0.005, 0.01, 0.02, 0.04 ]; // m

interface SolePoint
{
	place: THREE.Vector3;
	before: THREE.Vector3;
}

export class Body
{
	readonly pose: Float32Array;
	private readonly placer: FootPlacer | null;
	private readonly points: SolePoint[][];
	private readonly joint = new THREE.Vector3();

	constructor( model: CharacterModel, readonly instance: CharacterInstance, readonly method: Method, private readonly world: World )
	{
		this.pose = new Float32Array( POSE_FLOATS * model.jointCount );
		this.placer = makePlacer( method, world );
		this.points = world.rig.solePoints.map( ( leg ) => leg.map( () => ( { place: new THREE.Vector3(), before: new THREE.Vector3() } ) ) );
	}

	/// One frame: the clip's pose in, the placed pose out, and into the joints.
	step( facts: ClipFacts, clipTime: number, frame: Frame ): void
	{
		facts.sample( this.instance, clipTime, this.pose );
		this.placer?.place( this.pose, frame, this.world.ground );
		this.instance.applyPose( this.pose );
		const root = this.instance.root;
		root.matrix.compose( new THREE.Vector3().fromArray( frame.root ), new THREE.Quaternion().fromArray( frame.root, 3 ),
			new THREE.Vector3().fromArray( frame.root, 7 ) );
		const offset = this.told?.rootOffset ?? [ 0, 0, 0 ];
		root.matrix.premultiply( new THREE.Matrix4().makeTranslation( offset[ 0 ]!, offset[ 1 ]!, offset[ 2 ]! ) );
		root.updateMatrixWorld( true );
		this.findPoints( frame.teleport );
	}

	private findPoints( jumped: boolean ): void
	{
		this.world.rig.solePoints.forEach( ( leg, index ) => leg.forEach( ( point, k ) =>
		{
			const at = this.points[ index ]![ k ]!;
			at.before.copy( at.place );
			at.place.fromArray( point.place ).applyMatrix4( this.instance.joints[ point.joint ]!.matrixWorld );
			at.before.copy( jumped ? at.place : at.before );
		} ) );
	}

	/// World place of a joint as it is seen.
	jointPlace( index: number ): THREE.Vector3
	{
		return this.joint.setFromMatrixPosition( this.instance.joints[ index ]!.matrixWorld ).clone();
	}

	/// How high a point is over the ground; below zero how deep it is in it, by the nearer way out, up or sideways: toes
	/// that touch a riser are not as deep as it is high.
	private findGap( place: THREE.Vector3, reach: number ): number
	{
		const over = ( dx: number, dz: number ): number =>
		{
			const floor = this.world.floor( place.x + dx, place.z + dz, place.y + reach );
			return floor === null ? Infinity : place.y - floor;
		};
		const gap = over( 0, 0 );
		const aside = SIDEWAYS.find( ( away ) => away < -gap &&
			[ [ away, 0 ], [ -away, 0 ], [ 0, away ], [ 0, -away ] ].some( ( [ dx, dz ] ) => over( dx!, dz! ) > -away ) );
		return aside === undefined ? gap : -aside;
	}

	/// How fast a point goes over what is under it, m/s.
	private findSlide( { place, before }: SolePoint, reach: number, timeStep: number ): number
	{
		const [ x, , z ] = this.world.ground.findVelocity( place.x, place.z, place.y + reach, FEET_LAYERS );
		return Math.hypot( ( place.x - before.x ) / timeStep - x!, ( place.z - before.z ) / timeStep - z! );
	}

	/// @param labels per leg whether the clip has it on the floor, where that is known
	measure( labels: readonly boolean[] | null, timeStep: number ): FootFigures[]
	{
		const reach = 0.5 * this.world.rig.worldLegLength;
		return this.points.map( ( leg, index ) =>
		{
			let gap = Infinity;
			let slide = 0;
			for ( const point of leg )
			{
				const over = this.findGap( point.place, reach );
				if ( over < gap )
				{
					gap = over;
					slide = timeStep > 0 ? this.findSlide( point, reach, timeStep ) : 0;
				}
			}
			const stands = labels?.[ index ] ?? gap < NEAR_GROUND;
			return { name: this.world.rig.legNames[ index ]!, gap: Number.isFinite( gap ) ? gap : NaN, slide, stands,
				held: ( ( this.placer?.flags( index ) ?? 0 ) & PLANTED ) !== 0, extension: this.findExtension( index ) };
		} );
	}

	private findExtension( leg: number ): number
	{
		const chain = this.world.rig.legJoints[ leg ]!.map( ( joint ) => this.jointPlace( joint ) );
		let length = 0;
		for ( let i = 1; i < chain.length; ++i )
		{
			length += chain[ i ]!.distanceTo( chain[ i - 1 ]! );
		}
		return chain[ 0 ]!.distanceTo( chain.at( -1 )! ) / Math.max( length, 1e-6 );
	}

	report(): FootReport[]
	{
		return this.world.rig.legNames.map( ( name, leg ) => ( {
			name, joints: this.world.rig.legJoints[ leg ]!.map( ( joint ) => this.jointPlace( joint ).toArray() ),
			points: this.points[ leg ]!.map( ( point ) => point.place.toArray() ), solved: this.placer?.ankle( leg ) ?? null,
		} ) );
	}

	/// What the last frame shows of itself. Nothing where no feet are placed.
	draw( mask: number ): Shape[]
	{
		return this.placer?.draw( mask ) ?? [];
	}

	/// Settings of the method's own.
	setOwn( values: SettingValues ): void
	{
		this.placer?.setOwn( values );
	}

	/// What the library tells of the last frame; null where it placed nothing.
	get told(): BodyTold | null
	{
		return this.placer?.told ?? null;
	}

	/// Microseconds that the last frame took: gather, cast, solve.
	get cost(): readonly number[]
	{
		return this.placer?.cost ?? [ 0, 0, 0 ];
	}

	/// As at its beginning.
	forget(): void
	{
		this.placer?.forget();
	}

	beginTrace( capacity?: number ): void
	{
		this.placer?.beginTrace( capacity );
	}

	endTrace(): Uint8Array
	{
		return this.placer?.endTrace() ?? new Uint8Array();
	}

	dispose(): void
	{
		this.placer?.dispose();
		this.instance.dispose();
	}
}
