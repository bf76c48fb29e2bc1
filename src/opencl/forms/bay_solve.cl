// SPDX-License-Identifier: MIT
// bay_solve.cl -- solves a batch in one launch: a work-group keeps the bodies of some worlds in local memory for the step.
//
// The constraints of a world share bodies only with one another. So a work-group that has all bodies and constraints of
// some worlds needs no other work-group: it walks through the passes and, in each pass, through the colors, with a local
// barrier after each. It writes the prepared constraints to the stream, and reads them again in each pass. Within a color,
// the layout sorts constraints by slot, and so by world: those of a group are adjacent, and two searches find them.
// With constraints in registers, the solve of 65,536 cheetahs took 1.65 ms on an H200 instead of 0.59, because that many
// registers leave two work-groups per compute unit, which wait for most of the time.
#include "opencl/group_sizes.h"
#include "pools/bays.h"

#define BAY_COLUMNS (COLORS * CONSTRAINT_KINDS) // columns: a color and a kind of constraint, in the order of a pass

typedef struct // bodies and constraints of a work-group, in local memory
{
	float4 motion[BAY_BODIES]; // velocity x, y, angular velocity, inverse mass
	float4 moved[BAY_BODIES];  // displacement x, y, rotation, inverse inertia
	int first[BAY_COLUMNS];     // first task (task_at) of each column
	int place[BAY_COLUMNS];     // first place of each column
	int begin[BAY_COLUMNS + 1]; // number of tasks of the group in earlier columns
	int used[BAY_COLUMNS + 1];  // columns that have tasks, then BAY_COLUMNS
} BayGroup;

// fails to compile if the kernels have more local memory than the host expects
typedef char bay_fits[((sizeof(BayGroup) <= TILE_MEMORY) | (BAY_BODIES > TILE_BODIES)) ? 1 : -1];

// Returns the first place of a column at or behind which slots are at least `slot`. The column has `count` places from
// `begin` on.
INLINE int bay_search(const Pools* p, int kind, int begin, int count, int slot)
{
	int low = 0, high = count;
	while (low < high)
	{
		int middle = (low + high) / 2;
		if (edge_slot_at(p, kind, begin + middle) < slot)
			low = middle + 1;
		else
			high = middle;
	}
	return low;
}

// Finds the constraints of worlds `world` to `end` - 1 in each column.
INLINE_MEET void bay_find(const Pools* p, int world, int end, LOCAL BayGroup* g)
{
	int lane = (int)get_local_id(0), width = (int)get_local_size(0);
	for (int c = lane; c < BAY_COLUMNS; c += width)
	{
		int color = c / CONSTRAINT_KINDS, kind = c % CONSTRAINT_KINDS;
		int bits = kind == CONSTRAINT_CONTACT ? p->step.bays.contact_bits : p->step.bays.joint_bits;
		GLOBAL const KindLayout* layout = &p->counters->layout[kind];
		int begin = layout->begin[color], count = layout->count[color], first = task_first(p->counters, color);
		for (int k = 0; k < kind; ++k)
			first += p->counters->layout[k].begin[color + 1] - p->counters->layout[k].begin[color];
		int low = bay_search(p, kind, begin, count, world << bits);
		g->first[c] = first + low;
		g->place[c] = begin + low;
		g->begin[c + 1] = bay_search(p, kind, begin, count, end << bits) - low;
	}
	barrier(CLK_LOCAL_MEM_FENCE);
	if (lane == 0)
	{
		int sum = 0, used = 0;
		g->begin[0] = 0;
		for (int c = 0; c < BAY_COLUMNS; ++c)
		{
			int count = g->begin[c + 1];
			if (count > 0)
				g->used[used++] = c;
			sum += count;
			g->begin[c + 1] = sum;
		}
		g->used[used] = BAY_COLUMNS;
	}
	barrier(CLK_LOCAL_MEM_FENCE);
}

