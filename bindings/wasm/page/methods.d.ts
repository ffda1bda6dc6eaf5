// SPDX-License-Identifier: MIT
import type { Character, Ground, GroundParts, Pieces, Rig, RigDefinition, SettingInfo } from "../sole.js";

export type MethodName = "homebrew" | "iksetting" | "effector" | "ozz";
export const methodNames: readonly MethodName[];

/// Settings of its own, by the names of the original: "homebrew.smoothTime".
export interface MethodCharacter extends Character {
	readonly ownInfos: readonly SettingInfo[];
	getOwn(name: string): number;
	setOwn(name: string, value: number): void;
}

export interface Methods {
	createRig(definition: RigDefinition): Rig;
	createGround(parts: GroundParts): Ground;
	createPieces(pieces: readonly { ground: Ground | null; surface?: number }[]): Pieces;
	createCharacter(rig: Rig, method: MethodName): MethodCharacter;
}

export function loadMethods(source: { url?: URL; bytes?: BufferSource | WebAssembly.Module }): Promise<Methods>;
