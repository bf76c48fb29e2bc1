// SPDX-License-Identifier: MIT
// test_auto.c -- worlds that move between devices, by the user's will and by the clock's: nobody can tell by their state.
//
// The formula: hash(moved, step) = hash(not moved, step). test_parity.c holds every scene to it; here are the ways in
// which a move can go wrong, and when device "auto" moves.
#include "move.h"
#include "world.h" // before cmocka, which makes a macro of fail
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "support.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// the name of an OpenCL device that keeps equal bits, empty when there is none
static char other[128];

static int find_other(void** state)
{
	(void)state;
	scree_device devices[MAX_WAYS];
	int count;
	OK(scree_get_devices(devices, MAX_WAYS, &count));
	for (int k = 1; k < count && k < MAX_WAYS && !other[0]; ++k)
		if (devices[k].equal_bits)
			snprintf(other, sizeof other, "%s", devices[k].name);
	return 0;
}

#define NEEDS_OTHER() \
	if (!other[0])    \
	skip()

// A pyramid of boxes with a circle above, in motion after 20 steps.
static scree_world* open_pile(const char* device, bool alone)
{
	scree_world_def def = scree_default_world_def();
	def.device = device;
	def.threads = alone ? 1 : 2;
	scree_world* world;
	OK(scree_create_world(&def, &world));
	add_floor(world);
	for (int row = 0; row < 8; ++row)
		for (int k = 0; k < 8 - row; ++k)
			add_box(world, SCREE_DYNAMIC, 0.5f, 0.5f, 1.05f * (float)k + 0.5f * (float)row, 0.5f + (float)row);
	scree_attribute_def circle = surface_of(circle_shape(0.4f));
	circle.restitution = 0.5f;
	add_body(world, SCREE_DYNAMIC, add_attribute(world, &circle), 4.0f, 12.0f, 0.0f);
	return world;
}

static uint64_t hash_after(int steps)
{
	scree_world* world = open_pile("cpu", true);
	run_steps(world, steps);
	uint64_t hash = hash_of(world);
	scree_destroy_world(world);
	return hash;
}

// ---------------------------------------------------------------------------------------------------------------
// moves by the user
// ---------------------------------------------------------------------------------------------------------------

// A device may be at work when the world leaves it, and there may be no world yet to speak of.
static void moves_in_mid_run(void** state)
{
	(void)state;
	NEEDS_OTHER();
	scree_world* world = open_pile("cpu", false);
	OK(scree_move_world(world, other));
	assert_string_equal(scree_world_device(world), other);
	assert_int_equal(scree_world_threads(world), 0);
	run_steps(world, 13);
	OK(scree_move_world(world, "cpu"));
	assert_string_equal(scree_world_device(world), "cpu");
	assert_int_equal(scree_world_threads(world), 2);
	run_steps(world, 11);
	OK(scree_move_world(world, "cpu"));
	OK(scree_move_world(world, other));
	OK(scree_move_world(world, "opencl"));
	run_steps(world, 16);
	assert_true(hash_of(world) == hash_after(40));
	assert_int_equal(counters_of(world).steps, 40);
	scree_destroy_world(world);
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
	OK(scree_get_bodies(world, all->handles, 64, &all->bodies));
	OK(scree_get_poses(world, all->handles, all->poses, all->bodies));
	OK(scree_get_velocities(world, all->handles, all->velocities, all->bodies));
	OK(scree_get_contacts(world, all->list, 256, &all->contacts));
	OK(scree_get_counters(world, &all->counters));
	all->counters.device_bytes = 0;
	assert_true(all->bodies == 38 && all->contacts > 20);
	*bytes = sizeof *all;
	return all;
}

static void what_is_read_stays(void** state)
{
	(void)state;
	NEEDS_OTHER();
	scree_world* world = open_pile("cpu", false);
	run_steps(world, 30);
	size_t bytes;
	void* before = read_all(world, &bytes);
	const char* devices[] = {other, "cpu"};
	for (int k = 0; k < 2; ++k)
	{
		OK(scree_move_world(world, devices[k]));
		void* after = read_all(world, &bytes);
		assert_memory_equal(before, after, bytes);
		free(after);
	}
	free(before);
	scree_destroy_world(world);
}

