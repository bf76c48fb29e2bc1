// SPDX-License-Identifier: MIT
// collidable_settings.c -- reads and sets pose, filter, reports, sensor bits and user word of a collidable.
#include "platform/processor.h"
#include "world/edits.h"
#include "world/failure.h"
#include "world/objects/collidables.h"
#include "world/objects/handles.h"
#include "world/objects/mass.h"
#include "world/objects/reports.h"
#include "world/objects/sensors.h"
#include "world/objects/sleep.h"
#include "world/pool_values.h"
#include "world/record/api_calls.h"
#include "world/structure.h"

static scree_status lookup(const scree_world* world, const char* function, scree_collidable collidable,
                           const char* argument, const void* out, HostCollidable** host)
{
	int index = 0;
	TRY(check_pointer(function, "world", world));
	TRY(check_collidable(world, (ArgumentPlace){function, "collidable", ALONE}, collidable, &index));
	*host = world->host_collidables + index;
	return check_pointer(function, argument, out);
}

scree_status api_collidable_get_body(const scree_world* world, scree_collidable collidable, scree_body* body)
{
	FLOAT_MODE_HERE;
	HostCollidable* host;
	TRY(lookup(world, "scree_collidable_get_body", collidable, "body", body, &host));
	*body = owner_handle(world, (int)collidable.index - 1);
	return SCREE_OK;
}

scree_status api_collidable_get_local_pose(const scree_world* world, scree_collidable collidable, scree_pose* pose)
{
	FLOAT_MODE_HERE;
	HostCollidable* host;
	TRY(lookup(world, "scree_collidable_get_local_pose", collidable, "pose", pose, &host));
	*pose = host->pose;
	return SCREE_OK;
}

scree_status api_collidable_get_filter(const scree_world* world, scree_collidable collidable, scree_filter* filter)
{
	FLOAT_MODE_HERE;
	HostCollidable* host;
	TRY(lookup(world, "scree_collidable_get_filter", collidable, "filter", filter, &host));
	*filter = host->filter;
	return SCREE_OK;
}

scree_status api_collidable_get_user(const scree_world* world, scree_collidable collidable, uint64_t* user)
{
	FLOAT_MODE_HERE;
	HostCollidable* host;
	TRY(lookup(world, "scree_collidable_get_user", collidable, "user", user, &host));
	*user = host->user;
	return SCREE_OK;
}

scree_status api_collidable_set_user(scree_world* world, scree_collidable collidable, uint64_t user)
{
	FLOAT_MODE_HERE;
	HostCollidable* host;
	TRY(lookup(world, "scree_collidable_set_user", collidable, "user", &user, &host));
	host->user = user;
	structure_changed(world);
	return SCREE_OK;
}

scree_status api_collidable_set_filter(scree_world* world, scree_collidable collidable, scree_filter filter)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_collidable_set_filter";
	TRY(world_check(world, function));
	int index = 0;
	TRY(check_collidable(world, (ArgumentPlace){function, "collidable", ALONE}, collidable, &index));
	scree_filter old = world->host_collidables[index].filter;
	if (old.category == filter.category && old.mask == filter.mask && old.group == filter.group)
		return SCREE_OK; // so that a call in each step keeps no body awake
	TRY(edits_reserve(world, function, 0, 1, 1));
	TRY(collidable_mark_tree(world, index));
	body_note_wake(world, world->host_collidables[index].body);
	world->host_collidables[index].filter = filter;
	edits_collidable(world, index);
	return SCREE_OK;
}

scree_status api_collidable_get_reports(const scree_world* world, scree_collidable collidable, uint32_t* reports)
{
	FLOAT_MODE_HERE;
	HostCollidable* host;
	TRY(lookup(world, "scree_collidable_get_reports", collidable, "reports", reports, &host));
	*reports = host->reports;
	return SCREE_OK;
}

