// SPDX-License-Identifier: MIT
// tiles.cl -- solves a large world with tiles: in each pass, a work-group keeps a tile of bodies in local memory.
//
// Launches by color read and write a body in global memory once per constraint. A tile contains neighbors along the
// Hilbert curve of the broad phase's tree. In one launch per pass, a work-group loads a tile once, integrates its
// bodies, and solves the constraints inside it color by color.
//
// A constraint between two tiles is a border constraint. The constraints of a body are solved in the order of their
// colors, so the later constraints of its two bodies are border constraints too. A second launch solves the border as a
// relay (relay.cl). The result does not depend on the tiles.
#include "opencl/group_sizes.h"
#include "pools/pools.h"

#define TILE_RESTS TILE_BODIES // common place in local memory for all bodies that are at rest and cannot move
#define TILE_PLAIN 0x40000000  // added to the index of a body for which tile_plain is true

// Returns false if the counter with index `bound` is 0: the layout has changed, and the kernels do nothing.
INLINE bool tile_wanted(const Pools* p, int bound)
{
	return bound < 0 || ((__global const int*)p->counters)[bound] != 0;
}

INLINE int tile_holds(const Pools* p, int body)
{
	return body >= 0 && p->color_mask[body] != 0 && p->sleep[body] == 0 && p->body[body].inv_mass > 0.0f;
}

INLINE int tile_body_of(const Pools* p, int leaf)
{
	return leaf < p->tree[0].leaves ? p->collidable_body[p->leaf[p->tree[0].leaf_begin + leaf]] : -1;
}

// Returns TILE_PLAIN if a body has no force, torque, damping or locked axis, and gravity scale 1; otherwise 0. Passes
// do not read the constants of a plain body. Only fields can change these constants without a rebuild of the tiles: a
// change by the user makes tiles stale.
INLINE int tile_plain(const Pools* p, int body)
{
	Motion m = p->motion[body];
	int odd = float_bits(m.fx) | float_bits(m.fy) | float_bits(m.torque) | float_bits(m.linear_damping) |
	          float_bits(m.angular_damping);
	return odd == 0 && m.gravity_scale == 1.0f && m.free_x == 1.0f && m.free_y == 1.0f ? TILE_PLAIN : 0;
}

// Assigns each body the place of one of its leaves: if it has several, the last write is kept. Sets its first border
// color to a value above all colors. place, border: one int per body.
__kernel void tile_settle(POOL_ARGUMENTS Step step, __global int* place, __global int* border, int places,
                          int bound)
{
	Pools pools = {POOL_NAMES step, 0};
	int i = (int)get_global_id(0), body = i < places && tile_wanted(&pools, bound) ? tile_body_of(&pools, i) : -1;
	if (!tile_holds(&pools, body))
		return;
	place[body] = i;
	border[body] = COLORS + 1;
}

// Lists the bodies by place; `resident` is -1 at places without a body. pushed: 1 if fields change forces, so that no
// body counts as plain.
__kernel void tile_list(POOL_ARGUMENTS Step step, __global const int* place, __global int* resident, int places,
                        int bound, int pushed)
{
	Pools pools = {POOL_NAMES step, 0};
	int i = (int)get_global_id(0), body = i < places ? tile_body_of(&pools, i) : -1;
	if (i < places && tile_wanted(&pools, bound))
		resident[i] = tile_holds(&pools, body) && place[body] == i ? body | (pushed ? 0 : tile_plain(&pools, body)) : -1;
}

INLINE bool tile_still(const float row[8])
{
	return all_zero(row, 3) && all_zero(row + 4, 4);
}

// Returns the table row for constraints of a body with infinite mass. If the body rests, the row is -1, which stands
// for any row. If it moves, the row is that of the border (`rows`), because its position differs from pass to pass.
INLINE int tile_row_of_fixed(const Pools* p, int body, int rows)
{
	float first[8], second[8];
	body_alone(p, 1, body, 0, first);
	body_alone(p, 1, body, 2, second);
	return tile_still(first) && tile_still(second) ? -1 : rows;
}

INLINE int tile_column(int color, int kind) { return color * CONSTRAINT_KINDS + kind; }