// All kinds of changes, on their way to one device when the world goes to another.
static void change(scree_world* world, scree_body* made)
{
	scree_body bodies[64];
	int count;
	OK(scree_get_bodies(world, bodies, 64, &count));
	OK(scree_body_set_velocity(world, bodies[5], (scree_velocity){{1.0f, 3.0f}, 2.0f}));
	OK(scree_body_apply_force(world, bodies[6], (scree_vec){30.0f, 5.0f}));
	OK(scree_destroy_body(world, bodies[9]));
	scree_collidable collidable;
	OK(scree_get_collidables(world, bodies[12], &collidable, 1, &count));
	scree_filter filter = scree_default_filter();
	filter.mask = 2;
	OK(scree_collidable_set_filter(world, collidable, filter));
	for (int k = 0; k < 40; ++k)
		made[k] = add_box(world, SCREE_DYNAMIC, 0.3f, 0.2f, 0.7f * (float)(k % 20), 14.0f + (float)(k / 20));
}

static void changes_go_along(void** state)
{
	(void)state;
	NEEDS_OTHER();
	scree_body made[2][40];
	scree_world *still = open_pile("cpu", true), *moved = open_pile("cpu", false);
	run_steps(still, 20);
	run_steps(moved, 20);
	change(still, made[0]);
	change(moved, made[1]);
	OK(scree_move_world(moved, other));
	run_steps(still, 30);
	run_steps(moved, 30);
	assert_true(hash_of(still) == hash_of(moved));
	for (int k = 0; k < 40; ++k)
	{
		scree_vec a = position_of(still, made[0][k]), b = position_of(moved, made[1][k]);
		assert_true(a.x == b.x && a.y == b.y);
	}
	OK(scree_destroy_bodies(still, made[0], 40));
	OK(scree_destroy_bodies(moved, made[1], 40));
	OK(scree_move_world(moved, "cpu"));
	run_steps(still, 5);
	run_steps(moved, 5);
	assert_true(hash_of(still) == hash_of(moved));
	scree_destroy_world(still);
	scree_destroy_world(moved);
}

static void check_refused(scree_world* world, const char* device, scree_status expected, const char* words)
{
	uint64_t before = hash_of(world);
	char name[128];
	snprintf(name, sizeof name, "%s", scree_world_device(world));
	assert_int_equal(scree_move_world(world, device), expected);
	if (!strstr(scree_error(), words))
		fail_msg("\"%s\" is not in: %s", words, scree_error());
	assert_string_equal(scree_world_device(world), name);
	assert_true(hash_of(world) == before);
}

static void bad_moves_change_nothing(void** state)
{
	(void)state;
	scree_world* world = open_pile("cpu", true);
	run_steps(world, 10);
	assert_int_equal(scree_move_world(NULL, "cpu"), SCREE_INVALID);
	check_refused(world, NULL, SCREE_INVALID, "scree_move_world: device is null");
	check_refused(world, "gpu", SCREE_INVALID, "scree_move_world: device is \"gpu\", must be");
	check_refused(world, "opencl:", SCREE_INVALID, "scree_move_world: device is \"opencl:\"");
	check_refused(world, "opencl:no such device", SCREE_NO_DEVICE, "");
	run_steps(world, 10);
	assert_true(hash_of(world) == hash_after(20));

	world->broken = SCREE_DEVICE_FAILED;
	assert_int_equal(scree_move_world(world, "cpu"), SCREE_DEVICE_FAILED);
	assert_non_null(strstr(scree_error(), "scree_move_world: the device of this world has failed"));
	scree_destroy_world(world);
}

// ---------------------------------------------------------------------------------------------------------------
// moves that fail half way
// ---------------------------------------------------------------------------------------------------------------

static int allocations_left; // negative: as many as you like

static void* counting_allocate(size_t bytes, size_t alignment, void* context)
{
	(void)context;
	if (allocations_left == 0)
		return NULL;
	allocations_left -= allocations_left > 0;
	return aligned_alloc(alignment, bytes);
}

static void plain_release(void* memory, void* context)
{
	(void)context;
	free(memory);
}

