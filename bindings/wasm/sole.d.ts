// SPDX-License-Identifier: MIT
// Sole for JavaScript. Lengths are the world's unless said otherwise, angles radians, quaternions x, y, z, w. Everything
// that is made has to be disposed of; arrays that are called views are the module's own memory and show what is there
// now: ask for them anew after something was created, since memory that grows moves them.

import type { Figures, LabelLimits, MeasureParts, Motion, Step, Steps } from "./measure.js";

export * from "./measure.js";

export type Vector = ArrayLike<number> | { readonly x: number; readonly y: number; readonly z: number };
export type Numbers = readonly number[] | Float32Array | Float64Array | Int8Array | Int16Array | Int32Array | Uint8Array
	| Uint16Array | Uint32Array;

export interface LoadOptions {
	/** Where a module is. Without url and bytes: the one beside sole.js that fits. */
	url?: string | URL;
	/** A module, compiled or not. */
	bytes?: BufferSource | WebAssembly.Module;
	/** default: whether the engine has it. */
	simd?: boolean;
	/** The module that draws and replays traces besides. default false */
	debug?: boolean;
}

export function loadSole(options?: LoadOptions): Promise<Sole>;
/** Whether this engine has SIMD. */
export function hasSimd(): boolean;

export interface Sole {
	readonly version: string;
	readonly simd: boolean;
	readonly debug: boolean;
	/** How much memory the module has, bytes. */
	readonly memorySize: number;
	/** Every setting with its unit, range, default and one sentence. */
	readonly settingInfos: readonly SettingInfo[];
	createSettings(json?: SettingsJSON | string): Settings;
	createRig(definition: RigDefinition): Rig;
	/** Finds the legs of a skeleton. Fails with a sentence where there are none. */
	detectRig(skeleton: Skeleton): Detection;
	createCharacter(rig: Rig, options?: CharacterOptions): Character;
	createGround(parts: GroundParts): Ground;
	createPieces(pieces: readonly { ground: Ground | null; surface?: number }[]): Pieces;

	/** Height of the floor that a clip walks on, over the character's origin. */
	findClipFloor(motion: Motion): number;
	/** Speed over the ground that an in-place clip pretends. */
	findStrideVelocity(motion: Motion): number[];
	/** A ContactLabel per frame and leg, of a motion over flat ground. */
	label(motion: Motion, limits?: LabelLimits): Uint8Array;
	/** The steps of a motion over flat ground; of one that loops give three rounds. */
	findSteps(motion: Motion, labels: Uint8Array, loops?: boolean): Step[];
	/** Steps of a clip, for Steps.tell(). */
	createSteps(steps: readonly Step[], clip: { duration: number; loops?: boolean }): Steps;
	measure(parts: MeasureParts): Figures;

	/** What Character.draw() shows. Debug module only, as are the next two. */
	readonly drawInfos: readonly { category: number; name: string; text: string }[];
	/** @param capacity bytes of the longest trace. default 16 MiB */
	createTracer(character: Character, capacity?: number): Tracer;
	replayTrace(bytes: Uint8Array): TraceReport;
}

// ------------------------------------------------------------------------------------------------------ settings

export interface SettingInfo {
	/** "stage.field" */
	readonly name: string;
	/** "L" (leg length), "s", "rad", "L/s", "" for shares */
	readonly unit: string;
	readonly kind: "number" | "choice" | "mask";
	readonly minimum: number;
	readonly maximum: number;
	readonly default: number;
	readonly text: string;
}

/** The same JSON that the program sole reads and writes. */
export type SettingsJSON = { [stage: string]: { [field: string]: number } };

export interface Settings {
	get(name: string): number;
	/** Refuses names that are none and values out of range. */
	set(name: string, value: number): void;
	reset(): void;
	toJSON(): SettingsJSON;
	/** All of it or, where something is wrong, nothing. */
	fromJSON(json: SettingsJSON | string): Settings;
	dispose(): void;
}

