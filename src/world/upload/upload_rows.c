// SPDX-License-Identifier: MIT
// upload_rows.c -- uploads attributes and long sequences of rows, pool by pool.
#include "world/upload/upload_rows.h"
#include "platform/error.h"
#include "world/objects/attributes.h"
#include "world/objects/collidables.h"
#include "world/objects/mass.h"
#include "world/pool_values.h"
#include "world/shape/geometry.h"
#include "world/upload/edit_order.h"
#include <stdlib.h>
#include <string.h>

Float4 body_pose(const BodyRow* row)
{
	scree_vec center = pose_point(row->pose, row->center);
	return make_float4(center.x, center.y, row->pose.rotation.c, row->pose.rotation.s);
}

// Writes the values of a body's row for one pool to *item, which the caller has set to zero.
static void body_item(scree_world* world, PoolId pool, const BodyRow* row, void* item)
{
	// a disabled body has velocity 0; the velocity that it gets when enabled is in the pool stored_velocity
	scree_velocity v = row->velocity, now = row->disabled || row->asleep ? (scree_velocity){0} : v;
	switch (pool)
	{
	case POOL_body:
		*(BodyState*)item = (BodyState){.vx = now.linear.x,
		                                .vy = now.linear.y,
		                                .w = now.angular,
		                                .inv_mass = row->inv_mass,
		                                .inv_inertia = row->inv_inertia};
		break;
	case POOL_pose:
		*(Float4*)item = body_pose(row);
		break;
	case POOL_motion:
		*(Motion*)item = (Motion){
#define X(name, least, most, value) .name = row->values.name,
#include "pools/body_values.def"
		    .free_x = row->asleep || row->locks & SCREE_LOCK_X ? 0.0f : 1.0f,
		    .free_y = row->asleep || row->locks & SCREE_LOCK_Y ? 0.0f : 1.0f};
		if (row->disabled)
			((Motion*)item)->gravity_scale = 0.0f;
		break;
	case POOL_local_center:
		*(Float2*)item = make_float2(row->center.x, row->center.y);
		break;
	case POOL_continuous_body:
		*(ContinuousBody*)item = continuous_row(world, row->index);
		break;
	case POOL_sleep:
		if (row->asleep)
			*(int*)item = (1 + row->index) | (row->locks & SCREE_LOCK_X ? SLEEP_LOCK_X : 0) |
			              (row->locks & SCREE_LOCK_Y ? SLEEP_LOCK_Y : 0);
		break;
	case POOL_still:
		*(float*)item = row->asleep ? STILL_MADE : 0.0f;
		break;
	case POOL_sleep_threshold:
		*(float*)item = row->sleep_threshold;
		break;
	case POOL_stored_velocity:
		if (row->disabled)
			*(StoredVelocity*)item = (StoredVelocity){v.linear.x, v.linear.y, v.angular, 1.0f};
		break;
	default:
		break;
	}
}

static void collidable_item(const scree_world* world, PoolId pool, int index, void* item)
{
	const HostCollidable* host = world->host_collidables + index;
	switch (pool)
	{
	case POOL_collidable_pose:
		*(Float4*)item = pose_row(host->pose);
		break;
	case POOL_collidable_attribute:
		*(int*)item = host->attribute;
		break;
	case POOL_collidable_body:
		*(int*)item = host->body;
		break;
	case POOL_next_collidable:
		*(int*)item = host->next + 1;
		break;
	case POOL_collidable_kind:
		*(int*)item = device_kind(world, index);
		break;
	case POOL_filter:
		*(Filter*)item = filter_row(host->filter, report_bits(host));
		break;
	case POOL_box:
	case POOL_old_box:
		*(Float4*)item = make_float4(EMPTY_LOW, EMPTY_LOW, EMPTY_HIGH, EMPTY_HIGH);
		break;
	default:
		break;
	}
}

static bool is_cleared(int pool, Per per) { return pool_info[pool].per == per && pool_info[pool].role <= STATE; }

