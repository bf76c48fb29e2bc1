// SPDX-License-Identifier: MIT
// relay.cl -- executes a solve in one launch without device-wide barriers: constraints send bodies to each other.
//
// The colors order the constraints of each body, and the result depends only on this order. So a constraint may be
// solved as soon as the previous constraint of each of its bodies is solved.
//
// Each body has a mailbox in global memory: two 64-bit words of velocity and two of displacement, each with components
// and a ticket. A constraint spin-waits until its tickets are in the mailboxes of both bodies. Then it is solved, and
// writes the new velocities with the next tickets. No memory fence is needed: words are read and written atomically,
// and only the constraint whose ticket is in a mailbox writes to this mailbox. The last constraint of a body in a pass
// integrates the body.
//
// All work-items must be resident at once and make progress independently; relay_probe tests this. Each work-item does
// its tasks by pass, then by color. The first unfinished task in this order never waits, so there is no deadlock.
#include "opencl/group_sizes.h"
#include "pools/pools.h"

#define PAUSE_NS 50 // ns: pause of a spin-wait between two reads; it leaves memory bandwidth to other work-items
#ifdef __NV_CL_C_VERSION
#define PAUSE(ns) asm volatile("nanosleep.u32 %0;" ::"r"((uint)(ns)))
#else
#define PAUSE(ns)
#endif

// macros that read and write two words of a mailbox, each word atomically; emulations in tests define other macros
#ifndef MAILBOX_READ
#define MAILBOX_READ(words)                 (*(volatile __global const ulong2*)(words))
#define MAILBOX_WRITE(words, first, second) (*(volatile __global ulong2*)(words) = (ulong2)((first), (second)))
#endif

typedef struct // values that all tasks of a solve share
{
	volatile __global ulong* mailboxes; // zero at the beginning of a step
	int substeps;
	int passes; // number of passes: warm start; bias and relax in each substep; restitution pass, if any
	int spins;  // maximum number of reads of a spin-wait
} Relay;

// Returns the ticket of a constraint in pass q. before: number of tasks of the same body before it in the pass.
INLINE uint relay_ticket(int q, int before) { return RELAY_TICKETS * (uint)q + (uint)before + 1u; }

// Unpacks three 32-bit components from two words. Returns whether the 16-bit tickets of both words equal `ticket`.
INLINE bool mailbox_unpack(ulong2 words, uint ticket, float* x, float* y, float* z)
{
	*x = as_float((uint)(words.x >> 32));
	*y = as_float((uint)(words.y >> 32));
	*z = as_float((uint)words.x << 16 | ((uint)words.y & 0xffffu));
	return (uint)words.x >> 16 == ticket && (uint)words.y >> 16 == ticket;
}

INLINE void mailbox_write(volatile __global ulong* words, uint ticket, float x, float y, float z)
{
	ulong first = (ulong)as_uint(x) << 32 | ticket << 16 | as_uint(z) >> 16;
	ulong second = (ulong)as_uint(y) << 32 | ticket << 16 | (as_uint(z) & 0xffffu);
	MAILBOX_WRITE(words, first, second);
}

// Sets a mailbox to zero at the end of a step, after the last ticket of the body.
INLINE void mailbox_clear(volatile __global ulong* words)
{
	for (int k = 0; k < MAILBOX_WORDS; ++k)
		words[k] = 0;
}

INLINE void relay_send_next(const Relay* r, Side side, int q, Body body)
{
	if (side.moves && !side.last)
		mailbox_write(r->mailboxes + MAILBOX_WORDS * (ulong)side.body, relay_ticket(q, side.before + 1), body.v.x,
		              body.v.y, body.w);
}

// Finishes pass q of a body after its last constraint in the pass: integrates the body and sends it to the next pass,
// or stores it at the end of the step.
INLINE void relay_finish_pass(const Pools* p, const Relay* r, Side side, int q, Body body, float m[8], float base[4])
{
	if (!side.moves || !side.last)
		return;
	float row[8] = {body.v.x, body.v.y, body.w, body.inv_mass, body.d.x, body.d.y, body.da, body.inv_inertia};
	volatile __global ulong* words = r->mailboxes + MAILBOX_WORDS * (ulong)side.body;
	if (q + 1 == r->passes)
	{
		body_keep(p, side.body, row);
		mailbox_clear(words);
		return;
	}
	uint ticket = relay_ticket(q + 1, 0);
	int before = schedule_before(r->substeps, q + 1);
	if (before == BODY_ACCELERATES)
		body_accelerate(&p->step, gravity_of(p, side.body), row, m, base, schedule_first(q + 1));
	if (before == BODY_MOVES)
	{
		body_move(&p->step, row, m);
		mailbox_write(words + 2, ticket, row[4], row[5], row[6]);
	}
	mailbox_write(words, ticket, row[0], row[1], row[2]);
	if (before == BODY_ACCELERATES)
		p->base[side.body] = make_float4(base[0], base[1], base[2], 0.0f);
}

