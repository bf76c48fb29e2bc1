// SPDX-License-Identifier: MIT
// test_save.c -- checks that a world that is loaded from a save goes on with the same bits.
//
// Formula: snapshot(loaded) = snapshot(saved), and hash(loaded, step) = hash(not loaded, step). Random programs also save
// and load between any two calls (tests/programs/run_snapshot.c).
#include "support/allocations.h"
#include "support/make_joints.h"
#include "support/second_device.h"
#include "support/small_scenes.h"
#include "support/snapshots.h"

#define FRAMES 4 // steps that are saved, and steps after them

// Loads the last and the first of FRAMES saves, and checks that the world goes on as before.
static void rolls_back_on(const Scenario* scenario, const char* device, int threads)
{
	scree_world_def def = scenario->def;
	uint64_t hashes[2 * FRAMES];
	def.device = device;
	def.threads = threads;
	scree_world* world;
	OK(scree_world_create(&def, &world));
	scenario->build(world, scenario->context);
	for (int step = 0; step < scenario->steps / 2; ++step)
	{
		if (scenario->act)
			scenario->act(world, step, scenario->context);
		OK(scree_world_step(world, scenario->dt, scenario->substeps));
	}
	Saved before = save(world);
	for (int step = 0; step < 2 * FRAMES; ++step)
	{
		if (step < FRAMES)
			OK(scree_world_save(world, step));
		OK(scree_world_step(world, scenario->dt, scenario->substeps));
		hashes[step] = hash_of(world);
	}
	for (int frame = FRAMES - 1; frame >= 0; frame -= FRAMES - 1)
	{
		OK(scree_world_load(world, frame));
		for (int step = frame; step < 2 * FRAMES; ++step)
		{
			OK(scree_world_step(world, scenario->dt, scenario->substeps));
			if (hash_of(world) != hashes[step])
				fail_msg("%s on %s: step %d after save %d differs", scenario->name, device, step, frame);
		}
	}
	OK(scree_world_load(world, 0));
	assert_snapshot(world, before);
	free(before.bytes);
	scree_world_destroy(world);
}

static void rolls_back(const Scenario* scenario)
{
	rolls_back_on(scenario, "cpu", 2);
	if (second_device[0])
		rolls_back_on(scenario, second_device, 0);
}

static void scenes_roll_back(void** state)
{
	(void)state;
	for_every_scene(rolls_back);
	assert_int_equal(scree_memory(), 0);
}

// Objects that were created or destroyed after a save are as they were, and handles too.
static void structure_comes_back(void** state)
{
	(void)state;
	for (int device = 0; device < 2 && (device == 0 || second_device[0]); ++device)
	{
		scree_world* world = open_world_on(device ? second_device : "cpu", 2, -10.0f);
		scree_attribute_def disc = scree_attribute_def_default();
		scree_body_def body_def = crate_def(world, SCREE_BODY_DYNAMIC, 0.0f, 0.0f);
		scree_body bodies[40], more;
		for (int k = 0; k < 40; ++k)
		{
			body_def.pose.position = (scree_vec){(float)(k % 8), 1.1f * (float)(k / 8)};
			body_def.type = k < 8 ? SCREE_BODY_STATIC : SCREE_BODY_DYNAMIC;
			body_def.user = (uint64_t)k;
			OK(scree_body_create(world, &body_def, bodies + k));
		}
		run_steps(world, 20);
		OK(scree_world_save(world, 3));
		Saved before = save(world);
		OK(scree_body_set_user(world, bodies[12], 99));
		OK(scree_body_set_damping(world, bodies[13], 1.0f, 1.0f));
		OK(scree_bodies_destroy(world, bodies + 20, 10));
		OK(scree_shape_make_circle((scree_vec){0.0f, 0.0f}, 0.3f, &disc.shape));
		OK(scree_attribute_create(world, &disc, &body_def.attribute));
		body_def.pose.position = (scree_vec){3.0f, 9.0f};
		for (int k = 0; k < 300; ++k)
			OK(scree_body_create(world, &body_def, &more));
		run_steps(world, 20);
		OK(scree_world_save(world, 4));
		uint64_t later = hash_of(world), user;
		for (int turn = 0; turn < 2; ++turn)
		{
			OK(scree_world_load(world, 3));
			assert_snapshot(world, before);
			OK(scree_body_get_user(world, bodies[12], &user));
			assert_int_equal(user, 12);
			assert_true(scree_body_is_valid(world, bodies[25]));
			assert_false(scree_body_is_valid(world, more));
			OK(scree_world_load(world, 4));
			assert_true(hash_of(world) == later && scree_body_is_valid(world, more));
			assert_false(scree_body_is_valid(world, bodies[25]));
			OK(scree_world_move(world, device ^ turn ? "cpu" : second_device[0] ? second_device : "cpu"));
		}
		free(before.bytes);
		scree_world_destroy(world);
	}
	assert_int_equal(scree_memory(), 0);
}

