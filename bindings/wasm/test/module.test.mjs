// SPDX-License-Identifier: MIT
// The modules and the package: what they import, how large they are, how they are found and refused.
import assert from "node:assert/strict";
import { execFileSync, spawnSync } from "node:child_process";
import { readFileSync, writeFileSync } from "node:fs";
import { test } from "node:test";
import { brotliCompressSync } from "node:zlib";
import { hasSimd, loadSole } from "sole";
import { moduleBytes, modules, packageFolder, root, workFolder } from "./support.mjs";

const SIZE_LIMIT = 200_000;

test("no module imports anything", () => {
	for (const name of modules) {
		const module = new WebAssembly.Module(moduleBytes(name));
		assert.deepEqual(WebAssembly.Module.imports(module), [], name);
	}
});

test("the modules with detection and measure are small", () => {
	for (const name of modules.slice(0, 2)) {
		assert.ok(moduleBytes(name).length < SIZE_LIMIT, `${name}: ${moduleBytes(name).length} bytes`);
		assert.ok(brotliCompressSync(moduleBytes(name)).length < SIZE_LIMIT / 2, name);
	}
});

test("engines without SIMD get a module without", () => {
	const features = ["--enable-bulk-memory", "--enable-nontrapping-float-to-int", "--enable-sign-ext", "--disable-simd"];
	const validate = (name) => spawnSync("wasm-opt", [...features, `${packageFolder}/${name}.wasm`, "-o", "/dev/null"]);
	assert.equal(validate("sole").status, 0);
	assert.equal(validate("sole-debug").status, 0);
	assert.notEqual(validate("sole-simd").status, 0);
	assert.equal(hasSimd(), true);
});

test("a module is found beside the code, by address, by bytes and compiled", async () => {
	const version = readFileSync(`${root}/include/sole/base.h`, "utf8");
	const number = ["MAJOR", "MINOR", "PATCH"].map((part) => version.match(`SOLE_VERSION_${part} (\\d+)`)[1]).join(".");
	const bytes = moduleBytes("sole");
	const kinds = [
		{},
		{ simd: false },
		{ debug: true },
		{ url: new URL(`file://${packageFolder}/sole.wasm`) },
		{ bytes },
		{ bytes: new WebAssembly.Module(bytes) },
	];
	for (const options of kinds) {
		const sole = await loadSole(options);
		assert.equal(sole.version, number);
		assert.equal(sole.debug, options.debug ?? false);
		assert.ok(sole.settingInfos.length > 40);
	}
	assert.equal(JSON.parse(readFileSync(`${packageFolder}/package.json`, "utf8")).version, number);
});

test("what is no module of Sole is refused", async () => {
	await assert.rejects(loadSole({ bytes: new Uint8Array([1, 2, 3]) }), Error);
	await assert.rejects(loadSole({ bytes: Uint8Array.from([0, 97, 115, 109, 1, 0, 0, 0]) }), /is none of Sole/);
	await assert.rejects(loadSole({ url: "file:///nowhere/sole.wasm" }), Error);
});

test("the package has all that it names", () => {
	const said = execFileSync("npm", ["pack", "--dry-run", "--json"], {
		cwd: packageFolder,
		encoding: "utf8",
		stdio: ["ignore", "pipe", "ignore"],
	});
	const files = JSON.parse(said)[0].files.map(({ path }) => path);
	const needed = ["sole.js", "sole.d.ts", "sole-three.js", "sole-three.d.ts", "layout.js", "LICENSE", "README.md"];
	for (const file of [...needed, ...modules.map((name) => `${name}.wasm`)]) {
		assert.ok(files.includes(file), file);
	}
	assert.ok(!files.some((file) => file.includes("test")), files.join(" "));
});

test("the declarations hold for a user's program, strictly", () => {
	const config = {
		compilerOptions: {
			strict: true,
			noEmit: true,
			module: "nodenext",
			target: "es2022",
			lib: ["es2022", "dom"],
			exactOptionalPropertyTypes: true,
			skipLibCheck: false,
			types: [],
		},
		files: [`${root}/bindings/wasm/test/user.ts`],
	};
	writeFileSync(`${workFolder}/tsconfig.json`, JSON.stringify(config));
	const tsc = (...words) => execFileSync("node", [`${root}/node_modules/typescript/bin/tsc`, ...words], { encoding: "utf8" });
	try {
		tsc("-p", `${workFolder}/tsconfig.json`);
	} catch (error) {
		assert.fail(error.stdout);
	}
});
