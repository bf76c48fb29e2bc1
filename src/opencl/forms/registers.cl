// SPDX-License-Identifier: MIT
// registers.cl -- what relay and tiles share: constraints in registers, and bodies that no constraint pushes.
//
// A pass over registers does what a pass of solve.h does over pools, by the same functions, so that the bits are the same.
#include "opencl/limits.h"
#include "pools/pools.h"

// A plain world has no shape with a radius, and surfaces that rub and do nothing else. Kernels for it alone leave the rest
// out, and with it registers that a device could not give to more work-items. On an H200 the solve of a million stacked
// boxes takes 1.379 ms so, and 1.420 without.
#define STEP_PLAIN(step) ((step).rare = (step).rolls = (step).details = (step).bounces = (step).round = 0)

INLINE void body_row(const Pools* p, int body, float row[8])
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

INLINE void body_motion(const Pools* p, int body, float m[8])
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

INLINE void body_keep(const Pools* p, int body, const float row[8])
{
	GLOBAL BodyState* state = p->body + body;
	state->vx = row[0];
	state->vy = row[1];
	state->w = row[2];
	state->dx = row[4];
	state->dy = row[5];
	state->da = row[6];
}

// whether all are zero, with a plus
INLINE bool all_zero(const float* values, int count)
{
	int bits = 0;
	for (int k = 0; k < count; ++k)
		bits |= float_bits(values[k]);
	return bits == 0;
}

// The row of a body that no constraint pushes, as pass q finds it. It is worked out by whoever asks: a row in memory
// would have to wait for its last reader.
//
// Most rest, and need no more than the first substep: where accelerating leads from rest to rest, it does so again, from
// the same bits by the same function, and moving adds nothing.
INLINE void body_alone(const Pools* p, int substeps, int body, int q, float row[8])
{
	float m[8], base[4];
	body_row(p, body, row);
	body_motion(p, body, m);
	base[0] = row[0];
	base[1] = row[1];
	base[2] = row[2];
	for (int k = 1; k <= q; ++k)
	{
		int before = schedule_before(substeps, k);
		if (before == BODY_STAYS)
			return;
		if (before == BODY_MOVES)
		{
			body_move(&p->step, row, m);
			continue;
		}
		bool rests = all_zero(row, 3) && all_zero(base, 3);
		body_accelerate(&p->step, row, m, base, schedule_first(k));
		if (rests && all_zero(row, 3) && all_zero(base, 3))
			return;
	}
}

typedef struct // one body of a constraint
{
	int body, before; // of its constraints, so many come before this one in a pass
	bool moves, last; // last: no other constraint of the body comes after this one
} Side;

// The side of a constraint of some color. With hubs, bodies may have been with some before.
INLINE Side side_of(const Pools* p, int body, int color, bool hubs)
{
	Side side;
	Word64 mask = p->color_mask[body];
	side.body = body;
	side.moves = p->body[body].inv_mass > 0.0f;
	side.before = (int)popcount(mask & (((Word64)1 << color) - (Word64)1));
	if (hubs && p->touching[body] > (int)popcount(mask))
		side.before += (int)popcount((uint)p->hub_turns[body]);
	side.last = mask >> color == (Word64)1;
	return side;
}

typedef struct // a constraint in registers
{
#define CONSTRAINT_KIND(kind, Kind, KIND) Kind kind; // if it is of this kind
#include "pools/kinds.def"
#undef CONSTRAINT_KIND
	Body a, b;
	Side side[2];
	KindPlace at;
	bool inert;
} Registers;

// Its bodies, as they are when a step begins.
INLINE void registers_bodies(const Pools* p, Registers* u)
{
	BodyState a = p->body[u->side[0].body], b = p->body[u->side[1].body];
	u->a.inv_mass = a.inv_mass;
	u->a.inv_inertia = a.inv_inertia;
	u->a.d = vec(0.0f, 0.0f);
	u->a.da = 0.0f;
	u->b.inv_mass = b.inv_mass;
	u->b.inv_inertia = b.inv_inertia;
	u->b.d = u->a.d;
	u->b.da = 0.0f;
}

