// SPDX-License-Identifier: MIT
// relay_hub.cl -- executes a solve as a relay in a world with hubs: some work-groups solve hubs, the others colors.
//
// In each pass, the hub colors of a body come first, then its colors. The work-group of a hub waits for its tickets in
// the mailboxes of the hub and its neighbors, solves all spokes together (hub.h), and sends each body to its next hub
// or first color. If a body is split into parts, one work-item adds up the parts and sends the body on.
//
// Order of tasks: by pass; in a pass, hub colors before colors; in a hub color, hubs before split bodies. The first
// unfinished task in this order never waits, so there is no deadlock.
#include "opencl/forms/relay.cl"

// Returns the side of a body in hub color `turn`; side.before: number of the body's hub colors before it.
INLINE Side relay_side(const Pools* p, int body, int turn)
{
	Side side;
	uint turns = (uint)p->hub_colors[body];
	side.body = body;
	side.before = (int)popcount(turns & ((1u << turn) - 1u));
	side.moves = p->body[body].inv_mass > 0.0f;
	side.last = p->color_mask[body] == 0 && turns >> turn == 1u;
	return side;
}

// Receives a body for pass q, or loads it if no task sends it. Returns false if its ticket did not arrive.
OUT_OF_LINE bool relay_receive(const Pools* p, const Relay* r, Side side, int q, Body* b)
{
	float row[8];
	volatile __global ulong* words = r->mailboxes + MAILBOX_WORDS * (ulong)side.body;
	bool waits = side.moves && (q > 0 || side.before > 0);
	if (waits)
		body_row(p, side.body, row);
	else
		body_alone(p, r->substeps, side.body, q, row);
	b->v = vec(row[0], row[1]);
	b->w = row[2];
	b->inv_mass = row[3];
	b->d = vec(row[4], row[5]);
	b->da = row[6];
	b->inv_inertia = row[7];
	bool ok = relay_wait(p, r, waits && schedule_moved(q) > 0, words + 2, relay_ticket(schedule_moved(q), 0), &b->d,
	                     &b->da, waits, words, relay_ticket(q, side.before), &b->v, &b->w);
	body_turn(b);
	return ok;
}

// Sends a body with its new velocity, computed in pass q of a hub, to its next hub, its first color or the next pass.
OUT_OF_LINE void relay_send_from_hub(const Pools* p, const Relay* r, Side side, int q, float vx, float vy, float w)
{
	Body b;
	float row[8], m[8], base[4];
	if (!side.moves)
		return;
	body_row(p, side.body, row);
	b.v = vec(vx, vy);
	b.w = w;
	b.inv_mass = row[3];
	b.d = vec(0.0f, 0.0f);
	b.da = 0.0f;
	b.inv_inertia = row[7];
	if (side.last && schedule_moved(q) > 0)
	{
		// this displacement arrived before the velocity, so no wait is needed
		volatile __global const ulong* moved = r->mailboxes + MAILBOX_WORDS * (ulong)side.body + 2;
		mailbox_unpack(MAILBOX_READ(moved), relay_ticket(schedule_moved(q), 0), &b.d.x, &b.d.y, &b.da);
	}
	relay_load_motion(p, r, side, q, m, base);
	relay_send_next(r, side, q, b);
	relay_finish_pass(p, r, side, q, b, m, base);
}

// Sends the velocity of a part of a body to the work-item that adds up the parts. Parts need not be cleared: a part
// from the last step has the ticket of the last pass, never 1, and pass 0 of this step overwrites it.
INLINE void relay_send_part(volatile __global ulong* parts, int k, int q, float vx, float vy, float w)
{
	mailbox_write(parts + 2 * (ulong)k, (uint)q + 1u, vx, vy, w);
}

INLINE bool relay_receive_part(const Pools* p, const Relay* r, volatile __global ulong* parts, int k, int q, Vec* v,
                               float* w)
{
	Vec none;
	float no;
	return relay_wait(p, r, true, parts + 2 * (ulong)k, (uint)q + 1u, v, w, false, parts, 0u, &none, &no);
}

