// SPDX-License-Identifier: MIT
// The library as the page uses it: sole.js and the WebAssembly module, with what the page needs beside: sole points in
// their joints' spaces, the floor below a place, a clip's motion.
import * as THREE from 'three';
import { ContactLabel, hasSimd, LegFlags, loadSole } from '../../build/wasm/sole.js';
import type { Character, Rig, SettingInfo, Settings, Skeleton, Sole, Steps, Tracer, Vector } from '../../build/wasm/sole.js';
import plainModule from '../../build/wasm/sole-debug.wasm?url';
import simdModule from '../../build/wasm/sole-debug-simd.wasm?url';
import { POSE_FLOATS, type CharacterModel } from './character';
import type { Finding } from './checks';
import type { GroundHandle, GroundMaker } from './ground-handle';

export type { SettingInfo };
export const PLANTED = LegFlags.planted;
export const LABEL_FLAT = ContactLabel.flat;

/// Values by their dotted names.
export type SettingValues = Record<string, number>;

/// A category of what the library draws of a frame.
export type DrawInfo = Sole[ 'drawInfos' ][ number ];
/// One thing that it draws. World.
export type Shape = ReturnType<Character[ 'draw' ]>[ number ];

let sole: Sole;

export interface Library
{
	settingInfos: readonly SettingInfo[];
	drawInfos: readonly DrawInfo[];
	/// Settings as the program reads and writes them. Settings that are not in the text keep their defaults.
	formatSettings( values: SettingValues ): string;
	parseSettings( text: string ): SettingValues;
}

function fill( settings: Settings, values: SettingValues ): Settings
{
	for ( const [ name, value ] of Object.entries( values ) )
	{
		settings.set( name, value );
	}
	return settings;
}

function formatSettings( values: SettingValues ): string
{
	const settings = fill( sole.createSettings(), values );
	const text = `${JSON.stringify( settings.toJSON(), null, '\t' )}\n`;
	settings.dispose();
	return text;
}

function parseSettings( text: string ): SettingValues
{
	const settings = sole.createSettings( text );
	const values = Object.fromEntries( sole.settingInfos.map( ( { name } ) => [ name, settings.get( name ) ] ) );
	settings.dispose();
	return values;
}

/// Makes the grounds that Sole's characters stand on.
export function groundMaker(): GroundMaker
{
	return sole;
}

export async function openLibrary(): Promise<Library>
{
	sole = await loadSole( { url: hasSimd() ? simdModule : plainModule, debug: true } );
	return { settingInfos: sole.settingInfos, drawInfos: sole.drawInfos, formatSettings, parseSettings };
}

// -------------------------------------------------------------------------------------------------------- settings

export class SettingsHandle
{
	readonly settings = sole.createSettings();

	set( values: SettingValues ): void
	{
		fill( this.settings, values );
	}

	dispose(): void
	{
		this.settings.dispose();
	}
}

// ------------------------------------------------------------------------------------------------------------- rig

/// A point of a sole in the space of the joint that carries it.
export interface SolePoint
{
	joint: number;
	place: readonly number[];
}

/// Joints to character space in the bind pose.
function findBindMatrices( model: CharacterModel ): THREE.Matrix4[]
{
	const matrices: THREE.Matrix4[] = [];
	model.names.forEach( ( _, joint ) =>
	{
		const at = POSE_FLOATS * joint;
		const local = new THREE.Matrix4().compose( new THREE.Vector3().fromArray( model.bindPose, at ),
			new THREE.Quaternion().fromArray( model.bindPose, at + 3 ), new THREE.Vector3().fromArray( model.bindPose, at + 7 ) );
		const parent = model.parents[ joint ]!;
		matrices.push( parent < 0 ? local : matrices[ parent ]!.clone().multiply( local ) );
	} );
	return matrices;
}

const ARCH_POINTS = 8; // from the heel to before the ball

function toVector( v: Vector ): THREE.Vector3
{
	return 'x' in v ? new THREE.Vector3( v.x, v.y, v.z ) : new THREE.Vector3().fromArray( Array.from( v ) );
}

