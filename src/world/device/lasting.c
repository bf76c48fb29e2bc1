// SPDX-License-Identifier: MIT
// lasting.c -- counts the items of pools that outlive a step.
#include "world/device/lasting.h"
#include "world/world.h"
#include <limits.h>

static int held(const scree_world* world, Per per, int items)
{
	int capacity = world->backend->capacity[per];
	return items < capacity ? items : capacity;
}

int lasting_items(const scree_world* world, Per per)
{
	const Counters* c = &world->pipeline.counters;
	switch (per)
	{
	case PER_ATTRIBUTE:
		return world->edits.attribute_rows;
	case PER_COLLIDABLE:
		return held(world, per, world->collidables.used);
	case PER_BODY:
		// wide kernels also process the padding, whose items must be inert
		return held(world, per, (world->bodies.used + MAX_LANES - 1) / MAX_LANES * MAX_LANES);
#define CONSTRAINT_KIND(kind, Kind, KIND)                      \
	case PER_##KIND:                                           \
		return c->kind##s;                                     \
	case PER_##KIND##_PLACE:                                   \
		return c->layout[CONSTRAINT_##KIND].begin[COLORS + 1]; \
	case PER_##KIND##_BLOCK:                                   \
		return (c->layout[CONSTRAINT_##KIND].begin[COLORS + 1] + MAX_LANES - 1) / MAX_LANES;
#include "pools/kinds.def"
#undef CONSTRAINT_KIND
	case PER_JOINED:
		return c->joined;
	case PER_EXCLUDED:
		return world->pipeline.excluded;
	case PER_MATERIAL_PAIR:
		return held(world, per, world->pipeline.material_pairs);
	case PER_PATH_SAMPLE:
		return held(world, per, world->edits.sample_rows);
	case PER_CHAIN:
		return world->pipeline.chain_ranges;
	case PER_BRANCH:
		return world->pipeline.branch_nodes;
	case PER_BODY_GROUP:
	case PER_COLLIDABLE_GROUP:
	case PER_CONTACT_GROUP:
		return held(world, per, INT_MAX);
	case PER_ONE:
		return 1;
	case PER_SAVED:
		return world->saves.end;
	default:
		return 0; // scratch pools, and trees: their leaves are copied one by one, and the new device computes their nodes
	}
}
