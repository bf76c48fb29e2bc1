// SPDX-License-Identifier: MIT
// make_wild.c -- makes calls of a fuzzer wild: arguments of any value, and forged handles.
#include "programs/make.h"
#include <string.h>

#define SHARE 0.06 // share of wild calls

static float wild_value(Maker* m)
{
	static const float values[] = {
	    0.0f,    -0.0f,   1.0f,    -1.0f,  2.0f,  NAN,   INFINITY,      -INFINITY,      FLT_MAX,  -FLT_MAX,
	    FLT_MIN, 1e-45f,  -1e-45f, 1e5f,   -1e5f, 1e30f, 2147483648.0f, -2147483648.0f, 65535.0f, 65536.0f,
	    8191.0f, 8192.0f, 255.0f,  256.0f, 1e6f,  1e-9f, 0.5f,          64.0f,          65.0f};
	int k = below(m, 40);
	uint32_t bits = take(m, k < 30 ? 0 : 4);
	float any;
	memcpy(&any, &bits, sizeof any);
	return k < (int)(sizeof values / sizeof *values) ? values[k] : any;
}

// Returns a number of objects or of calls in a batch. Thousands of bodies in one place would take minutes.
static float wild_count(Maker* m) { return PICK(m, -1.0f, 0.0f, 1.0f, 2.0f, 40.0f, NAN, -FLT_MAX); }

static void put_forge(Maker* m)
{
	Call call = call_make(CALL_forge);
	call_set(&call, "type", (float)below(m, 6));
	call_set(&call, "number", (float)below(m, 64));
	call_set(&call, "index", PICK(m, 0.0f, 1.0f, -1.0f, 1e5f, 65536.0f));
	call_set(&call, "generation", PICK(m, 0.0f, 1.0f, -1.0f, 2.0f, 1000.0f));
	program_add(m->program, call);
}

void make_wild(Maker* m, Call* call)
{
	const CallInfo* info = call_info(call->kind);
	if (!chance(m, SHARE) || info->count == 0)
		return;
	int k = below(m, info->count + 1);
	if (k == info->count && m->program->count == 0) // a program begins with its world
		return;
	if (k == info->count)
		put_forge(m);
	else
		call->value[k] = strcmp(info->names[k], "count") == 0 || strcmp(info->names[k], "bodies") == 0 ? wild_count(m)
		                                                                                               : wild_value(m);
}
