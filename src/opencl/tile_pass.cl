// SPDX-License-Identifier: MIT
// tile_pass.cl -- one pass of the solve over all tiles, and over what is on their borders.
#include "opencl/tiles.cl"

typedef struct // the bodies of a tile
{
	float4 motion[TILE_BODIES + 1]; // velocity x, y, angular, inverse mass
	float4 moved[TILE_BODIES + 1];  // displacement x, y, sine and versine of the turn
	float inv_inertia[TILE_BODIES + 1];
} Tile;

// A body into local memory, moved on to pass q.
INLINE void tile_fetch(const Pools* p, const Relay* r, int resident, int q, BENCH Tile* tile, int k)
{
	int body = resident & ~TILE_PLAIN;
	BodyState state = p->body[body];
	float row[8] = {state.vx, state.vy, state.w,  state.inv_mass,
	                state.dx, state.dy, state.da, state.inv_inertia};
	if (q == 0)
	{
		row[4] = 0.0f;
		row[5] = 0.0f;
		row[6] = 0.0f;
		p->base[body] = make_float4(row[0], row[1], row[2], 0.0f);
	}
	else if (q <= 2 * r->substeps)
	{
		float m[8] = {0.0f, 0.0f, 0.0f, 1.0f, 0.0f, 0.0f, 1.0f, 1.0f};
		if (!(resident & TILE_PLAIN))
			body_motion(p, body, m);
		if (q & 1)
		{
			Float4 old = p->base[body];
			float base[4] = {old.x, old.y, old.z, 0.0f};
			body_accelerate(&p->step, row, m, base, q == 1);
			p->base[body] = make_float4(base[0], base[1], base[2], 0.0f);
		}
		else
			body_move(&p->step, row, m);
	}
	if (!(q & 1))
		*(__global float4*)&p->body[body].dx = make_float4(row[4], row[5], row[6], row[7]);
	Body b;
	b.da = row[6];
	body_turn(&b);
	tile->motion[k] = make_float4(row[0], row[1], row[2], row[3]);
	tile->moved[k] = make_float4(row[4], row[5], b.sine, b.versine);
	tile->inv_inertia[k] = row[7];
}

INLINE void tile_gather(BENCH const Tile* tile, uint place, Body* b)
{
	float4 motion = tile->motion[place], moved = tile->moved[place];
	b->v = vec(motion.x, motion.y);
	b->w = motion.z;
	b->inv_mass = motion.w;
	b->d = vec(moved.x, moved.y);
	b->sine = moved.z;
	b->versine = moved.w;
	b->inv_inertia = tile->inv_inertia[place];
}

INLINE void tile_scatter(BENCH Tile* tile, uint place, const Body* b)
{
	if (place != TILE_RESTS)
		tile->motion[place] = make_float4(b->v.x, b->v.y, b->w, b->inv_mass);
}

// what a pass does with a constraint
#define TILE_WARM_START 0
#define TILE_BIAS       1
#define TILE_RELAX      2
#define TILE_BOUNCE     3

INLINE bool tile_reads(int kind, int pair)
{
	switch (pair)
	{
	case TILE_NORMAL_MASS:
		return kind != TILE_WARM_START;
	case TILE_TANGENT_MASS:
		return kind == TILE_RELAX;
	case TILE_TANGENT:
		return kind != TILE_BIAS;
	}
	return true;
}

INLINE void tile_pair(const Tiles* t, int j, int kind, int k, float pair[2])
{
	if (!tile_reads(kind, k))
		return;
	float2 both = runner_pairs(t->notes, t->stride, j)[k * t->stride];
	pair[0] = both.x;
	pair[1] = both.y;
}

