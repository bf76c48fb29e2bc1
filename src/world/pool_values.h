// SPDX-License-Identifier: MIT
// pool_values.h -- converts values of the interface to values of the pools.
#ifndef POOL_VALUES_H
#define POOL_VALUES_H
#include "pools/pools.h"
#include "world/world.h"
#include <string.h>

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
	return make_float4(pose.position.x, pose.position.y, pose.rotation.c, pose.rotation.s);
}

#endif
