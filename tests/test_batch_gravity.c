// SPDX-License-Identifier: MIT
// test_batch_gravity.c -- checks worlds of a batch whose gravity, lengths of substeps, paths and materials differ.
//
// Formula: after any sequence of steps, resets, pauses and changes of gravity, hash(world in a batch) = hash(the same world alone
// after the same sequence), where alone a reset builds the world again, and scree_world_set_gravity sets its gravity.
#include "support/batch_checks.h"
#include "support/make_joints.h"
#include "support/make_paths.h"
#include "support/second_device.h"
#include "support/small_scenes.h"
#include <math.h>

#define MOST_WORLDS 40

// ---------------------------------------------------------------------------------------------------------------
// levels
// ---------------------------------------------------------------------------------------------------------------

typedef struct // a way to build a world: a scene, or a level of this file; and the steps that follow
{
	const char* scene; // null: `build` makes the level
	void (*build)(scree_world* world);
	float unit; // scree_world_def.length_unit
	int steps, substeps;
	float dt;
} Level;

// Elastic and small bodies, a kinematic one, and a heavy plate on many balls, which is a hub.
static void build_toys(scree_world* world)
{
	scree_attribute ball = add_surface(world, circle_shape(0.2f), 0.5f, 0.9f);
	scree_attribute grain = add_surface(world, box_shape(0.004f, 0.004f), 0.5f, 0.0f);
	add_floor(world);
	for (int k = 0; k < 8; ++k)
		add_body(world, SCREE_BODY_DYNAMIC, ball, 0.5f * (float)k, 0.4f + 0.3f * (float)k, 0.0f);
	for (int k = 0; k < 8; ++k)
		add_body(world, SCREE_BODY_DYNAMIC, grain, -1.0f - 0.005f * (float)(k % 2), 0.0041f + 0.0081f * (float)k, 0.0f);
	for (int k = 0; k < 40; ++k)
		add_disc(world, 0.1f, 10.0f + 0.21f * (float)k, 0.1f);
	add_box(world, SCREE_BODY_DYNAMIC, 4.4f, 0.2f, 14.1f, 0.41f);
	throw_body(world, add_box(world, SCREE_BODY_KINEMATIC, 0.5f, 0.2f, -4.0f, 0.21f), 1.0f, 0.0f, 0.0f);
}

// Two bodies that follow a path. high: m, height of the path.
static void add_ride(scree_world* world, float high)
{
	scree_vec points[9];
	for (int k = 0; k < 9; ++k)
		points[k] = (scree_vec){(float)k, high + 0.3f * (float)(k % 3)};
	scree_path path = add_path(world, points, 9, false);
	ride(world, path, add_wagon(world, path, 2.0f, 0.3f, 1.0f), true);
	ride(world, path, add_crate(world, SCREE_BODY_DYNAMIC, 6.0f, high + 0.1f), false);
}

static void build_ride(scree_world* world)
{
	add_floor(world);
	add_ride(world, 3.0f);
}

static void build_rides(scree_world* world)
{
	add_ride(world, 5.0f);
	add_ride(world, -5.0f);
	add_crate(world, SCREE_BODY_STATIC, 6.0f, 4.0f);
}

// Crates of materials, of which pairs set friction, restitution and tangent speed, or ignore one another.
static void add_materials(scree_world* world, int first, bool ignored)
{
	scree_attribute attributes[3];
	for (int k = 0; k < 3; ++k)
	{
		scree_attribute_def def = surface_of(box_shape(0.5f, 0.5f));
		def.material = first + k;
		attributes[k] = add_attribute(world, &def);
	}
	for (int k = 0; k < 9; ++k)
		add_body(world, k < 3 ? SCREE_BODY_STATIC : SCREE_BODY_DYNAMIC, attributes[k < 3 ? 0 : k % 3],
		         1.0f * (float)(k % 3) + 0.1f * (float)(k / 3), 1.2f * (float)(k / 3), 0.0f);
	scree_material_pair pair = scree_material_pair_default();
	pair.restitution = 0.7f;
	pair.friction = 0.1f;
	OK(scree_world_set_material_pair(world, first, first + 1, &pair));
	pair.tangent_speed = 2.0f;
	pair.ignored = ignored;
	OK(scree_world_set_material_pair(world, first, first + 2, &pair));
}
static void build_materials(scree_world* world) { add_materials(world, 0, false); }
static void build_ghosts(scree_world* world) { add_materials(world, 40, true); }

static scree_world* build_level(const Level* level)
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
	def.sleep = false;
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
	scree_vec gravity[MOST_WORLDS], first[MOST_WORLDS]; // that of the world now, and that of its template
	uint8_t paused[MOST_WORLDS];
} Twins;

