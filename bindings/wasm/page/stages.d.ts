// SPDX-License-Identifier: MIT

export interface StageTimes {
	/** Frames whose outcome is not the recorded one: 0. */
	differentFrames: number;
	/** Microseconds a frame, in the order in which the stages run. */
	stages: { name: string; cost: number }[];
}

export interface StageMeter {
	/** Plays a trace of Tracer.finish() so often. */
	measure(trace: Uint8Array, rounds?: number): StageTimes;
}

export function loadStageMeter(source: { url?: URL; bytes?: BufferSource | WebAssembly.Module }): Promise<StageMeter>;
