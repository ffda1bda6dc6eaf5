// SPDX-License-Identifier: MIT
// Checks glTF files with the Khronos validator: node validate_glb.mjs [--baseline BASE.glb] FILE...
// Prints errors and warnings of each file with their codes; exits 1 where a file has errors. With a baseline only those
// errors count that it has not.
import { readFileSync } from "node:fs";
import { dirname, resolve } from "node:path";
import validator from "gltf-validator";

async function validate(path) {
	const report = await validator.validateBytes(new Uint8Array(readFileSync(path)), {
		uri: path,
		maxIssues: 0, // any other limit can hide errors behind hints
		externalResourceFunction: async (uri) =>
			new Uint8Array(readFileSync(resolve(dirname(path), decodeURIComponent(uri)))),
	});
	return report.issues;
}

/// How often each code of a severity (0 error, 1 warning) comes.
function countCodes(issues, severity) {
	const counts = {};
	for (const message of issues.messages) {
		if (message.severity === severity) {
			counts[message.code] = (counts[message.code] ?? 0) + 1;
		}
	}
	return counts;
}

const total = (counts) => Object.values(counts).reduce((sum, count) => sum + count, 0);

const files = process.argv.slice(2);
let known = {};
const option = files.indexOf("--baseline");
if (option >= 0) {
	const [, base] = files.splice(option, 2);
	if (base === undefined) {
		console.error("validate_glb: --baseline needs a file: see the head of this script");
		process.exit(2);
	}
	known = countCodes(await validate(base), 0);
}
if (files.length === 0) {
	console.error("validate_glb: no files: see the head of this script");
	process.exit(2);
}

let bad = 0;
for (const file of files) {
	try {
		const issues = await validate(file);
		const errors = countCodes(issues, 0);
		const warnings = countCodes(issues, 1);
		for (const [code, count] of Object.entries(known)) {
			if (code in errors) {
				errors[code] -= count;
				if (errors[code] <= 0) {
					delete errors[code];
				}
			}
		}
		const isNew = option >= 0 ? " new" : "";
		console.log(
			`${file}: ${total(errors)}${isNew} errors ${JSON.stringify(errors)}, ` +
				`${total(warnings)} warnings ${JSON.stringify(warnings)}`,
		);
		if (total(errors) > 0) {
			for (const message of issues.messages.filter((m) => m.severity === 0).slice(0, 10)) {
				console.log(`  ${message.code} ${message.pointer ?? message.offset}: ${message.message}`);
			}
			bad = 1;
		}
	} catch (error) {
		console.log(`${file}: cannot be validated: ${error.message ?? error}`);
		bad = 1;
	}
}
process.exit(bad);