export class RigHandle
{
	readonly rig: Rig;
	readonly findings: readonly Finding[];
	/// Hip to ankle, a list of joints per leg.
	readonly legJoints: readonly number[][];
	/// From the heel to the ball, toe tip, inner and outer edge, per leg.
	readonly solePoints: readonly SolePoint[][];
	readonly pelvis: number;
	readonly forward: readonly number[];
	readonly legLength: number; // in the file's unit
	/// What makes the character human sized where the file's unit is not the metre.
	readonly scale: number;

	constructor( model: CharacterModel )
	{
		const skeleton: Skeleton = { names: model.names, parents: model.parents, bindPose: model.bindPose, skin: model.skin };
		const found = sole.detectRig( skeleton );
		const definition = found.rig.definition;
		const binds = findBindMatrices( model );
		this.rig = found.rig;
		this.findings = found.findings;
		this.legLength = found.legLength;
		this.scale = found.suggestedScale;
		this.pelvis = definition.pelvis as number;
		this.forward = [ ...( definition.forward as readonly number[] ) ];
		this.legJoints = definition.legs.map( ( leg ) => [ ...leg.joints as number[] ] );
		this.solePoints = definition.legs.map( ( leg, index ) =>
		{
			const detached = leg.detachedFoot as number | undefined ?? -1;
			const foot = detached >= 0 ? detached : this.legJoints[ index ]!.at( -1 )!;
			const fore = ( leg.toes as number[] | undefined )?.[ 0 ] ?? foot;
			const { heel, ball, toe, inner, outer } = leg.sole;
			const [ back, middle ] = [ heel, ball ].map( toVector ) as [ THREE.Vector3, THREE.Vector3 ];
			const arch = Array.from( { length: ARCH_POINTS }, ( _, k ) => back.clone().lerp( middle, k / ARCH_POINTS ) );
			const place = ( joint: number, point: THREE.Vector3 ): SolePoint =>
				( { joint, place: point.applyMatrix4( binds[ joint ]!.clone().invert() ).toArray() } );
			return [ ...arch.map( ( point ) => place( foot, point ) ),
				...[ ball, toe, inner, outer ].map( ( point ) => place( fore, toVector( point ) ) ) ];
		} );
	}

	get legCount(): number
	{
		return this.rig.legCount;
	}

	get legNames(): readonly string[]
	{
		return this.rig.legNames;
	}

	get worldLegLength(): number
	{
		return this.legLength * this.scale;
	}

	dispose(): void
	{
		this.rig.dispose();
	}
}

// ------------------------------------------------------------------------------------------------------------ clips

/// A clip in place, as samples; its root goes on at a velocity. Character space.
export interface Sampled
{
	poses: Float32Array;
	frameRate: number;
	velocity: readonly number[];
	clipFloor: number;
}

function makeMotion( { rig }: RigHandle, { poses, frameRate, velocity, clipFloor }: Sampled ): Parameters<Sole[ 'label' ]>[ 0 ]
{
	const count = poses.length / ( POSE_FLOATS * rig.jointCount );
	const roots = new Float32Array( POSE_FLOATS * count );
	for ( let i = 0; i < count; ++i )
	{
		const time = i / frameRate;
		roots.set( [ velocity[ 0 ]! * time, velocity[ 1 ]! * time, velocity[ 2 ]! * time, 0, 0, 0, 1, 1, 1, 1 ], POSE_FLOATS * i );
	}
	return { rig, poses, roots, frameRate, clipFloor };
}

export function findStride( rig: RigHandle, sampled: Sampled ): readonly number[]
{
	return sole.findStrideVelocity( makeMotion( rig, sampled ) ) as readonly number[];
}

export function findFloor( rig: RigHandle, sampled: Sampled ): number
{
	return sole.findClipFloor( makeMotion( rig, sampled ) );
}

/// A label per frame and leg, and the steps. @param sampled three rounds of a clip that loops
export function findSteps( rig: RigHandle, sampled: Sampled, duration: number, loops: boolean ): { labels: Uint8Array; steps: Steps | null }
{
	const motion = makeMotion( rig, sampled );
	const labels = sole.label( motion );
	const steps = sole.findSteps( motion, labels, loops );
	return { labels, steps: steps.length > 0 ? sole.createSteps( steps, { duration, loops } ) : null };
}

/// What a clip tells of its steps in a frame.
export interface StepTell
{
	steps: Steps;
	time: number;
	rate: number;
	velocity: readonly number[];
}

// ---------------------------------------------------------------------------------------------------------- frames

