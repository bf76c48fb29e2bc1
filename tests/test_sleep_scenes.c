// SPDX-License-Identifier: MIT
// test_sleep_scenes.c -- checks that whole scenes fall asleep within 10 s after they came to rest, and stay asleep.
//
// A scene is at rest since the last step in which a center of mass moved faster than the threshold. docs/measurements/sleep.md has
// times of Box2D beside those of Scree.
#include "scene/player.h"
#include "support/load_scene.h"
#include "support/make_joints.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define LATEST     10.0 // s: from rest to sleep
#define STAYS      3.0  // s: checked after that
#define MOST       8192 // bodies
#define STACK_HIGH 100

typedef struct
{
	const char* name;
	double most;              // s: time in which the scene comes to rest
	SceneSetting settings[6]; // the list ends at an entry without a name
} Resting;

static const Resting scenes[] = {
    {"pile", 20.0, {{"count", "600"}}},
    {"pyramid", 20.0, {{"rows", "24"}}},
    {"pyramids", 10.0, {{"columns", "4"}, {"rows", "3"}}},
    {"ragdolls", 20.0, {{"columns", "5"}, {"rows", "3"}}},
    {"dominoes", 30.0, {{"lines", "4"}, {"length", "16"}}},
    {"shapes", 20.0, {{NULL, NULL}}},
    {"slope", 40.0, {{NULL, NULL}}},
    {"gears", 40.0, {{"columns", "3"}, {"rows", "2"}}}, // a motor lifts its weights, and stops at a limit
    {"cars", 20.0, {{"roads", "3"}, {"torque", "0"}}},
    {"pond", 90.0, {{"boats", "3"}, {"crates", "12"}, {"fish", "0"}, {"stones", "100"}, {"breeze", "0"}}},
};

typedef struct // world, its bodies, and their states after the last step
{
	scree_world* world;
	scree_body bodies[MOST];
	scree_body_state states[MOST];
} Watch;

// Reads the states. Returns the largest speed of a center of mass in the last step, m/s.
static double watch_speed(Watch* watch, float dt)
{
	static scree_body_state before[MOST];
	int count;
	memcpy(before, watch->states, sizeof before);
	OK(scree_world_get_states(watch->world, watch->bodies, watch->states, MOST, &count));
	double most = 0.0;
	for (int k = 0; k < count; ++k)
	{
		scree_vec a = before[k].pose.position, b = watch->states[k].pose.position;
		most = fmax(most, hypot((double)b.x - (double)a.x, (double)b.y - (double)a.y) / (double)dt);
	}
	return most;
}

static bool all_asleep(scree_world* world)
{
	scree_counters counters = counters_of(world);
	return counters.asleep_bodies == counters.dynamic_bodies;
}

// Takes steps until all bodies sleep; fails if they do not within `most` seconds, or within LATEST of the last motion.
// Then checks that nothing changes for STAYS.
static void check_rest(const char* name, scree_world* world, float dt, int substeps, double most)
{
	Watch* watch = calloc(1, sizeof *watch);
	watch->world = world;
	watch_speed(watch, dt);
	int step = 0, moved = 0;
	for (; step == 0 || !all_asleep(world); ++step)
	{
		OK(scree_world_step(world, dt, substeps));
		if (watch_speed(watch, dt) > 0.05)
			moved = step + 1;
		if ((step - moved) * (double)dt > LATEST || step * (double)dt > most)
			fail_msg("%s: %d bodies are awake after %.1f s, %.1f s after the last motion", name,
			         counters_of(world).dynamic_bodies - counters_of(world).asleep_bodies, step * (double)dt,
			         (step - moved) * (double)dt);
	}
	print_message("%s: %d bodies, last motion at %.2f s, all asleep at %.2f s\n", name,
	              counters_of(world).dynamic_bodies, moved * (double)dt, step * (double)dt);
	uint64_t hash = hash_of(world);
	for (double time = 0.0; time < STAYS; time += (double)dt)
		OK(scree_world_step(world, dt, substeps));
	assert_true(all_asleep(world) && hash_of(world) == hash);
	free(watch);
}

static void scenes_fall_asleep(void** state)
{
	(void)state;
	for (size_t k = 0; k < sizeof scenes / sizeof *scenes; ++k)
	{
		const Resting* resting = scenes + k;
		Scene* scene = load_scene(resting->name, resting->settings);
		scree_world_def def = scene->world;
		def.device = "cpu";
		def.threads = 2;
		def.sleep = true;
		ScenePlayer player;
		OK(player_open(&player, scene, &def));
		check_rest(resting->name, player.world, scene->dt, scene->substeps, resting->most);
		player_close(&player);
		scene_free(scene);
	}
}

static void a_high_stack_falls_asleep(void** state)
{
	(void)state;
	scree_world* world = open_world((float)-G);
	add_floor(world);
	for (int k = 0; k < STACK_HIGH; ++k)
		add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 0.5f + (float)k);
	check_rest("stack of 100", world, STEP, SUBSTEPS, 20.0);
	scree_world_destroy(world);
}

// A rope of 40 links lies over a peg; its ends hang down on both sides.
static void a_rope_over_a_peg_falls_asleep(void** state)
{
	(void)state;
	scree_world* world = open_world((float)-G);
	scree_attribute_def rough = surface_of(circle_shape(1.0f)), link = surface_of(capsule_shape(0.15f, 0.1f));
	rough.friction = 1.0f;
	link.friction = 1.0f;
	add_body(world, SCREE_BODY_STATIC, add_attribute(world, &rough), 0.0f, 0.0f, 0.0f);
	scree_attribute links = add_attribute(world, &link);
	scree_body last = NOBODY;
	for (int k = 0; k < 40; ++k)
	{
		float x = 0.3f * ((float)k - 19.5f);
		scree_body body = add_body(world, SCREE_BODY_DYNAMIC, links, x, 1.2f, 0.0f);
		OK(scree_body_set_damping(world, body, 0.5f, 0.5f));
		if (k > 0)
			join(world, SCREE_JOINT_REVOLUTE, last, body, x - 0.15f, 1.2f);
		last = body;
	}
	check_rest("rope over a peg", world, STEP, SUBSTEPS, 60.0);
	scree_world_destroy(world);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(scenes_fall_asleep),
	    cmocka_unit_test(a_high_stack_falls_asleep),
	    cmocka_unit_test(a_rope_over_a_peg_falls_asleep),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
