// SPDX-License-Identifier: MIT
// make.c -- makes a random program: a small world, then calls of all kinds with ordinary, odd and extreme values.
//
// Most programs are ordinary, so that bodies interact a lot. Some contain a few extreme values, and a few contain many.
#include "programs/make.h"

static void put_step(Maker* m)
{
	Call call = call_make(CALL_step);
	if (m->sleeps && chance(m, 0.5))
		call_set(&call, "dt", step_length(m));
	if (chance(m, 0.2))
		call_set(&call, "dt",
		         PICK(m, 0.0f, 0.0f, 0.0f, 1e-10f, 1e-9f, 1e-6f, 1e-4f, 1e-3f, 1.0f / 240.0f, 1.0f / 30.0f, 0.1f, 0.5f,
		              1.0f));
	if (chance(m, 0.2))
		call_set(&call, "substeps", PICK(m, 1.0f, 1.0f, 2.0f, 2.0f, 3.0f, 5.0f, 8.0f, 16.0f));
	put(m, call);
}

static void set_tuning(Maker* m, Call* call)
{
	if (chance(m, 0.3))
		call_set(call, "max_speed", PICK(m, 1e-3f, 1.0f, 20.0f, 1e5f));
	if (chance(m, 0.2))
		call_set(call, "threshold", PICK(m, 0.0f, 0.1f, FLT_MAX));
	if (chance(m, 0.2))
		call_set(call, "push", PICK(m, 0.0f, 0.1f, 30.0f, 1e5f));
	if (chance(m, 0.2))
	{
		call_set(call, "hertz", PICK(m, 1e-3f, 5.0f, 30.0f, 1e6f));
		call_set(call, "ratio", PICK(m, 0.0f, 0.1f, 1.0f, 1e6f));
	}
}

static void put_hits(Maker* m)
{
	Call call = call_make(CALL_hits);
	call_set(&call, "speed", factor(m, 4.0f));
	call_set(&call, "impulse", factor(m, 40.0f));
	put(m, call);
}

static void put_tuning(Maker* m)
{
	Call call = call_make(CALL_tuning);
	set_tuning(m, &call);
	set_sleep(m, &call);
	put(m, call);
}

static void put_gravity(Maker* m)
{
	Call call = call_make(CALL_gravity);
	call_set(&call, "x", amount(m, 5.0f));
	call_set(&call, "y", amount(m, 20.0f));
	put(m, call);
}

static void put_alone(Maker* m, CallKind kind, const char* name, float value)
{
	Call call = call_make(kind);
	call_set(&call, name, value);
	put(m, call);
}

static void put_ask(Maker* m)
{
	Call call = call_make(CALL_ask);
	call_set(&call, "seed", (float)below(m, 100000));
	call_set(&call, "x", bounded(m, 4.0f));
	call_set(&call, "y", bounded(m, 3.0f) + 3.0f);
	call_set(&call, "size", chance(m, 0.1) ? PICK(m, 0.0f, 1e-6f, 100.0f, 5e4f) : between(m, 0.5f, 6.0f));
	if (chance(m, 0.7))
		call_set(&call, "attribute", any_attribute(m));
	if (chance(m, 0.3))
		call_set(&call, "kinds", (float)below(m, 16));
	if (chance(m, 0.2))
		call_set(&call, "mask", (float)(1 + below(m, 3)));
	call_set(&call, "body", any_body(m));
	put(m, call);
}

static void put_blast(Maker* m)
{
	Call call = call_make(CALL_blast);
	call_set(&call, "x", bounded(m, 4.0f));
	call_set(&call, "y", bounded(m, 3.0f) + 3.0f);
	call_set(&call, "radius", chance(m, 0.1) ? PICK(m, 0.0f, 1e-6f, 100.0f, 1e5f) : between(m, 0.1f, 3.0f));
	call_set(&call, "falloff", chance(m, 0.1) ? PICK(m, 0.0f, 1e-6f, 1e5f) : between(m, 0.1f, 3.0f));
	call_set(&call, "impulse", amount(m, 5.0f));
	if (chance(m, 0.2))
		call_set(&call, "mask", (float)(1 + below(m, 3)));
	put(m, call);
}

static void put_walk(Maker* m)
{
	Call call = call_make(CALL_walk);
	call_set(&call, "body", any_body(m));
	call_set(&call, "x", bounded(m, 4.0f));
	call_set(&call, "y", bounded(m, 3.0f) + 3.0f);
	call_set(&call, "vx", bounded(m, 10.0f));
	call_set(&call, "vy", bounded(m, 10.0f));
	call_set(&call, "force", chance(m, 0.2) ? PICK(m, 0.0f, 1e-30f, 3e38f) : between(m, 1.0f, 3000.0f));
	if (chance(m, 0.3))
		call_set(&call, "radius", PICK(m, 0.0005f, 0.001f, 0.05f, 2.0f));
	if (chance(m, 0.1))
		call_set(&call, "dt", PICK(m, 0.0f, 1e-6f, 1.0f));
	if (chance(m, 0.2))
		call_set(&call, "mask", (float)(1 + below(m, 3)));
	put(m, call);
}