// Returns the row of a constraint: its tile, or `rows` for the border. border: first border color of each body.
INLINE int tile_row(const Pools* p, KindPlace at, int color, __global const int* place, __global const int* border,
                    int rows)
{
	Int2 both = edge_bodies_at(p, at.kind, at.place);
	int bodies[2] = {both.x, both.y}, row = -1;
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

// Counts the constraints of one color in each row and kind. There is a launch per color, because the border depends on
// earlier colors. rank: number of constraints with the same row, color and kind that were counted before each
// constraint; it may differ between executions.
__kernel void tile_count(POOL_ARGUMENTS Step step, __global const int* place, __global int* border, __global int* table,
                         __global int* rank, int rows, int bound, int begin, int end)
{
	// number of border constraints of the work-group, by kind; one atomic operation per kind adds it to the table
	__local int border_count[CONSTRAINT_KINDS], first[CONSTRAINT_KINDS], found;
	Pools pools = {POOL_NAMES step, 0};
	const Pools* p = &pools;
	int i = begin + (int)get_global_id(0), lane = (int)get_local_id(0);
	KindPlace at = task_at(p, i < end ? i : begin);
	int slot = i < end && tile_wanted(p, bound) ? edge_slot_at(p, at.kind, at.place) : -1;
	int color = 0, row = -1, mine = 0;
	if (lane < CONSTRAINT_KINDS)
		border_count[lane] = 0;
	barrier(CLK_LOCAL_MEM_FENCE);
	if (slot >= 0)
	{
		color = edge_color(p, at.kind, slot);
		row = tile_row(p, at, color, place, border, rows);
	}
	if (row == rows)
	{
		mine = atomic_inc(&border_count[at.kind]);
		found = color;
		Int2 both = edge_bodies_at(p, at.kind, at.place);
		int bodies[2] = {both.x, both.y};
		for (int k = 0; k < 2; ++k)
			if (p->body[bodies[k]].inv_mass > 0.0f && border[bodies[k]] > color)
				border[bodies[k]] = color;
	}
	else if (row >= 0)
		rank[i] = atomic_inc(&table[row * TILE_COLUMNS + tile_column(color, at.kind)]);
	barrier(CLK_LOCAL_MEM_FENCE);
	if (lane < CONSTRAINT_KINDS && border_count[lane] > 0)
		first[lane] = atomic_add(&table[rows * TILE_COLUMNS + tile_column(found, lane)], border_count[lane]);
	barrier(CLK_LOCAL_MEM_FENCE);
	if (row == rows)
		rank[i] = first[at.kind] + mine;
}

INLINE int tile_padded(int count, int row, int rows)
{
	// in the border, all work-items of a work-group must have constraints of one color
	return row < rows ? count : (count + RELAY_GROUP - 1) / RELAY_GROUP * RELAY_GROUP;
}

// Adds up the numbers of places in each row of the table; the last row is the border.
__kernel void tile_total(__global const int* table, __global int* total, int rows)
{
	int row = (int)get_global_id(0), sum = 0;
	if (row > rows)
		return;
	for (int k = 0; k < TILE_COLUMNS; ++k)
		sum += tile_padded(table[row * TILE_COLUMNS + k], row, rows);
	total[row] = sum;
}

// Replaces the sum of each row by the first place of the row, in one work-group.
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

// Replaces each count of the table by the first place of its constraints. The row after the border gets its end.
__kernel void tile_range(__global int* table, __global const int* total, int rows)
{
	int row = (int)get_global_id(0);
	if (row > rows + 1)
		return;
	int begin = total[row];
	for (int k = 0; k < (row > rows ? 1 : TILE_COLUMNS); ++k)
	{
		int count = row > rows ? 0 : tile_padded(table[row * TILE_COLUMNS + k], row, rows);
		table[row * TILE_COLUMNS + k] = begin;
		begin += count;
	}
}

// Writes the number of each constraint's task to the constraint's place in `order`; the other places keep -1.
__kernel void tile_order(POOL_ARGUMENTS Step step, __global const int* place, __global const int* border,
                         __global const int* table, __global const int* rank, int rows, int bound,
                         __global int* order, int constraints)
{
	Pools pools = {POOL_NAMES step, 0};
	const Pools* p = &pools;
	int i = (int)get_global_id(0);
	KindPlace at = task_at(p, i < constraints ? i : 0);
	int slot = i < constraints && tile_wanted(p, bound) ? edge_slot_at(p, at.kind, at.place) : -1;
	if (slot < 0)
		return;
	int color = edge_color(p, at.kind, slot), row = tile_row(p, at, color, place, border, rows);
	order[table[row * TILE_COLUMNS + tile_column(color, at.kind)] + rank[i]] = i;
}

typedef struct
{
	__global const int* place;
	__global const int* border;
	__global const int* resident;
	__global const int* table;
	__global const int* order;
	__global float4* stream; // each column has `stride` entries
	int stride, rows;
} Tiles;

// Returns the place of a body in its tile, for a constraint inside the tile; TILE_RESTS if the body cannot move.
INLINE uint tile_place(const Pools* p, const Tiles* t, int body)
{
	return p->body[body].inv_mass > 0.0f ? (uint)t->place[body] % TILE_BODIES : TILE_RESTS;
}

// Returns the side of a border constraint. side.before counts only border constraints of the body.
INLINE Side tile_side(const Pools* p, const Tiles* t, int body, int color)
{
	Side side = side_of(p, body, color, false);
	if (side.moves)
	{
		Word64 inner = ((Word64)1 << t->border[body]) - (Word64)1, lower = ((Word64)1 << color) - (Word64)1;
		side.before = (int)popcount(p->color_mask[body] & lower & ~inner);
	}
	return side;
}

// Prepares the constraint at place j and writes it to the stream, for the passes.
INLINE void tile_prepare_at(const Pools* p, const Tiles* t, int j)
{
	if (j == 0)
		counters_clear(p);
	if (j >= t->table[(t->rows + 1) * TILE_COLUMNS])
		return;
	int i = t->order[j];
	bool on_border = j >= t->table[t->rows * TILE_COLUMNS];
	Registers u;
	u.inert = i < 0;
	if (u.inert)
	{
		registers_store(&u, t->stream, t->stride, j);
		return;
	}
	KindPlace at = task_at(p, i);
	int slot = edge_slot_at(p, at.kind, at.place), color = edge_color(p, at.kind, slot);
	u = registers_make(p, at, slot);
	if (on_border)
	{
		u.side[0] = tile_side(p, t, u.side[0].body, color);
		u.side[1] = tile_side(p, t, u.side[1].body, color);
		registers_store(&u, t->stream, t->stride, j);
	}
	else
	{
		uint places = tile_place(p, t, u.side[0].body) | tile_place(p, t, u.side[1].body) << 16;
#define CONSTRAINT_KIND(name, Name, NAME) \
		if (at.kind == CONSTRAINT_##NAME) \
			name##_stream_store(&u.of.name, as_float(places), t->stream, t->stride, j);
#include "pools/kinds.def"
#undef CONSTRAINT_KIND
	}
}

#define TILE_PREPARE_KERNEL(name, specialize)                                                                        \
	__kernel void name(POOL_ARGUMENTS Step step, __global const int* place, __global const int* border,           \
	                   __global const int* table, __global const int* order, __global float4* stream, int stride, \
	                   int rows, int bound)                                                                       \
	{                                                                                                             \
		Pools pools = {POOL_NAMES step, 0};                                                                       \
		Tiles t = {place, border, 0, table, order, stream, stride, rows};                                         \
		specialize(pools.step);                                                                                   \
		STEP_ALONE(pools.step);                                                                                   \
		if (tile_wanted(&pools, bound))                                                                           \
			tile_prepare_at(&pools, &t, (int)get_global_id(0));                                                   \
	}
TILE_PREPARE_KERNEL(tile_prepare, STEP_CONTACTS)
TILE_PREPARE_KERNEL(tile_prepare_plain, STEP_PLAIN)
TILE_PREPARE_KERNEL(tile_prepare_joints, STEP_JOINTS)
