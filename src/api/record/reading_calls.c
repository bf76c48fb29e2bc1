// SPDX-License-Identifier: MIT
// reading_calls.c -- the public functions that use the device of a world and do not change the world: each calls its api_
// function, calls it again if the device failed and the world goes on without it, and reports a failure.
#include "platform/fail_hook.h"
#include "world/recovery/recovery.h"
#include "world/units/convert.h"
#include "world/upload/readers.h"
#include "world/world.h"

#ifndef SCREE_SMALL // api_calls.h

// call: the call of the api_ function. noted: the call changes the results of later ones.
#define REPEATED(name, call, noted)                              \
	scree_status status;                                         \
	if (!world->recovery)                                        \
		status = call;                                           \
	else                                                         \
	{                                                            \
		++world->recorders.depth;                                \
		do                                                       \
			status = call;                                       \
		while (world_recovers(world, "scree_" #name, status));   \
		--world->recorders.depth;                                \
		recovery_read(world, #name, noted&& status == SCREE_OK); \
	}
#define ALONE_CALL(name, call, noted) \
	if (!world)                       \
		return call;                  \
	readers_enter(world);             \
	REPEATED(name, call, noted)       \
	readers_leave(world);             \
	return status;
// Defines the public function of a call that metric_NAME makes in metres.
#define PUBLIC_CALL(name, ...)                                                        \
	CONVERTED(metric_##name, name, __VA_ARGS__)                                       \
	scree_status scree_##name(scree_world* world, EACH(AS_PARAMETER, __VA_ARGS__))    \
	{                                                                                 \
		REPORTED("scree_" #name, converted_##name(world, EACH(AS_NAME, __VA_ARGS__))) \
	}
#define READING_CALL(name, noted, ...)                                               \
	scree_status metric_##name(scree_world* world, EACH(AS_PARAMETER, __VA_ARGS__)){ \
	    ALONE_CALL(name, api_##name(world, EACH(AS_NAME, __VA_ARGS__)), noted)} PUBLIC_CALL(name, __VA_ARGS__)
// A world on the CPU is not recovered, and several threads read it. On another device they do so one after another.
#define READ_SHARED(name, ...)                                                      \
	scree_status metric_##name(scree_world* world, EACH(AS_PARAMETER, __VA_ARGS__)) \
	{                                                                               \
		if (!world || readers_parallel(world))                                      \
			return api_##name(world, EACH(AS_NAME, __VA_ARGS__));                   \
		bool locks = readers_lock(world);                                           \
		REPEATED(name, api_##name(world, EACH(AS_NAME, __VA_ARGS__)), false)        \
		readers_unlock(world, locks);                                               \
		return status;                                                              \
	}                                                                               \
	PUBLIC_CALL(name, __VA_ARGS__)
#define READ(name, ...)       READING_CALL(name, false, __VA_ARGS__)
#define READ_NOTED(name, ...) READING_CALL(name, true, __VA_ARGS__)
#define READ_ALONE(name)                                                                          \
	static scree_status repeated_##name(scree_world* world){                                      \
	    ALONE_CALL(name, api_##name(world), false)} scree_status scree_##name(scree_world* world) \
	{                                                                                             \
		REPORTED("scree_" #name, repeated_##name(world))                                          \
	}
#include "world/record/reading_calls.def"
#endif
