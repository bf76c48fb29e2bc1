// SPDX-License-Identifier: MIT
// relay.cl -- the whole solve in one launch without meetings: each body is handed from constraint to constraint.
//
// The colors order the constraints of each body. That order is all that the result depends on: a constraint may be
// solved as soon as the one before it on each of its two bodies has been, whatever the rest of the world does. So each
// body has a row of words, of which each holds a component and the turn of which it is; the constraint whose turn it is
// polls the row, solves, and writes the row for the next turn. A word is read and written at once, and only by the one
// whose turn it is, so there is nothing to fence. The last constraint of a body in a pass moves the body on. What a run
// per color and a meeting after it cost, 3.3 us, becomes the way of one word through the second-level cache.
//
// It needs all work-items on the device at once, and those of a group to advance each on its own: relay_probe tries.
// Every work-item takes its tasks in the order of passes and, within a pass, of colors. The first task that is not done
// waits for none, so that all get done.
#include "opencl/limits.h"
#include "pools/pools.h"

// A row: two words of velocity, two of displacement. 96 bits of components and twice a turn of 16.
#define PAUSE_NS 50

// Waits a moment, so that those whose turn is near get through.
#ifdef __NV_CL_C_VERSION
#define PAUSE(ns) asm volatile("nanosleep.u32 %0;" ::"r"((uint)(ns)))
#else
#define PAUSE(ns)
#endif

typedef struct // what every task knows
{
	volatile __global ulong* rows; // zero when a step begins
	int substeps;
	int passes; // warm start, bias and relax of every substep, and bounce
	int spins;
} Relay;

// Of pass q, the turn of the constraint before which so many others of the body come. A pass has as many turns as there
// are bits in a body's mask.
INLINE uint relay_turn(int q, int before) { return RELAY_TURNS * (uint)q + (uint)before + 1u; }

// Three components out of two words. False when it is not their turn.
INLINE bool relay_open(ulong2 words, uint turn, float* x, float* y, float* z)
{
	*x = as_float((uint)(words.x >> 32));
	*y = as_float((uint)(words.y >> 32));
	*z = as_float((uint)words.x << 16 | ((uint)words.y & 0xffffu));
	return (uint)words.x >> 16 == turn && (uint)words.y >> 16 == turn;
}

INLINE void relay_give(volatile __global ulong* row, uint turn, float x, float y, float z)
{
	ulong first = (ulong)as_uint(x) << 32 | turn << 16 | as_uint(z) >> 16;
	ulong second = (ulong)as_uint(y) << 32 | turn << 16 | (as_uint(z) & 0xffffu);
	*(volatile __global ulong2*)row = (ulong2)(first, second);
}

// After the last turn of a step nobody waits for the row any more.
INLINE void relay_clear(volatile __global ulong* row)
{
	for (int k = 0; k < RELAY_WORDS; ++k)
		row[k] = 0;
}

INLINE void relay_row(const Pools* p, int body, float row[8])
{
	BodyState state = p->body[body];
	row[0] = state.vx;
	row[1] = state.vy;
	row[2] = state.w;
	row[3] = state.inv_mass;
	row[4] = 0.0f;
	row[5] = 0.0f;
	row[6] = 0.0f;
	row[7] = state.inv_inertia;
}

INLINE void relay_motion(const Pools* p, int body, float m[8])
{
	Motion motion = p->motion[body];
	m[0] = motion.fx;
	m[1] = motion.fy;
	m[2] = motion.torque;
	m[3] = motion.gravity_scale;
	m[4] = motion.linear_damping;
	m[5] = motion.angular_damping;
	m[6] = motion.free_x;
	m[7] = motion.free_y;
}

INLINE void relay_keep(const Pools* p, int body, const float row[8])
{
	GLOBAL BodyState* state = p->body + body;
	state->vx = row[0];
	state->vy = row[1];
	state->w = row[2];
	state->dx = row[4];
	state->dy = row[5];
	state->da = row[6];
}

INLINE int relay_bits(const float v[3]) { return float_bits(v[0]) | float_bits(v[1]) | float_bits(v[2]); }

