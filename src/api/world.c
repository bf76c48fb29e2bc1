// SPDX-License-Identifier: MIT
// world.c -- the world: created, stepped, hashed, counted and destroyed.
#include "world/world.h"
#include "device/devices.h"
#include "dialect/hash_word.h"
#include "platform/processor.h"
#include "world/definition.h"
#include "world/targets.h"
#include <limits.h>
#include <stdio.h>
#include <string.h>

// Shorter than this, rates of change are too large for a float; seconds.
#define SHORTEST_STEP 1e-9f

void scree_world_def_default_sized(scree_world_def* def, size_t size)
{
	const scree_world_def made = {.size = (uint32_t)size,
	                              .gravity = {0.0f, -10.0f},
	                              .device = "auto",
	                              .contact_hertz = 52.0f,
	                              .contact_damping_ratio = 15.0f,
	                              .contact_push_speed = 3.0f,
	                              .restitution_threshold = 1.0f,
	                              .max_speed = 400.0f};
	write_result(def, size, &made, sizeof made);
}

// ---------------------------------------------------------------------------------------------------------------
// for the other files
// ---------------------------------------------------------------------------------------------------------------

scree_status world_check(const scree_world* world, const char* function)
{
	TRY(check_pointer(function, "world", world));
	if (world->broken)
		return fail(world->broken, "%s: %s; the world can only be destroyed", function,
		            world->broken == SCREE_ERROR_DEVICE_FAILED ? "the device of this world has failed"
		                                                       : "a step of this world broke off for want of memory");
	return SCREE_OK;
}

scree_status world_note(scree_world* world, scree_status status)
{
	if (status == SCREE_ERROR_DEVICE_FAILED)
		world->broken = status;
	return status;
}

scree_status world_read(scree_world* world, PoolId pool, int first, int count, void* items)
{
	Backend* b = world->backend;
	double begin = auto_clock();
	scree_status status = b->f->read(b, pool, first, count, items);
	auto_count(world, begin);
	return world_note(world, status);
}

void* world_scratch(scree_world* world, size_t bytes)
{
	if (bytes > world->scratch_bytes || !world->scratch)
	{
		void* memory = scree_allocate(bytes);
		if (!memory)
			return NULL;
		scree_release(world->scratch);
		world->scratch = memory;
		world->scratch_bytes = bytes;
	}
	return world->scratch;
}

scree_status grow(const char* function, void** array, int* capacity, size_t item, int needed)
{
	if (needed <= *capacity)
		return SCREE_OK;
	int64_t larger = *capacity + (int64_t)*capacity / 2 + 16;
	larger = larger > needed ? larger : needed;
	larger = larger < INT_MAX ? larger : INT_MAX;
	void* memory = scree_reallocate(*array, (size_t)*capacity * item, (size_t)larger * item);
	if (!memory)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for %lld items of %zu bytes", function, (long long)larger,
		            item);
	*array = memory;
	*capacity = (int)larger;
	return SCREE_OK;
}

// ---------------------------------------------------------------------------------------------------------------
// create and destroy
// ---------------------------------------------------------------------------------------------------------------

static scree_tuning tuning_of(const scree_world_def* def)
{
	return (scree_tuning){.size = sizeof(scree_tuning),
	                      .contact_hertz = def->contact_hertz,
	                      .contact_damping_ratio = def->contact_damping_ratio,
	                      .contact_push_speed = def->contact_push_speed,
	                      .restitution_threshold = def->restitution_threshold,
	                      .max_speed = def->max_speed};
}

static scree_status check_tuning(Where at, const scree_tuning* tuning)
{
	TRY(check_real(at, ".contact_hertz", tuning->contact_hertz, 1e-3f, 1e6f));
	TRY(check_real(at, ".contact_damping_ratio", tuning->contact_damping_ratio, 0.0f, 1e6f));
	TRY(check_real(at, ".contact_push_speed", tuning->contact_push_speed, 0.0f, SCREE_HUGE));
	TRY(check_real(at, ".restitution_threshold", tuning->restitution_threshold, 0.0f, FLT_MAX));
	return check_real(at, ".max_speed", tuning->max_speed, 1e-3f, SCREE_HUGE);
}

