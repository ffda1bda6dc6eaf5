// SPDX-License-Identifier: MIT
// What a clip is like: how fast its feet pretend to go, where its floor is, when which foot is on it, and its steps,
// found once by the library from samples of the clip. Character space.
//
// A clip that carries its body away is brought back to its place: the pelvis's way over one round is taken out of the
// root joint at a constant rate, and becomes the way of the walker.
import * as THREE from 'three';
import type { AnimationClip } from 'three';
import { POSE_FLOATS, type CharacterInstance, type CharacterModel } from './character';
import type { Finding } from './checks';
import { findFloor, findSteps, findStride, LABEL_FLAT, type RigHandle, type Sampled, type StepTell } from './library';

const RATE = 120; // Hz, of the samples
const MOST_SAMPLES = 6000;
const TRAVELS = 0.25; // of leg length: further from start to end is a way
const LOOP_TOLERANCE = 0.12; // of leg length: further apart at its ends is no loop
const STANDING = 0.1; // m/s: slower strides are none
const SLIDES = 0.12; // share of the stride's speed: a stance that is so much off slides

export class ClipFacts
{
	readonly duration: number;
	readonly loops: boolean;
	/// Of the stride, in the character's units a second; and its way about up, 0 along +Z.
	readonly speed: number;
	readonly strideTurn: number;
	readonly clipFloor: number;
	readonly findings: Finding[] = [];
	private readonly steps: StepTell[ 'steps' ] | null;
	private readonly velocity: readonly number[];
	private readonly labelRate: number;
	private readonly stance: Uint8Array;
	private readonly travel = new THREE.Vector3(); // a second
	private readonly carrier: number;

	/// @param clip null: the bind pose
	constructor( model: CharacterModel, private readonly rig: RigHandle, private readonly clip: AnimationClip | null )
	{
		this.duration = clip?.duration ?? 0;
		this.carrier = this.findCarrier( model );
		const instance = model.makeInstance();
		this.travel = this.findTravel( instance );
		this.loops = this.findLoop( instance );
		const rate = Math.min( RATE, MOST_SAMPLES / Math.max( 3 * this.duration, 0.1 ) );
		const round: Sampled = { poses: this.sampleRounds( instance, 1, rate ), frameRate: rate, velocity: [ 0, 0, 0 ], clipFloor: 0 };
		const stride = this.travel.lengthSq() > 0 ? this.travel.toArray() : findStride( rig, round );
		const speed = Math.hypot( stride[ 0 ]!, stride[ 2 ]! );
		this.speed = speed * rig.scale > STANDING ? speed : 0;
		this.strideTurn = this.speed > 0 ? Math.atan2( stride[ 0 ]!, stride[ 2 ]! ) : Math.atan2( rig.forward[ 0 ]!, rig.forward[ 2 ]! );
		this.velocity = this.speed > 0 ? stride : [ 0, 0, 0 ];
		this.clipFloor = findFloor( rig, round );
		const rounds = this.loops ? 3 : 1;
		const whole: Sampled = { poses: this.sampleRounds( instance, rounds, rate ), frameRate: rate, velocity: this.velocity, clipFloor: this.clipFloor };
		const { labels, steps } = findSteps( rig, whole, this.duration, this.loops );
		this.labelRate = rate;
		// Of a clip that loops its middle round, which knows what is before and after.
		const length = Math.floor( this.duration * rate ) * rig.legCount;
		this.stance = this.loops ? labels.subarray( length, 2 * length ) : labels;
		this.steps = steps;
		this.checkSlide( this.findSlide( instance ) );
		instance.dispose();
	}

	private findCarrier( model: CharacterModel ): number
	{
		let joint = this.rig.pelvis;
		while ( model.parents[ joint ]! >= 0 )
		{
			joint = model.parents[ joint ]!;
		}
		return joint;
	}

	private placeAt( instance: CharacterInstance, joint: number, time: number ): THREE.Vector3
	{
		if ( this.clip !== null )
		{
			instance.setClipPose( this.clip, time );
		}
		instance.root.updateMatrixWorld( true );
		return new THREE.Vector3().setFromMatrixPosition( instance.joints[ joint ]!.matrixWorld );
	}

