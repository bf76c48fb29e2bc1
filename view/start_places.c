// SPDX-License-Identifier: MIT
// start_places.c -- stores the starting places of bodies, for the paint that colors bodies by starting place.
#include "view/start_places.h"
#include "scene/viewport.h"
#include <stdlib.h>
#include <string.h>

bool starts_misses(const Starts* starts, scree_body body)
{
	return (int)body.index >= starts->capacity || starts->generations[body.index] != body.generation;
}

static bool grow(Starts* starts, int capacity)
{
	scree_vec* places = realloc(starts->places, (size_t)capacity * sizeof *places);
	starts->places = places ? places : starts->places;
	uint32_t* generations = realloc(starts->generations, (size_t)capacity * sizeof *generations);
	starts->generations = generations ? generations : starts->generations;
	if (!places || !generations)
		return false;
	memset(generations + starts->capacity, 0, (size_t)(capacity - starts->capacity) * sizeof *generations);
	starts->capacity = capacity;
	return true;
}

bool starts_add(Starts* starts, const scree_body* bodies, const scree_pose* poses, int count)
{
	int needed = starts->capacity;
	for (int k = 0; k < count; ++k)
		needed = (int)bodies[k].index >= needed ? (int)bodies[k].index + 1 : needed;
	if (needed > starts->capacity && !grow(starts, needed))
		return false;
	for (int k = 0; k < count; ++k)
	{
		if (!starts_misses(starts, bodies[k]))
			continue;
		starts->places[bodies[k].index] = poses[k].position;
		starts->generations[bodies[k].index] = bodies[k].generation;
	}
	return true;
}

bool starts_frame(Starts* starts, const scree_vec* points, int count)
{
	return viewport_fit(points, count, 0.0f, &starts->box);
}

static float share_of(float x, float low, float high)
{
	float t = high > low ? (x - low) / (high - low) : 0.5f;
	return t < 0.0f ? 0.0f : t > 1.0f ? 1.0f : t;
}

scree_vec starts_share(const Starts* starts, scree_body body)
{
	if (starts_misses(starts, body))
		return (scree_vec){0.5f, 0.5f};
	scree_vec at = starts->places[body.index];
	const scree_box* box = &starts->box;
	return (scree_vec){share_of(at.x, box->lower.x, box->upper.x), share_of(at.y, box->lower.y, box->upper.y)};
}

void starts_close(Starts* starts)
{
	free(starts->places);
	free(starts->generations);
	*starts = (Starts){0};
}
