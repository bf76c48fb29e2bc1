// SPDX-License-Identifier: MIT
// draw_shapes.c -- draws fields, collidables and their enlarged boxes.
#include "api/draw/draw_shapes.h"
#include "world/pool_read.h"
#include "world/shape/geometry.h"
#include <math.h>

// Returns the vector that shows the effect of a field, in its frame: an acceleration or a force, or else the velocity of
// its medium; 0 for attraction and vortices.
static scree_vec effect_of(const scree_field_def* def)
{
	bool pushes = def->acceleration.x != 0.0f || def->acceleration.y != 0.0f;
	switch (def->type)
	{
	case SCREE_FIELD_UNIFORM:
		return pushes ? def->acceleration : def->force;
	case SCREE_FIELD_RADIAL:
	case SCREE_FIELD_VORTEX:
		return (scree_vec){0.0f, 0.0f};
	case SCREE_FIELD_DRAG:
	case SCREE_FIELD_WIND:
	case SCREE_FIELD_BUOYANCY:
		break;
	}
	return def->velocity;
}

// Draws the region of a field, its origin, and the direction of its effect.
static void draw_field(const Pen* pen, const HostField* host)
{
	const scree_field_def* def = &host->def;
	scree_pose pose = def->pose;
	bool disabled = def->disabled || (host->body >= 0 && pen->world->host_bodies[host->body].disabled);
	uint32_t color = disabled ? SCREE_COLOR_DISABLED : SCREE_COLOR_FIELD;
	if (host->body >= 0)
		pose = pose_product(world_body_pose(pen->world, host->body, pen->rows->poses + host->body), pose);
	if (def->shape.count > 0)
		pen_shape(pen, &def->shape, pose, color);
	pen_point(pen, pose.position, LARGE_POINT, opaque(color));
	scree_vec effect = rot_vec(pose.rotation, effect_of(def));
	double size = sqrt((double)effect.x * effect.x + (double)effect.y * effect.y);
	if (size > 0.0)
	{
		scree_vec direction = {(float)(effect.x / size), (float)(effect.y / size)};
		pen_ray(pen, pose.position, direction, pen->def->length, opaque(color));
	}
}

void draw_fields(const Pen* pen)
{
	const Fields* fields = &pen->world->fields;
	for (int k = 0; k < fields->slots.used; ++k)
		if (slots_in_use(&fields->slots, k))
			draw_field(pen, fields->host + k);
}

static uint32_t color_of(const Pen* pen, int collidable)
{
	const HostCollidable* host = pen->world->host_collidables + collidable;
	if (draw_is_disabled(pen->world, collidable))
		return SCREE_COLOR_DISABLED;
	if (host->sensor || host->body < 0)
		return SCREE_COLOR_SENSOR;
	// a collidable that was made after the step may have the body of a slot that was free
	if (host->body == pen->rows->frozen && host->made < pen->world->pipeline.steps)
		return SCREE_COLOR_FROZEN;
	switch (pen->world->host_bodies[host->body].type)
	{
	case SCREE_BODY_STATIC:
		return SCREE_COLOR_STATIC;
	case SCREE_BODY_KINEMATIC:
		return SCREE_COLOR_KINEMATIC;
	case SCREE_BODY_DYNAMIC:
		break;
	}
	return pen->rows->asleep && pen->rows->asleep[host->body] ? SCREE_COLOR_ASLEEP : SCREE_COLOR_DYNAMIC;
}

void draw_collidables(const Pen* pen, bool solid)
{
	const scree_world* world = pen->world;
	for (int k = 0; k < world->collidables.used; ++k)
	{
		const HostCollidable* host = world->host_collidables + k;
		if (slots_in_use(&world->collidables, k) && (host->body >= 0 && host->sensor == 0) == solid)
			pen_shape(pen, &world->attributes[host->attribute].shape, draw_place(world, pen->rows, k),
			          color_of(pen, k));
	}
}

void draw_boxes(const Pen* pen)
{
	const scree_world* world = pen->world;
	for (int k = 0; k < world->collidables.used; ++k)
	{
		// a step writes the box of each collidable that it finds
		if (!slots_in_use(&world->collidables, k) || draw_is_disabled(world, k) ||
		    world->host_collidables[k].born >= world->pipeline.steps)
			continue;
		Float4 b = pen->rows->boxes[k];
		scree_box box = {{b.x, b.y}, {b.z, b.w}};
		scree_vec corners[4] = {{b.x, b.y}, {b.z, b.y}, {b.z, b.w}, {b.x, b.w}};
		for (int side = 0; side < 4 && draw_overlaps(&box, &pen->view); ++side)
			pen_line(pen, corners[side], corners[(side + 1) % 4], SCREE_COLOR_BOX);
	}
}
