// SPDX-License-Identifier: MIT
// The four systems that Sole is compared with, as characters that are used like Sole's own: for the page, which shows
// them side by side. A module of its own, whose rigs and grounds are its own too.
import { Character } from "../character.js";
import { Pieces, createGround } from "../ground.js";
import { openModule } from "../load.js";
import { Memory, offsetOf, refuse } from "../memory.js";
import { createRig } from "../rig.js";
import { Settings, readSettingInfos } from "../settings.js";

/// In the order of soleAncestorKind.
export const methodNames = ["homebrew", "iksetting", "effector", "ozz"];

/// A character whose feet another system places: the frame, its hits and the outcome lie where they do for Sole.
class MethodCharacter extends Character {
	#module;
	#method;

	constructor(module, rig, method, settings) {
		super(module, rig, { settings }, settings);
		const { memory, exports } = module;
		const kind = methodNames.indexOf(method);
		if (kind < 0) {
			refuse(`method: there is no '${method}': give one of ${methodNames.join(", ")}`);
		}
		this.#module = module;
		this.#method = memory.allocate(exports.soleAncestor_GetByteCount());
		memory.scope((scope) => {
			const bindPose = scope.numbers(Float32Array.from(rig.definition.bindPose));
			exports.soleStartAncestor(this.#method, kind, rig.at, bindPose);
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

	dispose() {
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
