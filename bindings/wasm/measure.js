// SPDX-License-Identifier: MIT
// Contact labels and quality figures of a motion, offline.
import { offsetOf, refuse, sizeOf, takeCount, takeNumbers, takeVector } from "./memory.js";

const TRANSFORM = 10;

/// What labels say of a leg in a frame.
export const ContactLabel = Object.freeze({ none: 0, heel: 1, toe: 2, flat: 3 });

function putMotion(memory, scope, motion) {
	const at = scope.struct("soleMotion");
	const set = (field, value) => memory.set("soleMotion", at, field, value);
	if (!motion.rig?.at) {
		refuse("motion.rig: is none, or was disposed of: give the rig that the poses are of");
	}
	const roots = takeNumbers("motion.roots", motion.roots, Float32Array);
	const frameCount = Math.floor(roots.length / TRANSFORM);
	takeNumbers("motion.roots", roots, Float32Array, TRANSFORM * frameCount);
	takeCount("motion.roots, the count of frames,", frameCount, 1, 10000000);
	const count = TRANSFORM * frameCount * motion.rig.jointCount;
	const poses = takeNumbers("motion.poses", motion.poses, Float32Array, count);
	if (!(motion.frameRate > 0 && motion.frameRate < Infinity)) {
		refuse(`motion.frameRate: is ${motion.frameRate}: give frames a second`);
	}
	set("rig", motion.rig.at);
	set("frameCount", frameCount);
	set("frameRate", motion.frameRate);
	set("poses", scope.numbers(poses));
	set("roots", scope.numbers(roots));
	memory.view("soleMotion", at, "up").set(takeVector("motion.up", motion.up ?? [0, 1, 0]));
	set("clipFloor", motion.clipFloor ?? 0);
	return { at, frameCount };
}

/// Height of the floor that a clip walks on, over the character's origin.
export function findClipFloor({ memory, exports }, motion) {
	return memory.scope((scope) => exports.soleFindClipFloor(putMotion(memory, scope, motion).at));
}

/// Speed over the ground that an in-place clip pretends.
export function findStrideVelocity({ memory, exports }, motion) {
	return memory.scope((scope) => {
		const velocity = scope.room(12);
		exports.soleFindStrideVelocity(velocity, putMotion(memory, scope, motion).at);
		return Array.from(memory.floats(velocity, 3));
	});
}

/// A ContactLabel per frame and leg, of a motion over flat ground.
export function label({ memory, exports }, motion, limits = {}) {
	return memory.scope((scope) => {
		const { at, frameCount } = putMotion(memory, scope, motion);
		const def = scope.struct("soleLabelDef");
		exports.soleDefaultLabelDef(def);
		for (const field of ["speedOn", "speedOff", "heightOn", "heightOff", "minimum"]) {
			if (limits[field] !== undefined) {
				memory.set("soleLabelDef", def, field, limits[field]);
			}
		}
		const count = frameCount * motion.rig.legCount;
		const labels = scope.room(count);
		if (exports.soleLabelContacts(at, def, 0, labels) !== 0) {
			refuse("motion: can't be labelled: give finite poses and roots");
		}
		memory.buffer;
		return memory.bytes.slice(labels, labels + count);
	});
}

/// The steps of a motion over flat ground; of one that loops, give three rounds.
export function findSteps({ memory, exports }, motion, labels, loops) {
	return memory.scope((scope) => {
		const { at, frameCount } = putMotion(memory, scope, motion);
		const bytes = takeNumbers("labels", labels, Uint8Array, frameCount * motion.rig.legCount);
		const labelsAt = scope.numbers(bytes);
		const capacity = frameCount * motion.rig.legCount;
		const steps = scope.struct("soleStep", capacity);
		const count = exports.soleFindSteps(at, labelsAt, loops ? 1 : 0, 0, steps, capacity);
		return Array.from({ length: Math.min(count, capacity) }, (_, i) => {
			const step = steps + i * sizeOf("soleStep");
			const numbers = ["leg", "strike", "lift", "heelDown", "heelUp", "toeDown", "toeUp"].map((field) => [
				field,
				memory.get("soleStep", step, field),
			]);
			const vectors = ["place", "forward"].map((field) => [field, Array.from(memory.view("soleStep", step, field))]);
			return Object.fromEntries([...numbers, ...vectors]);
		});
	});
}

