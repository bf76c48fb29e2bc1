// SPDX-License-Identifier: MIT
// make_own.c -- makes calls of bodies and collidables that own their shapes, and of surfaces, for random programs.
#include "programs/make.h"

static void put_own_bodies(Maker* m)
{
	Call call = call_make(CALL_own_bodies);
	int count = chance(m, 0.3) ? 1 + below(m, 8) : 0;
	call_set(&call, "body", (float)m->bodies);
	call_set(&call, "count", (float)count);
	call_set(&call, "of", any_attribute(m));
	call_set(&call, "type", PICK(m, 0.0f, 1.0f, 2.0f, 2.0f, 2.0f));
	call_set(&call, "dx", PICK(m, 0.0f, 0.5f, 1.0f));
	set_place(m, &call);
	if (chance(m, 0.3))
		call_set(&call, "vx", bounded(m, 4.0f));
	call_set(&call, "disabled", chance(m, 0.05));
	call_set(&call, "asleep", m->sleeps && chance(m, 0.2));
	set_surface(m, &call);
	m->bodies += count > 0 ? count : 1;
	m->alive += count > 0 ? count : 1;
	put(m, call);
}

static void put_own_collidable(Maker* m)
{
	Call call = call_make(CALL_own_collidable);
	call_set(&call, "collidable", (float)m->collidables++);
	call_set(&call, "of", any_attribute(m));
	call_set(&call, "body", chance(m, 0.2) ? -1.0f : any_body(m));
	call_set(&call, "x", bounded(m, 1.0f));
	call_set(&call, "y", bounded(m, 1.0f));
	set_surface(m, &call);
	put(m, call);
}

void put_own(Maker* m)
{
	int kind = below(m, 10);
	if (kind < 3 && m->alive < MOST_BODIES)
	{
		put_own_bodies(m);
		return;
	}
	if (kind < 4)
	{
		put_own_collidable(m);
		return;
	}
	Call call = call_make(kind < 9 ? CALL_surface : CALL_adopt);
	if (chance(m, 0.3))
		call_set(&call, "collidable", (float)below(m, m->collidables + 1));
	call_set(&call, "body", any_body(m));
	call_set(&call, "which", (float)below(m, 3));
	if (call.kind == CALL_adopt)
		call_set(&call, "attribute", any_attribute(m));
	else
	{
		call_set(&call, "friction", factor(m, 1.0f));
		if (m->extras && chance(m, 0.5))
		{
			call_set(&call, "restitution", PICK(m, 0.0f, 0.5f, 1.5f, 101.0f));
			call_set(&call, "rolling", factor(m, 0.3f));
			call_set(&call, "tangent", bounded(m, 3.0f));
		}
	}
	put(m, call);
}
