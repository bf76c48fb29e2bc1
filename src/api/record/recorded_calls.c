// SPDX-License-Identifier: MIT
// recorded_calls.c -- the public functions that change a world: each calls its api_ function, calls it again if the device failed
// and the world goes on without it, records the call if the world is recorded, and reports a failure. Records are in metres.
#include "platform/fail_hook.h"
#include "world/record/recorder.h"
#include "world/recovery/recovery.h"
#include "world/units/convert.h"
#include "world/upload/readers.h"
#include "world/world.h"

#ifndef SCREE_SMALL // api_calls.h

#define IS_WATCHED(world) (world->recorders.first || world->recovery)

#define WATCHED_CALL(name, enter, leave, ...)                                         \
	scree_status metric_##name(scree_world* world, EACH(AS_PARAMETER, __VA_ARGS__))   \
	{                                                                                 \
		scree_status status;                                                          \
		if (!world)                                                                   \
			return api_##name(world, EACH(AS_NAME, __VA_ARGS__));                     \
		readers_enter(world);                                                         \
		if (!IS_WATCHED(world))                                                       \
		{                                                                             \
			status = api_##name(world, EACH(AS_NAME, __VA_ARGS__));                   \
			readers_leave(world);                                                     \
			return status;                                                            \
		}                                                                             \
		const void* const addresses[] = {EACH(AS_ADDRESS, __VA_ARGS__)};              \
		enter;                                                                        \
		do                                                                            \
			status = api_##name(world, EACH(AS_NAME, __VA_ARGS__));                   \
		while (world_recovers(world, "scree_" #name, status));                        \
		status = leave(world, RECORDED_##name, addresses, status);                    \
		readers_leave(world);                                                         \
		return status;                                                                \
	}                                                                                 \
	CONVERTED(metric_##name, name, __VA_ARGS__)                                       \
	scree_status scree_##name(scree_world* world, EACH(AS_PARAMETER, __VA_ARGS__))    \
	{                                                                                 \
		REPORTED("scree_" #name, converted_##name(world, EACH(AS_NAME, __VA_ARGS__))) \
	}
#define CALL(name, ...) WATCHED_CALL(name, recorders_enter(world), recorders_leave, __VA_ARGS__)
#define STEP_CALL(name, ...) \
	WATCHED_CALL(name, recorders_enter_step(world, RECORDED_##name, addresses), recorders_leave_step, __VA_ARGS__)
#include "world/record/recorded_calls.def"
#endif