// A pass of the constraint at place j.
INLINE void tile_task(const Pools* p, const Relay* r, const Tiles* t, BENCH Tile* tile, int j, int q, int kind)
{
	Runner u;
	int n = t->stride;
	float4 names = t->notes[j], on_a = t->notes[n + j], gaps = t->notes[2 * n + j];
	tile_pair(t, j, kind, TILE_NORMAL_MASS, u.normal_mass);
	tile_pair(t, j, kind, TILE_TANGENT_MASS, u.tangent_mass);
	tile_pair(t, j, kind, TILE_NORMAL, u.normal);
	tile_pair(t, j, kind, TILE_TANGENT, u.tangent);
	uint place_a = as_uint(names.x) & 0xffffu, place_b = as_uint(names.x) >> 16;
	tile_gather(tile, place_a, &u.c.a);
	tile_gather(tile, place_b, &u.c.b);
	u.friction = names.y;
	u.c.n = vec(names.z, names.w);
	u.c.t = vec(names.w, -names.z);
	u.c.ra[0] = vec(on_a.x, on_a.y);
	u.c.ra[1] = vec(on_a.z, on_a.w);
	u.c.rb[0] = vec_add(u.c.ra[0], vec(gaps.x, gaps.y));
	u.c.rb[1] = vec_add(u.c.ra[1], vec(gaps.x, gaps.y));
	u.gap[0] = pair_gap(&u.c, 0, gaps.z);
	u.gap[1] = pair_gap(&u.c, 1, gaps.w);

	bool ends = q + 1 == r->passes && kind >= TILE_RELAX;
	int i = p->step.extras || ends ? t->order[j] : 0;
	if (kind == TILE_WARM_START)
		pair_push(p, i, &u.c, u.normal[0], u.normal[1], u.tangent[0], u.tangent[1]);
	else if (kind == TILE_BIAS)
		runner_bias(p, i, &u);
	else if (kind == TILE_RELAX)
		runner_relax(p, i, &u);
	else
		runner_bounce(p, i, &u);
	tile_scatter(tile, place_a, &u.c.a);
	tile_scatter(tile, place_b, &u.c.b);
	if (ends)
	{
		runner_stow(p, i, &u);
		return;
	}
	__global float2* pairs = runner_pairs(t->notes, n, j);
	if (kind != TILE_WARM_START)
		pairs[TILE_NORMAL * n] = make_float2(u.normal[0], u.normal[1]);
	if (kind == TILE_RELAX)
		pairs[TILE_TANGENT * n] = make_float2(u.tangent[0], u.tangent[1]);
}

// the next place from which a group takes constraints: the same color's, or the next color's that has any
INLINE int tile_next(BENCH const int* range, int at, int* color)
{
	if (at < range[*color + 1])
		return at;
	do
		++*color;
	while (*color < COLORS && range[*color] == range[*color + 1]);
	return range[*color];
}

// Brings a line of memory near, where it is known how.
#ifdef __NV_CL_C_VERSION
#define FETCH_AHEAD(place) asm volatile("prefetch.global.L2 [%0];" ::"l"(place))
#else
#define FETCH_AHEAD(place)
#endif
#define LINE_BYTES 128

// The notes that a group will take next, one work-item a line. The pass is bound by memory: on an H200 this is 6 % faster
// than to hold them in registers ahead of time, and nothing is gained by more groups at work.
INLINE void tile_fetch_ahead(const Tiles* t, int j, int lane, int kind)
{
	int n = t->stride;
	if (lane % (LINE_BYTES / (int)sizeof(float4)) == 0)
		for (int k = 0; k < NOTE_QUADS; ++k)
			FETCH_AHEAD(t->notes + k * n + j);
	if (lane % (LINE_BYTES / (int)sizeof(float2)) == 0)
		for (int k = 0; k < TILE_PAIRS; ++k)
			if (tile_reads(kind, k))
				FETCH_AHEAD(runner_pairs(t->notes, n, j) + k * n);
}

// A group takes a tile.
INLINE void tile_work(const Pools* p, const Relay* r, const Tiles* t, BENCH Tile* tile, BENCH int* range, int q,
                      int kind)
{
	int lane = (int)get_local_id(0), row = (int)get_group_id(0);
	if (lane <= TILE_COLORS)
		range[lane] = t->table[row * TILE_COLORS + lane];
	for (int k = lane; k < TILE_BODIES; k += TILE_GROUP)
	{
		int resident = t->resident[row * TILE_BODIES + k];
		if (resident >= 0)
			tile_fetch(p, r, resident, q, tile, k);
	}
	if (lane == 0)
	{
		Body rests;
		rests.da = 0.0f;
		body_turn(&rests);
		tile->motion[TILE_RESTS] = make_float4(0.0f, 0.0f, 0.0f, 0.0f);
		tile->moved[TILE_RESTS] = make_float4(0.0f, 0.0f, rests.sine, rests.versine);
		tile->inv_inertia[TILE_RESTS] = 0.0f;
	}
	barrier(CLK_LOCAL_MEM_FENCE);
	int color = 0, at = tile_next(range, range[0], &color);
	while (color < COLORS)
	{
		int next_color = color, next = tile_next(range, at + TILE_GROUP, &next_color);
		if (next_color < COLORS && next + lane < range[next_color + 1])
			tile_fetch_ahead(t, next + lane, lane, kind);
		if (at + lane < range[color + 1])
			tile_task(p, r, t, tile, at + lane, q, kind);
		if (next_color != color)
			barrier(CLK_LOCAL_MEM_FENCE);
		at = next;
		color = next_color;
	}
	for (int k = lane; k < TILE_BODIES; k += TILE_GROUP)
	{
		int resident = t->resident[row * TILE_BODIES + k];
		if (resident >= 0)
			*(__global float4*)&p->body[resident & ~TILE_PLAIN] = tile->motion[k];
	}
}

