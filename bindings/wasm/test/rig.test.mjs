// SPDX-License-Identifier: MIT
// Rigs and settings: what is found, what is refused and with which sentence, and that nothing is left behind.
import assert from "node:assert/strict";
import { test } from "node:test";
import { bipedDefinition, bipedSkeleton, hash, loadModule, native, stairs, walkOn } from "./support.mjs";

const sole = await loadModule("sole");

test("a rig is made from a definition, joints by name or index", () => {
	const byName = sole.createRig(bipedDefinition());
	assert.deepEqual([byName.jointCount, byName.legCount, byName.legNames], [11, 2, ["left", "right"]]);
	assert.ok(Math.abs(byName.legLength(0) - 0.9) < 1e-5);
	const definition = bipedDefinition();
	definition.pelvis = 1;
	definition.legs[0].joints = [3, 4, 5];
	assert.equal(sole.createRig(definition).legLength(0), byName.legLength(0));
	assert.throws(() => byName.legLength(2), /leg: is 2/);
});

test("what is wrong with a definition is said", () => {
	const change = (edit) => {
		const definition = bipedDefinition();
		edit(definition);
		return () => sole.createRig(definition);
	};
	const cases = [
		[(d) => (d.pelvis = "hips"), /pelvis: there is no joint 'hips'/],
		[(d) => (d.legs[1].joints[2] = "ankle"), /legs\[1\]\.joints\[2\]: there is no joint 'ankle'/],
		[(d) => (d.legs[0].joints = [3, 4, 5, 6, 3, 4, 5, 6]), /legs\[0\]\.joints: is no list of at most 7/],
		[(d) => (d.legs[0].joints = [5, 4, 3]), /legs\[0\]\.joints\[1\]: joint 4 is not below joint 5/],
		[(d) => (d.legs[0].joints = [3, 4, 4000]), /legs\[0\]\.joints\[2\]: is 4000/],
		[(d) => (d.legs[0].sole.ball = undefined), /legs\[0\]\.sole\.ball: is no array/],
		[(d) => (d.legs[0].sole.ball = [1, 2]), /legs\[0\]\.sole\.ball: has 2 numbers: give 3/],
		[(d) => (d.legs[0].sole.ball = [1, NaN, 2]), /legs\[0\]\.sole\.ball: is not finite/],
		[(d) => (d.legs[0].side = "up"), /legs\[0\]\.side: is up/],
		[(d) => (d.legs = []), /legCount: is 0/],
		[(d) => (d.legs = undefined), /legs: is no list/],
		[(d) => (d.legs = Array(17).fill(d.legs[0])), /legs: is no list of at most 16/],
		[(d) => (d.parents = [-1, 2, 1, 1, 3, 4, 5, 1, 7, 8, 9]), /parents\[1\]: is its own ancestor/],
		[(d) => (d.parents = []), /parents.length: is 0/],
		[(d) => (d.parents = "abc"), /parents: is no array/],
		[(d) => d.bindPose.fill(NaN), /bindPose\[0\]: is not finite/],
		[(d) => (d.bindPose = new Float32Array(10)), /bindPose: has 10 numbers: give 110/],
		[(d) => (d.names = ["a"]), /names: are not 11 texts/],
		[(d) => (d.up = [0, 0, 1]), /up, forward: are not two directions/],
		[(d) => (d.legs[0].ankleLimits = { twist: 7 }), /ankleLimits: one is 7: give radians from 0 to 1.5/],
	];
	for (const [edit, sentence] of cases) {
		assert.throws(change(edit), sentence);
	}
});

test("legs are found, and what is found can be kept as JSON", () => {
	const { rig, findings, legLength } = sole.detectRig(bipedSkeleton());
	assert.equal(rig.legCount, 2);
	assert.deepEqual(rig.definition.legs.map((leg) => leg.joints), [[3, 4, 5], [7, 8, 9]]);
	assert.ok(Math.abs(legLength - 0.9) < 1e-5);
	assert.ok(findings.length > 0 && findings.every(({ severity, what }) => severity && what));
	const again = sole.createRig(JSON.parse(JSON.stringify(rig.definition)));
	const walk = (kind) => {
		const character = sole.createCharacter(kind);
		const ground = sole.createGround({ meshes: [stairs()] });
		for (let i = 0; i < 90; ++i) {
			walkOn(character, ground, i);
		}
		return hash(character.placed, character.snapshot());
	};
	assert.equal(walk(again), walk(rig));
});

