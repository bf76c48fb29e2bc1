// SPDX-License-Identifier: MIT
// press.h -- which bodies something kinematic presses into something static, through others between them.
//
// Whether a body in a static one is pressed there by something kinematic, which no load stops, or by what lies on it, cannot be told
// from its own contacts. So a press tells its way: a contact that is deep in something kinematic presses its other body along the
// normal, that one presses what lies in that direction, one contact further in each step. The way is at most PRESS_HOPS contacts long.
// Each contact is one hop less than the one before it, so a way without a press at its begin fades. A contact keeps its hops in its flags;
// bodies gather them anew in each step.
#ifndef PRESS_H
#define PRESS_H
#include "constraints/contact_listed.h"

// cosine of the angle to the direction of a press up to which a body hands it on. With less, a cart that is pushed along presses the floor.
#define PRESS_ALONG 0.15f

// A body's way: hops, and the direction in eighths of a bit... The larger one counts, and of equal hops any, but always the same.
INLINE int press_code(int hops, Vec direction)
{
	int x = (int)(127.0f * direction.x + 128.5f), y = (int)(127.0f * direction.y + 128.5f);
	return hops << 16 | x << 8 | y;
}

// How a body that has a way presses along a normal: hops left, 0 if it does not.
INLINE int press_left(int code, Vec normal)
{
	Vec direction = vec((float)(code >> 8 & 255) - 128.0f, (float)(code & 255) - 128.0f);
	int along = vec_dot(direction, normal) > PRESS_ALONG * 127.0f;
	return along && code >> 16 > 1 ? (code >> 16) - 1 : 0;
}

// Whether contact i pushes; then at gets its points.
INLINE int press_acts(const Pools* p, int i, ContactPoints* at)
{
	Word flags = p->contact_flags[i];
	Int2 pair = p->pair[i];
	if (i >= p->counters->live || pair.x < 0 || !(flags & CONTACT_TOUCHING) || flags & (CONTACT_DETECTED | CONTACT_ASKS))
		return 0;
	float a[8], b[8], manifold[16];
	load_rows8((GLOBAL float*)p->world_shape, pair.x, a);
	load_rows8((GLOBAL float*)p->world_shape, pair.y, b);
	load_rows8((GLOBAL float*)p->contact_manifold, 2 * i, manifold);
	load_rows8((GLOBAL float*)p->contact_manifold, 2 * i + 1, manifold + 8);
	*at = listed_points(p->attribute, a, b, manifold, flags, p->contact_feature[i]);
	return minimum(at->separation[0], at->separation[1]) < 0.0f;
}

// Contact i: what its bodies get of the ways that the last step left, and of presses.
STAGE(press_gather)
{
	ContactPoints at;
	Word flags = p->contact_flags[i];
	if (p->counters->stalled || i >= p->counters->live)
		return;
	int hops = (int)(flags >> CONTACT_HOPS & CONTACT_MOST_HOPS), presses = p->pair[i].x >= 0 && p->collidable_kind[p->pair[i].y] == KIND_KINEMATIC;
	if ((hops == 0 && !presses) || !press_acts(p, i, &at))
		return;
	int back = presses || (flags & CONTACT_BACK), body = p->collidable_body[back ? p->pair[i].x : p->pair[i].y];
	if (presses)
		hops = minimum(at.separation[0], at.separation[1]) < -PRESS_FROM ? CONTACT_MOST_HOPS : 0;
	if (hops > 0)
		atomic_max_int(&p->press_way[body], press_code(hops, back ? vec_neg(at.normal) : at.normal));
}

// Contact i: how it hands ways on. What is pressed into something static is marked for guard.
STAGE(press_hand_on)
{
	if (p->counters->stalled || i >= p->counters->live || p->pair[i].x < 0)
		return;
	ContactPoints at;
	Word flags = p->contact_flags[i];
	int body_a = p->collidable_body[p->pair[i].x], body_b = p->collidable_body[p->pair[i].y], kind = p->collidable_kind[p->pair[i].y];
	int way_a = body_a >= 0 ? p->press_way[body_a] : 0, way_b = body_b >= 0 && kind == KIND_DYNAMIC ? p->press_way[body_b] : 0, to = 0, back = 0;
	if ((way_a | way_b) != 0 && kind != KIND_KINEMATIC && press_acts(p, i, &at))
	{
		to = press_left(way_a, at.normal);
		back = press_left(way_b, vec_neg(at.normal));
		if (to > 0 && kind == KIND_STATIC)
			raise_int(&p->pressed[body_a], float_bits(-minimum(at.separation[0], at.separation[1])));
	}
	int hops = to > back ? to : back;
	hops = kind == KIND_DYNAMIC ? hops : 0;
	Word now = (flags & ~CONTACT_PRESS) | (Word)hops << CONTACT_HOPS | (back > to ? CONTACT_BACK : 0u);
	if (now != flags)
		p->contact_flags[i] = now;
	if (hops > 0)
		raise_int(&p->counters->ways, 1);
}

#endif