// Loads the values with which relay_finish_pass integrates a body after its last constraint in pass q.
INLINE void relay_load_motion(const Pools* p, const Relay* r, Side side, int q, float m[8], float base[4])
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

// Loads the values for integration. Also loads a body that no constraint sends: it cannot move, or the pass is the
// first and has no earlier constraint of the body.
INLINE void relay_prepare(const Pools* p, const Relay* r, Side side, int q, Body* body, float m[8], float base[4])
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
	relay_load_motion(p, r, side, q, m, base);
}

// Waits for tickets in two mailboxes and reads three components of each. wait_a, wait_b: false to leave a mailbox and
// its components out. Returns false if this or another spin-wait reached its limit.
INLINE bool relay_wait(const Pools* p, const Relay* r, bool wait_a, volatile __global ulong* mailbox_a, uint ticket_a,
                       Vec* a, float* wa, bool wait_b, volatile __global ulong* mailbox_b, uint ticket_b, Vec* b,
                       float* wb)
{
	for (int spins = r->spins; wait_a || wait_b; --spins)
	{
		if (wait_a)
			wait_a = !mailbox_unpack(MAILBOX_READ(mailbox_a), ticket_a, &a->x, &a->y, wa);
		if (wait_b)
			wait_b = !mailbox_unpack(MAILBOX_READ(mailbox_b), ticket_b, &b->x, &b->y, wb);
		if (wait_a || wait_b)
			PAUSE(PAUSE_NS);
		if (spins <= 0 || ((spins & 1023) == 0 && read_shared(&p->counters->fault)))
			return false;
	}
	return true;
}

// Executes pass q of a constraint. Returns false if a ticket did not arrive. in_step: true if all work-items of the
// group call this function together; then it fails in all of them or in none, and no two of their constraints may share
// a body.
INLINE_MEET bool relay_task(const Pools* p, const Relay* r, int q, Registers* u, bool in_step,
                            volatile LOCAL int* fault)
{
	float motion_a[8], motion_b[8], base_a[4], base_b[4];
	bool ok = true;
	int pass = schedule_pass(r->substeps, q);
	AnyReady ready;
	if (!u->inert)
	{
		Body *a = &u->a, *b = &u->b;
		Side sa = u->side[0], sb = u->side[1];
		volatile __global ulong* mailbox_a = r->mailboxes + MAILBOX_WORDS * (ulong)sa.body;
		volatile __global ulong* mailbox_b = r->mailboxes + MAILBOX_WORDS * (ulong)sb.body;
		relay_prepare(p, r, sa, q, a, motion_a, base_a);
		relay_prepare(p, r, sb, q, b, motion_b, base_b);
		bool moved = schedule_moved(q) > 0, passed = q > 0;
		uint move = relay_ticket(schedule_moved(q), 0);
		ok = relay_wait(p, r, sa.moves && moved, mailbox_a + 2, move, &a->d, &a->da, sb.moves && moved, mailbox_b + 2,
		                       move, &b->d, &b->da);
		body_turn(a);
		body_turn(b);
		registers_ready(p, pass, u, &ready);
		ok = ok && relay_wait(p, r, sa.moves && (passed || sa.before > 0), mailbox_a, relay_ticket(q, sa.before), &a->v,
		                          &a->w, sb.moves && (passed || sb.before > 0), mailbox_b, relay_ticket(q, sb.before), &b->v,
		                          &b->w);
		if (!ok)
			*fault = 1;
	}
	if (in_step)
	{
		barrier(CLK_LOCAL_MEM_FENCE);
		ok = !*fault;
	}
	if (!ok)
	{
		*(volatile __global int*)&p->counters->fault = FAULT_TIMEOUT;
		return false;
	}
	if (u->inert)
		return true;
	registers_pass(p, pass, &ready, u);
	relay_send_next(r, u->side[0], q, u->a);
	relay_send_next(r, u->side[1], q, u->b);
	relay_finish_pass(p, r, u->side[0], q, u->a, motion_a, base_a);
	relay_finish_pass(p, r, u->side[1], q, u->b, motion_b, base_b);
	return true;
}

