// SPDX-License-Identifier: MIT
// test_faults.c -- checks that memory may run out and devices may fail, at every call in turn.
//
// A scenario is a list of acts. It runs once without a fault, which gives the expected hash after every act. Then it
// runs many times with one fault, in each run at a later call than before. The act with the fault must return a status
// and a message. There are two cases. If the world is unchanged, the act is repeated, and the hash at the end is the
// expected one. Otherwise the world is broken and can only be destroyed.
#include "support/allocations.h"
#include "support/fault_acts.h"
#include "support/faulty_device.h"
#include "support/second_device.h"
#include "world/upload/upload.h"
#include "world/world.h"
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static uint64_t expected[FAULT_ACTS]; // hash after each act

static void expect(bool timings)
{
	FaultRun s = {.timings = timings};
	for (int k = 0; k < FAULT_ACTS; ++k)
	{
		OK(fault_acts[k].act(&s));
		expected[k] = hash_of(s.world);
	}
	scree_counters counters = counters_of(s.world);
	assert_true(counters.reallocations > 3 && counters.contacts > 512);
	fault_run_end(&s);
	assert_int_equal(scree_memory(), 0);
}

// ---------------------------------------------------------------------------------------------------------------
// memory runs out
// ---------------------------------------------------------------------------------------------------------------

// Runs the scenario with one failing allocation. device: null for the CPU. allocations: number of allocations that succeed before this one.
// again: true repeats the failed act; false takes a few steps in place of the remaining acts. Returns whether an
// allocation failed. *broken: increased by 1 if the world broke.
static bool run_with_little_memory(const char* device, int allocations, bool again, int* broken)
{
	FaultRun s = {.device = device};
	bool failed = false;
	allocations_left = allocations;
	for (int k = 0; k < FAULT_ACTS; ++k)
	{
		scree_status status = fault_acts[k].act(&s);
		if (status == SCREE_OK)
			continue;
		assert_false(failed);
		failed = true;
		end_of_shortage(status);
		if (!s.world)
		{
			--k;
			continue;
		}
		if (scree_world_wait(s.world) != SCREE_OK)
		{
			check_broken(&s, SCREE_ERROR_OUT_OF_MEMORY);
			++*broken;
			break;
		}
		if (!again)
		{
			run_steps(s.world, 3);
			break;
		}

		// the first calls of the act may have changed the hash
		if (!fault_acts[k].several)
			assert_true(hash_of(s.world) == expected[k - 1]);
		--k;
	}
	allocations_left = -1;
	if (again && s.world && scree_world_wait(s.world) == SCREE_OK)
		assert_true(hash_of(s.world) == expected[FAULT_ACTS - 1]);
	fault_run_end(&s);
	assert_int_equal(scree_memory(), 0);
	return failed;
}

// Returns the distance between the numbers of the failing calls in two successive runs: 1, or 7 in quick builds.
static int stride(void) { return quick() ? 7 : 1; }

static void memory_runs_out(void** state)
{
	(void)state;
	count_allocations();
	expect(false);
	int faults = 0, broken = 0, others = 0, ignored = 0;
	while (run_with_little_memory(NULL, faults, true, &broken))
		faults += stride();
	for (int k = 0; k < faults; k += 4 * stride(), ++others)
		assert_true(run_with_little_memory(NULL, k, false, &ignored));
	print_message("memory ran out in %d places; %d worlds broke\n", faults / stride(), broken);
	assert_true(others > 20 && faults > 100 && broken > 0 && broken < faults);
	OK(scree_hooks_set(NULL));
}

// Worlds on OpenCL devices, which move to the CPU and back. SCREE_FAULTS=all: every allocation fails in turn.
static void memory_runs_out_on_opencl(void** state)
{
	(void)state;
	NEEDS_SECOND_DEVICE();
	const char* chosen = getenv("SCREE_FAULTS");
	int distance = chosen && strcmp(chosen, "all") == 0 ? 1 : 61, at = 0, tried = 0, broken = 0;
	count_allocations();
	expect(false);
	for (; run_with_little_memory(second_device, at, tried % 3 != 0, &broken); at += distance)
		++tried;
	print_message("memory ran out in %d of %d places; %d worlds broke\n", tried, at, broken);
	assert_true(tried > 10 && broken < tried);
	OK(scree_hooks_set(NULL));
}

// ---------------------------------------------------------------------------------------------------------------
// the device fails
// ---------------------------------------------------------------------------------------------------------------

// Runs the scenario with a device that fails. calls: number of calls of the device that succeed before the failure.
// Returns whether an act failed. *broken: increased by 1 if the world broke.
static bool run_with_faulty_device(int calls, int* broken)
{
	FaultRun s = {.timings = device_fault.calls != FAULT_RESIZE};
	BackendFunctions functions;
	device_fault.calls_left = -1;
	bool failed = false;
	for (int k = 0; k < FAULT_ACTS; ++k)
	{
		scree_status status = fault_acts[k].act(&s);
		if (k == 0)
		{
			OK(status);
			functions = faulty_functions(s.world->backend);
			s.world->backend->f = &functions;
			s.world->backend->distant = true;
			device_fault.calls_left = calls;
		}
		if (status == SCREE_OK)
			continue;
		assert_false(failed);
		assert_int_equal(status, device_fault.status);
		assert_non_null(strstr(scree_error(), "the device"));
		failed = true;
		if (status == SCREE_ERROR_DEVICE_FAILED || scree_world_wait(s.world) != SCREE_OK)
		{
			check_broken(&s, status);
			++*broken;
			break;
		}
		assert_true(hash_of(s.world) == expected[k - 1]);
		--k;
	}
	device_fault.calls_left = -1;
	if (!failed || scree_world_wait(s.world) == SCREE_OK)
		assert_true(hash_of(s.world) == expected[FAULT_ACTS - 1]);
	fault_run_end(&s);
	assert_int_equal(scree_memory(), 0);
	return failed;
}

static void device_falls(void** state)
{
	(void)state;
	expect(true);
	device_fault = (Fault){.calls = FAULT_COPY | FAULT_WORK, .status = SCREE_ERROR_DEVICE_FAILED};
	int faults = 0, broken = 0;
	while (run_with_faulty_device(faults, &broken))
		faults += stride();
	print_message("the device fell in %d places\n", faults / stride());
	assert_true(faults > 50);
	assert_int_equal(broken, faults / stride());
}

static void device_memory_runs_out(void** state)
{
	(void)state;
	expect(false);
	device_fault = (Fault){.calls = FAULT_RESIZE, .status = SCREE_ERROR_OUT_OF_MEMORY};
	int faults = 0, broken = 0;
	while (run_with_faulty_device(faults, &broken))
		++faults;
	print_message("the device's memory ran out in %d places; %d worlds broke\n", faults, broken);
	assert_true(faults > 5 && broken > 0 && broken < faults);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(memory_runs_out),
	    cmocka_unit_test(memory_runs_out_on_opencl),
	    cmocka_unit_test(device_falls),
	    cmocka_unit_test(device_memory_runs_out),
	};
	return cmocka_run_group_tests(tests, find_second_device, NULL);
}
