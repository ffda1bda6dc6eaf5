// SPDX-License-Identifier: MIT
// The same bits as the native library: traces that the native program has recorded are replayed, over several scenes and
// characters, and all four modules agree on a walk.
import assert from "node:assert/strict";
import { existsSync, readFileSync, writeFileSync } from "node:fs";
import { test } from "node:test";
import {
	bipedDefinition, bipedSkeleton, dataFolder, hash, loadModule, modules, native, stairs, walkOn, workFolder,
} from "./support.mjs";

const bakes = [
	["mannequin", "walk", "flat"],
	["mannequin", "run", "stairs"],
	["mannequin", "walk", "ramp"],
	["mannequin", "walk", "rubble"],
	["mannequin", "walk", "course"],
	["mannequin", "walk", "T16-2"],
	[`${dataFolder}/human-quaternius-ual/human-base-animations.glb`, "Walk_Loop", "rubble"],
	[`${dataFolder}/human-pab-rootmotion/pab_arnaud.glb`, "walk", "stairs"],
];

for (const name of ["sole-debug", "sole-debug-simd"]) {
	test(`${name} replays native traces to the bit`, async (t) => {
		const sole = await loadModule(name);
		for (const [character, clip, ground] of bakes) {
			if (character !== "mannequin" && !existsSync(character)) {
				t.diagnostic(`left out: ${character} is not there`);
				continue;
			}
			native("bake", character, "--clip", clip, "--ground", ground, "-o", "bake.glb", "--trace", "bake.trace");
			const report = sole.replayTrace(readFileSync(`${workFolder}/bake.trace`));
			assert.equal(report.first, null, `${character} ${ground}: ${JSON.stringify(report.first)}`);
			assert.ok(report.frameCount > 60, `${report.frameCount} frames`);
			assert.equal(report.legCount, 2);
		}
	});
}

test("the native program replays what was recorded here to the bit", async () => {
	for (const name of ["sole-debug", "sole-debug-simd"]) {
		const sole = await loadModule(name);
		const rig = sole.detectRig(bipedSkeleton()).rig;
		const ground = sole.createGround({ meshes: [stairs()] });
		const character = sole.createCharacter(rig);
		const tracer = sole.createTracer(character);
		for (let i = 0; i < 120; ++i) {
			walkOn(character, ground, i, tracer);
		}
		writeFileSync(`${workFolder}/own.trace`, tracer.finish());
		assert.match(native("replay", "own.trace"), /: 120 frames of 2 legs, .*: the same to the bit/);
		tracer.dispose();
	}
});

test("what is no trace is refused, with the library's sentence", async () => {
	native("bake", "mannequin", "--ground", "flat", "--distance", "1", "-o", "bake.glb", "--trace", "bake.trace");
	const sole = await loadModule("sole-debug");
	const bytes = readFileSync(`${workFolder}/bake.trace`);
	assert.equal(sole.replayTrace(bytes).differentFrames, 0);
	assert.throws(() => sole.replayTrace(bytes.subarray(0, bytes.length - 5)), /trace: is cut off/);
	bytes[bytes.length >> 1] ^= 1;
	assert.throws(() => sole.replayTrace(bytes), /trace: was changed after frame \d+/);
	assert.throws(() => sole.replayTrace(new Uint8Array(0)), /trace: is none/);
});

function walkHash(sole, detected) {
	const rig = detected ? sole.detectRig(bipedSkeleton()).rig : sole.createRig(bipedDefinition());
	const ground = sole.createGround({ meshes: [stairs()] });
	const character = sole.createCharacter(rig);
	character.settings.set("probe.shape", detected ? 1 : 0);
	const sums = [];
	for (let i = 0; i < 240; ++i) {
		walkOn(character, ground, i);
		const legs = character.output.legs.flatMap((leg) => [leg.flags, leg.error, leg.extension, leg.confidence]);
		sums.push(hash(character.placed, Float32Array.from(legs), character.output.pelvisOffset));
	}
	sums.push(hash(character.snapshot()));
	character.dispose();
	ground.dispose();
	rig.dispose();
	return hash(new TextEncoder().encode(sums.join()));
}

test("all modules walk alike, with rays and spheres", async () => {
	const hashes = [];
	for (const name of modules) {
		const sole = await loadModule(name);
		hashes.push([walkHash(sole, false), walkHash(sole, true)].join(" "));
	}
	assert.equal(new Set(hashes).size, 1, hashes.join("\n"));
	assert.notEqual(hashes[0].split(" ")[0], hashes[0].split(" ")[1]);
});
