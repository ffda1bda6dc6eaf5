// SPDX-License-Identifier: MIT
// The steps of a clip, and what they say of a character's legs in a frame: what a game knows of its clips beforehand.
import { refuse, sizeOf, takeVector } from "./memory.js";

const numbers = ["leg", "strike", "lift", "heelDown", "heelUp", "toeDown", "toeUp"];
const MOST_FORESEEN = 1e6; // s: further off is never

export class Steps {
	#module;
	#velocity;
	#travel;
	at;

	/// @param steps as findSteps() finds them, of a clip of this duration
	constructor(module, steps, { duration, loops = false }) {
		const { memory } = module;
		this.#module = module;
		this.count = steps.length;
		this.duration = duration;
		this.loops = loops;
		this.at = memory.allocate(this.count * sizeOf("soleStep"));
		steps.forEach((step, i) => {
			const at = this.at + i * sizeOf("soleStep");
			numbers.forEach((field) => memory.set("soleStep", at, field, step[field]));
			memory.view("soleStep", at, "place").set(takeVector(`steps[${i}].place`, step.place));
			memory.view("soleStep", at, "forward").set(takeVector(`steps[${i}].forward`, step.forward));
		});
		this.#velocity = memory.allocate(24); // and up
		this.#travel = memory.allocate(40);
	}

	/// Fills in contact and steps of a character's frame.
	/// time of the clip, and the rate of its play; velocity along the floor and turn rate about up of the root, as seen
	/// from itself, in character units and radians a second: it is taken to go on like that
	tell(character, { time, rate = 1, velocity, turnRate = 0 }) {
		if (this.at === 0 || character.at === 0) {
			refuse("steps: they or the character were disposed of: keep them for as long as they are used");
		}
		const { memory, exports } = this.#module;
		memory.floats(this.#velocity, 3).set(takeVector("velocity", velocity));
		memory.floats(this.#velocity + 12, 3).set(character.rig.definition.up ?? [0, 1, 0]);
		const { contact, steps } = character;
		const size = sizeOf("soleStepInput");
		for (let leg = 0; leg < character.rig.legCount; ++leg) {
			const contactAt = contact.byteOffset + leg * sizeOf("soleContactInput");
			const stepAt = steps.byteOffset + leg * size;
			const loops = this.loops ? 1 : 0;
			exports.soleGetStepInput(this.at, this.count, this.duration, loops, time, leg, contactAt, stepAt);
			this.#toWorldTime(memory.floats(stepAt, 2), rate);
			const until = memory.floats(stepAt, 2)[1];
			if (until >= 0) {
				exports.soleExtrapolate(this.#travel, this.#velocity, turnRate, this.#velocity + 12, until);
				exports.soleStepInput_Travel(stepAt, this.#travel);
			}
		}
	}

	/// Since and until, from the clip's time. A clip that stands still foretells nothing.
	#toWorldTime(times, rate) {
		times[0] = times[0] > 0 ? times[0] / rate : times[0];
		const until = times[1] / rate;
		times[1] = until >= 0 && until < MOST_FORESEEN ? until : -1;
	}

	dispose() {
		for (const at of [this.at, this.#velocity, this.#travel]) {
			this.#module.memory.free(at);
		}
		this.at = 0;
	}
}
