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

// Waits a moment, so that those whose turn is near get through.
#define PAUSE_NS 50
#ifdef __NV_CL_C_VERSION
#define PAUSE(ns) asm volatile("nanosleep.u32 %0;" ::"r"((uint)(ns)))
#else
#define PAUSE(ns)
#endif

// Two words of a row, read and written each as a whole. Tests emulate a device that has its own (tests/emulation).
#ifndef RELAY_LOOK
#define RELAY_LOOK(row)               (*(volatile __global const ulong2*)(row))
#define RELAY_PUT(row, first, second) (*(volatile __global ulong2*)(row) = (ulong2)((first), (second)))
#endif

typedef struct // what every task knows
{
	volatile __global ulong* rows; // zero when a step begins
	int substeps;
	int passes; // warm start, bias and relax of every substep, and bounce
	int spins;
} Relay;

// A row is two words of velocity and two of displacement: two words have room for 96 bits of components, and twice for a
// turn of 16.

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
	RELAY_PUT(row, first, second);
}

// After the last turn of a step nobody waits for the row any more.
INLINE void relay_clear(volatile __global ulong* row)
{
	for (int k = 0; k < RELAY_WORDS; ++k)
		row[k] = 0;
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
		body_keep(p, side.body, row);
		relay_clear(words);
		return;
	}
	uint turn = relay_turn(q + 1, 0);
	int before = schedule_before(r->substeps, q + 1);
	if (before == BODY_ACCELERATES)
		body_accelerate(&p->step, row, m, base, schedule_first(q + 1));
	if (before == BODY_MOVES)
	{
		body_move(&p->step, row, m);
		relay_give(words + 2, turn, row[4], row[5], row[6]);
	}
	relay_give(words, turn, row[0], row[1], row[2]);
	if (before == BODY_ACCELERATES)
		p->base[side.body] = make_float4(base[0], base[1], base[2], 0.0f);
}

// What the last one of a pass will move a body on with.
INLINE void relay_bring(const Pools* p, const Relay* r, Side side, int q, float m[8], float base[4])
{
	if (!side.moves || !side.last)
		return;
	body_motion(p, side.body, m);
	if (schedule_first(q + 1))
	{
		BodyState state = p->body[side.body];
		base[0] = state.vx;
		base[1] = state.vy;
		base[2] = state.w;
	}
	else if (schedule_before(r->substeps, q + 1) == BODY_ACCELERATES)
	{
		Float4 old = p->base[side.body];
		base[0] = old.x;
		base[1] = old.y;
		base[2] = old.z;
	}
}

// What a side needs before its turn comes: the row of a body that does not move, and what the last one will move on with.
INLINE void relay_ready(const Pools* p, const Relay* r, Side side, int q, Body* body, float m[8], float base[4])
{
	if (!side.moves || (q == 0 && side.before == 0))
	{
		float row[8];
		body_alone(p, r->substeps, side.body, side.moves ? 0 : q, row);
		body->v = vec(row[0], row[1]);
		body->w = row[2];
		body->d = vec(row[4], row[5]);
		body->da = row[6];
	}
	relay_bring(p, r, side, q, m, base);
}

// Waits until three components of two rows have come. False when that took too long, here or elsewhere.
INLINE bool relay_wait(const Pools* p, const Relay* r, bool wait_a, volatile __global ulong* row_a, uint turn_a,
                       Vec* a, float* wa, bool wait_b, volatile __global ulong* row_b, uint turn_b, Vec* b, float* wb)
{
	for (int spins = r->spins; wait_a || wait_b; --spins)
	{
		if (wait_a)
			wait_a = !relay_open(RELAY_LOOK(row_a), turn_a, &a->x, &a->y, wa);
		if (wait_b)
			wait_b = !relay_open(RELAY_LOOK(row_b), turn_b, &b->x, &b->y, wb);
		if (wait_a || wait_b)
			PAUSE(PAUSE_NS);
		if (spins <= 0 || ((spins & 1023) == 0 && read_shared(&p->counters->fault)))
			return false;
	}
	return true;
}