test("a skin tells where soles are", () => {
	const skeleton = bipedSkeleton();
	const [positions, joints, weights] = [[], [], []];
	for (const [joint, x] of [[5, 0.09], [9, -0.09]]) {
		for (const [z, y] of [[-0.1, 0], [-0.05, 0], [0, 0], [0.05, 0], [0.1, 0], [0.15, 0], [0.2, 0], [0.25, 0], [0, 0.08]]) {
			for (const side of [-0.05, 0, 0.05]) {
				positions.push(x + side, y - 0.02, z);
				joints.push(z > 0.12 ? joint + 1 : joint, -1, -1, -1);
				weights.push(1, 0, 0, 0);
			}
		}
	}
	const { rig } = sole.detectRig({ ...skeleton, skin: { positions, joints, weights } });
	const { heel, toe } = rig.definition.legs[0].sole;
	assert.ok(Math.abs(heel[2] + 0.1) < 0.03 && Math.abs(toe[2] - 0.25) < 0.03, `${heel} ${toe}`);
	joints[0] = 99;
	assert.throws(() => sole.detectRig({ ...skeleton, skin: { positions, joints, weights } }), /there is no joint 99/);
	assert.throws(() => sole.detectRig({ ...skeleton, skin: { positions, joints: [1], weights } }), /skin.joints: has 1/);
});

test("a skeleton without legs is refused with a sentence", () => {
	const skeleton = { names: ["box"], parents: [-1], bindPose: [0, 0, 0, 0, 0, 0, 1, 1, 1, 1] };
	assert.throws(() => sole.detectRig(skeleton), (error) => error.message.split(": ").length >= 2);
	assert.throws(() => sole.detectRig({ ...bipedSkeleton(), bindPose: new Float32Array(110).fill(NaN) }), Error);
	assert.throws(() => sole.detectRig({ ...bipedSkeleton(), roles: { nose: 1 } }), /there is no role 'nose'/);
	assert.throws(() => sole.detectRig({ ...bipedSkeleton(), samplePoses: [1, 2, 3] }), /samplePoses: has 3/);
});

test("refusals take no memory", () => {
	const before = sole.memorySize;
	for (let i = 0; i < 3000; ++i) {
		assert.throws(() => sole.createRig({ ...bipedDefinition(), pelvis: 5 }));
		sole.createRig(bipedDefinition()).dispose();
	}
	assert.ok(sole.memorySize <= before + 2 * 65536, `${before} to ${sole.memorySize}`);
});

// -------------------------------------------------------------------------------------------------------- settings

test("settings are the JSON of the native program", () => {
	const settings = sole.createSettings();
	assert.deepEqual(settings.toJSON(), JSON.parse(native("settings", "--json")));
	settings.set("pelvis.halfLife", 0.3);
	settings.set("probe.mask", 0x80000001);
	settings.set("probe.shape", 1);
	assert.deepEqual([settings.get("pelvis.halfLife"), settings.get("probe.mask")], [0.3, 0x80000001]);
	const again = sole.createSettings(JSON.stringify(settings));
	assert.deepEqual(again.toJSON(), settings.toJSON());
	again.reset();
	assert.deepEqual(again.toJSON(), sole.createSettings().toJSON());
	again.dispose();
});

test("settings that are none are refused, and then nothing has changed", () => {
	const settings = sole.createSettings();
	const usual = JSON.stringify(settings);
	const cases = [
		[{ pelvis: { halfLife: 0.2, height: 1 } }, /pelvis.height: is no setting/],
		[{ pelvis: { halfLife: 0.2, down: 7 } }, /pelvis.down: is 7, out of range: give a value from 0 to 1 L/],
		[{ pelvis: { halfLife: "0.2" } }, /pelvis.halfLife: is not a number/],
		[{ pelvis: { halfLife: NaN } }, /pelvis.halfLife: is not a number/],
		[{ probe: { shape: 0.5 } }, /probe.shape: is not a whole number/],
		[{ pelvis: 3 }, /pelvis: is not an object/],
		[[], /no JSON object/],
		["{ \"pelvis\": ", SyntaxError],
	];
	for (const [json, sentence] of cases) {
		assert.throws(() => settings.fromJSON(json), sentence);
		assert.throws(() => sole.createSettings(json), sentence);
	}
	assert.throws(() => settings.set("pelvis.halfLife", -1), /out of range/);
	assert.throws(() => settings.get("nothing"), /nothing: is no setting/);
	assert.equal(JSON.stringify(settings), usual);
});

test("the table of settings is the library's", () => {
	const info = sole.settingInfos.find(({ name }) => name === "pelvis.halfLife");
	assert.deepEqual([info.unit, info.kind, info.minimum, info.maximum, info.default], ["s", "number", 0, 2, 0.08]);
	assert.match(info.text, /\.$/);
	const table = native("settings").split("\n");
	for (const { name } of sole.settingInfos) {
		assert.ok(table.some((line) => line.startsWith(`${name} `)), name);
	}
});

test("numbers in sentences are written as the C library writes them", () => {
	// What %g gives of these.
	const texts = [[1.75, "1.75"], [1e-9 - 2e-9, "-1e-09"], [123456789, "1.23457e+08"], [1000000, "1e+06"], [2.5e-5 - 1, "-0.999975"]];
	for (const [value, text] of texts) {
		const definition = bipedDefinition();
		definition.legs[0].ankleLimits = { twist: value };
		assert.throws(() => sole.createRig(definition), new RegExp(`one is ${text.replace(/[+.]/g, "\\$&")}: `));
	}
});