// The row of a body that no constraint pushes, as pass q finds it. It is worked out by whoever asks: a row in memory
// would have to wait for its last reader.
INLINE void relay_alone(const Pools* p, const Relay* r, int body, int q, float row[8])
{
	float m[8], base[4];
	relay_row(p, body, row);
	relay_motion(p, body, m);
	base[0] = row[0];
	base[1] = row[1];
	base[2] = row[2];
	int before = 1, after = relay_bits(row) | relay_bits(base);
	for (int k = 1; k <= q && k <= 2 * r->substeps && (before | after); ++k)
	{
		// from rest to rest: so it will stay
		before = after;
		if (k & 1)
			body_accelerate(&p->step, row, m, base, k == 1);
		else
			body_move(&p->step, row, m);
		after = relay_bits(row) | relay_bits(base);
	}
}

typedef struct // one body of a constraint
{
	int body, before; // of its constraints, so many come before this one in a pass
	bool moves, last; // last: no other constraint of the body comes after this one
} Side;

INLINE Side relay_side(const Pools* p, int body, int color)
{
	Side side;
	Word64 mask = p->color_mask[body];
	side.body = body;
	side.moves = p->body[body].inv_mass > 0.0f;
	side.before = (int)popcount(mask & (((Word64)1 << color) - (Word64)1));
	side.last = mask >> color == (Word64)1;
	return side;
}

// A body to the next constraint of the pass.
INLINE void relay_pass_to(const Relay* r, Side side, int q, Body body)
{
	if (side.moves && !side.last)
		relay_give(r->rows + RELAY_WORDS * (ulong)side.body, relay_turn(q, side.before + 1), body.v.x, body.v.y, body.w);
}

// A body by the last constraint of pass q: on to the next pass, or into the pool at the end.
INLINE void relay_pass_on(const Pools* p, const Relay* r, Side side, int q, Body body, float m[8], float base[4])
{
	if (!side.moves || !side.last)
		return;
	float row[8] = {body.v.x, body.v.y, body.w, body.inv_mass, body.d.x, body.d.y, body.da, body.inv_inertia};
	volatile __global ulong* words = r->rows + RELAY_WORDS * (ulong)side.body;
	if (q + 1 == r->passes)
	{
		relay_keep(p, side.body, row);
		relay_clear(words);
		return;
	}
	uint turn = relay_turn(q + 1, 0);
	bool moves_on = q < 2 * r->substeps; // or bounce follows relax at once
	if (moves_on && !(q & 1))
		body_accelerate(&p->step, row, m, base, q == 0);
	if (moves_on && q & 1)
	{
		body_move(&p->step, row, m);
		relay_give(words + 2, turn, row[4], row[5], row[6]);
	}
	relay_give(words, turn, row[0], row[1], row[2]);
	if (moves_on && !(q & 1))
		p->base[side.body] = make_float4(base[0], base[1], base[2], 0.0f);
}

// What a side needs before its turn comes: the row of a body that does not move, and what the last one will move on with.
INLINE void relay_ready(const Pools* p, const Relay* r, Side side, int q, Body* body, float m[8], float base[4])
{
	if (!side.moves || (q == 0 && side.before == 0))
	{
		float row[8];
		relay_alone(p, r, side.body, side.moves ? 0 : q, row);
		body->v = vec(row[0], row[1]);
		body->w = row[2];
		body->d = vec(row[4], row[5]);
		body->da = row[6];
	}
	if (side.moves && side.last)
	{
		relay_motion(p, side.body, m);
		if (q == 0)
		{
			BodyState state = p->body[side.body];
			base[0] = state.vx;
			base[1] = state.vy;
			base[2] = state.w;
		}
		else if (!(q & 1))
		{
			Float4 old = p->base[side.body];
			base[0] = old.x;
			base[1] = old.y;
			base[2] = old.z;
		}
	}
}

