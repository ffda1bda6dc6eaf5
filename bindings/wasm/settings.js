// SPDX-License-Identifier: MIT
// Settings by their dotted names, and as the JSON that the program sole reads and writes.
import { settingTexts } from "./layout.js";
import { refuse, sizeOf } from "./memory.js";

const kinds = ["number", "choice", "mask"];

/// A table of settings. Sentences that the module is without lie in layout.js.
export function readInfoTable(memory, table, count) {
	return Array.from({ length: count }, (_, i) => {
		const at = table + i * sizeOf("soleSettingInfo");
		const get = (field) => memory.get("soleSettingInfo", at, field);
		const text = (field) => memory.getText("soleSettingInfo", at, field);
		const name = text("name");
		return Object.freeze({
			name,
			unit: text("unit"),
			kind: kinds[get("type")],
			minimum: get("minimum"),
			maximum: get("maximum"),
			default: get("defaultValue"),
			text: settingTexts[name] ?? text("text"),
			at,
		});
	});
}

/// The library's table of settings.
export function readSettingInfos({ memory, exports }) {
	return memory.scope((scope) => {
		const countAt = scope.room(4);
		return readInfoTable(memory, exports.soleGetSettingInfos(countAt), memory.getWord(countAt));
	});
}

/// The shortest number that is the same float.
export function shorten(value) {
	for (let digits = 1; digits < 9; ++digits) {
		const short = Number(value.toPrecision(digits));
		if (Math.fround(short) === value) {
			return short;
		}
	}
	return Number(value.toPrecision(9));
}

export class Settings {
	#module;
	#infos;
	at;

	constructor(module, infos) {
		this.#module = module;
		this.#infos = infos;
		this.at = module.memory.allocate(sizeOf("soleSettings"));
		this.reset();
	}

	/// All back to their defaults.
	reset() {
		this.#module.exports.soleDefaultSettings(this.at);
	}

	#find(name) {
		return this.#infos.get(name) ?? refuse(`${name}: is no setting: see settingInfos`);
	}

	get(name) {
		const info = this.#find(name);
		const value = this.#module.exports.soleSettings_Get(this.at, info.at);
		return info.kind === "number" ? shorten(value) : value;
	}

	#check(name, value) {
		const info = this.#find(name);
		const whole = info.kind !== "number";
		const unit = info.unit === "" ? "" : ` ${info.unit}`;
		const range = `from ${info.minimum} to ${info.maximum}${unit}`;
		if (typeof value !== "number" || !Number.isFinite(value) || (whole && !Number.isInteger(value))) {
			refuse(`${name}: is not a ${whole ? "whole " : ""}number: give one ${range}`);
		}
		// A range's end such as 0.87 is read as it is written, but kept as a float.
		if (value < info.minimum - 1e-6 || value > info.maximum + 1e-6) {
			refuse(`${name}: is ${value}, out of range: give a value ${range}`);
		}
		return info;
	}

	set(name, value) {
		this.#module.exports.soleSettings_Set(this.at, this.#check(name, value).at, value);
	}

	/// { probe: { radius: 0.05, ... }, ... }
	toJSON() {
		const json = {};
		for (const { name } of this.#infos.values()) {
			const [stage, field] = name.split(".");
			(json[stage] ??= {})[field] = this.get(name);
		}
		return json;
	}

	/// Takes over what is named, from an object or from text; all of it or, where something is wrong, nothing.
	fromJSON(json) {
		const given = typeof json === "string" ? JSON.parse(json) : json;
		const isObject = (value) => value !== null && typeof value === "object" && !Array.isArray(value);
		if (!isObject(given)) {
			refuse("settings: are no JSON object: write { \"probe\": { \"radius\": 0.05 } }");
		}
		const changes = [];
		for (const [stage, fields] of Object.entries(given)) {
			if (!isObject(fields)) {
				refuse(`${stage}: is not an object: write { "${stage}": { ... } }`);
			}
			for (const [field, value] of Object.entries(fields)) {
				changes.push([this.#check(`${stage}.${field}`, value), value]);
			}
		}
		for (const [info, value] of changes) {
			this.#module.exports.soleSettings_Set(this.at, info.at, value);
		}
		return this;
	}

	dispose() {
		this.#module.memory.free(this.at);
		this.at = 0;
	}
}
