// SPDX-License-Identifier: MIT
// test_gate.c -- checks the tests of OpenCL devices: wrong arithmetic is found and named, wrong quotients are
// replaced by own rounding, and verdicts are stored and read.
//
// PoCL is compiled wrongly on purpose (backend/arithmetic.h). Each test has a folder of its own for the cache.
#include "api/world/device_test.h"
#include "backend/arithmetic.h"
#include "opencl/arithmetic_test.h"
#include "opencl/device_name.h"
#include "platform/processor.h"
#include "support/checks.h"
#include "support/log_lines.h"
#include "support/second_device.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define N(x) (x)
#include "opencl/arithmetic_item.h"

static char old_cache[512];

static void forget_all(void)
{
	char command[640];
	snprintf(command, sizeof command, "rm -rf '%s'", getenv("SCREE_CACHE"));
	assert_int_equal(system(command), 0);
	verdict_forget();
}

static int begin(void** state)
{
	char folder[640];
	snprintf(old_cache, sizeof old_cache, "%s", getenv("SCREE_CACHE"));
	snprintf(folder, sizeof folder, "%s/test_gate", old_cache);
	setenv("SCREE_CACHE", folder, 1);
	forget_all();
	return keep_log(state);
}

static int end(void** state)
{
	arithmetic_setting = (Arithmetic){.rounding = ROUNDING_DEVICE};
	forget_all();
	setenv("SCREE_CACHE", old_cache, 1);
	return release_log(state) || memory_is_released(state);
}

static scree_device device_now(void)
{
	scree_device devices[32], found = {.name = ""};
	int count;
	OK(scree_devices_get(devices, 32, &count));
	for (int k = 0; k < count && k < 32; ++k)
		if (strcmp(devices[k].name, second_device) == 0)
			found = devices[k];
	assert_string_equal(found.name, second_device);
	return found;
}

static scree_status create(bool allow_unequal_bits)
{
	scree_world_def def = scree_world_def_default();
	def.device = second_device;
	def.allow_unequal_bits = allow_unequal_bits;
	scree_world* world;
	scree_status status = scree_world_create(&def, &world);
	assert_true((status == SCREE_OK) == (world != NULL));
	scree_world_destroy(world);
	return status;
}

static scree_status create_batch(scree_world* template)
{
	scree_batch_def def = scree_batch_def_default();
	def.templates = &template;
	def.template_count = def.worlds = 1;
	def.device = second_device;
	scree_batch* batch;
	scree_status status = scree_batch_create(&def, &batch);
	scree_batch_destroy(batch);
	return status;
}

// The first batch tests the device, if no world has done so.
static void first_batch_tests(void** state)
{
	(void)state;
	NEEDS_SECOND_DEVICE();
	scree_world* world = open_pile("cpu", true);
	OK(create_batch(world));
	assert_true(device_now().equal_bits && device_now().tested && device_now().tested_worlds >= 5);
	forget_all();
	arithmetic_setting.fused = true;
	assert_int_equal(create_batch(world), SCREE_ERROR_NO_DEVICE);
	assert_non_null(strstr(scree_error(), " is refused: it computes "));
	assert_true(device_now().tested && !device_now().equal_bits);
	scree_world_destroy(world);
}

static Word results[ARITHMETIC_RESULTS];

// Computes all results on the CPU, which flushes denormals if `flush` is true.
static void compute_results(bool flush)
{
	FloatMode mode = float_mode_enter();
	if (flush)
		float_mode_flush();
	for (int k = 0; k < ARITHMETIC_RESULTS; ++k)
		results[k] = arithmetic_result(k / ARITHMETIC_CASES, k % ARITHMETIC_CASES);
	float_mode_leave(mode);
}

