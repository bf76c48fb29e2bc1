// SPDX-License-Identifier: MIT
// reading_calls.c -- the public functions that use the device of a world and do not change the world: each calls its api_
// function, calls it again if the device failed and the world goes on without it, and reports a failure.
#include "platform/fail_hook.h"
#include "world/recovery/recovery.h"
#include "world/world.h"

#ifndef SCREE_SMALL // api_calls.h

// call: the call of the api_ function. noted: the call changes the results of later ones.
#define REPEATED(name, call, noted)                          \
	if (!world || !world->recovery)                          \
		return call;                                         \
	scree_status status;                                     \
	++world->recorders.depth;                                \
	do                                                       \
		status = call;                                       \
	while (world_recovers(world, "scree_" #name, status));   \
	--world->recorders.depth;                                \
	recovery_read(world, #name, noted&& status == SCREE_OK); \
	return status;
#define READING_CALL(name, noted, ...)                                                                  \
	static scree_status repeated_##name(scree_world* world, EACH(AS_PARAMETER, __VA_ARGS__)){           \
	    REPEATED(name, api_##name(world, EACH(AS_NAME, __VA_ARGS__)),                                   \
	             noted)} scree_status scree_##name(scree_world* world, EACH(AS_PARAMETER, __VA_ARGS__)) \
	{                                                                                                   \
		REPORTED("scree_" #name, repeated_##name(world, EACH(AS_NAME, __VA_ARGS__)))                    \
	}
#define READ(name, ...)       READING_CALL(name, false, __VA_ARGS__)
#define READ_NOTED(name, ...) READING_CALL(name, true, __VA_ARGS__)
#define READ_ALONE(name)                                                                        \
	static scree_status repeated_##name(scree_world* world){                                    \
	    REPEATED(name, api_##name(world), false)} scree_status scree_##name(scree_world* world) \
	{                                                                                           \
		REPORTED("scree_" #name, repeated_##name(world))                                        \
	}
#include "world/record/reading_calls.def"
#endif