// A constraint with its bodies, but for its sides: all rows, and what is derived of them.
INLINE Registers registers_make(const Pools* p, KindPlace at, int slot)
{
	Registers u;
	Int2 bodies = edge_bodies_at(p, at.kind, at.place);
	u.at = at;
	u.inert = false;
	u.side[0].body = bodies.x;
	u.side[1].body = bodies.y;
	registers_bodies(p, &u);
#define CONSTRAINT_KIND(name, Name, NAME)                        \
	if (at.kind == CONSTRAINT_##NAME)                            \
	{                                                            \
		name##_setup(p, at.place, slot, &u.name);                \
		if (p->step.rare)                                      \
			name##_setup_rare(p, at.place, &u.name);             \
		name##_take(p, at.place, &u.name);                       \
		name##_derive(IN_PASSES, &u.a, &u.b, &u.name);           \
		name##_start(&p->step, &u.name);                         \
	}
#include "pools/kinds.def"
#undef CONSTRAINT_KIND
	return u;
}

// Task t, which may be padding.
INLINE Registers registers_prepare(const Pools* p, int t, bool hubs)
{
	Registers u;
	KindPlace at = task_at(p, t);
	int slot = edge_slot_at(p, at.kind, at.place);
	u.inert = slot < 0;
	if (u.inert)
		return u;
	u = registers_make(p, at, slot);
	int color = edge_color(p, at.kind, slot);
	u.side[0] = side_of(p, u.side[0].body, color, hubs);
	u.side[1] = side_of(p, u.side[1].body, color, hubs);
	return u;
}

// What a pass needs of where the bodies are.
INLINE void registers_ready(Registers* u)
{
#define CONSTRAINT_KIND(name, Name, NAME)         \
	if (u->at.kind == CONSTRAINT_##NAME)          \
		name##_ready(&u->a, &u->b, &u->name);
#include "pools/kinds.def"
#undef CONSTRAINT_KIND
}

// A pass of solve.h for what is in registers.
INLINE void registers_pass(const Pools* p, int pass, Registers* u)
{
#define CONSTRAINT_KIND(name, Name, NAME)         \
	if (u->at.kind == CONSTRAINT_##NAME)          \
		name##_pass(p, pass, u->at.place, &u->name, &u->a, &u->b);
#include "pools/kinds.def"
#undef CONSTRAINT_KIND
}

// What is kept, for the next step.
INLINE void registers_stow(const Pools* p, const Registers* u)
{
#define CONSTRAINT_KIND(name, Name, NAME)         \
	if (u->at.kind == CONSTRAINT_##NAME)          \
		name##_stow(p, u->at.place, &u->name);
#include "pools/kinds.def"
#undef CONSTRAINT_KIND
}

// ---------------------------------------------------------------------------------------------------------------
// the stream: what does not stay in registers lies in columns of n, STREAM_QUADS of float4, then STREAM_PAIRS of float2
// ---------------------------------------------------------------------------------------------------------------

// the last column of each sort is not a kind's own: inverse masses, bodies
#define EDGE_QUAD (STREAM_QUADS - 1)
#define EDGE_PAIR (STREAM_PAIRS - 1)

INLINE __global float2* stream_pairs(__global float4* stream, int n, int i)
{
	return (__global float2*)(stream + STREAM_QUADS * n) + i;
}

// Of constraint j: quads and pairs are its first of either, n is how far the columns lie apart.
#define STREAM_SKIP_QUAD(k, c0, c1, c2, c3)
#define STREAM_LEAVE_QUAD(k, c0, c1, c2, c3)      quads[k * n] = make_float4(c0, c1, c2, c3);
#define STREAM_LEAVE_PAIR(k, read, written, c0, c1) pairs[k * n] = make_float2(c0, c1);
#define STREAM_TAKE_QUAD(k, c0, c1, c2, c3)                                                  \
	{                                                                                        \
		float4 quad = quads[k * n];                                                          \
		c0 = quad.x;                                                                         \
		c1 = quad.y;                                                                         \
		c2 = quad.z;                                                                         \
		c3 = quad.w;                                                                         \
	}
#define STREAM_TAKE_PAIR(k, read, written, c0, c1)                                           \
	if ((read) & passes)                                                                     \
	{                                                                                        \
		float2 pair = pairs[k * n];                                                          \
		c0 = pair.x;                                                                         \
		c1 = pair.y;                                                                         \
	}
#define STREAM_UPDATE_PAIR(k, read, written, c0, c1)                                         \
	if ((written) & passes)                                                                  \
		pairs[k * n] = make_float2(c0, c1);

#define CONSTRAINT_KIND(kind, Kind, KIND)                                                                  \
	/* Constraint j with a number of the caller's; all of it, what some passes read, what they write. */ \
	INLINE void kind##_leave(const Kind* u, float name, __global float4* stream, int n, int j)   \
	{                                                                                        \
		__global float4* quads = stream + j;                                                 \
		__global float2* pairs = stream_pairs(stream, n, j);                                 \
		KIND##_STREAM(STREAM_LEAVE_QUAD, STREAM_LEAVE_PAIR)                                  \
	}                                                                                        \
	INLINE float kind##_return(Kind* u, int passes, __global float4* stream, int n, int j)   \
	{                                                                                        \
		float name;                                                                          \
		__global float4* quads = stream + j;                                                 \
		__global float2* pairs = stream_pairs(stream, n, j);                                 \
		KIND##_STREAM(STREAM_TAKE_QUAD, STREAM_TAKE_PAIR)                                    \
		return name;                                                                         \
	}                                                                                        \
	INLINE void kind##_update(const Kind* u, int passes, __global float4* stream, int n, int j) \
	{                                                                                        \
		__global float2* pairs = stream_pairs(stream, n, j);                                 \
		KIND##_STREAM(STREAM_SKIP_QUAD, STREAM_UPDATE_PAIR)                                  \
	}
#include "pools/kinds.def"
#undef CONSTRAINT_KIND

// All of it to column j; what a pass writes.
INLINE void registers_leave(const Registers* u, __global float4* stream, int n, int j)
{
	if (u->inert)
	{
		stream[j] = make_float4(as_float(-1), 0.0f, 0.0f, 0.0f);
		return;
	}
	int turns = 0;
	for (int k = 0; k < 2; ++k)
		turns |= (u->side[k].before | u->side[k].moves << 6 | u->side[k].last << 7) << (8 * k);
#define CONSTRAINT_KIND(name, Name, NAME)                                 \
	if (u->at.kind == CONSTRAINT_##NAME)                                  \
		name##_leave(&u->name, as_float(turns), stream, n, j);
#include "pools/kinds.def"
#undef CONSTRAINT_KIND
	stream[EDGE_QUAD * n + j] = make_float4(u->a.inv_mass, u->a.inv_inertia, u->b.inv_mass, u->b.inv_inertia);
	stream_pairs(stream, n, j)[EDGE_PAIR * n] = make_float2(as_float(u->side[0].body), as_float(u->side[1].body));
}

INLINE void registers_update(const Registers* u, int pass, __global float4* stream, int n, int j)
{
#define CONSTRAINT_KIND(name, Name, NAME)                                 \
	if (u->at.kind == CONSTRAINT_##NAME)                                  \
		name##_update(&u->name, 1 << pass, stream, n, j);
#include "pools/kinds.def"
#undef CONSTRAINT_KIND
}

INLINE Side side_return(int body, int turns)
{
	Side side;
	side.body = body;
	side.before = turns & 63;
	side.moves = turns >> 6 & 1;
	side.last = turns >> 7 & 1;
	return side;
}

// Task t from column j.
INLINE Registers registers_return(const Pools* p, int t, __global float4* stream, int n, int j)
{
	Registers u;
	int turns = -1;
	float2 bodies = stream_pairs(stream, n, j)[EDGE_PAIR * n];
	float4 mass = stream[EDGE_QUAD * n + j];
	u.at = task_at(p, t);
#define CONSTRAINT_KIND(name, Name, NAME)                                 \
	if (u.at.kind == CONSTRAINT_##NAME)                                   \
		turns = as_int(name##_return(&u.name, IN_PASSES, stream, n, j));
#include "pools/kinds.def"
#undef CONSTRAINT_KIND
	u.inert = turns < 0;
	u.side[0] = side_return(as_int(bodies.x), turns);
	u.side[1] = side_return(as_int(bodies.y), turns >> 8);
	u.a.inv_mass = mass.x;
	u.a.inv_inertia = mass.y;
	u.a.d = vec(0.0f, 0.0f);
	u.a.da = 0.0f;
	u.b.inv_mass = mass.z;
	u.b.inv_inertia = mass.w;
	u.b.d = u.a.d;
	u.b.da = 0.0f;
	return u;
}

// What no constraint pushed moves alone, and all bodies are finalized but for what guard does.
__kernel void solve_end(POOL_ARGUMENTS Step step, int bodies, int substeps, int passes, int bound)
{
	Pools pools = {POOL_NAMES step, 0};
	const Pools* p = &pools;
	if (bound >= 0 && ((__global const int*)p->counters)[bound] == 0)
		return;
	for (int i = (int)get_global_id(0); i < bodies; i += (int)get_global_size(0))
	{
		if (p->touching[i] == 0 || !(p->body[i].inv_mass > 0.0f))
		{
			float row[8];
			body_alone(p, substeps, i, passes, row);
			body_keep(p, i, row);
		}
		finalize_item(p, i);
	}
}
