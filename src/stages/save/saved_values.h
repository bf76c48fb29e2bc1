// SPDX-License-Identifier: MIT
// saved_values.h -- lists the values of a contact that saved_contacts.h packs, and predicts them.
#ifndef SAVED_VALUES_H
#define SAVED_VALUES_H
#include "stages/narrow_phase/narrow_phase.h"
#include "stages/rules/rule.h"
#include "stages/save/saved_contact.h"
#include "stages/save/saved_manifold.h"

typedef struct // flags of a contact, and the pose for which its manifold was computed
{
	int flags;
	Float4 relative; // pose of shape b in the frame of shape a
	Vec axes;        // rotation of shape a
} SavedTest;

typedef struct // other values of a contact, apart from those of its row
{
	int color;
	Int2 bodies, feature;
	float kept[5]; // normal and tangent impulses, rolling impulse
	Vec normal;
	Float4 on_a;
	float separation1, separation2;
	float reach, limit;
	int press;
	Float4 surface;
} SavedContact;

// Lists the values of a contact without a place on which predictions of others depend. t: values; s: predictions.
#define SAVED_TEST_VALUES(INT, NUMBER) \
	INT(t.flags, s.flags)              \
	NUMBER(t.relative.x, s.relative.x) \
	NUMBER(t.relative.y, s.relative.y) \
	NUMBER(t.relative.z, s.relative.z) \
	NUMBER(t.relative.w, s.relative.w) \
	NUMBER(t.axes.x, s.axes.x)         \
	NUMBER(t.axes.y, s.axes.y)

// Lists the other values of a contact that are mostly as predicted. c: values; e: predictions.
#define SAVED_CONTACT_VALUES(INT, NUMBER) \
	INT(c.color, e.color)                 \
	INT(c.bodies.x, e.bodies.x)           \
	INT(c.bodies.y, e.bodies.y)           \
	INT(c.feature.x, e.feature.x)         \
	INT(c.feature.y, e.feature.y)         \
	NUMBER(c.kept[0], e.kept[0])          \
	NUMBER(c.kept[1], e.kept[1])          \
	NUMBER(c.kept[2], e.kept[2])          \
	NUMBER(c.kept[3], e.kept[3])          \
	NUMBER(c.kept[4], e.kept[4])          \
	NUMBER(c.normal.x, e.normal.x)        \
	NUMBER(c.normal.y, e.normal.y)        \
	NUMBER(c.on_a.x, e.on_a.x)            \
	NUMBER(c.on_a.y, e.on_a.y)            \
	NUMBER(c.on_a.z, e.on_a.z)            \
	NUMBER(c.on_a.w, e.on_a.w)            \
	NUMBER(c.separation1, e.separation1)  \
	NUMBER(c.separation2, e.separation2)  \
	NUMBER(c.reach, e.reach)              \
	NUMBER(c.limit, e.limit)              \
	INT(c.press, 0)                       \
	NUMBER(c.surface.x, e.surface.x)      \
	NUMBER(c.surface.y, e.surface.y)      \
	NUMBER(c.surface.z, e.surface.z)      \
	NUMBER(c.surface.w, e.surface.w)

INLINE void saved_set_manifold(SavedContact* e, Manifold m)
{
	e->feature = make_int2(m.count > 0 ? m.feature[0] : -1, m.count > 1 ? m.feature[1] : -1);
	e->normal = m.normal;
	e->on_a = make_float4(m.point[0].x, m.point[0].y, m.point[1].x, m.point[1].y);
	e->separation1 = m.separation[0];
	e->separation2 = m.separation[1];
}

INLINE SavedTest saved_test_of(int flags, const float pose[6])
{
	SavedTest t;
	t.flags = flags;
	t.relative = make_float4(pose[0], pose[1], pose[2], pose[3]);
	t.axes = vec(pose[4], pose[5]);
	return t;
}

INLINE Frame saved_frame(SavedTest t)
{
	return frame_at(vec(t.relative.x, t.relative.y), vec(t.relative.z, t.relative.w));
}

// Returns the prediction for a contact without a place.
INLINE SavedTest saved_test_expected(const Pools* p, Int2 pair)
{
	float pose[SAVED_TEST];
	saved_pose(p, pair.x, pair.y, pose);
	return saved_test_of(0, pose);
}

// Returns the values that the place of a contact has saved.
INLINE SavedTest saved_test_at(const Pools* p, int place)
{
	const GLOBAL Word* row = saved_row(p, places, place);
	size_t by = saved_by(p, places);
	float pose[6];
	for (int k = 0; k < 6; ++k)
		pose[k] = bits_float((int)row[(SAVED_POSE + k) * by]);
	return saved_test_of((int)row[SAVED_FLAGS * by], pose);
}

// Returns the values of a contact that follow from its pair, its flags and its code, apart from the manifold.
OUT_OF_LINE SavedContact saved_expected(const Pools* p, Int2 pair, Word flags, int ahead)
{
	SavedContact e;
	int body_a = p->collidable_body[pair.x], body_b = p->collidable_body[pair.y];
	const GLOBAL Attribute* a = p->attribute + p->collidable_attribute[pair.x];
	const GLOBAL Attribute* b = p->attribute + p->collidable_attribute[pair.y];
	e.color = COLOR_NONE;
	e.bodies = make_int2(body_a < 0 ? 0 : body_a, body_b < 0 ? 0 : body_b);
	e.kept[0] = e.kept[1] = e.kept[2] = e.kept[3] = e.kept[4] = 0.0f;
	e.press = 0;
	e.reach = a->reach;
	int moved = p->collidable_flags[pair.x] | p->collidable_flags[pair.y];
	Real room = moved & COLLIDABLE_GRAINS ? sweep_room(&p->step, moved) : 1.0f;
	e.limit = ahead ? -1.0f : narrow_phase_distance(a, b, flags, 0.0f, room, 0.0f);
	e.surface = contact_surface_of(a, b);
	if (p->step.material_pairs > 0)
		e.surface = rule_surface(rule_materials(p, pair.x, pair.y), e.surface);
	saved_set_manifold(&e, no_manifold());
	return e;
}

INLINE int saved_manifold_is(SavedContact a, SavedContact b)
{
	return float_word(a.normal.x) == float_word(b.normal.x) && float_word(a.normal.y) == float_word(b.normal.y) &&
	       a.feature.x == b.feature.x && a.feature.y == b.feature.y &&
	       float_word(a.separation1) == float_word(b.separation1) &&
	       float_word(a.separation2) == float_word(b.separation2) && float_word(a.on_a.x) == float_word(b.on_a.x) &&
	       float_word(a.on_a.y) == float_word(b.on_a.y) && float_word(a.on_a.z) == float_word(b.on_a.z) &&
	       float_word(a.on_a.w) == float_word(b.on_a.w);
}

#endif
