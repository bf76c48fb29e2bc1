// SPDX-License-Identifier: MIT
// path.c -- creates, destroys and lists paths, and reads their geometry.
#include "platform/processor.h"
#include "world/definition.h"
#include "world/failure.h"
#include "world/objects/handles.h"
#include "world/objects/path_samples.h"
#include "world/objects/paths.h"
#include "world/record/api_calls.h"
#include "world/structure.h"
#include <math.h>
#include <stdio.h>

#define LEAST_APART 1e-4f // m: minimum distance of neighboring points; rounding errors would distort shorter segments

void scree_path_def_default_sized(scree_path_def* def, size_t size)
{
	const scree_path_def made = {.size = (uint32_t)size};
	write_result(def, size, &made, sizeof made);
}

static scree_status check_points(ArgumentPlace at, const scree_path_def* def)
{
	int least = def->closed ? 3 : 2;
	char member[32];
	if (!def->points)
		return refuse(SCREE_ERROR_INVALID, at, ".points", "is null");
	if (def->count < least || def->count > MOST_PATH_POINTS)
		return refuse(SCREE_ERROR_INVALID, at, ".count", "is %d, must be from %d to %d for %s path", def->count, least,
		              MOST_PATH_POINTS, def->closed ? "a closed" : "an open");
	for (int k = 0; k < def->count; ++k)
	{
		snprintf(member, sizeof member, ".points[%d]", k);
		TRY(check_vec(at, member, def->points[k], SCREE_MAX_COORDINATE));
		if (k == 0 && !def->closed)
			continue;
		scree_vec a = def->points[k > 0 ? k - 1 : def->count - 1], b = def->points[k];
		float x = b.x - a.x, y = b.y - a.y, apart = sqrtf(x * x + y * y);
		if (k > 0 && !(apart >= LEAST_APART))
			return refuse(SCREE_ERROR_INVALID, at, member, "is %s m from the one before it, must be at least %s",
			              decimal(apart).text, decimal(LEAST_APART).text);
	}
	scree_vec first = def->points[0], last = def->points[def->count - 1];
	float x = last.x - first.x, y = last.y - first.y, apart = sqrtf(x * x + y * y);
	if (def->closed && !(apart >= LEAST_APART))
		return refuse(SCREE_ERROR_INVALID, at, member, "is %s m from the first one, must be at least %s if closed",
		              decimal(apart).text, decimal(LEAST_APART).text);
	return SCREE_OK;
}

scree_status api_path_create(scree_world* world, const scree_path_def* def, scree_path* path)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_path_create";
	ArgumentPlace at = {function, "def", ALONE};
	scree_path_def local;
	int index;
	TRY(world_check(world, function));
	TRY(check_pointer(function, "def", def));
	TRY(check_definition(at, def, 0, &path_definition));
	def = definition_at(def, 0, &path_definition, &local);
	TRY(check_points(at, def));
	TRY(path_put(world, function, def, &index));
	if (path)
		*path = path_handle(world, index);
	return SCREE_OK;
}

scree_status api_path_destroy(scree_world* world, scree_path path)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_path_destroy";
	ArgumentPlace at = {function, "path", ALONE};
	int index = 0;
	TRY(world_check(world, function));
	TRY(check_path(world, at, "", path, &index));
	int uses = world->host_paths[index].uses;
	if (uses > 0)
		return refuse(SCREE_ERROR_INVALID, at, "", "is that of %d joint%s: destroy %s first", uses, uses > 1 ? "s" : "",
		              uses > 1 ? "them" : "it");
	path_remove(world, index);
	structure_changed(world); // no edit waits for the upload
	return SCREE_OK;
}

bool scree_path_is_valid(const scree_world* world, scree_path path) { return world && path_is_valid(world, path); }

bool scree_path_is_closed(const scree_world* world, scree_path path)
{
	return scree_path_is_valid(world, path) && path_curve_of(world, (int)path.index - 1).closed;
}

static scree_status lookup(const scree_world* world, const char* function, scree_path path, int* index)
{
	TRY(check_pointer(function, "world", world));
	return check_path(world, (ArgumentPlace){function, "path", ALONE}, "", path, index);
}

scree_status api_path_get_length(const scree_world* world, scree_path path, float* length)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_path_get_length";
	int index = 0;
	TRY(lookup(world, function, path, &index));
	TRY(check_pointer(function, "length", length));
	*length = path_curve_of(world, index).length;
	return SCREE_OK;
}

scree_status api_path_get_pose(const scree_world* world, scree_path path, float along, scree_pose* pose)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_path_get_pose";
	int index = 0;
	TRY(lookup(world, function, path, &index));
	TRY(check_real((ArgumentPlace){function, "along", ALONE}, "", along, -FLT_MAX, FLT_MAX));
	TRY(check_pointer(function, "pose", pose));
	*pose = path_pose_at(world, index, along);
	return SCREE_OK;
}

scree_status api_path_get_nearest(const scree_world* world, scree_path path, scree_vec point, float* along)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_path_get_nearest";
	int index = 0;
	float laps = 0.0f;
	TRY(lookup(world, function, path, &index));
	TRY(check_vec((ArgumentPlace){function, "point", ALONE}, "", point, SCREE_MAX_COORDINATE));
	TRY(check_pointer(function, "along", along));
	PathCurve curve = path_curve_of(world, index);
	Vec at = {point.x, point.y};
	PathFoot foot = path_foot(&curve, path_descend(&curve, at, path_nearest(&curve, at), &laps), at);
	*along = foot.along < curve.length ? foot.along : curve.length;
	return SCREE_OK;
}

scree_status api_path_get_points(const scree_world* world, scree_path path, scree_vec* points, int capacity, int* count)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_path_get_points";
	int index = 0;
	TRY(lookup(world, function, path, &index));
	TRY(check_list(function, "points", points, capacity, count));
	const HostPath* host = world->host_paths + index;
	*count = host->segments / PATH_SHARES + !path_curve_of(world, index).closed;
	for (int k = 0; k < *count && k < capacity; ++k)
		points[k] = (scree_vec){host->samples[PATH_SHARES * k].x, host->samples[PATH_SHARES * k].y};
	return SCREE_OK;
}

scree_status api_path_get_user(const scree_world* world, scree_path path, uint64_t* user)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_path_get_user";
	int index = 0;
	TRY(lookup(world, function, path, &index));
	TRY(check_pointer(function, "user", user));
	*user = world->host_paths[index].user;
	return SCREE_OK;
}

scree_status api_path_set_user(scree_world* world, scree_path path, uint64_t user)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_path_set_user";
	int index = 0;
	TRY(world_check(world, function));
	TRY(lookup(world, function, path, &index));
	world->host_paths[index].user = user;
	structure_changed(world);
	return SCREE_OK;
}

scree_status api_world_get_paths(const scree_world* world, scree_path* paths, int capacity, int* count)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_world_get_paths";
	int listed = 0;
	TRY(check_pointer(function, "world", world));
	TRY(check_list(function, "paths", paths, capacity, count));
	for (int k = 0; k < world->paths.used; ++k)
	{
		if (!slots_in_use(&world->paths, k))
			continue;
		if (listed < capacity)
			paths[listed] = path_handle(world, k);
		++listed;
	}
	*count = listed;
	return SCREE_OK;
}
