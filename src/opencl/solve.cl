// SPDX-License-Identifier: MIT
// solve.cl -- what relay and tiles share: constraints in registers, and bodies that no constraint pushes.
//
// A pass over registers does what a pass of solve.h does over pools, by the same functions, so that the bits are the same.
#include "opencl/limits.h"
#include "pools/pools.h"

// A plain world has no shape with a radius, and surfaces that rub and do nothing else. Kernels for it alone leave the rest
// out, and with it registers that a device could not give to more work-items. On an H200 the solve of a million stacked
// boxes takes 1.379 ms so, and 1.420 without.
#define STEP_PLAIN(step) ((step).extras = (step).bounces = (step).round = 0)

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
	for (int k = 1; k <= q && k <= 2 * substeps; ++k)
	{
		if (k % 2 == 0)
		{
			body_move(&p->step, row, m);
			continue;
		}
		bool rests = all_zero(row, 3) && all_zero(base, 3);
		body_accelerate(&p->step, row, m, base, k == 1);
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
INLINE Runner runner_make(const Pools* p, int i, ContactPoints points)
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
	u.c.n = points.normal;
	u.c.t = vec(points.normal.y, -points.normal.x);
	u.friction = constraint_at(p, friction, i);
	u.normal[0] = constraint_at(p, normal_impulse1, i);
	u.normal[1] = constraint_at(p, normal_impulse2, i);
	u.tangent[0] = constraint_at(p, tangent_impulse1, i);
	u.tangent[1] = constraint_at(p, tangent_impulse2, i);
	u.separation[0] = points.separation[0];
	u.separation[1] = points.separation[1];
	u.c.ra[0] = points.anchor[0];
	u.c.ra[1] = points.anchor[1];
	for (int k = 0; k < 2; ++k)
	{
		u.c.rb[k] = vec_add(u.c.ra[k], points.offset);
		u.normal_mass[k] = pair_mass(&u.c, k, u.c.n);
		u.tangent_mass[k] = pair_mass(&u.c, k, u.c.t);
		u.normal[k] = pair_start(&p->step, u.normal[k], u.normal_mass[k]);
	}
	return u;
}

// Constraint i, which may be none.
INLINE Runner runner_prepare(const Pools* p, int i, bool hubs)
{
	Runner u;
	int slot = p->constraint_contact[i];
	u.inert = slot < 0;
	if (u.inert)
		return u;
	ContactPoints points = prepare_points(p, i, slot);
	if (p->step.extras)
		prepare_extras(p, i, points);
	u = runner_make(p, i, points);
	int color = p->contact_color[slot];
	u.side[0] = side_of(p, u.c.ia, color, hubs);
	u.side[1] = side_of(p, u.c.ib, color, hubs);
	return u;
}

// Its impulses, for the next step.
INLINE void runner_stow(const Pools* p, int i, const Runner* u)
{
	constraint_at(p, normal_impulse1, i) = u->normal[0];
	constraint_at(p, normal_impulse2, i) = u->normal[1];
	constraint_at(p, tangent_impulse1, i) = u->tangent[0];
	constraint_at(p, tangent_impulse2, i) = u->tangent[1];
}

// A runner that does not stay in registers lies in columns of n: NOTE_QUADS of float4s, then NOTE_PAIRS of float2s, of
// which the last two are its impulses.
INLINE __global float2* runner_pairs(__global float4* notes, int n, int i)
{
	return (__global float2*)(notes + NOTE_QUADS * n) + i;
}

INLINE void runner_leave_impulses(const Runner* u, __global float4* notes, int n, int i)
{
	__global float2* pair = runner_pairs(notes, n, i);
	pair[(NOTE_PAIRS - 2) * n] = make_float2(u->normal[0], u->normal[1]);
	pair[(NOTE_PAIRS - 1) * n] = make_float2(u->tangent[0], u->tangent[1]);
}

