// SPDX-License-Identifier: MIT
// tile_pass.cl -- executes one pass of the solve over all tiles, and then over the border constraints.
#include "opencl/forms/tiles.cl"

typedef struct // bodies of a tile in local memory
{
	float4 motion[TILE_BODIES + 1]; // velocity x, y, angular velocity, inverse mass
	float4 moved[TILE_BODIES + 1];  // displacement x, y, rotation, inverse inertia
} Tile;

// fails to compile if a pass has more local memory than the host expects
typedef char tile_fits[sizeof(Tile) + 4 * (TILE_COLUMNS + 1) <= TILE_MEMORY ? 1 : -1];

// Loads a body, integrated up to pass q, into place k of a tile. resident: its index, plus TILE_PLAIN if it is plain.
INLINE void tile_fetch(const Pools* p, const Relay* r, int resident, int q, LOCAL Tile* tile, int k)
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
	else if (schedule_before(r->substeps, q) != BODY_STAYS)
	{
		float m[8] = {0.0f, 0.0f, 0.0f, 1.0f, 0.0f, 0.0f, 1.0f, 1.0f};
		if (!(resident & TILE_PLAIN))
			body_motion(p, body, m);
		if (schedule_before(r->substeps, q) == BODY_ACCELERATES)
		{
			Float4 old = p->base[body];
			float base[4] = {old.x, old.y, old.z, 0.0f};
			body_accelerate(&p->step, gravity_of(p, body), row, m, base, schedule_first(q));
			p->base[body] = make_float4(base[0], base[1], base[2], 0.0f);
		}
		else
			body_move(&p->step, row, m);
	}
	if (q == 0 || schedule_before(r->substeps, q) == BODY_MOVES)
		*(__global float4*)&p->body[body].dx = make_float4(row[4], row[5], row[6], row[7]);
	tile->motion[k] = make_float4(row[0], row[1], row[2], row[3]);
	tile->moved[k] = make_float4(row[4], row[5], row[6], row[7]);
}

INLINE void tile_gather(const Pools* p, LOCAL const Tile* tile, uint place, Body* b)
{
	body_unpack(tile->motion[place], tile->moved[place], b);
}

INLINE void tile_scatter(LOCAL Tile* tile, uint place, const Body* b)
{
	if (place != TILE_RESTS)
		tile->motion[place] = make_float4(b->v.x, b->v.y, b->w, b->inv_mass);
}

