// SPDX-License-Identifier: MIT
// batch_twins.h -- steps worlds of a batch beside the same worlds alone, through resets, pauses, changes of gravity and copies.
#ifndef BATCH_TWINS_H
#define BATCH_TWINS_H
#include "support/batch_checks.h"
#include "support/second_device.h"
#include "support/small_scenes.h"
#include <math.h>
#include <stdlib.h>

#define MOST_WORLDS 40

#define COUNT_OF(array) (int)(sizeof(array) / sizeof *(array))

typedef struct // a way to build a world: a scene, or a level of this file; and the steps that follow
{
	const char* scene; // null: `build` makes the level
	void (*build)(scree_world* world);
	float unit; // scree_world_def.length_unit
	int steps, substeps;
	float dt;
	bool sleeps;                     // scree_world_def.sleep
	void (*end)(scree_world* world); // calls after the last step, without a step behind them; null: none
} Level;

static inline scree_world* build_level(const Level* level)
{
	scree_world* world;
	scree_world_def def = scree_world_def_default();
	Scenario scenario = {.name = NULL};
	if (level->scene)
	{
		scenario = small_scene(level->scene);
		def = scenario.def;
	}
	def.device = "cpu";
	def.threads = 1;
	def.sleep = level->sleeps;
	def.length_unit = level->unit;
	if (level->unit != 0.0f)
		def.gravity = (scree_vec){0.0f, -10.0f * level->unit};
	OK(scree_world_create(&def, &world));
	if (level->scene)
		scenario.build(world, scenario.context);
	else
		level->build(world);
	for (int k = 0; k < level->steps; ++k)
		OK(scree_world_step(world, level->dt, level->substeps));
	if (level->end)
		level->end(world);
	if (level->scene)
		scene_free((Scene*)scenario.context);
	player_close(small_players);
	player_close(small_players + 1);
	return world;
}

// ---------------------------------------------------------------------------------------------------------------
// a batch beside worlds alone
// ---------------------------------------------------------------------------------------------------------------

typedef struct
{
	const Level* levels;
	int level_count, worlds;
	scree_batch* batch;
	scree_world* alone[MOST_WORLDS];
	int level[MOST_WORLDS], next[MOST_WORLDS];          // that of the world, and that after its next reset
	scree_vec gravity[MOST_WORLDS], first[MOST_WORLDS]; // that of the world now, and that of each level
	bool pulled;                                        // gravity of the worlds was set
	bool varied;                                        // worlds get other templates
	uint8_t paused[MOST_WORLDS];
	int rare; // factor for the number of steps between changes
} Twins;

static inline void open_twins(Twins* t, const char* device, int threads, int lanes)
{
	scree_batch_def def = scree_batch_def_default();
	scree_world* templates[MOST_WORLDS];
	for (int k = 0; k < t->level_count; ++k)
		templates[k] = build_level(t->levels + k);
	def.worlds = t->worlds;
	def.templates = templates;
	def.template_count = t->level_count;
	def.device = device;
	def.threads = threads;
	def.lanes = lanes_here(lanes);
	def.other_templates = t->varied;
	OK(scree_batch_create(&def, &t->batch));
	for (int k = 0; k < t->level_count; ++k)
	{
		OK(scree_world_get_gravity(templates[k], t->first + k));
		scree_world_destroy(templates[k]);
	}
	for (int k = 0; k < t->worlds; ++k)
	{
		t->level[k] = t->next[k] = k % t->level_count;
		t->alone[k] = build_level(t->levels + t->level[k]);
		t->gravity[k] = t->first[t->level[k]];
	}
}

static inline void close_twins(Twins* t)
{
	scree_batch_destroy(t->batch);
	for (int k = 0; k < t->worlds; ++k)
		scree_world_destroy(t->alone[k]);
	assert_int_equal(scree_memory(), 0);
}

static inline void compare(const Twins* t, int step)
{
	uint64_t hashes[MOST_WORLDS];
	OK(scree_batch_get_hashes(t->batch, hashes));
	for (int k = 0; k < t->worlds; ++k)
	{
		const Level* level = t->levels + t->level[k];
		if (hashes[k] != hash_of(t->alone[k]))
			fail_msg("step %d, world %d of %d, level %d (%s), gravity %g, %g: hash %016llx, alone %016llx", step, k,
			         t->worlds, t->level[k], level->scene ? level->scene : "own", (double)t->gravity[k].x,
			         (double)t->gravity[k].y, (unsigned long long)hashes[k], (unsigned long long)hash_of(t->alone[k]));
	}
}

// m/s^2: none, of the Earth, sideways, upward, smaller than the smallest float, huge
static const scree_vec choices[] = {{0.0f, 0.0f},   {0.0f, -10.0f}, {7.0f, -3.0f},  {-0.0f, 2.0f},    {0.0f, -1.0e-40f},
                                    {0.0f, -80.0f}, {0.0f, -9.8f},  {-4.0f, -9.0f}, {3.0e5f, 1.0e6f}, {0.0f, -1.6f}};

