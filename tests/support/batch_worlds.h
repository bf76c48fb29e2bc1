// SPDX-License-Identifier: MIT
// batch_worlds.h -- makes templates for tests of batches, and records their hashes alone.
#ifndef BATCH_WORLDS_H
#define BATCH_WORLDS_H
#include "support/batch_checks.h"
#include "support/second_device.h"
#include "support/small_scenes.h"

#define MOST_TEMPLATES 32
#define AGES           40 // number of steps of a template that are recorded

typedef struct
{
	scree_world* worlds[MOST_TEMPLATES];
	uint64_t hashes[MOST_TEMPLATES][AGES + 1]; // hashes of each template alone, by age
	int count;
	float dt;
	int substeps;
} Templates;

static inline void record_alone(Templates* t)
{
	for (int k = 0; k < t->count; ++k)
		for (int age = 0; age <= AGES; ++age)
		{
			t->hashes[k][age] = hash_of(t->worlds[k]);
			OK(scree_world_step(t->worlds[k], t->dt, t->substeps));
		}
}

static inline void close_templates(Templates* t)
{
	for (int k = 0; k < t->count; ++k)
		scree_world_destroy(t->worlds[k]);
	t->count = 0;
}

typedef struct
{
	const char* device;
	int worlds, threads, lanes;
} Place;

static inline scree_batch* open_batch(Templates* t, const Place* place, int* template_of)
{
	scree_batch_def def = scree_batch_def_default();
	scree_batch* batch;
	def.worlds = place->worlds;
	def.templates = t->worlds;
	def.template_count = t->count;
	def.template_of = template_of;
	def.device = place->device;
	def.threads = place->threads;
	def.lanes = lanes_here(place->lanes);
	for (int k = 0; k < def.worlds; ++k)
		template_of[k] = random_below(t->count);
	OK(scree_batch_create(&def, &batch));
	assert_int_equal(scree_batch_get_worlds(batch), def.worlds);
	return batch;
}

// Compares all worlds with their templates, which record_alone has stepped.
static inline void check_hashes(scree_batch* batch, const Templates* t, const int* template_of, const int* ages,
                                const char* name)
{
	int worlds = scree_batch_get_worlds(batch);
	uint64_t* hashes = malloc(sizeof *hashes * (size_t)worlds);
	OK(scree_batch_get_hashes(batch, hashes));
	for (int k = 0; k < worlds; ++k)
		if (hashes[k] != t->hashes[template_of[k]][ages[k]])
			fail_msg("%s: world %d of %d, template %d, age %d: hash %016llx, alone %016llx", name, k, worlds,
			         template_of[k], ages[k], (unsigned long long)hashes[k],
			         (unsigned long long)t->hashes[template_of[k]][ages[k]]);
	free(hashes);
}

// Opens two templates of a scene: after `first` steps and a few more, or both before their first step.
static inline void open_scene_templates(Templates* t, const Scenario* scenario, int first)
{
	for (t->count = 0; t->count < 2; ++t->count)
		t->worlds[t->count] = scene_world(scenario, first == 0 ? 0 : first + 9 * t->count);
}

static inline scree_world* open_awake(float gravity_y)
{
	scree_world_def def = scree_world_def_default();
	def.device = "cpu";
	def.threads = 1;
	def.gravity.y = gravity_y;
	def.sleep = false;
	return create_world(&def);
}

// Opens a world of boxes that fall on one another, so that contacts become more from step to step.
static inline scree_world* falling_boxes(int boxes)
{
	scree_world* world = open_awake(-10.0f);
	scree_body_def def = crate_def(world, SCREE_BODY_STATIC, 0.0f, -1.0f);
	scree_body body;
	OK(scree_body_create(world, &def, &body));
	for (int k = 0; k < boxes; ++k)
	{
		def = crate_def(world, SCREE_BODY_DYNAMIC, 0.3f * (float)(k % 3), 1.0f + 1.3f * (float)k);
		OK(scree_body_create(world, &def, &body));
	}
	return world;
}

#endif
