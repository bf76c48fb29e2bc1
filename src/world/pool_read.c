// SPDX-License-Identifier: MIT
// pool_read.c -- reads pools from the device.
#include "world/pool_read.h"
#include "step/state_readback.h"
#include "world/device/auto.h"
#include "world/failure.h"
#include "world/pool_values.h"
#include "world/shape/geometry.h"
#include "world/world.h"

scree_status world_read(scree_world* world, PoolId pool, int first, int count, void* items)
{
	Backend* b = world->backend;
	double begin = auto_clock();
	scree_status status = b->f->read(b, pool, first, count, items);
	auto_count(world, begin);
	return world_note(world, status);
}

scree_status world_read_sleep(scree_world* world, int first, int count, int* asleep)
{
	TRY(world_note(world, pipeline_report_sleep(&world->pipeline, first, count)));
	return world_read(world, POOL_island, first, count, asleep);
}

scree_pose world_body_pose(const scree_world* world, int index, const Float4* row)
{
	scree_rot rotation = {row->z, row->w};
	scree_vec center = world->host_bodies[index].mass.center;
	// as in the pool local_center, so that outputs of batches are the same
	scree_vec shift = rot_vec(rotation, (scree_vec){flush_tiny(center.x), flush_tiny(center.y)});
	return (scree_pose){{row->x - shift.x, row->y - shift.y}, rotation};
}
