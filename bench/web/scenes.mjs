// SPDX-License-Identifier: MIT
// scenes.mjs -- makes three scenes as lists of bodies, the same for each engine. Units: m, rad, rad/s.
//
// A body of boxes is {x, y, type, boxes: [{w, h, x, y, a}]}, with half sides w and h, position (x, y) and angle a of each box; a
// circle is {x, y, type, radius}.

const still = (x, y, w, h) => ({x, y, type: "static", boxes: [{w, h, x: 0, y: 0, a: 0}]});

function pyramid() {
	const bodies = [still(0, -1, 100, 1)], base = 60;
	for (let row = 0; row < base; ++row)
		for (let k = 0; k < base - row; ++k)
			bodies.push({x: k + 0.5 * row - 0.5 * base + 0.5, y: row + 0.5, type: "dynamic", boxes: [{w: 0.5, h: 0.5, x: 0, y: 0, a: 0}]});
	return bodies;
}

function pile() {
	const bodies = [still(0, -1, 30, 1), still(-29, 50, 1, 50), still(29, 50, 1, 50)];
	for (let k = 0; k < 2000; ++k) {
		const x = 1.1 * (k % 50) - 27 + 0.05 * (Math.floor(k / 50) % 3), y = 1 + 1.1 * Math.floor(k / 50);
		bodies.push(k % 2 ? {x, y, type: "dynamic", radius: 0.5} : {x, y, type: "dynamic", boxes: [{w: 0.5, h: 0.5, x: 0, y: 0, a: 0}]});
	}
	return bodies;
}

// A drum of four walls turns at 30 degrees per second.
function tumbler() {
	const half = 20, wall = (x, y, w, h) => ({w, h, x, y, a: 0}), bodies = [{x: 0, y: 0, type: "kinematic", spin: Math.PI / 6,
		boxes: [wall(0, -half, half, 1), wall(0, half, half, 1), wall(-half, 0, 1, half), wall(half, 0, 1, half)]}];
	for (let k = 0; k < 2000; ++k)
		bodies.push({x: 0.75 * (k % 45) - 16.5, y: 0.75 * Math.floor(k / 45) - 16.5, type: "dynamic",
			boxes: [{w: 0.3, h: 0.3, x: 0, y: 0, a: 0}]});
	return bodies;
}

export const scenes = {pyramid, pile, tumbler};
