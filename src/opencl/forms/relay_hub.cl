// SPDX-License-Identifier: MIT
// relay_hub.cl -- the relay of a world with hubs: some groups take the hubs, the others the constraints that have colors.
//
// In each pass a body comes to its hubs first. So the group of a hub waits for the rows of the hub and of all its light
// ends as the pass before leaves them, solves them together (hub.h), and hands each on to its first color. A body that is
// split into parts is handed on by one work-item, when all of its parts have come.
//
// Tasks are taken in the order of passes and, within a pass, the turns of hubs, colors; and within a turn, hubs, split bodies: the first that is not done waits for
// none.
#include "opencl/forms/relay.cl"

// A body in a turn of hubs.
INLINE Side relay_side(const Pools* p, int body, int turn)
{
	Side side;
	uint turns = (uint)p->hub_turns[body];
	side.body = body;
	side.before = (int)popcount(turns & ((1u << turn) - 1u));
	side.moves = p->body[body].inv_mass > 0.0f;
	side.last = p->color_mask[body] == 0 && turns >> turn == 1u;
	return side;
}

// The body as pass q finds it. False when it never came.
INLINE bool relay_receive(const Pools* p, const Relay* r, Side side, int q, Body* b)
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
	bool ok = relay_wait(p, r, waits && schedule_moved(q) > 0, words + 2, relay_ticket(schedule_moved(q), 0), &b->d, &b->da, waits, words,
	                       relay_ticket(q, side.before), &b->v, &b->w);
	body_turn(b);
	return ok;
}

// A body goes on from a hub of pass q with another velocity, to the next hub, to its first color or to the next pass.
INLINE void relay_send_from_hub(const Pools* p, const Relay* r, Side side, int q, float vx, float vy, float w)
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
		// it came with the velocity, before
		volatile __global const ulong* moved = r->mailboxes + MAILBOX_WORDS * (ulong)side.body + 2;
		mailbox_unpack(MAILBOX_READ(moved), relay_ticket(schedule_moved(q), 0), &b.d.x, &b.d.y, &b.da);
	}
	relay_load_motion(p, r, side, q, m, base);
	relay_send_next(r, side, q, b);
	relay_finish_pass(p, r, side, q, b, m, base);
}

// Velocity of a part of a body, for the work-item that puts the parts together. Tags rise from pass to pass and begin
// below where they ended, so that nothing needs to be cleared.
INLINE void relay_send_part(volatile __global ulong* parts, int k, int q, float vx, float vy, float w)
{
	mailbox_write(parts + 2 * (ulong)k, (uint)q + 1u, vx, vy, w);
}

INLINE bool relay_receive_part(const Pools* p, const Relay* r, volatile __global ulong* parts, int k, int q, Vec* v, float* w)
{
	Vec none;
	float no;
	return relay_wait(p, r, true, parts + 2 * (ulong)k, (uint)q + 1u, v, w, false, parts, 0u, &none, &no);
}

// Pass q of hub n, by a group: nothing once fault is set, which it sets when something never came. Parts of light ends are
// named by their spoke, those of hubs come behind.
INLINE void relay_hub(const Pools* p, const Relay* r, volatile __global ulong* parts, int n, int q,
                      BENCH float* bench, volatile BENCH int* fault)
{
	Body b;
	int turn = hub_turn(n);
	Side own = relay_side(p, hub_span_of(p, n).body, turn);
	bool ok = relay_receive(p, r, own, q, &b);
	float row[8] = {b.v.x, b.v.y, b.w, b.inv_mass, b.d.x, b.d.y, b.da, b.inv_inertia};
	Hub h = hub_begin(p, n, row);
	HUB_EACH_COLUMN(c, &h)
	HUB_EACH_OF(i, c, &h)
	{
		Body light;
		ok = relay_receive(p, r, relay_side(p, spoke_light(p, &h, i), turn), q, &light) && ok;
		spoke_begin(p, &h, i, light);
	}
	if (!ok)
		*fault = 1;
	group_meet();
	if (*fault)
		return;
	hub_work(p, &h, schedule_pass(r->substeps, q), bench);

	// the hub itself comes behind its spokes
	group_meet();
	for (int k = group_lane(); k <= h.count; k += group_width())
	{
		int hub = k == h.count, m = spoke_of(p, h.first + (hub ? 0 : k));
		float vx = hub ? h.now[0] : spoke_at(p, vx, m), vy = hub ? h.now[1] : spoke_at(p, vy, m),
		      w = hub ? h.now[2] : spoke_at(p, w, m), count = hub ? spoke_at(p, hub_parts, m) : spoke_at(p, parts, m);
		if (count == 1.0f)
			relay_send_from_hub(p, r, hub ? own : relay_side(p, spoke_light(p, &h, h.first + k), turn), q, vx, vy, w);
		else
			relay_send_part(parts, hub ? spoke_places(p) + n : m, q, vx, vy, w);
	}
}

