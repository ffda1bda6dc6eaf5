// SPDX-License-Identifier: MIT
// Rigs: from a definition in plain numbers, or found in a skeleton that nobody has described.
import { NONE, fieldSize, offsetOf, refuse, sizeOf, takeCount, takeNumbers, takeVector } from "./memory.js";

const TRANSFORM = 10; // floats: translation, rotation x y z w, scale
const MOST_JOINTS = 65535;
const sides = ["center", "left", "right"];
const solePoints = ["heel", "ball", "toe", "inner", "outer"];
const ankleLimits = ["dorsiflexion", "plantarflexion", "inversion", "eversion", "twist"];
const severities = ["info", "warning", "error"];
const roles = ["none", "pelvis", "leftHip", "leftKnee", "leftAnkle", "leftToe", "rightHip", "rightKnee", "rightAnkle",
	"rightToe", "head"];

// ------------------------------------------------------------------------------------------------- what goes in

/// Checks sizes here; what the numbers say is the library's to judge.
function putSkeleton(memory, scope, struct, at, given) {
	const parents = takeNumbers("parents", given.parents, Int32Array);
	takeCount("parents.length", parents.length, 1, MOST_JOINTS);
	const bindPose = takeNumbers("bindPose", given.bindPose, Float32Array, TRANSFORM * parents.length);
	memory.set(struct, at, "jointCount", parents.length);
	memory.set(struct, at, "parents", scope.numbers(parents));
	memory.set(struct, at, "bindPose", scope.numbers(bindPose));
	if (given.names) {
		if (!Array.isArray(given.names) || given.names.length !== parents.length) {
			refuse(`names: are not ${parents.length} texts: give one for each joint`);
		}
		const names = given.names.map((name) => (name ? scope.text(String(name)) : 0));
		memory.set(struct, at, "names", scope.numbers(Uint32Array.from(names)));
	}
	for (const field of ["up", "forward"]) {
		if (given[field]) {
			memory.view(struct, at, field).set(takeVector(field, given[field]));
		}
	}
	return parents.length;
}

/// A joint by its index or its name.
function findJoint(what, joint, names) {
	if (typeof joint === "string") {
		const index = names?.indexOf(joint) ?? NONE;
		return index >= 0 ? index : refuse(`${what}: there is no joint '${joint}': give one of names`);
	}
	return takeCount(what, joint, NONE, MOST_JOINTS);
}

function putJoints(memory, at, field, what, joints, names) {
	const view = memory.view("soleLegDef", at, field);
	if (!Array.isArray(joints) || joints.length > view.length) {
		refuse(`${what}: is no list of at most ${view.length} joints: give indices or names`);
	}
	joints.forEach((joint, i) => (view[i] = findJoint(`${what}[${i}]`, joint, names)));
	return joints.length;
}

function putLeg(memory, scope, at, what, leg, names) {
	const set = (field, value) => memory.set("soleLegDef", at, field, value);
	const view = (field) => memory.view("soleLegDef", at, field);
	set("name", leg.name ? scope.text(String(leg.name)) : 0);
	const side = sides.indexOf(leg.side ?? "center");
	set("side", side >= 0 ? side : refuse(`${what}.side: is ${leg.side}: give left, right or center`));
	set("jointCount", putJoints(memory, at, "joints", `${what}.joints`, leg.joints, names));
	set("toeCount", putJoints(memory, at, "toes", `${what}.toes`, leg.toes ?? [], names));
	set("detachedFoot", findJoint(`${what}.detachedFoot`, leg.detachedFoot ?? NONE, names));
	if (leg.virtualAnkle) {
		set("hasVirtualAnkle", true);
		view("virtualAnkle").set(takeVector(`${what}.virtualAnkle`, leg.virtualAnkle));
	}
	if (leg.hinge) {
		view("hinge").set(takeVector(`${what}.hinge`, leg.hinge));
	}
	solePoints.forEach((point, i) => {
		view("sole").set(takeVector(`${what}.sole.${point}`, leg.sole?.[point]), 3 * i);
	});
	ankleLimits.forEach((limit, i) => {
		view("ankleLimits")[i] = leg.ankleLimits?.[limit] ?? view("ankleLimits")[i];
	});
}

