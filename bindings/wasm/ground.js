// SPDX-License-Identifier: MIT
// Sole's own ground for those without physics: triangles, height fields and planes, still or in moving pieces.
import { NONE, refuse, sizeOf, takeCount, takeNumbers, takeVector } from "./memory.js";

const ALL_LAYERS = 0xffffffff;

/// Layer and surface of a part, where they are given.
function putNames(memory, struct, at, part) {
	for (const field of ["layer", "surface"]) {
		if (part[field] !== undefined) {
			memory.set(struct, at, field, part[field]);
		}
	}
}

function putMesh(memory, scope, at, what, mesh) {
	const set = (field, value) => memory.set("soleGroundMesh", at, field, value);
	const positions = takeNumbers(`${what}.positions`, mesh.positions, Float32Array);
	const vertexCount = Math.floor(positions.length / 3);
	takeNumbers(`${what}.positions`, positions, Float32Array, 3 * vertexCount);
	const indices = mesh.indices
		? takeNumbers(`${what}.indices`, mesh.indices, Uint32Array)
		: Uint32Array.from({ length: vertexCount }, (_, i) => i);
	const triangleCount = Math.floor(indices.length / 3);
	takeNumbers(`${what}.indices`, indices, Uint32Array, 3 * triangleCount);
	set("vertices", scope.numbers(positions));
	set("vertexCount", vertexCount);
	set("indices", scope.numbers(indices));
	set("triangleCount", triangleCount);
	if (mesh.triangleLayers) {
		const layers = takeNumbers(`${what}.triangleLayers`, mesh.triangleLayers, Uint32Array, triangleCount);
		set("triangleLayers", scope.numbers(layers));
	}
	set("twoSided", mesh.twoSided ?? false);
	putNames(memory, "soleGroundMesh", at, mesh);
}

function putHeightField(memory, scope, at, what, field) {
	const set = (name, value) => memory.set("soleHeightField", at, name, value);
	const countX = takeCount(`${what}.countX`, field.countX, 2, 65536);
	const countZ = takeCount(`${what}.countZ`, field.countZ, 2, 65536);
	const heights = takeNumbers(`${what}.heights`, field.heights, Float32Array, countX * countZ);
	for (const name of ["origin", "axisX", "axisZ", "up"]) {
		if (field[name]) {
			memory.view("soleHeightField", at, name).set(takeVector(`${what}.${name}`, field[name]));
		}
	}
	set("cellX", field.cellX);
	set("cellZ", field.cellZ);
	set("countX", countX);
	set("countZ", countZ);
	set("heights", scope.numbers(heights));
	putNames(memory, "soleHeightField", at, field);
}

function putPlane(memory, scope, at, what, plane) {
	memory.view("soleGroundPlane", at, "normal").set(takeVector(`${what}.normal`, plane.normal));
	memory.set("soleGroundPlane", at, "offset", plane.offset);
	putNames(memory, "soleGroundPlane", at, plane);
}

const parts = [
	["meshes", "meshCount", "soleGroundMesh", "soleDefaultGroundMesh", putMesh],
	["heightFields", "heightFieldCount", "soleHeightField", "soleDefaultHeightField", putHeightField],
	["planes", "planeCount", "soleGroundPlane", "soleDefaultGroundPlane", putPlane],
];

export function createGround(module, given) {
	const { memory, exports } = module;
	return memory.scope((scope) => {
		const def = scope.struct("soleGroundDef");
		exports.soleDefaultGroundDef(def);
		for (const [list, count, struct, makeDefault, put] of parts) {
			const items = given[list] ?? [];
			const at = scope.struct(struct, items.length);
			items.forEach((item, i) => {
				exports[makeDefault](at + i * sizeOf(struct));
				put(memory, scope, at + i * sizeOf(struct), `${list}[${i}]`, item);
			});
			memory.set("soleGroundDef", def, list, at);
			memory.set("soleGroundDef", def, count, items.length);
		}
		const groundAt = scope.room(4);
		const message = scope.struct("soleMessage");
		if (exports.soleCreateGround(def, 0, groundAt, message) !== 0) {
			refuse(memory.text(message));
		}
		return new Ground(module, memory.getWord(groundAt));
	});
}

