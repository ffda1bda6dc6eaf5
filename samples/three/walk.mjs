// SPDX-License-Identifier: MIT
// A character of three.js walks up stairs, with its feet on them. Runs without a browser, as the tests run it:
//   sole sample mannequin -o mannequin.glb; sole sample stairs -o stairs.glb
//   node samples/three/walk.mjs mannequin.glb stairs.glb
import { readFile } from "node:fs/promises";
import { AnimationMixer, Raycaster, Scene, Vector3 } from "three";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";
import { loadSole } from "sole";
import { SoleSkin, groundFromObject } from "sole/three";

const FRAMES = 240;
const RATE = 60;
const SPEED = 1.3; // m/s, the walk's own

async function loadModel(path) {
	const { buffer, byteOffset, byteLength } = await readFile(path);
	return new GLTFLoader().parseAsync(buffer.slice(byteOffset, byteOffset + byteLength), "");
}

/// Height of the level below a place, as a game that has no physics would ask for it.
function findHeight(level, x, z) {
	const ray = new Raycaster(new Vector3(x, 100, z), new Vector3(0, -1, 0));
	return ray.intersectObject(level, true)[0]?.point.y ?? 0;
}

/// Calls back after every frame with the scene as it would be drawn.
export async function walk(characterPath, levelPath, onFrame) {
	const [model, { scene: level }] = [await loadModel(characterPath), await loadModel(levelPath)];
	const scene = new Scene().add(model.scene, level);
	const mixer = new AnimationMixer(model.scene);

	const sole = await loadSole();
	const ground = groundFromObject(sole, level);
	const feet = new SoleSkin(sole, model.scene, { ground });

	mixer.clipAction(model.animations.find((clip) => clip.name === "walk")).play();
	for (let i = 0; i < FRAMES; ++i) {
		const z = 0.8 + (i / RATE) * SPEED;
		model.scene.position.set(0, findHeight(level, 0, z), z);
		mixer.update(1 / RATE);
		feet.update(1 / RATE);
		scene.updateMatrixWorld();
		onFrame({ feet, ground, index: i });
	}
	feet.dispose();
	ground.dispose();
}

if (process.argv[1] === new URL(import.meta.url).pathname) {
	let planted = 0;
	let furthest = 0;
	await walk(process.argv[2], process.argv[3], ({ feet }) => {
		for (const leg of feet.character.output.legs) {
			planted += leg.plantWeight;
			furthest = Math.max(furthest, leg.error);
		}
	});
	console.log(`${FRAMES} frames, ${(planted / FRAMES).toFixed(2)} feet planted, at most ${furthest.toFixed(3)} m off`);
}