INLINE void runner_leave(const Runner* u, __global float4* notes, int n, int i)
{
	int turns = -1;
	if (!u->inert)
	{
		Pair c = u->c;
		__global float2* pair = runner_pairs(notes, n, i);
		turns = 0;
		for (int k = 0; k < 2; ++k)
			turns |= (u->side[k].before | u->side[k].moves << 6 | u->side[k].last << 7) << (8 * k);
		notes[n + i] = make_float4(c.n.x, c.n.y, c.b.inv_mass, c.b.inv_inertia);
		notes[2 * n + i] = make_float4(c.ra[0].x, c.ra[0].y, c.ra[1].x, c.ra[1].y);
		pair[0] = make_float2(c.rb[0].x, c.rb[0].y);
		pair[n] = make_float2(c.rb[1].x, c.rb[1].y);
		pair[2 * n] = make_float2(u->separation[0], u->separation[1]);
		pair[3 * n] = make_float2(c.a.inv_mass, c.a.inv_inertia);
		pair[4 * n] = make_float2(u->normal_mass[0], u->normal_mass[1]);
		pair[5 * n] = make_float2(u->tangent_mass[0], u->tangent_mass[1]);
		runner_leave_impulses(u, notes, n, i);
	}
	notes[i] = make_float4(as_float(turns), as_float(u->c.ia), as_float(u->c.ib), u->friction);
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

INLINE Runner runner_return(__global float4* notes, int n, int i)
{
	Runner u;
	__global const float2* pair = runner_pairs(notes, n, i);
	float4 names = notes[i], normal = notes[n + i], on_a = notes[2 * n + i];
	float2 gaps = pair[2 * n], mass_a = pair[3 * n], normal_mass = pair[4 * n], tangent_mass = pair[5 * n];
	float2 push = pair[6 * n], rub = pair[7 * n];
	int turns = as_int(names.x);
	u.inert = turns < 0;
	u.c.ia = as_int(names.y);
	u.c.ib = as_int(names.z);
	u.side[0] = side_return(u.c.ia, turns);
	u.side[1] = side_return(u.c.ib, turns >> 8);
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
INLINE void runner_bias(const Pools* p, int i, Runner* u)
{
	pair_bias(p, i, &u->c, u->gap[0], u->gap[1], u->normal_mass[0], u->normal_mass[1], &u->normal[0], &u->normal[1]);
}

INLINE void runner_bounce(const Pools* p, int i, Runner* u)
{
	pair_bounce(p, i, &u->c, u->gap[0], u->gap[1], u->normal_mass[0], u->normal_mass[1], &u->normal[0], &u->normal[1]);
}

INLINE void runner_relax(const Pools* p, int i, Runner* u)
{
	float speed = p->step.extras ? extra_at(p, tangent_speed, i) : 0.0f, rebound[2] = {0.0f, 0.0f};
	if (p->step.bounces)
	{
		rebound[0] = extra_at(p, rebound1, i);
		rebound[1] = extra_at(p, rebound2, i);
	}
	for (int k = 0; k < 2; ++k)
		u->tangent[k] = pair_tangent(&u->c, k, u->tangent_mass[k], speed, u->friction * u->normal[k], u->tangent[k]);
	for (int k = 0; k < 2; ++k)
		u->normal[k] = pair_normal(&u->c, k, u->gap[k], u->normal_mass[k], u->normal[k], &p->step, 0, rebound[k]);
	if (p->step.extras)
	{
		pair_roll(p, i, &u->c, u->normal[0] + u->normal[1]);
		pair_total(p, i, u->normal[0], u->normal[1]);
	}
}

INLINE void runner_pass(const Pools* p, int substeps, int i, int q, Runner* u)
{
	if (q == 0)
		pair_push(p, i, &u->c, u->normal[0], u->normal[1], u->tangent[0], u->tangent[1]);
	else if (q > 2 * substeps)
		runner_bounce(p, i, u);
	else if (q & 1)
		runner_bias(p, i, u);
	else
		runner_relax(p, i, u);
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
