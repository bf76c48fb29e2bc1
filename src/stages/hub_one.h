// SPDX-License-Identifier: MIT
// hub_one.h -- what hubs need of single items: contacts that become spokes, light ends in parts, and together again.
#ifndef HUB_ONE_H
#define HUB_ONE_H
#include "stages/body.h"
#include "stages/spoke.h"

// All contacts of a body that became a hub give their colors back.
STAGE(hub_enter)
{
	int color = p->contact_color[i];
	Int2 bodies = p->contact_bodies[i];
	if (color == COLOR_NONE || color == COLORS || !hub_wants(p, bodies))
		return;
	Word64 others = ~((Word64)1 << color);
	atomic_and_word64(&p->color_mask[bodies.x], others);
	atomic_and_word64(&p->color_mask[bodies.y], others);
	p->contact_color[i] = COLORS;
	raise_int(&p->counters->entered, 1);
}

// the number of a hub, -1 for what is none
INLINE int hub_number(const Pools* p, int body)
{
	int low = 0, high = p->counters->hubs;
	while (low < high)
	{
		int middle = low + (high - low) / 2;
		if (p->hub[middle] < body)
			low = middle + 1;
		else
			high = middle;
	}
	return low < p->counters->hubs && p->hub[low] == body ? low : -1;
}

// the body at the other end of spoke k
INLINE int spoke_light_of(const Pools* p, int k)
{
	int c = p->counters->color_begin[COLORS] + k, a = constraint_at(p, body_a, c), b = constraint_at(p, body_b, c);
	return a ^ b ^ hub_owner(p, make_int2(a, b));
}

// The light end of spoke i, to be sorted by. What cannot move, and padding, goes last.
STAGE(hub_key)
{
	Word64 name = (Word64)0xffffffffu;
	if (p->constraint_contact[p->counters->color_begin[COLORS] + i] >= 0)
	{
		int light = spoke_light_of(p, i);
		if (p->body[light].inv_mass > 0.0f)
			name = (Word64)light;
	}
	p->key[i] = name << 32 | (Word64)i;
	spoke_at(p, parts, i) = 1.0f;
	spoke_at(p, hub_parts, i) = 1.0f;
}

// Into how many parts each light end is split. argument is the number of spokes: binary search for the run of the sorted
// end i.
STAGE(hub_order)
{
	Word64 body = p->key[i] >> 32;
	int spoke = (int)(p->key[i] & (Word64)0xffffffffu);
	p->spoke_order[i] = -1;
	if (body == (Word64)0xffffffffu)
		return;
	int low = 0, high = i;
	while (low < high)
	{
		int middle = low + (high - low) / 2;
		if (p->key[middle] >> 32 < body)
			low = middle + 1;
		else
			high = middle;
	}
	int first = low;
	low = i + 1;
	high = p->argument;
	while (low < high)
	{
		int middle = low + (high - low) / 2;
		if (p->key[middle] >> 32 == body)
			low = middle + 1;
		else
			high = middle;
	}
	int n = hub_number(p, (int)body), parts = low - first + (n >= 0);
	p->spoke_order[i] = spoke;
	p->spoke_run[i] = make_int2(first, low);
	spoke_at(p, parts, spoke) = (float)parts;
	if (parts == 1)
		return;
	raise_int(&p->counters->split, p->argument);
	if (n >= 0 && i == first)
		spoke_at(p, hub_parts, spoke_of(p, hub_span_of(p, n).first)) = (float)parts;
}

// A body that is split gets the mean of what its parts got, by the first of its ends: the hub that it may be, then the
// spokes in their order.
STAGE(hub_merge)
{
	int spoke = p->spoke_order[i];
	Int2 run = p->spoke_run[i];
	if (spoke < 0 || run.x != i || spoke_at(p, parts, spoke) == 1.0f)
		return;
	int body = spoke_light_of(p, spoke), n = hub_number(p, body);
	float row[8], x = 0.0f, y = 0.0f, w = 0.0f, parts = spoke_at(p, parts, spoke);
	read_row8((GLOBAL float*)p->body, body, row);
	if (n >= 0)
	{
		int first = spoke_of(p, hub_span_of(p, n).first);
		x = spoke_at(p, hub_x, first) - row[0];
		y = spoke_at(p, hub_y, first) - row[1];
		w = spoke_at(p, hub_w, first) - row[2];
	}
	for (int k = run.x; k < run.y; ++k)
	{
		int m = p->spoke_order[k];
		x = x + (spoke_at(p, vx, m) - row[0]);
		y = y + (spoke_at(p, vy, m) - row[1]);
		w = w + (spoke_at(p, w, m) - row[2]);
	}
	p->body[body].vx = row[0] + x / parts;
	p->body[body].vy = row[1] + y / parts;
	p->body[body].w = row[2] + w / parts;
}

#endif
