// SPDX-License-Identifier: MIT
// What the tests share: the package as it is laid out in build/wasm, the native program, a biped of plain numbers and a
// walk of it.
import { execFileSync } from "node:child_process";
import { createHash } from "node:crypto";
import { existsSync, mkdirSync, readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { loadSole } from "sole";

export const root = fileURLToPath(new URL("../../..", import.meta.url));
export const packageFolder = `${root}/build/wasm`;
export const dataFolder = `${root}/../shared/data`;
export const workFolder = `${packageFolder}/test-files`;
const program = `${root}/build/release/tool/sole`;
mkdirSync(workFolder, { recursive: true });

export const modules = ["sole", "sole-simd", "sole-debug", "sole-debug-simd"];
export const moduleBytes = (name) => readFileSync(`${packageFolder}/${name}.wasm`);
export const loadModule = (name) => loadSole({ bytes: moduleBytes(name) });

/// Runs the native program in the folder of the tests.
export function native(...words) {
	return execFileSync(program, words, { cwd: workFolder, encoding: "utf8" });
}

/// A file of the program's, made once.
export function nativeFile(name, ...words) {
	if (!existsSync(`${workFolder}/${name}`)) {
		native(...words, name);
	}
	return `${workFolder}/${name}`;
}

export function hash(...arrays) {
	const sum = createHash("sha256");
	for (const array of arrays) {
		sum.update(new Uint8Array(array.buffer, array.byteOffset, array.byteLength));
	}
	return sum.digest("hex");
}

// ---------------------------------------------------------------------------------------------------------- biped

const names = ["root", "pelvis", "spine", "thigh_l", "shin_l", "foot_l", "toe_l", "thigh_r", "shin_r", "foot_r", "toe_r"];

const turnX = (angle) => [Math.sin(angle / 2), 0, 0, Math.cos(angle / 2)];

/// Hips 0.98 high, legs of 0.9, knees bent by an angle; each leg swung by its own.
export function poseBiped(flexion, swing = [0, 0]) {
	const joints = [[0, 0, 0], [0, 0.08 + 0.9 * Math.cos(flexion / 2), 0], [0, 0.2, 0]].map((place) => [place, [0, 0, 0, 1]]);
	for (const [side, x] of [[0, 0.09], [1, -0.09]]) {
		joints.push([[x, 0, 0], turnX(-flexion / 2 - swing[side])]);
		joints.push([[0, -0.45, 0], turnX(flexion)], [[0, -0.45, 0], turnX(-flexion / 2 + swing[side])]);
		joints.push([[0, -0.06, 0.12], [0, 0, 0, 1]]);
	}
	return Float32Array.from(joints.flatMap(([place, rotation]) => [...place, ...rotation, 1, 1, 1]));
}

export function bipedSkeleton() {
	return { names: [...names], parents: [-1, 0, 1, 1, 3, 4, 5, 1, 7, 8, 9], bindPose: poseBiped(0.2) };
}

export function bipedDefinition() {
	const legs = [["left", 0.09, 0.045, "l"], ["right", -0.09, -0.045, "r"]].map(([side, x, out, end]) => ({
		name: side,
		side,
		joints: [`thigh_${end}`, `shin_${end}`, `foot_${end}`],
		toes: [`toe_${end}`],
		hinge: [1, 0, 0],
		sole: {
			heel: [x, 0, -0.07],
			ball: [x, 0, 0.12],
			toe: [x, 0, 0.19],
			inner: [x - out, 0, 0.12],
			outer: [x + out, 0, 0.12],
		},
	}));
	return { ...bipedSkeleton(), pelvis: "pelvis", legs };
}

/// Steps of 0.1 along z, from z = 1 on, as one mesh.
export function stairs() {
	const positions = [];
	const indices = [];
	const quad = (corners) => {
		const first = positions.length / 3;
		positions.push(...corners.flat());
		indices.push(first, first + 1, first + 2, first, first + 2, first + 3);
	};
	quad([[-2, 0, -5], [-2, 0, 1], [2, 0, 1], [2, 0, -5]]);
	for (let i = 0; i < 40; ++i) {
		const [z, y] = [1 + 0.3 * i, 0.1 * (i + 1)];
		quad([[-2, y - 0.1, z], [-2, y, z], [2, y, z], [2, y - 0.1, z]]);
		quad([[-2, y, z], [-2, y, z + 0.3], [2, y, z + 0.3], [2, y, z]]);
	}
	return { positions, indices, twoSided: true };
}

export const heightOfStairs = (z) => (z > 1 ? 0.1 * Math.ceil((z - 1) / 0.3) : 0);

/// Frame number i of a walk up the stairs. @param solver the character, or its tracer
export function walkOn(character, ground, i, solver = character) {
	const t = i / 60;
	const swing = 0.4 * Math.sin(5 * t);
	character.pose = poseBiped(0.3 + 0.1 * Math.cos(5 * t), [swing, -swing]);
	character.frame.root = [0, heightOfStairs(t), t, 0, 0, 0, 1, 1, 1, 1];
	character.frame.timeStep = 1 / 60;
	character.gather();
	character.cast(ground);
	solver.solve();
}
