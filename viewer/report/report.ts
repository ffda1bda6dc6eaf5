// SPDX-License-Identifier: MIT
// The report as a whole: two takes of a walk on one time, seen side by side, with all that was measured of them.
import * as THREE from 'three';
import type { GLTF } from 'three/addons/loaders/GLTFLoader.js';
import { CharacterInstance } from '../src/character';
import { GroundShape } from '../src/ground';
import { Keys } from '../src/input';
import { find, getTheme, make, setTheme } from '../src/page';
import { LAYER_FIRST, LAYER_SECOND, Stage } from '../src/stage';
import { Transport } from '../src/transport';
import { baseName, durationOf, type ReportData, type Take, type Walk } from './data';
import { showChanges, showFigures } from './figures';
import { Sticks } from './sticks';
import { Timeline } from './timeline';

const FOCUS = 0.42; // of leg length below the pelvis: feet and ground are what is to be seen
const SMOOTH = 0.5; // s to either side: the camera goes straight on where the body bobs

/// Where the camera looks at every frame.
function findFocus( take: Take, walk: Walk, legLength: number ): THREE.Vector3[]
{
	const reach = Math.round( SMOOTH * walk.fps );
	return Array.from( { length: walk.frames }, ( _, frame ) =>
	{
		const away = Math.min( reach, frame, walk.frames - 1 - frame );
		const sum = new THREE.Vector3();
		for ( let k = frame - away; k <= frame + away; ++k )
		{
			sum.add( new THREE.Vector3().fromArray( take.pelvis, 3 * k ) );
		}
		return sum.divideScalar( 2 * away + 1 ).sub( new THREE.Vector3( 0, FOCUS * legLength, 0 ) );
	} );
}

/// One of the two bodies that are seen.
interface Seen
{
	instance: CharacterInstance;
	/// Of a character that has no skin to be seen.
	sticks: Sticks | null;
	clip: THREE.AnimationClip | null;
}

/// A leg of a body as it is in the picture.
export interface LegPlaces
{
	name: string;
	/// World, hip to ankle.
	joints: number[][];
	/// The ankle on the page; null: not in the picture.
	pixel: number[] | null;
}

/// By the name that it has in its file.
function findNode( root: THREE.Object3D, name: string | undefined ): THREE.Object3D | null
{
	let found: THREE.Object3D | null = null;
	root.traverse( ( node ) =>
	{
		found = ( ( node.userData[ 'name' ] as string | undefined ) ?? node.name ) === name ? node : found;
	} );
	return found;
}

/// The lowest node that all legs hang from.
function findPelvis( root: THREE.Object3D, data: ReportData ): THREE.Object3D
{
	const holds = ( top: THREE.Object3D ): boolean => data.legs.every( ( leg ) => findNode( top, leg.joints[ 0 ] ) !== null );
	let node = findNode( root, data.legs[ 0 ]?.joints[ 0 ] )?.parent ?? root;
	while ( node.parent !== null && holds( node ) === false )
	{
		node = node.parent;
	}
	return node;
}

function findPlace( root: THREE.Object3D, name: string ): THREE.Vector3
{
	const node = findNode( root, name );
	return node === null ? new THREE.Vector3( NaN, NaN, NaN ) : new THREE.Vector3().setFromMatrixPosition( node.matrixWorld );
}

export class Report
{
	readonly stage: Stage;
	private readonly transport: Transport;
	private readonly timeline = new Timeline( ( time ) => this.scrub( time ) );
	private readonly slider = make( 'input', { type: 'range', id: 'scrub', min: '0', step: '1', 'aria-label': 'Frame' } );
	private readonly seen: Seen[];
	private walk: Walk;
	private shown: [ number, number ] = [ 0, 1 ];
	private focus: THREE.Vector3[] = [];
	private time = 0;

	/// @param manual nothing moves by itself
	constructor( readonly data: ReportData, private readonly gltf: GLTF, ground: GLTF, manual: boolean )
	{
		this.walk = data.walks[ 0 ]!;
		this.stage = new Stage( find<HTMLCanvasElement>( 'canvas' ), manual );
		this.stage.views = [ LAYER_FIRST, LAYER_SECOND ];
		this.stage.scene.add( new GroundShape( baseName( data.ground ), ground.scene ).group );
		this.seen = this.stage.views.map( ( layer ) =>
		{
			const instance = new CharacterInstance( gltf.scene );
			instance.setLayer( layer );
			this.stage.scene.add( instance.root );
			const sticks = instance.joints.length === 0 ? new Sticks( findPelvis( instance.root, data ), layer ) : null;
			sticks !== null && this.stage.scene.add( sticks.lines );
			return { instance, sticks, clip: null };
		} );
		this.transport = new Transport( () => this.stepBy( 1 ), () => this.setTime( 0 ) );
		this.transport.setPlaying( manual === false && matchMedia( '(prefers-reduced-motion: reduce)' ).matches === false );
		this.slider.addEventListener( 'input', () => this.scrub( Number( this.slider.value ) / this.walk.fps ) );
		find( 'transport' ).append( this.slider );
		new Keys( { Space: () => this.transport.toggle(), Period: () => this.transport.stepOnce(), Comma: () => this.stepBack(),
			KeyR: () => this.setTime( 0 ) } );
		this.makePickers();
		showChanges( data.settings );
		find( 'foot' ).textContent = `Made by sole ${data.version} from ${baseName( data.character )} over ${baseName( data.ground )}.`;
		this.open( this.walk );
	}

	// --------------------------------------------------------------------------------------------------------- choices

