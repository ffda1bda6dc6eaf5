// SPDX-License-Identifier: MIT
// Characters frame by frame: probes, casts, output, state, and that bad input and long runs do no harm.
import assert from "node:assert/strict";
import { test } from "node:test";
import { setFlagsFromString } from "node:v8";
import { runInNewContext } from "node:vm";
import { LegFlags } from "sole";
import { bipedDefinition, hash, heightOfStairs, loadModule, poseBiped, stairs, walkOn } from "./support.mjs";

const sole = await loadModule("sole");
const rig = sole.createRig(bipedDefinition());
const ground = sole.createGround({ meshes: [stairs()] });

function stand(character, pose = poseBiped(0.3)) {
	character.pose = pose;
	character.frame.timeStep = 1 / 60;
	return character;
}

test("a frame goes from pose to pose", () => {
	const character = stand(sole.createCharacter(rig));
	const count = character.gather();
	assert.equal(character.probeCount, count);
	const asked = character.probes.slice(0, count).filter(({ length }) => length > 0);
	assert.ok(asked.length >= 10, `${asked.length}`);
	const { start, direction, length, radius, mask } = asked.find(({ leg, index }) => leg === 1 && index === 2);
	assert.deepEqual([direction[1], radius, mask], [-1, 0, 0xffffffff]);
	assert.ok(start[1] > 0.2 && length > 0.5);
	assert.ok(character.hits.slice(0, count).every(({ hit }) => hit === false));
	for (let i = 0; i < 60; ++i) {
		character.update(ground);
	}
	for (const { flags, ankle, plantWeight, planeNormal, error, rotations } of character.output.legs) {
		assert.ok(flags & LegFlags.planted);
		assert.equal(flags & LegFlags.noGround, 0);
		assert.ok(Math.abs(ankle[1] - 0.08) < 0.005, `${ankle}`);
		assert.ok(plantWeight > 0.9 && planeNormal[1] > 0.999 && error < 0.01);
		assert.equal(rotations.length, 28);
	}
	// The thigh of the placed pose is that of the output.
	assert.deepEqual(character.placed.subarray(33, 37), character.output.legs[0].rotations.subarray(0, 4));
	assert.notDeepEqual(character.placed, character.pose);
	character.dispose();
});

test("weight 0 and ground that is not there leave the pose", () => {
	const character = stand(sole.createCharacter(rig));
	character.frame.weight = 0;
	character.update(ground);
	const same = () => character.placed.every((value, i) => Math.abs(value - character.pose[i]) < 1e-6);
	assert.ok(same());
	character.frame.weight = 1;
	character.reset();
	character.update(() => {});
	assert.ok(character.output.legs.every(({ flags }) => flags & LegFlags.noGround));
	assert.ok(same());
	character.dispose();
});

test("own casts give the same as Sole's ground", () => {
	const [own, other] = [sole.createCharacter(rig), sole.createCharacter(rig)];
	const normal = { x: 0, y: 1, z: 0 };
	const cast = (probe, hit) => {
		const height = heightOfStairs(probe.start[2]);
		if (probe.start[1] >= height && probe.start[1] - height <= probe.length) {
			hit.put([probe.start[0], height, probe.start[2]], normal, 3);
		}
	};
	for (let i = 0; i < 150; ++i) {
		walkOn(own, cast, i);
		walkOn(other, ground, i);
		assert.ok(own.output.legs.every((leg, k) => Math.abs(leg.ankle[1] - other.output.legs[k].ankle[1]) < 1e-3), `${i}`);
	}
	assert.ok(own.hits.slice(0, own.probeCount).some(({ surface, hit }) => hit && surface === 3));
});

test("state is restored to the bit", () => {
	const character = sole.createCharacter(rig);
	const play = (from, to) => {
		for (let i = from; i < to; ++i) {
			walkOn(character, ground, i);
		}
		return hash(character.placed, character.snapshot());
	};
	play(0, 60);
	const saved = character.snapshot();
	const first = play(60, 120);
	character.restore(saved);
	assert.equal(play(60, 120), first);
	assert.notEqual(play(60, 120), first);
	assert.throws(() => character.restore(saved.subarray(1)), /state: has \d+ numbers: give \d+/);
	assert.throws(() => character.restore(null), /state: is no array/);
	// Bytes that are no state count as a new start.
	character.restore(new Uint8Array(saved.length).fill(0x7f));
	walkOn(character, ground, 0);
	assert.ok(character.placed.every(Number.isFinite));
	character.dispose();
});

