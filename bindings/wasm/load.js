// SPDX-License-Identifier: MIT
// Gets a module from where it lies and makes an instance of it.
import { refuse } from "./memory.js";

async function compile(url) {
	if (url.protocol === "file:") {
		const { readFile } = await import(/* @vite-ignore */ "node:fs/promises");
		return WebAssembly.compile(await readFile(url));
	}
	const response = await fetch(url);
	if (!response.ok) {
		refuse(`${url}: could not be loaded (${response.status}): put the package's .wasm files there`);
	}
	// Servers that do not know the type of .wasm files are no reason to fail.
	return WebAssembly.compile(await response.arrayBuffer());
}

/// What a module exports. @param bytes of one, or one that is compiled; else it is read from the url
export async function openModule({ url, bytes }, imports = {}) {
	const given = bytes instanceof WebAssembly.Module ? bytes : undefined;
	const wasm = given ?? (bytes ? await WebAssembly.compile(bytes) : await compile(url));
	return (await WebAssembly.instantiate(wasm, imports)).exports;
}
