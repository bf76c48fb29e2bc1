// SPDX-License-Identifier: MIT
// flashes.h -- short marks for events of the world: touches, hits, visits, broken joints.
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
	double born;    // time of the world, s
} Flash;

typedef struct
{
	Flash* list; // oldest first
	int count, capacity;
	int seen, left_out; // events of the last step in view, and the number of them that are not drawn because there are
	                    // too many
} Flashes;

void flashes_close(Flashes* flashes);

// Returns true if a style shows events.
bool flashes_shown(const Style* style);

// Adds the events of the last step; now is the time of the world after it, s. It adds only events in view whose layer
// is on; of too many it adds every second, third, ... If no layer of events is on, it reads no events.
scree_status flashes_step(Flashes* flashes, RenderTables* tables, const Camera* camera, const Style* style, double now);

// Adds strokes for the flashes that have not faded, and removes the others.
void flashes_mark(Flashes* flashes, Strokes* strokes, const Camera* camera, double now);

#endif