// Executes pass q of hub n in a work-group. If a ticket did not arrive, sets *fault and solves nothing. parts: one part
// for the neighbor of each spoke, then one part for each hub.
INLINE_MEET void relay_hub(const Pools* p, const Relay* r, volatile __global ulong* parts, int n, int q,
                           LOCAL float* bench, volatile LOCAL int* fault)
{
	Body b;
	int turn = hub_color(p, n);
	Side own = relay_side(p, hub_span_of(p, n).body, turn);
	bool ok = relay_receive(p, r, own, q, &b);
	float row[8] = {b.v.x, b.v.y, b.w, b.inv_mass, b.d.x, b.d.y, b.da, b.inv_inertia};
	Hub h = hub_begin(p, n, row);
	HUB_EACH_COLUMN(c, &h)
	HUB_EACH_OF(i, c, &h)
	{
		Body neighbor;
		ok = relay_receive(p, r, relay_side(p, spoke_neighbor(p, &h, i), turn), q, &neighbor) && ok;
		spoke_begin(p, &h, i, neighbor);
	}
	if (!ok)
		*fault = 1;
	group_meet();
	if (*fault)
		return;
	hub_work(p, &h, schedule_pass(r->substeps, q), bench);

	// index h.count, after the spokes, is the hub itself
	group_meet();
	for (int k = group_lane(); k <= h.count; k += group_width())
	{
		int hub = k == h.count, m = spoke_of(p, h.first + (hub ? 0 : k));
		float vx = hub ? h.now[0] : spoke_at(p, vx, m), vy = hub ? h.now[1] : spoke_at(p, vy, m),
		      w = hub ? h.now[2] : spoke_at(p, w, m), count = hub ? spoke_at(p, hub_parts, m) : spoke_at(p, parts, m);
		if (count == 1.0f)
			relay_send_from_hub(p, r, hub ? own : relay_side(p, spoke_neighbor(p, &h, h.first + k), turn), q, vx, vy, w);
		else
			relay_send_part(parts, hub ? spoke_places(p) + n : m, q, vx, vy, w);
	}
}

// Adds up the parts of a split body in pass q of hub color `turn`, like the kernel hub_merge, and sends the body on; i:
// index of its first spoke in spoke_order (otherwise does nothing). Returns false if a ticket did not arrive.
OUT_OF_LINE bool relay_merge(const Pools* p, const Relay* r, volatile __global ulong* parts, int i, int q, int turn)
{
	int spoke = hub_merged(p, i, turn);
	if (spoke < 0)
		return true;
	Int2 run = p->spoke_run[i];
	int body = spoke_neighbor_of(p, spoke), n = hub_within(p, body, turn);
	Side side = relay_side(p, body, turn);
	Body b;
	Vec part, sum = vec(0.0f, 0.0f);
	float spin, w = 0.0f;
	if (!relay_receive(p, r, side, q, &b))
		return false;
	if (n >= 0)
	{
		if (!relay_receive_part(p, r, parts, spoke_places(p) + n, q, &part, &spin))
			return false;
		float count = spoke_at(p, hub_parts, spoke_of(p, hub_span_of(p, n).first));
		sum = vec(quotient(part.x - b.v.x, count), quotient(part.y - b.v.y, count));
		w = quotient(spin - b.w, count);
	}
	for (int k = run.x; k < run.y; ++k)
	{
		if (!relay_receive_part(p, r, parts, p->spoke_order[k] / HUB_COLORS, q, &part, &spin))
			return false;
		float count = spoke_at(p, parts, p->spoke_order[k] / HUB_COLORS);
		sum = vec_add(sum, vec(quotient(part.x - b.v.x, count), quotient(part.y - b.v.y, count)));
		w = w + quotient(spin - b.w, count);
	}
	relay_send_from_hub(p, r, side, q, b.v.x + sum.x, b.v.y + sum.y, b.w + w);
	return true;
}

typedef struct // the tasks of a work-group and a work-item
{
	bool hubs, colors;                // true: the work-group solves hubs; it solves constraints with colors
	int group, hub_groups, hub_count; // the work-group solves hubs `group`, `group` + hub_groups, ... below hub_count
	int spokes;                       // number of spokes, including padding
	int begin, stride, constraints;   // the work-item solves constraints `begin`, `begin` + `stride`, and so on
	bool streamed;                    // false: the work-item has one constraint, which stays in registers
	__global float4* stream;
} HubTasks;

INLINE HubTasks hub_tasks(const Pools* p, __global float4* stream, int spread, int hub_groups)
{
	HubTasks t;
	int groups = (int)get_num_groups(0), lane = group_lane(), width = group_width();
	t.group = (int)get_group_id(0);
	t.hub_groups = hub_groups;
	t.hubs = t.group < hub_groups;
	t.colors = groups == 1 || !t.hubs;
	t.constraints = task_first(p->counters, COLORS);
	t.hub_count = p->counters->hubs;
	t.spokes = spoke_places(p);
	int place = groups == 1 ? lane : (t.group - hub_groups) * width + lane;
	t.stride = (groups == 1 ? width : (groups - hub_groups) * width) / spread;
	t.begin = place % spread == 0 ? place / spread : t.constraints;
	t.streamed = t.constraints > t.stride;
	t.stream = stream;
	return t;
}

INLINE void hub_tasks_prepare_hubs(const Pools* p, const HubTasks* t)
{
	for (int n = t->group; n < t->hub_count; n += t->hub_groups)
	{
		Hub h;
		HubSpan span = hub_span_of(p, n);
		h.first = span.first;
		h.count = span.count;
		HUB_EACH_COLUMN(c, &h)
		HUB_EACH_OF(i, c, &h)
		{
			contact_prepare_item(p, i);
			if (p->step.round || STEP_RARE(p->step))
				contact_prepare_rare_item(p, i);
		}
	}
}

