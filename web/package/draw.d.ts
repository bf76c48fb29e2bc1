// SPDX-License-Identifier: MIT
// draw.d.ts -- the types of "scree/draw": debug draw. generate.mjs adds Draw and Color.
import {PartialBox, Scree, World} from "./scree.js";

/** Items of one kind. The arrays are valid until the next drawing of the same function. */
export interface DrawBatch {
	count: number;
	/** Numbers of all items, the same number for each. */
	data: Float32Array;
	/** 0xRRGGBBAA of each item. Fills have an alpha below 255; their outlines have the same color with alpha 255. */
	colors: Uint32Array;
}

/** Everything that was drawn, in metres, in the order of docs/manual/debug_draw.md within each kind. */
export interface Drawing {
	/** Filled convex polygons, counter-clockwise. data: the radius of each by which it is rounded. Polygon k has the vertices first[k] to
	 * first[k + 1] - 1; vertices: x, y. */
	polygons: DrawBatch & {vertices: Float32Array; first: Uint32Array};
	/** Filled circles: x, y, radius. A line of lines shows the rotation. */
	circles: DrawBatch;
	/** Filled capsules: x and y of both ends, radius. */
	capsules: DrawBatch;
	/** x and y of both ends. */
	lines: DrawBatch;
	/** x, y, suggested width in pixels. */
	points: DrawBatch;
	/** x and y of the lower left corner of each text. */
	texts: DrawBatch & {words: string[]};
}

export interface DrawOptions {
	/** Bits of Draw; default SHAPES, SENSORS and JOINTS. */
	flags?: number;
	/** m per N s: length of impulses, 0 to 1e6, default 0.1. */
	impulseScale?: number;
	/** s: length of velocities, 0 to 1e6, default 0.1. */
	speedScale?: number;
	/** m: length of normals, axes and directions, default 0.25. */
	length?: number;
	/** m: only things whose bounding boxes overlap it are drawn; default: everything. */
	box?: PartialBox | null;
}

/** Loads debug draw for an engine: 4 kB, compressed. The function draws the current state of a world, which does not change. */
export declare function loadDraw(scree: Scree): Promise<(world: World, options?: DrawOptions) => Drawing>;

/** Paints a drawing on a canvas of the browser. The transform of the context converts metres to pixels; with its y axis up, for
 * instance context.setTransform(40, 0, 0, -40, width / 2, height). */
export declare function paint(context: Pick<CanvasRenderingContext2D, "getTransform" | "translate" | "scale" | "save" | "restore" | "beginPath" |
	"closePath" | "moveTo" | "lineTo" | "arc" | "fill" | "stroke" | "fillRect" | "fillText" | "fillStyle" | "strokeStyle" | "lineWidth">, drawing: Drawing): void;
