// SPDX-License-Identifier: MIT
// Records one character: the bytes can be played back bit by bit, here or by the program sole.
import { offsetOf, refuse, sizeOf } from "./memory.js";
import { putDefinition } from "./rig.js";

export class Tracer {
	#module;
	#character;
	#sink;
	#buffer;
	#tracer;

	/// @param capacity bytes of the longest trace
	constructor(module, character, capacity = 16 << 20) {
		const { memory, exports } = module;
		this.#module = module;
		this.#character = character;
		// The bytes lie behind the struct that says where they are.
		this.#buffer = memory.allocate(sizeOf("soleTraceBuffer") + capacity);
		memory.set("soleTraceBuffer", this.#buffer, "bytes", this.#buffer + sizeOf("soleTraceBuffer"));
		memory.set("soleTraceBuffer", this.#buffer, "capacity", capacity);
		memory.set("soleTraceBuffer", this.#buffer, "byteCount", 0);
		this.#sink = memory.allocate(sizeOf("soleTraceSink"));
		exports.soleMakeBufferSink(this.#sink, this.#buffer);
		this.#tracer = memory.scope((scope) => {
			const definition = putDefinition(module, scope, character.rig.definition);
			const out = scope.room(4);
			const message = scope.struct("soleMessage");
			if (exports.soleCreateTracer(definition, this.#sink, 0, out, message) !== 0) {
				refuse(memory.text(message));
			}
			return memory.getWord(out);
		});
	}

	/// Instead of the character's own solve(): the same, recorded.
	solve() {
		const { memory, exports } = this.#module;
		const { at, settings, probeCount } = this.#character;
		const inside = (field) => at + offsetOf("soleWasmCharacter", field);
		const hits = memory.get("soleWasmCharacter", at, "hits");
		const [state, frame] = [inside("state"), inside("frame")];
		exports.soleTracer_BeginFrame(this.#tracer, settings.at, state, frame, hits, probeCount);
		this.#character.solve();
		exports.soleTracer_EndFrame(this.#tracer, state, inside("output"));
	}

	/// The whole trace. Nothing can be recorded after it.
	finish() {
		const { memory, exports } = this.#module;
		if (exports.soleTracer_Finish(this.#tracer) === 0) {
			refuse("trace: is longer than the tracer's capacity: give more, or record less");
		}
		const from = memory.get("soleTraceBuffer", this.#buffer, "bytes");
		memory.buffer;
		return memory.bytes.slice(from, from + memory.get("soleTraceBuffer", this.#buffer, "byteCount"));
	}

	dispose() {
		this.#module.exports.soleDestroyTracer(this.#tracer);
		this.#module.memory.free(this.#sink);
		this.#module.memory.free(this.#buffer);
		this.#tracer = 0;
	}
}