// Executes pass q of the constraint at place j; pass: kind of pass q (PASS_*).
#define CONSTRAINT_KIND(kind, Kind, KIND)                                                                        \
	INLINE void kind##_tile_task(const Pools* p, const Relay* r, const Tiles* t, LOCAL Tile* tile, int j, int q, \
	                             int pass)                                                                       \
	{                                                                                                            \
		Kind u;                                                                                                  \
		Kind##Ready ready;                                                                                       \
		Body a, b;                                                                                               \
		uint places = as_uint(kind##_stream_load(&u, 1 << pass, t->stream, t->stride, j));                       \
		tile_gather(p, tile, places & 0xffffu, &a);                                                              \
		tile_gather(p, tile, places >> 16, &b);                                                                  \
		bool ends = q + 1 == r->passes && pass >= PASS_RELAX;                                                    \
		bool named = KIND##_RARE(&p->step) || ends || BATCHED(p);                                    \
		int i = named ? task_at(p, t->order[j]).place : 0;                                                        \
		kind##_ready(p, pass, i, &a, &b, &u, &ready);                                                            \
		kind##_pass(p, pass, i, &ready, &u, &a, &b);                                                             \
		tile_scatter(tile, places & 0xffffu, &a);                                                                \
		tile_scatter(tile, places >> 16, &b);                                                                    \
		if (ends)                                                                                                \
			kind##_store_kept(p, i, &u);                                                                         \
		else                                                                                                     \
			kind##_stream_update(&u, 1 << pass, t->stream, t->stride, j);                                        \
	}
#include "pools/kinds.def"
#undef CONSTRAINT_KIND

#define TILE_LAST_COLUMN (TILE_COLUMNS - 1)

// Returns place `at` if it is in column *column. Otherwise sets *column to the next column with constraints
// (TILE_LAST_COLUMN if there is none), and returns the first place of that column.
INLINE int tile_next(const Pools* p, LOCAL const int* range, int at, int* column)
{
	if (at < range[*column + 1])
		return at;
	do
		*column += p->step.joints ? 1 : CONSTRAINT_KINDS;
	while (*column < TILE_LAST_COLUMN && range[*column] == range[*column + 1]);
	return range[*column];
}

// Prefetches a cache line, if the compiler supports it.
#ifdef __NV_CL_C_VERSION
#define FETCH_AHEAD(place) asm volatile("prefetch.global.L2 [%0];" ::"l"(place))
#else
#define FETCH_AHEAD(place)
#endif
#define LINE_BYTES 128

#define STREAM_SKIP_PAIR(k, read, written, c0, c1)
#define STREAM_FETCH_QUAD(k, c0, c1, c2, c3) FETCH_AHEAD(t->stream + k * n + j);
#define STREAM_FETCH_PAIR(k, read, written, c0, c1) \
	if ((read) >> pass & 1)                         \
		FETCH_AHEAD(stream_pairs(t->stream, n, j) + k * n);

// Returns whether the world may have constraints of a kind; this is a constant in kernels without joints.
INLINE bool tile_has(const Pools* p, int kind) { return kind == CONSTRAINT_CONTACT || p->step.joints; }

// Prefetches the next constraints of a work-group, one work-item per cache line. Memory bandwidth limits the pass: on
// an H200, loading the next constraints into registers makes a pass 6 % slower than this prefetch, and a higher
// occupancy saves no time.
INLINE void tile_fetch_ahead(const Pools* p, const Tiles* t, int kind, int j, int lane, int pass)
{
	int n = t->stride;
#define CONSTRAINT_KIND(name, Name, NAME)                                            \
	if (tile_has(p, CONSTRAINT_##NAME) && kind == CONSTRAINT_##NAME && lane % (LINE_BYTES / (int)sizeof(float4)) == 0) \
	{                                                                                \
		NAME##_STREAM(STREAM_FETCH_QUAD, STREAM_SKIP_PAIR)                           \
	}                                                                                \
	if (tile_has(p, CONSTRAINT_##NAME) && kind == CONSTRAINT_##NAME && lane % (LINE_BYTES / (int)sizeof(float2)) == 0) \
	{                                                                                \
		NAME##_STREAM(STREAM_SKIP_QUAD, STREAM_FETCH_PAIR)                           \
	}
#include "pools/kinds.def"
#undef CONSTRAINT_KIND
}

INLINE_MEET void tile_work(const Pools* p, const Relay* r, const Tiles* t, LOCAL Tile* tile, LOCAL int* range, int q,
                           int pass)
{
	int lane = (int)get_local_id(0), row = (int)get_group_id(0);
	for (int k = lane; k <= TILE_COLUMNS; k += TILE_GROUP)
		range[k] = t->table[row * TILE_COLUMNS + k];
	for (int k = lane; k < TILE_BODIES; k += TILE_GROUP)
	{
		int resident = t->resident[row * TILE_BODIES + k];
		if (resident >= 0)
			tile_fetch(p, r, resident, q, tile, k);
	}
	if (lane == 0)
	{
		tile->motion[TILE_RESTS] = make_float4(0.0f, 0.0f, 0.0f, 0.0f);
		tile->moved[TILE_RESTS] = make_float4(0.0f, 0.0f, 0.0f, 0.0f);
	}
	barrier(CLK_LOCAL_MEM_FENCE);
	int column = 0, at = tile_next(p, range, range[0], &column);
	while (column < TILE_LAST_COLUMN)
	{
		int next_column = column, next = tile_next(p, range, at + TILE_GROUP, &next_column);
		if (next_column < TILE_LAST_COLUMN && next + lane < range[next_column + 1])
			tile_fetch_ahead(p, t, next_column % CONSTRAINT_KINDS, next + lane, lane, pass);
#define CONSTRAINT_KIND(name, Name, NAME)                                                    \
		if (tile_has(p, CONSTRAINT_##NAME) && column % CONSTRAINT_KINDS == CONSTRAINT_##NAME && \
		    at + lane < range[column + 1])                                                   \
			name##_tile_task(p, r, t, tile, at + lane, q, pass);
#include "pools/kinds.def"
#undef CONSTRAINT_KIND
		if (next_column != column)
			barrier(CLK_LOCAL_MEM_FENCE);
		at = next;
		column = next_column;
	}
	for (int k = lane; k < TILE_BODIES; k += TILE_GROUP)
	{
		int resident = t->resident[row * TILE_BODIES + k];
		if (resident >= 0)
			*(__global float4*)&p->body[resident & ~TILE_PLAIN] = tile->motion[k];
	}
}

#define TILE_PASS_KERNEL(name, pass, specialize)                                                                      \
	__kernel __attribute__((reqd_work_group_size(TILE_GROUP, 1, 1))) void name(                                       \
	    POOL_ARGUMENTS Step step, __global const int* resident, __global const int* table, __global const int* order, \
	    __global float4* stream, int stride, int substeps, int passes, int q, int bound)                              \
	{                                                                                                                 \
		__local Tile tile;                                                                                            \
		__local int range[TILE_COLUMNS + 1];                                                                          \
		Pools pools = {POOL_NAMES step, 0};                                                                           \
		specialize(pools.step);                                                                                       \
		STEP_ALONE(pools.step);                                                                                       \
		Relay r = {0, substeps, passes, 0};                                                                           \
		Tiles t = {0, 0, resident, table, order, stream, stride, 0};                                                  \
		if (tile_wanted(&pools, bound))                                                                               \
			tile_work(&pools, &r, &t, &tile, range, q, pass);                                                         \
	}
#define TILE_PASS_KERNELS(end, specialize)                              \
	TILE_PASS_KERNEL(tile_warm_start##end, PASS_WARM_START, specialize) \
	TILE_PASS_KERNEL(tile_bias##end, PASS_BIAS, specialize)             \
	TILE_PASS_KERNEL(tile_relax##end, PASS_RELAX, specialize)           \
	TILE_PASS_KERNEL(tile_bounce##end, PASS_BOUNCE, specialize)
TILE_PASS_KERNELS(, STEP_CONTACTS)
TILE_PASS_KERNELS(_joints, STEP_JOINTS)

// Sends a body to its next border constraint in pass q; after its last border constraint, writes the body to its pool.
INLINE void tile_border_send(const Pools* p, const Relay* r, Side side, int q, Body b)
{
	relay_send_next(r, side, q, b);
	if (!side.moves || !side.last)
		return;
	*(__global float4*)&p->body[side.body] = make_float4(b.v.x, b.v.y, b.w, b.inv_mass);
	if (q + 1 == r->passes)
		mailbox_clear(r->mailboxes + MAILBOX_WORDS * (ulong)side.body);
}

// Executes pass q of a border constraint, with bodies from their pool or from their previous border constraints.
// Returns false if a ticket did not arrive.
INLINE_MEET bool tile_border_task(const Pools* p, const Relay* r, const Tiles* t, int j, int q,
                                  volatile LOCAL int* fault)
{
	Registers u = registers_load(p, t->order[j], t->stream, t->stride, j);
	int pass = schedule_pass(r->substeps, q);
	AnyReady ready;
	if (!u.inert)
	{
		Body* bodies[2] = {&u.a, &u.b};
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
		registers_ready(p, pass, &u, &ready);
		Side sa = u.side[0], sb = u.side[1];
		volatile __global ulong* mailbox_a = r->mailboxes + MAILBOX_WORDS * (ulong)sa.body;
		volatile __global ulong* mailbox_b = r->mailboxes + MAILBOX_WORDS * (ulong)sb.body;
		if (!relay_wait(p, r, sa.moves && sa.before > 0, mailbox_a, relay_ticket(q, sa.before), &u.a.v, &u.a.w,
		                sb.moves && sb.before > 0, mailbox_b, relay_ticket(q, sb.before), &u.b.v, &u.b.w))
			*fault = 1;
	}
	barrier(CLK_LOCAL_MEM_FENCE);
	if (*fault)
	{
		*(volatile __global int*)&p->counters->fault = FAULT_TIMEOUT;
		return false;
	}
	if (u.inert)
		return true;
	registers_pass(p, pass, &ready, &u);
	for (int k = 0; k < 2; ++k)
		tile_border_send(p, r, u.side[k], q, k ? u.b : u.a);
	if (q + 1 == r->passes)
		registers_store_kept(p, &u);
	else
		registers_update(&u, pass, t->stream, t->stride, j);
	return true;
}

INLINE_MEET void tile_border_work(const Pools* p, const Relay* r, const Tiles* t, int q, volatile LOCAL int* fault)
{
	if (get_local_id(0) == 0)
		*fault = 0;
	barrier(CLK_LOCAL_MEM_FENCE);
	int begin = t->table[t->rows * TILE_COLUMNS], end = t->table[(t->rows + 1) * TILE_COLUMNS];
	for (int j = begin + (int)get_global_id(0); j < end; j += (int)get_global_size(0))
		if (!tile_border_task(p, r, t, j, q, fault))
			return;
}

#define TILE_BORDER_KERNEL(name, specialize)                                                                      \
	__kernel void name(POOL_ARGUMENTS Step step, __global ulong* mailboxes, __global const int* table,            \
	                   __global const int* order, __global float4* stream, int stride, int rows, int substeps,    \
	                   int passes, int q, int bound, int spins)                                                   \
	{                                                                                                             \
		volatile __local int fault;                                                                               \
		Pools pools = {POOL_NAMES step, 0};                                                                       \
		Relay r = {mailboxes, substeps, passes, spins};                                                           \
		Tiles t = {0, 0, 0, table, order, stream, stride, rows};                                                  \
		specialize(pools.step);                                                                                   \
		STEP_ALONE(pools.step);                                                                                   \
		if (tile_wanted(&pools, bound))                                                                           \
			tile_border_work(&pools, &r, &t, q, &fault);                                                          \
	}
TILE_BORDER_KERNEL(tile_border, STEP_CONTACTS)
TILE_BORDER_KERNEL(tile_border_joints, STEP_JOINTS)