static void memory_runs_out(void** state)
{
	(void)state;
	NEEDS_OTHER();
	scree_hooks hooks = {.allocate = counting_allocate, .release = plain_release};
	allocations_left = -1;
	OK(scree_set_hooks(&hooks));
	scree_world* world = open_pile(other, false);
	run_steps(world, 20);
	uint64_t hash = hash_of(world);
	int faults = 0;
	for (;; ++faults)
	{
		allocations_left = faults;
		scree_status status = scree_move_world(world, "cpu");
		allocations_left = -1;
		if (status == SCREE_OK)
			break;
		assert_int_equal(status, SCREE_OUT_OF_MEMORY);
		assert_string_equal(scree_world_device(world), other);
		assert_true(hash_of(world) == hash);
	}
	assert_true(faults > 20);
	run_steps(world, 10);
	assert_true(hash_of(world) == hash_after(30));
	scree_destroy_world(world);
	assert_int_equal(scree_memory(), 0);
	OK(scree_set_hooks(NULL));
}

static const BackendFunctions* real; // of the CPU
static int calls_left;               // of the device that fails
static scree_status call_status;

static scree_status call_fails(void)
{
	return calls_left-- > 0 ? SCREE_OK : (fail)(call_status, "the device has fallen");
}

static scree_status faulty_resize(Backend* b, Per per, int capacity)
{
	scree_status status = call_fails();
	return status ? status : real->resize(b, per, capacity);
}

static scree_status faulty_write(Backend* b, PoolId pool, int first, int count, const void* items)
{
	scree_status status = call_fails();
	return status ? status : real->write(b, pool, first, count, items);
}

static scree_status faulty_read(Backend* b, PoolId pool, int first, int count, void* items)
{
	scree_status status = call_fails();
	return status ? status : real->read(b, pool, first, count, items);
}

// A CPU that calls like these reach, as if it were far away.
static BackendFunctions far_away(Backend* b, bool faulty)
{
	real = b->f;
	BackendFunctions f = *real;
	f.address = NULL;
	f.spare = NULL;
	if (faulty)
	{
		f.resize = faulty_resize;
		f.write = faulty_write;
		f.read = faulty_read;
	}
	return f;
}

// The device that the world goes to fails in each of its calls in turn: the world stays, and goes on.
static void new_device_falls(void** state)
{
	(void)state;
	scree_world* world = open_pile("cpu", true);
	Backend* from = world->backend;
	run_steps(world, 20);
	uint64_t hash = hash_of(world);
	BackendOptions options = {.threads = 1};
	call_status = SCREE_DEVICE_FAILED;
	int faults = 0;
	for (bool moved = false; !moved; ++faults)
	{
		Backend* to;
		OK(cpu_open(&options, &to));
		BackendFunctions f = far_away(to, true);
		to->f = &f;
		calls_left = faults;
		moved = world_move(world, to) == SCREE_OK;
		to->f = real;
		Backend* left = moved ? from : to;
		left->f->close(left);
		assert_ptr_equal(world->backend, moved ? to : from);
		assert_true(hash_of(world) == hash);
	}
	print_message("the new device fell in %d places\n", faults - 1);
	assert_true(faults > 40);
	run_steps(world, 10);
	assert_true(hash_of(world) == hash_after(30));
	scree_destroy_world(world);
	assert_int_equal(scree_memory(), 0);
}

// The device that the world leaves fails: nothing is left to go on with.
static void old_device_falls(void** state)
{
	(void)state;
	BackendOptions options = {.threads = 1};
	call_status = SCREE_DEVICE_FAILED;
	for (int calls = 0;; ++calls)
	{
		scree_world* world = open_pile("cpu", true);
		run_steps(world, 20);
		Backend *from = world->backend, *to;
		BackendFunctions f = far_away(from, true);
		OK(cpu_open(&options, &to));
		from->f = &f;
		calls_left = calls;
		scree_status status = world_move(world, to);
		from->f = real;
		if (status == SCREE_OK)
			from->f->close(from);
		else
		{
			assert_int_equal(status, SCREE_DEVICE_FAILED);
			to->f->close(to);
			assert_ptr_equal(world->backend, from);
			assert_int_equal(scree_step(world, STEP, SUBSTEPS), SCREE_DEVICE_FAILED);
		}
		if (status == SCREE_OK)
		{
			run_steps(world, 10);
			assert_true(hash_of(world) == hash_after(30));
		}
		scree_destroy_world(world);
		if (status == SCREE_OK)
			break;
	}
	assert_int_equal(scree_memory(), 0);
}