// Executes all passes of all constraints; does nothing if the counter with index `bound` is 0. The kernel solve_end
// integrates bodies without constraints. stream: STREAM_FLOAT4S values of type float4 per constraint; not used if all
// constraints fit into registers.
INLINE_MEET void relay_tasks(const Pools* p, const Relay* r, __global float4* stream, int constraints, int bound,
                             int spread, volatile LOCAL int* fault)
{
	if (bound >= 0 && ((__global const int*)p->counters)[bound] == 0)
		return;
	int place = (int)get_global_id(0), stride = (int)get_global_size(0) / spread;
	int begin = place % spread == 0 ? place / spread : constraints;
	if (place == 0)
		counters_clear(p);
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
			registers_store(&u, stream, constraints, i);
	}
	if (constraints <= stride)
	{
		for (int q = 0; q < r->passes; ++q)
			if (!relay_task(p, r, q, &u, true, fault))
				return;
		if (!u.inert)
			registers_store_kept(p, &u);
	}
	else
		for (int q = 0; q < r->passes; ++q)
			for (int i = begin; i < constraints; i += stride)
			{
				u = registers_load(p, i, stream, constraints, i);
				if (!relay_task(p, r, q, &u, true, fault))
					return;
				if (u.inert)
					continue;
				if (q + 1 == r->passes)
					registers_store_kept(p, &u);
				else
					registers_update(&u, schedule_pass(r->substeps, q), stream, constraints, i);
			}
}

#define RELAY_KERNEL(name, specialize)                                                                                \
	__kernel void name(POOL_ARGUMENTS Step step, __global ulong* mailboxes, __global float4* stream, int constraints, \
	                   int substeps, int passes, int bound, int spins, int spread)                                    \
	{                                                                                                                 \
		volatile __local int fault;                                                                                   \
		Pools pools = {POOL_NAMES step, 0};                                                                           \
		Relay r = {mailboxes, substeps, passes, spins};                                                               \
		specialize(pools.step);                                                                                       \
		STEP_ALONE(pools.step);                                                                                       \
		relay_tasks(&pools, &r, stream, constraints, bound, spread, &fault);                                          \
	}
RELAY_KERNEL(relay, STEP_CONTACTS)
RELAY_KERNEL(relay_plain, STEP_PLAIN)
RELAY_KERNEL(relay_hinges, STEP_HINGES)
RELAY_KERNEL(relay_joints, STEP_JOINTS)

// Tests whether work-items make progress independently, and whether words are written as a whole. In round k, three of
// four work-items wait until a neighbor finishes round k; the fourth waits until a work-item in another work-group
// finishes round k - 1.
__kernel void relay_probe(volatile __global ulong* mailboxes, volatile __global int* fault, int rounds, int spins)
{
	int n = (int)get_global_size(0), i = (int)get_global_id(0);
	int from = i % 4 ? i - 1 : (i + (int)get_local_size(0)) % n;
	volatile __global ulong* neighbor = mailboxes + 2 * from;
	for (int k = 1; k <= rounds; ++k)
	{
		uint ticket = 0u, wanted = (uint)(i % 4 ? k : k - 1);
		ulong2 words;
		words.x = words.y = 0;
		for (int left = spins; ticket < wanted; --left)
		{
			words = MAILBOX_READ(neighbor);
			ticket = (uint)words.x >> 16;
			if (*fault)
				return;
			if (left <= 0)
				*fault = FAULT_TIMEOUT;
		}
		float x, y, z;
		if (mailbox_unpack(words, ticket, &x, &y, &z) &&
		    (as_uint(x) != ticket * 3u || as_uint(y) != ticket * 5u || as_uint(z) != ticket * 65543u))
			*fault = FAULT_STALE;
		ticket = (uint)k;
		mailbox_write(mailboxes + 2 * i, ticket, as_float(ticket * 3u), as_float(ticket * 5u), as_float(ticket * 65543u));
	}
}
