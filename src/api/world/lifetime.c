// SPDX-License-Identifier: MIT
// lifetime.c -- creates, steps and destroys the world.
#include "api/world/device_test.h"
#include "platform/processor.h"
#include "platform/zones.h"
#include "world/create.h"
#include "world/definition.h"
#include "world/device/auto.h"
#include "world/device/devices.h"
#include "world/device/idle.h"
#include "world/failure.h"
#include "world/objects/fields.h"
#include "world/objects/reports.h"
#include "world/objects/sensors.h"
#include "world/objects/targets.h"
#include "world/record/api_calls.h"
#include "world/record/recorder.h"
#include "world/recovery/recovery.h"
#include "world/save/saves.h"
#include "world/tuning_members.h"
#include "world/units/convert.h"
#include "world/upload/upload.h"
#include "world/upload/whole_sleep.h"
#include "world/world.h"
#include <string.h>

void scree_world_def_default_sized(scree_world_def* def, size_t size)
{
	const scree_world_def made = {.size = (uint32_t)size,
	                              .gravity = {0.0f, -10.0f},
	                              .device = "auto",
	                              .contact_hertz = 40.0f,
	                              .contact_damping_ratio = 10.0f,
	                              .contact_push_speed = 3.0f,
	                              .restitution_threshold = 1.0f,
	                              .max_speed = 400.0f,
	                              .hit_speed = 1.0f,
	                              .sleep = true,
	                              .sleep_threshold = 0.05f};
	write_result(def, size, &made, sizeof made);
}

static scree_status check_def(const char* function, const scree_world_def* def)
{
	ArgumentPlace at = {function, "def", ALONE};
	TRY(check_vec(at, ".gravity", def->gravity, FLT_MAX));
	TRY(check_device(at, ".device", def->device));
	if (def->opengl && (!def->opengl->context || !def->opengl->display))
		return refuse(SCREE_ERROR_INVALID, at, ".opengl", "has no %s", def->opengl->context ? "display" : "context");
	if (def->opengl && (def->opengl->system < SCREE_WINDOW_EGL || def->opengl->system > SCREE_WINDOW_WGL))
		return refuse(SCREE_ERROR_INVALID, at, ".opengl->system", "is %d, must be from %d to %d",
		              (int)def->opengl->system, (int)SCREE_WINDOW_EGL, (int)SCREE_WINDOW_WGL);
	if (def->tasks && (!def->tasks->enqueue || !def->tasks->finish))
		return refuse(SCREE_ERROR_INVALID, at, ".tasks", "has no %s", def->tasks->enqueue ? "finish" : "enqueue");
	if (def->threads < 0 || def->threads > 64)
		return refuse(SCREE_ERROR_INVALID, at, ".threads", "is %d, must be from 0 to 64", def->threads);
	TRY(check_lanes(at, ".lanes", def->lanes));
#ifdef SCREE_SMALL // a build for WebAssembly works in metres
	TRY(check_real(at, ".length_unit", def->length_unit, 0.0f, 0.0f));
#else
	if (def->length_unit != 0.0f)
		TRY(check_real(at, ".length_unit", def->length_unit, LEAST_LENGTH_UNIT, MOST_LENGTH_UNIT));
#endif
	scree_tuning tuning = tuning_of(def);
	TRY(check_tuning(at, &tuning));
	TRY(check_real(at, ".hit_speed", def->hit_speed, 0.0f, FLT_MAX));
	TRY(check_real(at, ".hit_impulse", def->hit_impulse, 0.0f, FLT_MAX));
	if (!(def->device_timeout >= 0.0f))
		return refuse(SCREE_ERROR_INVALID, at, ".device_timeout", "is %s, must be from 0 to INFINITY",
		              decimal(def->device_timeout).text);
	if (def->recovery_interval < 0)
		return refuse(SCREE_ERROR_INVALID, at, ".recovery_interval", "is %d, must be at least 0",
		              def->recovery_interval);
	if (def->body_capacity < 0 || def->body_capacity > MAX_ITEMS)
		return refuse(SCREE_ERROR_INVALID, at, ".body_capacity", "is %d, must be from 0 to %d", def->body_capacity,
		              MAX_ITEMS);
	if (def->contact_capacity < 0 || def->contact_capacity > MAX_CONTACTS)
		return refuse(SCREE_ERROR_INVALID, at, ".contact_capacity", "is %d, must be from 0 to %d",
		              def->contact_capacity, MAX_CONTACTS);
	if (def->contact_limit < 0 || def->contact_limit > MAX_CONTACTS)
		return refuse(SCREE_ERROR_INVALID, at, ".contact_limit", "is %d, must be from 0 to %d", def->contact_limit,
		              MAX_CONTACTS);
	return SCREE_OK;
}

scree_status api_world_create(const scree_world_def* def, scree_world** world)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_world_create";
	TRY(check_pointer(function, "world", world));
	*world = NULL;
	TRY(check_pointer(function, "def", def));
	TRY(check_definition((ArgumentPlace){function, "def", ALONE}, def, 0, &world_definition));
	scree_world_def local;
	def = definition_at(def, 0, &world_definition, &local);
	TRY(check_def(function, def));
#ifndef SCREE_SMALL
	scree_world_def metric = *def;
	units_of_definition(&metric);
	def = &metric;
	TRY(cpu_self_test(function));
