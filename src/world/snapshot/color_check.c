// SPDX-License-Identifier: MIT
// color_check.c -- checks the colors of constraints.
#include "world/snapshot/color_check.h"
#include "constraints/constraint_kinds.h"
#include "platform/error.h"

#define ITEMS(type, pool) ((const type*)pools[POOL_##pool])

typedef struct // sums over the constraints of each body
{
	int* touching; // number of constraints that have begun
	Word64* masks; // their colors, and those that sleeping contacts keep
} Counted;

typedef struct // constraints of a kind
{
	const char* name;
	const int *color, *flags;
	const Int2* bodies;
	int count;
	int asleep; // flag of a constraint that a sleeping body has ended
} Colored;

static void count_end(const Counted* counted, int body, int color)
{
	counted->touching[body] += color >= 0;
	color = color < 0 ? COLOR_KEPT(color) : color;
	if (color < COLORS)
		counted->masks[body] |= (Word64)1 << color;
}

static scree_status count_kind(const ChunkIndex* index, const Counted* counted, const Colored* c)
{
	for (int k = 0; k < c->count; ++k)
	{
		int color = c->color[k];
		CHECK_ITEM(color < 0 || (color <= COLORS && !(c->flags[k] & c->asleep)), c->name, k);
		CHECK_ITEM(color >= COLOR_NONE || (COLOR_KEPT(color) < COLORS && c->flags[k] & c->asleep), c->name, k);
		if (color == COLOR_NONE)
			continue;
		count_end(counted, c->bodies[k].x, color);
		count_end(counted, c->bodies[k].y, color);
	}
	return SCREE_OK;
}

static scree_status check_all(const ChunkIndex* index, const ItemCounts* counts, void* const* pools,
                              const Counted* counted)
{
	const Colored contacts = {"contact_color",           ITEMS(int, contact_color),
	                          ITEMS(int, contact_flags), ITEMS(Int2, contact_bodies),
	                          counts->contacts,          (int)CONTACT_ASLEEP};
	const Colored joints = {"joint_color",           ITEMS(int, joint_color),
	                        ITEMS(int, joint_flags), ITEMS(Int2, joint_bodies),
	                        counts->joints,          JOINT_ASLEEP};
	TRY(count_kind(index, counted, &contacts));
	TRY(count_kind(index, counted, &joints));
	for (int k = 0; k < counts->bodies; ++k)
	{
		CHECK_ITEM(ITEMS(int, touching)[k] == counted->touching[k], "touching", k);
		// a body that the user has made dynamic since the last step lacks the colors of its contacts until the next one
		if (ITEMS(BodyState, body)[k].inv_mass > 0.0f)
			CHECK_ITEM((ITEMS(Word64, color_mask)[k] & ~counted->masks[k]) == 0, "color_mask", k);
	}
	return SCREE_OK;
}

scree_status color_check(const ChunkIndex* index, const ItemCounts* counts, void* const* pools)
{
	size_t used = (size_t)counts->bodies;
	const Counted counted = {scree_allocate(used * sizeof(int)), scree_allocate(used * sizeof(Word64))};
	scree_status status = SCREE_ERROR_OUT_OF_MEMORY;
	if (counted.touching && counted.masks)
		status = check_all(index, counts, pools, &counted);
	else
		fail(status, "%s: no memory to check colors", index->function);
	scree_release(counted.touching);
	scree_release(counted.masks);
	return status;
}
