// SPDX-License-Identifier: MIT
// The four systems that Sole is compared with, as characters that are used like Sole's own: for the page, which shows
// them side by side. A module of its own, whose rigs and grounds are its own too. Each has its own settings, with the
// names of the original, beside Sole's, which do not reach it.
import { Character } from "../character.js";
import { Pieces, createGround } from "../ground.js";
import { openModule } from "../load.js";
import { Marks } from "../marks.js";
import { Memory, offsetOf, refuse } from "../memory.js";
import { createRig } from "../rig.js";
import { Settings, readInfoTable, readSettingInfos, shorten } from "../settings.js";

/// In the order of soleAncestorKind.
export const methodNames = ["homebrew", "iksetting", "effector", "ozz"];

function kindOf(method) {
	const kind = methodNames.indexOf(method);
	return kind >= 0 ? kind : refuse(`method: there is no '${method}': give one of ${methodNames.join(", ")}`);
}

function readOwnInfos({ memory, exports }, method) {
	return memory.scope((scope) => {
		const countAt = scope.room(4);
		const table = exports.soleGetAncestorSettingInfos(kindOf(method), countAt);
		return readInfoTable(memory, table, memory.getWord(countAt));
	});
}

/// A character whose feet another system places: the frame, its hits and the outcome lie where they do for Sole.
class MethodCharacter extends Character {
	#module;
	#method;
	#infos;
	#marks;

	constructor(module, rig, method, settings) {
		super(module, rig, { settings }, settings);
		const { memory, exports } = module;
		const kind = kindOf(method);
		this.#module = module;
		this.#infos = new Map(readOwnInfos(module, method).map((info) => [info.name, info]));
		this.#marks = new Marks(memory);
		this.#method = memory.allocate(exports.soleAncestor_GetByteCount());
		memory.scope((scope) => {
			const bindPose = scope.numbers(Float32Array.from(rig.definition.bindPose));
			exports.soleStartAncestor(this.#method, kind, rig.at, bindPose);
		});
	}

	#find(name) {
		return this.#infos.get(name) ?? refuse(`${name}: is no setting of this method: see ownInfos`);
	}

	getOwn(name) {
		const info = this.#find(name);
		const value = this.#module.exports.soleAncestor_GetSetting(this.#method, info.at);
		return info.kind === "number" ? shorten(value) : value;
	}

	setOwn(name, value) {
		if (!Number.isFinite(value)) {
			refuse(`${name}: is not a number`);
		}
		this.#module.exports.soleAncestor_SetSetting(this.#method, this.#find(name).at, value);
	}

	/// The table of its own settings, with the defaults that were fitted to the character. Ranges are an average human's,
	/// or wider where the default lies outside.
	get ownInfos() {
		return Array.from(this.#infos.values(), (info) => {
			const fitted = this.getOwn(info.name);
			const minimum = fitted < info.minimum ? 2 * fitted : info.minimum;
			const maximum = fitted > info.maximum ? 2 * fitted : info.maximum;
			return { ...info, default: fitted, minimum, maximum };
		});
	}

	#inside(field) {
		return this.at + offsetOf("soleWasmCharacter", field);
	}

	#get(field) {
		return this.#module.memory.get("soleWasmCharacter", this.at, field);
	}

	gather() {
		const { memory, exports } = this.#module;
		const count = exports.soleGatherAncestor(this.#method, this.rig.at, this.#inside("frame"), this.#get("probes"));
		memory.set("soleWasmCharacter", this.at, "probeCount", count);
		return count;
	}

	solve() {
		const { exports } = this.#module;
		const [frame, output] = [this.#inside("frame"), this.#inside("output")];
		exports.soleSolveAncestor(this.#method, this.rig.at, frame, this.#get("hits"), this.probeCount, output);
		this.placed.set(this.pose);
		exports.soleApply(this.rig.at, output, this.#get("placed"));
	}

	/// What the last frame shows of itself, as a list.
	draw(mask = 0xffffffff) {
		const { memory, exports } = this.#module;
		return memory.scope((scope) => {
			const [pen, list] = [scope.struct("soleDebugDraw"), scope.struct("soleWasmMarks")];
			exports.soleWasm_MakePen(pen, list, mask);
			// soleDrawnAncestor: pointers and a count, in its order.
			const drawn = scope.numbers(Uint32Array.of(this.rig.at, this.#inside("frame"), this.#get("placed"),
				this.#get("probes"), this.#get("hits"), this.probeCount, this.#inside("output")));
			return this.#marks.collect((at, capacity) => {
				memory.set("soleWasmMarks", list, "marks", at);
				memory.set("soleWasmMarks", list, "count", 0);
				memory.set("soleWasmMarks", list, "capacity", capacity);
				exports.soleDrawAncestor(pen, drawn);
				return memory.get("soleWasmMarks", list, "count");
			});
		});
	}

	dispose() {
		this.#marks.dispose();
		this.#module.memory.free(this.#method);
		super.dispose();
	}
}

export class Methods {
	#module;
	#infos;

	constructor(exports) {
		this.#module = { exports, memory: new Memory(exports) };
		this.#infos = new Map(readSettingInfos(this.#module).map((info) => [info.name, info]));
	}

	createRig(definition) {
		return createRig(this.#module, definition);
	}

	createGround(parts) {
		return createGround(this.#module, parts);
	}

	createPieces(pieces) {
		return new Pieces(this.#module, pieces);
	}

	/// @param method one of methodNames
	createCharacter(rig, method) {
		return new MethodCharacter(this.#module, rig, method, new Settings(this.#module, this.#infos));
	}
}

/// @param source its url, or bytes
export async function loadMethods(source) {
	return new Methods(await openModule(source));
}