// Pass q of a constraint. False when it never came to its turn. In step means that the whole group takes it at once, for no
// two of a group share a body, and fails as a whole.
INLINE bool relay_task(const Pools* p, const Relay* r, int q, Registers* u, bool in_step, volatile BENCH int* fault)
{
	float motion_a[8], motion_b[8], base_a[4], base_b[4];
	bool well = true;
	if (!u->inert)
	{
		Body *a = &u->a, *b = &u->b;
		Side sa = u->side[0], sb = u->side[1];
		volatile __global ulong* row_a = r->rows + RELAY_WORDS * (ulong)sa.body;
		volatile __global ulong* row_b = r->rows + RELAY_WORDS * (ulong)sb.body;
		relay_ready(p, r, sa, q, a, motion_a, base_a);
		relay_ready(p, r, sb, q, b, motion_b, base_b);
		bool moved = schedule_moved(q) > 0, passed = q > 0;
		uint move = relay_turn(schedule_moved(q), 0);
		well = relay_wait(p, r, sa.moves && moved, row_a + 2, move, &a->d, &a->da, sb.moves && moved, row_b + 2,
		                       move, &b->d, &b->da);
		body_turn(a);
		body_turn(b);
		registers_ready(u);
		well = well && relay_wait(p, r, sa.moves && (passed || sa.before > 0), row_a, relay_turn(q, sa.before), &a->v,
		                          &a->w, sb.moves && (passed || sb.before > 0), row_b, relay_turn(q, sb.before), &b->v,
		                          &b->w);
		if (!well)
			*fault = 1;
	}
	if (in_step)
	{
		barrier(CLK_LOCAL_MEM_FENCE);
		well = !*fault;
	}
	if (!well)
	{
		*(volatile __global int*)&p->counters->fault = FAULT_BLOWN;
		return false;
	}
	if (u->inert)
		return true;
	registers_pass(p, schedule_pass(r->substeps, q), u);
	relay_pass_to(r, u->side[0], q, u->a);
	relay_pass_to(r, u->side[1], q, u->b);
	relay_pass_on(p, r, u->side[0], q, u->a, motion_a, base_a);
	relay_pass_on(p, r, u->side[1], q, u->b, motion_b, base_b);
	return true;
}

// All tasks of all constraints. Bodies that no constraint holds are solve_end's. stream has STREAM_FLOAT4S rows a constraint
// when there are more constraints than work-items. Nothing is done when the counter at bound is zero.
INLINE void relay_tasks(const Pools* p, const Relay* r, __global float4* stream, int constraints, int bound, int spread,
                        volatile BENCH int* fault)
{
	if (bound >= 0 && ((__global const int*)p->counters)[bound] == 0)
		return;
	int place = (int)get_global_id(0), stride = (int)get_global_size(0) / spread;
	int begin = place % spread == 0 ? place / spread : constraints;
	if (place == 0)
	{
		p->counters->nonfinite = 0;
		p->counters->held = 0;
		p->counters->first_nonfinite = 0x7fffffff;
	}
	if (get_local_id(0) == 0)
		*fault = 0;
	barrier(CLK_LOCAL_MEM_FENCE);
	if (begin >= constraints)
		return;
	Registers u;
	for (int i = begin; i < constraints; i += stride)
	{
		u = registers_prepare(p, i, false);
		if (constraints > stride)
			registers_leave(&u, stream, constraints, i);
	}
	if (constraints <= stride)
	{
		for (int q = 0; q < r->passes; ++q)
			if (!relay_task(p, r, q, &u, true, fault))
				return;
		if (!u.inert)
			registers_stow(p, &u);
	}
	else
		for (int q = 0; q < r->passes; ++q)
			for (int i = begin; i < constraints; i += stride)
			{
				u = registers_return(p, i, stream, constraints, i);
				if (!relay_task(p, r, q, &u, true, fault))
					return;
				if (u.inert)
					continue;
				if (q + 1 == r->passes)
					registers_stow(p, &u);
				else
					registers_update(&u, schedule_pass(r->substeps, q), stream, constraints, i);
			}
}

#define RELAY_KERNEL(name, plain)                                                                                       \
	__kernel void name(POOL_ARGUMENTS Step step, __global ulong* rows, __global float4* stream, int constraints,     \
	                   int substeps, int passes, int bound, int spins, int spread)                                  \
	{                                                                                                               \
		volatile __local int fault;                                                                                 \
		Pools pools = {POOL_NAMES step, 0};                                                                         \
		Relay r = {rows, substeps, passes, spins};                                                                  \
		if (plain)                                                                                                  \
			STEP_PLAIN(pools.step);                                                                                 \
		relay_tasks(&pools, &r, stream, constraints, bound, spread, &fault);                                         \
	}
RELAY_KERNEL(relay, 0)
RELAY_KERNEL(relay_plain, 1)

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
		ulong2 words;
		words.x = words.y = 0;
		for (int left = spins; turn < wanted; --left)
		{
			words = RELAY_LOOK(row);
			turn = (uint)words.x >> 16;
			if (*fault)
				return;
			if (left <= 0)
				*fault = FAULT_BLOWN;
		}
		float x, y, z;
		if (relay_open(words, turn, &x, &y, &z) &&
		    (as_uint(x) != turn * 3u || as_uint(y) != turn * 5u || as_uint(z) != turn * 65543u))
			*fault = FAULT_STALE;
		turn = (uint)k;
		relay_give(rows + 2 * i, turn, as_float(turn * 3u), as_float(turn * 5u), as_float(turn * 65543u));
	}
}
