// SPDX-License-Identifier: MIT
// The adapter for three.js, without a browser: the sample walks, whatever a mixer leaves alone stays as it was animated,
// and ground is taken from all kinds of meshes.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { test } from "node:test";
import {
	AnimationClip, AnimationMixer, Bone, BoxGeometry, BufferGeometry, Float32BufferAttribute, Group, InstancedMesh,
	Matrix4, Mesh, Object3D, PlaneGeometry, QuaternionKeyframeTrack, Raycaster, Skeleton, SkinnedMesh,
	Uint16BufferAttribute, Vector3,
} from "three";
import { LegFlags } from "sole";
import { SoleSkin, findSkeletonJoints, groundFromObject, readSkeleton } from "sole/three";
import { walk } from "../../../samples/three/walk.mjs";
import { bipedDefinition, bipedSkeleton, loadModule, nativeFile, root } from "./support.mjs";

const sole = await loadModule("sole");
const mannequin = nativeFile("m.glb", "sample", "mannequin", "-o");
const level = nativeFile("stairs.glb", "sample", "stairs", "-o");

/// Soles from 10 behind to 25 ahead of the ankles, 2 below the floor, in centimetres, z up, beside the mesh's own place.
function makeFeet() {
	const [positions, joints, weights] = [[], [], []];
	for (const [foot, x] of [[5, 9], [9, -9]]) {
		for (const ahead of [-10, -5, 0, 5, 10, 15, 20, 25]) {
			for (const side of [-5, 0, 5]) {
				positions.push(x + side - 7, -ahead - 8, -2 - 9);
				joints.push(ahead > 12 ? foot + 1 : foot, 0, 0, 0);
				weights.push(1, 0, 0, 0);
			}
		}
	}
	const geometry = new BufferGeometry();
	geometry.setAttribute("position", new Float32BufferAttribute(positions, 3));
	geometry.setAttribute("skinIndex", new Uint16BufferAttribute(joints, 4));
	geometry.setAttribute("skinWeight", new Float32BufferAttribute(weights, 4));
	return geometry;
}

/// The biped as a SkinnedMesh below an armature, as exporters make it: turned, and in centimetres.
function makeBiped() {
	const { names, parents, bindPose } = bipedSkeleton();
	const armature = new Object3D();
	armature.rotation.x = -Math.PI / 2;
	armature.scale.setScalar(0.01);
	const bones = names.map((name, i) => {
		const bone = new Bone();
		bone.name = name;
		bone.position.fromArray(bindPose, 10 * i).multiplyScalar(100);
		bone.quaternion.fromArray(bindPose, 10 * i + 3);
		return bone;
	});
	bones.forEach((bone, i) => parents[i] >= 0 && bones[parents[i]].add(bone));
	bones[0].rotation.x = Math.PI / 2;
	const mesh = new SkinnedMesh(makeFeet());
	mesh.position.set(7, 8, 9); // which is part of its bind matrix
	armature.add(bones[0], mesh);
	const character = new Group().add(armature);
	character.updateWorldMatrix(true, true);
	mesh.bind(new Skeleton(bones));
	return { character, mesh, bones };
}

const box = (width, height, depth, y) => {
	const mesh = new Mesh(new BoxGeometry(width, height, depth));
	mesh.position.y = y;
	return mesh;
};

test("the sample walks up stairs with its feet on them", async () => {
	const place = new Vector3();
	const range = [Infinity, -Infinity];
	let planted = 0;
	await walk(mannequin, level, ({ feet, index }) => {
		feet.character.output.legs.forEach(({ ankle, flags, planePoint, planeNormal }, leg) => {
			const { joints, toes } = feet.rig.definition.legs[leg];
			// The joint that is drawn is where the library has put it.
			feet.joints[joints[joints.length - 1]].getWorldPosition(place);
			assert.ok(place.toArray().every((x, i) => Math.abs(x - ankle[i]) < 1e-4), `${place.toArray()} is not ${ankle}`);
			if (index < 30 || (flags & LegFlags.planted) === 0) {
				return;
			}
			const toe = feet.joints[toes[0]].getWorldPosition(place).sub(new Vector3(...planePoint));
			const height = toe.dot(new Vector3(...planeNormal));
			planted += 1;
			range[0] = Math.min(range[0], height);
			range[1] = Math.max(range[1], height);
		});
	});
	assert.ok(planted > 100, `${planted}`);
	assert.ok(range[0] > 0 && range[1] < 0.1, `toes from ${range} over the stairs`);
	const said = execFileSync("node", [`${root}/samples/three/walk.mjs`, mannequin, level], { encoding: "utf8" });
	assert.match(said, /^240 frames, 1\.\d+ feet planted, at most 0\.0\d+ m off\n$/);
});

