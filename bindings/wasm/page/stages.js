// SPDX-License-Identifier: MIT
// Time per stage of the solver: plays a recorded trace in a module that tells when a stage has ended. Clocks of
// browsers are coarse: a stage is far shorter than their ticks, and only the mean over many frames means something. Of
// the rounds in which a trace is played the slower half is left out: something else had the processor then.
import { layout } from "../layout.js";
import { openModule } from "../load.js";
import { Memory, refuse } from "../memory.js";

export class StageMeter {
	#memory;
	#exports;
	#sums = new Map();
	#last = 0;
	#names = new Map();

	/// From when the last stage ended, or the frame began, to now.
	end(nameAt) {
		const now = performance.now();
		let name = this.#names.get(nameAt);
		if (name === undefined) {
			name = this.#memory.text(nameAt);
			this.#names.set(nameAt, name);
			this.#sums.set(name, 0);
		}
		this.#sums.set(name, this.#sums.get(name) + now - this.#last);
		this.#last = now;
	}

	begin() {
		this.#last = performance.now();
	}

	use(exports) {
		this.#exports = exports;
		this.#memory = new Memory(exports);
	}

	/// Plays a trace once. @return milliseconds of each stage
	#play(play) {
		this.#sums.forEach((_, name) => this.#sums.set(name, 0));
		if (play() !== 0) {
			return null;
		}
		return Array.from(this.#sums.values());
	}

	/// Microseconds a frame of each stage, in the order in which they run. @param rounds so often the trace is played
	measure(trace, rounds = 1) {
		const memory = this.#memory;
		return memory.scope((scope) => {
			const report = scope.room(layout.soleTraceReport.whole);
			const message = scope.struct("soleMessage");
			const bytes = scope.numbers(trace);
			const play = () => this.#exports.soleReplayTrace(bytes, trace.length, 0, report, message);
			const played = Array.from({ length: rounds }, () => this.#play(play) ?? refuse(memory.text(message)));
			const total = (times) => times.reduce((sum, time) => sum + time, 0);
			const quick = played.sort((a, b) => total(a) - total(b)).slice(0, Math.ceil(rounds / 2));
			const frames = quick.length * Math.max(memory.get("soleTraceReport", report, "frameCount"), 1);
			return {
				differentFrames: memory.get("soleTraceReport", report, "differentFrames"),
				stages: Array.from(this.#sums.keys(), (name, k) => ({ name, cost: (1e3 * total(quick.map((times) => times[k]))) / frames })),
			};
		});
	}
}

/// @param source url of the module, or bytes
export async function loadStageMeter(source) {
	const meter = new StageMeter();
	const sole = { begin: () => meter.begin(), end: (nameAt) => meter.end(nameAt) };
	meter.use(await openModule(source, { sole }));
	return meter;
}
