// SPDX-License-Identifier: MIT
// plain_calls.c -- the public functions that are neither recorded nor repeated: each calls its api_ function, and reports a failure.
#include "platform/exact_floats.h"
#include "platform/fail_hook.h"
#include "world/units/convert.h"

#ifndef SCREE_SMALL // api_calls.h

#define PLAIN(name, ...)                                                 \
	scree_status scree_##name(EACH(AS_PARAMETER, __VA_ARGS__))           \
	{                                                                    \
		REPORTED("scree_" #name, api_##name(EACH(AS_NAME, __VA_ARGS__))) \
	}
#define PLAIN_LENGTHS(name, ...)                                               \
	CONVERTED_PLAIN(name, __VA_ARGS__)                                         \
	scree_status scree_##name(EACH(AS_PARAMETER, __VA_ARGS__))                 \
	{                                                                          \
		REPORTED("scree_" #name, converted_##name(EACH(AS_NAME, __VA_ARGS__))) \
	}
#include "world/record/plain_calls.def"
#endif
