// SPDX-License-Identifier: MIT
// pool_check.c -- checks the pools of a snapshot before they are written to a device.
#include "world/snapshot/pool_check.h"
#include "constraints/constraint_kinds.h"
#include "platform/error.h"
#include "world/device/lasting.h"
#include "world/objects/collidables.h"
#include "world/objects/joints.h"
#include "world/pool_values.h"
#include "world/snapshot/color_check.h"
#include "world/world.h"
#include <string.h>

#define ITEMS(type, pool) ((const type*)pools[POOL_##pool])

static scree_status check_attributes(const ChunkIndex* index, const scree_world* world, void* const* pools)
{
	for (int k = 0; k < world->edits.attribute_rows; ++k)
	{
		int least = k < world->attribute_slots.used && slots_in_use(&world->attribute_slots, k);
		CHECK_ITEM(in_range(ITEMS(Attribute, attribute)[k].count, least, MAX_CORNERS + 1), "attribute", k);
		CHECK_ITEM(in_range(ITEMS(Rule, rule)[k].material, 0, MATERIALS), "rule", k);
	}
	return SCREE_OK;
}

static scree_status check_collidables(const ChunkIndex* index, const scree_world* world, void* const* pools)
{
	int used = world->collidables.used, rows = world->edits.attribute_rows;
	for (int k = 0; k < used; ++k)
	{
		const HostCollidable* host = world->host_collidables + k;
		bool there = device_kind(world, k) != KIND_DEAD; // the device has no row for a collidable of a disabled body
		int next = ITEMS(int, next_collidable)[k], body = ITEMS(int, collidable_body)[k];
		CHECK_ITEM(ITEMS(int, collidable_kind)[k] == device_kind(world, k), "collidable_kind", k);
		CHECK_ITEM(there ? body == host->body : in_range(body, -1, world->bodies.used), "collidable_body", k);
		CHECK_ITEM(in_range(ITEMS(int, collidable_attribute)[k], 0, rows), "collidable_attribute", k);
		CHECK_ITEM(!there || ITEMS(int, collidable_attribute)[k] == host->attribute, "collidable_attribute", k);
		CHECK_ITEM(there ? next == host->next + 1 : in_range(next, 0, used + 1), "next_collidable", k);
		CHECK_ITEM(!there || ITEMS(Filter, filter)[k].reports == (Word)report_bits(host), "filter", k);
		CHECK_ITEM(!there || is_turn(ITEMS(Float4, collidable_pose)[k].z, ITEMS(Float4, collidable_pose)[k].w),
		           "collidable_pose", k);
		CHECK_ITEM(in_range(ITEMS(WorldShape, world_shape)[k].attribute, 0, rows), "world_shape", k);
		CHECK_ITEM(in_range(ITEMS(WorldShape, world_shape)[k].body, -1, world->bodies.used), "world_shape", k);
	}
	return SCREE_OK;
}

static scree_status check_bodies(const ChunkIndex* index, const scree_world* world, void* const* pools)
{
	int used = world->bodies.used, items = lasting_items(world, PER_BODY);
	for (int k = 0; k < items; ++k) // kernels also process the padding behind the bodies
	{
		const ContinuousBody* c = ITEMS(ContinuousBody, continuous_body) + k;
		bool there = k > 0 && k < used && slots_in_use(&world->bodies, k);
		CHECK_ITEM(c->first == 0 || (there && c->first == world->host_bodies[k].first_collidable + 1),
		           "continuous_body", k);
		CHECK_ITEM(!there || is_turn(ITEMS(Float4, pose)[k].z, ITEMS(Float4, pose)[k].w), "pose", k);
		CHECK_ITEM(in_range(c->parts, 0, CONTINUOUS_PARTS + 1), "continuous_body", k);
		CHECK_ITEM(in_range(ITEMS(int, sleep)[k] & SLEEP_ISLAND, 0, used + 1), "sleep", k);
		CHECK_ITEM(there ? ITEMS(int, sleep)[k] >= 0 : ITEMS(int, sleep)[k] == 0, "sleep", k);
		CHECK_ITEM(in_range(ITEMS(int, hub)[k], 0, used), "hub", k);
	}
	return SCREE_OK;
}

