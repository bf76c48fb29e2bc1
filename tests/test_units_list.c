// SPDX-License-Identifier: MIT
// test_units_list.c -- checks the lists of units (src/world/units/) against scree.h: each float of a public struct, each float
// argument and each function with a length is listed.
#include "support/checks.h"
#include "support/header_text.h"
#include "world/units/unit_list.h"
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char* without_length[] = {
#define NO_LENGTH(type, reason) #type,
#include "world/units/unit_types.def"
};

static const char* without_lengths[] = {
    // functions of a const world with floats, none of which has a length
    "world_get_tuning_sized",
    "body_get_damping",
    "body_get_gravity_scale",
    "body_get_sleep_threshold",
};

static const struct
{
	const char* name;
	int floats; // number of floats in it
} parts[] = {   // types of members that contain floats
    {"float", 1},
    {"scree_vec", 2},
    {"scree_rot", 2},
    {"scree_pose", 4},
    {"scree_velocity", 3},
    {"scree_box", 4},
    {"scree_mass", 4},
    {"scree_shape", 38},
    {"scree_joint_coordinate", 12},
    {"scree_joint_side", 5},
    {"scree_contact_point", 5},
    {"scree_contact_detail", 2}};

static int floats_in(const char* type)
{
	for (size_t k = 0; k < sizeof parts / sizeof *parts; ++k)
		if (strcmp(parts[k].name, type) == 0)
			return parts[k].floats;
	return 0;
}

static bool among(const char* const* list, size_t count, const char* name)
{
	for (size_t k = 0; k < count; ++k)
		if (strcmp(list[k], name) == 0)
			return true;
	return false;
}
#define AMONG(list, name) among(list, sizeof(list) / sizeof *(list), name)

static const UnitType* type_named(const char* name)
{
	for (int k = 0; k < UNIT_TYPE_COUNT; ++k)
		if (strcmp(unit_types[k].name, name) == 0)
			return unit_types + k;
	return NULL;
}

// Returns whether a type lists a member, or parts of it such as pose.position.
static bool lists(const UnitType* type, const char* member)
{
	size_t length = strlen(member);
	for (int m = 0; m < type->count; ++m)
		if (strncmp(type->members[m].name, member, length) == 0 && strchr(".[", type->members[m].name[length]))
			return true;
	return false;
}

// Checks the members of one line of a struct, "float a, b[2];". Returns their number of floats.
static int check_line(const char* type_name, const char* line)
{
	char type[80], names[400];
	int found = 0;
	if (sscanf(line, " %79[a-z_] %399[^;]", type, names) != 2 || floats_in(type) == 0)
		return 0;
	const UnitType* listed = type_named(type_name);
	for (char* name = strtok(names, " ,"); name; name = strtok(NULL, " ,"))
	{
		char* items = strchr(name, '[');
		int count = items ? (items[1] == 'S' ? SCREE_MAX_VERTICES : atoi(items + 1)) : 1;
		found += floats_in(type) * count;
		name[strcspn(name, "[")] = 0;
		bool exempt = AMONG(without_length, type_name);
		if (!exempt && (!listed || (listed->count > 0 && !lists(listed, name))))
			fail_msg("%s.%s has no power of length in src/world/units/unit_types.def", type_name, name);
		if (exempt && listed)
			fail_msg("%s is twice in src/world/units/unit_types.def", type_name);
	}
	return found;
}

static void each_member_has_a_power(void** state)
{
	(void)state;
	char *text = read_header(), name[80];
	int members = 0;
	for (char* at = text; (at = strstr(at, "\ntypedef struct scree_")); ++at)
	{
		char *end = strstr(at, "\n}"), *line = strchr(at + 1, '\n');
		if (!end || !line || line[1] != '{' || sscanf(at, "\ntypedef struct %79[a-z_]", name) != 1 ||
		    strcmp(name, "scree_vec") == 0)
			continue;
		int floats = 0, listed = 0;
		for (; line && line < end; line = strchr(line + 1, '\n'))
			floats += check_line(name, line + 1);
		const UnitType* type = type_named(name);
		for (int m = 0; type && m < type->count; ++m)
			listed += type->members[m].power == POINTS ? 0 : type->members[m].floats;
		if (type && listed != floats)
			fail_msg("%s has %d floats, and src/world/units/unit_types.def lists %d", name, floats, listed);
		members += floats;
	}
	assert_true(members > 300);
	free(text);
}

// Each float and vector among the arguments of a call has a power, and each power belongs to such an argument.
static void each_argument_has_a_power(void** state)
{
	(void)state;
	int found = 0, listed = 0;
	for (int c = 0; c < UNITS_CALLS; ++c)
		for (int k = 0; k < unit_calls[c].count; ++k)
		{
			UnitTypeId type = unit_calls[c].arguments[k].type;
			int power = unit_argument_power((UnitCallId)c, unit_calls[c].arguments[k].name);
			bool plain = type == UNIT_float || type == UNIT_scree_vec;
			if (plain != (power != INT_MAX))
				fail_msg("scree_%s, argument %s: src/world/units/unit_arguments.def is wrong", unit_calls[c].name,
				         unit_calls[c].arguments[k].name);
			found += plain;
		}
#define ARGUMENT(call, argument, power) ++listed;
#include "world/units/unit_arguments.def"
	assert_int_equal(found, listed);
}

static bool converted(const char* name)
{
	for (int c = 0; c < UNITS_CALLS; ++c)
		if (strcmp(unit_calls[c].name, name) == 0)
			return true;
	return false;
}

// Each function that takes a world and has an argument with floats is converted, or has no lengths.
static void each_function_is_converted(void** state)
{
	(void)state;
	char *text = read_header(), name[80], arguments[1000];
	int found = 0;
	for (char* at = text; (at = strstr(at, "\nSCREE_API ")); ++at)
	{
		if (sscanf(at, "\nSCREE_API %*[a-z_] scree_%79[a-z_](%999[^;]", name, arguments) != 2)
			continue;
		if (!strstr(arguments, "scree_world* world"))
			continue;
		bool has = false;
		for (int k = 0; k < UNIT_TYPE_COUNT; ++k)
		{
			char* type = strstr(arguments, unit_types[k].name);
			size_t length = strlen(unit_types[k].name);
			has |= type && (type[length] == ' ' || type[length] == '*');
		}
		if (has && converted(name) == AMONG(without_lengths, name))
			fail_msg("scree_%s is neither converted nor without lengths (src/world/record/plain_calls.def)", name);
		found += has;
	}
	assert_true(found > 80);
	free(text);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(each_member_has_a_power),
	    cmocka_unit_test(each_argument_has_a_power),
	    cmocka_unit_test(each_function_is_converted),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
