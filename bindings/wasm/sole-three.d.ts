// SPDX-License-Identifier: MIT
// Sole for three.js: a skinned character in, its pose with the feet on the ground out.
import type { Object3D, Vector3 } from "three";
import type { AnyGround, Character, Detection, Ground, Rig, RigDefinition, Settings, Sole } from "./sole.js";

export interface GroundOptions {
	/** What hits report, by mesh. default: none */
	surface?: (mesh: Object3D) => number;
	/** Which meshes count. default: all that are visible */
	filter?: (mesh: Object3D) => boolean;
}

/** The triangles of all meshes below an object, where they are now. */
export function groundFromObject(sole: Sole, object: Object3D, options?: GroundOptions): Ground;

/** What the skins below an object are bound to. */
export interface SkeletonOfObject {
	/** Whose space is character space; null: the world's. */
	space: Object3D | null;
	/** Parents first. */
	joints: Object3D[];
	/** As in the file, where the loader has kept that. */
	names: string[];
	parents: number[];
	/** Ten floats a joint, as in Skeleton. */
	bindPose: Float32Array;
	/** Four joints and weights a vertex. */
	skin: { positions: number[]; joints: number[]; weights: number[] };
}

/** @param space above all bones. default: what is right above them */
export function readSkeleton(object: Object3D, space?: Object3D): SkeletonOfObject;

/** The joints alone, in the same order. */
export function findSkeletonJoints(object: Object3D, space: Object3D): Object3D[];

export interface SkinOptions {
	/** Left out: nothing is met until it is set. */
	ground?: AnyGround;
	settings?: Settings;
	/** Left out: the legs are found. Joints by their names or as SoleSkin.joints has them. */
	definition?: Omit<RigDefinition, "parents" | "bindPose" | "names">;
	/** Out of the ground, world. default 0, 1, 0 */
	up?: Vector3;
	/** Height of the clip's own floor over the character's origin, in the space of the skeleton's topmost joint. */
	clipFloor?: number;
}

/** Places the feet of a skinned character. Make it while the character stands in its rest pose, before a clip plays. */
export class SoleSkin {
	/** @param object a SkinnedMesh, or whatever has some of one skeleton below it */
	constructor(sole: Sole, object: Object3D, options?: SkinOptions);
	/** What the rig's joints are. */
	readonly joints: readonly Object3D[];
	readonly rig: Rig;
	/** What was found out about the skeleton, where the legs had to be found. */
	readonly detection: Detection | null;
	/** Frame, weights and output for all that goes beyond update(). */
	readonly character: Character;
	ground: AnyGround | null;
	/** 0 leaves the pose as it is, 1 places the feet. */
	weight: number;
	/** After the mixer's own update and after the character was moved. @param timeStep seconds */
	update(timeStep: number): void;
	/** Puts the animated pose back, as if Sole had not been there. */
	restore(): void;
	/** The character was moved by a jump that is no motion. */
	reset(): void;
	dispose(): void;
}
