// SPDX-License-Identifier: MIT
// test_recording_list.c -- checks the lists of recorded and of reading calls and their types against scree.h: no function that
// uses a world and no member of a struct is missing.
#include "support/checks.h"
#include "support/header_text.h"
#include "world/record/call_list.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char* left_out[][2] = {
#define CALL(name, ...)
#define LEFT_OUT(pattern, reason) {pattern, reason},
#include "world/record/recorded_calls.def"
};
#define LEFT_OUT_COUNT (int)(sizeof left_out / sizeof *left_out)

static const char* reading[] = {
#define READ(name, ...)  #name,
#define READ_ALONE(name) #name,
#include "world/record/reading_calls.def"
};
#define READING_COUNT (int)(sizeof reading / sizeof *reading)

static const char* not_repeated[] = {
#define READ(name, ...)
#define NOT_REPEATED(pattern, reason) pattern,
#include "world/record/reading_calls.def"
};
#define NOT_REPEATED_COUNT (int)(sizeof not_repeated / sizeof *not_repeated)

// Returns whether a name matches a pattern, in which * stands for any letters.
static bool matches(const char* pattern, const char* name)
{
	if (*pattern != '*')
		return *pattern == *name && (*name == 0 || matches(pattern + 1, name + 1));
	return matches(pattern + 1, name) || (*name != 0 && matches(pattern, name + 1));
}

static int recorded(const char* name)
{
	for (int c = 0; c < RECORDED_CALLS; ++c)
		if (strcmp(recorded_calls[c].name, name) == 0)
			return c;
	return -1;
}

// Checks that a call that is not recorded is repeated after a failure of the device, or not repeated with a reason, not both.
static void check_reading(const char* name)
{
	int found = 0;
	for (int k = 0; k < READING_COUNT; ++k)
		found += strcmp(reading[k], name) == 0;
	for (int k = 0; k < NOT_REPEATED_COUNT; ++k)
		found += matches(not_repeated[k], name);
	if (found != 1)
		fail_msg("scree_%s is %s in src/world/record/reading_calls.def", name, found ? "twice" : "missing");
}

// Each function with a world that is not const, or with a replay, is recorded or left out with a reason, not both.
static void each_function_is_listed(void** state)
{
	(void)state;
	char *text = read_header(), name[80], first[80];
	int found = 0, calls = 0;
	bool used[LEFT_OUT_COUNT] = {false};
	for (char* at = text; (at = strstr(at, "\nSCREE_API ")); ++at)
	{
		if (sscanf(at, "\nSCREE_API %*[a-z_] scree_%79[a-z_](%79[a-z_*]", name, first) != 2)
			continue;
		if (strcmp(first, "scree_world*") != 0 && strcmp(first, "scree_replay*") != 0)
			continue;
		bool in_list = recorded(name) >= 0, out = false;
		for (int k = 0; k < LEFT_OUT_COUNT; ++k)
		{
			bool match = matches(left_out[k][0], name);
			used[k] |= match;
			out |= match;
		}
		if (in_list == out)
			fail_msg("scree_%s is %s in src/world/record/recorded_calls.def", name, out ? "twice" : "missing");
		if (out)
			check_reading(name);
		calls += in_list;
		++found;
	}
	assert_int_equal(calls, RECORDED_CALLS);
	assert_true(found > 100);
	for (int k = 0; k < LEFT_OUT_COUNT; ++k)
		if (!used[k])
			fail_msg("%s matches no function of scree.h", left_out[k][0]);
	free(text);
}

// Each byte of a struct is in a member, or belongs to its size, or is padding: fewer than eight bytes behind a member. Points and
// their number in a scree_path_def are recorded with the call.
static void each_member_is_listed(void** state)
{
	(void)state;
	for (int t = 0; t < RECORDED_TYPES; ++t)
	{
		const RecordedType* type = recorded_types + t;
		char covered[MOST_SIZE] = {0};
		assert_true(type->bytes <= MOST_SIZE);
		if (type->definition)
			memset(covered, 1, sizeof(uint32_t));
		if (t == RECORDED_TYPE_scree_path_def)
			memset(covered + offsetof(scree_path_def, points), 1, sizeof(void*) + sizeof(int));
		for (int m = 0; m < type->count; ++m)
			memset(covered + type->members[m].offset, 1, (size_t)type->members[m].bytes);
		for (int at = 0, gap = 0; at < type->bytes; ++at)
		{
			gap = covered[at] ? 0 : gap + 1;
			if (gap > 7 || (gap >= 4 && (at + 1) % 4 == 0 && (at + 1) % 8 != 0))
				fail_msg("byte %d of %s is in no member in src/world/record/recorded_types.def", at, type->name);
		}
		assert_true(type_recorded_bytes(type) > 0);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(each_function_is_listed),
	    cmocka_unit_test(each_member_is_listed),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