// ----------------------------------------------------------------------------------------------------------- rigs

/** Per joint translation, rotation x y z w and scale: 10 numbers, parent-local. */
export type Pose = Numbers;
/** An index or, where the definition has names, one of them. */
export type Joint = number | string;

export interface SolePoints {
	heel: Vector;
	/** Under the toe joint: where the foot bends and pivots. */
	ball: Vector;
	toe: Vector;
	/** Edge on the ball line towards the other leg. */
	inner: Vector;
	outer: Vector;
}

export interface LegDefinition {
	name?: string;
	side?: "left" | "right" | "center";
	/** Hip, (middle joints), knee, ankle. */
	joints: readonly Joint[];
	/** The first is the one at the ball. */
	toes?: readonly Joint[];
	/** A foot that is no descendant of the ankle. */
	detachedFoot?: Joint;
	/** Character space, bind pose; where the last bone has no joint at its end. */
	virtualAnkle?: Vector | undefined;
	/** The axis about which the knee bends. Zero or left out: from the bend of the bind pose. */
	hinge?: Vector;
	/** Character space, bind pose. */
	sole: SolePoints;
	ankleLimits?: {
		dorsiflexion?: number;
		plantarflexion?: number;
		inversion?: number;
		eversion?: number;
		twist?: number;
	};
}

export interface RigDefinition {
	names?: readonly string[] | undefined;
	/** Per joint its parent or -1. */
	parents: Numbers;
	bindPose: Pose;
	/** The joint that carries the body and all hips. */
	pelvis: Joint;
	/** Character space. default 0, 1, 0 */
	up?: Vector;
	/** default 0, 0, 1 */
	forward?: Vector;
	legs: readonly LegDefinition[];
}

export interface Skeleton {
	names?: readonly string[];
	parents: Numbers;
	bindPose: Pose;
	/** Left out: to be found. */
	up?: Vector;
	forward?: Vector;
	/** Where a file says which joint is what. */
	roles?: { [role: string]: Joint };
	/** Vertices in the bind pose, character space; four joints and weights each. */
	skin?: { positions: Numbers; joints: Numbers; weights: Numbers };
	/** Poses of clips, one after another: they tell which way knees bend. */
	samplePoses?: Numbers;
}

export interface Finding {
	severity: "info" | "warning" | "error";
	leg: number;
	joint: number;
	where: string;
	what: string;
	mend: string;
}

export interface Detection {
	rig: Rig;
	findings: Finding[];
	legLength: number;
	/** What would make the character human sized. */
	suggestedScale: number;
}

export interface Rig {
	/** As it was given or found; plain data. */
	readonly definition: RigDefinition;
	readonly jointCount: number;
	readonly legCount: number;
	readonly legNames: readonly string[];
	/** Hip to ankle along the bones: the L of the settings. */
	legLength(leg: number): number;
	dispose(): void;
}

// ----------------------------------------------------------------------------------------------------- characters

export interface CharacterOptions {
	/** Shared with others. Left out: settings of its own. */
	settings?: Settings;
	/** Most bodies that setSupports() takes. default 16 */
	maxSupports?: number;
}

export interface Frame {
	/** View. Character space to world: translation, rotation, scale. */
	get root(): Float32Array;
	set root(numbers: Numbers);
	/** View. Out of the ground. All zero: the rig's up carried by the root. */
	get up(): Float32Array;
	set up(numbers: Numbers);
	/** View. Origin of this world in the host's own large one. */
	get worldOrigin(): Float64Array;
	set worldOrigin(numbers: Numbers);
	/** Seconds since the last frame. */
	timeStep: number;
	/** 0 leaves the pose as it is, 1 places the feet. */
	weight: number;
	/** Height of the clip's own floor over the character's origin. */
	clipFloor: number;
	/** The character was moved by a jump that is no motion. */
	teleport: boolean;
}