// Results of a device that keeps denormals and of one that flushes them pass. One wrong bit in any operation is found.
static void results_are_compared(void** state)
{
	(void)state;
	Verdict verdict = {.results = 0};
	compute_results(false);
	assert_int_equal(arithmetic_compare(results, &verdict), ARITHMETIC_OPERATIONS);
	assert_true(verdict.keeps_denormals && verdict.keeps_zeros);
	for (int operation = 0; operation < ARITHMETIC_OPERATIONS; ++operation)
	{
		Word* result = &results[operation * ARITHMETIC_CASES + 16];
		*result ^= 1u;
		assert_int_equal(arithmetic_compare(results, &verdict), operation);
		print_message("%s\n", verdict.difference);
		assert_non_null(strstr(verdict.difference, "it computes "));
		assert_non_null(strstr(verdict.difference, ", the CPU as "));
		*result ^= 1u;
	}

	compute_results(true);
	assert_int_equal(arithmetic_compare(results, &verdict), ARITHMETIC_OPERATIONS);
#if defined(__x86_64__) || defined(__aarch64__)
	assert_false(verdict.keeps_denormals);
#endif
}

// Results of a compiler that simplifies operations with a constant 0 pass; a wrong sign elsewhere does not.
static void simplified_zeros_pass(void** state)
{
	(void)state;
	Verdict verdict = {.results = 0};
	compute_results(false);
	for (int number = 0; number < ARITHMETIC_CASES; ++number)
	{
		float a = operands_of(ARITHMETIC_PLUS_ZERO, number).a;
		results[ARITHMETIC_TIMES_ZERO * ARITHMETIC_CASES + number] = 0u;
		results[ARITHMETIC_PLUS_ZERO * ARITHMETIC_CASES + number] = float_word(a);
		a = operands_of(ARITHMETIC_ZERO_LESS, number).a;
		results[ARITHMETIC_ZERO_LESS * ARITHMETIC_CASES + number] = float_word(-a);
	}
	assert_int_equal(arithmetic_compare(results, &verdict), ARITHMETIC_OPERATIONS);
	assert_false(verdict.keeps_zeros);
	assert_true(verdict.keeps_denormals);

	Word* sum = &results[ARITHMETIC_PLUS_ZERO * ARITHMETIC_CASES];
	Word kept = *sum;
	*sum = 0u; // not a zero
	assert_int_equal(arithmetic_compare(results, &verdict), ARITHMETIC_PLUS_ZERO);
	*sum = kept;
	Word* difference = &results[ARITHMETIC_DIFFERENCE * ARITHMETIC_CASES + 10]; // a number less itself
	assert_int_equal(*difference, 0);
	*difference = 0x80000000u;
	assert_int_equal(arithmetic_compare(results, &verdict), ARITHMETIC_DIFFERENCE);
}

// The first world tests the device, and has the same hash as later ones.
static void first_world_tests(void** state)
{
	(void)state;
	NEEDS_SECOND_DEVICE();
	scree_device device = device_now();
	assert_true(device.equal_bits && !device.tested);
	for (int k = 0; k < 2; ++k)
	{
		scree_world* world = open_pile(second_device, false);
		run_steps(world, 30);
		assert_true(hash_of(world) == hash_after(30));
		scree_world_destroy(world);
		assert_int_equal(log_count, 1);
	}
	assert_true(was_logged("float results and 5 worlds have the bits of the CPU") ||
	            was_logged("float results and 15 worlds have the bits of the CPU"));
	device = device_now();
	assert_true(device.equal_bits && device.tested && device.tested_results > 100000);
	assert_true(device.tested_worlds == 5 || device.tested_worlds == 15);
	assert_string_equal(device.reason, "");
}

// A device that flushes denormals passes.
static void flushing_passes(void** state)
{
	(void)state;
	NEEDS_SECOND_DEVICE();
	skip_if_quick(); // PoCL compiles the stages once more
	arithmetic_setting.flush = true;
	OK(create(false));
	assert_true(device_now().equal_bits && device_now().tested);
	assert_int_equal(warning_count, 0);
}

