// SPDX-License-Identifier: MIT
// repeat.c -- makes a call of a recording again: a function for each recorded call, which follows from the list.
#include "world/record/repeat.h"

#define VALUE_OF(k, kind, type)     *(kind##_TYPE(type)*)values[k]
#define VALUE_(k, kind, type, name) VALUE_OF(k, kind, type)
#define SPREAD(k, ...)              VALUE_(k, __VA_ARGS__)
#define UNPACKED(...)               __VA_ARGS__
#define VALUE(k, argument)          SPREAD(k, UNPACKED argument)

#define CALL(name, ...)                                                        \
	static scree_status repeat_##name(scree_world* world, void* const* values) \
	{                                                                          \
		return metric_##name(world, EACH(VALUE, __VA_ARGS__));                 \
	}
#include "world/record/recorded_calls.def"

static scree_status (*const repeated[RECORDED_CALLS])(scree_world* world, void* const* values) = {
#define CALL(name, ...) repeat_##name,
#include "world/record/recorded_calls.def"
};

scree_status call_repeat(scree_world* world, const CallArguments* arguments)
{
	return repeated[arguments->call](world, arguments->values);
}
