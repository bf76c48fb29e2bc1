// SPDX-License-Identifier: MIT
// body_read.c -- reads poses, velocities and definitions of bodies, and velocities of their points, from the device.
#include "platform/processor.h"
#include "world/definition.h"
#include "world/failure.h"
#include "world/memory.h"
#include "world/objects/handles.h"
#include "world/pool_read.h"
#include "world/record/api_calls.h"
#include "world/shape/geometry.h"
#include "world/upload/readers.h"
#include "world/upload/upload.h"
#include "world/world.h"

// Mean distance between the slots of a batch, in rows, up to which one read of the whole range is faster than one read
// for each body. On a GPU, a read takes as long as the transfer of 100 kB.
#define SPARSE_ROWS 1024

typedef struct // rows of one pool, read for a batch of bodies
{
	const char* rows;
	size_t bytes; // bytes of a row
	int first;    // index of the body of the first row; -1: row k belongs to bodies[k]
} Rows;

static const void* row_of(const Rows* rows, const scree_body* bodies, int k)
{
	int row = rows->first < 0 ? k : (int)bodies[k].index - rows->first;
	return rows->rows + (size_t)row * rows->bytes;
}

static scree_status read_rows(scree_world* world, const char* function, const char* argument, PoolId pool,
                              const scree_body* bodies, int count, bool alone, Rows* rows)
{
	int low = 0, high = 0;
	for (int k = 0; k < count; ++k)
	{
		int index = 0;
		TRY(check_body(world, (ArgumentPlace){function, argument, alone ? ALONE : k}, "", bodies[k], &index));
		low = k == 0 || index < low ? index : low;
		high = index > high ? index : high;
	}
	TRY(readers_upload(world));
	const char* pool_rows = pool_item_address(world->backend, pool, 0);
	if (pool_rows) // without a copy, for which several threads would need memory of their own
	{
		*rows = (Rows){.rows = pool_rows, .bytes = pool_info[pool].bytes};
		return SCREE_OK;
	}
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
		poses[k] = world_body_pose(world, (int)bodies[k].index, row_of(&rows, bodies, k));
	return SCREE_OK;
}

static scree_velocity velocity_of(const StoredVelocity* row) { return (scree_velocity){{row->vx, row->vy}, row->w}; }

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
	bool disabled = false;
	for (int k = 0; k < count; ++k)
		disabled |= world->host_bodies[bodies[k].index].disabled;
	if (!disabled)
		return SCREE_OK;
	TRY(read_rows(world, function, argument, POOL_stored_velocity, bodies, count, alone, &rows));
	for (int k = 0; k < count; ++k)
		if (world->host_bodies[bodies[k].index].disabled)
			velocities[k] = velocity_of(row_of(&rows, bodies, k));
	return SCREE_OK;
}

static scree_status check_read(const scree_world* world, const char* function, const scree_body* bodies,
                               const char* argument, const void* out, int count)
{
	TRY(world_check(world, function));
	TRY(check_batch(function, "bodies", bodies, count));
	return check_batch(function, argument, out, count);
}

scree_status api_bodies_get_poses(scree_world* world, const scree_body* bodies, scree_pose* poses, int count)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_bodies_get_poses";
	TRY(check_read(world, function, bodies, "poses", poses, count));
	return count > 0 ? get_poses(world, function, "bodies", bodies, poses, count, false) : SCREE_OK;
}

scree_status api_bodies_get_velocities(scree_world* world, const scree_body* bodies, scree_velocity* velocities,
                                       int count)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_bodies_get_velocities";
	TRY(check_read(world, function, bodies, "velocities", velocities, count));
	return count > 0 ? get_velocities(world, function, "bodies", bodies, velocities, count, false) : SCREE_OK;
}

scree_status api_body_get_pose(scree_world* world, scree_body body, scree_pose* pose)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_body_get_pose";
	TRY(check_read(world, function, &body, "pose", pose, 1));
	return get_poses(world, function, "body", &body, pose, 1, true);
}

scree_status api_body_get_velocity(scree_world* world, scree_body body, scree_velocity* velocity)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_body_get_velocity";
	TRY(check_read(world, function, &body, "velocity", velocity, 1));
	return get_velocities(world, function, "body", &body, velocity, 1, true);
}

