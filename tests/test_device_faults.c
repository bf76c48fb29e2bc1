// SPDX-License-Identifier: MIT
// test_device_faults.c -- checks that each OpenCL call may fail, in every way, and that each wait ends.
//
// The acts of fault_acts.def run on an OpenCL device behind fault_layer. In each run one call fails, in the next run a
// later call. The public call that contains it returns a status and names the OpenCL function and the error. The world
// is then either unchanged, and the act is repeated, or broken. No call uses an object of a lost context, all memory
// and all objects of other contexts are released, and a world in another context goes on.
//
// SCREE_FAULTS is the number of runs for each kind of fault; "all": a run for each call.
#include "layer/fault_layer.h"
#include "opencl/verdict.h"
#include "support/environment.h"
#include "support/fault_acts.h"
#include "support/second_device.h"
#include <dlfcn.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define PATIENT 60.0f // s: limit of a wait that must not be reached
#define HASTY   0.4f  // s: limit of a wait for a command that never ends

static FaultLayer* layer;
static uint64_t expected[FAULT_ACTS]; // hash after each act
static scree_world *bystander, *twin; // a world in a context of its own, and the same world on the CPU
static int bystander_objects;         // number of objects of the bystander
static size_t bystander_memory;       // bytes

typedef struct
{
	LayerFault fault;
	cl_int code;
} Kind;

static const Kind kinds[] = {
    {LAYER_ERROR, CL_OUT_OF_HOST_MEMORY},
    {LAYER_ERROR, CL_MEM_OBJECT_ALLOCATION_FAILURE},
    {LAYER_ERROR, CL_BUILD_PROGRAM_FAILURE},
    {LAYER_LOST, CL_OUT_OF_RESOURCES},
    {LAYER_LOST, CL_DEVICE_NOT_AVAILABLE},
    {LAYER_LOST, -9999},
    {LAYER_HANGS, CL_SUCCESS},
};
#define KINDS ((int)(sizeof kinds / sizeof *kinds))

static void begin_fault(Kind kind, int function, long calls)
{
	layer->fault = kind.fault;
	layer->code = kind.code;
	layer->function = function;
	layer->failed = NULL;
	layer->violations = layer->unknown = 0;
	layer->calls_left = layer->fault_at = calls;
}

// Checks what holds after each fault, when the worlds that met it are destroyed.
static void end_fault(void)
{
	layer->calls_left = -1;
	if (layer->violations)
		fail_msg("after the failure of %s, %ld calls, the last of %s", layer->failed, layer->violations,
		         layer->violation);
	assert_int_equal(layer->unknown, 0);
	layer->lose();
	layer->forget();
	assert_int_equal(layer->others, bystander_objects);
	assert_true(layer->programs <= layer->contexts && layer->contexts <= 2);
	assert_int_equal(scree_memory(), bystander_memory);
	run_steps(bystander, 1);
	run_steps(twin, 1);
	assert_true(hash_of(bystander) == hash_of(twin));
}

// Checks the status and the message of the public call that contains the fault. Returns whether the call succeeded.
static bool is_tolerated(scree_status status, const char* act, Kind kind)
{
	bool release = strncmp(layer->failed, "clRelease", 9) == 0; // logged
	if (status == SCREE_OK && (release || kind.fault == LAYER_HANGS))
		return true;
	if (status == SCREE_OK)
		fail_msg("%s succeeds although call %ld, %s, failed", act, layer->fault_at, layer->failed);
	bool named = kind.fault == LAYER_HANGS
	                 ? strstr(scree_error(), "has not ended within") != NULL
	                 : strstr(scree_error(), layer->failed) && strstr(scree_error(), opencl_error_name(kind.code));
	if (!named && !release)
		fail_msg("%s: call %ld, %s, failed, and the message is \"%s\"", act, layer->fault_at, layer->failed,
		         scree_error());
	return false;
}

