// SPDX-License-Identifier: MIT
// tiles.cl -- the solve of a large world, a pass a launch: what is near lies in local memory while all colors are solved.
//
// A pass by colors brings every body from memory and back as often as it has constraints. So the bodies are cut into
// tiles of neighbors, along the curve of the broad phase's tree, and a group takes a tile: its bodies come once, and the
// constraints among them are solved color by color with nothing but barriers in between.
//
// That must not change what each body goes through, which is its constraints in the order of colors. A constraint
// between two tiles is on the border, and so is every one that comes after it on either body: those are left over, and
// follow in a second launch as a relay (relay.cl). Whatever the tiles are, the result is the same.
//
// Integration costs no pass over the bodies: a tile does it when it fetches them.
#include "opencl/limits.h"
#include "pools/pools.h"

// the place in local memory of whatever rests and cannot be moved
#define TILE_RESTS TILE_BODIES
// bits of a resident: its body, and whether the constants of its motion are the usual ones, which need not be read
#define TILE_PLAIN 0x40000000

// ---------------------------------------------------------------------------------------------------------------
// who is where
// ---------------------------------------------------------------------------------------------------------------

// Nothing is done when the counter at bound is zero: the constraints are not those that the host knows.
INLINE bool tile_wanted(const Pools* p, int bound)
{
	return bound < 0 || ((__global const int*)p->counters)[bound] != 0;
}

INLINE int tile_holds(const Pools* p, int body)
{
	return body >= 0 && p->color_mask[body] != 0 && p->body[body].inv_mass > 0.0f;
}

INLINE int tile_body_of(const Pools* p, int leaf)
{
	return leaf < p->tree[0].leaves ? p->collidable_body[p->leaf[p->tree[0].leaf_begin + leaf]] : -1;
}

// No force, damping or lock, and the world's gravity. What is true when the tiles are laid out stays true: the user's
// changes lay them out anew.
INLINE int tile_plain(const Pools* p, int body)
{
	Motion m = p->motion[body];
	int odd = float_bits(m.fx) | float_bits(m.fy) | float_bits(m.torque) | float_bits(m.linear_damping) |
	          float_bits(m.angular_damping);
	return odd == 0 && m.gravity_scale == 1.0f && m.free_x == 1.0f && m.free_y == 1.0f ? TILE_PLAIN : 0;
}

// A body belongs where one of its leaves is, whichever comes last. place is by body, resident by place.
__kernel void tile_settle(POOL_ARGUMENTS Step step, __global int* place, __global int* border, int places,
                          int bound)
{
	Pools pools = {POOL_NAMES step, 0};
	int i = (int)get_global_id(0), body = i < places && tile_wanted(&pools, bound) ? tile_body_of(&pools, i) : -1;
	if (!tile_holds(&pools, body))
		return;
	place[body] = i;
	border[body] = TILE_COLORS;
}

__kernel void tile_list(POOL_ARGUMENTS Step step, __global const int* place, __global int* resident, int places,
                        int bound)
{
	Pools pools = {POOL_NAMES step, 0};
	int i = (int)get_global_id(0), body = i < places ? tile_body_of(&pools, i) : -1;
	if (i < places && tile_wanted(&pools, bound))
		resident[i] = tile_holds(&pools, body) && place[body] == i ? body | tile_plain(&pools, body) : -1;
}

INLINE bool tile_still(const float row[8])
{
	return relay_bits(row) == 0 && relay_bits(row + 4) == 0 && float_bits(row[7]) == 0;
}

// The row of the table to which a body that cannot move lets its constraints belong: any, or the border's when it is
// driven, for then it is elsewhere in every pass.
INLINE int tile_row_of_fixed(const Pools* p, int body, int rows)
{
	Relay r = {0, 1, 0, 0};
	float first[8], second[8];
	relay_alone(p, &r, body, 0, first);
	relay_alone(p, &r, body, 2, second);
	return tile_still(first) && tile_still(second) ? -1 : rows;
}

// The row of the table that a constraint belongs to: its tile's, or the last one for what is on the border. border is
// the first color of a body that is.
INLINE int tile_row(const Pools* p, int i, int color, __global const int* place, __global const int* border, int rows)
{
	int bodies[2] = {constraint_at(p, body_a, i), constraint_at(p, body_b, i)}, row = -1;
	for (int k = 0; k < 2 && row != rows; ++k)
	{
		int body = bodies[k], own;
		if (!(p->body[body].inv_mass > 0.0f))
			own = tile_row_of_fixed(p, body, rows);
		else
			own = border[body] <= color ? rows : place[body] / TILE_BODIES;
		row = row == -1 || row == own ? own : own == -1 ? row : rows;
	}
	return row == -1 ? rows : row;
}

