// SPDX-License-Identifier: MIT
// test_recovery.c -- checks that a world whose device fails goes on on the CPU, with saves, recordings and lists.
//
// Formula: hash(world whose device fails) = hash(its twin on the CPU, to which the same calls are made). test_recovery_scenes.c
// has all scenes; test_device_faults.c lets the OpenCL calls of a device fail.
#include "support/allocations.h"
#include "support/fake_gpu.h"
#include "support/faulty_device.h"
#include "support/log_lines.h"
#include "support/recordings.h"
#include "world/recovery/recovery.h"

// Makes the same calls on a world whose device fails and on its twin, which is on the CPU.
typedef struct
{
	scree_world *world, *twin;
	scree_body body; // the same in both
} Pair;

static Pair open_pair(int interval)
{
	Pair pair = {open_on_fake_gpu(interval), open_world(-10.0f), {0, 0}};
	scree_world* both[] = {pair.twin, pair.world};
	for (int k = 0; k < 2; ++k)
	{
		add_floor(both[k]);
		for (int y = 0; y < 5; ++y)
			for (int x = 0; x < 5; ++x)
				pair.body = add_reporter(both[k], box_shape(0.5f, 0.5f), SCREE_REPORT_TOUCHES | SCREE_REPORT_HITS,
				                         1.02f * (float)x, 3.0f + 1.3f * (float)y);
	}
	return pair;
}

#define BOTH(call)                        \
	do                                    \
	{                                     \
		scree_world* world = pair->world; \
		OK(call);                         \
		world = pair->twin;               \
		OK(call);                         \
	} while (0)

static void steps_of(Pair* pair, int steps)
{
	for (int k = 0; k < steps; ++k)
		BOTH(scree_world_step(world, STEP, SUBSTEPS));
}

static void compare(const Pair* pair) { assert_true(hash_of(pair->world) == hash_of(pair->twin)); }

static void close_pair(Pair* pair)
{
	compare(pair);
	assert_string_equal(scree_world_get_device(pair->world), "cpu");
	scree_world_destroy(pair->world);
	scree_world_destroy(pair->twin);
	assert_int_equal(scree_memory(), 0);
}

// Saves from before and after the kept state can be loaded after the failure, whichever was replaced, loaded or discarded.
static void saves_survive(void** state)
{
	(void)state;
	for (int late = 0; late < 12; ++late)
	{
		Pair opened = open_pair(10), *pair = &opened;
		steps_of(pair, 6);
		BOTH(scree_world_save(world, 1));
		BOTH(scree_world_save(world, 2));
		BOTH(scree_body_set_user(world, pair->body, 5));
		BOTH(scree_world_save(world, 3));
		BOTH(scree_world_save(world, 63));
		steps_of(pair, 5); // a state is kept
		for (int k = 0; k < late; ++k)
		{
			if (k == 1)
				BOTH(scree_world_save(world, 2));
			if (k == 3)
				BOTH(scree_world_discard(world, 3));
			if (k == 5)
				BOTH(scree_world_save(world, 4));
			if (k == 7)
				BOTH(scree_world_load(world, 1));
			if (k == 8)
				BOTH(scree_world_save(world, 1));
			if (k == 10)
				BOTH(scree_world_load(world, 4));
			steps_of(pair, 1);
		}
		fake_gpu_falls();
		steps_of(pair, 3);
		compare(pair);
		static const int numbers[] = {2, 1, 63, 4, 3};
		for (size_t k = 0; k < sizeof numbers / sizeof *numbers; ++k)
		{
			scree_status expected = scree_world_load(pair->twin, numbers[k]);
			assert_int_equal(scree_world_load(pair->world, numbers[k]), expected);
			compare(pair);
		}
		close_pair(pair);
	}
}

// A save may be in progress when the device fails.
static void failures_during_saves(void** state)
{
	(void)state;
	for (int calls = 0, fell = 1; fell; ++calls)
	{
		Pair opened = open_pair(10), *pair = &opened;
		steps_of(pair, 3);
		BOTH(scree_world_save(world, 0));
		steps_of(pair, 11);
		BOTH(scree_body_set_user(world, pair->body, 7));
		fake_gpu_falls();
		device_fault.calls_left = calls;
		BOTH(scree_world_save(world, 0));
		BOTH(scree_world_save(world, 1));
		fell = device_fault.calls_left == 0;
		device_fault.calls_left = 0;
		steps_of(pair, 2);
		BOTH(scree_world_load(world, 0));
		compare(pair);
		BOTH(scree_world_load(world, 1));
		close_pair(pair);
	}
}