// Loads body k of the group before pass 0, or integrates it before a later pass. body: its index.
INLINE void bay_advance(const Pools* p, int substeps, int body, int q, LOCAL BayGroup* g, int k)
{
	float row[8], m[8], base[4];
	int before = schedule_before(substeps, q);
	if (q == 0)
	{
		body_row(p, body, row);
		p->base[body] = make_float4(row[0], row[1], row[2], 0.0f);
	}
	else if (before == BODY_STAYS)
		return;
	else
	{
		float4 motion = g->motion[k], moved = g->moved[k];
		row[0] = motion.x;
		row[1] = motion.y;
		row[2] = motion.z;
		row[3] = motion.w;
		row[4] = moved.x;
		row[5] = moved.y;
		row[6] = moved.z;
		row[7] = moved.w;
		body_motion(p, body, m);
		if (before == BODY_ACCELERATES)
		{
			Float4 old = p->base[body];
			base[0] = old.x;
			base[1] = old.y;
			base[2] = old.z;
			base[3] = 0.0f;
			body_accelerate(&p->step, gravity_of(p, body), row, m, base, schedule_first(q));
			p->base[body] = make_float4(base[0], base[1], base[2], 0.0f);
		}
		else
			body_move(&p->step, row, m);
	}
	g->motion[k] = make_float4(row[0], row[1], row[2], row[3]);
	g->moved[k] = make_float4(row[4], row[5], row[6], row[7]);
}

INLINE void bay_gather(LOCAL const BayGroup* g, uint k, Body* b)
{
	body_unpack(g->motion[k], g->moved[k], b);
}

INLINE void bay_scatter(LOCAL BayGroup* g, uint k, const Body* b)
{
	if (b->inv_mass > 0.0f)
		g->motion[k] = make_float4(b->v.x, b->v.y, b->w, b->inv_mass);
}

typedef struct
{
	__global float4* stream; // each column has `stride` entries
	int stride, substeps, passes;
	int world, end;      // range of worlds of the work-group
	int first, bodies;   // its bodies
} BayRange;