// Runs the acts with one fault. calls: number of calls before it. Returns whether there was one. *broken: increased by
// 1 if the world broke.
static bool run_with_fault(Kind kind, long calls, int* broken)
{
	FaultRun s = {.device = second_device, .device_timeout = kind.fault == LAYER_HANGS ? HASTY : PATIENT};
	bool seen = false;
	begin_fault(kind, -1, calls);
	for (int k = 0; k < FAULT_ACTS; ++k)
	{
		scree_status status = fault_acts[k].act(&s);
		if (status == SCREE_OK && (seen || !layer->failed))
			continue;
		bool first = !seen;
		seen = true;
		if (first && is_tolerated(status, fault_acts[k].name, kind))
			continue;
		if (kind.fault == LAYER_HANGS)
			layer->lose();
		if (s.world && scree_world_wait(s.world) != SCREE_OK)
		{
			check_broken(&s, SCREE_ERROR_DEVICE_FAILED);
			++*broken;
			break;
		}
		if (s.world && !fault_acts[k].several)
			assert_true(hash_of(s.world) == expected[k - 1]);
		--k;
	}
	if (s.world && scree_world_wait(s.world) == SCREE_OK)
		assert_true(hash_of(s.world) == expected[FAULT_ACTS - 1]);
	bool failed = layer->failed;
	fault_run_end(&s);
	end_fault();
	return failed;
}

static long count_calls(void)
{
	FaultRun s = {.device = second_device, .device_timeout = PATIENT};
	long before = layer->calls;
	for (int k = 0; k < FAULT_ACTS; ++k)
		OK(fault_acts[k].act(&s));
	assert_true(hash_of(s.world) == expected[FAULT_ACTS - 1]);
	fault_run_end(&s);
	return layer->calls - before;
}

static void each_call_fails(void** state)
{
	(void)state;
	NEEDS_SECOND_DEVICE();
	const char* chosen = getenv("SCREE_FAULTS");
	const char* only = getenv("SCREE_FAULT_KIND");
	const char* from = getenv("SCREE_FAULT_FROM");
	long calls = count_calls();
	print_message("%ld calls\n", calls);
	for (int k = 0; k < KINDS; ++k)
	{
		long runs = chosen ? strcmp(chosen, "all") == 0 ? calls : atol(chosen) : 12;
		double step = (double)calls / (double)runs;
		if (only && atoi(only) != k)
			continue;
		int broken = 0, tried = 0;
		for (double at = from ? atof(from) : (double)k * step / KINDS; at < (double)calls; at += step)
			tried += run_with_fault(kinds[k], (long)at, &broken);
		print_message("%s: %d faults; %d worlds broke\n",
		              kinds[k].fault == LAYER_HANGS ? "hangs" : opencl_error_name(kinds[k].code), tried, broken);
	}
}

static int begin(void** state)
{
	void* library = dlopen(FAULT_LAYER, RTLD_NOW | RTLD_LOCAL);
	if (!library)
		fail_msg("%s", dlerror());
	layer = dlsym(library, "fault_layer");
	set_environment("SCREE_OPENCL", FAULT_LAYER);
	find_second_device(state);
	if (!second_device[0])
		return 0;
	FaultRun s = {0};
	for (int k = 0; k < FAULT_ACTS; ++k)
	{
		OK(fault_acts[k].act(&s));
		expected[k] = hash_of(s.world);
	}
	fault_run_end(&s);
	// a context for OpenGL is not shared, even if the device cannot share memory
	const scree_opengl opengl = {.context = &s, .display = &s};
	scree_world_def def = scree_world_def_default();
	def.device = second_device;
	def.opengl = &opengl;
	bystander = create_world(&def);
	def.device = "cpu";
	twin = create_world(&def);
	add_floor(bystander);
	add_floor(twin);
	add_crate(bystander, SCREE_BODY_DYNAMIC, 0.0f, 3.0f);
	add_crate(twin, SCREE_BODY_DYNAMIC, 0.0f, 3.0f);
	run_steps(bystander, 1);
	run_steps(twin, 1);
	bystander_objects = layer->others;
	bystander_memory = scree_memory();
	return 0;
}

static int end(void** state)
{
	(void)state;
	scree_world_destroy(bystander);
	scree_world_destroy(twin);
	return scree_memory() != 0;
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(each_call_fails),
	};
	return cmocka_run_group_tests(tests, begin, end);
}
