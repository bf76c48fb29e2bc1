// SPDX-License-Identifier: MIT
// traffic.c -- the bytes that the solve stage moves, counted by its algorithm.
//
// What counts is what a pass of src/stages/solve.h asks for, whoever serves it: a component of a constraint once for being
// read and once for being written, each body of a constraint once a pass for both, a row of a body once in each pass over
// bodies. So it depends neither on the device nor on the size of its caches. Padding, counters and the sorting and summing
// of spokes are left out. A body that cannot move counts as written, which it is not.
#include "step/traffic.h"
#include "stages/schedule.h"
#include <stddef.h>

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

scree_traffic traffic_of_solve(const Counters* layout, int bodies, int substeps, const Step* step)
{
	size_t pass[PASS_KINDS] = {
	    [PASS_WARM_START] = ENDS + ARMS + 2 * NORMALS + TANGENTS,
	    [PASS_BIAS] = ENDS + ARMS + GAPS + 2 * NORMALS,
	    [PASS_RELAX] = ENDS + ARMS + GAPS + ROW(friction) + 2 * NORMALS + 2 * TANGENTS,
	    [PASS_BOUNCE] = ENDS + ARMS + GAPS + EXTRA(fall) + REBOUNDS + 2 * TOTALS + 2 * NORMALS,
	};
	// slot, collidables; what it finds
	size_t prepare = sizeof(int) + sizeof(Int2) + 2 * sizeof(Placed) + sizeof(Found) + ARMS + GAPS;
	size_t prepare_bodies = 0;
	if (step->round)
		prepare += sizeof(Word); // its flags say what is round
	if (step->extras)
	{
		pass[PASS_WARM_START] += EXTRA(rolling_impulse);
		pass[PASS_RELAX] += EXTRA(tangent_speed) + EXTRA(rolling) + 2 * EXTRA(rolling_impulse) + 2 * TOTALS;
		prepare += sizeof(int) + TOTALS; // slot again: prepare_extra
	}
	if (step->bounces)
	{
		pass[PASS_BIAS] += REBOUNDS;
		pass[PASS_RELAX] += REBOUNDS;
		prepare += ARMS + GAPS + ENDS + EXTRA(restitution) + EXTRA(fall) + REBOUNDS;
		prepare_bodies = 2 * (sizeof(BodyState) + sizeof(Motion) + sizeof(Word64));
	}
	const size_t before[] = {
	    [BODY_STAYS] = 0,
	    [BODY_ACCELERATES] = 2 * sizeof(BodyState) + sizeof(Motion) + 2 * sizeof(Float4),
	    [BODY_MOVES] = 2 * sizeof(BodyState) + sizeof(Motion),
	};

	// a constraint; its bodies, of which a pass reads the row and writes the velocity; a body
	size_t rows = prepare, ends = prepare_bodies, a_body = VELOCITY + sizeof(Float4) + DISPLACEMENT;
	int passes = schedule_passes(substeps, step->bounces), constraints = 0;
	for (int q = 0; q < passes; ++q)
	{
		rows += pass[schedule_pass(substeps, q)];
		ends += 2 * (sizeof(BodyState) + VELOCITY);
		a_body += before[schedule_before(substeps, q)];
	}
	for (int color = 0; color <= COLORS; ++color)
		constraints += layout->color_count[color];
	return (scree_traffic){
	    .constraints = constraints,
	    .passes = passes,
	    .constraint_bytes = (uint64_t)constraints * rows,
	    .body_bytes = (uint64_t)constraints * ends + (uint64_t)bodies * a_body,
	};
}
