// SPDX-License-Identifier: MIT
// saved_pools.c -- copies items of pools to the pool `saved` and back, without the bus. A save contains the pools that
// outlive a step. Pools that only calls of the user change belong to the structure. Kernels pack the pools of bodies,
// collidables, contacts and joints (src/stages/save/); the others are copied whole.
#include "world/save/saved_pools.h"
#include "platform/error.h"
#include "step/reserve.h"
#include "world/device/lasting.h"

_Static_assert(MAX_ITEMS <= 1 << SAVED_PAIR_BITS, "the index of a collidable has more bits");
_Static_assert(CONTACT_FIXED == 3u << SAVED_PAIR_BITS, "save_contact shares these bits with the upper part of a code");
_Static_assert(MAX_CONTACTS <= 1 << SAVED_SLOT_BITS, "the index of a slot has more bits");

// The members of the pools `body` and `motion` that steps change are packed too.
static bool is_structure(PoolId pool)
{
	switch (pool)
	{
	case POOL_attribute:
	case POOL_thickness:
	case POOL_rule:
	case POOL_material_pair:
	case POOL_collidable_kind:
	case POOL_collidable_body:
	case POOL_collidable_attribute:
	case POOL_collidable_pose:
	case POOL_filter:
	case POOL_next_collidable:
	case POOL_local_center:
	case POOL_body:
	case POOL_motion:
	case POOL_stored_velocity:
	case POOL_continuous_body:
	case POOL_sleep_threshold:
	case POOL_joint_data:
	case POOL_excluded:
	case POOL_joint_spot:
	case POOL_chain:
	case POOL_branch:
	case POOL_path_sample:
		return true;
	default:
		return false;
	}
}

#define NO_KERNEL (-1)

static bool is_packed(PoolId pool)
{
	switch (pool_info[pool].per)
	{
	case PER_BODY:
	case PER_COLLIDABLE:
#define CONSTRAINT_KIND(kind, Kind, KIND) \
	case PER_##KIND:                      \
	case PER_##KIND##_PLACE:              \
	case PER_##KIND##_BLOCK:
#include "pools/kinds.def"
#undef CONSTRAINT_KIND
		return !is_structure(pool);
	default:
		return false;
	}
}

static bool is_saved(PoolId pool, bool structure)
{
	return pool_info[pool].role <= STANDING && pool_info[pool].per != PER_SAVED && pool != POOL_leaf &&
	       is_structure(pool) == structure;
}

static int64_t units(size_t bytes, int count)
{
	size_t unit = pool_info[POOL_saved].bytes;
	return (int64_t)((bytes * (size_t)count + unit - 1) / unit);
}

int64_t saved_pools_count(const scree_world* world, bool structure, int counts[POOL_COUNT])
{
	int64_t sum = 0;
	for (int pool = 0; pool < POOL_COUNT; ++pool)
	{
		counts[pool] = is_saved((PoolId)pool, structure) ? lasting_items(world, pool_info[pool].per) : 0;
		sum += is_packed((PoolId)pool) ? 0 : units(pool_info[pool].bytes, counts[pool]);
	}
	for (int t = 0; t < 2 && !structure; ++t)
		sum += units(sizeof(int), world->pipeline.trees[t].tree.leaves);
	return (sum + ALIGNED - 1) / ALIGNED * ALIGNED;
}

// Returns the number of items that may differ from those of a new world. Places of contacts keep those of earlier layouts,
// whose padding names collidables.
static int used_items(const scree_world* world, Per per)
{
	return per == PER_CONTACT_PLACE ? world->backend->capacity[per] : lasting_items(world, per);
}