// Counts the constraints of one color, and finds those on the border: one launch a color, for each depends on the colors
// before it. The count so far is the constraint's rank, in no order.
__kernel void tile_count(POOL_ARGUMENTS Step step, __global const int* place, __global int* border, __global int* table,
                         __global int* rank, int rows, int bound, int begin, int end)
{
	// many are on the border, and would all ask for one counter
	__local int together, first, found;
	Pools pools = {POOL_NAMES step, 0};
	const Pools* p = &pools;
	int i = begin + (int)get_global_id(0), slot = i < end && tile_wanted(p, bound) ? p->constraint_contact[i] : -1;
	int color = 0, row = -1, mine = 0;
	if (get_local_id(0) == 0)
		together = 0;
	barrier(CLK_LOCAL_MEM_FENCE);
	if (slot >= 0)
	{
		color = p->contact_color[slot];
		row = tile_row(p, i, color, place, border, rows);
	}
	if (row == rows)
	{
		mine = atomic_inc(&together);
		found = color;
		int bodies[2] = {constraint_at(p, body_a, i), constraint_at(p, body_b, i)};
		for (int k = 0; k < 2; ++k)
			if (p->body[bodies[k]].inv_mass > 0.0f && border[bodies[k]] > color)
				border[bodies[k]] = color;
	}
	else if (row >= 0)
		rank[i] = atomic_inc(&table[row * TILE_COLORS + color]);
	barrier(CLK_LOCAL_MEM_FENCE);
	if (get_local_id(0) == 0 && together > 0)
		first = atomic_add(&table[rows * TILE_COLORS + found], together);
	barrier(CLK_LOCAL_MEM_FENCE);
	if (row == rows)
		rank[i] = first + mine;
}

INLINE int tile_padded(int count, int row, int rows)
{
	// what the relay takes in step is of one color
	return row < rows ? count : (count + RELAY_GROUP - 1) / RELAY_GROUP * RELAY_GROUP;
}

// constraints of each row, the last one being the border's
__kernel void tile_total(__global const int* table, __global int* total, int rows)
{
	int row = (int)get_global_id(0), sum = 0;
	if (row > rows)
		return;
	for (int k = 0; k < TILE_COLORS; ++k)
		sum += tile_padded(table[row * TILE_COLORS + k], row, rows);
	total[row] = sum;
}

// Where each row begins. One group.
__kernel __attribute__((reqd_work_group_size(PRIMITIVE_GROUP, 1, 1))) void tile_begin(__global int* total, int rows)
{
	__local uint sum[PRIMITIVE_GROUP];
	uint before = 0, t = (uint)get_local_id(0);
	for (int first = 0; first <= rows + 1; first += PRIMITIVE_GROUP)
	{
		int row = first + (int)t;
		uint mine = row <= rows ? (uint)total[row] : 0u, below = group_scan(sum, mine);
		if (row <= rows + 1)
			total[row] = (int)(before + below);
		before += sum[PRIMITIVE_GROUP - 1];
		barrier(CLK_LOCAL_MEM_FENCE);
	}
}

// Counts into beginnings. The row behind the border's holds the end.
__kernel void tile_range(__global int* table, __global const int* total, int rows)
{
	int row = (int)get_global_id(0);
	if (row > rows + 1)
		return;
	int begin = total[row];
	for (int k = 0; k < (row > rows ? 1 : TILE_COLORS); ++k)
	{
		int count = row > rows ? 0 : tile_padded(table[row * TILE_COLORS + k], row, rows);
		table[row * TILE_COLORS + k] = begin;
		begin += count;
	}
}

// order: constraint at each place, -1 for none
__kernel void tile_order(POOL_ARGUMENTS Step step, __global const int* place, __global const int* border,
                         __global const int* table, __global const int* rank, int rows, int bound,
                         __global int* order, int constraints)
{
	Pools pools = {POOL_NAMES step, 0};
	const Pools* p = &pools;
	int i = (int)get_global_id(0), slot = i < constraints && tile_wanted(p, bound) ? p->constraint_contact[i] : -1;
	if (slot < 0)
		return;
	int color = p->contact_color[slot];
	order[table[tile_row(p, i, color, place, border, rows) * TILE_COLORS + color] + rank[i]] = i;
}