static scree_status check_contacts(const ChunkIndex* index, const scree_world* world, void* const* pools)
{
	const Counters* counters = &world->pipeline.counters;
	int alive = 0;
	for (int k = 0; k < counters->contacts; ++k)
	{
		bool there = ITEMS(Int2, pair)[k].x >= 0;
		CHECK_ITEM(there || ITEMS(int, contact_place)[k] == -1, "contact_place", k);
		alive += there;
	}
	CHECK_ITEM(counters->alive - counters->released == alive, "contacts", alive);
	return SCREE_OK;
}

static scree_status check_joints(const ChunkIndex* index, const scree_world* world, void* const* pools)
{
	for (int k = 0; k < world->pipeline.counters.joints; ++k)
	{
		const JointData* data = ITEMS(JointData, joint_data) + k;
		const JointEdit made = joint_edit(world, k);
		Int2 bodies = ITEMS(Int2, joint_bodies)[k];
		if (slots_in_use(&world->joints, k))
			CHECK_ITEM(memcmp(data, &made.data, sizeof *data) == 0, "joint_data", k);
		else
			CHECK_ITEM(!(ITEMS(int, joint_flags)[k] & JOINT_THERE), "joint_flags", k);
		CHECK_ITEM(in_range(bodies.x, 0, world->bodies.used) && in_range(bodies.y, 0, world->bodies.used),
		           "joint_bodies", k);
		CHECK_ITEM(ITEMS(int, joint_spot)[k] == made.spot, "joint_spot", k);
	}
	for (int k = 0; k < world->pipeline.counters.joint_events; ++k)
		CHECK_ITEM(in_range(ITEMS(JointEvent, joint_event)[k].slot, 0, world->joints.used), "joint_event", k);
	return SCREE_OK;
}

typedef struct // the layout of the constraints of a kind, and the pools with it
{
	int slots;
	const KindLayout* layout;
	const int *color, *place, *place_slot;
	const char* name;
} LayoutCheck;

// Checks the places of the constraints of a kind: that each is at one place, in the range of its color.
static scree_status check_layout(const ChunkIndex* index, const LayoutCheck* c)
{
	const int* begin = c->layout->begin;
	int listed = 0, placed = 0;
	CHECK_ITEM(begin[0] == 0, c->name, 0);
	for (int color = 0; color <= COLORS; ++color)
	{
		CHECK_ITEM(begin[color + 1] >= begin[color] && begin[color + 1] <= begin[COLORS + 1] &&
		               begin[color + 1] % COLOR_PADDING == 0,
		           c->name, color);
		for (int place = begin[color]; place < begin[color + 1]; ++place)
		{
			int slot = c->place_slot[place];
			CHECK_ITEM(in_range(slot, -1, c->slots), c->name, place);
			if (slot < 0 || c->place[slot] == -1) // -1: the user destroyed or changed the joint since the last step
				continue;
			CHECK_ITEM(c->place[slot] == place && c->color[slot] == color, c->name, place);
			++listed;
		}
	}
	for (int color = 0; color <= COLORS; ++color)
	{
		CHECK_ITEM(in_range(c->layout->count[color], 0, begin[color + 1] - begin[color] + 1), c->name, color);
		CHECK_ITEM(in_range(c->layout->first[color], 0, c->slots + 1), c->name, color);
		CHECK_ITEM(in_range(c->layout->last[color], c->layout->first[color], c->slots + 1), c->name, color);
	}
	for (int k = 0; k < c->slots; ++k)
	{
		CHECK_ITEM(in_range(c->color[k], COLOR_WANTED, COLORS + 1), c->name, k);
		CHECK_ITEM(in_range(c->place[k], -1, begin[COLORS + 1]), c->name, k);
		placed += c->place[k] >= 0;
	}
	CHECK_ITEM(placed == listed, c->name, placed);
	return SCREE_OK;
}

