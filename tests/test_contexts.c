// SPDX-License-Identifier: MIT
// test_contexts.c -- checks that worlds of a process share the context and the program of an OpenCL device: one after
// the other, at the same time, and in several threads. After a failure of the context, its worlds are broken, and new
// worlds use a new context.
#include "opencl/loader.h"
#include "support/second_device.h"
#include <pthread.h>
#include <stdatomic.h>

#define WORLDS 4

static OpenClFunctions plain;
static atomic_int contexts, programs; // numbers of contexts created and of programs built
static int buffers_left;              // number of buffers that can still be created; -1: no limit

static cl_context count_context(const cl_context_properties* properties, cl_uint count, const cl_device_id* devices,
                                void(CL_CALLBACK* notify)(const char*, const void*, size_t, void*), void* user,
                                cl_int* error)
{
	++contexts;
	return plain.CreateContext(properties, count, devices, notify, user, error);
}

static cl_int count_build(cl_program program, cl_uint count, const cl_device_id* devices, const char* options,
                          void(CL_CALLBACK* notify)(cl_program, void*), void* user)
{
	++programs;
	return plain.BuildProgram(program, count, devices, options, notify, user);
}

static cl_mem count_buffer(cl_context context, cl_mem_flags flags, size_t size, void* memory, cl_int* error)
{
	if (buffers_left-- != 0)
		return plain.CreateBuffer(context, flags, size, memory, error);
	*error = CL_INVALID_CONTEXT;
	return NULL;
}

static int begin(void** state)
{
	if (!opencl_load())
		return 0;
	plain = opencl;
	opencl.CreateContext = count_context;
	opencl.BuildProgram = count_build;
	opencl.CreateBuffer = count_buffer;
	buffers_left = -1;
	return find_second_device(state);
}

static int end(void** state)
{
	(void)state;
	opencl = plain;
	return 0;
}

static scree_world* open_there(void) { return open_pile(second_device, true); }

static uint64_t fall(scree_world* world)
{
	run_steps(world, 5);
	return hash_of(world);
}

static void worlds_share_a_context(void** state)
{
	(void)state;
	NEEDS_SECOND_DEVICE();
	scree_world_destroy(open_there());
	int before = contexts, built = programs;
	scree_world* worlds[WORLDS];
	for (int k = 0; k < WORLDS; ++k)
		worlds[k] = open_there();
	// a GPU releases its context when its last world is destroyed, so these worlds may need one new context
	assert_in_range(contexts - before, 0, 1);
	assert_in_range(programs - built, 0, 1);
	uint64_t hash = fall(worlds[0]);
	scree_world_destroy(worlds[0]);
	for (int k = 1; k < WORLDS; ++k)
		assert_true(fall(worlds[k]) == hash);
	for (int k = 1; k < WORLDS; ++k)
		scree_world_destroy(worlds[k]);
}

static void a_failure_ends_the_sharing(void** state)
{
	(void)state;
	NEEDS_SECOND_DEVICE();
	scree_world* old = open_there();
	uint64_t hash = fall(old);
	int before = contexts;
	scree_world_def def = scree_world_def_default();
	def.device = second_device;
	scree_world* none;
	buffers_left = 3;
	assert_int_equal(scree_world_create(&def, &none), SCREE_ERROR_DEVICE_FAILED);
	buffers_left = -1;
	scree_world* fresh = open_there();
	assert_int_equal(contexts - before, 1);
	assert_true(fall(fresh) == hash);
	assert_int_equal(scree_world_step(old, STEP, SUBSTEPS), SCREE_ERROR_DEVICE_FAILED);
	scree_world_destroy(old);
	scree_world_destroy(fresh);
	fresh = open_there();
	assert_in_range(contexts - before, 1, 2);
	scree_world_destroy(fresh);
}

typedef struct
{
	uint64_t hashes[WORLDS];
} Worker;

static void* open_and_close(void* argument)
{
	Worker* worker = argument;
	for (int k = 0; k < WORLDS; ++k)
	{
		scree_world* world = open_there();
		worker->hashes[k] = fall(world);
		scree_world_destroy(world);
	}
	return NULL;
}

static void threads_open_and_close(void** state)
{
	(void)state;
	NEEDS_SECOND_DEVICE();
	scree_world* world = open_there();
	uint64_t hash = fall(world);
	scree_world_destroy(world);
	pthread_t threads[2];
	Worker workers[2];
	for (int k = 0; k < 2; ++k)
		assert_int_equal(pthread_create(&threads[k], NULL, open_and_close, &workers[k]), 0);
	for (int k = 0; k < 2; ++k)
		assert_int_equal(pthread_join(threads[k], NULL), 0);
	for (int k = 0; k < 2 * WORLDS; ++k)
		assert_true(workers[k / WORLDS].hashes[k % WORLDS] == hash);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(worlds_share_a_context),
	                                   cmocka_unit_test(a_failure_ends_the_sharing),
	                                   cmocka_unit_test(threads_open_and_close)};
	return cmocka_run_group_tests(tests, begin, end);
}