#define TILE_PASS_KERNEL(name, kind)                                                                                \
	__kernel __attribute__((reqd_work_group_size(TILE_GROUP, 1, 1))) void name(                                     \
	    POOL_ARGUMENTS Step step, __global const int* resident, __global const int* table, __global const int* order, \
	    __global float4* notes, int stride, int substeps, int passes, int q, int bound)                             \
	{                                                                                                               \
		__local Tile tile;                                                                                          \
		__local int range[TILE_COLORS + 1];                                                                         \
		Pools pools = {POOL_NAMES step, 0};                                                                         \
		Relay r = {0, substeps, passes, 0};                                                                         \
		Tiles t = {0, 0, resident, table, order, notes, stride, 0};                                                 \
		if (tile_wanted(&pools, bound))                                                                             \
			tile_work(&pools, &r, &t, &tile, range, q, kind);                                                       \
	}
TILE_PASS_KERNEL(tile_warm_start, TILE_WARM_START)
TILE_PASS_KERNEL(tile_bias, TILE_BIAS)
TILE_PASS_KERNEL(tile_relax, TILE_RELAX)
TILE_PASS_KERNEL(tile_bounce, TILE_BOUNCE)

// Pass q of a constraint on the border: a body comes from its pool, or from the constraint before this one.
INLINE bool tile_hand(const Pools* p, const Relay* r, const Tiles* t, int j, int q, volatile BENCH int* fault)
{
	Runner u = runner_return(t->notes, t->stride, j);
	if (!u.inert)
	{
		Body* bodies[2] = {&u.c.a, &u.c.b};
		for (int k = 0; k < 2; ++k)
		{
			float row[8];
			Body* b = bodies[k];
			if (u.side[k].moves)
			{
				BodyState state = p->body[u.side[k].body];
				b->v = vec(state.vx, state.vy);
				b->w = state.w;
				b->d = vec(state.dx, state.dy);
				b->da = state.da;
			}
			else
			{
				body_alone(p, r->substeps, u.side[k].body, q, row);
				b->v = vec(row[0], row[1]);
				b->w = row[2];
				b->d = vec(row[4], row[5]);
				b->da = row[6];
			}
			body_turn(b);
		}
		u.gap[0] = pair_gap(&u.c, 0, u.separation[0]);
		u.gap[1] = pair_gap(&u.c, 1, u.separation[1]);
		Side sa = u.side[0], sb = u.side[1];
		volatile __global ulong* row_a = r->rows + RELAY_WORDS * (ulong)sa.body;
		volatile __global ulong* row_b = r->rows + RELAY_WORDS * (ulong)sb.body;
		if (!relay_wait(p, r, sa.moves && sa.before > 0, row_a, relay_turn(q, sa.before), &u.c.a.v, &u.c.a.w,
		                sb.moves && sb.before > 0, row_b, relay_turn(q, sb.before), &u.c.b.v, &u.c.b.w))
			*fault = 1;
	}
	barrier(CLK_LOCAL_MEM_FENCE);
	if (*fault)
	{
		*(volatile __global int*)&p->counters->fault = FAULT_BLOWN;
		return false;
	}
	if (u.inert)
		return true;
	int i = t->order[j];
	runner_pass(p, r->substeps, i, q, &u);
	for (int k = 0; k < 2; ++k)
	{
		Side side = u.side[k];
		Body b = k ? u.c.b : u.c.a;
		relay_pass_to(r, side, q, b);
		if (!side.moves || !side.last)
			continue;
		*(__global float4*)&p->body[side.body] = make_float4(b.v.x, b.v.y, b.w, b.inv_mass);
		if (q + 1 == r->passes)
			relay_clear(r->rows + RELAY_WORDS * (ulong)side.body);
	}
	if (q + 1 == r->passes)
		runner_stow(p, i, &u);
	else if (q > 0)
		runner_leave_impulses(&u, t->notes, t->stride, j);
	return true;
}

__kernel void tile_border(POOL_ARGUMENTS Step step, __global ulong* rows_of_words, __global const int* table,
                          __global const int* order, __global float4* notes, int stride, int rows, int substeps,
                          int passes, int q, int bound, int spins)
{
	volatile __local int fault;
	Pools pools = {POOL_NAMES step, 0};
	const Pools* p = &pools;
	Relay r = {rows_of_words, substeps, passes, spins};
	Tiles t = {0, 0, 0, table, order, notes, stride, rows};
	if (!tile_wanted(p, bound))
		return;
	if (get_local_id(0) == 0)
		fault = 0;
	barrier(CLK_LOCAL_MEM_FENCE);
	int begin = table[rows * TILE_COLORS], end = table[(rows + 1) * TILE_COLORS];
	for (int j = begin + (int)get_global_id(0); j < end; j += (int)get_global_size(0))
		if (!tile_hand(p, &r, &t, j, q, &fault))
			return;
}
