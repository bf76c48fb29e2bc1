// SPDX-License-Identifier: MIT
// run_path.c -- the calls of paths, and what can be read of them.
#include "programs/run_call.h"
#include <string.h>

#define MOST_POINTS 300

scree_path call_path(const Turn* t)
{
	int k = call_whole(t, "path");
	return k >= 0 && k < MOST_NAMES ? t->names->paths[k] : SCREE_NULL_PATH;
}

// a number from 0 to 1, of a seed
static float part(uint32_t* seed)
{
	*seed = *seed * 1664525u + 1013904223u; // Donald Knuth, H. W. Lewis
	return (float)(*seed >> 8) / 16777216.0f;
}

// Points on a ring or a line of a size, each shifted by up to a spread.
static scree_status run_new(const Turn* t)
{
	scree_vec points[MOST_POINTS];
	scree_path_def def = scree_path_def_default();
	scree_path made;
	uint32_t seed = (uint32_t)call_whole(t, "seed");
	float size = call_real(t, "size"), spread = call_real(t, "spread");
	scree_vec from = call_vec(t, "x", "y");
	bool ring = call_whole(t, "ring") != 0;
	def.points = points;
	def.count = call_whole(t, "points");
	def.closed = call_whole(t, "closed") != 0;
	int count = def.count < MOST_POINTS ? def.count : MOST_POINTS;
	for (int k = 0; k < count; ++k)
	{
		scree_rot q = scree_rot_make(6.28318531f * (float)k / (float)count);
		float step = size * (float)k / (float)count, shift_x = spread * (part(&seed) - 0.5f),
		      shift_y = spread * (part(&seed) - 0.5f);
		points[k] =
		    (scree_vec){from.x + (ring ? size * q.c : step) + shift_x, from.y + (ring ? size * q.s : 0.0f) + shift_y};
	}
	def.count = def.count > MOST_POINTS ? MOST_POINTS : def.count;
	scree_status status = scree_path_create(t->world, &def, &made);
	int k = call_whole(t, "path");
	if (status == SCREE_OK && k >= 0 && k < MOST_NAMES)
		t->names->paths[k] = made;
	return status;
}

scree_status run_path(const Turn* t)
{
	return t->call->kind == CALL_path ? run_new(t) : scree_path_destroy(t->world, call_path(t));
}

scree_status clear_paths(const Turn* t)
{
	static scree_path paths[MOST_NAMES];
	int count;
	scree_status status = scree_world_get_paths(t->world, paths, MOST_NAMES, &count);
	for (int k = 0; k < count && k < MOST_NAMES && status == SCREE_OK; ++k)
		status = scree_path_destroy(t->world, paths[k]);
	return status;
}

scree_status read_paths(const Turn* t, uint64_t* word)
{
	static scree_path paths[MOST_NAMES];
	int count;
	scree_status status = scree_world_get_paths(t->world, paths, MOST_NAMES, &count);
	for (int k = 0; k < count && k < MOST_NAMES && status == SCREE_OK; ++k)
	{
		float length = 0.0f, along = 0.0f;
		scree_pose pose = {0};
		status = scree_path_get_length(t->world, paths[k], &length);
		if (status == SCREE_OK)
			status = scree_path_get_pose(t->world, paths[k], 0.3f * length, &pose);
		if (status == SCREE_OK)
			status = scree_path_get_nearest(t->world, paths[k], (scree_vec){1.0f, 2.0f}, &along);
		*word = read_mixed(read_mixed(*word, &pose, sizeof pose), &along, sizeof along);
	}
	*word = read_mixed(*word, &count, sizeof count);
	return status;
}
