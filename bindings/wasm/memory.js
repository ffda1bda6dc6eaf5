// SPDX-License-Identifier: MIT
// The module's memory as JavaScript sees it: typed arrays over where the library's structs lie. They are made anew when
// the memory has grown, which happens only where something is created.
import { layout } from "./layout.js";

const NONE = -1;
const decoder = new TextDecoder();
const encoder = new TextEncoder();
const arrays = { f: Float32Array, d: Float64Array, i: Int32Array, u: Uint32Array, p: Uint32Array, h: Int16Array };

/// How many bytes a struct has.
export function sizeOf(struct) {
	return layout[struct].whole;
}

/// How many bytes a field has.
export function fieldSize(struct, field) {
	return layout[struct][field][1];
}

export function offsetOf(struct, field) {
	return layout[struct][field][0];
}

export class Memory {
	#exports;
	#buffer;

	constructor(exports) {
		this.#exports = exports;
		this.refresh();
	}

	/// Views are valid for as long as this is the same.
	get buffer() {
		if (this.#buffer !== this.#exports.memory.buffer) {
			this.refresh();
		}
		return this.#buffer;
	}

	refresh() {
		this.#buffer = this.#exports.memory.buffer;
		this.data = new DataView(this.#buffer);
		this.bytes = new Uint8Array(this.#buffer);
	}

	allocate(byteCount) {
		const at = this.#exports.malloc(Math.max(byteCount, 1));
		if (at === 0) {
			throw new Error(`out of memory: ${byteCount} bytes were asked for`);
		}
		this.buffer;
		return at;
	}

	free(at) {
		this.#exports.free(at);
	}

	// -------------------------------------------------------------------------------------------------- fields

	#find(struct, field) {
		this.buffer;
		return layout[struct][field];
	}

	/// A number, or false and true.
	get(struct, at, field) {
		const [offset, , type] = this.#find(struct, field);
		switch (type) {
			case "f":
				return this.data.getFloat32(at + offset, true);
			case "d":
				return this.data.getFloat64(at + offset, true);
			case "i":
				return this.data.getInt32(at + offset, true);
			case "h":
				return this.data.getInt16(at + offset, true);
			case "b":
				return this.bytes[at + offset] !== 0;
			default:
				return this.data.getUint32(at + offset, true);
		}
	}

	set(struct, at, field, value) {
		const [offset, , type] = this.#find(struct, field);
		switch (type) {
			case "f":
				this.data.setFloat32(at + offset, value, true);
				break;
			case "d":
				this.data.setFloat64(at + offset, value, true);
				break;
			case "b":
				this.bytes[at + offset] = value ? 1 : 0;
				break;
			default:
				this.data.setUint32(at + offset, value, true);
		}
	}

	/// The numbers of a field where they lie.
	view(struct, at, field) {
		const [offset, byteCount, type] = this.#find(struct, field);
		const array = arrays[type];
		return new array(this.buffer, at + offset, byteCount / array.BYTES_PER_ELEMENT);
	}

	/// A pointer or a count that a call has left.
	getWord(at) {
		this.buffer;
		return this.data.getUint32(at, true);
	}

	floats(at, count) {
		return new Float32Array(this.buffer, at, count);
	}

	// --------------------------------------------------------------------------------------------------- text

	/// Up to the zero byte, at most limit bytes.
	text(at, limit = 65536) {
		this.buffer;
		const end = this.bytes.indexOf(0, at);
		return decoder.decode(this.bytes.subarray(at, Math.min(end, at + limit)));
	}

	/// Text that a field holds.
	getText(struct, at, field) {
		const [offset, byteCount, type] = this.#find(struct, field);
		return type === "p" ? this.text(this.get(struct, at, field)) : this.text(at + offset, byteCount);
	}

	// -------------------------------------------------------------------------------------- memory for one call

	/// Calls back with a Scope, whose memory ends with the call.
	scope(callback) {
		const scope = new Scope(this);
		try {
			return callback(scope);
		} finally {
			scope.end();
		}
	}
}

/// Memory for what a call is given.
export class Scope {
	#memory;
	#pieces = [];

	constructor(memory) {
		this.#memory = memory;
	}

	/// Zeroed.
	room(byteCount) {
		const at = this.#memory.allocate(byteCount);
		this.#pieces.push(at);
		this.#memory.bytes.fill(0, at, at + byteCount);
		return at;
	}

	struct(name, count = 1) {
		return this.room(sizeOf(name) * count);
	}

	text(text) {
		const bytes = encoder.encode(text);
		const at = this.room(bytes.length + 1);
		this.#memory.bytes.set(bytes, at);
		return at;
	}

	/// A copy of numbers, of the array's own type.
	numbers(array) {
		const at = this.room(array.byteLength);
		this.#memory.bytes.set(new Uint8Array(array.buffer, array.byteOffset, array.byteLength), at);
		return at;
	}

	end() {
		for (const at of this.#pieces.splice(0)) {
			this.#memory.free(at);
		}
	}
}

// ---------------------------------------------------------------------------------------------------------- checks

/// Something the caller can mend: the sentence says how.
export function refuse(sentence) {
	throw new Error(sentence);
}

/// Numbers as an array of a type, of that many of them where a count is given.
export function takeNumbers(what, value, array, count) {
	const usable = Array.isArray(value) || (ArrayBuffer.isView(value) && !(value instanceof DataView));
	if (!usable) {
		refuse(`${what}: is no array: give numbers`);
	}
	const numbers = value instanceof array ? value : array.from(value);
	if (count !== undefined && numbers.length !== count) {
		refuse(`${what}: has ${numbers.length} numbers: give ${count}`);
	}
	return numbers;
}

/// Three numbers from an array or from something with x, y and z.
export function takeVector(what, value) {
	const vector = value !== null && typeof value === "object" && "x" in value ? [value.x, value.y, value.z] : value;
	return takeNumbers(what, vector, Float32Array, 3);
}

export function takeCount(what, value, least, most) {
	if (!Number.isInteger(value) || value < least || value > most) {
		refuse(`${what}: is ${value}: give a whole number from ${least} to ${most}`);
	}
	return value;
}

export { NONE };
