// SPDX-License-Identifier: MIT
// api_calls.h -- declares the calls without recording, recovery and reports of failures: api_NAME does the work of scree_NAME.
// metric_NAME also records and repeats the call; it is in metres, without the conversion to the unit of the world
// (world/units/convert.h).
#ifndef API_CALLS_H
#define API_CALLS_H
#include "scree/scree.h"
#include "world/record/arguments.h"

// A build for WebAssembly has none of these: its api_NAME is scree_NAME itself, which saves 0.3 kB of the npm package.
#ifdef SCREE_SMALL
#define API_SYMBOL(name) __asm__("scree_" #name)
#else
#define API_SYMBOL(name)
#endif

#define CALL(name, ...)                                                                            \
	scree_status api_##name(scree_world* world, EACH(AS_PARAMETER, __VA_ARGS__)) API_SYMBOL(name); \
	scree_status metric_##name(scree_world* world, EACH(AS_PARAMETER, __VA_ARGS__)) API_SYMBOL(name);
#include "world/record/recorded_calls.def"

#define READ(name, ...)                                                                            \
	scree_status api_##name(scree_world* world, EACH(AS_PARAMETER, __VA_ARGS__)) API_SYMBOL(name); \
	scree_status metric_##name(scree_world* world, EACH(AS_PARAMETER, __VA_ARGS__)) API_SYMBOL(name);
#define READ_ALONE(name) scree_status api_##name(scree_world* world) API_SYMBOL(name);
#include "world/record/reading_calls.def"

#define PLAIN(name, ...) scree_status api_##name(EACH(AS_PARAMETER, __VA_ARGS__)) API_SYMBOL(name);
#include "world/record/plain_calls.def"

#endif