// Prepares the constraint of a task and writes it to the stream, with the numbers of its bodies in the group.
INLINE void bay_prepare(const Pools* p, const BayRange* r, int task)
{
	KindPlace at = task_at(p, task);
	Registers u = registers_make(p, at, edge_slot_at(p, at.kind, at.place));
	float bodies = as_float((u.side[0].body - r->first) | (u.side[1].body - r->first) << 16);
#define CONSTRAINT_KIND(name, Name, NAME) \
	if (at.kind == CONSTRAINT_##NAME)     \
		name##_stream_store(&u.of.name, bodies, r->stream, r->stride, task);
#include "pools/kinds.def"
#undef CONSTRAINT_KIND
}

// Executes a pass of a constraint. ends: whether it is the last pass. place: its place, for its rare rows.
#define CONSTRAINT_KIND(kind, Kind, KIND)                                                                         \
	INLINE void kind##_bay_task(const Pools* p, const BayRange* r, LOCAL BayGroup* g, int task, int place, int pass, \
	                            bool ends)                                                                        \
	{                                                                                                             \
		Kind u;                                                                                                   \
		Kind##Ready ready;                                                                                        \
		Body a, b;                                                                                                \
		uint bodies = as_uint(kind##_stream_load(&u, 1 << pass, r->stream, r->stride, task));                     \
		bay_gather(g, bodies & 0xffffu, &a);                                                                      \
		bay_gather(g, bodies >> 16, &b);                                                                          \
		kind##_ready(p, pass, place, &a, &b, &u, &ready);                                                         \
		kind##_pass(p, pass, place, &ready, &u, &a, &b);                                                          \
		bay_scatter(g, bodies & 0xffffu, &a);                                                                     \
		bay_scatter(g, bodies >> 16, &b);                                                                         \
		if (ends)                                                                                                 \
			kind##_store_kept(p, place, &u);                                                                      \
		else                                                                                                      \
			kind##_stream_update(&u, 1 << pass, r->stream, r->stride, task);                                      \
	}
#include "pools/kinds.def"
#undef CONSTRAINT_KIND

// Returns whether the worlds may have constraints of a kind; this is a constant in kernels without joints.
INLINE bool bay_has(const Pools* p, int kind) { return kind == CONSTRAINT_CONTACT || p->step.joints; }

// Executes pass q. pass: its kind, a constant, so that a work-item loads only what the pass reads.
INLINE_MEET void bay_pass(const Pools* p, const BayRange* r, LOCAL BayGroup* g, int q, int pass)
{
	int lane = (int)get_local_id(0), width = (int)get_local_size(0);
	bool ends = q + 1 == r->passes && pass >= PASS_RELAX;
	for (int n = 0; g->used[n] < BAY_COLUMNS; ++n)
	{
		int c = g->used[n], count = g->begin[c + 1] - g->begin[c];
		for (int t = lane; t < count; t += width)
		{
			int task = g->first[c] + t, place = g->place[c] + t;
#define CONSTRAINT_KIND(name, Name, NAME)                                          \
			if (bay_has(p, CONSTRAINT_##NAME) && c % CONSTRAINT_KINDS == CONSTRAINT_##NAME) \
				name##_bay_task(p, r, g, task, place, pass, ends);
#include "pools/kinds.def"
#undef CONSTRAINT_KIND
		}
		barrier(CLK_LOCAL_MEM_FENCE);
	}
}

// Executes a solve for the worlds of a work-group.
INLINE_MEET void bay_work(const Pools* p, const BayRange* r, LOCAL BayGroup* g)
{
	int lane = (int)get_local_id(0), width = (int)get_local_size(0);
	if (get_global_id(0) == 0)
		counters_clear(p);
	bay_find(p, r->world, r->end, g);
	for (int n = 0; g->used[n] < BAY_COLUMNS; ++n)
	{
		int c = g->used[n], count = g->begin[c + 1] - g->begin[c];
		for (int t = lane; t < count; t += width)
			bay_prepare(p, r, g->first[c] + t);
	}
	for (int q = 0; q < r->passes; ++q)
	{
		for (int k = lane; k < r->bodies; k += width)
			bay_advance(p, r->substeps, r->first + k, q, g, k);
		barrier(CLK_LOCAL_MEM_FENCE);
		int pass = schedule_pass(r->substeps, q);
		if (pass == PASS_WARM_START)
			bay_pass(p, r, g, q, PASS_WARM_START);
		else if (pass == PASS_BIAS)
			bay_pass(p, r, g, q, PASS_BIAS);
		else if (pass == PASS_RELAX)
			bay_pass(p, r, g, q, PASS_RELAX);
		else
			bay_pass(p, r, g, q, PASS_BOUNCE);
	}
	for (int k = lane; k < r->bodies; k += width)
	{
		float4 motion = g->motion[k], moved = g->moved[k];
		float row[8] = {motion.x, motion.y, motion.z, motion.w, moved.x, moved.y, moved.z, moved.w};
		if (motion.w > 0.0f && p->touching[r->first + k] != 0) // solve_end integrates the other bodies
			body_keep(p, r->first + k, row);
	}
}

#define BAY_KERNEL(name, specialize, alike)                                                                      \
	__kernel __attribute__((reqd_work_group_size(BAY_GROUP, 1, 1))) void name(                                   \
	    POOL_ARGUMENTS Step step, __global float4* stream, int stride, int bays, int substeps, int passes,        \
	    int bound)                                                                                                \
	{                                                                                                             \
		__local BayGroup g;                                                                                       \
		Pools pools = {POOL_NAMES step, 0};                                                                       \
		specialize(pools.step);                                                                                   \
		alike(pools.step);                                                                                        \
		BayRange r = {stream, stride, substeps, passes, (int)get_group_id(0) * bays, 0, 0, 0};                    \
		r.end = min(r.world + bays, pools.counters->contacts >> step.bays.contact_bits);                          \
		r.first = r.world * step.bays.bodies;                                                                     \
		r.bodies = (r.end - r.world) * step.bays.bodies;                                                          \
		if (bound < 0 || ((__global const int*)pools.counters)[bound] != 0)                                       \
			bay_work(&pools, &r, &g);                                                                             \
	}
BAY_KERNEL(bay_solve, STEP_CONTACTS, STEP_ALIKE)
BAY_KERNEL(bay_solve_hinges, STEP_HINGES, STEP_ALIKE)
BAY_KERNEL(bay_solve_joints, STEP_JOINTS, STEP_ALIKE)
BAY_KERNEL(bay_solve_varied, STEP_JOINTS, STEP_JOINTS) // for worlds with different gravity