static void put_any(Maker* m)
{
	if (m->sleeps && chance(m, 0.12))
	{
		put_sleep(m);
		return;
	}
	// few calls are steps, because on a GPU a step takes as long as dozens of other calls
	int k = below(m, 100);
	if (m->saves && chance(m, 0.06))
		put(m, call_make(chance(m, 0.5) ? CALL_save : CALL_load));
	else if (k < 12)
	{
		put_step(m);
		if (m->rules && m->reports && chance(m, 0.7))
			put_alone(m, CALL_answer, "bits", (float)below(m, 256));
	}
	else if (k < 44)
		m->jointed&& k >= 32 ? chance(m, 0.4) ? put_joint(m) : put_joint_change(m) : put_motion(m);
	else if (k < 46 && m->railed)
		put_path(m);
	else if (k < 50 && m->fields)
		put_field(m);
	else if (k < 58)
		put_setting(m);
	else if (k < 69)
		chance(m, 0.3) ? put_own(m) : put_collidable(m);
	else if (k < 77)
		put_destroy(m);
	else if (k < 86)
		m->alive < MOST_BODIES ? put_body(m) : put_destroy(m);
	else if (k < 89)
		m->alive < MOST_BODIES - 20 ? put_bodies(m, 2 + below(m, 18)) : put_destroy(m);
	else if (k < 92)
		chance(m, 0.5) ? put_attribute(m) : chance(m, 0.5) ? put_like(m) : put_drop(m);
	else if (k < 95 && m->rules && chance(m, 0.5))
		put_material(m);
	else if (k < 96 && m->rules && m->reports)
		put_alone(m, CALL_answer, "bits", (float)below(m, 256));
	else if (k < 95)
		chance(m, 0.5) ? put_gravity(m) : chance(m, 0.8) ? put_tuning(m) : put_hits(m);
	else if (k < 96 && m->asks)
		chance(m, 0.6) ? put_ask(m) : chance(m, 0.5) ? put_blast(m) : put_walk(m);
	else if (k < 97)
		put_alone(m, m->moves ? CALL_move : CALL_step, m->moves ? "back" : "substeps",
		          m->moves ? (float)chance(m, 0.6) : 4.0f);
	else
		put_alone(m, CALL_read, "body", any_body(m));
}

static void put_world(Maker* m)
{
	Call call = call_make(CALL_world);
	m->extreme = chance(m, 0.2) ? 0.3f : 0.0f;
	if (chance(m, 0.3))
	{
		call_set(&call, "gravity_x", amount(m, 5.0f));
		call_set(&call, "gravity_y", amount(m, 20.0f));
	}
	set_tuning(m, &call);
	m->sleeps = chance(m, 0.5);
	set_sleep(m, &call);
	if (chance(m, 0.3))
		call_set(&call, "bodies", 200.0f);
	if (chance(m, 0.3))
		call_set(&call, "contacts", PICK(m, 1.0f, 3000.0f));
	m->extras = chance(m, 0.6);
	call_set(&call, "details", chance(m, 0.3));
	if (chance(m, 0.1))
		call_set(&call, "unit", PICK(m, 0.1f, 0.5f, 2.0f, 3.0f));
	put(m, call);
}

// Makes a program, except its first call.
static void make_calls(Maker* m, int calls)
{
	m->moves = chance(m, 0.01);
	m->jointed = chance(m, 0.7);
	m->railed = m->jointed && chance(m, 0.5);
	m->reports = chance(m, 0.5);
	m->asks = chance(m, 0.5);
	m->senses = chance(m, 0.35);
	m->rules = chance(m, 0.4);
	m->extreme = PICK(m, 0.0f, 0.0f, 0.01f, 0.03f, 0.1f, 0.4f);
	m->fields = chance(m, 0.4);
	m->sleeps = chance(m, 0.5);
	m->saves = chance(m, 0.25);
	if (m->sleeps && call_value(&m->program->calls[0], "sleep") == 0.0f)
		put_tuning(m);
	for (int k = 3 + below(m, 4); k > 0; --k)
		put_attribute(m);
	if (chance(m, 0.85))
		put_floor(m);
	if (chance(m, 0.04))
		put_hub(m);
	else
		for (int k = below(m, 4); k > 0; --k)
			put_bodies(m, 2 + below(m, 24));
	while (m->program->count < calls && (!m->bytes || m->left > 0))
		put_any(m);
	put_step(m);
	put_step(m);
}

void program_make(Program* program, uint64_t seed, int calls)
{
	Maker m = {.program = program, .seed = seed / PROGRAM_BLOCK};
	program->count = 0;
	random_word(&m.seed);
	put_world(&m);
	m.seed = seed ^ 0x5851f42d4c957f2du;
	random_word(&m.seed);
	make_calls(&m, calls);
}

void program_make_from(Program* program, const uint8_t* bytes, size_t size, int calls)
{
	Maker m = {.program = program, .bytes = bytes, .left = size};
	program->count = 0;
	put_world(&m);
	make_calls(&m, calls);
}
