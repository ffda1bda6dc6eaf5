// SPDX-License-Identifier: MIT
// A character of a file: its joints as the library wants them, its bind pose, the points of its skin, its clips, and
// instances of it that can be posed. Character space is the space of the file's scene.
//
// A pose is ten floats a joint, parent-local: translation, rotation x y z w, scale.
import * as THREE from 'three';
import { clone } from 'three/addons/utils/SkeletonUtils.js';
import type { GLTF } from 'three/addons/loaders/GLTFLoader.js';
import { findSkeletonJoints, readSkeleton } from '../../build/wasm/sole-three.js';

export const POSE_FLOATS = 10;

/// A vertex of the skin in the bind pose.
export interface SkinPoints
{
	positions: Float32Array; // 3 a vertex, character space
	joints: Int32Array; // 4 a vertex, -1: none
	weights: Float32Array; // 4 a vertex
}

function isSkinned( node: THREE.Object3D ): node is THREE.SkinnedMesh
{
	return ( node as THREE.SkinnedMesh ).isSkinnedMesh === true;
}

function skinsOf( object: THREE.Object3D ): THREE.SkinnedMesh[]
{
	const skins: THREE.SkinnedMesh[] = [];
	object.traverse( ( node ) =>
	{
		if ( isSkinned( node ) )
		{
			skins.push( node );
		}
	} );
	return skins;
}

function writePose( node: THREE.Object3D, pose: Float32Array, joint: number ): void
{
	node.position.toArray( pose, POSE_FLOATS * joint );
	node.quaternion.toArray( pose, POSE_FLOATS * joint + 3 );
	node.scale.toArray( pose, POSE_FLOATS * joint + 7 );
}

/// One of possibly many that look alike.
export class CharacterInstance
{
	readonly root = new THREE.Group();
	readonly joints: THREE.Object3D[];
	private readonly mixer: THREE.AnimationMixer;
	private readonly actions = new Map<THREE.AnimationClip, THREE.AnimationAction>();
	private playing: THREE.AnimationAction | null = null;
	/// As the clip had it last. The mixer writes only what has changed since then: joints that were placed in the
	/// meantime have to be put back first.
	private readonly animated: Float32Array;

	constructor( template: THREE.Object3D )
	{
		const object = clone( template );
		this.joints = findSkeletonJoints( object, object );
		this.root.add( object );
		this.root.matrixAutoUpdate = false;
		this.mixer = new THREE.AnimationMixer( object );
		this.animated = new Float32Array( POSE_FLOATS * this.joints.length );
		this.readPose( this.animated );
		for ( const skin of skinsOf( object ) )
		{
			skin.castShadow = true;
			skin.frustumCulled = false;
		}
	}

	setLayer( layer: number ): void
	{
		this.root.traverse( ( node ) => node.layers.set( layer ) );
	}

	/// The clip's pose at a time, in the joints.
	setClipPose( clip: THREE.AnimationClip, time: number ): void
	{
		this.applyPose( this.animated );
		let action = this.actions.get( clip );
		if ( action === undefined )
		{
			action = this.mixer.clipAction( clip );
			this.actions.set( clip, action );
		}
		if ( this.playing !== action )
		{
			this.playing?.stop();
			this.playing = action.play();
		}
		action.time = time;
		this.mixer.update( 0 );
		this.readPose( this.animated );
	}

	readPose( pose: Float32Array ): void
	{
		this.joints.forEach( ( node, joint ) => writePose( node, pose, joint ) );
	}

	applyPose( pose: Float32Array ): void
	{
		this.joints.forEach( ( node, joint ) =>
		{
			node.position.fromArray( pose, POSE_FLOATS * joint );
			node.quaternion.fromArray( pose, POSE_FLOATS * joint + 3 );
			node.scale.fromArray( pose, POSE_FLOATS * joint + 7 );
		} );
	}

	dispose(): void
	{
		this.mixer.stopAllAction();
		this.root.removeFromParent();
	}
}

export class CharacterModel
{
	readonly names: string[];
	readonly parents: Int32Array;
	readonly bindPose: Float32Array;
	readonly skin: SkinPoints;
	readonly clips: readonly THREE.AnimationClip[];
	private readonly template: THREE.Object3D;

	constructor( readonly name: string, gltf: GLTF )
	{
		this.template = gltf.scene;
		this.clips = gltf.animations;
		if ( skinsOf( this.template ).length === 0 )
		{
			throw new Error( `${name}: has no skin: a character needs bones that move its mesh.` );
		}
		const { names, parents, bindPose, skin } = readSkeleton( this.template, this.template );
		this.names = names;
		this.parents = Int32Array.from( parents );
		this.bindPose = bindPose;
		this.skin = { positions: new Float32Array( skin.positions ), joints: new Int32Array( skin.joints ), weights: new Float32Array( skin.weights ) };
	}

	get jointCount(): number
	{
		return this.names.length;
	}

	makeInstance(): CharacterInstance
	{
		return new CharacterInstance( this.template );
	}

	/// The named one, else the best walk.
	findClip( name: string | null ): THREE.AnimationClip | null
	{
		const wanted = [ name ?? '', 'walk', 'Walk_Loop' ];
		return wanted.map( ( one ) => this.clips.find( ( clip ) => clip.name === one ) ).find( ( clip ) => clip !== undefined ) ??
			this.clips.find( ( clip ) => /walk/i.test( clip.name ) ) ?? this.clips[ 0 ] ?? null;
	}

	findIdle(): THREE.AnimationClip | null
	{
		return this.clips.find( ( clip ) => /idle|stand/i.test( clip.name ) ) ?? null;
	}
}
