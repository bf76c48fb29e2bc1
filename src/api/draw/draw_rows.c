// SPDX-License-Identifier: MIT
// draw_rows.c -- reads the arrays of a device from which a world is drawn and its collidables are listed.
#include "api/draw/draw_rows.h"
#include "step/state_readback.h"
#include "world/check.h"
#include "world/failure.h"
#include "world/pool_read.h"
#include "world/record/api_calls.h"
#include "world/shape/geometry.h"
#include "world/upload/upload.h"
#include <math.h>

#define BODIES_NEEDED \
	(SCREE_DRAW_FIELDS | SCREE_DRAW_JOINTS | SCREE_DRAW_CENTERS | SCREE_DRAW_SPEEDS | SCREE_DRAW_LABELS)
#define SHAPES_NEEDED   (SCREE_DRAW_SHAPES | SCREE_DRAW_SENSORS)
#define CONTACTS_NEEDED (SCREE_DRAW_CONTACTS | SCREE_DRAW_IMPULSES)

static scree_status no_memory(const char* function, size_t bytes)
{
	return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for %zu bytes from the device", function, bytes);
}

static scree_status read_pool(scree_world* world, const char* function, PoolId pool, int count, void** items)
{
	size_t bytes = pool_info[pool].bytes * (size_t)count;
	if (count == 0)
		return SCREE_OK;
	*items = scree_allocate(bytes);
	if (!*items)
		return no_memory(function, bytes);
	return world_read(world, pool, 0, count, *items);
}

static scree_status read_shapes(scree_world* world, const char* function, DrawRows* rows)
{
	int collidables = world->collidables.used, bodies = world->bodies.used;
	if (collidables == 0)
		return SCREE_OK;
	TRY(world_note(world, pipeline_render(&world->pipeline, collidables, false, false)));
	TRY(read_pool(world, function, POOL_render_row, collidables, (void**)&rows->placed));
	if (world->def.sleep)
	{
		rows->asleep = scree_allocate((size_t)bodies * sizeof *rows->asleep);
		if (!rows->asleep)
			return no_memory(function, (size_t)bodies * sizeof *rows->asleep);
		TRY(world_read_sleep(world, 0, bodies, rows->asleep));
	}
	Counters counters;
	TRY(world_read(world, POOL_counters, 0, 1, &counters));
	rows->frozen = counters.nonfinite > 0 ? counters.first_nonfinite : -1;
	return SCREE_OK;
}

static scree_status read_contacts(scree_world* world, const char* function, DrawRows* rows)
{
	int count = 0;
	TRY(api_world_get_contacts_sized(world, NULL, sizeof *rows->contacts, 0, &count));
	if (count == 0)
		return SCREE_OK;
	rows->contacts = scree_allocate((size_t)count * sizeof *rows->contacts);
	if (!rows->contacts)
		return no_memory(function, (size_t)count * sizeof *rows->contacts);
	return api_world_get_contacts_sized(world, rows->contacts, sizeof *rows->contacts, count, &rows->contact_count);
}

scree_status draw_rows_read(scree_world* world, const char* function, uint32_t flags, DrawRows* rows)
{
	rows->frozen = -1;
	TRY(world_upload(world));
	if (flags & SHAPES_NEEDED)
		TRY(read_shapes(world, function, rows));
	if (flags & BODIES_NEEDED || (flags & SHAPES_NEEDED && world->disabled_bodies > 0))
		TRY(read_pool(world, function, POOL_pose, world->bodies.used, (void**)&rows->poses));
	if (flags & SCREE_DRAW_SPEEDS)
		TRY(read_pool(world, function, POOL_body, world->bodies.used, (void**)&rows->states));
	if (flags & SCREE_DRAW_BOXES)
		TRY(read_pool(world, function, POOL_box, world->collidables.used, (void**)&rows->boxes));
	if (flags & SCREE_DRAW_JOINTS)
		TRY(read_pool(world, function, POOL_joint_flags, world->joints.used, (void**)&rows->joint_flags));
	return flags & CONTACTS_NEEDED ? read_contacts(world, function, rows) : SCREE_OK;
}

void draw_rows_release(DrawRows* rows)
{
	scree_release(rows->placed);
	scree_release(rows->poses);
	scree_release(rows->states);
	scree_release(rows->asleep);
	scree_release(rows->boxes);
	scree_release(rows->joint_flags);
	scree_release(rows->contacts);
}

scree_status draw_view(const char* function, const scree_box* box, scree_box* view)
{
	*view = (scree_box){{-INFINITY, -INFINITY}, {INFINITY, INFINITY}};
	if (!box)
		return SCREE_OK;
	*view = *box;
	if (box->lower.x <= box->upper.x && box->lower.y <= box->upper.y)
		return SCREE_OK;
	return fail(SCREE_ERROR_INVALID, "%s: box from (%s, %s) to (%s, %s) must have a lower corner below its upper one",
	            function, decimal(box->lower.x).text, decimal(box->lower.y).text, decimal(box->upper.x).text,
	            decimal(box->upper.y).text);
}

scree_pose draw_place(const scree_world* world, const DrawRows* rows, int collidable)
{
	const HostCollidable* host = world->host_collidables + collidable;
	const WorldShape* row = rows->placed + collidable;
	// a disabled body has no render rows
	if (draw_is_disabled(world, collidable))
		return pose_product(world_body_pose(world, host->body, rows->poses + host->body), host->pose);
	return (scree_pose){{row->x, row->y}, {row->c, row->s}};
}

scree_box draw_outline(const scree_shape* shape, scree_pose pose, scree_vec vertices[SCREE_MAX_VERTICES])
{
	scree_box box = {{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};
	for (int k = 0; k < shape->count; ++k)
	{
		scree_vec v = vertices[k] = pose_point(pose, shape->vertices[k]);
		box.lower.x = fminf(box.lower.x, v.x - shape->radius);
		box.lower.y = fminf(box.lower.y, v.y - shape->radius);
		box.upper.x = fmaxf(box.upper.x, v.x + shape->radius);
		box.upper.y = fmaxf(box.upper.y, v.y + shape->radius);
	}
	return box;
}
