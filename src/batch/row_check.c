// SPDX-License-Identifier: MIT
// row_check.c -- checks the items of a row, which may come from anywhere, before a batch gets them.
//
// A checksum finds damage, not intent. The checks are those of a snapshot (world/snapshot/), as far as a row has the same
// items; what no step changes must be that of the template with the own values of the row.
#include "batch/row_check.h"
#include "batch/own_check.h"
#include "batch/row_structure.h"
#include "constraints/constraint_kinds.h"
#include "platform/error.h"
#include "world/snapshot/color_check.h"
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#define FLAGS_OF_COLLIDABLES                                                                              \
	(COLLIDABLE_NEW_BOX | COLLIDABLE_FAST | COLLIDABLE_MOVING | COLLIDABLE_CHANGED | COLLIDABLE_SHIFTED | \
	 COLLIDABLE_RESTARTED | COLLIDABLE_GRAINS)
#define LARGEST_FLOAT 0x7f7fffff // bits of FLT_MAX

// Checks a value of the head.
#define CHECK_HEAD(condition) CHECK_ITEM(condition, "head", 0)

static bool is_truth(int x) { return x == 0 || x == 1; }
static bool is_positive(float x) { return x >= 0.0f && x <= FLT_MAX; }
static bool is_positive_bits(int x) { return x >= 0 && x <= LARGEST_FLOAT; }

// Returns whether a value of the pool sleep is that of a sleeping body.
static bool is_sleep(int sleep, int bodies)
{
	return (sleep & ~(SLEEP_ISLAND | SLEEP_LOCK_X | SLEEP_LOCK_Y)) == 0 &&
	       in_range(sleep & SLEEP_ISLAND, 1, bodies + 1);
}

static scree_status check_head(const ChunkIndex* index, const RowHead* head)
{
	const BayState* state = &head->state;
	CHECK_HEAD(is_positive(head->dt) && is_truth(state->surfaces) && is_truth(state->surfaces_used));
	CHECK_HEAD(is_positive(state->substep) && is_positive(state->h_ratio));
	CHECK_HEAD(is_truth(state->press[0]) && is_truth(state->press[1]) && is_truth(state->ways));
	CHECK_HEAD(is_truth(state->presses) && is_truth(state->joints_dirty) && is_truth(state->taut));
	CHECK_HEAD(is_truth(state->taut_seen) && is_truth(state->taut_used) && state->crowded == 0);
	CHECK_HEAD(is_positive_bits(state->penetration) && is_positive_bits(state->joint_gap));
	CHECK_HEAD(in_range(state->nonfinite, 0, head->count[ROW_BODIES] + 1) && state->steps >= 0);
	CHECK_HEAD(is_truth(state->drowsy) && is_truth(state->joined_islands) && is_truth(state->settles));
	CHECK_HEAD(is_truth(state->searches) && is_truth(state->woken));
	CHECK_HEAD(fabsf(head->gravity.x) <= FLT_MAX && fabsf(head->gravity.y) <= FLT_MAX);
	return SCREE_OK;
}

static scree_status check_bodies(const ChunkIndex* index, const Expected* expected, const Pools* row)
{
	const Template* from = expected->from;
	for (int k = 0; k < from->bodies; ++k)
	{
		BodyStructure is, must;
		const Press* press = row->press + k;
		body_structure(row, k, &is);
		expected_body(expected, k, &must);
		CHECK_ITEM(memcmp(&is, &must, sizeof is) == 0, "body", k);
		CHECK_ITEM(k == 0 || !slots_in_use(&from->world->bodies, k) || is_turn(row->pose[k].z, row->pose[k].w), "pose",
		           k);
		CHECK_ITEM(row->sleep[k] == 0 || (from->request.sleep && is_sleep(row->sleep[k], from->bodies)), "sleep", k);
		CHECK_ITEM(in_range(row->wake[k], 0, from->request.sleep ? WAKE_WORLD + 1 : 1), "wake", k);
		CHECK_ITEM(in_range(row->static_contact[k], -MAX_CONTACTS, MAX_CONTACTS), "static_contact", k);
		CHECK_ITEM(in_range(press->way[0], 0, 1 << 24) && in_range(press->way[1], 0, 1 << 24), "press", k);
		CHECK_ITEM(is_positive_bits(press->depth) && is_positive_bits(press->speed), "press", k);
		CHECK_ITEM(in_range(press->left, 0, COUNT_MOST) && is_truth(press->tight), "press", k);
		CHECK_ITEM(fabsf(press->before) <= FLT_MAX && fabsf(press->spun) <= FLT_MAX, "press", k);
	}
	return SCREE_OK;
}

// Returns whether a number is that of an attribute of the template, or of the collidable.
static bool is_attribute(const Expected* e, int collidable, int number)
{
	return in_range(number, 0, e->from->attributes) || (e->host && number == e->own.collidable[collidable].attribute);
}

