// SPDX-License-Identifier: MIT
// world_draw.c -- draws a world by functions of the program, and lists its collidables with poses and shapes.
#include "api/draw/draw_joints.h"
#include "api/draw/draw_marks.h"
#include "api/draw/draw_shapes.h"
#include "platform/processor.h"
#include "world/definition.h"
#include "world/failure.h"
#include "world/objects/handles.h"
#include "world/record/api_calls.h"

#define ALL_FLAGS  (2 * SCREE_DRAW_LABELS - 1)
#define MOST_SCALE 1e6f

void scree_draw_def_default_sized(scree_draw_def* def, size_t size)
{
	const scree_draw_def made = {.size = (uint32_t)size,
	                             .flags = SCREE_DRAW_SHAPES | SCREE_DRAW_SENSORS | SCREE_DRAW_JOINTS,
	                             .impulse_scale = 0.1f,
	                             .speed_scale = 0.1f,
	                             .length = 0.25f};
	write_result(def, size, &made, sizeof made);
}

static scree_status check_draw(const char* function, const scree_draw_def* def)
{
	ArgumentPlace at = {function, "def", ALONE};
	if (def->flags & ~(uint32_t)ALL_FLAGS)
		return refuse(SCREE_ERROR_INVALID, at, ".flags", "is 0x%x, has bits beyond SCREE_DRAW_*", def->flags);
	TRY(check_real(at, ".impulse_scale", def->impulse_scale, 0.0f, MOST_SCALE));
	TRY(check_real(at, ".speed_scale", def->speed_scale, 0.0f, MOST_SCALE));
	return check_real(at, ".length", def->length, 0.0f, SCREE_MAX_COORDINATE);
}

// Calls the functions of the program, after all that can fail. The order is that of SCREE_DRAW_*.
static void draw(const Pen* pen)
{
	if (pen_draws(pen, SCREE_DRAW_FIELDS))
		draw_fields(pen);
	if (pen_draws(pen, SCREE_DRAW_SHAPES))
		draw_collidables(pen, true);
	if (pen_draws(pen, SCREE_DRAW_SENSORS))
		draw_collidables(pen, false);
	if (pen_draws(pen, SCREE_DRAW_BOXES))
		draw_boxes(pen);
	if (pen_draws(pen, SCREE_DRAW_JOINTS))
		draw_joints(pen);
	if (pen_draws(pen, SCREE_DRAW_CONTACTS))
		draw_contacts(pen);
	if (pen_draws(pen, SCREE_DRAW_IMPULSES))
		draw_impulses(pen);
	if (pen_draws(pen, SCREE_DRAW_CENTERS | SCREE_DRAW_SPEEDS | SCREE_DRAW_LABELS))
		draw_bodies(pen);
}

scree_status api_world_draw(scree_world* world, const scree_draw_def* def, const scree_box* box)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_world_draw";
	scree_draw_def local;
	scree_box view;
	TRY(world_check(world, function));
	TRY(check_pointer(function, "def", def));
	TRY(check_definition((ArgumentPlace){function, "def", ALONE}, def, 0, &draw_definition));
	def = definition_at(def, 0, &draw_definition, &local);
	TRY(check_draw(function, def));
	TRY(draw_view(function, box, &view));
	DrawRows rows = {0};
	scree_status status = draw_rows_read(world, function, def->flags, &rows);
	if (status == SCREE_OK)
	{
		world->drawing = true;
		draw(&(Pen){.world = world, .rows = &rows, .def = def, .view = view});
		world->drawing = false;
	}
	draw_rows_release(&rows);
	return status;
}

static scree_collidable_state state_of(const scree_world* world, const DrawRows* rows, int index, scree_pose pose)
{
	const HostCollidable* host = world->host_collidables + index;
	scree_collidable_state state = {.collidable = collidable_handle(world, index),
	                                .body = owner_handle(world, index),
	                                .attribute = attribute_handle(world, host->attribute),
	                                .pose = pose,
	                                .shape = &world->attributes[host->attribute].shape,
	                                .user = host->user,
	                                .sensor = host->sensor,
	                                .type = SCREE_BODY_STATIC};
	if (host->body < 0)
		return state;
	state.type = world->host_bodies[host->body].type;
	state.asleep = rows->asleep && rows->asleep[host->body];
	state.disabled = world->host_bodies[host->body].disabled;
	return state;
}

// Lists the collidables whose bounding boxes overlap a view. Returns their number.
static int list_states(const scree_world* world, const DrawRows* rows, const scree_box* view,
                       scree_collidable_state* states, size_t size, int capacity)
{
	int listed = 0;
	for (int k = 0; k < world->collidables.used; ++k)
	{
		scree_vec vertices[SCREE_MAX_VERTICES];
		if (!slots_in_use(&world->collidables, k))
			continue;
		const scree_shape* shape = &world->attributes[world->host_collidables[k].attribute].shape;
		scree_pose pose = draw_place(world, rows, k);
		if (!draw_is_near(shape, pose.position, view))
			continue;
		scree_box around = draw_outline(shape, pose, vertices);
		if (!draw_overlaps(&around, view))
			continue;
		if (listed < capacity)
		{
			scree_collidable_state state = state_of(world, rows, k, pose);
			write_result((char*)states + size * (size_t)listed, size, &state, sizeof state);
		}
		++listed;
	}
	return listed;
}

scree_status api_world_get_collidable_states_sized(scree_world* world, const scree_box* box,
                                                   scree_collidable_state* states, size_t size, int capacity,
                                                   int* count)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_world_get_collidable_states";
	scree_box view;
	TRY(world_check(world, function));
	TRY(check_list(function, "states", states, capacity, count));
	TRY(draw_view(function, box, &view));
	DrawRows rows = {0};
	scree_status status = draw_rows_read(world, function, SCREE_DRAW_SHAPES, &rows);
	if (status == SCREE_OK)
		*count = list_states(world, &rows, &view, states, size, capacity);
	draw_rows_release(&rows);
	return status;
}