// A recording of the user goes on, and is repeated with the same hashes.
static void recordings_go_on(void** state)
{
	(void)state;
	for (int calls = 0; calls < 200; calls += 7)
	{
		Pair opened = open_pair(4), *pair = &opened;
		steps_of(pair, 2);
		OK(scree_world_save(pair->world, 9));
		record_hashes(pair->world);
		steps_of(pair, 3);
		fake_gpu_falls();
		device_fault.calls_left = calls;
		steps_of(pair, 6);
		OK(scree_world_load(pair->world, 9)); // recorded as a snapshot
		device_fault.calls_left = 0;
		OK(scree_world_step(pair->world, STEP, SUBSTEPS));
		OK(scree_world_end_recording(pair->world));
		Saved recording = recording_of(pair->world);
		assert_true(repeat_on(recording, def_on("cpu", 1, 1)) == hash_of(pair->world));
		free(recording.bytes);
		scree_world_destroy(pair->twin);
		scree_world_destroy(pair->world);
	}
}

static scree_moved_bodies moved_of(scree_world* world)
{
	scree_moved_bodies list;
	OK(scree_world_get_moved_bodies(world, &list));
	return list;
}

// A read may be the call that meets the failure. It is repeated on the CPU, where reads of several threads run in parallel.
static void reads_meet_the_failure(void** state)
{
	(void)state;
	for (int read = 0; read < 4; ++read)
	{
		Pair opened = open_pair(10), *pair = &opened;
		steps_of(pair, 14);
		BOTH(scree_body_apply_impulse(world, pair->body, (scree_vec){1.0f, 2.0f}));
		fake_gpu_falls();
		scree_pose poses[2];
		scree_velocity velocities[2];
		scree_query_result found[2];
		scree_query_results list;
		int counts[2];
		for (int k = 0; k < 2; ++k)
		{
			scree_world* world = k == 0 ? pair->world : pair->twin;
			if (read == 0)
				OK(scree_body_get_pose(world, pair->body, poses + k));
			else if (read == 1)
				OK(scree_body_get_velocity(world, pair->body, velocities + k));
			else if (read == 2)
				OK(scree_world_cast_ray(world, (scree_vec){0.0f, 20.0f}, (scree_vec){0.0f, -40.0f}, found + k));
			else
				OK(scree_world_overlap_box(world, (scree_box){{-9.0f, -9.0f}, {9.0f, 9.0f}}, &list));
			counts[k] = read == 3 ? list.count : 0;
		}
		assert_true(read != 0 || memcmp(poses, poses + 1, sizeof *poses) == 0);
		assert_true(read != 1 || memcmp(velocities, velocities + 1, sizeof *velocities) == 0);
		assert_true(read != 2 || memcmp(found, found + 1, sizeof *found) == 0);
		assert_int_equal(counts[0], counts[1]);
		steps_of(pair, 3);
		close_pair(pair);
	}
}

// Lists that calls returned stay as they were, and new lists are those of the twin.
static void lists_stay(void** state)
{
	(void)state;
	Pair opened = open_pair(10), *pair = &opened;
	while (events_of(pair->twin).touches_began_count == 0)
		steps_of(pair, 1);
	scree_query_results found;
	OK(scree_world_overlap_box(pair->world, (scree_box){{-50.0f, -50.0f}, {50.0f, 50.0f}}, &found));
	scree_moved_bodies moved = moved_of(pair->world), other = moved_of(pair->twin);
	scree_events events = events_of(pair->world), expected = events_of(pair->twin);
	Saved snapshot = save(pair->world);
	const void* bytes;
	size_t size;
	OK(scree_world_snapshot(pair->world, &bytes, &size));
	assert_true(found.count > 20 && moved.count == other.count && events.touches_began_count > 0);
	Saved copies[] = {copy_of(found.results, sizeof *found.results * (size_t)found.count),
	                  copy_of(moved.bodies, sizeof *moved.bodies * (size_t)moved.count),
	                  copy_of(events.touches_began, sizeof *events.touches_began * (size_t)events.touches_began_count)};
	fake_gpu_falls();
	compare(pair);
	assert_memory_equal(bytes, snapshot.bytes, size);
	assert_memory_equal(found.results, copies[0].bytes, copies[0].size);
	assert_memory_equal(moved.bodies, copies[1].bytes, copies[1].size);
	assert_memory_equal(events.touches_began, copies[2].bytes, copies[2].size);
	events = events_of(pair->world);
	assert_int_equal(events.hit_count, expected.hit_count);
	assert_int_equal(events.touches_began_count, expected.touches_began_count);
	// no body has moved since the last list
	assert_int_equal(moved_of(pair->world).count, moved_of(pair->twin).count);
	steps_of(pair, 1);
	moved = moved_of(pair->world);
	other = moved_of(pair->twin);
	assert_int_equal(moved.count, other.count);
	assert_memory_equal(moved.bodies, other.bodies, sizeof *moved.bodies * (size_t)moved.count);
	for (int k = 0; k < 3; ++k)
		free(copies[k].bytes);
	free(snapshot.bytes);
	close_pair(pair);
}

