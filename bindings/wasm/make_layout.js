// SPDX-License-Identifier: MIT
// Prints where the fields of the library's structs are in the module's memory, as the source of layout.js:
// node make_layout.js fields.wasm. Each is [offset, bytes, type].
import { readFileSync } from "node:fs";

const ROW_BYTES = 16;

const { exports } = new WebAssembly.Instance(new WebAssembly.Module(readFileSync(process.argv[2])));
const bytes = new Uint8Array(exports.memory.buffer);
const words = new Uint32Array(exports.memory.buffer);
const layout = {};
for (let i = 0; i < exports.soleWasm_CountFields(); ++i) {
	const [nameAt, offset, byteCount, type] = words.subarray((exports.soleWasm_GetFields() + ROW_BYTES * i) / 4);
	const [struct, field] = new TextDecoder().decode(bytes.subarray(nameAt, bytes.indexOf(0, nameAt))).split(".");
	layout[struct] ??= {};
	if (field === undefined) {
		layout[struct].whole = byteCount;
	} else {
		layout[struct][field] = [offset, byteCount, String.fromCharCode(type)];
	}
}
console.log("// SPDX-License-Identifier: MIT\n// Made by make_layout.js together with the modules beside it.");
console.log(`export const layout = ${JSON.stringify(layout, null, "\t")};`);