// Sets a gravity for each world: other ones, the same for all, or that of the templates.
static inline void set_gravity(Twins* t)
{
	int how = random_below(6), same = random_below(2);
	for (int k = 0; k < t->worlds; ++k)
	{
		int most = (int)(sizeof choices / sizeof *choices);
		float unit = t->levels[t->level[k]].unit;
		scree_vec next = choices[how == 1 ? same : random_below(most - (random_below(10) != 0 ? 2 : 0))];
		if (unit != 0.0f)
			next = (scree_vec){unit * next.x, unit * next.y};
		if (how == 0)
			t->gravity[k] = t->first[t->level[k]];
		else if (how == 1 || random_below(3) == 0)
			t->gravity[k] = next;
		OK(scree_world_set_gravity(t->alone[k], t->gravity[k]));
	}
	OK(scree_batch_set_gravity(t->batch, how == 0 ? NULL : t->gravity));
	t->pulled = how != 0;
}

static inline void reset_some(Twins* t)
{
	uint8_t mask[MOST_WORLDS];
	for (int k = 0; k < t->worlds; ++k)
	{
		mask[k] = random_below(8) == 0;
		if (!mask[k])
			continue;
		scree_world_destroy(t->alone[k]);
		t->level[k] = t->next[k];
		t->alone[k] = build_level(t->levels + t->level[k]);
		if (!t->pulled)
			t->gravity[k] = t->first[t->level[k]];
		OK(scree_world_set_gravity(t->alone[k], t->gravity[k]));
		t->paused[k] = 0;
	}
	OK(scree_batch_reset(t->batch, mask));
}

// Chooses templates for the next resets.
static inline void vary_some(Twins* t)
{
	for (int k = 0; k < t->worlds; ++k)
		if (random_below(3) == 0)
			t->next[k] = random_below(t->level_count);
	OK(scree_batch_set_templates(t->batch, t->next));
}

static inline void pause_some(Twins* t)
{
	int most = random_below(3);
	for (int k = 0; k < t->worlds; ++k)
		t->paused[k] = random_below(3) < most;
	OK(scree_batch_pause(t->batch, t->paused));
}

// Loads the state of a world into another one of the same template.
static inline void copy_some(Twins* t)
{
	int32_t from = random_below(t->worlds), to = (from + t->level_count) % t->worlds;
	size_t bytes = scree_batch_get_state_bytes(t->batch);
	if (t->level[to] != t->level[from])
		return;
	char* row = malloc(bytes);
	OK(scree_batch_save(t->batch, &from, 1, row, bytes));
	OK(scree_batch_load(t->batch, &to, 1, row, bytes));
	free(row);
	scree_world_destroy(t->alone[to]);
	t->alone[to] = clone_of(t->alone[from]);
	OK(scree_world_set_gravity(t->alone[to], t->gravity[to]));
}

// Takes a world out; from now on the batch is compared with it.
static inline void take_some(Twins* t)
{
	int k = random_below(t->worlds);
	scree_world* taken;
	OK(scree_batch_extract(t->batch, k, NULL, &taken));
	assert_int_equal(hash_of(taken), hash_of(t->alone[k]));
	scree_world_destroy(t->alone[k]);
	t->alone[k] = taken;
}

static inline void run_twins(Twins* t, int steps)
{
	static const struct
	{
		float dt;
		int substeps;
	} lengths[] = {{STEP, 4}, {STEP, 4}, {STEP, 4}, {STEP / 2, 4}, {STEP, 8}, {0.0f, 1}, {STEP / 3, 1}};
	scree_batch_counters counters[MOST_WORLDS];
	for (int step = 0; step < steps; ++step)
	{
		int length = random_below(4 * t->rare) == 0 ? random_below((int)(sizeof lengths / sizeof *lengths)) : 0;
		if (random_below(4 * t->rare) == 0)
			set_gravity(t);
		if (t->varied && random_below(5 * t->rare) == 0)
			vary_some(t);
		if (random_below(5 * t->rare) == 0)
			reset_some(t);
		if (random_below(5 * t->rare) == 0)
			pause_some(t);
		if (random_below(3 * t->rare) == 0)
			copy_some(t);
		if (random_below(3 * t->rare) == 0)
			take_some(t);
		OK(scree_batch_step(t->batch, lengths[length].dt, lengths[length].substeps, 1));
		OK(scree_batch_get_counters(t->batch, counters));
		for (int k = 0; k < t->worlds; ++k)
			t->paused[k] |= counters[k].crowded > 0; // huge gravity may press a world to too many contacts
		for (int k = 0; k < t->worlds; ++k)
			if (!t->paused[k])
				OK(scree_world_step(t->alone[k], lengths[length].dt, lengths[length].substeps));
		int world = random_below(t->worlds), asleep = counters[world].asleep_bodies;
		if (!t->paused[world] && asleep != counters_of(t->alone[world]).asleep_bodies)
			fail_msg("step %d, world %d: %d bodies sleep, %d alone", step, world, asleep,
			         counters_of(t->alone[world]).asleep_bodies);
		compare(t, step);
	}
}

// varied: worlds get other templates. rare: Twins.rare.
static inline void check_levels(const Level* levels, int count, int worlds, int steps, int rare, bool varied)
{
	const struct
	{
		const char* device;
		int threads, lanes;
	} places[] = {{"cpu", 1, 0}, {"cpu", 2, 1}, {"cpu", 1, 4}, {second_device, 0, 0}};
	for (int k = 0; k < 4; ++k)
	{
		if (!places[k].device[0])
			continue;
		Twins t = {.levels = levels, .level_count = count, .worlds = worlds, .rare = rare, .varied = varied};
		random_state = 17u + (uint32_t)k;
		open_twins(&t, places[k].device, places[k].threads, places[k].lanes);
		compare(&t, -1);
		run_twins(&t, quick() || k == 3 ? steps / 3 : steps);
		close_twins(&t);
	}
}

#endif