test("legs are found below an armature that is turned and scaled", () => {
	const { character } = makeBiped();
	const feet = new SoleSkin(sole, character, { ground: groundFromObject(sole, box(9, 1, 9, -0.5)) });
	assert.deepEqual(feet.detection.rig.legNames.length, 2);
	assert.ok(Math.abs(feet.rig.legLength(0) - 90) < 0.01, `${feet.rig.legLength(0)}`);
	// Where the mesh has its soles: the armature's space is in centimetres, z up.
	const { heel, toe } = feet.rig.definition.legs.find(({ side }) => side === "left").sole;
	assert.ok(Math.abs(heel[1] - 10) < 2 && Math.abs(toe[1] + 25) < 2 && Math.abs(heel[2] + 2) < 0.1, `${heel} ${toe}`);
	character.position.y = 0.05; // the capsule hovers
	for (let i = 0; i < 60; ++i) {
		feet.update(1 / 60);
	}
	const ankle = feet.joints.find(({ name }) => name === "foot_l").getWorldPosition(new Vector3());
	assert.ok(Math.abs(ankle.y - 0.1) < 0.01, `${ankle.y}`);
	assert.ok(Math.abs(ankle.y - feet.character.output.legs[0].ankle[1]) < 1e-4);
	feet.dispose();
});

test("ends of chains are joints, and a skeleton may be seen from further up, whatever its bind matrices are measured in", () => {
	const { character, bones } = makeBiped();
	const ends = [5, 9].map((foot) => {
		const end = new Object3D();
		end.position.set(0, 0, 4);
		bones[foot].add(end);
		return end;
	});
	const sword = new Object3D().add(box(1, 1, 1, 0));
	const drawn = box(1, 1, 1, 0);
	bones[3].add(sword, drawn);
	const read = readSkeleton(character, character);
	assert.ok(ends.every((end) => read.joints.includes(end)));
	assert.ok(read.joints.includes(sword) && !read.joints.includes(drawn) && !read.joints.includes(sword.children[0]));
	read.parents.forEach((parent, i) => assert.ok(parent < i));
	assert.equal(read.space, character);
	assert.deepEqual(findSkeletonJoints(character, character), read.joints);
	// In metres, though the armature and what is bound below it are in centimetres.
	const heights = read.skin.positions.filter((_, i) => i % 3 === 1);
	assert.ok(heights.every((y) => Math.abs(y) < 0.03), `${Math.min(...heights)} to ${Math.max(...heights)}`);
	const { legLength, rig } = sole.detectRig(read);
	assert.equal(rig.definition.legs.length, 2);
	assert.ok(Math.abs(legLength - 0.9) < 0.1, legLength);
});