// ---------------------------------------------------------------------------------------------------------------
// notes: a constraint as the passes stream it
// ---------------------------------------------------------------------------------------------------------------

typedef struct
{
	__global const int* place;
	__global const int* border;
	__global const int* resident;
	__global const int* table;
	__global const int* order;
	__global float4* notes; // in columns of stride
	int stride, rows;
} Tiles;

// The place of a body in its tile, for a constraint that is not on the border.
INLINE uint tile_place(const Pools* p, const Tiles* t, int body)
{
	return p->body[body].inv_mass > 0.0f ? (uint)t->place[body] % TILE_BODIES : TILE_RESTS;
}

// The side of a constraint on the border: of the body's constraints, those before the first on the border do not count.
INLINE Side tile_side(const Pools* p, const Tiles* t, int body, int color)
{
	Side side = relay_side(p, body, color);
	if (side.moves)
	{
		Word64 inner = ((Word64)1 << t->border[body]) - (Word64)1, lower = ((Word64)1 << color) - (Word64)1;
		side.before = (int)popcount(p->color_mask[body] & lower & ~inner);
	}
	return side;
}

// pairs of a note, behind its quads: names of places, friction and normal; anchors on a; offset and separations
#define TILE_NORMAL_MASS  0
#define TILE_TANGENT_MASS 1
#define TILE_NORMAL       2
#define TILE_TANGENT      3
#define TILE_PAIRS        4

INLINE void tile_leave(const Runner* u, uint names, Vec offset, const Tiles* t, int j)
{
	int n = t->stride;
	__global float2* pairs = relay_pairs(t->notes, n, j);
	t->notes[j] = (float4)(as_float(names), u->friction, u->c.n.x, u->c.n.y);
	t->notes[n + j] = (float4)(u->c.ra[0].x, u->c.ra[0].y, u->c.ra[1].x, u->c.ra[1].y);
	t->notes[2 * n + j] = (float4)(offset.x, offset.y, u->separation[0], u->separation[1]);
	pairs[TILE_NORMAL_MASS * n] = (float2)(u->normal_mass[0], u->normal_mass[1]);
	pairs[TILE_TANGENT_MASS * n] = (float2)(u->tangent_mass[0], u->tangent_mass[1]);
	pairs[TILE_NORMAL * n] = (float2)(u->normal[0], u->normal[1]);
	pairs[TILE_TANGENT * n] = (float2)(u->tangent[0], u->tangent[1]);
}

__kernel void tile_prepare(POOL_ARGUMENTS Step step, __global const int* place, __global const int* border,
                           __global const int* table, __global const int* order, __global float4* notes, int stride,
                           int rows, int cleanse, int bound)
{
	Pools pools = {POOL_NAMES step, 0};
	const Pools* p = &pools;
	Tiles t = {place, border, 0, table, order, notes, stride, rows};
	if (!tile_wanted(p, bound))
		return;
	int j = (int)get_global_id(0);
	if (j == 0)
	{
		p->counters->nonfinite = 0;
		p->counters->first_nonfinite = 0x7fffffff;
	}
	if (j >= table[(rows + 1) * TILE_COLORS])
		return;
	int i = order[j];
	bool on_border = j >= table[rows * TILE_COLORS];
	Runner u;
	u.inert = i < 0;
	if (u.inert)
	{
		relay_leave(&u, notes, stride, j);
		return;
	}
	if (cleanse)
		cleanse_item(p, i);
	int slot = p->constraint_contact[i], color = p->contact_color[slot];
	Prepared made = prepare_points(p, p->constraint_pair[i], slot);
	if (p->step.extras)
		prepare_extras(p, i, &made);
	u = relay_make(p, i, &made);
	if (on_border)
	{
		u.side[0] = tile_side(p, &t, u.c.ia, color);
		u.side[1] = tile_side(p, &t, u.c.ib, color);
		relay_leave(&u, notes, stride, j);
	}
	else
		tile_leave(&u, tile_place(p, &t, u.c.ia) | tile_place(p, &t, u.c.ib) << 16, made.offset, &t, j);
}