// A turn of pass q of the body that sorted end i begins, if it is split; as hub_merge.
INLINE bool relay_merge(const Pools* p, const Relay* r, volatile __global ulong* parts, int i, int q, int turn)
{
	int spoke = hub_merged(p, i, turn);
	if (spoke < 0)
		return true;
	Int2 run = p->spoke_run[i];
	int body = spoke_light_of(p, spoke), n = hub_within(p, body, turn);
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
		sum = vec((part.x - b.v.x) / count, (part.y - b.v.y) / count);
		w = (spin - b.w) / count;
	}
	for (int k = run.x; k < run.y; ++k)
	{
		if (!relay_receive_part(p, r, parts, p->spoke_order[k] / HUB_TURNS, q, &part, &spin))
			return false;
		float count = spoke_at(p, parts, p->spoke_order[k] / HUB_TURNS);
		sum = vec_add(sum, vec((part.x - b.v.x) / count, (part.y - b.v.y) / count));
		w = w + (spin - b.w) / count;
	}
	relay_send_from_hub(p, r, side, q, b.v.x + sum.x, b.v.y + sum.y, b.w + w);
	return true;
}

// As relay. The first hub_groups groups take hubs; the others take constraints, or all of it is left to one group. parts has
// room for spokes and hubs.
__kernel void relay_hubs(POOL_ARGUMENTS Step step, __global ulong* mailboxes, __global float4* stream, int substeps, int passes,
                         int bound, int spins, int spread, __global ulong* parts, int hub_groups)
{
	volatile __local int fault;
	__local float bench[GROUP_FLOATS];
	Pools pools = {POOL_NAMES step, 0};
	const Pools* p = &pools;
	Relay r = {mailboxes, substeps, passes, spins};
	if (bound >= 0 && ((__global const int*)p->counters)[bound] == 0)
		return;
	int group = (int)get_group_id(0), groups = (int)get_num_groups(0), lane = group_lane(), width = group_width();
	bool for_hubs = group < hub_groups, for_colors = groups == 1 || !for_hubs;
	int constraints = task_first(p->counters, COLORS), hubs = p->counters->hubs, spokes = spoke_places(p);
	int place = groups == 1 ? lane : (group - hub_groups) * width + lane;
	int stride = (groups == 1 ? width : (groups - hub_groups) * width) / spread;
	int begin = place % spread == 0 ? place / spread : constraints;
	if (get_global_id(0) == 0)
	{
		p->counters->nonfinite = 0;
		p->counters->held = 0;
		p->counters->first_nonfinite = 0x7fffffff;
	}
	if (lane == 0)
		fault = 0;
	group_meet();

	Registers u;
	if (for_hubs)
		for (int n = group; n < hubs; n += hub_groups)
		{
			Hub h;
			HubSpan span = hub_span_of(p, n);
			h.first = span.first;
			h.count = span.count;
			HUB_EACH_COLUMN(c, &h)
			HUB_EACH_OF(i, c, &h)
			{
				contact_prepare_item(p, i);
				if (p->step.round || p->step.rare)
					contact_prepare_rare_item(p, i);
			}
		}
	if (for_colors)
		for (int i = begin; i < constraints; i += stride)
		{
			u = registers_prepare(p, i, true);
			if (constraints > stride)
				registers_store(&u, stream, constraints, i);
		}
	for (int q = 0; q < passes; ++q)
	{
		bool ok = true;
		if (for_hubs)
		{
			for (int turn = 0; turn < HUB_TURNS && turn < hubs; ++turn)
			{
				for (int n = group; n < hubs; n += hub_groups)
					if (hub_turn(n) == turn)
						relay_hub(p, &r, parts, n, q, bench, &fault);
				if (p->counters->split > 0)
					for (int i = group * width + lane; i < spokes && ok; i += hub_groups * width)
						ok = relay_merge(p, &r, parts, i, q, turn);
				group_meet();
			}
			if (!ok)
				fault = 1;
			group_meet();
			if (fault)
			{
				// those who wait elsewhere look at it now and then
				*(volatile __global int*)&p->counters->fault = FAULT_TIMEOUT;
				return;
			}
		}
		for (int i = for_colors ? begin : constraints; i < constraints && ok; i += stride)
		{
			if (constraints > stride)
				u = registers_load(p, i, stream, constraints, i);
			ok = relay_task(p, &r, q, &u, false, &fault);
			if (constraints > stride && !u.inert)
				registers_update(&u, schedule_pass(substeps, q), stream, constraints, i);
		}
		if (!ok && !for_hubs)
			return;
	}
	if (!for_colors)
		return;
	for (int i = begin; i < constraints; i += stride)
	{
		if (constraints > stride)
			u = registers_load(p, i, stream, constraints, i);
		if (!u.inert)
			registers_stow(p, &u);
	}
}
