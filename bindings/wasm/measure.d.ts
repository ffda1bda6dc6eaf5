// SPDX-License-Identifier: MIT
// Motions, their contact labels and figures. SI units where the world's are metres.
import type { Character, Numbers, Rig, Vector } from "./sole.js";

export interface Motion {
	rig: Rig;
	/** Frames a second. */
	frameRate: number;
	/** Poses one after another. */
	poses: Numbers;
	/** 10 numbers a frame, character space to world. */
	roots: Numbers;
	/** default 0, 1, 0 */
	up?: Vector;
	clipFloor?: number;
}

export const ContactLabel: { readonly none: 0; readonly heel: 1; readonly toe: 2; readonly flat: 3 };

export interface LabelLimits {
	speedOn?: number;
	speedOff?: number;
	heightOn?: number;
	heightOff?: number;
	minimum?: number;
}

export interface Step {
	leg: number;
	strike: number;
	lift: number;
	heelDown: number;
	heelUp: number;
	toeDown: number;
	toeUp: number;
	place: number[];
	forward: number[];
}

/** What a game knows of its clip beforehand, frame by frame. */
export interface Steps {
	readonly count: number;
	/**
	 * Fills in contact and steps of a character's frame. The root is taken to go on as it goes: velocity along the
	 * floor and turnRate about up, as seen from itself, in character units and radians a second.
	 */
	tell(character: Character, now: { time: number; rate?: number; velocity: Vector; turnRate?: number }): void;
	dispose(): void;
}

export interface MeasureParts {
	motion: Motion;
	/** The same frames without foot placement. */
	reference?: Motion;
	/** Of the clip on flat ground. */
	labels: Uint8Array;
	terrain: { positions: Numbers; indices: Numbers };
	/** Frames left out at the start. */
	skip?: number;
}

export interface Stat {
	mean: number;
	p95: number;
	max: number;
}

export interface LegFigures {
	labelledFrames: number;
	penetration: Stat;
	verticalPenetration: Stat;
	hover: Stat;
	drift: Stat;
	contactShare: number;
	slide: number;
	stances: number;
	overExtended: number;
	swings: number;
	scuffs: number;
	clearance: number;
	kneeAccelerationRms: number;
	kneeAccelerationMax: number;
	largestJump: number;
}

export interface Figures {
	legs: LegFigures[];
	/** Over all legs. */
	all: LegFigures;
	pelvisJerk: number;
	pelvisLargestStep: number;
	deviation: number;
	pelvisOffsetRms: number;
	pelvisOffsetMax: number;
}
