// SPDX-License-Identifier: MIT
// device_test.c -- tests a device by small worlds: the hashes of sample_worlds.c must be those of one thread of the
// CPU, in each form of execution that the device uses.
#include "api/world/device_test.h"
#include "api/world/sample_worlds.h"
#include "platform/error.h"
#include "world/create.h"
#include "world/world.h"
#include <stdio.h>

#define STEPS  40
#define HASHES 4 // hashes per world, at equal distances; the first difference is reported

typedef struct
{
	uint64_t hash[HASHES];
} Course;

static scree_status run(scree_world* world, const SampleWorld* sample, Course* course)
{
	TRY(sample->fill(world));
	for (int k = 0; k < STEPS; ++k)
	{
		TRY(scree_world_step(world, 1.0f / 60.0f, 4));
		if ((k + 1) % (STEPS / HASHES) == 0)
			TRY(scree_world_get_hash(world, &course->hash[k / (STEPS / HASHES)]));
	}
	return SCREE_OK;
}

static scree_status run_on_cpu(const SampleWorld* sample, Course* course)
{
	scree_world_def def = scree_world_def_default();
	def.device = "cpu";
	def.threads = 1;
	scree_world* world;
	TRY(scree_world_create(&def, &world));
	scree_status status = run(world, sample, course);
	scree_world_destroy(world);
	return status;
}

// Sets all pools of a device to zero, as they are in a device that was just opened.
static scree_status clear(Backend* b)
{
	size_t most = 0;
	for (int pool = 0; pool < POOL_COUNT; ++pool)
	{
		size_t bytes = pool_info[pool].bytes * (size_t)b->capacity[pool_info[pool].per];
		most = bytes > most ? bytes : most;
	}
	void* zeros = scree_allocate(most);
	if (!zeros)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "no memory to clear a device");
	scree_status status = SCREE_OK;
	for (int pool = 0; pool < POOL_COUNT && status == SCREE_OK; ++pool)
		status = b->f->write(b, (PoolId)pool, 0, b->capacity[pool_info[pool].per], zeros);
	if (status == SCREE_OK)
		status = b->f->wait(b);
	scree_release(zeros);
	return status;
}

static scree_status run_on_device(Backend* b, const SampleWorld* sample, Course* course)
{
	scree_world_def def = scree_world_def_default();
	def.device = b->name;
	scree_world* world;
	TRY(world_create(&def, b, &world));
	scree_status status = run(world, sample, course);
	world->backend = NULL; // the device stays open when the world is destroyed
	scree_world_destroy(world);
	TRY(status);
	return clear(b);
}

// Compares two courses. Returns whether they are equal; if not, writes the first difference.
static bool equal(const SampleWorld* sample, SolveForm form, const Course* expected, const Course* got,
                  WorldsTest* test)
{
	++test->worlds;
	for (int k = 0; k < HASHES && !test->difference[0]; ++k)
		if (got->hash[k] != expected->hash[k])
			snprintf(test->difference, sizeof test->difference,
			         "after %d steps in form %s its world \"%s\" has hash %016llx, that of the CPU %016llx",
			         (k + 1) * (STEPS / HASHES), solve_form_names[form], sample->name, (unsigned long long)got->hash[k],
			         (unsigned long long)expected->hash[k]);
	return !test->difference[0];
}

scree_status test_worlds(Backend* b, WorldsTest* test)
{
	static const SolveForm forms[] = {FORM_ANY, FORM_TILES, FORM_LAUNCHES};
	Course expected[SAMPLE_WORLDS], got;
	*test = (WorldsTest){.worlds = 0};
	for (int k = 0; k < SAMPLE_WORLDS; ++k)
		TRY(run_on_cpu(&sample_worlds[k], &expected[k]));
	for (size_t i = 0; i < sizeof forms / sizeof *forms; ++i)
	{
		if (!b->f->form || !b->f->form(b, forms[i]))
			continue;
		for (int k = 0; k < SAMPLE_WORLDS; ++k)
		{
			TRY(run_on_device(b, &sample_worlds[k], &got));
			if (!equal(&sample_worlds[k], forms[i], &expected[k], &got, test))
				return SCREE_OK;
		}
	}
	return SCREE_OK;
}
