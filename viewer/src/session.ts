// SPDX-License-Identifier: MIT
// What is simulated: one or many walkers over one ground, each with a body, or two that are compared. Time goes in
// steps of one length, so that the same time is the same picture.
import * as THREE from 'three';
import { Body, type Method, type World } from './body';
import type { CharacterModel } from './character';
import { ClipFacts } from './clip';
import type { GroundShape } from './ground';
import { GroundHandle, RigHandle, SettingsHandle, type Shape } from './library';
import type { Finding } from './checks';
import type { FootFigures } from './plots';
import { LAYER_FIRST, LAYER_SECOND } from './stage';
import { TIME_STEP } from './transport';
import { Walker, type Steering, type WalkMode } from './walker';

export interface Choices
{
	mode: WalkMode;
	methods: Method[];
	/// How many characters.
	count: number;
	/// Of the clip's play.
	speed: number;
	/// Roots find their height by themselves.
	height: boolean;
	weight: number;
}

/// One that walks, and its bodies.
interface Subject
{
	walker: Walker;
	bodies: Body[];
	clipTime: number;
	facts: ClipFacts;
}

const LANE = 0.9; // of a leg length, from one to the next
const ROW = 1.6;

export class Session
{
	readonly group = new THREE.Group();
	readonly rig: RigHandle;
	readonly ground: GroundHandle;
	readonly settings = new SettingsHandle();
	readonly findings: Finding[];
	time = 0;
	private subjects: Subject[] = [];
	private readonly facts: ClipFacts;
	private readonly idle: ClipFacts | null;
	private readonly world: World;
	private readonly turn: number;

	constructor( readonly model: CharacterModel, readonly shape: GroundShape, clip: THREE.AnimationClip | null, readonly choices: Choices )
	{
		this.rig = new RigHandle( model );
		this.ground = new GroundHandle( shape.positions, shape.indices, shape.twoSided );
		this.facts = new ClipFacts( model, this.rig, clip );
		const idle = model.findIdle();
		this.idle = idle !== null && idle !== clip ? new ClipFacts( model, this.rig, idle ) : null;
		this.findings = [ ...this.rig.findings, ...this.facts.findings ];
		this.turn = Math.atan2( this.rig.forward[ 0 ]!, this.rig.forward[ 2 ]! );
		this.world = { rig: this.rig, ground: this.ground, settings: this.settings, weight: 1,
			floor: ( x, z, ceiling ) => this.ground.findFloor( x, z, ceiling ) };
		this.populate();
	}

	/// Bodies for all that is chosen, at the start.
	populate(): void
	{
		this.subjects.forEach( ( subject ) => subject.bodies.forEach( ( body ) => body.dispose() ) );
		const methods = this.choices.count > 1 ? this.choices.methods.slice( -1 ) : this.choices.methods;
		const columns = this.findColumns();
		this.subjects = Array.from( { length: this.choices.count }, ( _, index ) =>
		{
			const column = index % columns;
			const lane = index === 0 ? 0 : ( Math.ceil( column / 2 ) * ( column % 2 === 1 ? 1 : -1 ) ) * LANE * this.legLength;
			const lead = Math.floor( index / columns ) * ROW * this.legLength;
			const walker = new Walker( this.shape.path, this.world.floor, this.legLength, lane, lead );
			const bodies = methods.map( ( method, view ) => this.makeBody( method, view ) );
			return { walker, bodies, clipTime: this.facts.duration * ( ( index * 0.37 ) % 1 ), facts: this.facts };
		} );
		this.restart();
	}

	private makeBody( method: Method, view: number ): Body
	{
		const instance = this.model.makeInstance();
		instance.setLayer( view === 0 ? LAYER_FIRST : LAYER_SECOND );
		this.group.add( instance.root );
		return new Body( this.model, instance, method, this.world );
	}

	/// How many fit beside each other.
	private findColumns(): number
	{
		const size = this.shape.box.getSize( new THREE.Vector3() );
		const [ from, to ] = [ this.shape.path[ 0 ]!, this.shape.path[ 1 ]! ];
		const alongZ = Math.abs( to[ 1 ] - from[ 1 ] ) >= Math.abs( to[ 0 ] - from[ 0 ] );
		const wide = ( alongZ ? size.x : size.z ) - this.legLength;
		return Math.max( 1, Math.min( 20, Math.floor( wide / ( LANE * this.legLength ) ) ) );
	}

