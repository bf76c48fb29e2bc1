// SPDX-License-Identifier: MIT
// main.mjs -- shapes that fall into a basin, drawn by Pixi: fixed steps, poses between two steps, and the debug drawing.
import {Application, Container, Graphics, GraphicsContext} from "pixi.js";
import {BodyType, Clock, load} from "scree";
import {Draw, loadDraw} from "scree/draw";

const PIXELS = 40, STEP = 1 / 60, SUBSTEPS = 4; // pixels per m, s
const app = new Application();
await app.init({background: 0x182028, resizeTo: window, antialias: true});
document.body.append(app.canvas);

// the stage in metres: y points up, the origin is at the bottom of the window in the middle
const stage = new Container();
app.stage.addChild(stage);
function fit() {
	stage.position.set(app.screen.width / 2, app.screen.height - 20);
	stage.scale.set(PIXELS, -PIXELS);
}
app.renderer.on("resize", fit);
fit();

const scree = await load(), draw = await loadDraw(scree), world = scree.createWorld({gravity: {x: 0, y: -10}});
const clock = new Clock(STEP);

// kinds of shapes: an attribute for Scree, and a drawing in pixels for Pixi that all bodies share
const kind = (shape, color, path) => ({
	attribute: world.createAttribute({shape, friction: 0.5, restitution: 0.2}),
	drawing: path(new GraphicsContext()).fill(color).stroke({color: 0x182028, width: 1}),
});
function wall(x, y, width, height) {
	const attribute = world.createAttribute({shape: scree.shapeMakeBox(width, height)});
	world.createBody({type: BodyType.STATIC, pose: {position: {x, y}}, attribute});
	stage.addChild(new Graphics().rect(x - width, y - height, 2 * width, 2 * height).fill(0x7fae7c));
}
const R = 0.4, r = 0.25, p = PIXELS, hull = [{x: -0.5, y: -0.4}, {x: 0.5, y: -0.4}, {x: 0, y: 0.5}];
const kinds = [
	kind(scree.shapeMakeBox(R, R), 0xe8b060, (context) => context.rect(-R * p, -R * p, 2 * R * p, 2 * R * p)),
	kind(scree.shapeMakeCircle({}, R), 0x70b0e0, (context) => context.circle(0, 0, R * p)),
	kind(scree.shapeMakeHull(hull, 0), 0xd07090, (context) => context.poly(hull.map(({x, y}) => ({x: x * p, y: y * p})))),
	kind(scree.shapeMakeCapsule({x: -R}, {x: R}, r), 0xa0d070, (context) => context.roundRect(-(R + r) * p, -r * p, 2 * (R + r) * p, 2 * r * p, r * p)),
];
wall(0, 0, 9, 0.3);
wall(-9, 2, 0.3, 2.3);
wall(9, 2, 0.3, 2.3);

const bodies = [];
function drop(x, y) {
	const {attribute, drawing} = kinds[bodies.length % kinds.length];
	const body = world.createBody({pose: {position: {x, y}, rotation: bodies.length}, attribute});
	body.sprite = stage.addChild(new Graphics(drawing)); // programs may add members to bodies
	body.sprite.scale.set(1 / PIXELS);
	bodies.push(body);
}
for (let k = 0; k < 120; ++k)
	drop(k % 12 - 5.5 + 0.1 * (k % 3), 3 + Math.floor(k / 12));

// the debug drawing, above the bodies
const marks = stage.addChild(new Graphics());
marks.visible = false;
marks.zIndex = 1;
stage.sortableChildren = true;
function drawMarks() {
	const {lines, points} = draw(world, {flags: Draw.CONTACTS | Draw.CENTERS | Draw.SPEEDS});
	marks.clear();
	for (let k = 0; k < lines.count; ++k) {
		const [ax, ay, bx, by] = lines.data.subarray(4 * k, 4 * k + 4);
		marks.moveTo(ax, ay).lineTo(bx, by).stroke({color: lines.colors[k] >>> 8, width: 1.5 / PIXELS});
	}
	for (let k = 0; k < points.count; ++k) {
		const [x, y, width] = points.data.subarray(3 * k, 3 * k + 3);
		marks.rect(x - width / 2 / PIXELS, y - width / 2 / PIXELS, width / PIXELS, width / PIXELS).fill(points.colors[k] >>> 8);
	}
}

addEventListener("keydown", ({key}) => marks.visible = key === "d" ? !marks.visible : marks.visible);
app.canvas.addEventListener("pointerdown", (event) => {
	const {x, y} = stage.toLocal({x: event.offsetX, y: event.offsetY});
	drop(x, y);
});
app.ticker.add(({elapsedMS}) => {
	for (let left = clock.advance(elapsedMS / 1000); left > 0; --left)
		world.step(clock.dt, SUBSTEPS);
	const poses = world.poses(bodies, clock.alpha);
	bodies.forEach(({sprite}, k) => {
		sprite.position.set(poses[4 * k], poses[4 * k + 1]);
		sprite.rotation = Math.atan2(poses[4 * k + 3], poses[4 * k + 2]);
	});
	if (marks.visible)
		drawMarks();
});
