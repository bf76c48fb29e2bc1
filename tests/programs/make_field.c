// SPDX-License-Identifier: MIT
// make_field.c -- makes calls of fields for random programs.
#include "programs/make.h"

#define MOST_FIELDS 24 // number of fields that a program can name: so few that calls often redefine existing fields

static void set_pose(Maker* m, Call* call)
{
	call_set(call, "x", bounded(m, 3.0f));
	call_set(call, "y", bounded(m, 3.0f));
	call_set(call, "angle", angle(m));
}

static float coefficient(Maker* m)
{
	return chance(m, 0.1) ? PICK(m, 0.0f, 1e-20f, 1e3f, 1e6f, 1e12f, 1.1e12f) : factor(m, 4.0f);
}

static void put_new(Maker* m)
{
	Call call = call_make(CALL_field);
	call_set(&call, "field", (float)below(m, MOST_FIELDS));
	call_set(&call, "type", (float)rarely_beyond(m, below(m, 6), 1));
	if (chance(m, 0.3))
		call_set(&call, "body", any_body(m));
	if (chance(m, 0.6))
		call_set(&call, "attribute", (float)below(m, m->attributes + 1));
	set_pose(m, &call);
	call_set(&call, "strength", chance(m, 0.1) ? PICK(m, 1e6f, -1e6f, 1e12f, 1e-30f) : amount(m, 30.0f));
	call_set(&call, "falloff", (float)rarely_beyond(m, below(m, 4), 1));
	call_set(&call, "radius", chance(m, 0.1) ? PICK(m, 1e-3f, 1e-4f, 1e5f) : between(m, 0.1f, 5.0f));
	call_set(&call, "softening", chance(m, 0.3) ? PICK(m, 0.0f, 1e-30f, 1e5f) : factor(m, 1.0f));
	call_set(&call, "ax", amount(m, 20.0f));
	call_set(&call, "ay", amount(m, 20.0f));
	call_set(&call, "fx", amount(m, 20.0f));
	call_set(&call, "fy", amount(m, 20.0f));
	call_set(&call, "vx", bounded(m, 10.0f));
	call_set(&call, "vy", bounded(m, 10.0f));
	call_set(&call, "density", coefficient(m));
	call_set(&call, "drag", coefficient(m));
	call_set(&call, "lift", coefficient(m));
	call_set(&call, "linear", coefficient(m));
	call_set(&call, "quadratic", coefficient(m));
	call_set(&call, "spin", coefficient(m));
	if (chance(m, 0.2))
		call_set(&call, "mask", (float)(1 + below(m, 3)));
	put(m, call);
}

void put_field(Maker* m)
{
	if (chance(m, 0.6))
	{
		put_new(m);
		return;
	}
	static const CallKind kinds[] = {CALL_field_destroy, CALL_field_pose, CALL_field_enabled};
	Call call = call_make(kinds[below(m, 3)]);
	call_set(&call, "field", (float)below(m, MOST_FIELDS));
	if (call.kind == CALL_field_pose)
		set_pose(m, &call);
	if (call.kind == CALL_field_enabled)
		call_set(&call, "enabled", (float)chance(m, 0.6));
	put(m, call);
}
