// SPDX-License-Identifier: MIT
// recorded_calls.c -- the public functions that change a world: each calls its api_ function, and records the call if the world is
// recorded.
#include "world/record/recorder.h"
#include "world/world.h"

#ifndef SCREE_SMALL // api_calls.h

#define IS_RECORDED(world) (world && world->recorders.first)

// name and address of an argument
#define NAME_OF(kind, type, name)    name
#define ADDRESS_OF(kind, type, name) &name
#define AS_NAME(k, argument)         NAME_OF argument
#define AS_ADDRESS(k, argument)      ADDRESS_OF argument

#define CALL(name, ...)                                                            \
	scree_status scree_##name(scree_world* world, EACH(AS_PARAMETER, __VA_ARGS__)) \
	{                                                                              \
		if (!IS_RECORDED(world))                                                   \
			return api_##name(world, EACH(AS_NAME, __VA_ARGS__));                  \
		const void* const addresses[] = {EACH(AS_ADDRESS, __VA_ARGS__)};           \
		recorders_enter(world);                                                    \
		scree_status status = api_##name(world, EACH(AS_NAME, __VA_ARGS__));       \
		return recorders_leave(world, RECORDED_##name, addresses, status);         \
	}
#define STEP_CALL(name, ...)                                                               \
	scree_status scree_##name(scree_world* world, EACH(AS_PARAMETER, __VA_ARGS__))         \
	{                                                                                      \
		if (!IS_RECORDED(world))                                                           \
			return api_##name(world, EACH(AS_NAME, __VA_ARGS__));                          \
		const void* const addresses[] = {EACH(AS_ADDRESS, __VA_ARGS__)};                   \
		recorders_enter_step(world, RECORDED_##name, addresses);                           \
		return recorders_leave_step(world, api_##name(world, EACH(AS_NAME, __VA_ARGS__))); \
	}
#include "world/record/recorded_calls.def"
#endif
