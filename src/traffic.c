// SPDX-License-Identifier: MIT
// traffic.c -- the bytes that the solve stage moves, counted by its algorithm, and how fast its device copies.
//
// What counts is what a pass of src/stages/solve.h asks for, whoever serves it: a component of a constraint once for being
// read and once for being written, each body of a constraint once a pass for both, a row of a body once in each pass over
// bodies. So it depends neither on the device nor on the size of its caches. Padding, counters and the sorting and summing
// of spokes are left out. A body that cannot move counts as written, which it is not.
#include "traffic.h"
#include "cpu/processor.h"
#include "definition.h"
#include "world.h"

// bytes of one constraint in a row of its block
#define ROW(name)   (sizeof(((Constraints*)NULL)->name[0]))
#define EXTRA(name) (sizeof(((Extras*)NULL)->name[0]))

// what passes read, and some write, of a constraint
#define ENDS     (ROW(body_a) + ROW(body_b))
#define ANCHORS  (ROW(offset_x) + ROW(offset_y) + ROW(anchor1_x) + ROW(anchor1_y) + ROW(anchor2_x) + ROW(anchor2_y))
#define ARMS     (ROW(normal_x) + ROW(normal_y) + ANCHORS)
#define GAPS     (ROW(separation1) + ROW(separation2))
#define NORMALS  (ROW(normal_impulse1) + ROW(normal_impulse2))
#define TANGENTS (ROW(tangent_impulse1) + ROW(tangent_impulse2))
#define REBOUNDS (EXTRA(rebound1) + EXTRA(rebound2))
#define TOTALS   (EXTRA(total_impulse1) + EXTRA(total_impulse2))

// of a row of the pool body what a constraint, or the start of a step, writes
#define VELOCITY     (offsetof(BodyState, dx))
#define DISPLACEMENT (offsetof(BodyState, inv_inertia) - offsetof(BodyState, dx))

// Of two blocks to copy between; a device with less room takes the half, down to the least.
#define MOST_BYTES  ((size_t)256 << 20)
#define LEAST_BYTES ((size_t)1 << 20)
// The best of so many tries counts, each of so many copies, so that what starts and ends them weighs little; fewer tries on
// a device that is so slow that they would take longer than this, in ms.
#define TRIES  4
#define COPIES 8
#define ENOUGH 500.0

scree_traffic traffic_of_solve(int constraints, int bodies, int substeps, bool extras, bool bounces, bool round)
{
	size_t warm_start = ENDS + ARMS + 2 * NORMALS + TANGENTS;
	size_t bias = ENDS + ARMS + GAPS + 2 * NORMALS;
	size_t relax = ENDS + ARMS + GAPS + ROW(friction) + 2 * NORMALS + 2 * TANGENTS;
	size_t bounce = ENDS + ARMS + GAPS + EXTRA(fall) + REBOUNDS + 2 * TOTALS + 2 * NORMALS;
	size_t prepare = sizeof(int) + sizeof(Int2) + 2 * sizeof(Placed) + sizeof(Found) + ARMS +
	                 GAPS; // slot, collidables; what it finds
	size_t prepare_bodies = 0;
	if (round)
		prepare += sizeof(Word); // its flags say what is round
	if (extras)
	{
		warm_start += EXTRA(rolling_impulse);
		relax += EXTRA(tangent_speed) + EXTRA(rolling) + 2 * EXTRA(rolling_impulse) + 2 * TOTALS;
		prepare += sizeof(int) + TOTALS; // slot again: prepare_extra
	}
	if (bounces)
	{
		bias += REBOUNDS;
		relax += REBOUNDS;
		prepare += ARMS + GAPS + ENDS + EXTRA(restitution) + EXTRA(fall) + REBOUNDS;
		prepare_bodies = 2 * (sizeof(BodyState) + sizeof(Motion) + sizeof(Word64));
	}

	// of both bodies the row is read and the velocity written
	size_t pass = 2 * (sizeof(BodyState) + VELOCITY);
	size_t passes = 1 + 2 * (size_t)substeps + (bounces ? 1 : 0);
	size_t solve_begin = VELOCITY + sizeof(Float4) + DISPLACEMENT;
	size_t integrate_velocity = 2 * sizeof(BodyState) + sizeof(Motion) + 2 * sizeof(Float4);
	size_t integrate_position = 2 * sizeof(BodyState) + sizeof(Motion);

	size_t a_constraint = prepare + warm_start + (size_t)substeps * (bias + relax) + (bounces ? bounce : 0);
	size_t its_bodies = prepare_bodies + passes * pass;
	size_t a_body = solve_begin + (size_t)substeps * (integrate_velocity + integrate_position);
	return (scree_traffic){
	    .constraints = constraints,
	    .passes = (int)passes,
	    .constraint_bytes = (uint64_t)constraints * a_constraint,
	    .body_bytes = (uint64_t)constraints * its_bodies + (uint64_t)bodies * a_body,
	};
}

scree_status scree_world_get_traffic_sized(scree_world* world, scree_traffic* traffic, size_t size)
{
	const char* function = "scree_world_get_traffic";
	TRY(world_check(world, function));
	TRY(check_pointer(function, "traffic", traffic));
	write_result(traffic, size, &world->pipeline.traffic, sizeof world->pipeline.traffic);
	return SCREE_OK;
}

static scree_status time_copies(Backend* b, size_t bytes, double* bandwidth)
{
	TRY(b->f->copy(b, 1));
	double spent = 0;
	for (int k = 0; k < TRIES && spent < ENOUGH; ++k)
	{
		double begin = processor_milliseconds();
		TRY(b->f->copy(b, COPIES));
		double time = processor_milliseconds() - begin;
		double found = time > 0 ? 1e3 * 2.0 * COPIES * (double)bytes / time : 0;
		*bandwidth = found > *bandwidth ? found : *bandwidth;
		spent += time;
	}
	return SCREE_OK;
}

scree_status scree_world_measure_bandwidth(scree_world* world, double* bandwidth)
{
	const char* function = "scree_world_measure_bandwidth";
	TRY(world_check(world, function));
	TRY(check_pointer(function, "bandwidth", bandwidth));
	Backend* b = world->backend;
	size_t bytes = MOST_BYTES;
	scree_status status = b->f->copy_reserve(b, bytes);
	while (status == SCREE_ERROR_OUT_OF_MEMORY && bytes > LEAST_BYTES)
	{
		bytes /= 2;
		status = b->f->copy_reserve(b, bytes);
	}
	double found = 0;
	if (status == SCREE_OK)
		status = time_copies(b, bytes, &found);
	b->f->copy_release(b);
	if (status == SCREE_OK)
		*bandwidth = found;
	return world_note(world, status);
}
