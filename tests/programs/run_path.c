// SPDX-License-Identifier: MIT
// run_path.c -- makes the calls of paths, and reads the state of paths.
#include "programs/run_call.h"
#include <string.h>

#define MOST_POINTS 300

scree_path call_path(const CallRun* r)
{
	int k = call_whole(r, "path");
	return k >= 0 && k < MOST_NAMES ? r->names->paths[k] : SCREE_NULL_PATH;
}

// Creates a path through points on a ring or a line. Each point is shifted at random by up to half of the argument
// spread.
static scree_status run_new(const CallRun* r)
{
	scree_vec points[MOST_POINTS];
	scree_path_def def = scree_path_def_default();
	scree_path made;
	uint32_t seed = (uint32_t)call_whole(r, "seed");
	float size = call_real(r, "size"), spread = call_real(r, "spread");
	scree_vec from = call_vec(r, "x", "y");
	bool ring = call_whole(r, "ring") != 0;
	def.points = points;
	def.count = call_whole(r, "points");
	def.closed = call_whole(r, "closed") != 0;
	int count = def.count < MOST_POINTS ? def.count : MOST_POINTS;
	for (int k = 0; k < count; ++k)
	{
		scree_rot q = scree_rot_make(6.28318531f * (float)k / (float)count);
		float step = size * (float)k / (float)count, shift_x = spread * (call_random_part(&seed) - 0.5f),
		      shift_y = spread * (call_random_part(&seed) - 0.5f);
		points[k] =
		    (scree_vec){from.x + (ring ? size * q.c : step) + shift_x, from.y + (ring ? size * q.s : 0.0f) + shift_y};
	}
	def.count = def.count > MOST_POINTS ? MOST_POINTS : def.count;
	scree_status status = scree_path_create(r->world, &def, &made);
	int k = call_whole(r, "path");
	if (status == SCREE_OK && k >= 0 && k < MOST_NAMES)
		r->names->paths[k] = made;
	return status;
}

scree_status run_path(const CallRun* r)
{
	return r->call->kind == CALL_path ? run_new(r) : scree_path_destroy(r->world, call_path(r));
}

scree_status clear_paths(const CallRun* r)
{
	static scree_path paths[MOST_NAMES];
	int count;
	scree_status status = scree_world_get_paths(r->world, paths, MOST_NAMES, &count);
	for (int k = 0; k < count && k < MOST_NAMES && status == SCREE_OK; ++k)
		status = scree_path_destroy(r->world, paths[k]);
	return status;
}

scree_status read_paths(const CallRun* r, uint64_t* word)
{
	static scree_path paths[MOST_NAMES];
	int count;
	scree_status status = scree_world_get_paths(r->world, paths, MOST_NAMES, &count);
	for (int k = 0; k < count && k < MOST_NAMES && status == SCREE_OK; ++k)
	{
		float length = 0.0f, along = 0.0f;
		scree_pose pose = {0};
		status = scree_path_get_length(r->world, paths[k], &length);
		if (status == SCREE_OK)
			status = scree_path_get_pose(r->world, paths[k], 0.3f * length, &pose);
		if (status == SCREE_OK)
			status = scree_path_get_nearest(r->world, paths[k], (scree_vec){1.0f, 2.0f}, &along);
		*word = hash_words(hash_words(*word, &pose, sizeof pose), &along, sizeof along);
	}
	*word = hash_words(*word, &count, sizeof count);
	return status;
}
