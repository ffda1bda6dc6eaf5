// SPDX-License-Identifier: MIT
// Prints where the fields of the library's structs are in the module's memory, as the source of layout.js:
// node make_layout.js fields.wasm. Each is [offset, bytes, type]. With them go the sentences of the table of settings,
// which the modules themselves are without.
import { readFileSync } from "node:fs";

const ROW_BYTES = 16;

const { exports } = new WebAssembly.Instance(new WebAssembly.Module(readFileSync(process.argv[2])));
const countAt = exports.malloc(4);
const table = exports.soleGetSettingInfos(countAt);
const bytes = new Uint8Array(exports.memory.buffer);
const words = new Uint32Array(exports.memory.buffer);
const readText = (at) => new TextDecoder().decode(bytes.subarray(at, bytes.indexOf(0, at)));
const layout = {};
for (let i = 0; i < exports.soleWasm_CountFields(); ++i) {
	const [nameAt, offset, byteCount, type] = words.subarray((exports.soleWasm_GetFields() + ROW_BYTES * i) / 4);
	const [struct, field] = readText(nameAt).split(".");
	layout[struct] ??= {};
	if (field === undefined) {
		layout[struct].whole = byteCount;
	} else {
		layout[struct][field] = [offset, byteCount, String.fromCharCode(type)];
	}
}

const wordOf = (struct, at, field) => words[(at + layout[struct][field][0]) / 4];
const settingTexts = {};
for (let i = 0; i < words[countAt / 4]; ++i) {
	const at = table + i * layout.soleSettingInfo.whole;
	settingTexts[readText(wordOf("soleSettingInfo", at, "name"))] = readText(wordOf("soleSettingInfo", at, "text"));
}
console.log("// SPDX-License-Identifier: MIT\n// Made by make_layout.js together with the modules beside it.");
console.log(`export const layout = ${JSON.stringify(layout, null, "\t")};`);
console.log(`export const settingTexts = ${JSON.stringify(settingTexts, null, "\t")};`);
