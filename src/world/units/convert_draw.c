// SPDX-License-Identifier: MIT
// convert_draw.c -- converts debug draw and the shapes of listed collidables to a world's unit of length.
#include "world/units/convert_draw.h"
#include "platform/error.h"
#include "world/memory.h"
#include "world/units/scale.h"
#include "world/world.h"
#include <stddef.h>
#include <string.h>

static float length_of(const UnitPen* pen, float x)
{
	units_scale(pen->unit, (char*)&x, 1, 1, TO_UNITS);
	return x;
}

static scree_vec point_of(const UnitPen* pen, scree_vec v)
{
	units_scale(pen->unit, (char*)&v, 2, 1, TO_UNITS);
	return v;
}

static void polygon(const scree_vec* vertices, int count, float radius, uint32_t color, void* context)
{
	const UnitPen* pen = context;
	scree_vec points[SCREE_MAX_VERTICES];
	for (int k = 0; k < count; ++k)
		points[k] = point_of(pen, vertices[k]);
	pen->given.polygon(points, count, length_of(pen, radius), color, pen->given.context);
}

static void circle(scree_vec center, float radius, uint32_t color, void* context)
{
	const UnitPen* pen = context;
	pen->given.circle(point_of(pen, center), length_of(pen, radius), color, pen->given.context);
}

static void capsule(scree_vec a, scree_vec b, float radius, uint32_t color, void* context)
{
	const UnitPen* pen = context;
	pen->given.capsule(point_of(pen, a), point_of(pen, b), length_of(pen, radius), color, pen->given.context);
}

static void line(scree_vec a, scree_vec b, uint32_t color, void* context)
{
	const UnitPen* pen = context;
	pen->given.line(point_of(pen, a), point_of(pen, b), color, pen->given.context);
}

static void point(scree_vec at, float pixels, uint32_t color, void* context)
{
	const UnitPen* pen = context;
	pen->given.point(point_of(pen, at), pixels, color, pen->given.context);
}

static void text(scree_vec at, const char* words, uint32_t color, void* context)
{
	const UnitPen* pen = context;
	pen->given.text(point_of(pen, at), words, color, pen->given.context);
}

void units_draw(UnitPen* pen, scree_draw_def* def, double unit)
{
	pen->given = *def;
	pen->unit = unit;
	def->context = pen;
#define REPLACE(name) def->name = def->name ? name : NULL
	REPLACE(polygon);
	REPLACE(circle);
	REPLACE(capsule);
	REPLACE(line);
	REPLACE(point);
	REPLACE(text);
#undef REPLACE
}

// Returns the shape of an attribute in the unit, or null if memory is missing.
static const scree_shape* shape_of(scree_world* world, int attribute)
{
	UnitShapes* made = &world->unit_shapes;
	if (GROW("scree_world_get_collidable_states", made->shapes, made->capacity, attribute + 1) != SCREE_OK)
		return NULL;
	scree_shape** shape = made->shapes + attribute;
	if (!*shape)
		*shape = scree_allocate(sizeof **shape);
	if (*shape)
	{
		**shape = world->attributes[attribute].shape;
		units_scale_item((double)world->def.length_unit, UNIT_scree_shape, *shape, sizeof **shape, TO_UNITS);
	}
	return *shape;
}

scree_status units_shapes(scree_world* world, scree_collidable_state* states, size_t size, int count)
{
	const size_t place = offsetof(scree_collidable_state, shape);
	char* row = (char*)states;
	for (int k = 0; k < count && size >= place + sizeof(scree_shape*); ++k, row += size)
	{
		scree_attribute attribute;
		memcpy(&attribute, row + offsetof(scree_collidable_state, attribute), sizeof attribute);
		const scree_shape* shape = shape_of(world, (int)attribute.index);
		if (!shape)
			return fail(SCREE_ERROR_OUT_OF_MEMORY, "scree_world_get_collidable_states: no memory for shapes");
		memcpy(row + place, &shape, sizeof shape);
	}
	return SCREE_OK;
}
