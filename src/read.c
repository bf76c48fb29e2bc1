// SPDX-License-Identifier: MIT
// read.c -- poses and velocities of bodies, back from the device.
#include "geometry.h"
#include "world.h"

// Where the bodies of a batch lie closer together than this, one read of all rows between them is cheaper than one a
// body: on a GPU a read costs about as much as the transfer of 100 kB.
#define SPARSE_ROWS 1024

typedef struct // rows of one pool, read for a batch
{
	const char* rows;
	size_t bytes; // of a row
	int first;    // body of the first row; -1 when row k is that of bodies[k]
} Rows;

static const void* row_of(const Rows* rows, const scree_body* bodies, int k)
{
	int row = rows->first < 0 ? k : (int)bodies[k].index - rows->first;
	return rows->rows + (size_t)row * rows->bytes;
}

// Checks, sends what is pending, and reads a pool's rows of all bodies of a batch.
static scree_status read_rows(scree_world* world, const char* function, const char* argument, PoolId pool,
                              const scree_body* bodies, int count, bool alone, Rows* rows)
{
	int low = 0, high = 0;
	for (int k = 0; k < count; ++k)
	{
		int index = 0;
		TRY(check_body(world, (Where){function, argument, alone ? ALONE : k}, "", bodies[k], &index));
		low = k == 0 || index < low ? index : low;
		high = index > high ? index : high;
	}
	TRY(world_flush(world));

	bool dense = (int64_t)high - low < (int64_t)SPARSE_ROWS * count;
	*rows = (Rows){.bytes = pool_info[pool].bytes, .first = dense ? low : -1};
	size_t bytes = rows->bytes * (size_t)(dense ? high - low + 1 : count);
	char* memory = world_scratch(world, bytes);
	if (!memory)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for %zu bytes from the device", function, bytes);
	rows->rows = memory;
	if (dense)
		return world_read(world, pool, low, high - low + 1, memory);
	for (int k = 0; k < count; ++k)
		TRY(world_read(world, pool, (int)bodies[k].index, 1, memory + (size_t)k * rows->bytes));
	return SCREE_OK;
}

static scree_status get_poses(scree_world* world, const char* function, const char* argument, const scree_body* bodies,
                              scree_pose* poses, int count, bool alone)
{
	Rows rows;
	TRY(read_rows(world, function, argument, POOL_pose, bodies, count, alone, &rows));
	for (int k = 0; k < count; ++k)
	{
		const Float4* row = row_of(&rows, bodies, k);
		scree_vec center = world->host_bodies[bodies[k].index].mass.center;
		scree_pose arm = {{0.0f, 0.0f}, {row->z, row->w}};
		scree_vec shift = pose_point(arm, center);
		poses[k] = (scree_pose){{row->x - shift.x, row->y - shift.y}, arm.rotation};
	}
	return SCREE_OK;
}

static scree_status get_velocities(scree_world* world, const char* function, const char* argument,
                                   const scree_body* bodies, scree_velocity* velocities, int count, bool alone)
{
	Rows rows;
	TRY(read_rows(world, function, argument, POOL_body, bodies, count, alone, &rows));
	for (int k = 0; k < count; ++k)
	{
		const BodyState* row = row_of(&rows, bodies, k);
		velocities[k] = (scree_velocity){{row->vx, row->vy}, row->w};
	}
	return SCREE_OK;
}

static scree_status check_read(const scree_world* world, const char* function, const scree_body* bodies,
                               const char* argument, const void* out, int count)
{
	TRY(world_check(world, function));
	TRY(check_batch(function, "bodies", bodies, count));
	return check_batch(function, argument, out, count);
}

scree_status scree_bodies_get_poses(scree_world* world, const scree_body* bodies, scree_pose* poses, int count)
{
	const char* function = "scree_bodies_get_poses";
	TRY(check_read(world, function, bodies, "poses", poses, count));
	return count > 0 ? get_poses(world, function, "bodies", bodies, poses, count, false) : SCREE_OK;
}

scree_status scree_bodies_get_velocities(scree_world* world, const scree_body* bodies, scree_velocity* velocities,
                                         int count)
{
	const char* function = "scree_bodies_get_velocities";
	TRY(check_read(world, function, bodies, "velocities", velocities, count));
	return count > 0 ? get_velocities(world, function, "bodies", bodies, velocities, count, false) : SCREE_OK;
}

scree_status scree_body_get_pose(scree_world* world, scree_body body, scree_pose* pose)
{
	const char* function = "scree_body_get_pose";
	TRY(check_read(world, function, &body, "pose", pose, 1));
	return get_poses(world, function, "body", &body, pose, 1, true);
}

scree_status scree_body_get_velocity(scree_world* world, scree_body body, scree_velocity* velocity)
{
	const char* function = "scree_body_get_velocity";
	TRY(check_read(world, function, &body, "velocity", velocity, 1));
	return get_velocities(world, function, "body", &body, velocity, 1, true);
}