// --------------------------------------------------------------------------------------------------------- figures

const stats = ["penetration", "verticalPenetration", "hover", "drift"];
const legNumbers = ["labelledFrames", "contactShare", "slide", "stances", "overExtended", "swings", "scuffs", "clearance",
	"kneeAccelerationRms", "kneeAccelerationMax", "largestJump"];
const wholeNumbers = ["pelvisJerk", "pelvisLargestStep", "deviation", "pelvisOffsetRms", "pelvisOffsetMax"];

function readLeg(memory, at) {
	const figures = {};
	for (const field of stats) {
		const [mean, p95, max] = memory.view("soleLegFigures", at, field);
		figures[field] = { mean, p95, max };
	}
	for (const field of legNumbers) {
		figures[field] = memory.get("soleLegFigures", at, field);
	}
	return figures;
}

function readFigures(memory, at) {
	const legs = at + offsetOf("soleFigures", "legs");
	const count = memory.get("soleFigures", at, "legCount");
	const figures = {
		legs: Array.from({ length: count }, (_, i) => readLeg(memory, legs + i * sizeOf("soleLegFigures"))),
		all: readLeg(memory, at + offsetOf("soleFigures", "all")),
	};
	for (const field of wholeNumbers) {
		figures[field] = memory.get("soleFigures", at, field);
	}
	return figures;
}

function createTerrain({ memory, exports }, scope, { positions, indices }, up) {
	const vertices = takeNumbers("terrain.positions", positions, Float32Array);
	const corners = takeNumbers("terrain.indices", indices, Uint32Array);
	const upAt = scope.numbers(takeVector("motion.up", up));
	const terrain = scope.room(4);
	const message = scope.struct("soleMessage");
	const [vertexCount, triangleCount] = [Math.floor(vertices.length / 3), Math.floor(corners.length / 3)];
	const at = [scope.numbers(vertices), vertexCount, scope.numbers(corners), triangleCount];
	if (exports.soleCreateTerrain(...at, upAt, 0, terrain, message) !== 0) {
		refuse(memory.text(message));
	}
	return memory.getWord(terrain);
}

/// Figures of a motion over a terrain.
export function measure(module, { motion, reference, labels, terrain, skip = 0 }) {
	const { memory, exports } = module;
	return memory.scope((scope) => {
		const { at, frameCount } = putMotion(memory, scope, motion);
		const def = scope.struct("soleMeasureDef");
		exports.soleDefaultMeasureDef(def);
		const set = (field, value) => memory.set("soleMeasureDef", def, field, value);
		set("motion", at);
		set("labels", scope.numbers(takeNumbers("labels", labels, Uint8Array, frameCount * motion.rig.legCount)));
		set("skip", takeCount("skip", skip, 0, frameCount));
		if (reference) {
			const other = putMotion(memory, scope, reference);
			if (other.frameCount !== frameCount || reference.rig.jointCount !== motion.rig.jointCount) {
				refuse(`reference: has ${other.frameCount} frames: give ${frameCount} of the same rig`);
			}
			set("reference", other.at);
		}
		const count = exports.soleMakeMeasurePoints(motion.rig.at, 0, 0);
		const points = scope.struct("soleMeasurePoint", count);
		exports.soleMakeMeasurePoints(motion.rig.at, points, count);
		set("points", points);
		set("pointCount", count);
		const figures = scope.struct("soleFigures");
		const message = scope.struct("soleMessage");
		const terrainAt = createTerrain(module, scope, terrain, motion.up ?? [0, 1, 0]);
		set("terrain", terrainAt);
		const result = exports.soleMeasureMotion(def, 0, figures, message);
		exports.soleDestroyTerrain(terrainAt);
		return result === 0 ? readFigures(memory, figures) : refuse(memory.text(message));
	});
}
