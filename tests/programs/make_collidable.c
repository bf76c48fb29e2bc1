// SPDX-License-Identifier: MIT
// make_collidable.c -- makes calls of collidables for random programs, and sets their values in calls of bodies.
#include "programs/make.h"

void set_filter(Maker* m, Call* call)
{
	if (!chance(m, 0.15))
		return;
	call_set(call, "category", (float)(1 + below(m, 3)));
	call_set(call, "mask", (float)(below(m, 5) - 1));
	call_set(call, "group", (float)(below(m, 5) - 2));
}

// Sets the events that a collidable reports, but only in half of the programs.
void set_reports(Maker* m, Call* call)
{
	if (m->reports && (call->kind == CALL_reports || chance(m, 0.3)))
		call_set(call, "reports", (float)below(m, m->rules ? 8 : 4));
}

// Makes some collidables sensors, but only in a third of the programs.
void set_sensor(Maker* m, Call* call)
{
	if (m->senses && (call->kind == CALL_sensor || chance(m, 0.15)))
		call_set(call, "sensor", (float)below(m, 8));
}

void set_place(Maker* m, Call* call)
{
	float x = bounded(m, 4.0f), y = bounded(m, 3.0f);
	if (chance(m, 0.05)) // places some objects far away
		x += of_any_sign(m, PICK(m, 100.0f, 3000.0f, 90000.0f));
	call_set(call, "x", x);
	call_set(call, "y", chance(m, 0.05) ? y : y + 3.0f);
	call_set(call, "angle", angle(m));
}

void put_collidable(Maker* m)
{
	CallKind kinds[] = {CALL_collidable, CALL_collidable, CALL_remove, CALL_filter,
	                    CALL_place,      CALL_dress,      CALL_dress,  CALL_reports};
	Call call = call_make(m->senses && chance(m, 0.1) ? CALL_sensor : kinds[below(m, m->reports ? 8 : 7)]);
	switch (call.kind)
	{
	case CALL_collidable:
		call_set(&call, "collidable", (float)m->collidables++);
		call_set(&call, "attribute", any_attribute(m));
		call_set(&call, "body", chance(m, 0.2) ? -1.0f : any_body(m));
		set_filter(m, &call);
		set_reports(m, &call);
		set_sensor(m, &call);
		set_place(m, &call);
		if (call_value(&call, "body") >= 0.0f && chance(m, 0.8))
		{
			call_set(&call, "x", bounded(m, 1.0f));
			call_set(&call, "y", bounded(m, 1.0f));
		}
		break;
	case CALL_place:
		call_set(&call, "collidable", (float)below(m, m->collidables + 1));
		set_place(m, &call);
		break;
	default:
		if (chance(m, 0.5))
			call_set(&call, "collidable", (float)below(m, m->collidables + 1));
		call_set(&call, "body", any_body(m));
		call_set(&call, "which", (float)below(m, 3));
		if (call.kind == CALL_filter)
			set_filter(m, &call);
		if (call.kind == CALL_reports)
			set_reports(m, &call);
		if (call.kind == CALL_sensor)
			set_sensor(m, &call);
		if (call.kind == CALL_dress)
			call_set(&call, "attribute", any_attribute(m));
	}
	put(m, call);
}