	get legLength(): number
	{
		return this.rig.worldLegLength;
	}

	/// The body that figures and gizmos are of: the last of the first.
	get hero(): Body
	{
		return this.subjects[ 0 ]!.bodies.at( -1 )!;
	}

	get heroView(): number
	{
		return this.subjects[ 0 ]!.bodies.length - 1;
	}

	get walker(): Walker
	{
		return this.subjects[ 0 ]!.walker;
	}

	restart(): void
	{
		this.time = 0;
		this.subjects.forEach( ( subject, index ) =>
		{
			subject.walker.begin();
			subject.bodies.forEach( ( body ) => body.forget() );
			subject.clipTime = this.facts.duration * ( ( index * 0.37 ) % 1 );
		} );
		if ( this.choices.mode === 'stand' )
		{
			this.putInTheMiddle();
		}
		this.pose( 0 );
	}

	/// Who stands does so on the way, not at its edge.
	private putInTheMiddle(): void
	{
		for ( const subject of this.subjects )
		{
			const root = subject.walker.root;
			const [ from, to ] = [ this.shape.path[ 0 ]!, this.shape.path[ 1 ]! ];
			subject.walker.put( root.x + 0.3 * ( to[ 0 ] - from[ 0 ] ), root.z + 0.3 * ( to[ 1 ] - from[ 1 ] ), root.heading );
		}
	}

	step( steering: Steering ): void
	{
		this.time += TIME_STEP;
		for ( const subject of this.subjects )
		{
			const { walker } = subject;
			const going = this.choices.mode === 'path' || ( this.choices.mode === 'keys' && steering.amount > 0 );
			const facts = going || this.idle === null ? this.facts : this.idle;
			if ( facts !== subject.facts )
			{
				subject.facts = facts;
				subject.clipTime = 0;
			}
			const speed = facts.speed * this.rig.scale * this.choices.speed;
			walker.step( this.choices.mode, steering, speed, facts.strideTurn - this.turn, TIME_STEP, this.choices.height );
			const amount = this.choices.mode === 'keys' && going ? steering.amount : 1;
			subject.clipTime += TIME_STEP * this.choices.speed * amount;
		}
		this.pose( TIME_STEP );
	}

	private pose( timeStep: number ): void
	{
		const scale = this.rig.scale;
		for ( const { walker, bodies, facts, clipTime } of this.subjects )
		{
			const root = walker.root;
			const yaw = 0.5 * ( root.heading - this.turn );
			const frame = {
				root: [ root.x, root.y, root.z, 0, Math.sin( yaw ), 0, Math.cos( yaw ), scale, scale, scale ],
				timeStep, weight: this.choices.weight, clipFloor: facts.clipFloor,
				teleport: walker.jumped || timeStep === 0, tell: facts.tell( clipTime, this.choices.speed ),
			};
			bodies.forEach( ( body ) => body.step( facts, clipTime, frame ) );
		}
	}

	/// What the camera goes along with: over the root, where the legs are.
	focus(): THREE.Vector3
	{
		const pelvis = this.hero.jointPlace( this.rig.pelvis );
		return pelvis.setY( pelvis.y - 0.42 * this.legLength );
	}

	figures(): FootFigures[]
	{
		const { facts, clipTime } = this.subjects[ 0 ]!;
		return this.hero.measure( facts.labels( clipTime ), TIME_STEP );
	}

	shapes( mask: number ): Shape[]
	{
		return mask === 0 ? [] : this.hero.draw( mask );
	}

	/// Microseconds a character: gather, cast, solve.
	cost(): number[]
	{
		const sums = [ 0, 0, 0 ];
		for ( const { bodies } of this.subjects )
		{
			bodies.at( -1 )!.cost.forEach( ( cost, index ) => { sums[ index ]! += cost / this.subjects.length; } );
		}
		return sums;
	}

	dispose(): void
	{
		this.subjects.forEach( ( subject ) => subject.bodies.forEach( ( body ) => body.dispose() ) );
		this.facts.dispose();
		this.idle?.dispose();
		this.group.removeFromParent();
		this.settings.dispose();
		this.ground.dispose();
		this.rig.dispose();
	}
}