scree_status saved_pools_copy(scree_world* world, bool structure, SavedRange range, const int counts[POOL_COUNT],
                              const int leaves[2], bool back)
{
	Backend* b = world->backend;
	int at = range.first;
	for (int pool = 0; pool < POOL_COUNT; ++pool)
	{
		if (!is_saved((PoolId)pool, structure))
			continue;
		int used = back ? used_items(world, pool_info[pool].per) : 0;
		if (used > counts[pool]) // items that the world has gained since
			TRY(b->f->clear(b, (PoolId)pool, counts[pool], used - counts[pool]));
		if (is_packed((PoolId)pool))
			continue;
		TRY(b->f->keep(b, (PoolId)pool, 0, counts[pool], at, back));
		at += (int)units(pool_info[pool].bytes, counts[pool]);
	}
	for (int t = 0; t < 2 && !structure; ++t)
	{
		TRY(b->f->keep(b, POOL_leaf, t * b->capacity[PER_COLLIDABLE], leaves[t], at, back));
		at += (int)units(sizeof(int), leaves[t]);
	}
	return SCREE_OK;
}

// Pools of groups are saved up to their capacity, so an item more would enlarge them at each load.
static bool is_scanned(Per per)
{
	return per != PER_BODY_GROUP && per != PER_COLLIDABLE_GROUP && per != PER_CONTACT_GROUP && per != PER_ONE;
}

scree_status saved_pools_reserve(scree_world* world, const int counts[POOL_COUNT])
{
	for (int pool = 0; pool < POOL_COUNT; ++pool)
	{
		Per per = pool_info[pool].per;
		if (counts[pool] > 0)
			TRY(pipeline_reserve(&world->pipeline, per, counts[pool] + is_scanned(per)));
	}
	return SCREE_OK;
}

// Adds a part. Items are padded, so that the words of MAX_LANES items are aligned.
static SavedPart part(int* at, int words, int count)
{
	SavedPart made = {*at, (count + MAX_LANES - 1) / MAX_LANES * MAX_LANES, count};
	*at += words * made.count;
	return made;
}

int64_t saved_words_count(const scree_world* world, int first, SavedLayout* layout)
{
	int bodies = lasting_items(world, PER_BODY), collidables = lasting_items(world, PER_COLLIDABLE);
	int contacts = lasting_items(world, PER_CONTACT), places = lasting_items(world, PER_CONTACT_PLACE), at = SAVED_HEAD;
	*layout = (SavedLayout){.first = first};
	layout->bodies = part(&at, SAVED_BODY_WORDS, bodies);
	layout->collidables = part(&at, SAVED_COLLIDABLE_WORDS, collidables);
	layout->contacts = part(&at, SAVED_CONTACT_WORDS, contacts);
	layout->places = part(&at, SAVED_PLACE_WORDS, places);
	layout->joints = part(&at, SAVED_JOINT_WORDS, lasting_items(world, PER_JOINT));
	layout->rest = at;
	return at;
}

scree_status saved_words_run(const scree_world* world, const Save* save, bool back)
{
	// these constants do not depend on the world, so that the predictions of a load are those of the save
	const Step step = {.small = 1, .material_pairs = save->material_pairs, .saved = save->layout};
	// in the order in which items follow from others
	static const struct
	{
		PoolId items;
		int save, load;
	} kernels[] = {{POOL_pose, KERNEL_save_body, KERNEL_load_body},
	               {POOL_box, KERNEL_save_collidable, KERNEL_load_collidable},
	               {POOL_contact_place_slot, NO_KERNEL, KERNEL_load_place_name},
	               {POOL_pair, KERNEL_save_contact, KERNEL_load_contact},
	               {POOL_pair, KERNEL_save_contact_odd, KERNEL_load_contact_odd},
	               {POOL_contact_place_slot, KERNEL_save_place, KERNEL_load_place},
	               {POOL_joint_place_slot, NO_KERNEL, KERNEL_load_joint_place},
	               {POOL_joint_flags, KERNEL_save_joint, KERNEL_load_joint}};
	Run runs[sizeof kernels / sizeof *kernels];
	int count = 0;
	for (size_t k = 0; k < sizeof kernels / sizeof *kernels; ++k)
	{
		int kernel = back ? kernels[k].load : kernels[k].save;
		if (kernel != NO_KERNEL && save->counts[kernels[k].items] > 0)
			runs[count++] = (Run){.kernel_id = kernel, .end = save->counts[kernels[k].items], .count = NO_COUNT};
	}
	return world->backend->f->run(world->backend, &step, runs, count);
}
