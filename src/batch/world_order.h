// SPDX-License-Identifier: MIT
// world_order.h -- orders the worlds of a batch by tuning, because all worlds of a block have the same tuning.
#ifndef WORLD_ORDER_H
#define WORLD_ORDER_H
#include "batch/template.h"

typedef struct // places of worlds in the blocks
{
	int *world, *place; // world at each place, and place of each world; null if world k is at place k
	int groups;         // number of different tunings
	int* end;           // for each of them, the end of its places
} WorldOrder;

// Orders the worlds: those with the tuning of template 0 first, each tuning by rising number. On failure order_close must
// follow.
scree_status order_open(WorldOrder* order, const Template* templates, int count, const int* template_of, int worlds);
void order_close(WorldOrder* order);

static inline int order_world(const WorldOrder* order, int place) { return order->world ? order->world[place] : place; }
static inline int order_place(const WorldOrder* order, int world) { return order->place ? order->place[world] : world; }

#endif
