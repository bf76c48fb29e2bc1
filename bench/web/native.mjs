// SPDX-License-Identifier: MIT
// native.mjs -- native.mjs SCENE FILE: writes a scene of scenes.mjs as a file for the command line of Scree.
import "./usage.mjs";
import {writeFileSync} from "node:fs";
import {scenes} from "./scenes.mjs";

const [, , scene, file] = process.argv, attributes = {};
const attribute = (part) => {
	const name = `a${[part.radius ?? part.w, part.h ?? ""].join("_").replaceAll(".", "d")}`;
	attributes[name] = part.radius ? {circle: part.radius} : {box: [part.w, part.h]};
	return name;
};
const bodies = scenes[scene]().map((b) => ({type: b.type, position: [b.x, b.y], ...(b.spin && {angular_velocity: b.spin}),
	collidables: (b.boxes ?? [{x: 0, y: 0, radius: b.radius}]).map((part) => ({attribute: attribute(part), position: [part.x, part.y]}))}));
writeFileSync(file, JSON.stringify({name: `web_${scene}`, title: `The scene ${scene} of bench/web`, world: {dt: "1 / 60", substeps: 4}, steps: 300,
	view: [-60, -60, 60, 60], attributes, bodies}));