// Neither device's memory is the host's, as between two GPUs.
static void far_to_far(void** state)
{
	(void)state;
	scree_world* world = open_pile("cpu", true);
	run_steps(world, 20);
	BackendOptions options = {.threads = 1};
	Backend *from = world->backend, *to;
	OK(cpu_open(&options, &to));
	BackendFunctions f = far_away(to, false);
	from->f = to->f = &f;
	OK(world_move(world, to));
	from->f->close(from);
	run_steps(world, 20);
	assert_true(hash_of(world) == hash_after(40));
	scree_destroy_world(world);
	assert_int_equal(scree_memory(), 0);
}

// ---------------------------------------------------------------------------------------------------------------
// moves by the clock
// ---------------------------------------------------------------------------------------------------------------

static char said[4][512]; // the last sentences of the log
static int said_count;

static void note(scree_log_level level, const char* sentence, void* context)
{
	(void)level;
	(void)context;
	snprintf(said[said_count++ % 4], sizeof said[0], "%s", sentence);
}

static bool was_said(const char* words)
{
	for (int k = 0; k < 4; ++k)
		if (strstr(said[k], words))
			return true;
	return false;
}

static int set_log(void** state)
{
	(void)state;
	scree_hooks hooks = {.log = note};
	memset(said, 0, sizeof said);
	said_count = 0;
	return scree_set_hooks(&hooks);
}

static int reset_log(void** state)
{
	(void)state;
	unsetenv("SCREE_AUTO");
	return scree_set_hooks(NULL) || scree_memory() > 0;
}

// Steps until a trial has begun; returns how many.
static int run_to_trial(scree_world* world)
{
	int steps = 0;
	while (!world->automatic.trial && steps < 100)
	{
		run_steps(world, 1);
		++steps;
	}
	assert_true(world->automatic.trial);
	assert_string_equal(scree_world_device(world), other);
	return steps;
}

// The CPU, were it as slow as this, would lose; then the other device does.
static void trial_decides(void** state)
{
	(void)state;
	NEEDS_OTHER();
	setenv("SCREE_AUTO", other, 1);
	scree_world* world = open_pile("auto", false);
	int steps = run_to_trial(world);
	world->automatic.meters[0].step = 1e6;
	run_steps(world, 30);
	assert_string_equal(scree_world_device(world), other);
	assert_false(world->automatic.trial);
	assert_true(was_said("the world moves to opencl:") && was_said("ms a step, and 1000000.0000 ms on cpu"));

	// the CPU is tried again when the world has worked for long enough
	world->automatic.spent = 1e9;
	run_steps(world, 1);
	assert_string_equal(scree_world_device(world), "cpu");
	assert_true(world->automatic.trial);
	world->automatic.meters[1].step = 0.0;
	run_steps(world, 10);
	assert_string_equal(scree_world_device(world), other);
	assert_true(was_said("the world does not stay on cpu"));
	assert_int_equal(world->automatic.failures, 1);

	world->automatic.spent = 1e9;
	run_steps(world, 1);
	world->automatic.meters[1].step = 1e6;
	run_steps(world, 10);
	assert_string_equal(scree_world_device(world), "cpu");
	assert_int_equal(world->automatic.failures, 0);
	assert_true(hash_of(world) == hash_after(steps + 52));
	scree_destroy_world(world);
}

static void world_goes_back(void** state)
{
	(void)state;
	NEEDS_OTHER();
	setenv("SCREE_AUTO", other, 1);
	scree_world* world = open_pile("auto", false);
	int steps = run_to_trial(world);
	world->automatic.meters[0].step = 0.0;
	run_steps(world, 20);
	assert_string_equal(scree_world_device(world), "cpu");
	assert_true(was_said("the world does not stay on opencl:"));

	// the next one waits for many times what this one cost
	assert_true(world->automatic.cost > 0.0);
	assert_true(world->automatic.failures == 1);
	assert_false(world->automatic.trial);
	assert_true(hash_of(world) == hash_after(steps + 20));
	scree_destroy_world(world);
}

// What gains nothing from a GPU does not open one.
static void small_world_stays(void** state)
{
	(void)state;
	scree_world* world = open_pile("auto", false);
	run_steps(world, 60);
	assert_string_equal(scree_world_device(world), "cpu");
	assert_null(world->automatic.opening);
	assert_null(world->automatic.other);
	assert_int_equal(said_count, 0);
	assert_true(hash_of(world) == hash_after(60));
	scree_destroy_world(world);
}

