// SPDX-License-Identifier: MIT
// usage.mjs -- handles --help for programs that import it: prints the comment at the head of the program, and refuses other
// options.
import {readFileSync} from "node:fs";
import {basename} from "node:path";

const [, program, ...given] = process.argv;
for (const argument of given.filter((text) => text.startsWith("-"))) {
	if (argument === "-h" || argument === "--help") {
		const [, head] = readFileSync(program, "utf8").match(/^\/\/ SPDX.*\n((?:\/\/.*\n)+)/);
		console.log(head.replace(/^\/\/ ?/gm, "").trimEnd());
		process.exit(0);
	}
	console.error(`${basename(program)}: unknown option ${argument}; --help lists the arguments`);
	process.exit(2);
}
