// SPDX-License-Identifier: MIT
// flashes.h -- events of the world that are drawn for a moment: touches, hits, visits, joints that break.
#ifndef FLASHES_H
#define FLASHES_H
#include "view/render_tables.h"
#include "view/stroke.h"
#include "view/style.h"

typedef struct
{
	Layer layer;
	scree_vec at;
	float diameter; // px
	double born;    // s of the world
} Flash;

typedef struct
{
	Flash* list; // the oldest first
	int count, capacity;
	int seen, left_out; // events of the last step that are in view, and how many of them are too many to be drawn
} Flashes;

void flashes_close(Flashes* flashes);

// Whether a style shows events.
bool flashes_shown(const Style* style);

// Adds what happened in the last step, which ended at this time of the world in seconds. Only events that are in view and that the
// style shows; of too many it takes every second, third, ... Reads no events if the style shows none.
scree_status flashes_step(Flashes* flashes, RenderTables* tables, const Camera* camera, const Style* style, double now);

// Adds strokes for the flashes that have not faded; drops the others.
void flashes_mark(Flashes* flashes, Strokes* strokes, const Camera* camera, double now);

#endif