// Waits until three components of two rows have come. False when that took too long, here or elsewhere.
INLINE bool relay_wait(const Pools* p, const Relay* r, bool wait_a, volatile __global ulong* row_a, uint turn_a,
                       Vec* a, float* wa, bool wait_b, volatile __global ulong* row_b, uint turn_b, Vec* b, float* wb)
{
	for (int spins = r->spins; wait_a || wait_b; --spins)
	{
		if (wait_a)
			wait_a = !relay_open(*(volatile __global const ulong2*)row_a, turn_a, &a->x, &a->y, wa);
		if (wait_b)
			wait_b = !relay_open(*(volatile __global const ulong2*)row_b, turn_b, &b->x, &b->y, wb);
		if (wait_a || wait_b)
			PAUSE(PAUSE_NS);
		if (spins <= 0 || ((spins & 1023) == 0 && read_shared(&p->counters->fault)))
			return false;
	}
	return true;
}

typedef struct // a constraint in registers
{
	Pair c;
	Side side[2];
	float friction;
	float separation[2];         // of the points at the start of the step
	float gap[2];                // now
	float normal[2], tangent[2]; // impulses
	float normal_mass[2], tangent_mass[2];
	bool inert;
} Runner;

// Of constraint i: what it is made of, but for its sides.
INLINE Runner relay_make(const Pools* p, int i, const Prepared* made)
{
	Runner u;
	u.inert = false;
	u.c.ia = constraint_at(p, body_a, i);
	u.c.ib = constraint_at(p, body_b, i);
	BodyState a = p->body[u.c.ia], b = p->body[u.c.ib];
	u.c.a.inv_mass = a.inv_mass;
	u.c.a.inv_inertia = a.inv_inertia;
	u.c.a.d = vec(0.0f, 0.0f);
	u.c.a.da = 0.0f;
	u.c.b.inv_mass = b.inv_mass;
	u.c.b.inv_inertia = b.inv_inertia;
	u.c.b.d = u.c.a.d;
	u.c.b.da = 0.0f;
	u.c.n = made->normal;
	u.c.t = vec(made->normal.y, -made->normal.x);
	u.friction = constraint_at(p, friction, i);
	u.normal[0] = constraint_at(p, normal_impulse1, i);
	u.normal[1] = constraint_at(p, normal_impulse2, i);
	u.tangent[0] = constraint_at(p, tangent_impulse1, i);
	u.tangent[1] = constraint_at(p, tangent_impulse2, i);
	for (int k = 0; k < 2; ++k)
	{
		u.separation[k] = made->separation[k];
		u.c.ra[k] = made->anchor[k];
		u.c.rb[k] = vec_add(made->anchor[k], made->offset);
		u.normal_mass[k] = pair_mass(&u.c, k, u.c.n);
		u.tangent_mass[k] = pair_mass(&u.c, k, u.c.t);
	}
	return u;
}

// Constraint i, which may be none.
INLINE Runner relay_prepare(const Pools* p, int i, int cleanse)
{
	Runner u;
	int slot = p->constraint_contact[i];
	u.inert = slot < 0;
	if (u.inert)
		return u;
	if (cleanse)
		cleanse_item(p, i);
	Prepared made = prepare_points(p, p->constraint_pair[i], slot);
	if (p->step.extras)
		prepare_extras(p, i, &made);
	u = relay_make(p, i, &made);
	int color = p->contact_color[slot];
	u.side[0] = relay_side(p, u.c.ia, color);
	u.side[1] = relay_side(p, u.c.ib, color);
	return u;
}

// Its impulses, for the next step.
INLINE void relay_stow(const Pools* p, int i, const Runner* u)
{
	constraint_at(p, normal_impulse1, i) = u->normal[0];
	constraint_at(p, normal_impulse2, i) = u->normal[1];
	constraint_at(p, tangent_impulse1, i) = u->tangent[0];
	constraint_at(p, tangent_impulse2, i) = u->tangent[1];
}

// A runner that does not stay in registers lies in columns of n: RELAY_QUADS of float4s, then RELAY_PAIRS of float2s, of
// which the last two are its impulses.
INLINE __global float2* relay_pairs(__global float4* notes, int n, int i)
{
	return (__global float2*)(notes + RELAY_QUADS * n) + i;
}

