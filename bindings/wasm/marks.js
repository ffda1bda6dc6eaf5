// SPDX-License-Identifier: MIT
// The list into which a frame is drawn: a module without imports has nobody to call.
import { sizeOf } from "./memory.js";

const markKinds = ["line", "arrow", "circle", "sphere", "text"];

export class Marks {
	#memory;
	#at = 0;
	#capacity = 0;

	constructor(memory) {
		this.#memory = memory;
	}

	#read(index) {
		const memory = this.#memory;
		const at = this.#at + index * sizeOf("soleWasmMark");
		const get = (field) => memory.get("soleWasmMark", at, field);
		const kind = markKinds[get("kind")];
		const mark = { kind, color: get("color"), category: get("category") };
		mark.a = Array.from(memory.view("soleWasmMark", at, "a_w"));
		mark.b = Array.from(memory.view("soleWasmMark", at, "b_w"));
		mark.radius = get("radius");
		mark.text = kind === "text" ? memory.getText("soleWasmMark", at, "text") : "";
		return mark;
	}

	/// @param draw called with where marks go and how many may; returns how many there are
	collect(draw) {
		let count = draw(this.#at, this.#capacity);
		if (count > this.#capacity) {
			this.dispose();
			this.#capacity = 2 * count;
			this.#at = this.#memory.allocate(this.#capacity * sizeOf("soleWasmMark"));
			count = draw(this.#at, this.#capacity);
		}
		return Array.from({ length: count }, (_, index) => this.#read(index));
	}

	dispose() {
		this.#memory.free(this.#at);
		this.#at = 0;
		this.#capacity = 0;
	}
}