static scree_status check_rows(const ChunkIndex* index, const scree_world* world, void* const* pools)
{
	const KindLayout* layout = world->pipeline.counters.layout;
	for (int place = 0; place < layout[CONSTRAINT_CONTACT].begin[COLORS + 1]; ++place)
	{
		const struct ContactRows* rows = ITEMS(struct ContactRows, contact_rows) + place / MAX_LANES;
		Int2 pair = ITEMS(Int2, contact_place_pair)[place];
		CHECK_ITEM(in_range(rows->body_a[place % MAX_LANES], 0, world->bodies.used), "contact_rows", place);
		CHECK_ITEM(in_range(rows->body_b[place % MAX_LANES], 0, world->bodies.used), "contact_rows", place);
		CHECK_ITEM(in_range(pair.x, 0, world->collidables.used) && in_range(pair.y, 0, world->collidables.used),
		           "contact_place_pair", place);
	}
	for (int place = 0; place < layout[CONSTRAINT_JOINT].begin[COLORS + 1]; ++place)
	{
		const struct JointRows* rows = ITEMS(struct JointRows, joint_rows) + place / MAX_LANES;
		const struct JointRareRows* rare = ITEMS(struct JointRareRows, joint_rare_rows) + place / MAX_LANES;
		int lane = place % MAX_LANES, slot = ITEMS(int, joint_place_slot)[place];
		CHECK_ITEM(in_range(rows->body_a[lane], 0, world->bodies.used), "joint_rows", place);
		CHECK_ITEM(in_range(rows->body_b[lane], 0, world->bodies.used), "joint_rows", place);
		// a new joint does not read the row, which may be that of an earlier joint on another path
		if (slot < 0 || world->host_joints[slot].path < 0 || ITEMS(int, joint_flags)[slot] & JOINT_NEW)
			continue;
		float segment = rare->path_segment[lane],
		      last = (float)world->host_paths[world->host_joints[slot].path].segments;
		CHECK_ITEM(segment >= 0.0f && segment < last, "joint_rare_rows", place);
	}
	return SCREE_OK;
}

static scree_status check_layouts(const ChunkIndex* index, const scree_world* world, void* const* pools)
{
	const Counters* counters = &world->pipeline.counters;
#define CONSTRAINT_KIND(name_, Name, NAME)                               \
	{                                                                    \
		LayoutCheck c = {.slots = counters->name_##s,                    \
		                 .layout = counters->layout + CONSTRAINT_##NAME, \
		                 .color = ITEMS(int, name_##_color),             \
		                 .place = ITEMS(int, name_##_place),             \
		                 .place_slot = ITEMS(int, name_##_place_slot),   \
		                 .name = #name_ "_place"};                       \
		TRY(check_layout(index, &c));                                    \
	}
#include "pools/kinds.def"
#undef CONSTRAINT_KIND
	return check_rows(index, world, pools);
}

static ItemCounts counts_of(const scree_world* world)
{
	const Pipeline* pipeline = &world->pipeline;
	// flags of contacts that are listed, in worlds that have no memory for these lists
	Word unused = (pipeline->reports ? 0 : CONTACT_REPORTS | CONTACT_TOUCHED) |
	              (pipeline->asks && pipeline->reports ? 0 : CONTACT_APPROVALS) |
	              (pipeline->platforms ? 0 : CONTACT_PASSES | CONTACT_SUNK);
	return (ItemCounts){.bodies = world->bodies.used,
	                    .collidables = world->collidables.used,
	                    .attributes = world->edits.attribute_rows,
	                    .contacts = pipeline->counters.contacts,
	                    .joints = pipeline->counters.joints,
	                    .padded_bodies = lasting_items(world, PER_BODY),
	                    .unused = unused};
}

scree_status pool_check(const ChunkIndex* index, const scree_world* world, void* const* pools)
{
	const ItemCounts counts = counts_of(world);
	TRY(floats_check(index, &counts, pools));
	TRY(check_attributes(index, world, pools));
	TRY(check_collidables(index, world, pools));
	TRY(check_bodies(index, world, pools));
	TRY(contacts_check(index, &counts, pools));
	TRY(check_contacts(index, world, pools));
	TRY(check_joints(index, world, pools));
	TRY(check_layouts(index, world, pools));
	return color_check(index, &counts, pools);
}