test("poses that are not finite are flagged and do no harm", () => {
	const [character, other] = [sole.createCharacter(rig), sole.createCharacter(rig)];
	for (let i = 0; i < 30; ++i) {
		walkOn(character, ground, i);
		walkOn(other, ground, i);
	}
	character.pose.fill(NaN);
	character.update(ground);
	assert.ok(character.output.legs.every(({ flags }) => flags & LegFlags.badInput));
	assert.ok(character.output.legs.every(({ rotations, ankle }) => [...rotations, ...ankle].every(Number.isFinite)));
	character.frame.root.fill(Infinity);
	character.update(ground);
	assert.ok(character.output.legs.every(({ flags }) => flags & LegFlags.badInput));
	for (let i = 30; i < 120; ++i) {
		walkOn(character, ground, i);
		walkOn(other, ground, i);
	}
	assert.ok(character.placed.every((value, i) => Math.abs(value - other.placed[i]) < 0.02));
	character.hits.forEach((hit) => hit.put([NaN, NaN, NaN], [Infinity, 0, 0]));
	character.solve();
	assert.ok(character.placed.every(Number.isFinite));
});

test("wrong sizes and what was disposed of are refused", () => {
	const character = sole.createCharacter(rig);
	assert.throws(() => (character.pose = new Float32Array(12)), /pose: has 12 numbers: give 110/);
	assert.throws(() => (character.pose = "pose"), /pose: is no array/);
	assert.throws(() => (character.secondPose = [1]), /secondPose: has 1 numbers/);
	assert.throws(() => (character.frame.root = [1, 2, 3]), /root: has 3 numbers: give 10/);
	assert.throws(() => character.cast(null), /cast: is no ground/);
	assert.throws(() => character.setSupports(Array(17).fill({})), /supports.length: is 17/);
	assert.throws(() => character.draw(), /load it with { debug: true }/);
	const settings = sole.createSettings();
	character.settings = settings;
	settings.dispose();
	assert.throws(() => character.update(ground), /settings were disposed of/);
	assert.throws(() => (character.settings = settings), /were disposed of/);
	const gone = sole.createGround({ meshes: [stairs()] });
	gone.dispose();
	character.settings = sole.createSettings();
	character.gather();
	assert.throws(() => character.cast(gone), /disposed of/);
	character.dispose();
	assert.throws(() => character.gather(), /disposed of/);
	assert.throws(() => sole.createCharacter(null), /has no rig/);
	const old = sole.createRig(bipedDefinition());
	old.dispose();
	assert.throws(() => sole.createCharacter(old), /has no rig/);
});

test("what is optional counts", () => {
	const run = (change) => {
		const character = sole.createCharacter(rig);
		change(character);
		for (let i = 0; i < 100; ++i) {
			walkOn(character, ground, i);
		}
		const sum = hash(character.placed);
		character.dispose();
		return sum;
	};
	const usual = run(() => {});
	const changes = {
		legWeight: (c) => (c.legWeight[0] = 0.5),
		positionWeight: (c) => (c.positionWeight[1] = 0.5),
		rotationWeight: (c) => (c.rotationWeight[1] = 0.5),
		contact: (c) => c.contact.set([1, 1, 0, 0]),
		clipFloor: (c) => (c.frame.clipFloor = 0.05),
		up: (c) => (c.frame.up = [0.1, 0.99, 0]),
		second: (c) => {
			c.settings.set("target.secondFrom", 0);
			c.settings.set("target.secondFull", 0.05);
			c.secondPose = poseBiped(1.4);
		},
		settings: (c) => c.settings.set("pelvis.halfLife", 0.5),
	};
	for (const [name, change] of Object.entries(changes)) {
		assert.notEqual(run(change), usual, name);
	}
	assert.equal(run((c) => (c.secondPose = poseBiped(1.4)) && (c.secondPose = null)), usual);
	assert.equal(run(() => {}), usual);
});