INLINE void relay_note_impulses(const Runner* u, __global float4* notes, int n, int i)
{
	__global float2* pair = relay_pairs(notes, n, i);
	pair[(RELAY_PAIRS - 2) * n] = (float2)(u->normal[0], u->normal[1]);
	pair[(RELAY_PAIRS - 1) * n] = (float2)(u->tangent[0], u->tangent[1]);
}

INLINE void relay_leave(const Runner* u, __global float4* notes, int n, int i)
{
	int turns = -1;
	if (!u->inert)
	{
		Pair c = u->c;
		__global float2* pair = relay_pairs(notes, n, i);
		turns = 0;
		for (int k = 0; k < 2; ++k)
			turns |= (u->side[k].before | u->side[k].moves << 6 | u->side[k].last << 7) << (8 * k);
		notes[n + i] = (float4)(c.n.x, c.n.y, c.b.inv_mass, c.b.inv_inertia);
		notes[2 * n + i] = (float4)(c.ra[0].x, c.ra[0].y, c.ra[1].x, c.ra[1].y);
		pair[0] = (float2)(c.rb[0].x, c.rb[0].y);
		pair[n] = (float2)(c.rb[1].x, c.rb[1].y);
		pair[2 * n] = (float2)(u->separation[0], u->separation[1]);
		pair[3 * n] = (float2)(c.a.inv_mass, c.a.inv_inertia);
		pair[4 * n] = (float2)(u->normal_mass[0], u->normal_mass[1]);
		pair[5 * n] = (float2)(u->tangent_mass[0], u->tangent_mass[1]);
		relay_note_impulses(u, notes, n, i);
	}
	notes[i] = (float4)(as_float(turns), as_float(u->c.ia), as_float(u->c.ib), u->friction);
}

INLINE Side relay_side_of(int body, int turns)
{
	Side side;
	side.body = body;
	side.before = turns & 63;
	side.moves = turns >> 6 & 1;
	side.last = turns >> 7 & 1;
	return side;
}

INLINE Runner relay_return(__global float4* notes, int n, int i)
{
	Runner u;
	__global const float2* pair = relay_pairs(notes, n, i);
	float4 names = notes[i], normal = notes[n + i], on_a = notes[2 * n + i];
	float2 gaps = pair[2 * n], mass_a = pair[3 * n], normal_mass = pair[4 * n], tangent_mass = pair[5 * n];
	float2 push = pair[6 * n], rub = pair[7 * n];
	int turns = as_int(names.x);
	u.inert = turns < 0;
	u.c.ia = as_int(names.y);
	u.c.ib = as_int(names.z);
	u.side[0] = relay_side_of(u.c.ia, turns);
	u.side[1] = relay_side_of(u.c.ib, turns >> 8);
	u.c.n = vec(normal.x, normal.y);
	u.c.t = vec(normal.y, -normal.x);
	u.c.ra[0] = vec(on_a.x, on_a.y);
	u.c.ra[1] = vec(on_a.z, on_a.w);
	u.c.rb[0] = vec(pair[0].x, pair[0].y);
	u.c.rb[1] = vec(pair[n].x, pair[n].y);
	u.c.a.inv_mass = mass_a.x;
	u.c.a.inv_inertia = mass_a.y;
	u.c.a.d = vec(0.0f, 0.0f);
	u.c.a.da = 0.0f;
	u.c.b.inv_mass = normal.z;
	u.c.b.inv_inertia = normal.w;
	u.c.b.d = u.c.a.d;
	u.c.b.da = 0.0f;
	u.friction = names.w;
	u.separation[0] = gaps.x;
	u.separation[1] = gaps.y;
	u.normal[0] = push.x;
	u.normal[1] = push.y;
	u.tangent[0] = rub.x;
	u.tangent[1] = rub.y;
	u.normal_mass[0] = normal_mass.x;
	u.normal_mass[1] = normal_mass.y;
	u.tangent_mass[0] = tangent_mass.x;
	u.tangent_mass[1] = tangent_mass.y;
	return u;
}