INLINE void hub_tasks_prepare_colors(const Pools* p, const HubTasks* t, Registers* u)
{
	for (int i = t->begin; i < t->constraints; i += t->stride)
	{
		*u = registers_prepare(p, i, true);
		if (t->streamed)
			registers_store(u, t->stream, t->constraints, i);
	}
}

// Executes pass q of the hubs of a work-group. Returns false in all work-items of the group if a ticket did not arrive.
INLINE_MEET bool hub_tasks_pass_hubs(const Pools* p, const Relay* r, const HubTasks* t, volatile __global ulong* parts,
                                     int q, LOCAL float* bench, volatile LOCAL int* fault)
{
	bool ok = true;
	int width = group_width();
	for (int turn = 0; turn < HUB_COLORS && turn < t->hub_count; ++turn)
	{
		for (int n = t->group; n < t->hub_count; n += t->hub_groups)
			if (hub_color(p, n) == turn)
				relay_hub(p, r, parts, n, q, bench, fault);
		if (p->counters->split > 0)
			for (int i = t->group * width + group_lane(); i < t->spokes && ok; i += t->hub_groups * width)
				ok = relay_merge(p, r, parts, i, q, turn);
		group_meet();
	}
	if (!ok)
		*fault = 1;
	group_meet();
	return !*fault;
}

// Executes pass q of the constraints of a work-item. Returns false if a ticket did not arrive.
INLINE_MEET bool hub_tasks_pass_colors(const Pools* p, const Relay* r, const HubTasks* t, int q, Registers* u,
                                       volatile LOCAL int* fault)
{
	bool ok = true;
	for (int i = t->colors ? t->begin : t->constraints; i < t->constraints && ok; i += t->stride)
	{
		if (t->streamed)
			*u = registers_load(p, i, t->stream, t->constraints, i);
		ok = relay_task(p, r, q, u, false, fault);
		if (t->streamed && !u->inert)
			registers_update(u, schedule_pass(r->substeps, q), t->stream, t->constraints, i);
	}
	return ok;
}

INLINE void hub_tasks_store_colors(const Pools* p, const HubTasks* t, Registers* u)
{
	for (int i = t->begin; i < t->constraints; i += t->stride)
	{
		if (t->streamed)
			*u = registers_load(p, i, t->stream, t->constraints, i);
		if (!u->inert)
			registers_store_kept(p, u);
	}
}

// Executes all passes like relay_tasks, but the first hub_groups work-groups solve hubs, and the other groups solve
// constraints with colors. A single work-group solves both. parts: two 64-bit words per spoke and per hub.
INLINE_MEET void relay_hub_tasks(const Pools* p, const Relay* r, __global float4* stream, int bound, int spread,
                                 __global ulong* parts, int hub_groups, LOCAL float* bench, volatile LOCAL int* fault)
{
	if (bound >= 0 && ((__global const int*)p->counters)[bound] == 0)
		return;
	HubTasks tasks = hub_tasks(p, stream, spread, hub_groups);
	if (get_global_id(0) == 0)
		counters_clear(p);
	if (group_lane() == 0)
		*fault = 0;
	group_meet();

	Registers u;
	if (tasks.hubs)
		hub_tasks_prepare_hubs(p, &tasks);
	if (tasks.colors)
		hub_tasks_prepare_colors(p, &tasks, &u);
	for (int q = 0; q < r->passes; ++q)
	{
		if (tasks.hubs && !hub_tasks_pass_hubs(p, r, &tasks, parts, q, bench, fault))
		{
			// spin-waits of other work-groups end when they read this flag
			*(volatile __global int*)&p->counters->fault = FAULT_TIMEOUT;
			return;
		}
		if (!hub_tasks_pass_colors(p, r, &tasks, q, &u, fault) && !tasks.hubs)
			return;
	}
	if (tasks.colors)
		hub_tasks_store_colors(p, &tasks, &u);
}

#define RELAY_HUBS_KERNEL(name, specialize)                                                                      \
	__kernel void name(POOL_ARGUMENTS Step step, __global ulong* mailboxes, __global float4* stream, int substeps, \
	                   int passes, int bound, int spins, int spread, __global ulong* parts, int hub_groups)        \
	{                                                                                                            \
		volatile __local int fault;                                                                              \
		__local float bench[GROUP_FLOATS];                                                                       \
		Pools pools = {POOL_NAMES step, 0};                                                                      \
		Relay r = {mailboxes, substeps, passes, spins};                                                          \
		specialize(pools.step);                                                                                  \
		STEP_ALONE(pools.step);                                                                                  \
		relay_hub_tasks(&pools, &r, stream, bound, spread, parts, hub_groups, bench, &fault);                    \
	}
RELAY_HUBS_KERNEL(relay_hubs, STEP_CONTACTS)
RELAY_HUBS_KERNEL(relay_hubs_hinges, STEP_HINGES)
RELAY_HUBS_KERNEL(relay_hubs_joints, STEP_JOINTS)