static void check_refused(const char* operation)
{
	assert_int_equal(create(false), SCREE_ERROR_NO_DEVICE);
	print_message("%s\n", scree_error());
	assert_non_null(strstr(scree_error(), " is refused: it computes "));
	assert_non_null(strstr(scree_error(), operation));
	assert_non_null(strstr(scree_error(), ", the CPU as "));
	assert_non_null(strstr(scree_error(), "; scree_world_def.allow_unequal_bits runs it anyway"));
	scree_device device = device_now();
	assert_true(device.tested && !device.equal_bits);
	assert_non_null(strstr(device.reason, "it computes "));
}

// A device whose compiler fuses products and sums is refused with the operation, also by a move and by device "auto",
// and can be used if unequal bits are allowed.
static void fused_products_are_found(void** state)
{
	(void)state;
	NEEDS_SECOND_DEVICE();
	arithmetic_setting.fused = true;
	check_refused(" * ");
	assert_int_equal(warning_count, 1);
	check_refused(" + ");
	assert_int_equal(warning_count, 1);
	scree_world* world = open_pile("cpu", true);
	assert_int_equal(scree_world_move(world, second_device), SCREE_ERROR_NO_DEVICE);
	assert_int_equal(create_batch(world), SCREE_ERROR_NO_DEVICE);
	scree_world_destroy(world);

	setenv("SCREE_AUTO", second_device, 1);
	world = open_pile("auto", false);
	run_steps(world, 20);
	assert_string_equal(scree_world_get_device(world), "cpu");
	assert_true(was_logged("the world stays on the CPU: "));
	scree_world_destroy(world);
	unsetenv("SCREE_AUTO");

	OK(create(true));
	assert_int_equal(scree_device_test(second_device), SCREE_ERROR_NO_DEVICE);
	arithmetic_setting.fused = false;
	assert_true(device_now().equal_bits);
}

// A machine with PoCL alone has no GPU, which is said in a sentence about GPUs, not about names.
static void no_device_is_a_gpu(void** state)
{
	(void)state;
	NEEDS_SECOND_DEVICE();
	Device device;
	BackendOptions options = {.gpu = true};
	if (device_choose(&options, &device) == SCREE_OK)
		assert_true(device.type & CL_DEVICE_TYPE_GPU);
	else
		assert_string_equal(scree_error(), "This machine has no OpenCL device that is a GPU.");
	options.device = "no such device";
	assert_int_equal(device_choose(&options, &device), SCREE_ERROR_NO_DEVICE);
	assert_non_null(strstr(scree_error(), "\"no such device\" in its name or in that of its driver, case ignored."));
}

// The small worlds find a difference that the arithmetic test has not found.
static void worlds_find_differences(void** state)
{
	(void)state;
	NEEDS_SECOND_DEVICE();
	arithmetic_setting.fused = true;
	BackendOptions options = {.device = second_device + strlen("opencl:")};
	Backend* b;
	OK(opencl_open(&options, &b));
	WorldsTest test;
	OK(test_worlds(b, &test));
	print_message("%s\n", test.difference);
	assert_non_null(strstr(test.difference, "its world \"mixed\" has hash "));
	b->f->close(b);
}

// A device that rounds quotients and roots wrongly without reporting it gets own rounding.
static void wrong_quotients_are_replaced(void** state)
{
	(void)state;
	NEEDS_SECOND_DEVICE();
	arithmetic_setting.rounding = ROUNDING_WRONG;
	OK(create(false));
	scree_device device = device_now();
	assert_true(device.tested && device.equal_bits && device.own_rounding);
	if (warning_count > 0) // otherwise the device reports that it does not round correctly
		assert_non_null(strstr(last_warning, "; integers will round them."));
	int warnings = warning_count;
	scree_world* world = open_pile(second_device, false);
	run_steps(world, 30);
	assert_true(hash_of(world) == hash_after(30));
	scree_world_destroy(world);
	assert_int_equal(warning_count, warnings);
	OK(scree_device_test(second_device));
	assert_int_equal(warning_count, 2 * warnings);
}

// Changes a byte in the middle of the only file of a verdict, and of all other files of the cache.
static void damage_all(void)
{
	char command[1024];
	snprintf(command, sizeof command,
	         "for file in '%s'/*.bin; do printf '\\377' | dd of=\"$file\" bs=1 seek=60 conv=notrunc 2>/dev/null; done",
	         getenv("SCREE_CACHE"));
	assert_int_equal(system(command), 0);
}