export interface Probe {
	/** View. */
	readonly start: Float32Array;
	/** View, unit. */
	readonly direction: Float32Array;
	/** 0: need not be cast. */
	readonly length: number;
	/** 0: a ray. */
	readonly radius: number;
	readonly mask: number;
	readonly leg: number;
	readonly index: number;
}

export interface Hit {
	/** Something was met at point; normal is the face's, against the probe. */
	put(point: Vector, normal: Vector, surface?: number): void;
	/** View. */
	readonly point: Float32Array;
	/** View. */
	readonly normal: Float32Array;
	/** View. Of the surface at the point. */
	readonly velocity: Float32Array;
	/** View. Start of the probe that this answers. */
	readonly asked: Float32Array;
	hit: boolean;
	startedInside: boolean;
	layer: number;
	/** Whatever the host calls the body, or -1. */
	surface: number;
	/** Of a loose thing. 0: not loose. */
	size: number;
}

/** Why a leg is as it is: bits of LegOutput.flags. */
export const LegFlags: {
	readonly planted: number;
	readonly noGround: number;
	readonly tooSteep: number;
	readonly onEdge: number;
	readonly softened: number;
	readonly outOfReach: number;
	readonly heelLifted: number;
	readonly ankleClamped: number;
	readonly folded: number;
	readonly released: number;
	readonly captured: number;
	readonly degenerate: number;
	readonly badInput: number;
	readonly inside: number;
	readonly planned: number;
	readonly tooLow: number;
	readonly tooHigh: number;
	readonly asleep: number;
};

/** The new pose of one leg and what is worth knowing about it. Arrays are views. */
export interface LegOutput {
	readonly flags: number;
	/** New parent-local rotations of the leg's joints, hip first, 4 numbers each. */
	readonly rotations: Float32Array;
	readonly toeRotation: Float32Array;
	readonly footTranslation: Float32Array;
	readonly footRotation: Float32Array;
	readonly ankleTarget: Float32Array;
	readonly ankle: Float32Array;
	readonly planePoint: Float32Array;
	readonly planeNormal: Float32Array;
	readonly stretch: number;
	/** How far the ankle is from where it was wanted. */
	readonly error: number;
	readonly extension: number;
	readonly heightDemand: number;
	readonly plantWeight: number;
	readonly confidence: number;
}

export interface Output {
	readonly legs: readonly LegOutput[];
	readonly pelvisOffset: Float32Array;
	readonly pelvisTranslation: Float32Array;
	readonly bodyGradient: Float32Array;
	/** The turn that leans the trunk, before the animated rotation of the joint that carries it, parent-local. */
	readonly lean: Float32Array;
	readonly capsuleShorter: number;
	readonly capsuleOffset: number;
	readonly secondWeight: number;
	/** How far the ground under the body lies over the root's floor: move the root by it to keep it on the ground. */
	readonly groundOffset: number;
	/** For how long no probe has met anything, s. */
	readonly unmetTime: number;
	/** What the character is doing: 0 stands, 1 moves, 2 runs, 3 is in the air. */
	readonly activity: number;
	/** How much of the placement the settings of activity leave for that. */
	readonly strength: number;
}

export interface Mark {
	kind: "line" | "arrow" | "circle" | "sphere" | "text";
	/** 0xRRGGBB */
	color: number;
	category: number;
	/** Start, middle or place. */
	a: number[];
	/** End of lines and arrows, normal of circles. */
	b: number[];
	radius: number;
	text: string;
}

export type CastFunction = (probe: Probe, hit: Hit) => void;
export type AnyGround = Ground | Pieces | CastFunction;

