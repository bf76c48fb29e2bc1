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

typedef struct
{
	Pass body, splat, box, velocity, center;
	unsigned one_each, four_each; // vertex arrays: a row is a vertex, or an instance of four
	Strokes strokes, under;       // over the bodies, under them
	RenderTables tables;
	Lod lod;
	JointLines joint_lines;
	FieldLines field_lines;
	const Scene* scene; // null: none made the world
	Scan scan;          // of the rays of the scene
	Flashes flashes;
	scree_contact* contacts;
	int contact_count, contact_capacity;
	bool software; // OpenGL runs on the CPU
} Renderer;

// Needs a current OpenGL 3.3 context. False writes a sentence (SENTENCE of shader.h).
bool renderer_open(Renderer* renderer, char* sentence);
void renderer_close(Renderer* renderer);

// Reads the world again after bodies were added or removed; also before the first frame. The scene that made the world stays until
// then; null: none did.
bool renderer_update_world(Renderer* renderer, const Scene* scene, scree_world* world);

// After every step, with the time of the world in seconds: adds the events that a style shows.
scree_status renderer_step(Renderer* renderer, const Camera* camera, const Style* style, double now);

// Reads what a style shows besides the rows: velocities, contacts, joints, fields, sensors, the rays in view.
scree_status renderer_fetch(Renderer* renderer, const Camera* camera, const Style* style);

// Draws background, bodies and layers into the current framebuffer. Strokes that were added before are drawn on top.
void renderer_draw(Renderer* renderer, const Share* share, const Camera* camera, const Style* style);

#endif