export interface Frame
{
	root: readonly number[]; // translation, rotation, scale
	timeStep: number;
	weight: number;
	clipFloor: number;
	teleport: boolean;
	tell: StepTell | null;
}

/// What the library tells of the body as a whole.
export interface BodyTold
{
	/// How far the ground that it is over lies over the root, m.
	groundOffset: number;
	/// For how long no probe has met anything, s.
	unmetTime: number;
	/// What the host is to move the whole character by.
	rootOffset: readonly number[];
}

/// Places the feet of one character, by whatever method.
export interface FootPlacer
{
	/// Microseconds of the last frame: gather, cast, solve.
	readonly cost: readonly number[];
	/// Of the last frame; null where the method tells nothing.
	readonly told: BodyTold | null;
	/// As if it had never placed a frame.
	forget(): void;
	/// @param pose in and out
	place( pose: Float32Array, frame: Frame, ground: GroundHandle ): void;
	flags( leg: number ): number;
	ankle( leg: number ): number[];
	draw( mask: number ): Shape[];
	/// Settings of the method's own; Sole's are shared by all of its characters.
	setOwn( values: SettingValues ): void;
	/// From now on all frames are recorded, where they can be.
	beginTrace( capacity?: number ): void;
	endTrace(): Uint8Array;
	dispose(): void;
}

function hear( character: Character, tell: StepTell | null ): void
{
	tell !== null ? tell.steps.tell( character, tell ) : character.forgetSteps();
}

/// Hears what a clip tells of its steps, for those who live in another module.
export class Listener
{
	private readonly character: Character;

	constructor( rig: RigHandle )
	{
		this.character = sole.createCharacter( rig.rig );
	}

	hear( tell: StepTell | null ): { contact: Float32Array; steps: Float32Array }
	{
		hear( this.character, tell );
		return { contact: this.character.contact, steps: this.character.steps };
	}

	dispose(): void
	{
		this.character.dispose();
	}
}

const TO_ROOT = 1; // pelvis.mode: the host moves the whole character

/// Sole.
export class Placer implements FootPlacer
{
	readonly cost = [ 0, 0, 0 ];
	private readonly character: Character;
	private readonly fresh: Uint8Array;
	private tracer: Tracer | null = null;

	constructor( rig: RigHandle, settings: SettingsHandle )
	{
		this.character = sole.createCharacter( rig.rig, { settings: settings.settings } );
		this.fresh = this.character.snapshot();
	}

	get told(): BodyTold
	{
		const { output, settings } = this.character;
		return { groundOffset: output.groundOffset, unmetTime: output.unmetTime,
			rootOffset: settings.get( 'pelvis.mode' ) === TO_ROOT ? Array.from( output.pelvisOffset ) : [ 0, 0, 0 ] };
	}

	forget(): void
	{
		this.character.restore( this.fresh );
	}

	place( pose: Float32Array, frame: Frame, ground: GroundHandle ): void
	{
		const { character } = this;
		character.pose = pose;
		const { tell, ...said } = frame;
		Object.assign( character.frame, said );
		hear( character, tell );
		character.setSupports( ground.supports );
		const times = [ performance.now() ];
		character.gather();
		times.push( performance.now() );
		character.cast( ground.answers );
		times.push( performance.now() );
		this.tracer !== null ? this.tracer.solve() : character.solve();
		times.push( performance.now() );
		this.cost.forEach( ( _, k ) => { this.cost[ k ] = 1e3 * ( times[ k + 1 ]! - times[ k ]! ); } );
		pose.set( character.placed );
	}

	flags( leg: number ): number
	{
		return this.character.output.legs[ leg ]!.flags;
	}

	ankle( leg: number ): number[]
	{
		return Array.from( this.character.output.legs[ leg ]!.ankle );
	}

	draw( mask: number ): Shape[]
	{
		return this.character.draw( mask );
	}

	setOwn(): void
	{
	}

	beginTrace( capacity?: number ): void
	{
		this.tracer?.dispose();
		this.tracer = sole.createTracer( this.character, capacity );
	}

	endTrace(): Uint8Array
	{
		const bytes = this.tracer?.finish() ?? new Uint8Array();
		this.tracer?.dispose();
		this.tracer = null;
		return bytes;
	}

	dispose(): void
	{
		this.tracer?.dispose();
		this.character.dispose();
	}
}
