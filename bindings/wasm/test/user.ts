// SPDX-License-Identifier: MIT
// A user's program in TypeScript: compiled by the tests, never run. What must not compile is marked.
import { LegFlags, loadSole } from "sole";
import type { Character, Hit, Probe, SettingsJSON } from "sole";
import { SoleSkin, groundFromObject } from "sole/three";
import { Mesh, SkinnedMesh, Vector3 } from "three";

const sole = await loadSole({ simd: true });
const settings = sole.createSettings({ pelvis: { halfLife: 0.1 } });
const json: SettingsJSON = settings.toJSON();
settings.set("pelvis.halfLife", json["pelvis"]?.["halfLife"] ?? 0.1);

const { rig, findings } = sole.detectRig({ names: ["a"], parents: [-1], bindPose: new Float32Array(10) });
findings.forEach((finding) => console.log(finding.severity, finding.mend));
const character: Character = sole.createCharacter(rig, { settings });
character.pose = new Float32Array(10 * rig.jointCount);
character.frame.root = [0, 0, 0, 0, 0, 0, 1, 1, 1, 1];
character.frame.timeStep = 1 / 60;
character.update((probe: Probe, hit: Hit) => {
	hit.put(probe.start, new Vector3(0, 1, 0));
});
const planted: boolean = ((character.output.legs[0]?.flags ?? 0) & LegFlags.planted) !== 0;
const saved: Uint8Array = character.snapshot();
character.restore(saved);

const feet = new SoleSkin(sole, new SkinnedMesh(), { ground: groundFromObject(sole, new Mesh()), settings });
feet.update(1 / 60);
feet.ground = (probe, hit) => hit.put([0, 0, 0], [0, probe.length, 0]);

// @ts-expect-error: a setting is a number
settings.set("pelvis.halfLife", "0.1");
// @ts-expect-error: the placed pose is read only
character.placed = new Float32Array(10);
// @ts-expect-error: there is no such call
sole.createLeg();
// @ts-expect-error: a ground is needed
character.update();
console.log(planted);
