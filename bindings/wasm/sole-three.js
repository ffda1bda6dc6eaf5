// SPDX-License-Identifier: MIT
// Sole for three.js. Joints are the bones of a skeleton, whatever lies between them, and their ends; character space is
// that of the object above them. The animated pose is read from the joints' own transforms, which is where a mixer
// leaves it, and the placed pose is written there for the renderer.
import { InstancedMesh, Matrix4, Quaternion, Vector3 } from "three";

const TRANSFORM = 10;
const DOUBLE_SIDE = 2; // THREE.DoubleSide

const position = new Vector3();
const rotation = new Quaternion();
const scale = new Vector3();

// --------------------------------------------------------------------------------------------------------- ground

/// Triangles of one mesh at a place. Mirrored ones are turned round.
function addTriangles(mesh, matrix, parts, surface) {
	const { position: vertices } = mesh.geometry.attributes;
	const { index } = mesh.geometry;
	const positions = new Float32Array(3 * vertices.count);
	for (let i = 0; i < vertices.count; ++i) {
		position.fromBufferAttribute(vertices, i).applyMatrix4(matrix).toArray(positions, 3 * i);
	}
	const count = 3 * Math.floor((index ?? vertices).count / 3);
	const indices = Uint32Array.from({ length: count }, (_, i) => (index ? index.getX(i) : i));
	if (matrix.determinant() < 0) {
		for (let i = 0; i < count; i += 3) {
			[indices[i], indices[i + 1]] = [indices[i + 1], indices[i]];
		}
	}
	const material = Array.isArray(mesh.material) ? mesh.material[0] : mesh.material;
	parts.push({ positions, indices, surface, twoSided: material?.side === DOUBLE_SIDE });
}

export function groundFromObject(sole, object, { surface = () => -1, filter = (mesh) => mesh.visible } = {}) {
	const parts = [];
	const matrix = new Matrix4();
	object.updateWorldMatrix(true, true);
	object.traverse((mesh) => {
		if (!mesh.isMesh || mesh.isSkinnedMesh || !mesh.geometry.attributes.position || !filter(mesh)) {
			return;
		}
		if (mesh instanceof InstancedMesh) {
			for (let i = 0; i < mesh.count; ++i) {
				mesh.getMatrixAt(i, matrix);
				addTriangles(mesh, matrix.premultiply(mesh.matrixWorld), parts, surface(mesh));
			}
		} else {
			addTriangles(mesh, mesh.matrixWorld, parts, surface(mesh));
		}
	});
	return sole.createGround({ meshes: parts });
}

// --------------------------------------------------------------------------------------------------------- joints

function findSkins(object) {
	const skins = [];
	object.traverse((child) => {
		if (child.isSkinnedMesh && child.skeleton) {
			skins.push(child);
		}
	});
	if (skins.length === 0) {
		throw new Error("object: has no SkinnedMesh with a skeleton: give one, or what is above it");
	}
	return skins;
}

function pathTo(object) {
	const path = [];
	for (let at = object; at !== null; at = at.parent) {
		path.unshift(at);
	}
	return path;
}

/// The object that character space belongs to: the last that is above all bones and is none itself.
function findSpace(bones) {
	const paths = [...bones].map(pathTo);
	let depth = 0;
	while (paths.every((path) => path[depth] === paths[0][depth] && path[depth] !== undefined && !bones.has(path[depth]))) {
		++depth;
	}
	return depth > 0 ? paths[0][depth - 1] : null;
}

/// Bones, what lies between them and their space, and what hangs below them without being drawn, such as the ends of
/// chains, which no vertex follows: parents first.
function findJoints(bones, space) {
	const joints = new Set();
	for (const bone of bones) {
		const path = pathTo(bone);
		path.slice(path.indexOf(space) + 1).forEach((joint) => joints.add(joint));
	}
	const addBelow = (joint) => {
		for (const child of joint.children) {
			if (bones.has(child) || child.type === "Object3D" || child.isBone) {
				joints.add(child);
				addBelow(child);
			}
		}
	};
	bones.forEach(addBelow);
	return [...joints];
}

function putTransform(pose, index, from) {
	from.position.toArray(pose, TRANSFORM * index);
	from.quaternion.toArray(pose, TRANSFORM * index + 3);
	from.scale.toArray(pose, TRANSFORM * index + 7);
}

/// Bind pose from the inverse bind matrices, each seen from the joint above. Joints that are no bones, and bones below
/// none, stand as they do now.
function findBindPose(joints, parents, skins) {
	const inverses = new Map();
	for (const { skeleton } of skins) {
		skeleton.bones.forEach((bone, i) => inverses.has(bone) || inverses.set(bone, skeleton.boneInverses[i]));
	}
	const pose = new Float32Array(TRANSFORM * joints.length);
	const matrix = new Matrix4();
	const bind = { position, quaternion: rotation, scale };
	joints.forEach((joint, i) => {
		const above = parents[i] < 0 ? undefined : inverses.get(joints[parents[i]]);
		if (above && inverses.has(joint)) {
			matrix.copy(inverses.get(joint)).invert().premultiply(above).decompose(position, rotation, scale);
			putTransform(pose, i, bind);
		} else {
			putTransform(pose, i, joint);
		}
	});
	return pose;
}