static void open_twins(Twins* t, const char* device, int threads, int lanes)
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
	def.lanes = lanes;
	OK(scree_batch_create(&def, &t->batch));
	for (int k = 0; k < t->level_count; ++k)
		scree_world_destroy(templates[k]);
	for (int k = 0; k < t->worlds; ++k)
	{
		t->alone[k] = build_level(t->levels + k % t->level_count);
		OK(scree_world_get_gravity(t->alone[k], t->first + k));
		t->gravity[k] = t->first[k];
	}
}

static void close_twins(Twins* t)
{
	scree_batch_destroy(t->batch);
	for (int k = 0; k < t->worlds; ++k)
		scree_world_destroy(t->alone[k]);
	assert_int_equal(scree_memory(), 0);
}

static void compare(const Twins* t, int step)
{
	uint64_t hashes[MOST_WORLDS];
	OK(scree_batch_get_hashes(t->batch, hashes));
	for (int k = 0; k < t->worlds; ++k)
	{
		const Level* level = t->levels + k % t->level_count;
		if (hashes[k] != hash_of(t->alone[k]))
			fail_msg("step %d, world %d of %d, level %d (%s), gravity %g, %g: hash %016llx, alone %016llx", step, k,
			         t->worlds, k % t->level_count, level->scene ? level->scene : "own", (double)t->gravity[k].x,
			         (double)t->gravity[k].y, (unsigned long long)hashes[k], (unsigned long long)hash_of(t->alone[k]));
	}
}

// m/s^2: none, of the Earth, sideways, upward, smaller than the smallest float, huge
static const scree_vec choices[] = {{0.0f, 0.0f},   {0.0f, -10.0f}, {7.0f, -3.0f},  {-0.0f, 2.0f},    {0.0f, -1.0e-40f},
                                    {0.0f, -80.0f}, {0.0f, -9.8f},  {-4.0f, -9.0f}, {3.0e5f, 1.0e6f}, {0.0f, -1.6f}};

// Sets a gravity for each world: other ones, the same for all, or that of the templates.
static void set_gravity(Twins* t)
{
	int how = random_below(6), same = random_below(2);
	for (int k = 0; k < t->worlds; ++k)
	{
		int most = (int)(sizeof choices / sizeof *choices);
		float unit = t->levels[k % t->level_count].unit;
		scree_vec next = choices[how == 1 ? same : random_below(most - (random_below(10) != 0 ? 2 : 0))];
		if (unit != 0.0f)
			next = (scree_vec){unit * next.x, unit * next.y};
		if (how == 0)
			t->gravity[k] = t->first[k];
		else if (how == 1 || random_below(3) == 0)
			t->gravity[k] = next;
		OK(scree_world_set_gravity(t->alone[k], t->gravity[k]));
	}
	OK(scree_batch_set_gravity(t->batch, how == 0 ? NULL : t->gravity));
}

static void reset_some(Twins* t)
{
	uint8_t mask[MOST_WORLDS];
	for (int k = 0; k < t->worlds; ++k)
	{
		mask[k] = random_below(8) == 0;
		if (!mask[k])
			continue;
		scree_world_destroy(t->alone[k]);
		t->alone[k] = build_level(t->levels + k % t->level_count);
		OK(scree_world_set_gravity(t->alone[k], t->gravity[k]));
		t->paused[k] = 0;
	}
	OK(scree_batch_reset(t->batch, mask));
}

static void pause_some(Twins* t)
{
	int most = random_below(3);
	for (int k = 0; k < t->worlds; ++k)
		t->paused[k] = random_below(3) < most;
	OK(scree_batch_pause(t->batch, t->paused));
}

static void run_twins(Twins* t, int steps)
{
	static const struct
	{
		float dt;
		int substeps;
	} lengths[] = {{STEP, 4}, {STEP, 4}, {STEP, 4}, {STEP / 2, 4}, {STEP, 8}, {0.0f, 1}, {STEP / 3, 1}};
	scree_batch_counters counters[MOST_WORLDS];
	for (int step = 0; step < steps; ++step)
	{
		int length = random_below(4) == 0 ? random_below((int)(sizeof lengths / sizeof *lengths)) : 0;
		if (random_below(4) == 0)
			set_gravity(t);
		if (random_below(5) == 0)
			reset_some(t);
		if (random_below(5) == 0)
			pause_some(t);
		OK(scree_batch_step(t->batch, lengths[length].dt, lengths[length].substeps, 1));
		OK(scree_batch_get_counters(t->batch, counters));
		for (int k = 0; k < t->worlds; ++k)
			t->paused[k] |= counters[k].crowded > 0; // huge gravity may press a world to too many contacts
		for (int k = 0; k < t->worlds; ++k)
			if (!t->paused[k])
				OK(scree_world_step(t->alone[k], lengths[length].dt, lengths[length].substeps));
		compare(t, step);
	}
}

