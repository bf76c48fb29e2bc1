// SPDX-License-Identifier: MIT
// flashes.h -- draws short marks for events of the world: touches, hits, visits, broken joints.
#ifndef FLASHES_H
#define FLASHES_H
#include "view/render_tables.h"
#include "view/stroke.h"
#include "view/style.h"

typedef struct
{
	Layer layer;
	scree_vec at;
	float diameter; // px: diameter of the ring
	double born;    // s: time of the world at the event
} Flash;

typedef struct
{
	Flash* list; // the oldest flash first
	int count, capacity;
	int seen, left_out; // number of events of the last step in view; number of these events without a flash
} Flashes;

void flashes_close(Flashes* flashes);

// Returns true if a style shows any layer of events.
bool flashes_shown(const Style* style);

// Adds flashes for the events of the last step that are in view and whose layer is on. If a layer has too many events,
// adds a flash for every second, third, ... event. now: time of the world after the step, s.
scree_status flashes_step(Flashes* flashes, RenderTables* tables, const Camera* camera, const Style* style, double now);

// Adds strokes for the flashes that have not faded, and removes the flashes that have faded.
void flashes_mark(Flashes* flashes, Strokes* strokes, const Camera* camera, double now);

#endif