static scree_status set_reports(scree_world* world, const char* function, const char* argument,
                                const scree_collidable* collidables, const uint32_t* reports, int count, bool alone)
{
	for (int k = 0; k < count; ++k)
	{
		int index;
		TRY(check_collidable(world, (ArgumentPlace){function, argument, alone ? ALONE : k}, collidables[k], &index));
		TRY(check_reports((ArgumentPlace){function, "reports", alone ? ALONE : k}, "", reports[k]));
	}
	TRY(edits_reserve(world, function, 0, 0, count));
	for (int k = 0; k < count; ++k)
	{
		int index = (int)collidables[k].index - 1;
		HostCollidable* host = world->host_collidables + index;
		if (host->reports == reports[k])
			continue;
		world->reports.reporters += (reports[k] != 0) - (host->reports != 0);
		host->reports = reports[k];
		reports_note(world, host->reports);
		edits_command(world, COMMAND_REPORTS, index, make_float4(0.0f, 0.0f, 0.0f, 0.0f), (int)report_bits(host));
		world->pipeline.surfaces_changed = true;
	}
	return SCREE_OK;
}

scree_status api_collidable_set_reports(scree_world* world, scree_collidable collidable, uint32_t reports)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_collidable_set_reports";
	TRY(world_check(world, function));
	return set_reports(world, function, "collidable", &collidable, &reports, 1, true);
}

scree_status api_collidables_set_reports(scree_world* world, const scree_collidable* collidables,
                                         const uint32_t* reports, int count)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_collidables_set_reports";
	TRY(world_check(world, function));
	TRY(check_batch(function, "collidables", collidables, count));
	TRY(check_batch(function, "reports", reports, count));
	return set_reports(world, function, "collidables", collidables, reports, count, false);
}

scree_status api_collidable_get_sensor(const scree_world* world, scree_collidable collidable, uint32_t* sensor)
{
	FLOAT_MODE_HERE;
	HostCollidable* host;
	TRY(lookup(world, "scree_collidable_get_sensor", collidable, "sensor", sensor, &host));
	*sensor = host->sensor;
	return SCREE_OK;
}

scree_status api_collidable_set_sensor(scree_world* world, scree_collidable collidable, uint32_t sensor)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_collidable_set_sensor";
	TRY(world_check(world, function));
	int index = 0;
	TRY(check_collidable(world, (ArgumentPlace){function, "collidable", ALONE}, collidable, &index));
	TRY(check_sensor((ArgumentPlace){function, "sensor", ALONE}, "", sensor));
	HostCollidable* host = world->host_collidables + index;
	if (host->sensor == sensor)
		return SCREE_OK;
	TRY(edits_reserve(world, function, 0, 1, 2));
	TRY(collidable_mark_tree(world, index));
	sensors_note(world, host->sensor, sensor);
	body_note_wake(world, host->body);
	host->sensor = sensor;
	mass_touches(world, host->body);
	host->born = world->pipeline.steps;
	edits_collidable(world, index);
	return SCREE_OK;
}

scree_status api_collidables_set_poses(scree_world* world, const scree_collidable* collidables, const scree_pose* poses,
                                       int count)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_collidables_set_poses";
	TRY(world_check(world, function));
	TRY(check_batch(function, "collidables", collidables, count));
	TRY(check_batch(function, "poses", poses, count));
	for (int k = 0; k < count; ++k)
	{
		int index = 0;
		scree_pose pose = poses[k];
		TRY(check_collidable(world, (ArgumentPlace){function, "collidables", k}, collidables[k], &index));
		if (world->host_collidables[index].body >= 0)
			return refuse(SCREE_ERROR_INVALID, (ArgumentPlace){function, "collidables", k}, "",
			              "belongs to a body: move that");
		TRY(check_pose((ArgumentPlace){function, "poses", k}, "", &pose));
	}
	TRY(edits_reserve(world, function, 0, 0, count));
	for (int k = 0; k < count; ++k)
	{
		int index = (int)collidables[k].index - 1;
		scree_pose pose = poses[k];
		check_pose((ArgumentPlace){function, "poses", k}, "", &pose);
		world->host_collidables[index].pose = pose;
		edits_command(world, COMMAND_PLACE, index, pose_row(pose), 0);
	}
	return SCREE_OK;
}