// A verdict is read from the cache by another process, here by one that has forgotten it; a damaged one is not.
static void verdicts_are_stored(void** state)
{
	(void)state;
	NEEDS_SECOND_DEVICE();
	OK(create(false));
	assert_int_equal(log_count, 1);
	verdict_forget();
	scree_device device = device_now();
	assert_true(device.tested && device.equal_bits && device.tested_results > 100000);
	OK(create(false));
	assert_int_equal(log_count, 1);

	verdict_forget();
	damage_all();
	device = device_now();
	assert_true(!device.tested && device.equal_bits && device.tested_results == 0);
	assert_true(was_logged("is damaged and will be written again"));
	OK(create(false));
	assert_true(was_logged("was tested"));
	assert_true(device_now().tested);

	// without a cache, the device is tested once per process
	char folder[640];
	snprintf(folder, sizeof folder, "%s", getenv("SCREE_CACHE"));
	setenv("SCREE_CACHE", "", 1);
	verdict_forget();
	log_count = 0;
	OK(create(false));
	OK(create(false));
	assert_int_equal(log_count, 1);
	setenv("SCREE_CACHE", folder, 1);
}

// Another process uses the verdict: scree devices prints it, and does not test without --test.
static void commands_print_verdicts(void** state)
{
	(void)state;
	NEEDS_SECOND_DEVICE();
	char command[1024];
	if (access(getenv("SCREE_BINARY"), X_OK) != 0)
		skip();
	const char* lines[] = {"not tested yet", "tested by 10", "not tested yet"};
	for (int k = 0; k < 3; ++k)
	{
		snprintf(command, sizeof command, "'%s' devices | grep -q '%s'", getenv("SCREE_BINARY"), lines[k]);
		assert_int_equal(system(command), 0);
		if (k == 0)
			OK(create(false));
		else
			damage_all();
	}
	snprintf(command, sizeof command, "'%s' devices --test | grep -q 'denormals   '", getenv("SCREE_BINARY"));
	assert_int_equal(system(command), 0);
	verdict_forget();
	assert_true(device_now().tested);
}

static void bad_names_are_refused(void** state)
{
	(void)state;
	OK(scree_device_test("cpu"));
	assert_int_equal(scree_device_test("auto"), SCREE_ERROR_INVALID);
	assert_non_null(strstr(scree_error(), "scree_device_test: device is \"auto\""));
	assert_int_equal(scree_device_test("gpu"), SCREE_ERROR_INVALID);
	assert_int_equal(scree_device_test(NULL), SCREE_ERROR_INVALID);
	assert_int_equal(scree_device_test("opencl:no such device"), SCREE_ERROR_NO_DEVICE);
}

// With a warm cache of PoCL; prints the time, since the machine may be busy.
static void test_is_quick(void** state)
{
	(void)state;
	NEEDS_SECOND_DEVICE();
	double least = 1e9;
	for (int k = 0; k < 3; ++k)
	{
		double start = processor_milliseconds();
		OK(scree_device_test(second_device));
		double spent = processor_milliseconds() - start;
		least = spent < least ? spent : least;
	}
	print_message("%s: tested in %.0f ms\n", second_device, least);
}

int main(void)
{
#define TEST(name) cmocka_unit_test_setup_teardown(name, begin, end)
	const struct CMUnitTest tests[] = {
	    TEST(results_are_compared), TEST(simplified_zeros_pass),   TEST(first_world_tests),
	    TEST(first_batch_tests),    TEST(flushing_passes),         TEST(fused_products_are_found),
	    TEST(no_device_is_a_gpu),   TEST(worlds_find_differences), TEST(wrong_quotients_are_replaced),
	    TEST(verdicts_are_stored),  TEST(commands_print_verdicts), TEST(bad_names_are_refused),
	    TEST(test_is_quick),
	};
	return cmocka_run_group_tests(tests, find_second_device, NULL);
}