test("what a mixer leaves alone stays as it was animated", () => {
	const { character, mesh, bones } = makeBiped();
	const feet = new SoleSkin(sole, mesh, { ground: groundFromObject(sole, box(9, 1, 9, -0.4)) });
	const before = bones.map(({ quaternion, position }) => [...quaternion, ...position]);
	// A key of the spine alone, and one of the left thigh that never changes: three writes it once.
	const turn = bones[3].quaternion.toArray();
	const tracks = [
		new QuaternionKeyframeTrack("spine.quaternion", [0, 1], [0, 0, 0, 1, 0, 1, 0, 0]),
		new QuaternionKeyframeTrack("thigh_l.quaternion", [0, 1], [...turn, ...turn]),
	];
	const mixer = new AnimationMixer(character);
	mixer.clipAction(new AnimationClip("turn", 1, tracks)).play();
	for (let i = 0; i < 90; ++i) {
		mixer.update(1 / 60);
		feet.update(1 / 60);
	}
	assert.notDeepEqual(bones[3].quaternion.toArray(), turn);
	feet.restore();
	bones.forEach(({ quaternion, position }, i) => {
		if (i !== 2) {
			const now = [...quaternion, ...position];
			assert.ok(now.every((x, k) => Math.abs(x - before[i][k]) < 1e-5), `${i}: ${now}`);
		}
	});
	assert.ok(Math.abs(bones[2].quaternion.y) > 0.1);
});

test("a definition is taken instead, and the user's own raycasts", () => {
	const { character } = makeBiped();
	const { legs, pelvis } = bipedDefinition();
	// Character space is the armature's: centimetres, z up.
	for (const leg of legs) {
		leg.sole = Object.fromEntries(Object.entries(leg.sole).map(([name, [x, y, z]]) => [name, [100 * x, -100 * z, 100 * y]]));
	}
	const definition = { pelvis, legs, up: [0, 0, 1], forward: [0, -1, 0] };
	const floor = box(9, 1, 9, -0.5);
	floor.updateMatrixWorld();
	const raycaster = new Raycaster();
	const ground = (probe, hit) => {
		raycaster.set(new Vector3(...probe.start), new Vector3(...probe.direction));
		const [first] = raycaster.intersectObject(floor);
		if (first && first.distance < probe.length) {
			hit.put(first.point, first.face.normal);
		}
	};
	const feet = new SoleSkin(sole, character, { definition, ground });
	assert.equal(feet.detection, null);
	character.position.y = 0.04;
	for (let i = 0; i < 60; ++i) {
		feet.update(1 / 60);
	}
	assert.ok(feet.character.output.legs.every(({ ankle }) => Math.abs(ankle[1] - 0.08) < 0.01));
	feet.weight = 0;
	for (let i = 0; i < 60; ++i) {
		feet.update(1 / 60);
	}
	assert.ok(feet.character.output.legs.every(({ ankle }) => Math.abs(ankle[1] - 0.12) < 0.01));
	feet.ground = null;
	feet.reset();
	feet.update(1 / 60);
	assert.ok(feet.character.output.legs.every(({ flags }) => flags & LegFlags.noGround));
	feet.dispose();
});

test("ground is taken from meshes as they stand: mirrored, instanced, nested", () => {
	const mirrored = new Mesh(new PlaneGeometry(2, 2).rotateX(-Math.PI / 2));
	mirrored.scale.set(-1, 1, 1);
	mirrored.position.set(5, 1, 0);
	const instanced = new InstancedMesh(new BoxGeometry(1, 1, 1), undefined, 2);
	instanced.setMatrixAt(0, new Matrix4().makeTranslation(-5, 0, 0));
	instanced.setMatrixAt(1, new Matrix4().makeTranslation(-5, 0, 5));
	const hidden = box(1, 9, 1, 0);
	hidden.visible = false;
	const group = new Group().add(new Group().add(mirrored), instanced, hidden);
	group.position.y = 2;
	const ground = groundFromObject(sole, group, { surface: (mesh) => (mesh === instanced ? 8 : 2) });
	const at = (x, z) => ground.cast({ start: [x, 20, z], direction: [0, -1, 0], length: 40 });
	assert.deepEqual([at(5, 0).point[1], at(5, 0).surface], [3, 2]);
	assert.deepEqual([at(-5, 0).point[1], at(-5, 5).point[1], at(-5, 5).surface], [2.5, 2.5, 8]);
	assert.equal(at(0, 0), null);
});

test("what is no character is refused", () => {
	assert.throws(() => new SoleSkin(sole, new Group()), /has no SkinnedMesh/);
	const { character } = makeBiped();
	assert.throws(() => new SoleSkin(sole, character, { definition: { pelvis: "belly", legs: [] } }), /no joint 'belly'/);
});