static void check_levels(const Level* levels, int count, int worlds, int steps)
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
		Twins t = {.levels = levels, .level_count = count, .worlds = worlds};
		random_state = 17u + (uint32_t)k;
		open_twins(&t, places[k].device, places[k].threads, places[k].lanes);
		compare(&t, -1);
		run_twins(&t, quick() || k == 3 ? steps / 3 : steps);
		close_twins(&t);
	}
}

#define COUNT_OF(array) (int)(sizeof(array) / sizeof *(array))

// Worlds of many kinds, whose templates had substeps of other lengths, or no step.
static void gravity_may_differ(void** state)
{
	(void)state;
	static const Level levels[] = {
	    {.build = build_toys},
	    {.build = build_toys, .steps = 40, .dt = STEP, .substeps = 4},
	    {.scene = "bridge", .steps = 20, .dt = STEP, .substeps = 2},
	    {.scene = "chains", .steps = 10, .dt = STEP, .substeps = 4},
	    {.scene = "pyramids", .steps = 30, .dt = STEP, .substeps = 4},
	    {.scene = "ragdolls", .steps = 25, .dt = STEP / 2, .substeps = 4},
	    {.scene = "machine", .steps = 12, .dt = STEP, .substeps = 8},
	    {.scene = "windmill", .steps = 9, .dt = STEP, .substeps = 4},
	    {.scene = "washer", .steps = 30, .dt = STEP, .substeps = 4},
	    {.scene = "tumbler", .steps = 30, .dt = STEP, .substeps = 3},
	    {.scene = "coaster", .steps = 5, .dt = STEP, .substeps = 4},
	    {.scene = "gears"},
	};
	check_levels(levels, COUNT_OF(levels), COUNT_OF(levels) + 5, 60);
}

// Tables of paths and pairs of materials of several templates, beside templates without.
static void tables_may_differ(void** state)
{
	(void)state;
	static const Level levels[] = {
	    {.build = build_ride, .steps = 3, .dt = STEP, .substeps = 4},
	    {.build = build_materials, .steps = 8, .dt = STEP, .substeps = 4},
	    {.build = build_toys, .steps = 8, .dt = STEP, .substeps = 4},
	    {.build = build_rides, .steps = 8, .dt = STEP, .substeps = 2},
	    {.build = build_ghosts},
	    {.scene = "platforms", .steps = 30, .dt = STEP, .substeps = 4},
	};
	check_levels(levels, COUNT_OF(levels), 2 * COUNT_OF(levels) + 1, 90);
}

// Gravity is in the unit of length of each world's template.
static void units_may_differ(void** state)
{
	(void)state;
	static const Level levels[] = {
	    {.build = build_toys, .unit = 4.0f, .steps = 4, .dt = STEP, .substeps = 4},
	    {.build = build_toys},
	    {.build = build_toys, .unit = 3.0f, .steps = 2, .dt = STEP, .substeps = 4},
	};
	check_levels(levels, COUNT_OF(levels), 9, 40);
}

static void bad_gravity_is_refused(void** state)
{
	(void)state;
	static const Level levels[] = {{.build = build_ride, .steps = 2, .dt = STEP, .substeps = 4},
	                               {.build = build_toys, .unit = 4.0f, .steps = 2, .dt = STEP, .substeps = 4}};
	Twins t = {.levels = levels, .level_count = 2, .worlds = 4};
	open_twins(&t, "cpu", 1, 0);
	scree_vec bad[4] = {{1.0f, 2.0f}, {0.0f, 0.0f}, {0.0f, NAN}, {0.0f, 0.0f}};
	assert_int_equal(scree_batch_set_gravity(t.batch, bad), SCREE_ERROR_INVALID);
	assert_string_equal(scree_error(), "scree_batch_set_gravity: gravity[2].y is nan, must be finite");
	assert_int_equal(scree_batch_set_gravity(NULL, bad), SCREE_ERROR_INVALID);
	assert_string_equal(scree_error(), "scree_batch_set_gravity: batch is null");
	run_twins(&t, 10); // nothing has changed
	close_twins(&t);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(gravity_may_differ),
	    cmocka_unit_test(tables_may_differ),
	    cmocka_unit_test(units_may_differ),
	    cmocka_unit_test(bad_gravity_is_refused),
	};
	return cmocka_run_group_tests(tests, find_second_device, NULL);
}
