// SPDX-License-Identifier: MIT
// test_device_faults.c -- checks that each OpenCL call may fail, in every way, and that each wait ends.
//
// The acts of fault_acts.def run on an OpenCL device behind fault_layer. In each run one call fails, in the next run a
// later call. Without recovery, the public call that contains it returns a status and names the OpenCL function and the
// error. The world is then either unchanged, and the act is repeated, or broken. With recovery, the world goes on on the CPU
// to the hash of a world whose device never failed, and logs one line. In both cases no call uses an object of a lost context,
// all memory and all objects of other contexts are released, and a world in another context goes on.
//
// SCREE_FAULTS is the number of calls of each function that fail in each way; "all": each call, and every 97th of
// clSetKernelArg.
#include "layer/fault_layer.h"
#include "opencl/compile.h"
#include "opencl/device_name.h"
#include "opencl/verdict.h"
#include "support/environment.h"
#include "support/fault_acts.h"
#include "support/second_device.h"
#include "world/world.h"
#include <dlfcn.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define PATIENT 60.0f // s: limit of a wait that must not be reached
#define HASTY   0.4f  // s: limit of a wait for a command that never ends

#define AUTO_FAULTS 12 // number of kernel launches that fail in worlds with device "auto"

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
    {LAYER_FAILS, CL_OUT_OF_RESOURCES},
};
#define KINDS ((int)(sizeof kinds / sizeof *kinds))

static char warnings[4096]; // log since the last fault

static void note_log(scree_log_level level, const char* text, void* context)
{
	(void)context;
	(void)level;
	size_t length = strlen(warnings);
	snprintf(warnings + length, sizeof warnings - length, "%s\n", text);
}

static void begin_fault(Kind kind, int function, long calls)
{
	layer->fault = kind.fault;
	layer->code = kind.code;
	layer->function = function;
	layer->failed = NULL;
	warnings[0] = '\0';
	layer->violations = layer->unknown = 0;
	layer->calls_left = layer->fault_at = calls;
}

static scree_status open_one(scree_world** world, float timeout)
{
	scree_world_def def = scree_world_def_default();
	def.device = second_device;
	def.device_timeout = timeout;
	return scree_world_create(&def, world);
}