// The passes of solve.h for what is in registers.
INLINE void relay_bias(const Step* step, Runner* u)
{
	for (int k = 0; k < 2; ++k)
		u->normal[k] = pair_normal(&u->c, k, u->gap[k], u->normal_mass[k], u->normal[k], step, 1);
}

INLINE void relay_relax(const Pools* p, int i, Runner* u)
{
	float speed = p->step.extras ? extra_at(p, tangent_speed, i) : 0.0f;
	for (int k = 0; k < 2; ++k)
		u->tangent[k] = pair_tangent(&u->c, k, u->tangent_mass[k], speed, u->friction * u->normal[k], u->tangent[k]);
	for (int k = 0; k < 2; ++k)
		u->normal[k] = pair_normal(&u->c, k, u->gap[k], u->normal_mass[k], u->normal[k], &p->step, 0);
	if (p->step.extras)
	{
		pair_roll(p, i, &u->c, u->normal[0] + u->normal[1]);
		pair_peak(p, i, u->normal[0], u->normal[1]);
	}
}

INLINE void relay_bounce(const Pools* p, int i, Runner* u)
{
	relay_stow(p, i, u);
	bounce_pass(p, i, &u->c);
	u->normal[0] = constraint_at(p, normal_impulse1, i);
	u->normal[1] = constraint_at(p, normal_impulse2, i);
}

INLINE void relay_pass(const Pools* p, const Relay* r, int i, int q, Runner* u)
{
	if (q == 0)
		pair_push(p, i, &u->c, u->normal[0], u->normal[1], u->tangent[0], u->tangent[1]);
	else if (q > 2 * r->substeps)
		relay_bounce(p, i, u);
	else if (q & 1)
		relay_bias(&p->step, u);
	else
		relay_relax(p, i, u);
}

// Pass q of a constraint, which the whole group takes in step, for no two of a group share a body. False when some never
// came to its turn.
INLINE bool relay_task(const Pools* p, const Relay* r, int i, int q, Runner* u, volatile __local int* fault)
{
	float motion_a[8], motion_b[8], base_a[4], base_b[4];
	if (!u->inert)
	{
		Body *a = &u->c.a, *b = &u->c.b;
		Side sa = u->side[0], sb = u->side[1];
		volatile __global ulong* row_a = r->rows + RELAY_WORDS * (ulong)sa.body;
		volatile __global ulong* row_b = r->rows + RELAY_WORDS * (ulong)sb.body;
		relay_ready(p, r, sa, q, a, motion_a, base_a);
		relay_ready(p, r, sb, q, b, motion_b, base_b);
		bool moved = q > 1, passed = q > 0;
		uint move = relay_turn(q & ~1, 0);
		bool well = relay_wait(p, r, sa.moves && moved, row_a + 2, move, &a->d, &a->da, sb.moves && moved, row_b + 2,
		                       move, &b->d, &b->da);
		body_turn(a);
		body_turn(b);
		u->gap[0] = pair_gap(&u->c, 0, u->separation[0]);
		u->gap[1] = pair_gap(&u->c, 1, u->separation[1]);
		well = well && relay_wait(p, r, sa.moves && (passed || sa.before > 0), row_a, relay_turn(q, sa.before), &a->v,
		                          &a->w, sb.moves && (passed || sb.before > 0), row_b, relay_turn(q, sb.before), &b->v,
		                          &b->w);
		if (!well)
			*fault = 1;
	}
	barrier(CLK_LOCAL_MEM_FENCE);
	if (*fault)
	{
		*(volatile __global int*)&p->counters->fault = FAULT_BLOWN;
		return false;
	}
	if (u->inert)
		return true;
	relay_pass(p, r, i, q, u);
	relay_pass_to(r, u->side[0], q, u->c.a);
	relay_pass_to(r, u->side[1], q, u->c.b);
	relay_pass_on(p, r, u->side[0], q, u->c.a, motion_a, base_a);
	relay_pass_on(p, r, u->side[1], q, u->c.b, motion_b, base_b);
	return true;
}