static void other_is_missing(void** state)
{
	(void)state;
	setenv("SCREE_AUTO", "opencl:no such device", 1);
	scree_world* world = open_pile("auto", false);
	run_steps(world, 20);
	assert_string_equal(scree_world_device(world), "cpu");
	assert_true(was_said("scree_step: the world stays on the CPU: "));
	assert_int_equal(said_count, 1);
	scree_destroy_world(world);

	setenv("SCREE_AUTO", "cpu", 1);
	world = open_pile("auto", false);
	run_steps(world, 20);
	assert_int_equal(said_count, 1);
	scree_destroy_world(world);
}

// A device that fails while the world goes there is left alone from then on.
static void other_falls(void** state)
{
	(void)state;
	scree_world* world = open_pile("auto", true);
	run_steps(world, 10);
	BackendOptions options = {.threads = 1};
	Backend* to;
	OK(cpu_open(&options, &to));
	BackendFunctions f = far_away(to, true);
	to->f = &f;
	to->distant = true;
	call_status = SCREE_OUT_OF_MEMORY;
	calls_left = 20;
	snprintf(world->automatic.named, sizeof world->automatic.named, "%s", "opencl:X");
	world->automatic.other = to;
	run_steps(world, 10);
	assert_string_equal(scree_world_device(world), "cpu");
	assert_true(world->automatic.alone && !world->automatic.trial && !world->automatic.other);
	assert_true(was_said("scree_step: the world stays on cpu: the device has fallen"));
	assert_true(hash_of(world) == hash_after(20));
	scree_destroy_world(world);
}

// The user's word ends the choice by the clock, and gives it back.
static void user_decides(void** state)
{
	(void)state;
	NEEDS_OTHER();
	setenv("SCREE_AUTO", other, 1);
	scree_world* world = open_pile("auto", false);
	int steps = run_to_trial(world);
	OK(scree_move_world(world, "cpu"));
	assert_false(world->automatic.on);
	assert_null(world->automatic.other);
	run_steps(world, 20);
	assert_string_equal(scree_world_device(world), "cpu");
	OK(scree_move_world(world, "auto"));
	OK(scree_move_world(world, "auto"));
	steps += run_to_trial(world);
	OK(scree_move_world(world, other));
	assert_false(world->automatic.on);
	run_steps(world, 20);
	assert_string_equal(scree_world_device(world), other);

	// from there the way back is open as well
	OK(scree_move_world(world, "auto"));
	while (!world->automatic.trial && steps < 1000)
	{
		run_steps(world, 1);
		++steps;
	}
	world->automatic.meters[1].step = 1e6;
	run_steps(world, 10);
	assert_string_equal(scree_world_device(world), "cpu");
	assert_true(hash_of(world) == hash_after(steps + 50));
	scree_destroy_world(world);
}

// A world may end while a device is being opened for it.
static void opening_is_waited_for(void** state)
{
	(void)state;
	NEEDS_OTHER();
	for (int moved = 0; moved < 2; ++moved)
	{
		scree_world* world = open_pile("auto", false);
		world->automatic.opening = opening_begin(&world->def, other);
		assert_non_null(world->automatic.opening);
		if (moved)
			OK(scree_move_world(world, "cpu"));
		scree_destroy_world(world);
		assert_int_equal(scree_memory(), 0);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(moves_in_mid_run),
	    cmocka_unit_test(what_is_read_stays),
	    cmocka_unit_test(changes_go_along),
	    cmocka_unit_test(bad_moves_change_nothing),
	    cmocka_unit_test(memory_runs_out),
	    cmocka_unit_test(new_device_falls),
	    cmocka_unit_test(old_device_falls),
	    cmocka_unit_test(far_to_far),
	    cmocka_unit_test_setup_teardown(trial_decides, set_log, reset_log),
	    cmocka_unit_test_setup_teardown(world_goes_back, set_log, reset_log),
	    cmocka_unit_test_setup_teardown(small_world_stays, set_log, reset_log),
	    cmocka_unit_test_setup_teardown(other_is_missing, set_log, reset_log),
	    cmocka_unit_test_setup_teardown(other_falls, set_log, reset_log),
	    cmocka_unit_test_setup_teardown(user_decides, set_log, reset_log),
	    cmocka_unit_test(opening_is_waited_for),
	};
	return cmocka_run_group_tests(tests, find_other, NULL);
}
