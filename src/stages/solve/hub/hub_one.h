// SPDX-License-Identifier: MIT
// hub_one.h -- turns contacts into spokes, splits neighbors into parts and merges them: kernels over single items.
#ifndef HUB_ONE_H
#define HUB_ONE_H
#include "constraints/solver_body.h"
#include "stages/color/edge.h"
#include "stages/color/key_bound.h"
#include "stages/color/spoke.h"

// Frees the color of contact i if one of its bodies became a hub: the contact becomes a spoke. Stages that are repeated with
// larger pools have not found yet which contacts begin and end.
KERNEL(hub_enter)
{
	int color = p->contact_color[i];
	Int2 bodies = p->contact_bodies[i];
	if (color < 0 || color == COLORS || p->counters->stalled || !hub_wants(p, bodies))
		return;
	edge_free_color(p, bodies, color);
	p->contact_color[i] = COLORS;
	raise_int(&p->counters->entered, 1);
	edge_mark_dirty(p, CONSTRAINT_CONTACT);
}

// Returns the hub number of a body, -1 if the body is not a hub.
INLINE int hub_number(const Pools* p, int body)
{
	int n = hub_bound(p, p->counters->hubs, body);
	return n < p->counters->hubs && p->hub[n] == body ? n : -1;
}

// Returns the hub to which the layout assigned spoke k, even if the user has changed masses since the layout.
INLINE int spoke_hub_of(const Pools* p, int k)
{
	int c = p->counters->layout[CONSTRAINT_CONTACT].begin[COLORS] + k, a = contact_row(p, body_a, c),
	    n = hub_number(p, a);
	if (n < 0)
		return contact_row(p, body_b, c);
	HubSpan span = hub_span_of(p, n);
	return c >= span.first && c < span.first + span.count ? a : contact_row(p, body_b, c);
}

INLINE int spoke_neighbor_of(const Pools* p, int k)
{
	int c = p->counters->layout[CONSTRAINT_CONTACT].begin[COLORS] + k;
	return contact_row(p, body_a, c) ^ contact_row(p, body_b, c) ^ spoke_hub_of(p, k);
}

INLINE int hub_key_spoke(Word64 key) { return (int)(key & (((Word64)1 << HUB_KEY_COLOR) - (Word64)1)); }

// Writes the key of spoke i: neighbor, hub color of the hub, and i. Padding and immovable neighbors come last.
KERNEL(hub_key)
{
	Word64 name = (Word64)0xffffffffu, turn = 0;
	int c = p->counters->layout[CONSTRAINT_CONTACT].begin[COLORS] + i;
	if (p->contact_place_slot[c] >= 0)
	{
		int hub = spoke_hub_of(p, i), n = hub_number(p, hub), neighbor = spoke_neighbor_of(p, i);
		if (hub_span_of(p, n).first == c)
			p->hub_colors[hub] = 1 << hub_color(p, n);
		if (p->body[neighbor].inv_mass > 0.0f)
		{
			name = (Word64)neighbor;
			turn = (Word64)hub_color(p, n);
		}
	}
	p->key[i] = name << 32 | turn << HUB_KEY_COLOR | (Word64)i;
	spoke_at(p, parts, i) = 1.0f;
	spoke_at(p, hub_parts, i) = 1.0f;
}

