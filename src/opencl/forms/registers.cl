// SPDX-License-Identifier: MIT
// registers.cl -- loads and stores constraints in registers and in the stream, and integrates bodies without
// constraints, for relay and tiles. Passes call the same functions as those over pools (solve_pass.h), for equal bits.
#include "opencl/group_sizes.h"
#include "pools/pools.h"

// Specializations of a kernel set members of Step to constants, for fewer registers and a higher occupancy. STEP_PLAIN:
// worlds without joints, heavy bodies, radii, restitution, rolling resistance and tangent speed. On an H200, a solve of
// a million stacked boxes takes 1.379 ms with STEP_PLAIN and 1.420 ms without it.
// STEP_ALIKE: the worlds of a batch have the same gravity. STEP_ALONE: there is no batch, as in relay and tiles.
#define STEP_ALIKE(step)    ((step).bays.varied = 0)
#define STEP_ALONE(step)    ((step).bays.worlds = (step).bays.varied = 0)
#define STEP_JOINTS(step)   ((void)0)
#define STEP_HINGES(step)   ((step).springs = (step).couplings = (step).paths = 0)
#define STEP_CONTACTS(step) ((step).joints = (step).has_drives = (step).springs = (step).couplings = (step).paths = 0)
#define STEP_PLAIN(step)    \
	(STEP_CONTACTS(step), (step).heavy = (step).has_rolling = (step).details = (step).bounces = (step).round = 0)

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

// Unpacks a body in local memory. motion: velocity x, y, angular velocity, inverse mass; moved: displacement x, y, rotation,
// inverse inertia.
INLINE void body_unpack(float4 motion, float4 moved, Body* b)
{
	b->v = vec(motion.x, motion.y);
	b->w = motion.z;
	b->inv_mass = motion.w;
	b->d = vec(moved.x, moved.y);
	b->da = moved.z;
	b->inv_inertia = moved.w;
	body_turn(b);
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

// Returns whether the first `count` values are all +0.
INLINE bool all_zero(const float* values, int count)
{
	int bits = 0;
	for (int k = 0; k < count; ++k)
		bits |= float_bits(values[k]);
	return bits == 0;
}

// Computes the state before pass q of a body on which no constraint acts. Each work-item that needs this state computes
// it: a shared copy could be updated only after all work-items have read it. If body_accelerate leaves a body at rest,
// the loop ends: all later substeps have the same arguments, bit for bit, and the same result.
INLINE void body_alone(const Pools* p, int substeps, int body, int q, float row[8])
{
	float m[8], base[4];
	Vec gravity = gravity_of(p, body);
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
		body_accelerate(&p->step, gravity, row, m, base, schedule_first(k));
		if (rests && all_zero(row, 3) && all_zero(base, 3))
			return;
	}
}

typedef struct // one body of a constraint
{
	int body, before; // before: number of constraints and hub colors of the body that precede this constraint in a pass
	bool moves, last; // moves: constraints can change its velocity; last: no other constraint of it follows in a pass
} Side;

// Returns one side of a constraint of the given color. hubs: true if a pass solves hubs before the colors.
INLINE Side side_of(const Pools* p, int body, int color, bool hubs)
{
	Side side;
	Word64 mask = p->color_mask[body];
	side.body = body;
	side.moves = p->body[body].inv_mass > 0.0f;
	side.before = (int)popcount(mask & (((Word64)1 << color) - (Word64)1));
	if (hubs && p->touching[body] > (int)popcount(mask))
		side.before += (int)popcount((uint)p->hub_colors[body]);
	side.last = mask >> color == (Word64)1;
	return side;
}

typedef union // a constraint of any kind; it takes as many registers as the largest kind
{
#define CONSTRAINT_KIND(kind, Kind, KIND) Kind kind;
#include "pools/kinds.def"
#undef CONSTRAINT_KIND
} AnyKind;

typedef union // values of a pass that depend only on the positions of the bodies of a constraint
{
#define CONSTRAINT_KIND(kind, Kind, KIND) Kind##Ready kind;
#include "pools/kinds.def"
#undef CONSTRAINT_KIND
} AnyReady;

typedef struct // a constraint in registers
{
	AnyKind of;
	Body a, b;
	Side side[2];
	KindPlace at;
	bool inert;
} Registers;

// Loads the masses of both bodies, and sets their displacements to zero, as at the start of a step.
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

