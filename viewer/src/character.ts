// SPDX-License-Identifier: MIT
// A character of a file: its joints as the library wants them, its bind pose, the points of its skin, its clips, and
// instances of it that can be posed. Character space is the space of the file's scene.
//
// A pose is ten floats a joint, parent-local: translation, rotation x y z w, scale.
import * as THREE from 'three';
import { clone } from 'three/addons/utils/SkeletonUtils.js';
import type { GLTF } from 'three/addons/loaders/GLTFLoader.js';

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

/// Bones and all above them, parents first.
function jointsOf( object: THREE.Object3D ): THREE.Object3D[]
{
	const wanted = new Set<THREE.Object3D>();
	for ( const skin of skinsOf( object ) )
	{
		for ( const bone of skin.skeleton.bones )
		{
			for ( let node: THREE.Object3D | null = bone; node !== null && node !== object; node = node.parent )
			{
				wanted.add( node );
			}
		}
	}
	const joints: THREE.Object3D[] = [];
	object.traverse( ( node ) =>
	{
		if ( wanted.has( node ) )
		{
			joints.push( node );
		}
	} );
	return joints;
}

function writePose( node: THREE.Object3D, pose: Float32Array, joint: number ): void
{
	node.position.toArray( pose, POSE_FLOATS * joint );
	node.quaternion.toArray( pose, POSE_FLOATS * joint + 3 );
	node.scale.toArray( pose, POSE_FLOATS * joint + 7 );
}

/// What the inverse bind matrices say where there are some, else the rest pose.
function findBindPose( object: THREE.Object3D, joints: readonly THREE.Object3D[], parents: Int32Array ): Float32Array
{
	object.updateMatrixWorld( true );
	const worlds = joints.map( ( joint ) => joint.matrixWorld.clone() );
	for ( const skin of skinsOf( object ) )
	{
		skin.skeleton.bones.forEach( ( bone, index ) =>
		{
			const inverse = skin.skeleton.boneInverses[ index ];
			if ( inverse !== undefined && inverse.determinant() !== 0 )
			{
				worlds[ joints.indexOf( bone ) ] = inverse.clone().invert().premultiply( skin.bindMatrix );
			}
		} );
	}
	const pose = new Float32Array( POSE_FLOATS * joints.length );
	const node = new THREE.Object3D();
	joints.forEach( ( _, joint ) =>
	{
		const parent = parents[ joint ]!;
		const local = parent < 0 ? worlds[ joint ]!.clone() : worlds[ parent ]!.clone().invert().multiply( worlds[ joint ]! );
		local.decompose( node.position, node.quaternion, node.scale );
		writePose( node, pose, joint );
	} );
	return pose;
}

function findSkinPoints( object: THREE.Object3D, joints: readonly THREE.Object3D[] ): SkinPoints
{
	const positions: number[] = [];
	const indices: number[] = [];
	const weights: number[] = [];
	const p = new THREE.Vector3();
	for ( const skin of skinsOf( object ) )
	{
		const toJoint = skin.skeleton.bones.map( ( bone ) => joints.indexOf( bone ) );
		const place = skin.geometry.getAttribute( 'position' );
		const index = skin.geometry.getAttribute( 'skinIndex' );
		const weight = skin.geometry.getAttribute( 'skinWeight' );
		for ( let i = 0; i < place.count; ++i )
		{
			p.fromBufferAttribute( place, i ).applyMatrix4( skin.bindMatrix );
			positions.push( p.x, p.y, p.z );
			for ( let k = 0; k < 4; ++k )
			{
				const share = weight.getComponent( i, k );
				indices.push( share > 0 ? toJoint[ index.getComponent( i, k ) ] ?? -1 : -1 );
				weights.push( share );
			}
		}
	}
	return { positions: new Float32Array( positions ), joints: new Int32Array( indices ), weights: new Float32Array( weights ) };
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
		this.joints = jointsOf( object );
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
		const joints = jointsOf( this.template );
		if ( joints.length === 0 )
		{
			throw new Error( `${name}: has no skin: a character needs bones that move its mesh.` );
		}
		this.names = joints.map( ( joint ) => ( joint.userData[ 'name' ] as string | undefined ) ?? joint.name );
		this.parents = Int32Array.from( joints, ( joint ) => joints.indexOf( joint.parent! ) );
		this.bindPose = findBindPose( this.template, joints, this.parents );
		this.skin = findSkinPoints( this.template, joints );
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
