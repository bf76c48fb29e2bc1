// SPDX-License-Identifier: MIT
// pool_values.h -- converts values of the interface to values of the pools.
#ifndef POOL_VALUES_H
#define POOL_VALUES_H
#include "dialect/finite.h"
#include "pools/pools.h"
#include "world/world.h"
#include <string.h>

// Copies a row of floats of the user, of which tiny ones become 0 (finite.h).
static inline void flush_copy(float* to, const float* from, int count)
{
	for (int k = 0; k < count; ++k)
		to[k] = flush_tiny(from[k]);
}

// Likewise in place.
static inline void flush_row(float* row, int count) { flush_copy(row, row, count); }

// Likewise for all floats of a struct from one member to another, of which both are included.
#define FLUSH_MEMBERS(item, first, last) flush_row(&(item)->first, (int)(&(item)->last - &(item)->first) + 1)

// Returns the word Filter.reports of a collidable, with its REPORT_* and SENSOR_* bits.
static inline uint32_t report_bits(const HostCollidable* host) { return host->reports | host->sensor << SENSOR_SHIFT; }

static inline Filter filter_row(scree_filter filter, uint32_t reports)
{
	return (Filter){.category = filter.category, .mask = filter.mask, .group = filter.group, .reports = reports};
}

static inline void shape_row(const scree_shape* shape, Attribute* row)
{
	row->count = shape->count;
	row->radius = shape->radius;
	for (int k = 0; k < shape->count; ++k)
	{
		row->vertices[k] = make_float2(shape->vertices[k].x, shape->vertices[k].y);
		row->normals[k] = make_float2(shape->normals[k].x, shape->normals[k].y);
		flush_row(&row->vertices[k].x, 2);
		flush_row(&row->normals[k].x, 2);
	}
}

_Static_assert(sizeof(Motion) == 8 * sizeof(float), "kernels read a Motion as eight numbers (registers.cl, tiles.cl)");

// Returns Command.value for COMMAND_MOTION.
static inline Float4 body_values_row(const BodyValues* values)
{
	_Static_assert(sizeof *values <= sizeof(Float4), "a command has four numbers");
	Float4 row = {0};
	memcpy(&row, values, sizeof *values);
	return row;
}

static inline Float4 pose_row(scree_pose pose)
{
	return make_float4(flush_tiny(pose.position.x), flush_tiny(pose.position.y), flush_tiny(pose.rotation.c),
	                   flush_tiny(pose.rotation.s));
}

#endif
