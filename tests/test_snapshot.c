// SPDX-License-Identifier: MIT
// test_snapshot.c -- checks that a world that is restored from a snapshot goes on with the same bits, on any device.
//
// Formula: hash(restored, step) = hash(not stopped, step). Random programs also take and restore snapshots between any
// two calls (tests/programs/run_snapshot.c).
#include "support/make_paths.h"
#include "support/second_device.h"
#include "support/small_scenes.h"
#include "support/snapshots.h"

static scree_world* create_from(Saved saved, const char* device, int threads, int lanes)
{
	scree_world_def def = scree_world_def_default();
	def.device = device;
	def.threads = threads;
	def.lanes = lanes;
	scree_world* world;
	OK(scree_world_create_from(&def, saved.bytes, saved.size, &world));
	return world;
}

// ---------------------------------------------------------------------------------------------------------------
// restored worlds go on
// ---------------------------------------------------------------------------------------------------------------

#define MORE 12 // steps after the snapshot

static void goes_on(const Scenario* scenario)
{
	scree_world_def def = scenario->def;
	def.device = "cpu";
	def.threads = 2;
	scree_world* world;
	OK(scree_world_create(&def, &world));
	scenario->build(world, scenario->context);
	for (int step = 0; step < scenario->steps / 2; ++step)
	{
		if (scenario->act)
			scenario->act(world, step, scenario->context);
		OK(scree_world_step(world, scenario->dt, scenario->substeps));
	}
	uint64_t before = hash_of(world);
	Saved saved = save(world);
	assert_true(hash_of(world) == before);
	scree_world* others[3] = {create_from(saved, "cpu", 1, 1), create_from(saved, "cpu", 3, 0), NULL};
	if (second_device[0])
		others[2] = create_from(saved, second_device, 0, 0);
	for (int step = 0; step < MORE; ++step)
	{
		OK(scree_world_step(world, scenario->dt, scenario->substeps));
		uint64_t hash = hash_of(world);
		for (int k = 0; k < 3 && others[k]; ++k)
		{
			OK(scree_world_step(others[k], scenario->dt, scenario->substeps));
			if (hash_of(others[k]) != hash)
				fail_msg("%s: world %d differs %d steps after the snapshot", scenario->name, k, step + 1);
		}
	}
	uint64_t end = hash_of(world);
	OK(scree_world_restore(world, saved.bytes, saved.size));
	assert_true(hash_of(world) == before);
	assert_snapshot(world, saved);
	for (int step = 0; step < MORE; ++step)
		OK(scree_world_step(world, scenario->dt, scenario->substeps));
	assert_true(hash_of(world) == end);
	for (int k = 0; k < 3 && others[k]; ++k)
		scree_world_destroy(others[k]);
	scree_world_destroy(world);
	free(saved.bytes);
}

static void scenes_go_on(void** state)
{
	(void)state;
	for_every_scene(goes_on);
	assert_int_equal(scree_memory(), 0);
}

// Handles, user data, events of the last step, and joints with their turns are as they were. Handles of later objects
// become invalid, and a slot gets the same handle again.
static void what_is_read_stays(void** state)
{
	(void)state;
	scree_world* world = open_world(-10.0f);
	add_floor(world);
	scree_body_def def = crate_def(world, SCREE_BODY_DYNAMIC, 3.0f, 3.0f);
	def.user = 0x123456789abcdefu;
	scree_body wheel = create_body(world, &def);
	scree_joint_def hinge = joint_def_at(world, SCREE_JOINT_REVOLUTE, NOBODY, wheel, 3.0f, 3.0f, 0.0f);
	hinge.coordinates[SCREE_ANGLE].motor = true;
	hinge.coordinates[SCREE_ANGLE].motor_speed = 20.0f;
	hinge.coordinates[SCREE_ANGLE].motor_max = 1e6f;
	scree_joint joint = add_joint(world, &hinge);
	add_reporter(world, box_shape(0.5f, 0.5f), SCREE_REPORT_TOUCHES, 0.0f, 0.55f);
	int steps = 0;
	scree_events events = events_of(world);
	for (; events.touches_began_count == 0 && steps < 60; ++steps)
	{
		run_steps(world, 1);
		events = events_of(world);
	}
	run_steps(world, 0);
	scree_contact began = events.touches_began[0];
	scree_joint_state turned = joint_state_of(world, joint);
	Saved saved = save(world);
	scree_body later = add_crate(world, SCREE_BODY_DYNAMIC, -5.0f, 4.0f);
	run_steps(world, 30);
	OK(scree_world_restore(world, saved.bytes, saved.size));

	events = events_of(world);
	assert_int_equal(events.touches_began_count, 1);
	assert_memory_equal(events.touches_began, &began, sizeof began);
	scree_joint_state now = joint_state_of(world, joint);
	assert_memory_equal(&now, &turned, sizeof now);
	scree_body_def read = scree_body_def_default();
	OK(scree_body_get_def(world, wheel, &read));
	assert_true(read.user == def.user);
	assert_false(scree_body_is_valid(world, later));
	assert_true(scree_body_equals(add_crate(world, SCREE_BODY_DYNAMIC, -5.0f, 4.0f), later));
	scree_world_destroy(world);
	free(saved.bytes);
}

static void clones_go_their_own_way(void** state)
{
	(void)state;
	scree_world *world = open_pile("cpu", false), *clone;
	run_steps(world, 20);
	OK(scree_world_clone(world, NULL, &clone));
	assert_int_equal(scree_world_get_threads(clone), scree_world_get_threads(world));
	run_steps(clone, 20);
	assert_true(hash_of(clone) == hash_after(40));
	scree_world_destroy(world);
	run_steps(clone, 1);
	scree_world_destroy(clone);
	assert_int_equal(scree_memory(), 0);
}

// A new joint on a short path has the slot, and until the next step the rows, of one that was far along a longer path.
static void new_joints_need_no_rows(void** state)
{
	(void)state;
	scree_world *world = open_world(-10.0f), *clone;
	scree_vec points[21];
	for (int k = 0; k < 21; ++k)
		points[k] = (scree_vec){(float)k, 0.3f * (float)(k % 3)};
	scree_path longest = add_path(world, points, 21, false), shortest = add_path(world, points, 3, false);
	scree_body first = add_disc(world, 0.2f, 15.0f, 0.0f), second = add_disc(world, 0.2f, 1.0f, 0.3f);
	ride(world, longest, first, false);
	run_steps(world, 3);
	OK(scree_body_destroy(world, first));
	ride(world, shortest, second, false);
	Saved saved = save(world);
	OK(scree_world_clone(world, NULL, &clone));
	run_steps(world, 5);
	uint64_t expected = hash_of(world);
	OK(scree_world_restore(world, saved.bytes, saved.size));
	run_steps(world, 5);
	run_steps(clone, 5);
	assert_true(hash_of(world) == expected && hash_of(clone) == expected);
	scree_world_destroy(world);
	scree_world_destroy(clone);
	free(saved.bytes);
	assert_int_equal(scree_memory(), 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(scenes_go_on),
	    cmocka_unit_test(what_is_read_stays),
	    cmocka_unit_test(clones_go_their_own_way),
	    cmocka_unit_test(new_joints_need_no_rows),
	};
	return cmocka_run_group_tests(tests, find_second_device, NULL);
}