#endif
	Backend* backend;
	TRY(device_open(def, TEST_WORLDS, &backend));
	scree_status status = world_create(def, backend, world);
	if (status != SCREE_OK)
	{
		backend->f->close(backend);
		return status;
	}
	if (strcmp(def->device, "auto") == 0)
		auto_open(*world, TEST_WORLDS);
	status = recovery_begin(*world, function);
	if (status != SCREE_OK)
	{
		scree_world_destroy(*world);
		*world = NULL;
	}
	return status;
}

static scree_status step(scree_world* world, const char* function, float dt, int substeps)
{
	TRY(world_check(world, function));
	TRY(check_step(function, dt, substeps));
	if (dt > 0.0f &&
	    auto_choose(world)) // with dt 0 a step only detects contacts, so its duration is no measure of a device
	{
		TRY(recovery_prepare(world, function));
		TRY(auto_change(world));
	}
	double start = processor_milliseconds();
	TRY(reports_reserve(world, function));
	bool request_again = !world->reports.answered && (dt == 0.0f || world->reports.lost);
	reports_forget(world);
	sensors_forget(world);
	TRY(world_upload_to_step(world));
	double begin = auto_clock();
	StepRequest request = {.dt = dt,
	                       .substeps = substeps,
	                       .gravity = world->def.gravity,
	                       .tuning = tuning_of(&world->def),
	                       .bodies = world->bodies.used,
	                       .collidables = world->collidables.used,
	                       .kinematic = world->kinematic_count,
	                       .kinematics = world->kinematics,
	                       .contact_limit = world->def.contact_limit,
	                       .timings = world->def.timings,
	                       .details = world->def.contact_details,
	                       .reports = world->reports.reporters > 0,
	                       .sleep = world->def.sleep,
	                       .sleep_threshold = world->def.sleep_threshold,
	                       .request_again = request_again,
	                       .allowed = world->reports.allowed,
	                       .allowed_count = world->reports.allowed_count,
	                       .hit_speed = world->def.hit_speed,
	                       .hit_impulse = world->def.hit_impulse};
	request.fields = fields_acting(world, &request.field_shapes);
	request.carried_fields = world->fields.carried;
	if (dt > 0.0f)
		TRY(targets_commands(world, &request.commands));
	idle_begin(world);
	scree_status status = pipeline_step(&world->pipeline, &request);
	if (status == SCREE_OK)
		reports_stepped(world);
	if (status == SCREE_OK && dt > 0.0f)
	{
		targets_arrived(world);
		idle_end(world);
	}
	// the boxes have moved, but not the bodies: later steps would miss pairs whose boxes began to overlap in this step
	if (status != SCREE_OK && world->pipeline.started)
		world->broken = status;
	double milliseconds = processor_milliseconds() - start;
	if (status == SCREE_OK && world->auto_device.trial)
		status = world->backend->f->wait(world->backend);
	auto_count(world, begin);
	TRY(world_note(world, status));
	world->reports.fetched = false;
	// without motion, visits neither begin nor end
	status = world->pipeline.rested ? SCREE_OK : sensors_update(world, function);
	if (status != SCREE_OK) // the step is complete without its visits, so later steps would miss them
		world->broken = status;
	TRY(world_note(world, status));
	world->pipeline.milliseconds = milliseconds;
	const Counters* c = &world->pipeline.counters;
	if (c->nonfinite > 0 && dt > 0.0f)
		log_sentence(SCREE_LOG_WARNING,
		             "%s: %d bodies were frozen because their state was not finite; the first is body %d", function,
		             c->nonfinite, c->first_nonfinite);
	return SCREE_OK;
}

scree_status api_world_step(scree_world* world, float dt, int substeps)
{
	FLOAT_MODE_HERE;
	ZONE_BEGIN(zone, "scree_world_step");
	scree_status status = step(world, "scree_world_step", dt, substeps);
	ZONE_END(zone);
	return status;
}

void scree_world_destroy(scree_world* world)
{
	FLOAT_MODE_HERE;
	if (!world)
		return;
	if (world->drawing)
	{
		log_sentence(SCREE_LOG_WARNING,
		             "scree_world_destroy: a function that draws for scree_world_draw must not use its world; "
		             "the world is not destroyed");
		return;
	}
#ifndef SCREE_SMALL // a build for WebAssembly makes no recordings, and its device does not fail
	recorders_close(world);
	recovery_close(world);
#endif
	saves_close(world);
	world_destroy(world);
}

scree_status api_world_set_gravity(scree_world* world, scree_vec gravity)
{
	FLOAT_MODE_HERE;
	TRY(world_check(world, "scree_world_set_gravity"));
	TRY(check_vec((ArgumentPlace){"scree_world_set_gravity", "gravity", ALONE}, "", gravity, FLT_MAX));
	if (gravity.x != world->def.gravity.x || gravity.y != world->def.gravity.y)
		TRY(world_set_awake(world, true));
	world->def.gravity = gravity;
	return SCREE_OK;
}

scree_status api_world_get_gravity(const scree_world* world, scree_vec* gravity)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_world_get_gravity";
	TRY(check_pointer(function, "world", world));
	TRY(check_pointer(function, "gravity", gravity));
	*gravity = world->def.gravity;
	return SCREE_OK;
}

const char* scree_world_get_device(const scree_world* world) { return world ? world->device : ""; }
int scree_world_get_threads(const scree_world* world) { return world ? world->backend->threads : 0; }
int scree_world_get_lanes(const scree_world* world) { return world ? world->backend->lanes : 0; }

scree_status api_world_wait(scree_world* world)
{
	FLOAT_MODE_HERE;
	TRY(world_check(world, "scree_world_wait"));
	return world_note(world, world->backend->f->wait(world->backend));
}
