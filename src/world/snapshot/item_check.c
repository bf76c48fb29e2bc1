// SPDX-License-Identifier: MIT
// item_check.c -- checks items of pools that come from bytes of a user: numbers, and what contacts refer to.
#include "world/snapshot/item_check.h"
#include "constraints/constraint_kinds.h"
#include <float.h>
#include <math.h>

#define FAR      1e9f // m: bodies stop at 1e8 m
#define FEATURES 16   // number of features of a shape: corners, then edges

#define ITEMS(type, pool) ((const type*)pools[POOL_##pool])

static int items_of(const ItemCounts* counts, Per per)
{
	return per == PER_BODY         ? counts->padded_bodies
	       : per == PER_COLLIDABLE ? counts->collidables
	       : per == PER_ATTRIBUTE  ? counts->attributes
	                               : counts->contacts;
}

scree_status floats_check(const ChunkIndex* index, const ItemCounts* counts, void* const* pools)
{
	static const struct
	{
		PoolId pool;
		float most;
	} all[] = {{POOL_collidable_pose, FAR},
	           {POOL_box, EMPTY_LOW},
	           {POOL_old_box, EMPTY_LOW},
	           {POOL_pose, FAR},
	           {POOL_body, FLT_MAX},
	           {POOL_motion, FLT_MAX},
	           {POOL_pose_low, FAR},
	           {POOL_local_center, FAR},
	           {POOL_reported_pose, FAR},
	           {POOL_stored_velocity, FLT_MAX},
	           {POOL_still, FLT_MAX},
	           {POOL_sleep_threshold, FLT_MAX},
	           {POOL_contact_surface, FLT_MAX},
	           {POOL_contact_kept, FLT_MAX},
	           {POOL_contact_manifold, FLT_MAX},
	           {POOL_thickness, FAR}};
	for (size_t p = 0; p < sizeof all / sizeof *all; ++p)
	{
		const float* values = pools[all[p].pool];
		size_t floats = pool_info[all[p].pool].bytes / sizeof(float);
		size_t count = values ? (size_t)items_of(counts, pool_info[all[p].pool].per) * floats : 0;
		for (size_t k = 0; k < count; ++k)
			CHECK_ITEM(fabsf(values[k]) <= all[p].most, pool_info[all[p].pool].name, k / floats);
	}
	return SCREE_OK;
}

scree_status contacts_check(const ChunkIndex* index, const ItemCounts* counts, void* const* pools)
{
	int used = counts->collidables, bodies_used = counts->bodies;
	for (int k = 0; k < counts->contacts; ++k)
	{
		Int2 pair = ITEMS(Int2, pair)[k], bodies = ITEMS(Int2, contact_bodies)[k];
		bool there = pair.x >= 0;
		CHECK_ITEM(there ? in_range(pair.x, 0, used) && in_range(pair.y, 0, used) : pair.x == -1 && pair.y == -1,
		           "pair", k);
		CHECK_ITEM(there || ITEMS(int, contact_color)[k] == COLOR_NONE, "contact_color", k);
		CHECK_ITEM(in_range(bodies.x, 0, bodies_used) && in_range(bodies.y, 0, bodies_used), "contact_bodies", k);
		Word flags = ITEMS(Word, contact_flags)[k];
		CHECK_ITEM((flags & CONTACT_COUNT) <= 2 && !(flags & counts->unused) && (there || flags == 0), "contact_flags",
		           k);
		for (int p = 0; p < 2; ++p)
		{
			int feature = p ? ITEMS(Int2, contact_feature)[k].y : ITEMS(Int2, contact_feature)[k].x;
			CHECK_ITEM(feature == -1 || (in_range(feature >> 8, 0, FEATURES) && (feature & 255) < FEATURES),
			           "contact_feature", k);
		}
	}
	return SCREE_OK;
}