	private choose( label: string, names: readonly string[], value: number, changed: ( index: number ) => void ): void
	{
		const select = make( 'select', {}, ...names.map( ( name, index ) => make( 'option', { value: String( index ) }, name ) ) );
		select.selectedIndex = value;
		select.addEventListener( 'change', () => changed( select.selectedIndex ) );
		find( 'pickers' ).append( make( 'label', {}, label, select ) );
	}

	/// Only what there is a choice of.
	private makePickers(): void
	{
		if ( this.data.walks.length > 1 )
		{
			this.choose( 'Clip', this.data.walks.map( ( walk ) => walk.clip ), 0, ( index ) => this.open( this.data.walks[ index ]! ) );
		}
		const methods = this.walk.takes.map( ( take ) => take.method );
		for ( const side of methods.length > 2 ? [ 0, 1 ] : [] )
		{
			this.choose( side === 0 ? 'Left' : 'Right', methods, this.shown[ side ]!, ( index ) =>
			{
				this.shown[ side ] = index;
				this.showTakes();
			} );
		}
		find( 'tools' ).append( make( 'button', { title: 'Light or dark', 'aria-label': 'Light or dark',
			onclick: () => setTheme( getTheme() === 'dark' ? 'light' : 'dark' ) }, '◐' ) );
	}

	private open( walk: Walk ): void
	{
		this.walk = walk;
		const title = `${walk.clip} over ${baseName( this.data.ground )}`;
		document.title = `${title}: Sole`;
		find( 'what' ).textContent = `${title} · ${walk.frames} frames at ${walk.fps} Hz, ${durationOf( walk ).toFixed( 1 )} s` +
			( walk.speed > 0 ? `, ${walk.speed.toFixed( 2 )} m/s` : '' );
		this.slider.max = String( walk.frames - 1 );
		this.time = 0;
		this.showTakes();
		const pelvis = walk.takes[ 0 ]!.pelvis;
		const way = new THREE.Vector3().fromArray( pelvis, pelvis.length - 3 ).sub( new THREE.Vector3().fromArray( pelvis ) );
		this.stage.resize();
		this.stage.frame( this.focus[ 0 ]!, this.data.legLength, Math.atan2( way.x, way.z ) );
	}

	private showTakes(): void
	{
		const takes = this.shown.map( ( index ) => this.walk.takes[ index ]! ) as [ Take, Take ];
		this.seen.forEach( ( body, side ) =>
		{
			body.clip = this.gltf.animations.find( ( clip ) => clip.name === takes[ side ]!.clip ) ?? null;
		} );
		find( 'captions' ).replaceChildren( ...takes.map( ( take, side ) => make( 'span', { class: side === 0 ? 'before' : 'after' },
			`${side === 0 ? 'Before' : 'After'}: ${take.method}`,
			make( 'small', {}, take.summary.toLowerCase() === take.method ? 'feet placed' : take.summary ) ) ) );
		this.focus = findFocus( takes[ 1 ], this.walk, this.data.legLength );
		this.timeline.show( this.data, this.walk, takes );
		showFigures( this.walk, this.shown );
		this.setTime( this.time );
	}

	// ------------------------------------------------------------------------------------------------------------ time

	setTime( time: number ): void
	{
		this.time = Math.min( Math.max( time, 0 ), durationOf( this.walk ) );
		const frame = Math.round( this.time * this.walk.fps );
		for ( const { instance, sticks, clip } of this.seen )
		{
			clip !== null && instance.setClipPose( clip, this.time );
			instance.root.updateMatrixWorld( true );
			sticks?.update();
		}
		this.stage.follow( this.focusAt( this.time ), 0, true );
		this.slider.value = String( frame );
		this.timeline.setTime( this.time );
		this.transport.show( this.time, `frame ${frame} of ${this.walk.frames - 1}` );
	}

	private focusAt( time: number ): THREE.Vector3
	{
		const at = time * this.walk.fps;
		const last = this.focus.length - 1;
		const frame = Math.min( Math.floor( at ), last );
		return this.focus[ frame ]!.clone().lerp( this.focus[ Math.min( frame + 1, last ) ]!, at - frame );
	}

	private scrub( time: number ): void
	{
		this.transport.setPlaying( false );
		this.setTime( Math.round( time * this.walk.fps ) / this.walk.fps );
	}

	private stepBy( frames: number ): void
	{
		this.setTime( ( Math.round( this.time * this.walk.fps ) + frames ) / this.walk.fps );
	}

	private stepBack(): void
	{
		this.transport.setPlaying( false );
		this.stepBy( -1 );
	}

	/// A picture, and the time that it stands for. Behind the end it begins anew.
	tick( seconds: number ): void
	{
		if ( this.transport.playing )
		{
			const next = this.time + seconds * this.transport.rate;
			this.setTime( next > durationOf( this.walk ) ? 0 : next );
		}
		this.stage.render();
	}

	// --------------------------------------------------------------------------------------------------------- telling

	/// What is seen of the legs now, left and right picture.
	places(): { method: string; legs: LegPlaces[] }[]
	{
		return this.seen.map( ( { instance }, side ) => ( { method: this.walk.takes[ this.shown[ side ]! ]!.method,
			legs: this.data.legs.map( ( leg ) =>
			{
				const places = leg.joints.map( ( name ) => findPlace( instance.root, name ) );
				return { name: leg.name, joints: places.map( ( place ) => place.toArray() ),
					pixel: this.stage.project( places.at( -1 )!, side )?.toArray() ?? null };
			} ) } ) );
	}
}