// A world that has left one device may fail on the next one too.
static void devices_fail_again(void** state)
{
	(void)state;
	Pair opened = open_pair(5), *pair = &opened;
	for (int turn = 0; turn < 3; ++turn)
	{
		int before = warning_count;
		steps_of(pair, 8);
		fake_gpu_falls();
		steps_of(pair, 3);
		assert_int_equal(warning_count, before + 1);
		assert_null(pair->world->recovery->kept.copy);
		become_fake_gpu(pair->world);
	}
	steps_of(pair, 2);
	fake_gpu_falls();
	close_pair(pair);
}

// Without memory the world is broken, and a later call recovers it. No call fails because no state can be kept.
static void memory_runs_out(void** state)
{
	(void)state;
	count_allocations();
	shortage_passes = true;
	int failed = 0;
	for (int allowed = 0, enough = 0; !enough; ++allowed)
	{
		Pair opened = open_pair(4), *pair = &opened;
		steps_of(pair, 6);
		fake_gpu_falls();
		allocations_left = allowed;
		scree_status status = scree_world_step(pair->world, STEP, SUBSTEPS);
		enough = allocations_left >= 0;
		allocations_left = -1;
		if (status != SCREE_OK)
		{
			assert_int_equal(status, SCREE_ERROR_DEVICE_FAILED);
			if (!strstr(scree_error(), "the device fell; the world cannot go on on the CPU: "))
				fail_msg("%s", scree_error());
			++failed;
			OK(scree_world_step(pair->world, STEP, SUBSTEPS));
		}
		OK(scree_world_step(pair->twin, STEP, SUBSTEPS));
		close_pair(pair);
	}
	shortage_passes = false;
	assert_true(failed > 20);
	OK(scree_hooks_set(NULL));
	assert_int_equal(keep_log(NULL), 0);
}

static void states_need_memory(void** state)
{
	(void)state;
	count_allocations();
	for (int allowed = 0; allowed < 12; ++allowed)
	{
		Pair opened = open_pair(4), *pair = &opened;
		steps_of(pair, 3);
		allocations_left = allowed;
		OK(scree_world_step(pair->world, STEP, SUBSTEPS));
		allocations_left = -1;
		OK(scree_world_step(pair->twin, STEP, SUBSTEPS));
		steps_of(pair, 3);
		fake_gpu_falls();
		steps_of(pair, 1);
		close_pair(pair);
	}
	OK(scree_hooks_set(NULL));
	assert_int_equal(keep_log(NULL), 0);
}

// Without the setting, the message names it.
static void setting_is_named(void** state)
{
	(void)state;
	scree_world* world = open_on_fake_gpu(0);
	fake_gpu_falls();
	assert_int_equal(scree_world_step(world, STEP, SUBSTEPS), SCREE_ERROR_DEVICE_FAILED);
	assert_int_equal(scree_world_step(world, STEP, SUBSTEPS), SCREE_ERROR_DEVICE_FAILED);
	assert_non_null(strstr(scree_error(), "scree_world_def.recovery_interval"));
	scree_world_destroy(world);
	scree_world_def def = scree_world_def_default();
	def.recovery_interval = -1;
	assert_int_equal(scree_world_create(&def, &world), SCREE_ERROR_INVALID);
	assert_string_equal(scree_error(), "scree_world_create: def.recovery_interval is -1, must be at least 0");
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(saves_survive),    cmocka_unit_test(failures_during_saves),
	    cmocka_unit_test(recordings_go_on), cmocka_unit_test(reads_meet_the_failure),
	    cmocka_unit_test(lists_stay),       cmocka_unit_test(devices_fail_again),
	    cmocka_unit_test(memory_runs_out),  cmocka_unit_test(states_need_memory),
	    cmocka_unit_test(setting_is_named),
	};
	return cmocka_run_group_tests(tests, keep_log, release_log);
}
