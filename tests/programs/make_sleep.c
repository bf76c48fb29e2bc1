// SPDX-License-Identifier: MIT
// make_sleep.c -- makes calls of sleep for random programs, and sequences of steps in which bodies come to rest.
#include "programs/make.h"

void set_sleep(Maker* m, Call* call)
{
	call_set(call, "sleep", (float)(m->sleeps && chance(m, 0.95)));
	if (!m->sleeps)
		return;
	float speed = chance(m, 0.5) ? PICK(m, 0.5f, 1.0f, 2.0f, 5.0f) : between(m, 0.01f, 1.0f);
	call_set(call, "sleep_threshold",
	         chance(m, m->extreme) ? PICK(m, 1e-6f, 1e6f, 0.0f, NAN)
	         : speed < 0.01f       ? 0.01f
	                               : speed);
}

void set_asleep(Maker* m, Call* call)
{
	if (!m->sleeps)
		return;
	call_set(call, "asleep", (float)chance(m, 0.2));
	if (call->kind == CALL_bodies)
		return;
	call_set(call, "stays_awake", (float)chance(m, 0.03));
	if (chance(m, 0.2))
		call_set(call, "sleep_threshold", factor(m, 5.0f));
}

float step_length(Maker* m) { return PICK(m, 1.0f / 60.0f, 1.0f / 30.0f, 0.05f, 0.1f, 0.1f, 0.25f, 0.5f); }

// Adds steps whose lengths sum to 0.5 s or more, the time of rest after which bodies fall asleep. In some of these
// sequences the whole world sleeps from the first step on, so that the last steps are skipped. In others, each step is
// followed by a step of length 0, which moves nothing.
static void put_rest(Maker* m)
{
	Call call = call_make(CALL_awake_world);
	call_set(&call, "awake", 0.0f);
	if (chance(m, 0.4))
		put(m, call);
	call = call_make(CALL_step);
	call_set(&call, "dt", PICK(m, 0.05f, 0.1f, 0.1f, 0.25f, 0.5f));
	Call look = call_make(CALL_step);
	call_set(&look, "dt", 0.0f);
	bool looks = chance(m, 0.2);
	for (int k = 5 + below(m, 6); k > 0; --k)
	{
		put(m, call);
		if (looks)
			put(m, look);
	}
}

static void put_one(Maker* m, CallKind kind, const char* name, float value)
{
	Call call = call_make(kind);
	call_set(&call, "body", any_body(m));
	call_set(&call, name, value);
	put(m, call);
}

static void put_awake(Maker* m, CallKind kind)
{
	Call call = call_make(kind);
	if (kind != CALL_awake_get)
		call_set(&call, "awake", (float)chance(m, 0.3));
	if (kind == CALL_awake_box)
	{
		call_set(&call, "x", bounded(m, 4.0f));
		call_set(&call, "y", bounded(m, 3.0f));
		call_set(&call, "width", chance(m, 0.05) ? PICK(m, 0.0f, 1e-6f, 1e5f) : between(m, 0.5f, 6.0f));
		call_set(&call, "height", chance(m, 0.05) ? PICK(m, 0.0f, 1e-6f, 1e5f) : between(m, 0.5f, 6.0f));
	}
	else if (kind != CALL_awake_world)
	{
		call_set(&call, "body", any_body(m));
		if (chance(m, 0.5))
			call_set(&call, "count", (float)(1 + below(m, 20)));
	}
	put(m, call);
}

void put_sleep(Maker* m)
{
	int k = below(m, 100);
	if (k < 30)
		put_rest(m);
	else if (k < 55)
		put_awake(m, CALL_awake);
	else if (k < 63)
		put_awake(m, CALL_awake_box);
	else if (k < 75)
		put_awake(m, CALL_awake_world);
	else if (k < 90)
		put_awake(m, CALL_awake_get);
	else if (k < 95)
		put_one(m, CALL_sleep_threshold, "speed", factor(m, 5.0f));
	else
		put_one(m, CALL_stays_awake, "stays", (float)chance(m, 0.3));
}