/// Where a joint is in character space, in the bind pose.
function bindMatrix(pose, parents, joint) {
	const matrix = new Matrix4();
	const local = new Matrix4();
	for (let j = joint; j >= 0; j = parents[j]) {
		position.fromArray(pose, TRANSFORM * j);
		rotation.fromArray(pose, TRANSFORM * j + 3);
		scale.fromArray(pose, TRANSFORM * j + 7);
		matrix.premultiply(local.compose(position, rotation, scale));
	}
	return matrix;
}

/// Vertices of all skins in the bind pose, character space.
function findSkin(skins, joints, parents, pose) {
	const skin = { positions: [], joints: [], weights: [] };
	const toCharacter = new Matrix4();
	for (const { geometry, skeleton, bindMatrix: toBind } of skins) {
		const { position: vertices, skinIndex, skinWeight } = geometry.attributes;
		const map = skeleton.bones.map((bone) => joints.indexOf(bone));
		toCharacter.multiplyMatrices(bindMatrix(pose, parents, map[0]), skeleton.boneInverses[0]).multiply(toBind);
		for (let i = 0; i < vertices.count; ++i) {
			skin.positions.push(...position.fromBufferAttribute(vertices, i).applyMatrix4(toCharacter));
			for (let k = 0; k < 4; ++k) {
				skin.joints.push(map[skinIndex.getComponent(i, k)] ?? -1);
				skin.weights.push(skinWeight.getComponent(i, k));
			}
		}
	}
	return skin;
}

function findBones(skins) {
	return new Set(skins.flatMap(({ skeleton }) => skeleton.bones));
}

export function findSkeletonJoints(object, space) {
	return findJoints(findBones(findSkins(object)), space);
}

export function readSkeleton(object, space) {
	const skins = findSkins(object);
	const bones = findBones(skins);
	object.updateWorldMatrix(true, true);
	space ??= findSpace(bones);
	const joints = findJoints(bones, space);
	const parents = joints.map((joint) => joints.indexOf(joint.parent));
	const bindPose = findBindPose(joints, parents, skins);
	const names = joints.map((joint) => joint.userData.name ?? joint.name); // the loader of glTF changes names
	return { space, joints, names, parents, bindPose, skin: findSkin(skins, joints, parents, bindPose) };
}

// ----------------------------------------------------------------------------------------------------- characters

export class SoleSkin {
	#space;
	#animated;
	#up;

	constructor(sole, object, { ground = null, settings, definition, up = new Vector3(0, 1, 0), clipFloor = 0 } = {}) {
		const { space, joints, skin, ...skeleton } = readSkeleton(object);
		// Who defines the legs calls joints as they are called here, which may not be as in the file.
		skeleton.names = definition ? joints.map((joint) => joint.name) : skeleton.names;
		this.#space = space;
		this.#up = up;
		this.joints = joints;
		this.detection = definition ? null : sole.detectRig({ ...skeleton, up: this.#upInSpace(), skin });
		this.rig = this.detection?.rig ?? sole.createRig({ ...definition, ...skeleton });
		this.character = sole.createCharacter(this.rig, settings ? { settings } : {});
		this.character.frame.clipFloor = clipFloor;
		this.#animated = skeleton.bindPose.slice();
		this.ground = ground;
		this.weight = 1;
		this.character.placed.fill(NaN); // nothing was written yet
	}

	/// Up as the skeleton's own space sees it, while the character stands upright.
	#upInSpace() {
		const up = this.#up.clone();
		if (this.#space) {
			this.#space.matrixWorld.decompose(position, rotation, scale);
			up.applyQuaternion(rotation.invert());
		}
		return up;
	}

	/// The animated pose. A mixer writes only what has changed: where a joint still has what was placed last, it is
	/// animated as it was.
	#readPose() {
		const { placed } = this.character;
		const animated = this.#animated;
		this.joints.forEach(({ position: p, quaternion: q, scale: s }, i) => {
			const at = TRANSFORM * i;
			if (Math.fround(p.x) !== placed[at] || Math.fround(p.y) !== placed[at + 1] || Math.fround(p.z) !== placed[at + 2]) {
				p.toArray(animated, at);
			}
			const same = Math.fround(q.x) === placed[at + 3] && Math.fround(q.y) === placed[at + 4] &&
				Math.fround(q.z) === placed[at + 5] && Math.fround(q.w) === placed[at + 6];
			if (!same) {
				q.toArray(animated, at + 3);
			}
			s.toArray(animated, at + 7);
		});
		this.character.pose.set(animated);
	}

	#write(pose) {
		this.joints.forEach((joint, i) => {
			joint.position.fromArray(pose, TRANSFORM * i);
			joint.quaternion.fromArray(pose, TRANSFORM * i + 3);
		});
	}

	update(timeStep) {
		const { frame } = this.character;
		this.#readPose();
		if (this.#space) {
			this.#space.updateWorldMatrix(true, false);
			this.#space.matrixWorld.decompose(position, rotation, scale);
			putTransform(frame.root, 0, { position, quaternion: rotation, scale });
		}
		this.#up.toArray(frame.up);
		frame.timeStep = timeStep;
		frame.weight = this.weight;
		this.character.gather();
		if (this.ground) {
			this.character.cast(this.ground);
		}
		this.character.solve();
		this.#write(this.character.placed);
	}

	restore() {
		this.#write(this.#animated);
	}

	reset() {
		this.character.reset();
	}

	dispose() {
		this.character.dispose();
		this.rig.dispose();
	}
}
