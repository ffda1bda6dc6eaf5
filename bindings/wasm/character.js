// SPDX-License-Identifier: MIT
// One character: its frame, what it asks of the ground, and what came out, where they lie in the module's memory. A
// frame copies nothing but the pose and hits that the caller writes.
import { Marks } from "./marks.js";
import { offsetOf, refuse, sizeOf, takeCount, takeNumbers, takeVector } from "./memory.js";

const TRANSFORM = 10;

/// Why a leg is as it is: bits of LegOutput.flags.
export const LegFlags = Object.freeze({
	planted: 1 << 0,
	noGround: 1 << 1,
	tooSteep: 1 << 2,
	onEdge: 1 << 3,
	softened: 1 << 4,
	outOfReach: 1 << 5,
	heelLifted: 1 << 6,
	ankleClamped: 1 << 7,
	folded: 1 << 8,
	released: 1 << 9,
	captured: 1 << 10,
	degenerate: 1 << 11,
	badInput: 1 << 12,
	inside: 1 << 13,
	planned: 1 << 14,
	tooLow: 1 << 15,
	tooHigh: 1 << 16,
	asleep: 1 << 17,
});

/// A struct in memory: its numbers by name, its vectors as views that are made once and again after memory has grown.
class Struct {
	#memory;
	#struct;
	#views = new Map();
	#buffer;

	constructor(memory, struct, at) {
		this.#memory = memory;
		this.#struct = struct;
		this.at = at;
	}

	read(field) {
		return this.#memory.get(this.#struct, this.at, field);
	}

	write(field, value) {
		this.#memory.set(this.#struct, this.at, field, value);
	}

	view(field, make = () => this.#memory.view(this.#struct, this.at, field)) {
		if (this.#buffer !== this.#memory.buffer) {
			this.#views.clear();
			this.#buffer = this.#memory.buffer;
		}
		let view = this.#views.get(field);
		if (view === undefined) {
			view = make();
			this.#views.set(field, view);
		}
		return view;
	}
}

/// Gives a class a property for each field: vectors as views, numbers by value.
function defineFields(target, vectors, numbers) {
	for (const [name, field] of Object.entries(vectors)) {
		Object.defineProperty(target.prototype, name, {
			get() {
				return this.struct.view(field);
			},
			set(value) {
				this.struct.view(field).set(takeNumbers(name, value, Float32Array, this.struct.view(field).length));
			},
		});
	}
	for (const [name, field] of Object.entries(numbers)) {
		Object.defineProperty(target.prototype, name, {
			get() {
				return this.struct.read(field);
			},
			set(value) {
				this.struct.write(field, value);
			},
		});
	}
}

/// A question about the ground: what is first met on the way from start along direction?
class Probe {
	constructor(memory, at) {
		this.struct = new Struct(memory, "soleProbe", at);
	}
}
defineFields(
	Probe,
	{ start: "start_w", direction: "direction_w" },
	{ length: "length", radius: "radius", mask: "mask", leg: "leg", index: "index" },
);

/// An answer. What nobody writes is a miss.
class Hit {
	constructor(memory, at) {
		this.struct = new Struct(memory, "soleHit", at);
	}

	/// Something was met there. point, normal: arrays, or x, y and z
	put(point, normal, surface = -1) {
		this.#copy("point_w", point);
		this.#copy("normal_w", normal);
		this.struct.write("surface", surface);
		this.struct.write("hit", true);
	}

	#copy(field, vector) {
		const view = this.struct.view(field);
		const named = vector.x !== undefined;
		view[0] = named ? vector.x : vector[0];
		view[1] = named ? vector.y : vector[1];
		view[2] = named ? vector.z : vector[2];
	}
}
defineFields(
	Hit,
	{ point: "point_w", normal: "normal_w", velocity: "velocity_w", asked: "asked_w" },
	{ hit: "hit", startedInside: "startedInside", layer: "layer", surface: "surface", size: "size" },
);

/// What came out for one leg.
class LegOutput {
	constructor(memory, at) {
		this.struct = new Struct(memory, "soleLegOutput", at);
	}
}
defineFields(
	LegOutput,
	{
		rotations: "rotations_l",
		toeRotation: "toeRotation_l",
		footTranslation: "footTranslation_l",
		footRotation: "footRotation_l",
		ankleTarget: "ankleTarget_w",
		ankle: "ankle_w",
		planePoint: "planePoint_w",
		planeNormal: "planeNormal_w",
	},
	{
		flags: "flags",
		stretch: "stretch",
		error: "error",
		extension: "extension",
		heightDemand: "heightDemand",
		plantWeight: "plantWeight",
		confidence: "confidence",
	},
);