// All tasks of all constraints. Bodies that no constraint holds are relay_end's. notes has RELAY_NOTES rows a constraint
// when there are more constraints than work-items. Nothing is done when the counter at bound is zero.
__kernel void relay(POOL_ARGUMENTS Step step, __global ulong* rows, __global float4* notes, int constraints, int substeps,
                    int passes, int cleanse, int bound, int spins)
{
	volatile __local int fault;
	Pools pools = {POOL_NAMES step, 0};
	const Pools* p = &pools;
	Relay r = {rows, substeps, passes, spins};
	if (bound >= 0 && ((__global const int*)p->counters)[bound] == 0)
		return;
	int begin = (int)get_global_id(0), stride = (int)get_global_size(0);
	if (begin == 0)
	{
		p->counters->nonfinite = 0;
		p->counters->first_nonfinite = 0x7fffffff;
	}
	if (get_local_id(0) == 0)
		fault = 0;
	barrier(CLK_LOCAL_MEM_FENCE);
	if (begin >= constraints)
		return;
	Runner u;
	for (int i = begin; i < constraints; i += stride)
	{
		u = relay_prepare(p, i, cleanse);
		if (constraints > stride)
			relay_leave(&u, notes, constraints, i);
	}
	if (constraints <= stride)
	{
		for (int q = 0; q < passes; ++q)
			if (!relay_task(p, &r, begin, q, &u, &fault))
				return;
		if (!u.inert)
			relay_stow(p, begin, &u);
	}
	else
		for (int q = 0; q < passes; ++q)
			for (int i = begin; i < constraints; i += stride)
			{
				u = relay_return(notes, constraints, i);
				if (!relay_task(p, &r, i, q, &u, &fault))
					return;
				if (u.inert)
					continue;
				if (q + 1 == passes)
					relay_stow(p, i, &u);
				else
					relay_note_impulses(&u, notes, constraints, i);
			}
}

// What no constraint pushed moves alone, and all bodies are finalized.
__kernel void relay_end(POOL_ARGUMENTS Step step, int bodies, int substeps, int passes, int bound)
{
	Pools pools = {POOL_NAMES step, 0};
	const Pools* p = &pools;
	Relay r = {0, substeps, passes, 0};
	if (bound >= 0 && ((__global const int*)p->counters)[bound] == 0)
		return;
	for (int i = (int)get_global_id(0); i < bodies; i += (int)get_global_size(0))
	{
		if (p->color_mask[i] == 0 || !(p->body[i].inv_mass > 0.0f))
		{
			float row[8];
			relay_alone(p, &r, i, passes, row);
			relay_keep(p, i, row);
		}
		finalize_item(p, i);
	}
}

// Whether work-items advance each on its own, and words arrive whole: in round k each waits for its neighbor's row of
// the same round, but one in four for another group's row of the round before.
__kernel void relay_probe(volatile __global ulong* rows, volatile __global int* fault, int rounds, int spins)
{
	int n = (int)get_global_size(0), i = (int)get_global_id(0);
	int from = i % 4 ? i - 1 : (i + (int)get_local_size(0)) % n;
	volatile __global ulong* row = rows + 2 * from;
	for (int k = 1; k <= rounds; ++k)
	{
		uint turn = 0u, wanted = (uint)(i % 4 ? k : k - 1);
		ulong2 words = (ulong2)(0, 0);
		for (int left = spins; turn < wanted; --left)
		{
			words = *(volatile __global const ulong2*)row;
			turn = (uint)words.x >> 16;
			if (left <= 0 || *fault)
			{
				*fault = FAULT_BLOWN;
				return;
			}
		}
		float x, y, z;
		if (relay_open(words, turn, &x, &y, &z) &&
		    (as_uint(x) != turn * 3u || as_uint(y) != turn * 5u || as_uint(z) != turn * 65543u))
			*fault = FAULT_STALE;
		turn = (uint)k;
		relay_give(rows + 2 * i, turn, as_float(turn * 3u), as_float(turn * 5u), as_float(turn * 65543u));
	}
}