// A setting of a joint between two static bodies has no effect, but comes back, because one of them may become dynamic.
static void settings_without_effect_come_back(void** state)
{
	(void)state;
	scree_world* world = open_world(-10.0f);
	scree_body_def def = crate_def(world, SCREE_BODY_STATIC, 0.0f, 0.0f);
	scree_body bodies[2];
	OK(scree_body_create(world, &def, bodies));
	def.pose.position.x = 2.0f;
	OK(scree_body_create(world, &def, bodies + 1));
	scree_joint_def hinge = joint_def_at(world, SCREE_JOINT_REVOLUTE, bodies[0], bodies[1], 1.0f, 0.0f, 0.0f);
	hinge.collide_connected = true;
	scree_joint joint = add_joint(world, &hinge);
	OK(scree_world_save(world, 0));
	OK(scree_joint_set_enabled(world, joint, false));
	OK(scree_world_save(world, 1));
	Saved disabled = save(world);
	OK(scree_joint_set_enabled(world, joint, true));
	run_steps(world, 1);
	OK(scree_world_load(world, 1));
	assert_false(scree_joint_is_enabled(world, joint));
	assert_snapshot(world, disabled);
	OK(scree_world_load(world, 0));
	assert_true(scree_joint_is_enabled(world, joint));
	free(disabled.bytes);
	scree_world_destroy(world);
	assert_int_equal(scree_memory(), 0);
}

// A velocity that a body of any type gets after a save leaves no trace in a snapshot after the load.
static void velocities_leave_no_trace(void** state)
{
	(void)state;
	scree_world* world = open_world(0.0f);
	scree_body bodies[3];
	for (int k = 0; k < 3; ++k)
		OK(scree_body_create_box(world, (scree_body_type)k, upright_at(3.0f * (float)k, 0.0f), 0.5f, 0.5f, 0,
		                         bodies + k));
	run_steps(world, 3);
	OK(scree_world_save(world, 0));
	Saved before = save(world);
	for (int k = 0; k < 3; ++k)
		OK(scree_body_set_linear_velocity(world, bodies[k], (scree_vec){1.0f, 2.0f}));
	for (int k = 0; k < 3; ++k)
		OK(scree_body_set_angular_velocity(world, bodies[k], 1.0f));
	OK(scree_world_load(world, 0));
	assert_snapshot(world, before);
	free(before.bytes);
	scree_world_destroy(world);
	assert_int_equal(scree_memory(), 0);
}

// Returns the number of bodies in the list of moved bodies, whose poses are those of the world.
static int moved_in(scree_world* world)
{
	scree_moved_bodies list;
	scree_pose pose;
	OK(scree_world_get_moved_bodies(world, &list));
	for (int k = 0; k < list.count; ++k)
	{
		OK(scree_body_get_pose(world, list.bodies[k].body, &pose));
		assert_memory_equal(&pose, &list.bodies[k].pose, sizeof pose);
	}
	return list.count;
}

