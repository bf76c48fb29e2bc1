// SPDX-License-Identifier: MIT
// use_world.c -- limits the memory of fuzz targets, and uses worlds that strange bytes have made.
#include "fuzz/fuzz.h"
#include "programs/run_call.h"
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#define MOST_CONTACTS 4096 // limits the time of a step: a few bodies may have many contacts if all overlap
#define STEPS         3
#define FEW           4 // number of objects of each type that are destroyed

int fuzz_accepted;

static size_t most_memory, peak;

void fuzz_fault(const char* format, ...)
{
	va_list arguments;
	va_start(arguments, format);
	vfprintf(stderr, format, arguments);
	va_end(arguments);
	fputc('\n', stderr);
	abort();
}

// ---------------------------------------------------------------------------------------------------------------
// memory
// ---------------------------------------------------------------------------------------------------------------

static void* limited_allocate(size_t bytes, size_t alignment, void* context)
{
	(void)context;
	size_t used = scree_memory();
	size_t wanted = bytes < SIZE_MAX - used ? used + bytes : SIZE_MAX;
	peak = wanted > peak ? wanted : peak;
	return wanted > most_memory ? NULL : aligned_alloc(alignment, (bytes + alignment - 1) / alignment * alignment);
}

static void plain_release(void* memory, void* context)
{
	(void)context;
	free(memory);
}

static void ignore_line(scree_log_level level, const char* sentence, void* context)
{
	(void)level;
	(void)sentence;
	(void)context;
}

void fuzz_limit_memory(size_t most)
{
	static bool installed;
	const scree_hooks hooks = {.allocate = limited_allocate, .release = plain_release, .log = ignore_line};
	if (!installed)
		FUZZ_CHECK(scree_hooks_set(&hooks) == SCREE_OK, "%s", scree_error());
	installed = true;
	most_memory = most;
	peak = scree_memory();
}

size_t fuzz_memory_peak(void) { return peak; }

// ---------------------------------------------------------------------------------------------------------------
// worlds
// ---------------------------------------------------------------------------------------------------------------

scree_world_def fuzz_world_def(void)
{
	scree_world_def def = scree_world_def_default();
	def.device = "cpu";
	def.threads = def.lanes = 1;
	def.contact_limit = MOST_CONTACTS;
	return def;
}

void fuzz_check_status(scree_status status, const char* call)
{
	bool known = status == SCREE_OK || status == SCREE_ERROR_INVALID || status == SCREE_ERROR_STALE ||
	             status == SCREE_ERROR_OUT_OF_MEMORY || status == SCREE_ERROR_CONTACT_LIMIT;
	FUZZ_CHECK(known, "%s: %s: %s", call, scree_status_name(status), scree_error());
	FUZZ_CHECK(status == SCREE_OK || strlen(scree_error()) > 8, "%s: %s without a message", call,
	           scree_status_name(status));
}

// Makes a call of a random program. Such calls report a failed device if lists do not agree, as in a world of strange
// bytes.
static void make_call(scree_world* world, struct Names* names, Call call)
{
	static const Place place = {.device = "cpu", .threads = 1, .lanes = 1};
	Left left = {0};
	const CallRun run = {&call, world, names, &place, "cpu", &left};
	scree_status status = run_call(&run);
	if (status != SCREE_ERROR_DEVICE_FAILED)
		fuzz_check_status(status, call_info(call.kind)->name);
}

static void step(scree_world* world, struct Names* names, float dt, int substeps)
{
	Call call = call_make(CALL_step);
	call_set(&call, "dt", dt);
	call_set(&call, "substeps", (float)substeps);
	make_call(world, names, call);
}

// Reads a world, and queries it around a body.
static void read_world(scree_world* world, struct Names* names)
{
	Call read = call_make(CALL_read), ask = call_make(CALL_ask);
	uint64_t hash;
	scree_pose pose;
	if (scree_body_get_pose(world, names->bodies[0], &pose) == SCREE_OK)
	{
		call_set(&ask, "x", pose.position.x);
		call_set(&ask, "y", pose.position.y);
	}
	make_call(world, names, read);
	make_call(world, names, ask);
	fuzz_check_status(scree_world_get_hash(world, &hash), "scree_world_get_hash");
}

static void destroy_some(scree_world* world, struct Names* names)
{
	scree_joint joints[FEW];
	scree_field fields[FEW];
	scree_collidable collidables[FEW];
	int count;
	scree_world_get_joints(world, joints, FEW, &count);
	for (int k = 0; k < count && k < FEW; k += 2)
		fuzz_check_status(scree_joint_destroy(world, joints[k]), "scree_joint_destroy");
	scree_world_get_fields(world, fields, FEW, &count);
	for (int k = 0; k < count && k < FEW; k += 2)
		fuzz_check_status(scree_field_destroy(world, fields[k]), "scree_field_destroy");
	scree_body_get_collidables(world, names->bodies[1], collidables, FEW, &count);
	for (int k = 0; k < count && k < FEW; ++k)
		fuzz_check_status(scree_collidable_destroy(world, collidables[k]), "scree_collidable_destroy");
	fuzz_check_status(scree_body_set_type(world, names->bodies[2], SCREE_BODY_STATIC), "scree_body_set_type");
	fuzz_check_status(scree_body_set_enabled(world, names->bodies[3], false), "scree_body_set_enabled");
	fuzz_check_status(scree_body_destroy(world, names->bodies[0]), "scree_body_destroy");
}

void fuzz_use_world(scree_world* world, float dt, int substeps)
{
	static struct Names names;
	const void* bytes;
	size_t size;
	int count;
	memset(names.bodies, 0, sizeof names.bodies);
	scree_world_get_bodies(world, names.bodies, MOST_NAMES, &count);
	for (int k = 0; k < STEPS; ++k)
		step(world, &names, dt, substeps);
	read_world(world, &names);
	destroy_some(world, &names);
	step(world, &names, dt, substeps);
	scree_status status = scree_world_snapshot(world, &bytes, &size);
	fuzz_check_status(status, "scree_world_snapshot");
	if (status == SCREE_OK)
		fuzz_check_status(scree_world_restore(world, bytes, size), "scree_world_restore");
	step(world, &names, dt, substeps);
	read_world(world, &names);
	make_call(world, &names, call_make(CALL_clear));
	step(world, &names, dt, substeps);
}
