// SPDX-License-Identifier: MIT
// What the page alone loads: the systems that Sole is compared with, and the build that tells when stages have ended.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { loadMethods, methodNames } from "../../../build/wasm/page/methods.js";
import { loadStageMeter } from "../../../build/wasm/page/stages.js";
import { bipedDefinition, bipedSkeleton, hash, heightOfStairs, loadModule, packageFolder, stairs, walkOn } from "./support.mjs";

const bytes = (name) => readFileSync(`${packageFolder}/page/${name}.wasm`);
const methods = await loadMethods({ bytes: bytes("sole-methods") });
const definition = { ...bipedDefinition(), ...bipedSkeleton() };
const rig = methods.createRig(definition);
const ground = methods.createGround({ meshes: [stairs()] });

test("the module of the methods needs nothing and is small", () => {
	const module = new WebAssembly.Module(bytes("sole-methods"));
	assert.deepEqual(WebAssembly.Module.imports(module), []);
	assert.ok(bytes("sole-methods").length < 120000, `${bytes("sole-methods").length}`);
});

test("every method places feet on stairs, each in its own way", () => {
	const seen = new Set();
	for (const name of methodNames) {
		const character = methods.createCharacter(rig, name);
		let changed = 0;
		for (let i = 0; i < 180; ++i) {
			// One of them does its work while the character stands.
			walkOn(character, ground, Math.min(i, 120));
			assert.ok(character.placed.every(Number.isFinite), name);
			changed += character.placed.some((value, k) => Math.abs(value - character.pose[k]) > 1e-3) ? 1 : 0;
		}
		assert.ok(changed > 40, `${name} ${changed}`);
		seen.add(hash(character.placed));
		character.dispose();
	}
	assert.equal(seen.size, methodNames.length);
});

test("who stands on a step is brought up to it by ozz, and begins anew after a jump", () => {
	const character = methods.createCharacter(rig, "ozz");
	const stand = (z) => {
		character.frame.teleport = true;
		character.frame.root = [0, heightOfStairs(z) - 0.05, z, 0, 0, 0, 1, 1, 1, 1];
		character.frame.timeStep = 1 / 60;
		character.pose = bipedSkeleton().bindPose;
		character.gather();
		character.cast(ground);
		character.solve();
		return character.output.pelvisOffset[1];
	};
	const [first, again] = [stand(0), stand(0)];
	assert.ok(Math.abs(first - 0.05) < 0.02, `${first}`);
	assert.equal(again, first);
	character.dispose();
});

test("every method has settings of its own, fitted to the character, which count", () => {
	for (const name of methodNames) {
		const walked = (change) => {
			const character = methods.createCharacter(rig, name);
			change?.(character);
			for (let i = 0; i < 150; ++i) {
				walkOn(character, ground, Math.min(i, 100));
			}
			const result = hash(character.placed);
			const infos = character.ownInfos;
			character.dispose();
			return { result, infos };
		};
		const before = walked();
		assert.ok(before.infos.length >= 10 && before.infos.every(({ text, name: own }) => text.endsWith(".") && own.startsWith(`${name}.`)));
		assert.ok(before.infos.every((info) => info.minimum <= info.default && info.default <= info.maximum));
		const off = { homebrew: "globalWeight", iksetting: "enableFeetIk", effector: "enableAnimationIk", ozz: "weight" }[name];
		const after = walked((character) => character.setOwn(`${name}.${off}`, 0));
		assert.notEqual(after.result, before.result, name);
		assert.equal(after.infos.find((info) => info.name === `${name}.${off}`).default, 0);
		assert.throws(() => walked((character) => character.setOwn("magic", 0)), /magic: is no setting/);
		assert.throws(() => walked((character) => character.setOwn(`${name}.${off}`, NaN)), /is not a number/);
	}
});

test("every method draws its frames, and only what is switched on", () => {
	for (const name of methodNames) {
		const character = methods.createCharacter(rig, name);
		for (let i = 0; i < 60; ++i) {
			walkOn(character, ground, Math.min(i, 30));
		}
		const all = character.draw();
		assert.ok(all.length > 15 && all.every((mark) => [...mark.a, ...mark.b, mark.radius].every(Number.isFinite)), name);
		assert.ok(new Set(all.map(({ kind }) => kind)).size === 5, name);
		const flags = character.draw(1 << 12);
		assert.deepEqual(flags.map(({ kind }) => kind), ["text", "text"]);
		character.dispose();
	}
});

test("a method that is none is refused with a sentence", () => {
	assert.throws(() => methods.createCharacter(rig, "magic"), /there is no 'magic'.*homebrew/);
});

test("stages are measured in the order in which they run, and change no bit", async () => {
	const sole = await loadModule("sole-debug");
	const character = sole.createCharacter(sole.createRig(definition));
	const tracer = sole.createTracer(character);
	const own = sole.createGround({ meshes: [stairs()] });
	for (let i = 0; i < 60; ++i) {
		walkOn(character, own, i, tracer);
	}
	const meter = await loadStageMeter({ bytes: bytes("sole-stages") });
	const { stages, differentFrames } = meter.measure(tracer.finish(), 20);
	assert.equal(differentFrames, 0);
	assert.deepEqual(stages.map(({ name }) => name),
		["sense", "support", "contact", "foothold", "lock", "target", "pelvis", "leg and ankle", "output"]);
	const sum = stages.reduce((total, { cost }) => total + cost, 0);
	assert.ok(stages.every(({ cost }) => cost > 0) && sum < 2000, JSON.stringify(stages));
	assert.throws(() => meter.measure(new Uint8Array(100)), /trace/i);
});
