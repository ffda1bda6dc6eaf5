// SPDX-License-Identifier: MIT
// Labels and figures of motions that are known exactly.
import assert from "node:assert/strict";
import { test } from "node:test";
import { ContactLabel } from "sole";
import { bipedDefinition, loadModule, poseBiped } from "./support.mjs";

const sole = await loadModule("sole");
const rig = sole.createRig(bipedDefinition());
const FRAMES = 120;
const floor = { positions: [-9, 0, -9, -9, 0, 9, 9, 0, 9, 9, 0, -9], indices: [0, 1, 2, 0, 2, 3] };
const near = (a, b, tolerance) => assert.ok(Math.abs(a - b) < tolerance, `${a} is not ${b}`);

/// A biped that stands at a height; from the middle on it slides.
function motionAt(height, speed = 0) {
	const poses = new Float32Array(FRAMES * 110);
	const roots = new Float32Array(FRAMES * 10);
	for (let i = 0; i < FRAMES; ++i) {
		poses.set(poseBiped(0.3), 110 * i);
		roots.set([0, height, (speed * Math.max(i - FRAMES / 2, 0)) / 60, 0, 0, 0, 1, 1, 1, 1], 10 * i);
	}
	return { rig, frameRate: 60, poses, roots };
}

test("feet that stand are labelled flat, and none where they slide", () => {
	assert.ok(sole.label(motionAt(0)).every((label) => label === ContactLabel.flat));
	const sliding = sole.label(motionAt(0, 2), { speedOn: 0.1, speedOff: 0.2, minimum: 0.02 });
	assert.equal(sliding.length, 2 * FRAMES);
	assert.equal(sliding[0], ContactLabel.flat);
	near(sole.findClipFloor(motionAt(0)), 0, 1e-3);
	assert.deepEqual(sole.findStrideVelocity(motionAt(0)).map(Math.abs), [0, 0, 0]);
	const steps = sole.findSteps(motionAt(0), sole.label(motionAt(0)));
	assert.equal(steps.length, 2);
	near(steps[0].place[2], 0.12, 0.02);
});

test("figures say how deep feet are, how high and how they slide", () => {
	const labels = sole.label(motionAt(0));
	const measure = (motion, reference) => sole.measure({ motion, reference, labels, terrain: floor });
	near(measure(motionAt(-0.02)).all.penetration.mean, 0.02, 1e-3);
	near(measure(motionAt(0.03)).legs[1].hover.mean, 0.03, 1e-3);
	near(measure(motionAt(0, 1)).all.slide, 0.5, 0.02);
	const figures = measure(motionAt(0), motionAt(0));
	assert.equal(figures.legs.length, 2);
	assert.equal(figures.legs[0].labelledFrames, FRAMES);
	near(figures.all.contactShare, 1, 1e-6);
	near(figures.deviation, 0, 1e-6);
	const bent = motionAt(0);
	for (let i = 0; i < FRAMES; ++i) {
		bent.poses.set(poseBiped(0.5), 110 * i);
	}
	near(measure(motionAt(0), bent).pelvisOffsetMax, 0.9 * (Math.cos(0.15) - Math.cos(0.25)), 1e-4);
	assert.ok(measure(motionAt(0), bent).deviation > 0.05);
});

test("what can't be measured is refused with a sentence", () => {
	const motion = motionAt(0);
	const labels = sole.label(motion);
	assert.throws(() => sole.label({ ...motion, poses: new Float32Array(3) }), /motion.poses: has 3 numbers: give 13200/);
	assert.throws(() => sole.label({ ...motion, roots: [] }), /count of frames, is 0|: is 0/);
	assert.throws(() => sole.label({ ...motion, frameRate: NaN }), /motion.frameRate: is NaN/);
	assert.throws(() => sole.label({ ...motion, rig: undefined }), /motion.rig: is none/);
	assert.throws(() => sole.measure({ motion, labels: [1], terrain: floor }), /labels: has 1 numbers: give 240/);
	const bad = { ...floor, indices: [0, 1, 9] };
	assert.throws(() => sole.measure({ motion, labels, terrain: bad }), Error);
	assert.throws(() => sole.measure({ motion, labels, terrain: floor, skip: 500 }), /skip: is 500/);
	motion.poses.fill(NaN);
	assert.throws(() => sole.measure({ motion, labels, terrain: floor }), Error);
});
