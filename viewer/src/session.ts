// SPDX-License-Identifier: MIT
// What is simulated: one or many walkers over one ground, each with a body, or two that are compared. Time goes in
// steps of one length, so that the same time is the same picture.
import * as THREE from 'three';
import { Body, type Method, type World } from './body';
import type { CharacterModel } from './character';
import { ClipFacts } from './clip';
import type { GroundShape } from './ground';
import { GroundHandle } from './ground-handle';
import { groundMaker, RigHandle, SettingsHandle, type SettingInfo, type SettingValues, type Shape } from './library';
import { MethodWorld, type MethodName } from './methods';
import { FEET_LAYERS, ROOT_LAYERS } from './motion';
import type { Finding } from './checks';
import type { FootFigures } from './plots';
import { LAYER_FIRST, LAYER_SECOND } from './stage';
import { TIME_STEP } from './transport';
import { Walker, type FloorFcn, type HeightMode, type Steering, type WalkMode } from './walker';

export interface Choices
{
	mode: WalkMode;
	methods: Method[];
	/// How many characters.
	count: number;
	/// Of the clip's play.
	speed: number;
	height: HeightMode;
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

/// Is one of them an ancestor?
export function needsMethods( methods: readonly Method[] ): boolean
{
	return methods.some( ( method ) => method !== 'none' && method !== 'sole' );
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
	private readonly methods: MethodWorld | null;
	private readonly world: World;
	private readonly turn: number;

	constructor( readonly model: CharacterModel, readonly shape: GroundShape, clip: THREE.AnimationClip | null, readonly choices: Choices )
	{
		this.rig = new RigHandle( model );
		this.ground = new GroundHandle( groundMaker(), shape.parts, shape.twoSided );
		this.facts = new ClipFacts( model, this.rig, clip );
		const idle = model.findIdle();
		this.idle = idle !== null && idle !== clip ? new ClipFacts( model, this.rig, idle ) : null;
		this.findings = [ ...this.rig.findings, ...this.facts.findings ];
		this.turn = Math.atan2( this.rig.forward[ 0 ]!, this.rig.forward[ 2 ]! );
		this.methods = needsMethods( choices.methods ) ? new MethodWorld( this.rig, shape ) : null;
		this.world = { rig: this.rig, ground: this.ground, methods: this.methods, settings: this.settings, weight: 1,
			floor: ( x, z, ceiling ) => this.ground.findFloor( x, z, ceiling, FEET_LAYERS ) };
		this.populate();
	}

	/// Bodies for all that is chosen, at the start.
	populate(): void
	{
		this.subjects.forEach( ( subject ) => subject.bodies.forEach( ( body ) => body.dispose() ) );
		const methods = this.choices.count > 1 ? this.choices.methods.slice( -1 ) : this.choices.methods;
		const columns = this.findColumns();
		const floor: FloorFcn = ( x, z, ceiling ) => this.ground.findFloor( x, z, ceiling, ROOT_LAYERS );
		this.subjects = Array.from( { length: this.choices.count }, ( _, index ) =>
		{
			const column = index % columns;
			const lane = index === 0 ? 0 : ( Math.ceil( column / 2 ) * ( column % 2 === 1 ? 1 : -1 ) ) * LANE * this.legLength;
			const lead = Math.floor( index / columns ) * ROW * this.legLength;
			const walker = new Walker( this.shape.path, floor, this.legLength, lane, lead );
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

	/// The body that figures are of: the last of the first.
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
		this.moveGround( 0 );
		this.subjects.forEach( ( subject, index ) =>
		{
			subject.bodies.forEach( ( body ) => body.forget() );
			subject.facts = this.findFacts( this.choices.mode === 'path' );
			subject.clipTime = this.facts.duration * ( ( index * 0.37 ) % 1 );
		} );
		this.putAtTheStart();
		this.pose( 0 );
	}

	private findFacts( going: boolean ): ClipFacts
	{
		return going || this.idle === null ? this.facts : this.idle;
	}

	private putAtTheStart(): void
	{
		this.subjects.forEach( ( { walker } ) => walker.begin() );
		if ( this.choices.mode === 'stand' )
		{
			this.putOnTheWay( this.shape.duration === null ? 0.3 : 0.5 );
		}
	}

	/// Who stands does so on the way, not at its edge. @param share of the way
	private putOnTheWay( share: number ): void
	{
		for ( const subject of this.subjects )
		{
			const root = subject.walker.root;
			const [ from, to ] = [ this.shape.path[ 0 ]!, this.shape.path[ 1 ]! ];
			subject.walker.put( root.x + share * ( to[ 0 ] - from[ 0 ] ), root.z + share * ( to[ 1 ] - from[ 1 ] ), root.heading );
		}
	}

	/// All that stands for the ground, to where it is at a time of the scene.
	private moveGround( time: number ): void
	{
		this.shape.move( time );
		this.ground.move( time );
		this.methods?.ground.move( time );
	}

	/// The ground moves on, and takes along whoever rides it. @return whether the scene began anew
	private advanceGround( before: number ): boolean
	{
		const { duration } = this.shape;
		if ( duration === null )
		{
			return false;
		}
		const ridden = this.subjects.map( ( { walker } ) => this.ground.findRidden( walker.root, ROOT_LAYERS ) );
		this.moveGround( this.time % duration );
		this.subjects.forEach( ( { walker }, index ) => walker.carry( this.ground.findCarried( ridden[ index ]! ) ) );
		return Math.floor( this.time / duration ) > Math.floor( before / duration );
	}

	step( steering: Steering ): void
	{
		const before = this.time;
		this.time += TIME_STEP;
		const anew = this.advanceGround( before );
		for ( const subject of this.subjects )
		{
			const { walker } = subject;
			const going = this.choices.mode === 'path' || ( this.choices.mode === 'keys' && steering.amount > 0 );
			const facts = this.findFacts( going );
			if ( facts !== subject.facts )
			{
				subject.facts = facts;
				subject.clipTime = 0;
			}
			const speed = facts.speed * this.rig.scale * this.choices.speed;
			walker.step( this.choices.mode, steering, speed, facts.strideTurn - this.turn, TIME_STEP, this.choices.height,
				subject.bodies.at( -1 )!.told?.groundOffset ?? null );
			const amount = this.choices.mode === 'keys' && going ? steering.amount : 1;
			subject.clipTime += TIME_STEP * this.choices.speed * amount;
		}
		if ( anew )
		{
			this.putAtTheStart();
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

	/// @param solid 0: bodies are not seen, 1: not seen through
	setOpacity( solid: number ): void
	{
		this.group.traverse( ( node ) =>
		{
			const mesh = node as THREE.Mesh;
			if ( mesh.isMesh === true )
			{
				for ( const material of Array.isArray( mesh.material ) ? mesh.material : [ mesh.material ] )
				{
					material.transparent = solid < 1;
					material.opacity = solid;
					material.depthWrite = solid > 0.5;
				}
				mesh.visible = solid > 0;
			}
		} );
	}

	/// What each view has to show, left to right.
	shapes( mask: number ): Shape[][]
	{
		return mask === 0 ? [] : this.subjects[ 0 ]!.bodies.map( ( body ) => body.draw( mask ) );
	}

	/// The table of the settings that a method that is shown has of its own.
	ownInfos( method: MethodName ): readonly SettingInfo[]
	{
		return this.methods!.ownInfos( method );
	}

	setOwn( method: MethodName, values: SettingValues ): void
	{
		this.subjects.forEach( ( { bodies } ) => bodies.filter( ( body ) => body.method === method ).forEach( ( body ) => body.setOwn( values ) ) );
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
		this.methods?.dispose();
		this.ground.dispose();
		this.rig.dispose();
	}
}
