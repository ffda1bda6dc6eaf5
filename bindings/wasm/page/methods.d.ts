// SPDX-License-Identifier: MIT
import type { Character, Ground, GroundParts, Pieces, Rig, RigDefinition } from "../sole.js";

export type MethodName = "homebrew" | "iksetting" | "effector" | "ozz";
export const methodNames: readonly MethodName[];

export interface Methods {
	createRig(definition: RigDefinition): Rig;
	createGround(parts: GroundParts): Ground;
	createPieces(pieces: readonly { ground: Ground | null; surface?: number }[]): Pieces;
	createCharacter(rig: Rig, method: MethodName): Character;
}

export function loadMethods(source: { url?: URL; bytes?: BufferSource | WebAssembly.Module }): Promise<Methods>;