scree_status api_body_get_def_sized(scree_world* world, scree_body body, scree_body_def* def, size_t size)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_body_get_def";
	scree_body_def now = scree_body_def_default();
	TRY(check_read(world, function, &body, "def", def, 1));
	TRY(get_poses(world, function, "body", &body, &now.pose, 1, true));
	TRY(get_velocities(world, function, "body", &body, &now.velocity, 1, true));
	int asleep = 0;
	TRY(world_read_sleep(world, (int)body.index, 1, &asleep));
	const HostBody* host = world->host_bodies + body.index;
	now.asleep = asleep;
	now.size = (uint32_t)size;
	now.type = host->type;
#define X(name, least, most, value) now.name = host->values.name;
#define KEPT(type, name)            now.name = host->name;
#include "pools/body_values.def"
	write_result(def, size, &now, sizeof now);
	return SCREE_OK;
}

scree_status api_world_get_states(scree_world* world, scree_body* bodies, scree_body_state* states, int capacity,
                                  int* count)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_world_get_states";
	TRY(world_check(world, function));
	TRY(check_list(function, "states", states, capacity, count));
	TRY(world_upload(world));
	int used = world->bodies.used, listed = 0;
	size_t bytes = (size_t)used * (sizeof(Float4) + sizeof(StoredVelocity) + sizeof(BodyState) + sizeof(int));
	Float4* poses = world_scratch(world, bytes);
	if (!poses)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for %zu bytes from the device", function, bytes);
	StoredVelocity* stored = (StoredVelocity*)(poses + used);
	BodyState* rows = (BodyState*)(stored + used);
	int* asleep = (int*)(rows + used);
	if (capacity > 0)
	{
		TRY(world_read(world, POOL_pose, 0, used, poses));
		TRY(world_read(world, POOL_body, 0, used, rows));
		if (world->disabled_bodies > 0)
			TRY(world_read(world, POOL_stored_velocity, 0, used, stored));
		if (world->def.sleep)
			TRY(world_read_sleep(world, 0, used, asleep));
	}
	for (int k = 0; k < used && listed < capacity; ++k)
	{
		if (!slots_in_use(&world->bodies, k))
			continue;
		states[listed].pose = world_body_pose(world, k, poses + k);
		states[listed].velocity = (scree_velocity){{rows[k].vx, rows[k].vy}, rows[k].w};
		if (world->host_bodies[k].disabled)
			states[listed].velocity = velocity_of(stored + k);
		states[listed].asleep = world->def.sleep && asleep[k];
		if (bodies)
			bodies[listed] = body_handle(world, k);
		++listed;
	}
	*count = world->bodies.alive;
	return SCREE_OK;
}

static scree_status point_pose(scree_world* world, const char* function, scree_body body, const char* argument,
                               scree_vec point, const char* result, const void* out, scree_pose* pose)
{
	TRY(check_read(world, function, &body, result, out, 1));
	TRY(check_vec((ArgumentPlace){function, argument, ALONE}, "", point, SCREE_MAX_COORDINATE));
	return get_poses(world, function, "body", &body, pose, 1, true);
}

scree_status api_body_get_world_point(scree_world* world, scree_body body, scree_vec local, scree_vec* point)
{
	FLOAT_MODE_HERE;
	scree_pose pose;
	TRY(point_pose(world, "scree_body_get_world_point", body, "local", local, "point", point, &pose));
	*point = pose_point(pose, local);
	return SCREE_OK;
}

scree_status api_body_get_local_point(scree_world* world, scree_body body, scree_vec point, scree_vec* local)
{
	FLOAT_MODE_HERE;
	scree_pose pose;
	TRY(point_pose(world, "scree_body_get_local_point", body, "point", point, "local", local, &pose));
	scree_vec from = {point.x - pose.position.x, point.y - pose.position.y};
	*local = rot_vec((scree_rot){pose.rotation.c, -pose.rotation.s}, from);
	return SCREE_OK;
}

scree_status api_body_get_point_velocity(scree_world* world, scree_body body, scree_vec point, scree_vec* velocity)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_body_get_point_velocity";
	scree_pose pose;
	scree_velocity v;
	TRY(point_pose(world, function, body, "point", point, "velocity", velocity, &pose));
	TRY(get_velocities(world, function, "body", &body, &v, 1, true));
	scree_vec center = pose_point(pose, world->host_bodies[body.index].mass.center);
	*velocity =
	    (scree_vec){v.linear.x - v.angular * (point.y - center.y), v.linear.y + v.angular * (point.x - center.x)};
	return SCREE_OK;
}