/// A definition in the module's memory, for as long as the scope lasts.
export function putDefinition(module, scope, given) {
	const { memory, exports } = module;
	const at = scope.struct("soleRigDef");
	exports.soleDefaultRigDef(at);
	putSkeleton(memory, scope, "soleRigDef", at, given);
	memory.set("soleRigDef", at, "pelvis", findJoint("pelvis", given.pelvis, given.names));
	const most = fieldSize("soleRigDef", "legs") / sizeOf("soleLegDef");
	if (!Array.isArray(given.legs) || given.legs.length > most) {
		refuse(`legs: is no list of at most ${most} legs: describe each`);
	}
	given.legs.forEach((leg, i) => {
		const legAt = at + offsetOf("soleRigDef", "legs") + i * sizeOf("soleLegDef");
		putLeg(memory, scope, legAt, `legs[${i}]`, leg, given.names);
	});
	memory.set("soleRigDef", at, "legCount", given.legs.length);
	return at;
}

// ------------------------------------------------------------------------------------------------ what comes out

function readLeg(memory, at) {
	const get = (field) => memory.get("soleLegDef", at, field);
	const numbers = (field) => Array.from(memory.view("soleLegDef", at, field));
	const sole = numbers("sole");
	const limits = numbers("ankleLimits");
	return {
		name: get("name") !== 0 ? memory.getText("soleLegDef", at, "name") : "",
		side: sides[get("side")],
		joints: numbers("joints").slice(0, get("jointCount")),
		toes: numbers("toes").slice(0, get("toeCount")),
		detachedFoot: get("detachedFoot"),
		virtualAnkle: get("hasVirtualAnkle") ? numbers("virtualAnkle") : undefined,
		hinge: numbers("hinge"),
		sole: Object.fromEntries(solePoints.map((point, i) => [point, sole.slice(3 * i, 3 * i + 3)])),
		ankleLimits: Object.fromEntries(ankleLimits.map((limit, i) => [limit, limits[i]])),
	};
}

/// A definition as it was found, in plain JavaScript: it can be kept as JSON and given to createRig().
function readDefinition(memory, at, given) {
	const count = memory.get("soleRigDef", at, "legCount");
	const legsAt = at + offsetOf("soleRigDef", "legs");
	return {
		names: given.names ? Array.from(given.names) : undefined,
		parents: Array.from(given.parents),
		bindPose: Array.from(given.bindPose),
		pelvis: memory.get("soleRigDef", at, "pelvis"),
		up: Array.from(memory.view("soleRigDef", at, "up")),
		forward: Array.from(memory.view("soleRigDef", at, "forward")),
		legs: Array.from({ length: count }, (_, i) => readLeg(memory, legsAt + i * sizeOf("soleLegDef"))),
	};
}

function readFindings(memory, report) {
	const count = memory.get("soleDetectReport", report, "findingCount");
	return Array.from({ length: count }, (_, i) => {
		const at = report + offsetOf("soleDetectReport", "findings") + i * sizeOf("soleFinding");
		return {
			severity: severities[memory.get("soleFinding", at, "severity")],
			leg: memory.get("soleFinding", at, "leg"),
			joint: memory.get("soleFinding", at, "joint"),
			where: memory.getText("soleFinding", at, "where"),
			what: memory.getText("soleFinding", at, "what"),
			mend: memory.getText("soleFinding", at, "mend"),
		};
	});
}

// -------------------------------------------------------------------------------------------------------- making

function create(module, scope, defAt) {
	const { memory, exports } = module;
	const rigAt = scope.room(4);
	const message = scope.struct("soleMessage");
	if (exports.soleCreateRig(defAt, 0, rigAt, message) !== 0) {
		refuse(memory.text(message));
	}
	return memory.getWord(rigAt);
}

