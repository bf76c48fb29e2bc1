// SPDX-License-Identifier: MIT
// test_thread_faults.c -- checks that the system may refuse to start a thread, at each start in turn.
//
// The program has its own pthread_create, which fails when the test requests it. OpenCL and other shared libraries keep
// that of the system.
#include "support/environment.h"
#include "support/fault_acts.h"
#include "support/make_worlds.h"
#include <string.h>

#if defined(__linux__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) && !defined(__clang__)
#include <dlfcn.h>
#include <errno.h>
#include <pthread.h>

static int starts_left = -1; // number of threads that start before all others are refused; negative: no limit

int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, void* (*function)(void*), void* argument)
{
	typedef int (*Create)(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*);
	static Create create;
	if (!create)
		*(void**)&create = dlsym(RTLD_NEXT, "pthread_create");
	if (starts_left == 0)
		return EAGAIN;
	starts_left -= starts_left > 0;
	return create(thread, attributes, function, argument);
}

// A world with four threads starts three. If one of them is refused, the world is not created.
static void worlds_need_their_threads(void** state)
{
	(void)state;
	scree_world_def def = scree_world_def_default();
	def.device = "cpu";
	def.threads = 4;
	for (int k = 0; k < 3; ++k)
	{
		scree_world* world;
		starts_left = k;
		assert_int_equal(scree_world_create(&def, &world), SCREE_ERROR_OUT_OF_MEMORY);
		assert_null(world);
		assert_non_null(strstr(scree_error(), "refuses to start thread"));
		assert_int_equal(scree_memory(), 0);
	}
	starts_left = -1;
	scree_world_destroy(create_world(&def));
}

// Each act that starts a thread fails, changes nothing, and is repeated.
static void acts_without_threads(void** state)
{
	(void)state;
	uint64_t expected = 0;
	int refused = 0;
	for (int k = -1; k < 8; ++k)
	{
		FaultRun s = {0};
		starts_left = k;
		for (int act = 0; act < FAULT_ACTS; ++act)
		{
			if (fault_acts[act].act(&s) == SCREE_OK)
				continue;
			assert_non_null(strstr(scree_error(), "refuses to start thread"));
			assert_true(!s.world || scree_world_wait(s.world) == SCREE_OK);
			starts_left = -1;
			++refused;
			--act;
		}
		uint64_t hash = hash_of(s.world);
		assert_true(k < 0 || hash == expected);
		expected = hash;
		fault_run_end(&s);
		assert_int_equal(scree_memory(), 0);
	}
	starts_left = -1;
	print_message("%d acts had no thread\n", refused);
	assert_true(refused >= 2);
}

// A world with device "auto" that cannot start the thread that opens the GPU stays on the CPU.
static void auto_stays(void** state)
{
	(void)state;
	scree_world_def def = scree_world_def_default();
	def.threads = 1;
	set_environment("SCREE_AUTO", "opencl");
	scree_world* world = create_world(&def);
	starts_left = 0;
	run_steps(world, 30);
	assert_string_equal(scree_world_get_device(world), "cpu");
	scree_world_destroy(world);
	set_environment("SCREE_AUTO", NULL);
	starts_left = -1;
}
#else
static void worlds_need_their_threads(void** state)
{
	(void)state;
	skip(); // sanitizers have their own pthread_create
}
#define acts_without_threads worlds_need_their_threads
#define auto_stays           worlds_need_their_threads
#endif

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(worlds_need_their_threads),
	    cmocka_unit_test(acts_without_threads),
	    cmocka_unit_test(auto_stays),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