	private findTravel( instance: CharacterInstance ): THREE.Vector3
	{
		const way = this.placeAt( instance, this.rig.pelvis, this.duration ).sub( this.placeAt( instance, this.rig.pelvis, 0 ) ).setY( 0 );
		const travels = this.duration > 0 && way.length() > TRAVELS * this.rig.legLength;
		return travels ? way.divideScalar( this.duration ) : way.set( 0, 0, 0 );
	}

	private findLoop( instance: CharacterInstance ): boolean
	{
		const away = this.travel.clone().multiplyScalar( this.duration );
		return this.duration > 0 && this.rig.legJoints.every( ( chain ) => chain.every( ( joint ) =>
			this.placeAt( instance, joint, this.duration ).sub( away ).distanceTo( this.placeAt( instance, joint, 0 ) ) <
				LOOP_TOLERANCE * this.rig.legLength ) );
	}

	private sampleRounds( instance: CharacterInstance, rounds: number, rate: number ): Float32Array
	{
		const count = Math.max( 2, Math.floor( rounds * this.duration * rate ) );
		const size = POSE_FLOATS * instance.joints.length;
		const poses = new Float32Array( count * size );
		for ( let i = 0; i < count; ++i )
		{
			this.sample( instance, i / rate, poses.subarray( i * size, ( i + 1 ) * size ) );
		}
		return poses;
	}

	/// Mean speed over the clip's floor of ankles whose foot is flat on it.
	private findSlide( instance: CharacterInstance ): number
	{
		const legs = this.rig.legCount;
		const move = new THREE.Vector3().fromArray( this.velocity ).sub( this.travel ).divideScalar( this.labelRate );
		const ankles = this.rig.legJoints.map( ( chain ) => chain.at( -1 )! );
		let before: THREE.Vector3[] = [];
		let sum = 0;
		let count = 0;
		for ( let frame = 0; frame < this.stance.length / legs; ++frame )
		{
			const now = ankles.map( ( joint ) => this.placeAt( instance, joint, this.wrap( frame / this.labelRate ) ) );
			for ( let leg = 0; leg < legs && frame > 0; ++leg )
			{
				const flat = this.stance[ frame * legs + leg ] === LABEL_FLAT && this.stance[ ( frame - 1 ) * legs + leg ] === LABEL_FLAT;
				sum += flat ? now[ leg ]!.clone().sub( before[ leg ]! ).add( move ).setY( 0 ).length() * this.labelRate : 0;
				count += flat ? 1 : 0;
			}
			before = now;
		}
		return count > 0 ? sum / count : 0;
	}

	private checkSlide( slide: number ): void
	{
		if ( this.speed > 0 && slide > SLIDES * this.speed )
		{
			this.findings.push( { severity: 'warning', where: `clip ${this.clip?.name ?? ''}`, joint: -1,
				what: `its standing feet slide by ${( slide * this.rig.scale ).toFixed( 2 )} m/s over its own floor`,
				mend: 'clean the clip up, or play it at another speed' } );
		}
	}

	private wrap( time: number ): number
	{
		if ( this.duration <= 0 )
		{
			return 0;
		}
		return this.loops ? time - this.duration * Math.floor( time / this.duration ) : Math.min( Math.max( time, 0 ), this.duration );
	}

	/// The clip in place, at a time that may be longer than it.
	sample( instance: CharacterInstance, time: number, pose: Float32Array ): void
	{
		const at = this.wrap( time );
		if ( this.clip !== null )
		{
			instance.setClipPose( this.clip, at );
		}
		instance.readPose( pose );
		const first = POSE_FLOATS * this.carrier;
		pose[ first ]! -= this.travel.x * at;
		pose[ first + 2 ]! -= this.travel.z * at;
	}

	/// Per leg whether the clip has it on its floor.
	labels( time: number ): boolean[] | null
	{
		if ( this.stance.length === 0 )
		{
			return null;
		}
		const legs = this.rig.legCount;
		const frame = Math.min( Math.floor( this.wrap( time ) * this.labelRate ), this.stance.length / legs - 1 );
		return this.rig.legNames.map( ( _, leg ) => this.stance[ frame * legs + leg ]! !== 0 );
	}

	/// What a game that knows the clip would tell of its steps. @param rate of the clip's play
	tell( time: number, rate: number ): StepTell | null
	{
		const velocity = this.velocity.map( ( v ) => v * rate );
		return this.steps === null ? null : { steps: this.steps, time: this.wrap( time ), rate, velocity };
	}

	dispose(): void
	{
		this.steps?.dispose();
	}
}
