// SPDX-License-Identifier: MIT
// test_move.c -- checks that moves of a world between devices, which the user requests, do not change the state of the
// world.
//
// Formula: hash(moved, step) = hash(not moved, step). test_parity.c checks it for every scene. This file checks moves
// at unusual times, and moves that fail.
#include "support/allocations.h"
#include "support/faulty_device.h"
#include "support/second_device.h"
#include "world/device/migrate.h"
#include "world/world.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// ---------------------------------------------------------------------------------------------------------------
// moves by the user
// ---------------------------------------------------------------------------------------------------------------

// A world may move before its first step, and while its device is still computing.
static void moves_in_mid_run(void** state)
{
	(void)state;
	NEEDS_SECOND_DEVICE();
	scree_world* world = open_pile("cpu", false);
	OK(scree_world_move(world, second_device));
	assert_string_equal(scree_world_get_device(world), second_device);
	assert_int_equal(scree_world_get_threads(world), 0);
	run_steps(world, 13);
	OK(scree_world_move(world, "cpu"));
	assert_string_equal(scree_world_get_device(world), "cpu");
	assert_int_equal(scree_world_get_threads(world), 2);
	run_steps(world, 11);
	OK(scree_world_move(world, "cpu"));
	OK(scree_world_move(world, second_device));
	OK(scree_world_move(world, "opencl"));
	run_steps(world, 16);
	assert_true(hash_of(world) == hash_after(40));
	assert_int_equal(counters_of(world).steps, 40);
	scree_world_destroy(world);
	assert_int_equal(scree_memory(), 0);
}

static void* read_all(scree_world* world, size_t* bytes)
{
	typedef struct
	{
		scree_counters counters;
		int bodies, contacts;
		scree_body handles[64];
		scree_pose poses[64];
		scree_velocity velocities[64];
		scree_contact list[256];
	} All;
	All* all = calloc(1, sizeof *all);
	OK(scree_world_get_bodies(world, all->handles, 64, &all->bodies));
	OK(scree_bodies_get_poses(world, all->handles, all->poses, all->bodies));
	OK(scree_bodies_get_velocities(world, all->handles, all->velocities, all->bodies));
	OK(scree_world_get_contacts(world, all->list, 256, &all->contacts));
	all->counters = counters_of(world);
	all->counters.device_bytes = 0;
	assert_true(all->bodies == 38 && all->contacts > 20);
	*bytes = sizeof *all;
	return all;
}

static void what_is_read_stays(void** state)
{
	(void)state;
	NEEDS_SECOND_DEVICE();
	scree_world* world = open_pile("cpu", false);
	run_steps(world, 30);
	size_t bytes;
	void* before = read_all(world, &bytes);
	const char* devices[] = {second_device, "cpu"};
	for (int k = 0; k < 2; ++k)
	{
		OK(scree_world_move(world, devices[k]));
		void* after = read_all(world, &bytes);
		assert_memory_equal(before, after, bytes);
		free(after);
	}
	free(before);
	scree_world_destroy(world);
}

// Makes changes of all kinds, which are pending when the caller moves the world to another device. Creates 40 bodies
// and writes their handles to `made`.
static void change(scree_world* world, scree_body* made)
{
	scree_body bodies[64];
	int count;
	OK(scree_world_get_bodies(world, bodies, 64, &count));
	throw_body(world, bodies[5], 1.0f, 3.0f, 2.0f);
	OK(scree_body_apply_force(world, bodies[6], (scree_vec){30.0f, 5.0f}));
	OK(scree_body_destroy(world, bodies[9]));
	scree_collidable collidable;
	OK(scree_body_get_collidables(world, bodies[12], &collidable, 1, &count));
	scree_filter filter = scree_filter_default();
	filter.mask = 2;
	OK(scree_collidable_set_filter(world, collidable, filter));
	for (int k = 0; k < 40; ++k)
		made[k] = add_box(world, SCREE_BODY_DYNAMIC, 0.3f, 0.2f, 0.7f * (float)(k % 20), 14.0f + (float)(k / 20));
}

static void changes_go_along(void** state)
{
	(void)state;
	NEEDS_SECOND_DEVICE();
	scree_body made[2][40];
	scree_world *still = open_pile("cpu", true), *moved = open_pile("cpu", false);
	run_steps(still, 20);
	run_steps(moved, 20);
	change(still, made[0]);
	change(moved, made[1]);
	OK(scree_world_move(moved, second_device));
	run_steps(still, 30);
	run_steps(moved, 30);
	assert_true(hash_of(still) == hash_of(moved));
	for (int k = 0; k < 40; ++k)
	{
		scree_vec a = position_of(still, made[0][k]), b = position_of(moved, made[1][k]);
		assert_true(a.x == b.x && a.y == b.y);
	}
	OK(scree_bodies_destroy(still, made[0], 40));
	OK(scree_bodies_destroy(moved, made[1], 40));
	OK(scree_world_move(moved, "cpu"));
	run_steps(still, 5);
	run_steps(moved, 5);
	assert_true(hash_of(still) == hash_of(moved));
	scree_world_destroy(still);
	scree_world_destroy(moved);
}

static void check_refused(scree_world* world, const char* device, scree_status expected, const char* words)
{
	uint64_t before = hash_of(world);
	char name[128];
	snprintf(name, sizeof name, "%s", scree_world_get_device(world));
	assert_int_equal(scree_world_move(world, device), expected);
	if (!strstr(scree_error(), words))
		fail_msg("\"%s\" is not in: %s", words, scree_error());
	assert_string_equal(scree_world_get_device(world), name);
	assert_true(hash_of(world) == before);
}