// Item: a key, sorted by neighbor, hub color and hub. Computes the number of parts of the neighbor. Hubs of one color
// at the neighbor get equal parts, also the neighbor if it is such a hub. The part of a hub is split equally among its
// spokes with the neighbor. argument: number of spokes.
KERNEL(hub_order)
{
	Word64 body = p->key[i] >> 32, group = p->key[i] >> HUB_KEY_COLOR;
	int spoke = hub_key_spoke(p->key[i]), turn = (int)(group & (Word64)(HUB_COLORS - 1));
	p->spoke_order[i] = -1;
	if (body == (Word64)0xffffffffu)
		return;
	int first = key_bound(p->key, 0, i, group << HUB_KEY_COLOR),
	    end = key_bound(p->key, i + 1, p->argument, (group + (Word64)1) << HUB_KEY_COLOR);
	int own = hub_number(p, (int)body), shares = own >= 0 && hub_color(p, own) == turn, hubs = shares, beside = 0;
	for (int k = first; k < end; ++hubs)
	{
		HubSpan span = hub_span_of(p, hub_number(p, spoke_hub_of(p, hub_key_spoke(p->key[k]))));
		Word64 behind = (Word64)(spoke_of(p, span.first) + span.count);
		int next = key_bound(p->key, k + 1, end, group << HUB_KEY_COLOR | behind);
		if (k <= i && i < next)
			beside = next - k;
		k = next;
	}
	if (i == first && (i == 0 || p->key[i - 1] >> 32 != body))
	{
		int turns = own >= 0 ? 1 << hub_color(p, own) : 0;
		for (int t = 0, k = i; t < HUB_COLORS; ++t)
		{
			int next = key_bound(p->key, k, p->argument, (body * HUB_COLORS + (Word64)(t + 1)) << HUB_KEY_COLOR);
			turns |= k < next ? 1 << t : 0;
			k = next;
		}
		p->hub_colors[(int)body] = turns;
	}
	p->spoke_order[i] = spoke * HUB_COLORS + turn;
	p->spoke_run[i] = make_int2(first, end);
	spoke_at(p, parts, spoke) = (float)(hubs * beside);
	if (hubs * beside == 1)
		return;
	raise_int(&p->counters->split, p->argument);
	if (shares && i == first)
		spoke_at(p, hub_parts, spoke_of(p, hub_span_of(p, own).first)) = (float)hubs;
}

// Returns the spoke of key i if this is the first key of a split neighbor in hub color `turn`; otherwise -1.
INLINE int hub_merged(const Pools* p, int i, int turn)
{
	int order = p->spoke_order[i], spoke = order / HUB_COLORS;
	if (order < 0 || order % HUB_COLORS != turn || p->spoke_run[i].x != i || spoke_at(p, parts, spoke) == 1.0f)
		return -1;
	return spoke;
}

// Returns the hub number of a neighbor that is itself a hub of the hub color `turn`; otherwise -1.
INLINE int hub_within(const Pools* p, int body, int turn)
{
	int n = hub_number(p, body);
	return n >= 0 && hub_color(p, n) == turn ? n : -1;
}

// Merges a split body: adds to its velocity the changes of its parts, each times the part's fraction of the mass. The
// item of the body's first key adds them in a fixed order; its part as a hub comes first. argument: hub color.
KERNEL(hub_merge)
{
	int spoke = hub_merged(p, i, p->argument);
	if (spoke < 0)
		return;
	Int2 run = p->spoke_run[i];
	int body = spoke_neighbor_of(p, spoke), n = hub_within(p, body, p->argument);
	float row[8], x = 0.0f, y = 0.0f, w = 0.0f;
	read_row8((GLOBAL float*)p->body, body, row);
	if (n >= 0)
	{
		int first = spoke_of(p, hub_span_of(p, n).first);
		float parts = spoke_at(p, hub_parts, first);
		x = quotient(spoke_at(p, hub_x, first) - row[0], parts);
		y = quotient(spoke_at(p, hub_y, first) - row[1], parts);
		w = quotient(spoke_at(p, hub_w, first) - row[2], parts);
	}
	for (int k = run.x; k < run.y; ++k)
	{
		int m = p->spoke_order[k] / HUB_COLORS;
		float parts = spoke_at(p, parts, m);
		x = x + quotient(spoke_at(p, vx, m) - row[0], parts);
		y = y + quotient(spoke_at(p, vy, m) - row[1], parts);
		w = w + quotient(spoke_at(p, w, m) - row[2], parts);
	}
	p->body[body].vx = row[0] + x;
	p->body[body].vy = row[1] + y;
	p->body[body].w = row[2] + w;
}

#endif