// Checks what holds after each fault, when the worlds that met it are destroyed.
static void end_fault(void)
{
	layer->calls_left = -1;
	scree_world* next;
	// commands may hang after the last wait of a world; the next world of the context finds out
	if (layer->fault >= LAYER_HANGS && open_one(&next, HASTY) == SCREE_OK)
		scree_world_destroy(next);
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

// Returns whether the function that failed describes devices or platforms, and the machine has several. The failure then
// excludes only one of them.
static bool is_of_another_device(void)
{
	scree_device devices[8];
	int count;
	OK(scree_devices_get(devices, 8, &count));
	return count > 2 && (strstr(layer->failed, "clGetDeviceInfo") || strstr(layer->failed, "clGetPlatformInfo") ||
	                     strstr(layer->failed, "clGetDeviceIDs"));
}

// Checks the status and the message of the public call that contains the fault. Returns whether the call succeeded.
static bool is_tolerated(scree_status status, const char* act, Kind kind)
{
	bool logged = strstr(warnings, layer->failed);
	if (status == SCREE_OK && (logged || kind.fault >= LAYER_HANGS || is_of_another_device()))
		return true;
	if (status == SCREE_OK)
		fail_msg("%s succeeds although call %ld, %s, failed", act, layer->fault_at, layer->failed);
	const char* error = kind.fault == LAYER_HANGS ? "has not ended within" : opencl_error_name(kind.code);
	const char* function = kind.fault >= LAYER_HANGS ? "clGetEventInfo" : layer->failed;
	bool named = strstr(scree_error(), error) && strstr(scree_error(), function);
	if (!named && !logged)
		fail_msg("%s: call %ld, %s, failed, and the message is \"%s\"", act, layer->fault_at, layer->failed,
		         scree_error());
	return false;
}

static const char recovered[] = "the world goes on on the CPU";

// Checks that the log has one line for a world that has left its device; a release that fails has a line of its own. Returns
// whether the world left.
static bool is_recovered(void)
{
	int lines = 0;
	for (const char* at = warnings; *at; at = strchr(at, '\n') + 1)
		lines += strncmp(at, "clRelease", strlen("clRelease")) != 0;
	if (strstr(warnings, recovered) && lines != 1)
		fail_msg("a world recovers, and the log has %d lines:\n%s", lines, warnings);
	return strstr(warnings, recovered);
}

typedef struct // numbers of runs
{
	int tried, functions, broken, recovered;
} Outcomes;

// Runs the acts with one fault. calls: number of calls of the function before it. interval: as in scree_world_def. Returns whether
// there was one.
static bool run_with_fault(Kind kind, int function, long calls, int interval, Outcomes* outcomes)
{
	FaultRun s = {.device = second_device,
	              .device_timeout = kind.fault == LAYER_HANGS ? HASTY : PATIENT,
	              .recovery_interval = interval};
	bool seen = false;
	begin_fault(kind, function, calls);
	for (int k = 0; k < FAULT_ACTS; ++k)
	{
		scree_status status = fault_acts[k].act(&s);
		if (status == SCREE_OK && (seen || !layer->failed))
			continue;
		bool first = !seen;
		seen = true;
		if (first && is_tolerated(status, fault_acts[k].name, kind))
			continue;
		layer->lose();
		// other acts open another device, whose failure does not break the world
		if (status == SCREE_ERROR_DEVICE_FAILED && s.world && !fault_acts[k].opens)
		{
			if (interval > 0)
				fail_msg("%s: the world does not recover: %s", fault_acts[k].name, scree_error());
			assert_int_equal(s.world->broken, status);
		}
		if (s.world && scree_world_wait(s.world) != SCREE_OK)
		{
			if (interval > 0)
				fail_msg("after %s the world does not recover: %s", fault_acts[k].name, scree_error());
			check_broken(&s, SCREE_ERROR_DEVICE_FAILED);
			++outcomes->broken;
			break;
		}
		if (s.world && !fault_acts[k].several)
			assert_true(hash_of(s.world) == expected[k - 1]);
		--k;
	}
	if (s.world && scree_world_wait(s.world) == SCREE_OK)
		assert_true(hash_of(s.world) == expected[FAULT_ACTS - 1]);
	bool failed = layer->failed;
	outcomes->recovered += is_recovered();
	outcomes->tried += failed;
	fault_run_end(&s);
	end_fault();
	return failed;
}

// Sets calls[] to the number of calls of each function in a run without a fault.
static void count_calls(long calls[LAYER_FUNCTIONS], int interval)
{
	FaultRun s = {.device = second_device, .device_timeout = PATIENT, .recovery_interval = interval};
	long before[LAYER_FUNCTIONS];
	memcpy(before, layer->calls_of, sizeof before);
	for (int k = 0; k < FAULT_ACTS; ++k)
		OK(fault_acts[k].act(&s));
	assert_true(hash_of(s.world) == expected[FAULT_ACTS - 1]);
	fault_run_end(&s);
	for (int f = 0; f < LAYER_FUNCTIONS; ++f)
		calls[f] = layer->calls_of[f] - before[f];
}

// Returns the number of calls of a function that fail in the test, of `calls`.
static long sites_of(int function, long calls)
{
	const char* chosen = getenv("SCREE_FAULTS");
	long most = chosen ? atol(chosen) : 1;
	if (chosen && strcmp(chosen, "all") == 0)
		most = function == LAYER_SetKernelArg ? calls / 97 : calls;
	return most < calls ? most : calls;
}

static Outcomes fail_each_call(int interval)
{
	bool all = getenv("SCREE_FAULTS");
	long calls[LAYER_FUNCTIONS];
	Outcomes outcomes = {0};
	count_calls(calls, interval);
	for (int f = 0; f < LAYER_FUNCTIONS; ++f)
	{
		long sites = sites_of(f, calls[f]);
		outcomes.functions += sites > 0;
		for (long k = 0; k < sites; ++k)
			for (int kind = 0; kind < KINDS; ++kind)
				// without SCREE_FAULTS a function has one kind of fault
				if (all || kind == (f + (int)k) % KINDS)
					run_with_fault(kinds[kind], f, (2 * k + 1) * calls[f] / (2 * sites), interval, &outcomes);
	}
	print_message("%d faults in %d functions; %d worlds broke, %d went on on the CPU\n", outcomes.tried,
	              outcomes.functions, outcomes.broken, outcomes.recovered);
	return outcomes;
}

static void each_call_fails(void** state)
{
	(void)state;
	NEEDS_SECOND_DEVICE();
	Outcomes o = fail_each_call(0);
	assert_true(o.functions > 25 && o.broken > 5 && o.broken < o.tried && o.recovered == 0);
}

// Worlds go on on the CPU.
static void worlds_recover(void** state)
{
	(void)state;
	NEEDS_SECOND_DEVICE();
	Outcomes o = fail_each_call(4);
	assert_true(o.functions > 20 && o.recovered > 5 && o.broken == 0);
}

// Steps a world on the device "auto", which moves between the CPU and the second device. Returns its hash.
static uint64_t run_auto(const char* device, long calls)
{
	scree_world* world;
	scree_world_def def = scree_world_def_default();
	def.device = device;
	def.recovery_interval = 3;
	OK(scree_world_create(&def, &world));
	add_floor(world);
	for (int k = 0; k < 40; ++k)
		add_reporter(world, box_shape(0.5f, 0.5f), SCREE_REPORT_TOUCHES, (float)(k % 8), 0.6f + 1.01f * (float)(k / 8));
	begin_fault(kinds[3], LAYER_EnqueueNDRangeKernel, calls);
	run_steps(world, 25);
	uint64_t hash = hash_of(world);
	is_recovered();
	scree_world_destroy(world);
	return hash;
}

static void auto_recovers(void** state)
{
	(void)state;
	NEEDS_SECOND_DEVICE();
	uint64_t without = run_auto("cpu", -1);
	end_fault();
	set_environment("SCREE_AUTO", second_device);
	const long* now = layer->calls_of + LAYER_EnqueueNDRangeKernel;
	long before = *now;
	assert_true(run_auto("auto", -1) == without);
	long calls = *now - before;
	end_fault();
	int recoveries = 0;
	for (int k = 0; k < AUTO_FAULTS; ++k)
	{
		assert_true(run_auto("auto", k * calls / AUTO_FAULTS) == without);
		recoveries += strstr(warnings, recovered) != NULL;
		end_fault();
	}
	print_message("%d of %d worlds with device auto recovered\n", recoveries, AUTO_FAULTS);
	assert_true(recoveries > 2);
	set_environment("SCREE_AUTO", NULL);
}

// Opens a device that has no verdict and is therefore tested, with one fault. The next world is created and can step.
static void open_with_fault(Kind kind, long calls)
{
	scree_world* world;
	verdict_forget();
	begin_fault(kind, -1, calls);
	scree_status status = open_one(&world, kind.fault == LAYER_HANGS ? HASTY : PATIENT);
	assert_true((status == SCREE_OK) == (world != NULL));
	if (layer->failed)
		is_tolerated(status, "scree_world_create", kind);
	scree_world_destroy(world);
	end_fault();
	OK(open_one(&world, PATIENT));
	run_steps(world, 1);
	scree_world_destroy(world);
}

// Devices are tested at their first opening.
static void devices_open_with_faults(void** state)
{
	(void)state;
	NEEDS_SECOND_DEVICE();
	const char* chosen = getenv("SCREE_FAULTS");
	long runs = !chosen ? 1 : strcmp(chosen, "all") == 0 ? 100 : atol(chosen);
	scree_world* world;
	verdict_forget();
	long before = layer->calls;
	OK(open_one(&world, PATIENT));
	scree_world_destroy(world);
	long calls = layer->calls - before, tried = 0;
	for (int kind = 0; kind < KINDS; ++kind)
		for (long k = 0; k < runs; ++k, ++tried)
			open_with_fault(kinds[kind], (KINDS * k + kind) * calls / (runs * KINDS));
	print_message("%ld faults at the first opening of a device, which makes %ld calls\n", tried, calls);
}

// Builds a program with one fault. Returns whether there was one. Without a program, the message names the error.
static bool build_with_fault(const Device* device, Kind kind, long calls)
{
	static const char text[] = "kernel void one(global int* x) { *x = 1; }";
	ContextFailure failure = 0;
	cl_int error;
	cl_program program;
	cl_context context = opencl.CreateContext(NULL, 1, &device->id, NULL, NULL, &error);
	assert_int_equal(error, CL_SUCCESS);
	begin_fault(kind, -1, calls);
	scree_status status = program_build(&failure, context, device, "", text, sizeof text - 1, &program);
	assert_true((status == SCREE_OK) == (program != NULL));
	assert_false(program && context_failed(&failure));
	bool failed = layer->failed;
	if (status != SCREE_OK)
		assert_non_null(strstr(scree_error(), opencl_error_name(kind.code)));
	else if (failed)
		assert_non_null(strstr(warnings, opencl_error_name(kind.code)));
	RELEASE(&failure, Program, program);
	RELEASE(&failure, Context, context);
	end_fault();
	return failed;
}

static void cached_programs_fail(void** state)
{
	(void)state;
	NEEDS_SECOND_DEVICE();
	Device device;
	BackendOptions options = {.device = second_device + strlen("opencl:")};
	OK(device_choose(&options, &device));
	device.compiles_at_launch = false; // otherwise its programs are not stored
	int faults = 0;
	for (int cached = 0; cached < 2; ++cached)
		for (int kind = 0; kind < KINDS && kinds[kind].fault <= LAYER_LOST; ++kind)
			for (bool failed = true; failed;)
			{
				static long calls;
				char folder[] = "/tmp/scree_faults_XXXXXX", command[64];
				assert_non_null(mkdtemp(folder));
				set_environment("SCREE_CACHE", folder);
				if (cached)
					build_with_fault(&device, kinds[kind], 1000);
				failed = build_with_fault(&device, kinds[kind], calls);
				calls = failed ? calls + 1 : 0;
				faults += failed;
				snprintf(command, sizeof command, "rm -r %s", folder);
				assert_true(system(command) >= 0);
			}
	set_environment("SCREE_CACHE", "");
	print_message("%d faults in programs and their cache\n", faults);
	assert_true(faults > 20);
}

// A driver may state after a wait for the queue that a launch has not ended. Its time is read when it has.
static void times_come_late(void** state)
{
	(void)state;
	NEEDS_SECOND_DEVICE();
	static const Kind late = {LAYER_ERROR, CL_PROFILING_INFO_NOT_AVAILABLE};
	scree_world_def def = scree_world_def_default();
	scree_timings timings;
	def.device = second_device;
	def.device_timeout = PATIENT;
	def.timings = true;
	scree_world* world = create_world(&def);
	begin_fault(late, LAYER_GetEventProfilingInfo, 2);
	run_steps(world, 1);
	assert_string_equal(layer->failed, "clGetEventProfilingInfo");
	OK(scree_world_get_timings(world, &timings));
	assert_true(timings.step > 0.0f);
	scree_world_destroy(world);
	end_fault();
}

static int begin(void** state)
{
	OK(scree_hooks_set(&(scree_hooks){.log = note_log}));
	void* library = dlopen(FAULT_LAYER, RTLD_NOW | RTLD_LOCAL);
	if (!library)
		fail_msg("%s", dlerror());
	layer = dlsym(library, "fault_layer");
	set_environment("SCREE_OPENCL", FAULT_LAYER);
	set_environment("SCREE_CACHE", "");
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
	OK(scree_hooks_set(NULL));
	return scree_memory() != 0;
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(each_call_fails),      cmocka_unit_test(worlds_recover),
	    cmocka_unit_test(auto_recovers),        cmocka_unit_test(devices_open_with_faults),
	    cmocka_unit_test(cached_programs_fail), cmocka_unit_test(times_come_late),
	};
	return cmocka_run_group_tests(tests, begin, end);
}
