// SPDX-License-Identifier: MIT
// body_sleep.c -- wakes bodies, puts them to sleep, and reads whether they sleep.
#include "platform/processor.h"
#include "world/check.h"
#include "world/edits.h"
#include "world/failure.h"
#include "world/memory.h"
#include "world/objects/handles.h"
#include "world/objects/sleep.h"
#include "world/pool_read.h"
#include "world/record/api_calls.h"
#include "world/shape/geometry.h"
#include "world/structure.h"
#include "world/upload/upload.h"
#include "world/upload/whole_sleep.h"

// Records that a body wakes or falls asleep. The caller has reserved memory for a command.
static void send(scree_world* world, int index, bool awake)
{
	const HostBody* host = world->host_bodies + index;
	if (host->type != SCREE_BODY_DYNAMIC || host->disabled || !world->def.sleep)
		return;
	world->pipeline.settles |= !awake;
	edits_command(world, COMMAND_AWAKE, index, make_float4(0.0f, 0.0f, 0.0f, 0.0f), awake);
}

static scree_status set_awake(scree_world* world, const char* function, const char* argument, const scree_body* bodies,
                              const bool* awake, int count, bool alone)
{
	TRY(world_check(world, function));
	TRY(check_batch(function, argument, bodies, count));
	TRY(check_batch(function, "awake", awake, count));
	int index = 0;
	for (int k = 0; k < count; ++k)
		TRY(check_body(world, (ArgumentPlace){function, argument, alone ? ALONE : k}, "", bodies[k], &index));
	TRY(edits_reserve(world, function, 0, 0, count));
	for (int k = 0; k < count; ++k)
		send(world, (int)bodies[k].index, awake[k]);
	return SCREE_OK;
}

scree_status api_bodies_set_awake(scree_world* world, const scree_body* bodies, const bool* awake, int count)
{
	FLOAT_MODE_HERE;
	return set_awake(world, "scree_bodies_set_awake", "bodies", bodies, awake, count, false);
}

scree_status api_body_set_awake(scree_world* world, scree_body body, bool awake)
{
	FLOAT_MODE_HERE;
	return set_awake(world, "scree_body_set_awake", "body", &body, &awake, 1, true);
}

scree_status api_world_set_box_awake(scree_world* world, scree_box box, bool awake)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_world_set_box_awake";
	scree_query_results list;
	TRY(world_check(world, function));
	TRY(check_box(function, box));
	world->makes_queries = true;
	scree_status status = api_world_overlap_box_sized(world, box, &list, sizeof list);
	world->makes_queries = false;
	TRY(status);
	TRY(edits_reserve(world, function, 0, 0, list.count));
	for (int k = 0; k < list.count; ++k)
	{
		int body = world->host_collidables[list.results[k].collidable.index - 1].body;
		if (body >= 0)
			send(world, body, awake);
	}
	return SCREE_OK;
}

scree_status api_world_set_awake(scree_world* world, bool awake)
{
	FLOAT_MODE_HERE;
	TRY(world_check(world, "scree_world_set_awake"));
	return world_set_awake(world, awake);
}

static scree_status get_awake(scree_world* world, const char* function, const char* argument, const scree_body* bodies,
                              bool* awake, int count, bool alone)
{
	TRY(world_check(world, function));
	TRY(check_batch(function, argument, bodies, count));
	TRY(check_batch(function, "awake", awake, count));
	int low = MAX_ITEMS, high = -1, index = 0;
	for (int k = 0; k < count; ++k)
	{
		TRY(check_body(world, (ArgumentPlace){function, argument, alone ? ALONE : k}, "", bodies[k], &index));
		low = index < low ? index : low;
		high = index > high ? index : high;
	}
	TRY(world_upload(world));
	int* rows = count > 0 ? world_scratch(world, (size_t)(high - low + 1) * sizeof *rows) : NULL;
	if (count > 0 && !rows)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for %d bodies", function, high - low + 1);
	if (count > 0)
		TRY(world_read_sleep(world, low, high - low + 1, rows));
	for (int k = 0; k < count; ++k)
		awake[k] = rows[(int)bodies[k].index - low] == 0;
	return SCREE_OK;
}

scree_status api_bodies_get_awake(scree_world* world, const scree_body* bodies, bool* awake, int count)
{
	FLOAT_MODE_HERE;
	return get_awake(world, "scree_bodies_get_awake", "bodies", bodies, awake, count, false);
}

scree_status api_body_get_awake(scree_world* world, scree_body body, bool* awake)
{
	FLOAT_MODE_HERE;
	return get_awake(world, "scree_body_get_awake", "body", &body, awake, 1, true);
}

static scree_status lookup(const scree_world* world, const char* function, scree_body body, const char* argument,
                           const void* out, HostBody** host)
{
	int index = 0;
	TRY(world_check(world, function));
	TRY(check_body(world, (ArgumentPlace){function, "body", ALONE}, "", body, &index));
	*host = world->host_bodies + index;
	return check_pointer(function, argument, out);
}

static void send_threshold(scree_world* world, const HostBody* host)
{
	Float4 value = make_float4(body_sleep_threshold(host), 0.0f, 0.0f, 0.0f);
	edits_command(world, COMMAND_SLEEP, (int)(host - world->host_bodies), value, SLEEP_AS_BEFORE);
}

scree_status api_body_set_sleep_threshold(scree_world* world, scree_body body, float threshold)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_body_set_sleep_threshold";
	HostBody* host;
	TRY(lookup(world, function, body, "threshold", &threshold, &host));
	TRY(check_real((ArgumentPlace){function, "threshold", ALONE}, "", threshold, 0.0f, 1e6f));
	TRY(edits_reserve(world, function, 0, 0, 1));
	host->sleep_threshold = threshold;
	send_threshold(world, host);
	return SCREE_OK;
}

scree_status api_body_get_sleep_threshold(const scree_world* world, scree_body body, float* threshold)
{
	FLOAT_MODE_HERE;
	HostBody* host;
	TRY(lookup(world, "scree_body_get_sleep_threshold", body, "threshold", threshold, &host));
	*threshold = host->sleep_threshold;
	return SCREE_OK;
}

scree_status api_body_set_stays_awake(scree_world* world, scree_body body, bool stays_awake)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_body_set_stays_awake";
	HostBody* host;
	TRY(lookup(world, function, body, "stays_awake", &stays_awake, &host));
	TRY(edits_reserve(world, function, 0, 0, 1));
	host->stays_awake = stays_awake;
	structure_changed(world);
	send_threshold(world, host);
	return SCREE_OK;
}

scree_status api_body_get_stays_awake(const scree_world* world, scree_body body, bool* stays_awake)
{
	FLOAT_MODE_HERE;
	HostBody* host;
	TRY(lookup(world, "scree_body_get_stays_awake", body, "stays_awake", stays_awake, &host));
	*stays_awake = host->stays_awake;
	return SCREE_OK;
}
