// SPDX-License-Identifier: MIT
// make_attribute.c -- makes calls of attributes and materials for random programs.
#include "programs/make.h"

void set_surface(Maker* m, Call* call)
{
	call_set(call, "density",
	         chance(m, 0.3) ? PICK(m, 0.0f, 1e-6f, 0.01f, 100.0f, 1e6f, 1e9f) : between(m, 0.1f, 3.0f));
	call_set(call, "friction",
	         chance(m, 0.1) ? PICK(m, 0.0f, 1e-45f, 10.0f, 1e3f, 1e6f, FLT_MAX) : between(m, 0.0f, 1.0f));
	if (m->extras && chance(m, 0.6))
	{
		call_set(call, "restitution", PICK(m, 0.0f, 0.5f, 1.0f, 1.5f));
		call_set(call, "rolling", chance(m, 0.1) ? PICK(m, 1e-30f, 100.0f, 1e6f) : between(m, 0.0f, 0.3f));
		call_set(call, "tangent", chance(m, 0.5) ? 0.0f : bounded(m, 3.0f));
	}
	if (m->rules && chance(m, 0.5))
		call_set(call, "material", (float)(chance(m, 0.05) ? PICK(m, 255.0f, 256.0f, -1.0f) : below(m, 4)));
	if (m->rules && chance(m, 0.4))
	{
		call_set(call, "way_x", chance(m, 0.5) ? 0.0f : bounded(m, 1.0f));
		call_set(call, "way_y", chance(m, 0.7) ? 1.0f : bounded(m, 1.0f));
	}
}

void put_attribute(Maker* m)
{
	static const CallKind kinds[] = {CALL_box,     CALL_box,     CALL_circle,  CALL_circle, CALL_capsule,
	                                 CALL_segment, CALL_polygon, CALL_polygon, CALL_hull};
	Call call = call_make(kinds[below(m, 9)]);
	call_set(&call, "attribute", (float)m->attributes++);
	float size = chance(m, 0.1) ? PICK(m, 0.002f, 0.01f, 5.0f, 30.0f) : between(m, 0.125f, 0.75f);
	switch (call.kind)
	{
	case CALL_box:
		call_set(&call, "width", 2.0f * size);
		call_set(&call, "height", chance(m, 0.5) ? 2.0f * size : between(m, 0.02f, 1.5f));
		break;
	case CALL_circle:
		call_set(&call, "radius", size);
		if (chance(m, 0.2))
			call_set(&call, "x", between(m, -0.5f, 0.5f));
		break;
	case CALL_capsule:
		call_set(&call, "radius", 0.5f * size);
		call_set(&call, "x", -size);
		call_set(&call, "x2", size);
		call_set(&call, "y2", between(m, -0.2f, 0.2f));
		break;
	case CALL_segment:
		call_set(&call, "x", -4.0f * size);
		call_set(&call, "x2", 4.0f * size);
		break;
	case CALL_polygon:
		call_set(&call, "corners", (float)(3 + below(m, 6)));
		call_set(&call, "width", 2.0f * size);
		call_set(&call, "height", 2.0f * size);
		call_set(&call, "angle", angle(m));
		call_set(&call, "radius", chance(m, 0.4) ? 0.2f * size : 0.0f);
		break;
	default:
		call_set(&call, "points", (float)(3 + below(m, 6)));
		call_set(&call, "seed", (float)below(m, 1000));
		call_set(&call, "size", 2.0f * size);
		call_set(&call, "radius", chance(m, 0.3) ? 0.1f * size : 0.0f);
	}
	set_surface(m, &call);
	put(m, call);
}

float any_attribute(Maker* m) { return (float)below(m, m->attributes + chance(m, 0.01)); }

// Adds an attribute with the shape of an existing attribute and with another surface.
void put_like(Maker* m)
{
	Call call = call_make(CALL_like);
	call_set(&call, "of", any_attribute(m));
	call_set(&call, "attribute", (float)m->attributes++);
	set_surface(m, &call);
	put(m, call);
}

// Adds a call that destroys any attribute, which may be in use or already destroyed.
void put_drop(Maker* m)
{
	Call call = call_make(CALL_drop);
	call_set(&call, "attribute", any_attribute(m));
	put(m, call);
}

void put_material(Maker* m)
{
	Call call = call_make(CALL_material);
	call_set(&call, "a", (float)below(m, 4));
	call_set(&call, "b", chance(m, 0.05) ? PICK(m, 255.0f, 256.0f, -1.0f) : (float)below(m, 4));
	if (chance(m, 0.3))
		call_set(&call, "friction", factor(m, 1.0f));
	if (chance(m, 0.3))
		call_set(&call, "restitution", PICK(m, 0.0f, 0.5f, 1.0f, 1.5f, 101.0f));
	if (chance(m, 0.3))
		call_set(&call, "tangent", bounded(m, 3.0f));
	call_set(&call, "ignored", chance(m, 0.3));
	call_set(&call, "unset", chance(m, 0.2));
	put(m, call);
}