static void bad_moves_change_nothing(void** state)
{
	(void)state;
	scree_world* world = open_pile("cpu", true);
	run_steps(world, 10);
	assert_int_equal(scree_world_move(NULL, "cpu"), SCREE_ERROR_INVALID);
	check_refused(world, NULL, SCREE_ERROR_INVALID, "scree_world_move: device is null");
	check_refused(world, "gpu", SCREE_ERROR_INVALID, "scree_world_move: device is \"gpu\", must be");
	check_refused(world, "opencl:", SCREE_ERROR_INVALID, "scree_world_move: device is \"opencl:\"");
	check_refused(world, "opencl:no such device", SCREE_ERROR_NO_DEVICE, "");
	run_steps(world, 10);
	assert_true(hash_of(world) == hash_after(20));

	world->broken = SCREE_ERROR_DEVICE_FAILED;
	assert_int_equal(scree_world_move(world, "cpu"), SCREE_ERROR_DEVICE_FAILED);
	assert_non_null(strstr(scree_error(), "scree_world_move: the device of this world has failed"));
	scree_world_destroy(world);
}

// ---------------------------------------------------------------------------------------------------------------
// moves that fail midway
// ---------------------------------------------------------------------------------------------------------------

static void memory_runs_out(void** state)
{
	(void)state;
	NEEDS_SECOND_DEVICE();
	count_allocations();
	scree_world* world = open_pile(second_device, false);
	run_steps(world, 20);
	uint64_t hash = hash_of(world);
	int faults = 0;
	for (;; ++faults)
	{
		allocations_left = faults;
		scree_status status = scree_world_move(world, "cpu");
		allocations_left = -1;
		if (status == SCREE_OK)
			break;
		assert_int_equal(status, SCREE_ERROR_OUT_OF_MEMORY);
		assert_string_equal(scree_world_get_device(world), second_device);
		assert_true(hash_of(world) == hash);
	}
	assert_true(faults > 20);
	run_steps(world, 10);
	assert_true(hash_of(world) == hash_after(30));
	scree_world_destroy(world);
	assert_int_equal(scree_memory(), 0);
	OK(scree_hooks_set(NULL));
}

// Makes each call of the new device fail in turn. The world stays on the old device and continues on it.
static void new_device_falls(void** state)
{
	(void)state;
	scree_world* world = open_pile("cpu", true);
	Backend* from = world->backend;
	run_steps(world, 20);
	uint64_t hash = hash_of(world);
	BackendOptions options = {.threads = 1};
	device_fault = (Fault){.calls = FAULT_RESIZE | FAULT_COPY, .lasts = true, .status = SCREE_ERROR_DEVICE_FAILED};
	int faults = 0;
	for (bool moved = false; !moved; ++faults)
	{
		Backend* to;
		OK(cpu_open(&options, &to));
		BackendFunctions f = faulty_functions(to);
		to->f = &f;
		device_fault.calls_left = faults;
		moved = world_move(world, to) == SCREE_OK;
		to->f = real_functions;
		Backend* left = moved ? from : to;
		left->f->close(left);
		assert_ptr_equal(world->backend, moved ? to : from);
		assert_true(hash_of(world) == hash);
	}
	print_message("the new device fell in %d places\n", faults - 1);
	assert_true(faults > 40);
	run_steps(world, 10);
	assert_true(hash_of(world) == hash_after(30));
	scree_world_destroy(world);
	assert_int_equal(scree_memory(), 0);
}

// Makes each call of the old device fail in turn. The world cannot continue after such a failure.
static void old_device_falls(void** state)
{
	(void)state;
	BackendOptions options = {.threads = 1};
	device_fault = (Fault){.calls = FAULT_RESIZE | FAULT_COPY, .lasts = true, .status = SCREE_ERROR_DEVICE_FAILED};
	for (int calls = 0;; ++calls)
	{
		scree_world* world = open_pile("cpu", true);
		run_steps(world, 20);
		Backend *from = world->backend, *to;
		BackendFunctions f = faulty_functions(from);
		OK(cpu_open(&options, &to));
		from->f = &f;
		device_fault.calls_left = calls;
		scree_status status = world_move(world, to);
		from->f = real_functions;
		if (status == SCREE_OK)
			from->f->close(from);
		else
		{
			assert_int_equal(status, SCREE_ERROR_DEVICE_FAILED);
			to->f->close(to);
			assert_ptr_equal(world->backend, from);
			assert_int_equal(scree_world_step(world, STEP, SUBSTEPS), SCREE_ERROR_DEVICE_FAILED);
		}
		if (status == SCREE_OK)
		{
			run_steps(world, 10);
			assert_true(hash_of(world) == hash_after(30));
		}
		scree_world_destroy(world);
		if (status == SCREE_OK)
			break;
	}
	assert_int_equal(scree_memory(), 0);
}

// Moves a world between two devices that share no memory with the host, such as two GPUs.
static void far_to_far(void** state)
{
	(void)state;
	scree_world* world = open_pile("cpu", true);
	run_steps(world, 20);
	BackendOptions options = {.threads = 1};
	Backend *from = world->backend, *to;
	OK(cpu_open(&options, &to));
	BackendFunctions f = distant_functions(to);
	from->f = to->f = &f;
	OK(world_move(world, to));
	from->f->close(from);
	run_steps(world, 20);
	assert_true(hash_of(world) == hash_after(40));
	scree_world_destroy(world);
	assert_int_equal(scree_memory(), 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(moves_in_mid_run), cmocka_unit_test(what_is_read_stays),
	    cmocka_unit_test(changes_go_along), cmocka_unit_test(bad_moves_change_nothing),
	    cmocka_unit_test(memory_runs_out),  cmocka_unit_test(new_device_falls),
	    cmocka_unit_test(old_device_falls), cmocka_unit_test(far_to_far),
	};
	return cmocka_run_group_tests(tests, find_second_device, NULL);
}