// ---------------------------------------------------------------------------------------------------------------
// a pass
// ---------------------------------------------------------------------------------------------------------------

typedef struct // the bodies of a tile
{
	float4 motion[TILE_BODIES + 1]; // velocity x, y, angular, inverse mass
	float4 moved[TILE_BODIES + 1];  // displacement x, y, sine and versine of the turn
	float inv_inertia[TILE_BODIES + 1];
} Tile;

// A body into local memory, moved on to pass q.
INLINE void tile_fetch(const Pools* p, const Relay* r, int resident, int q, __local Tile* tile, int k)
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
			relay_motion(p, body, m);
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
		*(__global float4*)&p->body[body].dx = (float4)(row[4], row[5], row[6], row[7]);
	Body b;
	b.da = row[6];
	body_turn(&b);
	tile->motion[k] = (float4)(row[0], row[1], row[2], row[3]);
	tile->moved[k] = (float4)(row[4], row[5], b.sine, b.versine);
	tile->inv_inertia[k] = row[7];
}

INLINE void tile_gather(__local const Tile* tile, uint place, Body* b)
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

INLINE void tile_scatter(__local Tile* tile, uint place, const Body* b)
{
	if (place != TILE_RESTS)
		tile->motion[place] = (float4)(b->v.x, b->v.y, b->w, b->inv_mass);
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
		return kind == TILE_BIAS || kind == TILE_RELAX;
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
	float2 both = relay_pairs(t->notes, t->stride, j)[k * t->stride];
	pair[0] = both.x;
	pair[1] = both.y;
}

// A pass of the constraint at place j.
INLINE void tile_task(const Pools* p, const Relay* r, const Tiles* t, __local Tile* tile, int j, int q, int kind)
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
		relay_bias(&p->step, &u);
	else if (kind == TILE_RELAX)
		relay_relax(p, i, &u);
	else
		relay_bounce(p, i, &u);
	tile_scatter(tile, place_a, &u.c.a);
	tile_scatter(tile, place_b, &u.c.b);
	if (ends)
	{
		relay_stow(p, i, &u);
		return;
	}
	__global float2* pairs = relay_pairs(t->notes, n, j);
	if (kind != TILE_WARM_START)
		pairs[TILE_NORMAL * n] = (float2)(u.normal[0], u.normal[1]);
	if (kind == TILE_RELAX)
		pairs[TILE_TANGENT * n] = (float2)(u.tangent[0], u.tangent[1]);
}

// the next place from which a group takes constraints: the same color's, or the next color's that has any
INLINE int tile_next(__local const int* range, int at, int* color)
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
		for (int k = 0; k < RELAY_QUADS; ++k)
			FETCH_AHEAD(t->notes + k * n + j);
	if (lane % (LINE_BYTES / (int)sizeof(float2)) == 0)
		for (int k = 0; k < TILE_PAIRS; ++k)
			if (tile_reads(kind, k))
				FETCH_AHEAD(relay_pairs(t->notes, n, j) + k * n);
}

// A group takes a tile.
INLINE void tile_work(const Pools* p, const Relay* r, const Tiles* t, __local Tile* tile, __local int* range, int q,
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
		tile->motion[TILE_RESTS] = (float4)(0.0f, 0.0f, 0.0f, 0.0f);
		tile->moved[TILE_RESTS] = (float4)(0.0f, 0.0f, rests.sine, rests.versine);
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
INLINE bool tile_hand(const Pools* p, const Relay* r, const Tiles* t, int j, int q, volatile __local int* fault)
{
	Runner u = relay_return(t->notes, t->stride, j);
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
				relay_alone(p, r, u.side[k].body, q, row);
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
	relay_pass(p, r, i, q, &u);
	for (int k = 0; k < 2; ++k)
	{
		Side side = u.side[k];
		Body b = k ? u.c.b : u.c.a;
		relay_pass_to(r, side, q, b);
		if (!side.moves || !side.last)
			continue;
		*(__global float4*)&p->body[side.body] = (float4)(b.v.x, b.v.y, b.w, b.inv_mass);
		if (q + 1 == r->passes)
			relay_clear(r->rows + RELAY_WORDS * (ulong)side.body);
	}
	if (q + 1 == r->passes)
		relay_stow(p, i, &u);
	else if (q > 0)
		relay_note_impulses(&u, t->notes, t->stride, j);
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