static scree_status check_collidables(const ChunkIndex* index, const Expected* expected, const Pools* row)
{
	const Template* from = expected->from;
	for (int k = 0; k < from->collidables; ++k)
	{
		CollidableStructure is, must;
		WorldShape shape = row->world_shape[k];
		collidable_structure(row, k, 0, &is);
		expected_collidable(expected, k, &must);
		CHECK_ITEM(memcmp(&is, &must, sizeof is) == 0, "collidable", k);
		// kernels also read the items of free slots
		CHECK_ITEM(in_range(row->collidable_body[k], -1, from->bodies), "collidable_body", k);
		CHECK_ITEM(is_attribute(expected, k, row->collidable_attribute[k]), "collidable_attribute", k);
		CHECK_ITEM(in_range(row->next_collidable[k], 0, from->collidables + 1), "next_collidable", k);
		CHECK_ITEM((row->collidable_flags[k] & ~FLAGS_OF_COLLIDABLES) == 0, "collidable_flags", k);
		CHECK_ITEM(is_attribute(expected, k, shape.attribute), "world_shape", k);
		CHECK_ITEM(in_range(shape.body, -1, from->bodies), "world_shape", k);
		CHECK_ITEM(fabsf(shape.x) <= EMPTY_LOW && fabsf(shape.y) <= EMPTY_LOW, "world_shape", k);
	}
	return SCREE_OK;
}

static scree_status check_joints(const ChunkIndex* index, const Expected* expected, const Pools* row)
{
	const Template* from = expected->from;
	for (int k = 0; k < from->joints; ++k)
	{
		JointStructure is, must;
		const JointData* data = row->joint_data + k;
		Int2 bodies = row->joint_bodies[k];
		joint_structure(row, k, &is);
		expected_joint(expected, k, &must);
		CHECK_ITEM(memcmp(&is, &must, sizeof is) == 0, "joint", k);
		CHECK_ITEM(in_range(data->body_a, 0, from->bodies) && in_range(data->body_b, 0, from->bodies), "joint_data", k);
		CHECK_ITEM(in_range(bodies.x, 0, from->bodies) && in_range(bodies.y, 0, from->bodies), "joint_bodies", k);
		for (int c = 0; c < JOINT_COORDINATES; ++c)
			CHECK_ITEM(fabsf(data->lock[c].target) <= FLT_MAX && fabsf(data->drive[c].speed) <= FLT_MAX &&
			               fabsf(data->drive[c].motor_most) <= FLT_MAX,
			           "joint_data", k);
		if (!(is.flags & JOINT_THERE) || !((int)data->modes & JOINT_RAILED) || row->joint_flags[k] & JOINT_NEW)
			continue;
		float segment = row->joint_rare_kept[k].path_segment;
		CHECK_ITEM(segment >= 0.0f && segment < data->path_segments, "joint_rare_kept", k);
		CHECK_ITEM(fabsf(row->joint_rare_kept[k].path_laps) <= FLT_MAX, "joint_rare_kept", k);
	}
	return SCREE_OK;
}

static scree_status check_items(const ChunkIndex* index, const RowHead* head, const Expected* expected,
                                void* const* pools)
{
	const Template* from = expected->from;
	bool reports = from->pipeline.reports || from->request.reports;
	const ItemCounts counts = {.bodies = from->bodies,
	                           .collidables = from->collidables,
	                           .attributes = from->attributes,
	                           .contacts = head->count[ROW_CONTACTS],
	                           .joints = from->joints,
	                           .padded_bodies = from->bodies,
	                           // flags of contacts that are listed, in worlds that have no memory for these lists
	                           .unused = (reports ? 0 : CONTACT_REPORTS | CONTACT_TOUCHED) |
	                                     (from->pipeline.platforms ? 0 : CONTACT_PASSES | CONTACT_SUNK) |
	                                     (from->request.sleep ? 0 : CONTACT_ASLEEP) | CONTACT_APPROVALS};
	Pools row;
	memset(&row, 0, sizeof row);
#define X(type, name, per, role) row.name = pools[POOL_##name];
#include "pools/pools.def"
	TRY(check_head(index, head));
	TRY(floats_check(index, &counts, pools));
	TRY(check_bodies(index, expected, &row));
	TRY(check_collidables(index, expected, &row));
	TRY(contacts_check(index, &counts, pools));
	TRY(check_joints(index, expected, &row));
	return color_check(index, &counts, pools);
}

// Checks a row at an address with the alignment of its items.
static scree_status check_aligned(const ChunkIndex* index, const RowHead* head, const Template* from, char* row)
{
	size_t at[POOL_COUNT];
	void* pools[POOL_COUNT];
	char* values = row + row_own(head->count);
	Expected expected = {.from = from};
	row_layout(head->count, at);
	for (int pool = 0; pool < POOL_COUNT; ++pool)
		pools[pool] = row_kind((PoolId)pool) < 0 ? NULL : row + at[pool];
	if (memcmp(values, from->own, own_size(from)) == 0)
		return check_items(index, head, &expected, pools);
	expected.own = own_of(from, values);
	TRY(own_check(index, from, expected.own));
	TRY(own_host_open(&expected.host, from->world));
	own_host_set(expected.host, from, expected.own);
	scree_status status = check_items(index, head, &expected, pools);
	own_host_close(expected.host);
	return status;
}

scree_status row_check(const char* row, const RowHead* head, const Template* from, const char* function, int number)
{
	char subject[64], *copy = NULL;
	snprintf(subject, sizeof subject, "state %d is refused", number);
	const ChunkIndex index = {.function = function, .subject = subject};
	if ((uintptr_t)row % ROW_ALIGN != 0)
	{
		copy = scree_allocate((size_t)head->bytes);
		if (!copy)
			return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory to check a state", function);
		memcpy(copy, row, (size_t)head->bytes);
	}
	scree_status status = check_aligned(&index, head, from, copy ? copy : (char*)row);
	scree_release(copy);
	return status;
}
