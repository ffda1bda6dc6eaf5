// SPDX-License-Identifier: MIT
// Sole's own ground from JavaScript: triangles, height fields, planes and moving pieces, asked with rays and spheres.
import assert from "node:assert/strict";
import { test } from "node:test";
import { loadModule, stairs } from "./support.mjs";

const sole = await loadModule("sole-simd");
const down = [0, -1, 0];
const near = (a, b, tolerance = 1e-5) => assert.ok(a.every((x, i) => Math.abs(x - b[i]) < tolerance), `${a} is not ${b}`);

test("triangles are met by rays and spheres", () => {
	const ground = sole.createGround({ meshes: [{ ...stairs(), layer: 4, surface: 12 }] });
	const ray = ground.cast({ start: [0, 2, 1.1], direction: down, length: 5 });
	near(ray.point, [0, 0.1, 1.1]);
	near(ray.normal, [0, 1, 0]);
	assert.deepEqual([ray.layer, ray.surface, ray.startedInside], [4, 12, false]);
	const sphere = ground.cast({ start: { x: 0, y: 2, z: 0.95 }, direction: down, length: 5, radius: 0.1 });
	near(sphere.point, [0, 0.1, 1]);
	assert.equal(ground.cast({ start: [0, 2, 1.1], direction: down, length: 1 }), null);
	assert.equal(ground.cast({ start: [0, 2, 1.1], direction: down, length: 5, mask: 3 }), null);
	assert.equal(ground.cast({ start: [0, 2, 1.1], direction: [NaN, 0, 0], length: 5 }), null);
	assert.equal(ground.triangleCount, 162);
	near(ground.bounds.lower, [-2, 0, -5]);
	near(ground.bounds.upper, [2, 4, 13]);
	ground.dispose();
});

test("faces are met from the front, or from both sides", () => {
	const mesh = { positions: [0, 0, 0, 0, 0, 1, 1, 0, 0] };
	const up = { start: [0.2, -1, 0.2], direction: [0, 1, 0], length: 2 };
	assert.equal(sole.createGround({ meshes: [mesh] }).cast(up), null);
	near(sole.createGround({ meshes: [{ ...mesh, twoSided: true }] }).cast(up).normal, [0, -1, 0]);
});

test("height fields and planes are met", () => {
	const heights = Float32Array.from({ length: 16 }, (_, i) => 0.5 * (i % 4));
	const field = { heights, countX: 4, countZ: 4, cellX: 1, cellZ: 1, origin: [10, 0, 0] };
	const ground = sole.createGround({ heightFields: [field], planes: [{ normal: [0, 1, 0], offset: -1, surface: 3 }] });
	near(ground.cast({ start: [11.5, 5, 1.2], direction: down, length: 9 }).point, [11.5, 0.75, 1.2]);
	const plane = ground.cast({ start: [0, 5, 0], direction: down, length: 9 });
	near(plane.point, [0, -1, 0]);
	assert.equal(plane.surface, 3);
	ground.dispose();
});

test("pieces are met where they are now", () => {
	const ground = sole.createGround({ meshes: [stairs()] });
	const pieces = sole.createPieces([{ ground, surface: 7 }, { ground: null }]);
	const half = Math.SQRT1_2;
	pieces.move(0, { translation: { x: 0, y: 1, z: 0 }, rotation: { x: 0, y: half, z: 0, w: half }, spin: [0, 2, 0] });
	const hit = pieces.cast({ start: [1.1, 9, 0], direction: down, length: 20 });
	near(hit.point, [1.1, 1.1, 0], 1e-4);
	near(hit.velocity, [0, 0, -2.2], 1e-4);
	assert.equal(hit.surface, 7);
	pieces.move(0, { there: false });
	assert.equal(pieces.cast({ start: [1.1, 9, 0], direction: down, length: 20 }), null);
	pieces.move(0, { there: true });
	near(pieces.cast({ start: [1.1, 9, 0], direction: down, length: 20 }).point, [1.1, 1.1, 0], 1e-4);
	assert.throws(() => pieces.move(2, {}), /piece: is 2: give a whole number from 0 to 1/);
	assert.throws(() => pieces.move(0, { translation: [1] }), /translation: has 1 numbers/);
	pieces.dispose();
	ground.dispose();
});

test("memory that was given back is used again, in other pieces", async () => {
	const own = await loadModule("sole");
	const make = (size) => own.createGround({
		heightFields: [{ heights: new Float32Array(size * size), countX: size, countZ: size, cellX: 1, cellZ: 1 }],
	});
	make(200).dispose();
	const before = own.memorySize;
	for (let round = 0; round < 40; ++round) {
		const grounds = [20 + round, 60 - round, 10, 33].map(make);
		grounds.reverse().forEach((ground) => ground.dispose());
		make(200 - round).dispose();
	}
	assert.equal(own.memorySize, before);
});

test("what is no ground is refused with a sentence", () => {
	const mesh = { positions: [0, 0, 0, 0, 0, 1, 1, 0, 0], indices: [0, 1, 2] };
	const field = { heights: [0, 0, 0, 0], countX: 2, countZ: 2, cellX: 1, cellZ: 1 };
	const cases = [
		[{ meshes: [{ ...mesh, positions: [0, 0] }] }, /meshes\[0\]\.positions: has 2 numbers: give 0/],
		[{ meshes: [{ ...mesh, positions: undefined }] }, /meshes\[0\]\.positions: is no array/],
		[{ meshes: [mesh, { ...mesh, indices: [0, 1] }] }, /meshes\[1\]\.indices: has 2/],
		[{ meshes: [{ ...mesh, indices: [0, 1, 3] }] }, /meshes\[0\].*: /],
		[{ meshes: [{ ...mesh, positions: [0, 0, NaN, 0, 0, 1, 1, 0, 0] }] }, /meshes\[0\].*finite/],
		[{ meshes: [{ ...mesh, triangleLayers: [1, 2] }] }, /triangleLayers: has 2 numbers: give 1/],
		[{ heightFields: [{ ...field, countX: 1 }] }, /heightFields\[0\]\.countX: is 1/],
		[{ heightFields: [{ ...field, heights: [1] }] }, /heightFields\[0\]\.heights: has 1 numbers: give 4/],
		[{ heightFields: [{ ...field, cellX: 0 }] }, /heightFields\[0\].*cell/],
		[{ planes: [{ normal: [0, 0, 0], offset: 0 }] }, /planes\[0\]/],
	];
	for (const [parts, sentence] of cases) {
		assert.throws(() => sole.createGround(parts), sentence);
	}
	assert.equal(sole.createGround({}).cast({ start: [0, 1, 0], direction: down, length: 2 }), null);
});