/// Skin vertices: four joints and weights each.
function putSkin(memory, scope, at, skin, jointCount) {
	const positions = takeNumbers("skin.positions", skin.positions, Float32Array);
	const count = Math.floor(positions.length / 3);
	takeNumbers("skin.positions", positions, Float32Array, 3 * count);
	const joints = takeNumbers("skin.joints", skin.joints, Int32Array, 4 * count);
	const weights = takeNumbers("skin.weights", skin.weights, Float32Array, 4 * count);
	const bad = joints.find((joint) => joint < NONE || joint >= jointCount);
	if (bad !== undefined) {
		refuse(`skin.joints: there is no joint ${bad}: give indices below ${jointCount}, or -1`);
	}
	const size = sizeOf("soleSkinVertex");
	const vertices = scope.room(count * size);
	for (let i = 0; i < count; ++i) {
		memory.floats(vertices + i * size, 3).set(positions.subarray(3 * i, 3 * i + 3));
		new Int32Array(memory.buffer, vertices + i * size + 12, 4).set(joints.subarray(4 * i, 4 * i + 4));
		memory.floats(vertices + i * size + 28, 4).set(weights.subarray(4 * i, 4 * i + 4));
	}
	memory.set("soleSkeleton", at, "skin", vertices);
	memory.set("soleSkeleton", at, "skinCount", count);
}

function putRoles(memory, scope, at, { roles: given, names }, jointCount) {
	const numbers = new Int32Array(jointCount);
	for (const [role, joint] of Object.entries(given)) {
		const number = roles.indexOf(role);
		numbers[findJoint(`roles.${role}`, joint, names)] =
			number >= 0 ? number : refuse(`roles: there is no role '${role}': give one of ${roles.join(", ")}`);
	}
	memory.set("soleSkeleton", at, "roles", scope.numbers(numbers));
}

export function createRig(module, definition) {
	return module.memory.scope((scope) => {
		const at = create(module, scope, putDefinition(module, scope, definition));
		return new Rig(module, at, definition);
	});
}

export function detectRig(module, skeleton) {
	const { memory, exports } = module;
	return memory.scope((scope) => {
		const at = scope.struct("soleSkeleton");
		const jointCount = putSkeleton(memory, scope, "soleSkeleton", at, skeleton);
		if (skeleton.skin) {
			putSkin(memory, scope, at, skeleton.skin, jointCount);
		}
		if (skeleton.roles) {
			putRoles(memory, scope, at, skeleton, jointCount);
		}
		if (skeleton.samplePoses) {
			const poses = takeNumbers("samplePoses", skeleton.samplePoses, Float32Array);
			const count = Math.floor(poses.length / (TRANSFORM * jointCount));
			takeNumbers("samplePoses", poses, Float32Array, TRANSFORM * jointCount * count);
			memory.set("soleSkeleton", at, "samplePoses", scope.numbers(poses));
			memory.set("soleSkeleton", at, "poseCount", count);
		}
		const defAt = scope.struct("soleRigDef");
		exports.soleDefaultRigDef(defAt);
		const report = scope.struct("soleDetectReport");
		const result = exports.soleDetectRig(at, defAt, report);
		const findings = readFindings(memory, report);
		if (result !== 0) {
			const error = findings.find((finding) => finding.severity === "error");
			refuse(error ? `${error.where}: ${error.what}: ${error.mend}`
				: "skeleton: no legs were found: name the joints as common rigs do");
		}
		const definition = readDefinition(memory, defAt, skeleton);
		return {
			rig: new Rig(module, create(module, scope, defAt), definition),
			findings,
			legLength: memory.get("soleDetectReport", report, "legLength"),
			suggestedScale: memory.get("soleDetectReport", report, "suggestedScale"),
		};
	});
}

export class Rig {
	#module;
	at;

	constructor(module, at, definition) {
		this.#module = module;
		this.at = at;
		this.definition = definition;
		this.jointCount = definition.parents.length;
		this.legCount = definition.legs.length;
		this.legNames = definition.legs.map((leg) => leg.name ?? "");
	}

	/// Hip to ankle along the bones: the L of the settings.
	legLength(leg) {
		return this.#module.exports.soleRig_GetLegLength(this.at, takeCount("leg", leg, 0, this.legCount - 1));
	}

	dispose() {
		this.#module.exports.soleDestroyRig(this.at);
		this.at = 0;
	}
}