static scree_status check_def(const char* function, const scree_world_def* def)
{
	Where at = {function, "def", ALONE};
	TRY(check_vec(at, ".gravity", def->gravity, FLT_MAX));
	TRY(check_device(at, ".device", def->device));
	if (def->opengl && (!def->opengl->context || !def->opengl->display))
		return refuse(SCREE_ERROR_INVALID, at, ".opengl", "has no %s", def->opengl->context ? "display" : "context");
	if (def->opengl && (def->opengl->system < SCREE_WINDOW_EGL || def->opengl->system > SCREE_WINDOW_WGL))
		return refuse(SCREE_ERROR_INVALID, at, ".opengl->system", "is %d, must be from %d to %d",
		              (int)def->opengl->system, (int)SCREE_WINDOW_EGL, (int)SCREE_WINDOW_WGL);
	if (def->threads < 0 || def->threads > 64)
		return refuse(SCREE_ERROR_INVALID, at, ".threads", "is %d, must be from 0 to 64", def->threads);
	if (def->lanes != 0 && def->lanes != 1 && def->lanes != 4 && def->lanes != 8 && def->lanes != 16)
		return refuse(SCREE_ERROR_INVALID, at, ".lanes", "is %d, must be 0, 1, 4, 8 or 16", def->lanes);
	scree_tuning tuning = tuning_of(def);
	TRY(check_tuning(at, &tuning));
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

// Body 0, what everything without a body of its own is bound to. Its slot is never in use, so that no handle names it.
static scree_status add_ground(scree_world* world, const char* function)
{
	if (!slots_reserve(&world->bodies, 1))
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for bodies", function);
	TRY(GROW(function, world->host_bodies, world->host_body_capacity, world->bodies.capacity));
	TRY(edits_reserve(world, function, 1, 0, 0));
	world->bodies.used = 1;
	world->host_bodies[0] = (HostBody){.first_collidable = -1, .last_collidable = -1};
	edits_body(world, (BodyRow){.index = 0, .pose.rotation.c = 1.0f});
	return SCREE_OK;
}

scree_status world_create(const scree_world_def* def, Backend* backend, scree_world** world)
{
	const char* function = "scree_world_create";
	*world = NULL;
	scree_world* made = scree_allocate(sizeof *made);
	if (!made)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for a world", function);
	worlds_add(1);
	made->def = *def;
	// what the definition points to was lent for the call alone
	made->def.device = made->device;
	if (def->opengl)
	{
		made->opengl = *def->opengl;
		made->def.opengl = &made->opengl;
	}
	snprintf(made->device, sizeof made->device, "%s", backend->name);
	made->backend = backend;
	scree_status status = pipeline_open(&made->pipeline, backend, def->body_capacity, def->contact_capacity);
	if (status == SCREE_OK)
		status = add_ground(made, function);
	if (status == SCREE_OK)
		*world = made;
	else
	{
		made->backend = NULL;
		scree_world_destroy(made);
	}
	return status;
}

scree_status scree_world_create(const scree_world_def* def, scree_world** world)
{
	const char* function = "scree_world_create";
	TRY(check_pointer(function, "world", world));
	*world = NULL;
	TRY(check_pointer(function, "def", def));
	TRY(check_definition((Where){function, "def", ALONE}, def, 0, &world_definition));
	scree_world_def local;
	def = definition_at(def, 0, &world_definition, &local);
	TRY(check_def(function, def));
	Backend* backend;
	TRY(device_open(def, &backend));
	scree_status status = world_create(def, backend, world);
	if (status != SCREE_OK)
		backend->f->close(backend);
	else if (strcmp(def->device, "auto") == 0)
		auto_open(*world);
	return status;
}

void scree_world_destroy(scree_world* world)
{
	if (!world)
		return;
	auto_close(world);
	pipeline_close(&world->pipeline);
	if (world->backend)
		world->backend->f->close(world->backend);
	edits_close(&world->edits);
	slots_close(&world->bodies);
	slots_close(&world->collidables);
	slots_close(&world->attribute_slots);
	scree_release(world->host_bodies);
	scree_release(world->host_collidables);
	scree_release(world->attributes);
	scree_release(world->host_attributes);
	scree_release(world->attribute_table);
	scree_release(world->targets);
	scree_release(world->scratch);
	scree_release(world);
	worlds_add(-1);
}

// ---------------------------------------------------------------------------------------------------------------
// the whole world
// ---------------------------------------------------------------------------------------------------------------

scree_status scree_world_step(scree_world* world, float dt, int substeps)
{
	const char* function = "scree_world_step";
	TRY(world_check(world, function));
	if (dt != 0.0f && !(dt >= SHORTEST_STEP && dt <= 1.0f))
		return fail(SCREE_ERROR_INVALID, "%s: dt is %s, must be 0 or from %s to 1", function, decimal(dt).text,
		            decimal(SHORTEST_STEP).text);
	if (substeps < 1 || substeps > 64)
		return fail(SCREE_ERROR_INVALID, "%s: substeps is %d, must be from 1 to 64", function, substeps);
	if (dt > 0.0f) // what only looks takes another time
		TRY(auto_choose(world));
	double start = processor_milliseconds();
	TRY(world_upload(world));
	double begin = auto_clock();
	StepRequest request = {.dt = dt,
	                       .substeps = substeps,
	                       .gravity = world->def.gravity,
	                       .tuning = tuning_of(&world->def),
	                       .bodies = world->bodies.used,
	                       .collidables = world->collidables.used,
	                       .contact_limit = world->def.contact_limit,
	                       .timings = world->def.timings,
	                       .details = world->def.contact_details};
	if (dt > 0.0f)
		TRY(targets_commands(world, &request.commands));
	scree_status status = pipeline_step(&world->pipeline, &request);
	if (status == SCREE_OK && dt > 0.0f)
		targets_arrived(world);
	// the boxes have moved on and the bodies have not: what touched in between would never be found again
	if (status != SCREE_OK && world->pipeline.begun)
		world->broken = status;
	double milliseconds = processor_milliseconds() - start;
	if (status == SCREE_OK && world->auto_device.trial)
		status = world->backend->f->wait(world->backend);
	auto_count(world, begin);
	TRY(world_note(world, status));
	world->pipeline.milliseconds = milliseconds;
	const Counters* c = &world->pipeline.counters;
	if (c->nonfinite > 0 && dt > 0.0f)
		log_sentence(SCREE_LOG_WARNING,
		             "%s: %d bodies were frozen because their state was not finite; the first is body %d", function,
		             c->nonfinite, c->first_nonfinite);
	return SCREE_OK;
}

scree_status scree_world_set_gravity(scree_world* world, scree_vec gravity)
{
	TRY(world_check(world, "scree_world_set_gravity"));
	TRY(check_vec((Where){"scree_world_set_gravity", "gravity", ALONE}, "", gravity, FLT_MAX));
	world->def.gravity = gravity;
	return SCREE_OK;
}

scree_status scree_world_get_gravity(const scree_world* world, scree_vec* gravity)
{
	const char* function = "scree_world_get_gravity";
	TRY(check_pointer(function, "world", world));
	TRY(check_pointer(function, "gravity", gravity));
	*gravity = world->def.gravity;
	return SCREE_OK;
}

scree_status scree_world_get_tuning_sized(const scree_world* world, scree_tuning* tuning, size_t size)
{
	const char* function = "scree_world_get_tuning";
	TRY(check_pointer(function, "world", world));
	TRY(check_pointer(function, "tuning", tuning));
	scree_tuning now = tuning_of(&world->def);
	now.size = (uint32_t)size;
	write_result(tuning, size, &now, sizeof now);
	return SCREE_OK;
}

scree_status scree_world_set_tuning(scree_world* world, const scree_tuning* tuning)
{
	const char* function = "scree_world_set_tuning";
	Where at = {function, "tuning", ALONE};
	TRY(world_check(world, function));
	TRY(check_pointer(function, "tuning", tuning));
	TRY(check_definition(at, tuning, 0, &tuning_definition));
	scree_tuning local;
	tuning = definition_at(tuning, 0, &tuning_definition, &local);
	TRY(check_tuning(at, tuning));
	world->def.contact_hertz = tuning->contact_hertz;
	world->def.contact_damping_ratio = tuning->contact_damping_ratio;
	world->def.contact_push_speed = tuning->contact_push_speed;
	world->def.restitution_threshold = tuning->restitution_threshold;
	world->def.max_speed = tuning->max_speed;
	return SCREE_OK;
}

const char* scree_world_get_device(const scree_world* world) { return world ? world->device : ""; }
int scree_world_get_threads(const scree_world* world) { return world ? world->backend->threads : 0; }
int scree_world_get_lanes(const scree_world* world) { return world ? world->backend->lanes : 0; }

static Word64 hash_pose(Word64 h, scree_pose pose)
{
	return hash_float4(h, make_float4(pose.position.x, pose.position.y, pose.rotation.c, pose.rotation.s));
}

// the device hashes no collidable of a body that is disabled, and has no gravity for it
static Word64 hash_disabled(const scree_world* world, int body)
{
	const HostBody* host = world->host_bodies + body;
	Word64 sum = hash_float(hash_word(hash_begin(5, body), (Word)host->type), host->gravity_scale);
	for (int k = host->first_collidable; k >= 0; k = world->host_collidables[k].next)
	{
		const HostCollidable* c = world->host_collidables + k;
		Word64 h = hash_pose(hash_word(hash_word(hash_begin(6, k), (Word)body), (Word)c->attribute), c->pose);
		h = hash_word(hash_word(h, (Word)c->filter.category), (Word)(c->filter.category >> 32));
		h = hash_word(hash_word(h, (Word)c->filter.mask), (Word)(c->filter.mask >> 32));
		sum += hash_word(h, (Word)c->filter.group);
	}
	return sum;
}

// Of what only the host knows.
static uint64_t hidden_hash(const scree_world* world)
{
	Word64 sum = 0;
	for (int k = 0; k < world->target_count; ++k)
		sum += hash_pose(hash_begin(4, world->targets[k].body), world->targets[k].pose);
	for (int k = 0; k < world->bodies.used && world->disabled_bodies > 0; ++k)
		if (slots_in_use(&world->bodies, k) && world->host_bodies[k].disabled)
			sum += hash_disabled(world, k);
	return sum;
}

scree_status scree_world_get_hash(scree_world* world, uint64_t* hash)
{
	const char* function = "scree_world_get_hash";
	TRY(world_check(world, function));
	TRY(check_pointer(function, "hash", hash));
	TRY(world_upload(world));
	double begin = auto_clock();
	scree_status status = pipeline_hash(&world->pipeline, world->bodies.used, world->collidables.used, hash);
	if (status == SCREE_OK)
		*hash += hidden_hash(world);
	auto_count(world, begin);
	return world_note(world, status);
}

scree_status scree_world_get_counters_sized(scree_world* world, scree_counters* counters, size_t size)
{
	const char* function = "scree_world_get_counters";
	TRY(world_check(world, function));
	TRY(check_pointer(function, "counters", counters));
	// those that the end of the last step changed are a step old otherwise
	TRY(world_read(world, POOL_counters, 0, 1, &world->pipeline.counters));
	const Pipeline* pipeline = &world->pipeline;
	const Counters* c = &pipeline->counters;
	scree_counters now = {.bodies = world->bodies.alive,
	                      .dynamic_bodies = world->dynamic_bodies,
	                      .collidables = world->collidables.alive,
	                      .attributes = world->attribute_slots.alive,
	                      .contacts = c->alive - c->released,
	                      .touching = c->touching,
	                      .spokes = c->layout[CONSTRAINT_CONTACT].count[COLORS],
	                      .moved = c->moved,
	                      .new_contacts = c->created,
	                      .grown = pipeline->grown,
	                      .nonfinite = c->nonfinite,
	                      .held = c->held,
	                      .penetration = bits_float(c->penetration),
	                      .steps = pipeline->steps,
	                      .device_bytes = world->backend->bytes};
	for (int color = 0; color < COLORS; ++color)
		now.colors += c->layout[CONSTRAINT_CONTACT].count[color] > 0;
	write_result(counters, size, &now, sizeof now);
	return SCREE_OK;
}

scree_status scree_world_get_timings_sized(scree_world* world, scree_timings* timings, size_t size)
{
	const char* function = "scree_world_get_timings";
	TRY(world_check(world, function));
	TRY(check_pointer(function, "timings", timings));
	scree_timings now = {0};
	const double* boxes = world->pipeline.boxes;
	if (world->def.timings)
		now = (scree_timings){.step = (float)world->pipeline.milliseconds,
		                      .transform = (float)boxes[BOX_transform],
		                      .broad_phase = (float)boxes[BOX_broad_phase],
		                      .narrow_phase = (float)boxes[BOX_narrow_phase],
		                      .color = (float)boxes[BOX_color],
		                      .solve = (float)boxes[BOX_solve],
		                      .finalize = (float)boxes[BOX_finalize]};
	write_result(timings, size, &now, sizeof now);
	return SCREE_OK;
}

scree_status scree_world_wait(scree_world* world)
{
	TRY(world_check(world, "scree_world_wait"));
	return world_note(world, world->backend->f->wait(world->backend));
}