/// What a cast met, or null.
function readHit(memory, at) {
	const get = (field) => memory.get("soleHit", at, field);
	const numbers = (field) => Array.from(memory.view("soleHit", at, field));
	return get("hit") === false ? null : {
		startedInside: get("startedInside"),
		layer: get("layer"),
		surface: get("surface"),
		point: numbers("point_w"),
		normal: numbers("normal_w"),
		velocity: numbers("velocity_w"),
	};
}

/// Asks with a probe of its own: cast( hit, probe ) leaves the answer.
function askOnce(memory, { start, direction, length, radius = 0, mask = ALL_LAYERS }, cast) {
	return memory.scope((scope) => {
		const probe = scope.struct("soleProbe");
		const hit = scope.struct("soleHit");
		memory.view("soleProbe", probe, "start_w").set(takeVector("start", start));
		memory.view("soleProbe", probe, "direction_w").set(takeVector("direction", direction));
		memory.set("soleProbe", probe, "length", length);
		memory.set("soleProbe", probe, "radius", radius);
		memory.set("soleProbe", probe, "mask", mask);
		cast(hit, probe);
		return readHit(memory, hit);
	});
}

export class Ground {
	#module;
	at;

	constructor(module, at) {
		this.#module = module;
		this.at = at;
		this.triangleCount = module.exports.soleGround_GetTriangleCount(at);
	}

	/// The nearest hit of a ray, or of a sphere where a radius is given; null where nothing is met.
	cast(probe) {
		return askOnce(this.#module.memory, probe, (hit, at) => this.#module.exports.soleCastProbe(hit, this.at, at));
	}

	/// The box around everything but planes.
	get bounds() {
		const { memory, exports } = this.#module;
		return memory.scope((scope) => {
			const at = scope.room(24);
			exports.soleGround_GetBounds(this.at, at, at + 12);
			const numbers = Array.from(memory.floats(at, 6));
			return { lower: numbers.slice(0, 3), upper: numbers.slice(3) };
		});
	}

	/// Answers all that a character asks.
	answer(characterAt) {
		this.#module.exports.soleWasm_CastGround(characterAt, this.at);
	}

	dispose() {
		this.#module.exports.soleDestroyGround(this.at);
		this.at = 0;
	}
}

/// Grounds that move, each as a whole.
export class Pieces {
	#module;
	#grounds;
	at;

	constructor(module, pieces) {
		const { memory } = module;
		this.#module = module;
		this.#grounds = pieces.map(({ ground }) => ground);
		this.count = pieces.length;
		this.at = memory.allocate(pieces.length * sizeOf("soleGroundPiece"));
		memory.bytes.fill(0, this.at, this.at + pieces.length * sizeOf("soleGroundPiece"));
		pieces.forEach(({ ground, surface = NONE }, i) => {
			memory.set("soleGroundPiece", this.#find(i), "ground", ground?.at ?? 0);
			memory.set("soleGroundPiece", this.#find(i), "surface", surface);
			memory.view("soleGroundPiece", this.#find(i), "transform").set([0, 0, 0, 0, 0, 0, 1, 1, 1, 1]);
		});
	}

	#find(index) {
		return this.at + takeCount("piece", index, 0, this.count - 1) * sizeOf("soleGroundPiece");
	}

	/// Where a piece is now, how it moves, and whether it is there at all. What is left out stays.
	move(index, { translation, rotation, velocity, spin, there }) {
		const at = this.#find(index);
		const { memory } = this.#module;
		const put = (field, values, from) => memory.view("soleGroundPiece", at, field).set(values, from);
		if (translation) {
			put("transform", takeVector("translation", translation), 0);
		}
		if (rotation) {
			const { x, y, z, w } = rotation;
			const list = w === undefined ? rotation : [x, y, z, w];
			put("transform", takeNumbers("rotation", list, Float32Array, 4), 3);
		}
		if (velocity) {
			put("velocity_w", takeVector("velocity", velocity), 0);
		}
		if (spin) {
			put("spin_w", takeVector("spin", spin), 0);
		}
		if (there !== undefined) {
			this.#module.memory.set("soleGroundPiece", at, "ground", there ? this.#grounds[index]?.at ?? 0 : 0);
		}
	}

	cast(probe) {
		const { memory, exports } = this.#module;
		return askOnce(memory, probe, (hit, at) => exports.soleCastPieces(hit, this.at, this.count, at));
	}

	answer(characterAt) {
		this.#module.exports.soleWasm_CastPieces(characterAt, this.at, this.count);
	}

	dispose() {
		this.#module.memory.free(this.at);
		this.at = 0;
	}
}
