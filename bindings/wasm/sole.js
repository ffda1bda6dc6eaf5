// SPDX-License-Identifier: MIT
// Sole for JavaScript: loads the module and makes rigs, settings, characters and grounds. What each does is said in
// sole.d.ts; the reference is the C library's headers, whose names are kept.
import { Character, LegFlags } from "./character.js";
import { Ground, Pieces, createGround } from "./ground.js";
import { ContactLabel, findClipFloor, findSteps, findStrideVelocity, label, measure } from "./measure.js";
import { openModule } from "./load.js";
import { Memory, offsetOf, refuse, sizeOf } from "./memory.js";
import { Rig, createRig, detectRig } from "./rig.js";
import { Settings, readSettingInfos } from "./settings.js";
import { Steps } from "./steps.js";
import { Tracer } from "./trace.js";

export { Character, ContactLabel, Ground, LegFlags, Pieces, Rig, Settings, Steps, Tracer };

// ( module ( func ( drop ( v128.const ... ) ) ) ), the smallest that only engines with SIMD take.
const SIMD_PROBE = Uint8Array.from([
	0, 97, 115, 109, 1, 0, 0, 0, 1, 4, 1, 96, 0, 0, 3, 2, 1, 0, 10, 23, 1, 21, 0, 253, 12, 0, 0, 0, 0, 0, 0, 0, 0, 0,
	0, 0, 0, 0, 0, 0, 0, 26, 11,
]);

/// Whether this engine has SIMD.
export function hasSimd() {
	return WebAssembly.validate(SIMD_PROBE);
}

/// @param url of a module; bytes: of one, or one that is compiled. Neither: the one beside this file that fits
export async function loadSole({ url, bytes, simd = hasSimd(), debug = false } = {}) {
	const name = `sole${debug ? "-debug" : ""}${simd ? "-simd" : ""}.wasm`;
	const base = import.meta.url;
	const exports = await openModule({ url: new URL(url ?? name, base), bytes });
	if (exports.soleWasm_Solve === undefined) {
		refuse("module: is none of Sole: give one of the package's .wasm files");
	}
	return new Sole(exports, simd);
}

export class Sole {
	#module;
	#infos;

	constructor(exports, simd) {
		this.#module = { exports, memory: new Memory(exports) };
		this.#infos = new Map(readSettingInfos(this.#module).map((info) => [info.name, info]));
		this.simd = simd;
		this.debug = exports.soleWasm_Draw !== undefined;
	}

	/// Of the library in the module.
	get version() {
		const { exports, memory } = this.#module;
		return memory.scope((scope) => {
			const at = scope.struct("soleVersion");
			exports.soleGetVersion(at);
			return Array.from(new Int32Array(memory.buffer, at, 3)).join(".");
		});
	}

	/// How much the module holds, bytes.
	get memorySize() {
		return this.#module.memory.buffer.byteLength;
	}

	get settingInfos() {
		return Array.from(this.#infos.values());
	}

	createSettings(json = {}) {
		const settings = new Settings(this.#module, this.#infos);
		try {
			return settings.fromJSON(json);
		} catch (error) {
			settings.dispose();
			throw error;
		}
	}

	createRig(definition) {
		return createRig(this.#module, definition);
	}

	detectRig(skeleton) {
		return detectRig(this.#module, skeleton);
	}

	/// Without settings it gets its own.
	createCharacter(rig, options = {}) {
		const own = options.settings ? undefined : this.createSettings();
		try {
			return new Character(this.#module, rig, { settings: own, ...options }, own);
		} catch (error) {
			own?.dispose();
			throw error;
		}
	}

	createGround(parts) {
		return createGround(this.#module, parts);
	}

	createPieces(pieces) {
		return new Pieces(this.#module, pieces);
	}

	findClipFloor(motion) {
		return findClipFloor(this.#module, motion);
	}

	findStrideVelocity(motion) {
		return findStrideVelocity(this.#module, motion);
	}

	label(motion, limits) {
		return label(this.#module, motion, limits);
	}

	findSteps(motion, labels, loops = false) {
		return findSteps(this.#module, motion, labels, loops);
	}

	createSteps(steps, clip) {
		return new Steps(this.#module, steps, clip);
	}

	measure(parts) {
		return measure(this.#module, parts);
	}

	#needDebug(name) {
		if (!this.debug) {
			refuse(`${name}: is not in this module: load it with { debug: true }`);
		}
	}

	/// The categories of what Character.draw() shows.
	get drawInfos() {
		this.#needDebug("drawInfos");
		const { exports, memory } = this.#module;
		return memory.scope((scope) => {
			const countAt = scope.room(4);
			const table = exports.soleGetDrawInfos(countAt);
			return Array.from({ length: memory.getWord(countAt) }, (_, i) => {
				const at = table + i * sizeOf("soleDrawInfo");
				return {
					category: memory.get("soleDrawInfo", at, "category"),
					name: memory.getText("soleDrawInfo", at, "name"),
					text: memory.getText("soleDrawInfo", at, "text"),
				};
			});
		});
	}

	/// Records what goes into a character's frames and what comes out.
	createTracer(character, capacity) {
		this.#needDebug("createTracer");
		return new Tracer(this.#module, character, capacity);
	}

	/// Plays a recorded trace and compares it bit by bit.
	replayTrace(bytes) {
		this.#needDebug("replayTrace");
		const { exports, memory } = this.#module;
		return memory.scope((scope) => {
			const at = scope.struct("soleTraceReport");
			const message = scope.struct("soleMessage");
			if (exports.soleReplayTrace(scope.numbers(bytes), bytes.length, 0, at, message) !== 0) {
				refuse(memory.text(message));
			}
			const first = at + offsetOf("soleTraceReport", "first");
			const get = (field) => memory.get("soleTraceDifference", first, field);
			return {
				frameCount: memory.get("soleTraceReport", at, "frameCount"),
				legCount: memory.get("soleTraceReport", at, "legCount"),
				differentFrames: memory.get("soleTraceReport", at, "differentFrames"),
				first: get("frame") < 0 ? null : {
					frame: get("frame"),
					leg: get("leg"),
					field: memory.getText("soleTraceDifference", first, "field"),
					component: get("component"),
					recorded: get("recorded"),
					replayed: get("replayed"),
				},
			};
		});
	}
}
