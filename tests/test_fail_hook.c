// SPDX-License-Identifier: MIT
// test_fail_hook.c -- checks that the hook for failed calls is called once for each call of the program that fails, and for no
// other call.
#include "support/header_text.h"
#include "support/make_bodies.h"
#include "world/record/arguments.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int hooked;
static char last_function[80], last_sentence[1024];
static scree_status last_status;

static void note(const char* function, scree_status status, const char* sentence, void* context)
{
	assert_ptr_equal(context, &hooked);
	assert_string_equal(sentence, scree_error());
	++hooked;
	last_status = status;
	strncpy(last_function, function, sizeof last_function - 1);
	strncpy(last_sentence, sentence, sizeof last_sentence - 1);
}

static int set_hook(void** state)
{
	(void)state;
	scree_fail_hook_set(note, &hooked);
	hooked = 0;
	return 0;
}

static int clear_hook(void** state)
{
	scree_fail_hook_set(NULL, NULL);
	return memory_is_released(state);
}

// Checks the hook after a call with null arguments.
static void check_call(scree_status status, const char* name, int* failed)
{
	assert_int_equal(hooked, status != SCREE_OK);
	hooked = 0;
	if (status == SCREE_OK)
		return;
	++*failed;
	assert_int_equal(last_status, status);
	char function[80];
	size_t length = strlen(name);
	length -= length > 6 && strcmp(name + length - 6, "_sized") == 0 ? 6 : 0;
	snprintf(function, sizeof function, "scree_%.*s", (int)length, name);
	assert_string_equal(last_function, function);
	if (strncmp(last_sentence, function, strlen(function)) != 0)
		fail_msg("%s fails with \"%s\"", function, last_sentence);
}

#define ZERO_OF(kind, type, name) \
	(kind##_TYPE(type)) { 0 }
#define ZERO(k, argument) ZERO_OF argument
#define CALL(name, ...)   check_call(scree_##name(NULL, EACH(ZERO, __VA_ARGS__)), #name, &failed);
#define READ              CALL
#define READ_ALONE(name)  check_call(scree_##name(NULL), #name, &failed);
#define PLAIN(name, ...)  check_call(scree_##name(EACH(ZERO, __VA_ARGS__)), #name, &failed);

static void release_nothing(void* memory, void* context)
{
	(void)memory;
	(void)context;
}

// Each function of the three lists, with zeros for all arguments, fails and calls the hook.
static void each_function_is_reported(void** state)
{
	(void)state;
	int failed = 0, listed = 0;
#include "world/record/reading_calls.def"
#include "world/record/recorded_calls.def"
#define CALL(name, ...)  ++listed;
#define READ(name, ...)  ++listed;
#define READ_ALONE(name) ++listed;
#include "world/record/plain_calls.def"
#include "world/record/reading_calls.def"
#include "world/record/recorded_calls.def"
#define PLAIN(name, ...) ++listed;
#include "world/record/plain_calls.def"
	assert_int_equal(failed, listed);
	assert_true(listed > 190);
	check_call(scree_hooks_set(&(scree_hooks){.release = release_nothing}), "hooks_set", &failed);

	// all functions with a status are in the lists, but scree_hooks_set and scree_call_end
	static const char start[] = "\nSCREE_API scree_status ";
	char* text = read_header();
	int declared = 0;
	for (const char* at = text; (at = strstr(at, start)); at += sizeof start - 1)
		++declared;
	free(text);
	assert_int_equal(declared, listed + 2);
}

// Calls that Scree makes itself are not reported, whether or not they fail; static inline functions are.
static void only_calls_of_the_program_count(void** state)
{
	(void)state;
	scree_world* world = open_world(-10.0f);
	assert_int_equal(scree_body_create_box(world, SCREE_BODY_DYNAMIC, upright_at(0.0f, 0.0f), 0.0f, 1.0f, 0, NULL),
	                 SCREE_ERROR_INVALID);
	assert_int_equal(hooked, 1);
	assert_string_equal(last_function, "scree_shape_make_box");
	assert_non_null(strstr(last_sentence, "half_width is 0, must be from "));
	scree_body body = add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 0.0f);
	scree_blast_def blast = scree_blast_def_default();
	OK(scree_world_blast(world, &blast, NULL)); // calls other public functions
	assert_int_equal(hooked, 1);
	scree_body_def def;
	assert_int_equal(scree_body_get_def(world, SCREE_NULL_BODY, &def), SCREE_ERROR_STALE);
	assert_string_equal(last_function, "scree_body_get_def");
	assert_int_equal(hooked, 2);
	OK(scree_body_destroy(world, body));
	assert_false(scree_body_is_valid(world, body)); // no failure
	assert_int_equal(hooked, 2);
	scree_world_destroy(world);
}

// A library on top of Scree reports its own failures; calls that it makes are not reported.
static void libraries_report_their_calls(void** state)
{
	(void)state;
	scree_call_begin();
	assert_int_equal(scree_world_step(NULL, 1.0f, 1), SCREE_ERROR_INVALID);
	scree_call_begin();
	assert_int_equal(scree_call_end("inner", SCREE_ERROR_FILE, "inner: no file"), SCREE_ERROR_FILE);
	assert_int_equal(hooked, 0);
	assert_int_equal(scree_call_end("outer", SCREE_ERROR_STALE, NULL), SCREE_ERROR_STALE);
	assert_int_equal(hooked, 1);
	assert_int_equal(last_status, SCREE_ERROR_STALE);
	assert_string_equal(last_function, "outer");
	assert_string_equal(last_sentence, "inner: no file");
	scree_call_begin();
	assert_int_equal(scree_call_end("good", SCREE_OK, "not used"), SCREE_OK);
	assert_int_equal(hooked, 1);
	assert_string_equal(scree_error(), "inner: no file");
	assert_int_equal(scree_world_step(NULL, 1.0f, 1), SCREE_ERROR_INVALID);
	assert_int_equal(hooked, 2);
}

static void fail_again(const char* function, scree_status status, const char* sentence, void* context)
{
	(void)function;
	(void)status;
	++hooked;
	// a failed call in the hook is not reported, and changes neither the sentence nor that of scree_error
	char kept[1024];
	strncpy(kept, sentence, sizeof kept - 1);
	kept[sizeof kept - 1] = 0;
	assert_int_equal(scree_world_step(NULL, 1.0f, 1), SCREE_ERROR_INVALID);
	assert_string_equal(sentence, kept);
	scree_world_destroy(context);
	scree_fail_hook_set(NULL, NULL);
}

// The hook may call any function, also end the world and remove itself.
static void the_hook_may_call_functions(void** state)
{
	(void)state;
	scree_world* world = open_world(-10.0f);
	scree_fail_hook_set(fail_again, world);
	assert_int_equal(scree_world_step(world, -1.0f, 4), SCREE_ERROR_INVALID);
	assert_int_equal(hooked, 1);
	assert_non_null(strstr(scree_error(), "dt is -1"));
	assert_int_equal(scree_world_step(NULL, 1.0f, 1), SCREE_ERROR_INVALID);
	assert_int_equal(hooked, 1);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test_setup_teardown(each_function_is_reported, set_hook, clear_hook),
	    cmocka_unit_test_setup_teardown(only_calls_of_the_program_count, set_hook, clear_hook),
	    cmocka_unit_test_setup_teardown(libraries_report_their_calls, set_hook, clear_hook),
	    cmocka_unit_test_setup_teardown(the_hook_may_call_functions, set_hook, clear_hook),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