size_t largest_row(Per per)
{
	size_t most = 0;
	for (int pool = 0; pool < POOL_COUNT; ++pool)
	{
		if (pool_info[pool].per == per && pool_info[pool].bytes > most)
			most = pool_info[pool].bytes;
	}
	return most;
}

scree_status upload_bodies(scree_world* world, int begin, int end, char* stage)
{
	Backend* b = world->backend;
	const BodyRow* rows = world->edits.bodies;
	int first = rows[begin].index;
	Step step = {0};
	Run gone = {.kernel_id = KERNEL_body_gone, .begin = first, .end = first + end - begin, .count = NO_COUNT};
	if (world->pipeline.sleeps)
		TRY(b->f->run(b, &step, &gone, 1));
	for (int pool = 0; pool < POOL_COUNT; ++pool)
	{
		size_t bytes = pool_info[pool].bytes;
		// the pool of reported poses is used only after the user's first request for moved bodies
		if (!is_cleared(pool, PER_BODY) && pool != POOL_start_pose &&
		    !(pool == POOL_reported_pose && world->pipeline.tells))
			continue;
		memset(stage, 0, (size_t)(end - begin) * bytes);
		for (int k = begin; k < end; ++k)
			body_item(world, (PoolId)pool, rows + k, stage + (size_t)(k - begin) * bytes);
		TRY(b->f->write(b, (PoolId)pool, first, end - begin, stage));
	}
	return SCREE_OK;
}

scree_status upload_collidables(scree_world* world, int begin, int end, char* stage)
{
	Backend* b = world->backend;
	const CollidableRow* rows = world->edits.collidables;
	bool dead = edit_is_dead(world, begin);
	for (int pool = 0; pool < POOL_COUNT; ++pool)
	{
		size_t bytes = pool_info[pool].bytes;
		if (dead ? pool != POOL_collidable_kind : !is_cleared(pool, PER_COLLIDABLE))
			continue;
		memset(stage, 0, (size_t)(end - begin) * bytes);
		for (int k = begin; k < end; ++k)
			collidable_item(world, (PoolId)pool, rows[k].index, stage + (size_t)(k - begin) * bytes);
		TRY(b->f->write(b, (PoolId)pool, rows[begin].index, end - begin, stage));
	}
	return SCREE_OK;
}

static scree_status write_attributes(scree_world* world, int first, int count, char* stage)
{
	Backend* b = world->backend;
	for (int k = 0; k < count; ++k)
		attribute_item(world, first + k, (Attribute*)stage + k);
	TRY(b->f->write(b, POOL_attribute, first, count, stage));
	for (int k = 0; k < count; ++k)
		((float*)stage)[k] = attribute_thickness(world, first + k);
	TRY(b->f->write(b, POOL_thickness, first, count, stage));
	if (!world->ruled)
		return SCREE_OK; // no attribute has a rule, and new rows of the pool are zero
	for (int k = 0; k < count; ++k)
		((Rule*)stage)[k] = attribute_rule(world, first + k);
	return b->f->write(b, POOL_rule, first, count, stage);
}

static int compare_slots(const void* a, const void* b) { return *(const int*)a - *(const int*)b; }

scree_status upload_attributes(scree_world* world, char* stage)
{
	Edits* p = &world->edits;
	if (p->attribute_count > 1)
		qsort(p->attributes, (size_t)p->attribute_count, sizeof *p->attributes, compare_slots);
	for (int k = 0, end; k < p->attribute_count; k = end)
	{
		for (end = k + 1; end < p->attribute_count && p->attributes[end] == p->attributes[end - 1] + 1;)
			++end;
		TRY(write_attributes(world, p->attributes[k], end - k, stage));
		int rows = p->attributes[end - 1] + 1;
		p->attribute_rows = rows > p->attribute_rows ? rows : p->attribute_rows;
	}
	return SCREE_OK;
}