test("feet ride on bodies that move", () => {
	const lift = sole.createGround({ planes: [{ normal: [0, 1, 0], offset: 0, surface: 9 }] });
	const pieces = sole.createPieces([{ ground: lift, surface: 9 }]);
	const character = stand(sole.createCharacter(rig));
	for (let i = 0; i < 120; ++i) {
		const [x, y] = [0.002 * i, 0.001 * i];
		pieces.move(0, { translation: [x, y, 0] });
		character.frame.root = [x, y, 0, 0, 0, 0, 1, 1, 1, 1];
		character.setSupports([{ surface: 9, translation: [x, y, 0], rotation: [0, 0, 0, 1] }]);
		character.update(pieces);
	}
	for (const [i, leg] of character.output.legs.entries()) {
		assert.ok(leg.flags & LegFlags.planted);
		assert.ok(Math.abs(leg.ankle[0] - 0.238 - (i === 0 ? 0.09 : -0.09)) < 0.01, `${leg.ankle}`);
		assert.ok(Math.abs(leg.ankle[1] - 0.119 - 0.08) < 0.01, `${leg.ankle}`);
	}
	pieces.dispose();
	lift.dispose();
});

test("10,000 frames take no memory", () => {
	setFlagsFromString("--expose_gc");
	const collect = runInNewContext("gc");
	const character = sole.createCharacter(rig);
	const play = (count) => {
		for (let i = 0; i < count; ++i) {
			character.frame.root[2] = (i % 600) / 60;
			character.frame.timeStep = 1 / 60;
			character.update(ground);
		}
		collect();
		return [sole.memorySize, process.memoryUsage().heapUsed];
	};
	character.pose = poseBiped(0.3);
	const [size, heap] = play(2000);
	const [sizeAfter, heapAfter] = play(10000);
	assert.equal(sizeAfter, size);
	assert.ok(heapAfter - heap < 200_000, `${heap} to ${heapAfter}`);
});

test("views follow when the memory grows", async () => {
	const own = await loadModule("sole");
	const character = stand(own.createCharacter(own.createRig(bipedDefinition())));
	const before = own.memorySize;
	const { pose } = character;
	own.createGround({ heightFields: [{ heights: new Float32Array(250000), countX: 500, countZ: 500, cellX: 1, cellZ: 1 }] });
	assert.ok(own.memorySize > before);
	assert.equal(pose.length, 0);
	assert.deepEqual(character.pose, poseBiped(0.3));
	const flat = own.createGround({ planes: [{ normal: [0, 1, 0], offset: 0 }] });
	character.update(flat);
	assert.ok(character.output.legs[0].planeNormal[1] > 0.99);
});

test("a frame is drawn, as a list", async () => {
	const own = await loadModule("sole-debug");
	const character = stand(own.createCharacter(own.createRig(bipedDefinition())));
	const stand2 = own.createGround({ meshes: [stairs()] });
	character.update(stand2);
	const marks = character.draw();
	assert.deepEqual(new Set(marks.map(({ kind }) => kind)), new Set(["line", "arrow", "circle", "sphere", "text"]));
	for (const { color, category, a, b, kind, text } of marks) {
		assert.ok(color <= 0xffffff && own.drawInfos.some((info) => info.category === category));
		assert.ok([...a, ...b].every(Number.isFinite));
		assert.equal(kind === "text", text !== "");
	}
	const [hits] = own.drawInfos.filter(({ name }) => name.includes("hit"));
	const some = character.draw(hits.category);
	assert.ok(some.length > 0 && some.length < marks.length);
	assert.ok(some.every(({ category }) => category === hits.category));
	assert.deepEqual(character.draw(), marks);
	assert.deepEqual(character.draw(0), []);
	// Drawn is the frame as it went, with what was remembered then.
	for (let i = 0; i < 100; ++i) {
		walkOn(character, stand2, i);
	}
	const [bones] = own.drawInfos.filter(({ name }) => name === "placed legs");
	const drawn = character.draw(bones.category).flatMap(({ a, b }) => [a, b]);
	for (const { ankle } of character.output.legs) {
		assert.ok(drawn.some((place) => place.every((x, i) => Math.abs(x - ankle[i]) < 1e-5)), `${ankle}`);
	}
});