export interface Character {
	readonly rig: Rig;
	settings: Settings;
	readonly frame: Frame;
	/** View. The animated pose, to be written every frame; never what was placed. */
	get pose(): Float32Array;
	set pose(numbers: Pose);
	/** View. What came of it. */
	readonly placed: Float32Array;
	/** View, or null: none is used. For ground that is much higher under one foot. */
	get secondPose(): Float32Array | null;
	set secondPose(numbers: Pose | null);
	/** Views, a number per leg, 1 where nobody writes them. */
	readonly legWeight: Float32Array;
	readonly positionWeight: Float32Array;
	readonly rotationWeight: Float32Array;
	/** View, heel and toe per leg, 0 free to 1 planted; below zero: not known. */
	readonly contact: Float32Array;
	/** View, 11 numbers per leg: since, until, place, forward, travel. since below zero: not known. */
	readonly steps: Float32Array;
	/** Nothing is known of contact and steps. */
	forgetSteps(): void;
	/** Bodies that move and that feet may stand on. */
	setSupports(supports: readonly { surface: number; translation: Vector; rotation: Numbers }[]): void;

	/** What to ask of the ground. @returns how many of probes are filled */
	gather(): number;
	readonly probeCount: number;
	readonly probes: readonly Probe[];
	/** The answers, hits[i] to probes[i]. gather() makes misses of them. */
	readonly hits: readonly Hit[];
	cast(ground: AnyGround): void;
	solve(): void;
	/** gather, cast and solve. */
	update(ground: AnyGround): void;
	readonly output: Output;

	/** All that is remembered of earlier frames. */
	snapshot(): Uint8Array;
	restore(state: Uint8Array): void;
	reset(): void;

	/** What the last frame saw, decided and did. Debug module only. */
	draw(mask?: number): Mark[];
	dispose(): void;
}

// --------------------------------------------------------------------------------------------------------- ground

export interface GroundMesh {
	/** x, y, z a vertex, world. */
	positions: Numbers;
	/** Three a triangle. Left out: vertices in their order. */
	indices?: Numbers;
	triangleLayers?: Numbers;
	/** default 1 */
	layer?: number;
	/** What hits report. default -1 */
	surface?: number;
	/** Also meet back faces. default false */
	twoSided?: boolean;
}

export interface HeightField {
	/** countX * countZ, row by row along X; NaN is a hole. */
	heights: Numbers;
	countX: number;
	countZ: number;
	cellX: number;
	cellZ: number;
	origin?: Vector;
	axisX?: Vector;
	axisZ?: Vector;
	up?: Vector;
	layer?: number;
	surface?: number;
}

export interface GroundPlane {
	normal: Vector;
	offset: number;
	layer?: number;
	surface?: number;
}

export interface GroundParts {
	meshes?: readonly GroundMesh[];
	heightFields?: readonly HeightField[];
	planes?: readonly GroundPlane[];
}

export interface CastQuery {
	start: Vector;
	/** Unit. */
	direction: Vector;
	length: number;
	/** 0 or left out: a ray, else a sphere. */
	radius?: number;
	mask?: number;
}

export interface CastHit {
	startedInside: boolean;
	layer: number;
	surface: number;
	point: number[];
	normal: number[];
	velocity: number[];
}

export interface Ground {
	readonly triangleCount: number;
	readonly bounds: { lower: number[]; upper: number[] };
	cast(query: CastQuery): CastHit | null;
	dispose(): void;
}

/** Grounds that move, each as a whole: a lift, a turntable. The grounds have to live as long. */
export interface Pieces {
	readonly count: number;
	move(index: number, motion: {
		translation?: Vector;
		rotation?: Numbers | { x: number; y: number; z: number; w: number };
		velocity?: Vector;
		spin?: Vector;
		there?: boolean;
	}): void;
	cast(query: CastQuery): CastHit | null;
	dispose(): void;
}

// --------------------------------------------------------------------------------------------------------- traces

/** Records one character from now on. */
export interface Tracer {
	/** Instead of the character's own solve(): the same, recorded. */
	solve(): void;
	/** The whole trace; nothing can be recorded after it. */
	finish(): Uint8Array;
	dispose(): void;
}

export interface TraceReport {
	frameCount: number;
	legCount: number;
	differentFrames: number;
	first: { frame: number; leg: number; field: string; component: number; recorded: number; replayed: number } | null;
}
