// SPDX-License-Identifier: MIT
// unit_list.c -- the tables of converted calls and types, which follow from the lists.
#include "world/units/unit_list.h"
#include <limits.h>
#include <stddef.h>
#include <string.h>

// clang-format off
#define BEGIN(type) static const UnitMember lengths_##type[] = {
#define MEMBER_ROW(type, member, power) \
	{#member, (uint16_t)offsetof(type, member), (uint16_t)(sizeof(((type*)0)->member) / (sizeof(float))), power},
#define MEMBER(type, member, power) MEMBER_ROW(type, member, power)
#define END(type) {NULL, 0, 0, 0}};
#include "world/units/unit_types.def"

// true if a type begins with its size
#define IS_SIZED(type) _Generic((type*)0, scree_attribute_def*: true, scree_material_pair*: true, scree_body_def*: true, \
	scree_collidable_def*: true, scree_path_def*: true, scree_joint_def*: true, scree_blast_def*: true,                   \
	scree_mover_def*: true, scree_field_def*: true, scree_tuning*: true, scree_draw_def*: true, scree_surface*: true, default: false)

const UnitType unit_types[UNIT_TYPE_COUNT] = {
#define X(type) {#type, (uint32_t)sizeof(type), IS_SIZED(type), lengths_##type, (int)(sizeof lengths_##type / sizeof(UnitMember)) - 1},
UNIT_TYPES(X)
#undef X
};

#define TYPE_CASE(type) type*: UNIT_##type,
#define ID_OF(type)     _Generic((type*)0, UNIT_TYPES(TYPE_CASE) default: UNIT_NONE)
#define ROW_OF(kind, type, name) {#name, ARGUMENT_##kind, ID_OF(type)}
#define ROW(k, argument) ROW_OF argument
#define ONE(k, argument) 1
#define CALL_ROW(name, ...) {#name, (int)(sizeof((char[]){EACH(ONE, __VA_ARGS__)})), {EACH(ROW, __VA_ARGS__)}},

const UnitCall unit_calls[UNITS_CALLS] = {
#define CALL(name, ...) CALL_ROW(name, __VA_ARGS__)
#include "world/record/recorded_calls.def"
#define READ(name, ...) CALL_ROW(name, __VA_ARGS__)
#include "world/record/reading_calls.def"
#define PLAIN_LENGTHS(name, ...) CALL_ROW(name, __VA_ARGS__)
#include "world/record/plain_calls.def"
};
// clang-format on

static const struct
{
	UnitCallId call;
	const char* argument;
	int power;
} argument_powers[] = {
#define ARGUMENT(call, argument, power) {UNITS_##call, #argument, power},
#include "world/units/unit_arguments.def"
};

int unit_argument_power(UnitCallId call, const char* argument)
{
	for (size_t k = 0; k < sizeof argument_powers / sizeof *argument_powers; ++k)
		if (argument_powers[k].call == call && strcmp(argument_powers[k].argument, argument) == 0)
			return argument_powers[k].power;
	return INT_MAX;
}