// Prepares a constraint, loads it with the masses of its bodies, and derives the values that passes need. Sets only the
// member `body` of its sides.
OUT_OF_LINE Registers registers_make(const Pools* p, KindPlace at, int slot)
{
	Registers u;
	Int2 bodies = edge_bodies_at(p, at.kind, at.place);
	u.at = at;
	u.inert = false;
	u.side[0].body = bodies.x;
	u.side[1].body = bodies.y;
	registers_bodies(p, &u);
#define CONSTRAINT_KIND(name, Name, NAME)              \
	if (at.kind == CONSTRAINT_##NAME)                  \
	{                                                  \
		name##_setup(p, at.place, slot, &u.of.name);      \
		if (NAME##_RARE(&p->step))                     \
			name##_setup_rare(p, at.place, &u.of.name);   \
		name##_load_all(p, at.place, &u.of.name);         \
		name##_derive(IN_PASSES, &u.a, &u.b, &u.of.name); \
		name##_start(&p->step, &u.of.name);               \
	}
#include "pools/kinds.def"
#undef CONSTRAINT_KIND
	return u;
}

// Returns the prepared constraint of task t, or an inert one if the task is padding. hubs: as in side_of.
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

INLINE void registers_ready(const Pools* p, int pass, Registers* u, AnyReady* ready)
{
#define CONSTRAINT_KIND(name, Name, NAME) \
	if (u->at.kind == CONSTRAINT_##NAME)  \
		name##_ready(p, pass, u->at.place, &u->a, &u->b, &u->of.name, &ready->name);
#include "pools/kinds.def"
#undef CONSTRAINT_KIND
}

OUT_OF_LINE void registers_pass(const Pools* p, int pass, const AnyReady* ready, Registers* u)
{
#define CONSTRAINT_KIND(name, Name, NAME) \
	if (u->at.kind == CONSTRAINT_##NAME)  \
		name##_pass(p, pass, u->at.place, &ready->name, &u->of.name, &u->a, &u->b);
#include "pools/kinds.def"
#undef CONSTRAINT_KIND
}

OUT_OF_LINE void registers_store_kept(const Pools* p, const Registers* u)
{
#define CONSTRAINT_KIND(name, Name, NAME) \
	if (u->at.kind == CONSTRAINT_##NAME)  \
		name##_store_kept(p, u->at.place, &u->of.name);
#include "pools/kinds.def"
#undef CONSTRAINT_KIND
}

// The stream: constraints not in registers, in STREAM_QUADS columns of float4, then STREAM_PAIRS columns of float2.

#define EDGE_QUAD (STREAM_QUADS - 1) // last column of float4, common to all kinds: inverse masses
#define EDGE_PAIR (STREAM_PAIRS - 1) // last column of float2, common to all kinds: bodies

INLINE __global float2* stream_pairs(__global float4* stream, int n, int i)
{
	return (__global float2*)(stream + STREAM_QUADS * n) + i;
}

// Macros that access column k of the stream. `quads`, `pairs`: addresses of a constraint in the first column of float4
// and in the first column of float2; n: length of a column.
#define STREAM_SKIP_QUAD(k, c0, c1, c2, c3)
#define STREAM_STORE_QUAD(k, c0, c1, c2, c3)        quads[k * n] = make_float4(c0, c1, c2, c3);
#define STREAM_STORE_PAIR(k, read, written, c0, c1) pairs[k * n] = make_float2(c0, c1);
#define STREAM_LOAD_QUAD(k, c0, c1, c2, c3) \
	{                                       \
		float4 quad = quads[k * n];         \
		c0 = quad.x;                        \
		c1 = quad.y;                        \
		c2 = quad.z;                        \
		c3 = quad.w;                        \
	}
#define STREAM_LOAD_PAIR(k, read, written, c0, c1) \
	if ((read) & passes)                           \
	{                                              \
		float2 pair = pairs[k * n];                \
		c0 = pair.x;                               \
		c1 = pair.y;                               \
	}
#define STREAM_UPDATE_PAIR(k, read, written, c0, c1) \
	if ((written) & passes)                          \
		pairs[k * n] = make_float2(c0, c1);

#define CONSTRAINT_KIND(kind, Kind, KIND)                                                                   \
	/* stream_store: stores constraint j, and `name`, a number that stream_load returns. stream_load loads  \
	   the columns that the given passes read; stream_update stores the columns that they write. */         \
	INLINE void kind##_stream_store(const Kind* u, float name, __global float4* stream, int n, int j)       \
	{                                                                                                       \
		__global float4* quads = stream + j;                                                                \
		__global float2* pairs = stream_pairs(stream, n, j);                                                \
		KIND##_STREAM(STREAM_STORE_QUAD, STREAM_STORE_PAIR)                                                 \
	}                                                                                                       \
	INLINE float kind##_stream_load(Kind* u, int passes, __global float4* stream, int n, int j)             \
	{                                                                                                       \
		float name;                                                                                         \
		__global float4* quads = stream + j;                                                                \
		__global float2* pairs = stream_pairs(stream, n, j);                                                \
		KIND##_STREAM(STREAM_LOAD_QUAD, STREAM_LOAD_PAIR)                                                   \
		return name;                                                                                        \
	}                                                                                                       \
	INLINE void kind##_stream_update(const Kind* u, int passes, __global float4* stream, int n, int j)      \
	{                                                                                                       \
		__global float2* pairs = stream_pairs(stream, n, j);                                                \
		KIND##_STREAM(STREAM_SKIP_QUAD, STREAM_UPDATE_PAIR)                                                 \
	}
#include "pools/kinds.def"
#undef CONSTRAINT_KIND

// registers_store writes all columns of constraint j to the stream; registers_update writes those that a pass changes.
OUT_OF_LINE void registers_store(const Registers* u, __global float4* stream, int n, int j)
{
	if (u->inert)
	{
		stream[j] = make_float4(as_float(-1), 0.0f, 0.0f, 0.0f);
		return;
	}
	int sides = 0;
	for (int k = 0; k < 2; ++k)
		sides |= (u->side[k].before | u->side[k].moves << 6 | u->side[k].last << 7) << (8 * k);
#define CONSTRAINT_KIND(name, Name, NAME) \
	if (u->at.kind == CONSTRAINT_##NAME)  \
		name##_stream_store(&u->of.name, as_float(sides), stream, n, j);
#include "pools/kinds.def"
#undef CONSTRAINT_KIND
	stream[EDGE_QUAD * n + j] = make_float4(u->a.inv_mass, u->a.inv_inertia, u->b.inv_mass, u->b.inv_inertia);
	stream_pairs(stream, n, j)[EDGE_PAIR * n] = make_float2(as_float(u->side[0].body), as_float(u->side[1].body));
}

OUT_OF_LINE void registers_update(const Registers* u, int pass, __global float4* stream, int n, int j)
{
#define CONSTRAINT_KIND(name, Name, NAME) \
	if (u->at.kind == CONSTRAINT_##NAME)  \
		name##_stream_update(&u->of.name, 1 << pass, stream, n, j);
#include "pools/kinds.def"
#undef CONSTRAINT_KIND
}

INLINE Side side_load(int body, int sides)
{
	Side side;
	side.body = body;
	side.before = sides & 63;
	side.moves = sides >> 6 & 1;
	side.last = sides >> 7 & 1;
	return side;
}

// Returns the constraint of task t, loaded from place j of the stream; it is inert if the place is padding.
OUT_OF_LINE Registers registers_load(const Pools* p, int t, __global float4* stream, int n, int j)
{
	Registers u;
	int sides = -1;
	float2 bodies = stream_pairs(stream, n, j)[EDGE_PAIR * n];
	float4 mass = stream[EDGE_QUAD * n + j];
	u.at = task_at(p, t);
#define CONSTRAINT_KIND(name, Name, NAME) \
	if (u.at.kind == CONSTRAINT_##NAME)   \
		sides = as_int(name##_stream_load(&u.of.name, IN_PASSES, stream, n, j));
#include "pools/kinds.def"
#undef CONSTRAINT_KIND
	u.inert = sides < 0;
	u.side[0] = side_load(as_int(bodies.x), sides);
	u.side[1] = side_load(as_int(bodies.y), sides >> 8);
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

// Integrates bodies without constraints, and finalizes all bodies; does nothing if the counter with index `bound` is 0.
// The kernel continuous follows.
__kernel void solve_end(POOL_ARGUMENTS Step step, int bodies, int substeps, int passes, int bound)
{
	Pools pools = {POOL_NAMES step, 0};
	const Pools* p = &pools;
	if (bound >= 0 && ((__global const int*)p->counters)[bound] == 0)
		return;
	int visits = step.sleep ? p->counters->active_items[GROUPS_OF_BODIES] : bodies;
	for (int k = (int)get_global_id(0); k < visits; k += (int)get_global_size(0))
	{
		int i = active_item(p, GROUPS_OF_BODIES, k);
		if (p->touching[i] == 0 || !(p->body[i].inv_mass > 0.0f))
		{
			float row[8];
			body_alone(p, substeps, i, passes, row);
			body_keep(p, i, row);
		}
		finalize_body(p, i);
	}
}