// After a load or a restore, the list of moved bodies has those whose poses differ from the last list, whatever was read before
// the save; in a world of a snapshot it has all bodies.
static void moved_bodies_are_those_since_the_last_list(void** state)
{
	(void)state;
	for (int device = 0; device < 2 && (device == 0 || second_device[0]); ++device)
		for (int restores = 0; restores < 2; ++restores)
		{
			scree_world *world = open_world_on(device ? second_device : "cpu", 2, 0.0f), *clone;
			scree_body bodies[3];
			for (int k = 0; k < 3; ++k)
				OK(scree_body_create_box(world, SCREE_BODY_DYNAMIC, upright_at(3.0f * (float)k, 0.0f), 0.5f, 0.5f, 0,
				                         bodies + k));
			assert_int_equal(moved_in(world), 3);
			OK(scree_world_save(world, 0));
			Saved before = save(world);
			OK(scree_body_set_pose(world, bodies[0], upright_at(0.0f, 5.0f)));
			if (restores)
				OK(scree_body_destroy(world, bodies[2])); // its slot has another body, in the same place
			if (restores)
				OK(scree_body_create_box(world, SCREE_BODY_DYNAMIC, upright_at(6.0f, 0.0f), 0.5f, 0.5f, 0, NULL));
			assert_int_equal(moved_in(world), 1 + restores);
			for (int turn = 0; turn < 2; ++turn)
			{
				if (restores && turn == 0)
					OK(scree_world_restore(world, before.bytes, before.size));
				else
					OK(scree_world_load(world, 0));
				assert_int_equal(moved_in(world), turn == 0 ? 1 + restores : 0);
			}
			OK(scree_world_clone(world, NULL, &clone));
			assert_int_equal(moved_in(clone), 3);
			scree_world_destroy(clone);
			free(before.bytes);
			scree_world_destroy(world);
		}
	assert_int_equal(scree_memory(), 0);
}

// A path that is destroyed between two saves does not come back with the second one.
static void paths_end_between_saves(void** state)
{
	(void)state;
	static const scree_vec points[] = {{0.0f, 0.0f}, {1.0f, 1.0f}, {2.0f, 0.0f}};
	scree_world* world = open_world(-10.0f);
	scree_path_def def = scree_path_def_default();
	def.points = points;
	def.count = 3;
	scree_path path;
	OK(scree_path_create(world, &def, &path));
	OK(scree_world_save(world, 0));
	OK(scree_path_destroy(world, path));
	OK(scree_world_save(world, 1));
	uint64_t hash = hash_of(world);
	add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 0.0f);
	OK(scree_world_load(world, 1));
	assert_false(scree_path_is_valid(world, path));
	assert_true(hash_of(world) == hash);
	OK(scree_world_load(world, 0));
	assert_true(scree_path_is_valid(world, path));
	scree_world_destroy(world);
}

// Returns the largest number of bytes of a save: 100 for each body, 60 for each touching contact, 20 for each other contact,
// and 64 for each joint.
static uint64_t most_bytes(scree_world* world)
{
	scree_counters counters;
	int joints;
	OK(scree_world_get_counters(world, &counters));
	OK(scree_world_get_joints(world, NULL, 0, &joints));
	int others = counters.contacts - counters.touching;
	return 100 * (uint64_t)counters.bodies + 60 * (uint64_t)counters.touching + 20 * (uint64_t)others +
	       64 * (uint64_t)joints;
}

static void is_small_on(const Scene* scene, const char* device)
{
	scree_world_def def = scene->world;
	def.device = device;
	scree_world* world;
	OK(scree_world_create(&def, &world));
	build_scene(world, scene);
	uint64_t bytes;
	OK(scree_world_get_save_bytes(world, 7, &bytes));
	assert_int_equal(bytes, 0);
	for (int step = 0; step < 20; ++step)
	{
		OK(scree_world_step(world, scene->dt, scene->substeps));
		if (step < 10) // new contacts take more
			continue;
		OK(scree_world_save(world, 7));
		OK(scree_world_get_save_bytes(world, 7, &bytes));
		if (bytes > most_bytes(world))
			fail_msg("step %d: %llu bytes, must be at most %llu", step, (unsigned long long)bytes,
			         (unsigned long long)most_bytes(world));
	}
	uint64_t before, after;
	OK(scree_world_get_hash(world, &before));
	OK(scree_world_step(world, scene->dt, scene->substeps));
	OK(scree_world_load(world, 7));
	OK(scree_world_get_hash(world, &after));
	assert_int_equal(after, before);
	OK(scree_world_discard(world, 7));
	OK(scree_world_get_save_bytes(world, 7, &bytes));
	assert_int_equal(bytes, 0);
	scree_world_destroy(world);
}

// Saves are small on every device: of a pyramid, of a cloth of springs, and of bodies in flight, most of whose contacts do
// not touch.
static void saves_are_small(void** state)
{
	(void)state;
	const struct
	{
		const char* name;
		SceneSetting settings[3];
	} scenes[] = {{"pyramid", {{"rows", quick() ? "60" : "100"}}},
	              {"cloth", {{NULL, NULL}}},
	              {"storm", {{"columns", "3"}, {"rows", "1"}}}};
	for (size_t k = 0; k < sizeof scenes / sizeof *scenes; ++k)
	{
		Scene* scene = load_scene(scenes[k].name, scenes[k].settings);
		is_small_on(scene, "cpu");
		if (second_device[0])
			is_small_on(scene, second_device);
		scene_free(scene);
	}
}

