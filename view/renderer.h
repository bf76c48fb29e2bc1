// SPDX-License-Identifier: MIT
// renderer.h -- draws a world from rows in an OpenGL buffer: bodies, and layers over them.
#ifndef RENDERER_H
#define RENDERER_H
#include "scene/scan.h"
#include "view/field_lines.h"
#include "view/flashes.h"
#include "view/joint_lines.h"
#include "view/lod.h"
#include "view/pass.h"
#include "view/render_tables.h"
#include "view/shared_rows.h"
#include "view/stroke.h"
#include "view/style.h"

typedef struct // parts of a picture, each with a world of its own: the same structure, at another place
{
	int count, rows;        // number of tiles; render rows of each world, one world after the other
	const scree_box* boxes; // m: box of each tile, outside of which nothing of its world is drawn
} Tiles;

typedef struct
{
	Pass body, splat, box, velocity, center;
	unsigned one_each, four_each; // vertex arrays: one vertex per row; four vertices per row, as an instance
	Strokes strokes, under;       // strokes over the bodies; strokes under the bodies
	RenderTables tables;
	Lod lod;
	JointLines joint_lines;
	FieldLines field_lines;
	const Scene* scene; // scene that created the world, or null
	Scan scan;          // rays of the scene
	Flashes flashes;
	scree_contact* contacts;
	int contact_count, contact_capacity;
	// Worlds that renderer_draw draws, in the look of the world that was read; count 0: that world. The caller sets them.
	Tiles tiles;
	bool software; // true: OpenGL runs on the CPU
} Renderer;

// Opens the renderer in the current OpenGL 3.3 context. Returns false and writes a sentence (SENTENCE of shader.h) on
// failure.
bool renderer_open(Renderer* renderer, char* sentence);
void renderer_close(Renderer* renderer);

// Reads a world. Call it before the first frame and after bodies were added or removed. `scene` is the scene that
// created the world, or null; the scene must exist until the next call. Returns false if memory is short.
bool renderer_update_world(Renderer* renderer, const Scene* scene, scree_world* world);

// Adds flashes for those events of a step whose layers are on in the style. Call it after every step. now: time of the
// world, s.
scree_status renderer_step(Renderer* renderer, const Camera* camera, const Style* style, double now);

// Reads the data that a style shows besides rows and events: velocities, contacts, joints, fields, sensors, and the
// rays in view.
scree_status renderer_fetch(Renderer* renderer, const Camera* camera, const Style* style);

// Draws background, bodies and layers into the current framebuffer, and on top the strokes that the caller has added.
// Tiles have no layers but boxes and centers.
void renderer_draw(Renderer* renderer, const Share* share, const Camera* camera, const Style* style);

#endif
