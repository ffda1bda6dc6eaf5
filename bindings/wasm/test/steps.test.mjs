// SPDX-License-Identifier: MIT
// What a clip tells of its steps, and traces that are recorded here.
import assert from "node:assert/strict";
import { writeFileSync } from "node:fs";
import { test } from "node:test";
import { bipedDefinition, heightOfStairs, loadModule, native, poseBiped, stairs, workFolder } from "./support.mjs";

const sole = await loadModule("sole-debug-simd");
const step = { leg: 0, strike: 0.1, lift: 0.7, heelDown: 0.1, heelUp: 0.5, toeDown: 0.2, toeUp: 0.7, place: [0.1, 0, 0.2],
	forward: [0, 0, 1] };

test("contact and steps are told as the clip has them, in the world's time", () => {
	const rig = sole.createRig(bipedDefinition());
	const character = sole.createCharacter(rig, { settings: sole.createSettings() });
	const steps = sole.createSteps([step], { duration: 1, loops: true });
	assert.equal(steps.count, 1);
	steps.tell(character, { time: 0.15, velocity: [0, 0, 1] });
	assert.deepEqual([...character.contact.subarray(0, 2)], [1, 0]);
	// In flight, played at double speed: until the strike of the next round is half as long, and the root goes on.
	steps.tell(character, { time: 0.9, rate: 2, velocity: [0, 0, 2] });
	assert.deepEqual([...character.contact.subarray(0, 2)], [0, 0]);
	const [since, until, x, , z] = character.steps;
	assert.ok(Math.abs(since - 0.1) < 1e-6 && Math.abs(until - 0.1) < 1e-6);
	assert.ok(Math.abs(x - 0.1) < 1e-6 && Math.abs(z - (0.2 + 2 * 0.1)) < 1e-6);
	// A clip that stands still foretells nothing.
	steps.tell(character, { time: 0.9, rate: 0, velocity: [0, 0, 0] });
	assert.ok(character.steps[1] < 0);
	character.forgetSteps();
	assert.ok(character.contact.every((number) => number === -1));
	steps.dispose();
	assert.throws(() => steps.tell(character, { time: 0, velocity: [0, 0, 0] }), /disposed/);
	character.dispose();
	rig.dispose();
});

test("a trace that is recorded here is replayed to the bit, here and by the native program", () => {
	const rig = sole.createRig(bipedDefinition());
	const character = sole.createCharacter(rig, { settings: sole.createSettings() });
	const ground = sole.createGround({ meshes: [stairs()] });
	const steps = sole.createSteps([step, { ...step, leg: 1, strike: 0.6, lift: 1.2, heelDown: 0.6, heelUp: 1, toeDown: 0.7,
		toeUp: 1.2 }], { duration: 1, loops: true });
	const tracer = sole.createTracer(character);
	for (let i = 0; i < 120; ++i) {
		const t = i / 60;
		const swing = 0.4 * Math.sin(5 * t);
		character.pose = poseBiped(0.3, [swing, -swing]);
		character.frame.root = [0, heightOfStairs(t), t, 0, 0, 0, 1, 1, 1, 1];
		character.frame.timeStep = 1 / 60;
		steps.tell(character, { time: t % 1, velocity: [0, 0, 1] });
		character.gather();
		character.cast(ground);
		tracer.solve();
	}
	const bytes = tracer.finish();
	tracer.dispose();
	const report = sole.replayTrace(bytes);
	assert.equal(report.frameCount, 120);
	assert.equal(report.differentFrames, 0);
	writeFileSync(`${workFolder}/recorded.trace`, bytes);
	assert.equal(JSON.parse(native("replay", "recorded.trace", "--json")).frames, 120);
	const short = sole.createTracer(character, 4096);
	for (let i = 0; i < 20; ++i) {
		short.solve();
	}
	assert.throws(() => short.finish(), /capacity/);
	short.dispose();
});
