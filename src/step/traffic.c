// SPDX-License-Identifier: MIT
// traffic.c -- computes the number of bytes that the solve stage moves, from its algorithm.
//
// Bytes are counted as the passes request them (docs/measurements/performance.md), so the count does not depend on the device.
#include "step/traffic.h"
#include "constraints/constraint_kinds.h"
#include <stddef.h>

#define ROW_BYTES  sizeof(float)
#define ENDS_BYTES (2 * sizeof(int)) // indices of the two bodies of a constraint

// Bytes of parts of a row of the pool body. VELOCITY: a constraint writes it. DISPLACEMENT: solve_begin clears it.
#define VELOCITY     (offsetof(BodyState, dx))
#define DISPLACEMENT (offsetof(BodyState, inv_inertia) - offsetof(BodyState, dx))

typedef struct // bytes that one constraint moves in a step: of its own rows, and of rows of bodies
{
	size_t rows, bodies;
} Bytes;

// Adds the bytes of a row that a pass reads and writes, if the step uses the row (`gate`).
#define COUNT_ROW(name, gate, life, inert, read, written) \
	bytes += on.gate ? (((read) >> pass & 1) + ((written) >> pass & 1)) * ROW_BYTES : 0;
#define CONSTRAINT_KIND(kind, Kind, KIND)                                                  \
	static size_t kind##_pass_bytes(int pass, const Step* step)                            \
	{                                                                                      \
		const struct                                                                       \
		{                                                                                  \
			int always, rare, has_rolling, details, bounces, has_drives, couplings, paths; \
		} on = {1,                                                                         \
		        STEP_RARE(*step),                                                          \
		        step->has_rolling,                                                         \
		        step->details,                                                             \
		        step->bounces,                                                             \
		        step->has_drives,                                                          \
		        step->couplings,                                                           \
		        step->paths};                                                              \
		size_t bytes = pass == PREPARE ? 0 : ENDS_BYTES;                                   \
		KIND##_ROWS(COUNT_ROW) KIND##_RARE_ROWS(COUNT_ROW) return bytes;                   \
	}                                                                                      \
	static Bytes kind##_bytes(int substeps, const Step* step)                              \
	{                                                                                      \
		/* slot of the constraint, twice with rare rows; data that setup gathers */        \
		Bytes count = {(KIND##_RARE(step) ? 2 : 1) * sizeof(int), 0};                      \
		count.rows += KIND##_GATHERS(step);                                                \
		count.rows += kind##_pass_bytes(PREPARE, step);                                    \
		if (step->bounces)                                                                 \
		{                                                                                  \
			count.rows += kind##_pass_bytes(PREPARE_BOUNCE, step);                         \
			count.bodies += KIND##_BOUNCE_GATHERS;                                         \
		}                                                                                  \
		for (int q = 0; q < schedule_passes(substeps, step->bounces); ++q)                 \
		{                                                                                  \
			count.rows += kind##_pass_bytes(schedule_pass(substeps, q), step);             \
			count.bodies += 2 * (sizeof(BodyState) + VELOCITY);                            \
		}                                                                                  \
		return count;                                                                      \
	}
#include "pools/kinds.def"
#undef CONSTRAINT_KIND

static size_t body_bytes(int substeps, int bounces)
{
	const size_t before[] = {
	    [BODY_STAYS] = 0,
	    [BODY_ACCELERATES] = 2 * sizeof(BodyState) + sizeof(Motion) + 2 * sizeof(Float4),
	    [BODY_MOVES] = 2 * sizeof(BodyState) + sizeof(Motion),
	};
	size_t bytes = VELOCITY + sizeof(Float4) + DISPLACEMENT;
	for (int q = 0; q < schedule_passes(substeps, bounces); ++q)
		bytes += before[schedule_before(substeps, q)];
	return bytes;
}

static void count_kind(scree_traffic* traffic, const KindLayout* layout, Bytes bytes)
{
	int constraints = 0;
	for (int color = 0; color <= COLORS; ++color)
		constraints += layout->count[color];
	traffic->constraints += constraints;
	traffic->constraint_bytes += (uint64_t)constraints * bytes.rows;
	traffic->body_bytes += (uint64_t)constraints * bytes.bodies;
}

scree_traffic traffic_of_solve(const Counters* counters, int bodies, int substeps, const Step* step)
{
	scree_traffic traffic = {.passes = schedule_passes(substeps, step->bounces),
	                         .body_bytes = (uint64_t)bodies * body_bytes(substeps, step->bounces)};
#define CONSTRAINT_KIND(kind, Kind, KIND) \
	count_kind(&traffic, &counters->layout[CONSTRAINT_##KIND], kind##_bytes(substeps, step));
#include "pools/kinds.def"
#undef CONSTRAINT_KIND
	return traffic;
}