/// What came out. The views are the memory itself: they show the last frame that was solved.
class Output {
	constructor(memory, at, legCount) {
		this.struct = new Struct(memory, "soleOutput", at);
		const legsAt = at + offsetOf("soleOutput", "legs");
		this.legs = Array.from({ length: legCount }, (_, i) => new LegOutput(memory, legsAt + i * sizeOf("soleLegOutput")));
	}
}
defineFields(
	Output,
	{ pelvisOffset: "pelvisOffset_w", pelvisTranslation: "pelvisTranslation_l", bodyGradient: "bodyGradient_w",
		lean: "lean_l" },
	{ capsuleShorter: "capsuleShorter", capsuleOffset: "capsuleOffset", secondWeight: "secondWeight",
		groundOffset: "groundOffset", unmetTime: "unmetTime", activity: "activity", strength: "strength" },
);

/// What the host says of a frame, by the names of soleFrame.
class Frame {
	constructor(memory, at) {
		this.struct = new Struct(memory, "soleFrame", at);
	}
}
defineFields(
	Frame,
	{ root: "root", up: "up", worldOrigin: "worldOrigin" },
	{ timeStep: "timeStep", weight: "weight", clipFloor: "clipFloor", teleport: "teleport" },
);


export class Character {
	#module;
	#struct;
	#frame;
	#settings;
	#ownSettings;
	#marks;

	/// @param ownSettings end with the character
	constructor(module, rig, { settings, maxSupports = 16 }, ownSettings) {
		const { memory, exports } = module;
		takeCount("maxSupports", maxSupports, 0, 1024);
		if (!rig?.at || !settings?.at) {
			refuse("character: has no rig or settings, or one that was disposed of: create them before");
		}
		this.#module = module;
		this.#marks = new Marks(memory);
		this.rig = rig;
		this.at = exports.soleWasm_CreateCharacter(rig.at, maxSupports);
		if (this.at === 0) {
			refuse(`out of memory: a character of ${rig.jointCount} joints was asked for`);
		}
		this.maxSupports = maxSupports;
		this.#struct = new Struct(memory, "soleWasmCharacter", this.at);
		this.#settings = settings;
		this.#ownSettings = ownSettings;
		this.#struct.write("settings", settings.at);
		const inside = (field) => this.at + offsetOf("soleWasmCharacter", field);
		const list = (field, type, item) => {
			const at = this.#struct.read(field);
			const count = this.#struct.read("probeCapacity");
			return Array.from({ length: count }, (_, i) => new type(memory, at + i * sizeOf(item)));
		};
		this.#frame = new Frame(memory, inside("frame"));
		this.output = new Output(memory, inside("output"), rig.legCount);
		this.probes = list("probes", Probe, "soleProbe");
		this.hits = list("hits", Hit, "soleHit");
	}

	get settings() {
		return this.#settings;
	}

	/// Shared ones are not disposed of with the character.
	set settings(settings) {
		if (!settings?.at) {
			refuse("settings: are none, or were disposed of: give some of createSettings()");
		}
		this.#settings = settings;
		this.#struct.write("settings", settings.at);
	}

	// --------------------------------------------------------------------------------------------- what goes in

