// SPDX-License-Identifier: MIT
// different_pools.c -- reads items of pools, and prints the pools in which two worlds differ.
#include "world/world.h" // included before cmocka, because cmocka defines a macro named fail

#include "support/different_pools.h"
#include <stdlib.h>
#include <string.h>

void* read_pool(scree_world* world, PoolId pool, int count)
{
	void* items = calloc((size_t)count + 1, pool_info[pool].bytes);
	assert_non_null(items);
	OK(world->backend->f->read(world->backend, pool, 0, count, items));
	return items;
}

// Returns the number of items in use in each pool of a kind. These items must be equal on all devices.
static int items_in_use(const scree_world* world, Per per)
{
	const Counters* c = &world->pipeline.counters;
	switch (per)
	{
	case PER_ATTRIBUTE:
		return world->attribute_slots.used;
	case PER_COLLIDABLE:
		return world->collidables.used;
	case PER_BODY:
		return world->bodies.used;
	case PER_CONTACT:
		return c->contacts;
	case PER_CONTACT_PLACE:
		return c->layout[CONSTRAINT_CONTACT].begin[COLORS + 1];
	case PER_CONTACT_BLOCK:
		return c->layout[CONSTRAINT_CONTACT].begin[COLORS + 1] / MAX_LANES;
	case PER_JOINT:
		return c->joints;
	case PER_JOINT_PLACE:
		return c->layout[CONSTRAINT_JOINT].begin[COLORS + 1];
	case PER_JOINT_BLOCK:
		return c->layout[CONSTRAINT_JOINT].begin[COLORS + 1] / MAX_LANES;
	default:
		return 0; // 0 items, because scratch pools and trees may differ between devices
	}
}

void print_different_pools(scree_world* a, scree_world* b)
{
	for (int pool = 0; pool < POOL_COUNT; ++pool)
	{
		int count = items_in_use(a, pool_info[pool].per), other = items_in_use(b, pool_info[pool].per);
		if (count != other)
		{
			print_message("pool %s: %d items, and %d\n", pool_info[pool].name, count, other);
			continue;
		}
		size_t bytes = pool_info[pool].bytes;
		char *items_a = read_pool(a, (PoolId)pool, count), *items_b = read_pool(b, (PoolId)pool, count);
		int different = 0, first = -1;
		for (int k = 0; k < count; ++k)
		{
			if (memcmp(items_a + (size_t)k * bytes, items_b + (size_t)k * bytes, bytes) == 0)
				continue;
			first = different++ == 0 ? k : first;
		}
		if (different > 0)
		{
			print_message("pool %s: %d of %d items differ, the first is %d:", pool_info[pool].name, different, count,
			              first);
			for (size_t word = 0; word + 4 <= bytes && word < 64; word += 4)
			{
				uint32_t x, y;
				memcpy(&x, items_a + (size_t)first * bytes + word, 4);
				memcpy(&y, items_b + (size_t)first * bytes + word, 4);
				print_message(x == y ? " %08x" : " %08x|%08x", x, y);
			}
			print_message("\n");
		}
		free(items_a);
		free(items_b);
	}
}