static void refused(scree_status status, const char* sentence)
{
	assert_int_equal(status, SCREE_ERROR_INVALID);
	assert_string_equal(scree_error(), sentence);
}

// The memory of saves and loads in every step does not grow.
static void memory_stays(void** state)
{
	(void)state;
	scree_world* world = open_pile("cpu", true);
	scree_counters first, last;
	for (int step = 0; step < 200; ++step)
	{
		run_steps(world, 1);
		OK(scree_world_save(world, step % 8));
		OK(scree_world_load(world, step % 8));
		OK(scree_world_get_counters(world, step == 20 ? &first : &last));
	}
	assert_true(last.device_bytes <= first.device_bytes + first.device_bytes / 4);
	scree_world_destroy(world);
}

static void bad_numbers_are_refused(void** state)
{
	(void)state;
	scree_world* world = open_world(-10.0f);
	refused(scree_world_save(world, -1), "scree_world_save: save is -1, must be from 0 to 63");
	refused(scree_world_save(world, SCREE_SAVES), "scree_world_save: save is 64, must be from 0 to 63");
	refused(scree_world_load(world, 5), "scree_world_load: the world has no save 5");
	OK(scree_world_save(world, 5));
	OK(scree_world_load(world, 5));
	refused(scree_world_load(world, 64), "scree_world_load: save is 64, must be from 0 to 63");
	OK(scree_world_discard(world, 5));
	OK(scree_world_discard(world, 5));
	refused(scree_world_load(world, 5), "scree_world_load: the world has no save 5");
	uint64_t bytes;
	refused(scree_world_get_save_bytes(world, 64, &bytes),
	        "scree_world_get_save_bytes: save is 64, must be from 0 to 63");
	refused(scree_world_get_save_bytes(world, 0, NULL), "scree_world_get_save_bytes: bytes is null");
	refused(scree_world_save(NULL, 0), "scree_world_save: world is null");
	scree_world_destroy(world);
}

// Lack of memory changes nothing, whenever it occurs.
static void memory_runs_out(void** state)
{
	(void)state;
	count_allocations();
	scree_world* world = open_world(-10.0f);
	scree_body_def body_def = crate_def(world, SCREE_BODY_DYNAMIC, 0.0f, 0.0f);
	scree_body body;
	Saved small = save(world);
	uint64_t first = hash_of(world);
	for (int k = 0; k < 400; ++k)
		OK(scree_body_create(world, &body_def, &body));
	run_steps(world, 2);
	uint64_t before = hash_of(world);
	int failures = 0;
	for (scree_status status = SCREE_ERROR_OUT_OF_MEMORY; status != SCREE_OK; ++failures)
	{
		allocations_left = failures;
		status = scree_world_save(world, 1);
		allocations_left = -1;
		assert_true(status == SCREE_OK || status == SCREE_ERROR_OUT_OF_MEMORY);
		assert_true(hash_of(world) == before);
	}
	assert_true(failures > 2);
	OK(scree_world_restore(world, small.bytes, small.size)); // in smaller arrays, which the load enlarges
	failures = 0;
	for (scree_status status = SCREE_ERROR_OUT_OF_MEMORY; status != SCREE_OK; ++failures)
	{
		allocations_left = failures;
		status = scree_world_load(world, 1);
		allocations_left = -1;
		assert_true(status == SCREE_OK || status == SCREE_ERROR_OUT_OF_MEMORY);
		assert_true(hash_of(world) == (status == SCREE_OK ? before : first));
	}
	assert_true(failures > 4);
	free(small.bytes);
	scree_world_destroy(world);
	assert_int_equal(scree_memory(), 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(scenes_roll_back),
	    cmocka_unit_test(structure_comes_back),
	    cmocka_unit_test(settings_without_effect_come_back),
	    cmocka_unit_test(velocities_leave_no_trace),
	    cmocka_unit_test(moved_bodies_are_those_since_the_last_list),
	    cmocka_unit_test(paths_end_between_saves),
	    cmocka_unit_test(saves_are_small),
	    cmocka_unit_test(bad_numbers_are_refused),
	    cmocka_unit_test(memory_runs_out),
	    cmocka_unit_test(memory_stays),
	};
	return cmocka_run_group_tests(tests, find_second_device, NULL);
}