	#numbers(field, count) {
		return this.#struct.view(field, () => this.#module.memory.floats(this.#struct.read(field), count));
	}

	get frame() {
		return this.#frame;
	}

	/// The animated pose: per joint translation, rotation x y z w, scale, parent-local.
	get pose() {
		return this.#numbers("pose", TRANSFORM * this.rig.jointCount);
	}

	set pose(numbers) {
		this.pose.set(takeNumbers("pose", numbers, Float32Array, TRANSFORM * this.rig.jointCount));
	}

	/// What came of it.
	get placed() {
		return this.#numbers("placed", TRANSFORM * this.rig.jointCount);
	}

	/// A second pose for ground that is much higher under one foot than under another, or null.
	get secondPose() {
		const used = this.#frame.struct.read("secondPose") !== 0;
		return used ? this.#numbers("secondPose", TRANSFORM * this.rig.jointCount) : null;
	}

	set secondPose(numbers) {
		const { struct } = this.#frame;
		struct.write("secondPose", numbers === null ? 0 : this.#struct.read("secondPose"));
		if (numbers !== null) {
			this.secondPose.set(takeNumbers("secondPose", numbers, Float32Array, TRANSFORM * this.rig.jointCount));
		}
	}

	/// A number per leg, all 1 where nobody writes them.
	get legWeight() {
		return this.#numbers("legWeight", this.rig.legCount);
	}

	get positionWeight() {
		return this.#numbers("positionWeight", this.rig.legCount);
	}

	get rotationWeight() {
		return this.#numbers("rotationWeight", this.rig.legCount);
	}

	/// Heel and toe per leg; below zero: not known.
	get contact() {
		return this.#numbers("contact", 2 * this.rig.legCount);
	}

	/// Per leg since, until, place, forward, travel, as in soleStepInput.
	get steps() {
		return this.#numbers("steps", (sizeOf("soleStepInput") / 4) * this.rig.legCount);
	}

	/// Nothing is known of contacts and steps: Sole goes by what the feet do.
	forgetSteps() {
		this.contact.fill(-1);
		this.steps.fill(-1);
	}

	/// Bodies that feet may stand on: { surface, translation, rotation } each.
	setSupports(supports) {
		takeCount("supports.length", supports.length, 0, this.maxSupports);
		const { memory } = this.#module;
		supports.forEach(({ surface, translation, rotation }, i) => {
			const at = this.#struct.read("supports") + i * sizeOf("soleSupport");
			const transform = memory.view("soleSupport", at, "transform");
			memory.set("soleSupport", at, "surface", surface);
			transform.set(takeVector(`supports[${i}].translation`, translation), 0);
			transform.set(takeNumbers(`supports[${i}].rotation`, rotation, Float32Array, 4), 3);
			transform.fill(1, 7);
		});
		this.#frame.struct.write("supportCount", supports.length);
	}

	// -------------------------------------------------------------------------------------------- every frame

	#check() {
		if (this.at === 0 || this.rig.at === 0 || this.#settings.at === 0) {
			refuse("character: it, its rig or its settings were disposed of: keep them for as long as it is used");
		}
	}

	/// Asks: probes[0] to probes[probeCount - 1] are then filled, leg by leg, and the hits beside them are misses.
	gather() {
		this.#check();
		return this.#module.exports.soleWasm_Gather(this.at);
	}

	get probeCount() {
		return this.#struct.read("probeCount");
	}

	/// Answers all probes: from a ground, from pieces, or by the caller's own casts, ( probe, hit ) => hit.put( ... ).
	cast(ground) {
		this.#check();
		if (typeof ground !== "function") {
			if (!ground?.at) {
				refuse("cast: is no ground, or one that was disposed of: give a ground or a function");
			}
			ground.answer(this.at);
			return;
		}
		const count = this.probeCount;
		for (let i = 0; i < count; ++i) {
			if (this.probes[i].length > 0) {
				ground(this.probes[i], this.hits[i]);
			}
		}
	}

	/// Places the feet: output and placed are then new.
	solve() {
		this.#check();
		this.#module.exports.soleWasm_Solve(this.at);
	}

	/// gather, cast and solve.
	update(ground) {
		this.gather();
		this.cast(ground);
		this.solve();
	}

	// -------------------------------------------------------------------------------------------------- state

	#stateBytes() {
		const at = this.at + offsetOf("soleWasmCharacter", "state");
		const { memory, exports } = this.#module;
		return new Uint8Array(memory.buffer, at, exports.soleState_GetByteCount(this.rig.at));
	}

	/// All that is remembered of earlier frames, to be given back to restore().
	snapshot() {
		this.#check();
		return this.#stateBytes().slice();
	}

	restore(bytes) {
		this.#check();
		const state = this.#stateBytes();
		state.set(takeNumbers("state", bytes, Uint8Array, state.length));
	}

	/// The character was moved by a jump that is no motion.
	reset() {
		this.#check();
		this.#module.exports.soleState_Reset(this.at + offsetOf("soleWasmCharacter", "state"));
	}

	// ------------------------------------------------------------------------------------------------ drawing

	/// What the last frame saw, decided and did, as a list to draw. Needs the debug module.
	draw(mask = 0xffffffff) {
		this.#check();
		const { exports } = this.#module;
		if (exports.soleWasm_Draw === undefined) {
			refuse("draw: this module cannot draw: load it with { debug: true }");
		}
		return this.#marks.collect((at, capacity) => exports.soleWasm_Draw(this.at, mask, at, capacity));
	}

	dispose() {
		this.#ownSettings?.dispose();
		this.#marks.dispose();
		this.#module.memory.free(this.at);
		this.at = 0;
	}
}
