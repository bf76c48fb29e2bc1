// SPDX-License-Identifier: MIT
// traffic.c -- the bytes that the solve stage moves, counted by its algorithm.
//
// What counts is what a pass of src/stages/solve.h asks for, whoever serves it: a component of a constraint once for being
// read and once for being written, each body of a constraint once a pass for both, a row of a body once in each pass over
// bodies. So it depends neither on the device nor on the size of its caches. Padding, counters and the sorting and summing
// of spokes are left out. A body that cannot move counts as written, which it is not.
#include "step/traffic.h"
#include "constraints/kinds.h"
#include <stddef.h>

// bytes of a row of one constraint, and of its two bodies' names
#define ROW_BYTES  sizeof(float)
#define ENDS_BYTES (2 * sizeof(int))

// of a row of the pool body what a constraint, or the start of a step, writes
#define VELOCITY     (offsetof(BodyState, dx))
#define DISPLACEMENT (offsetof(BodyState, inv_inertia) - offsetof(BodyState, dx))

typedef struct // gates of rows
{
	int always, extras, bounces;
} Switches;

typedef struct
{
	size_t bytes[PREPARE_BOUNCE + 1]; // of each pass, and of what comes before them
} PassBytes;

// What the passes of a kind read and write of its rows.
#define COUNT_ROW(name, gate, life, inert, read, written) \
	count.bytes[pass] += step->gate ? (((read) >> pass & 1) + ((written) >> pass & 1)) * ROW_BYTES : 0;
#define CONSTRAINT_KIND(kind, Kind, KIND)                          \
	static PassBytes kind##_bytes(const Switches* step)            \
	{                                                              \
		PassBytes count = {{0}};                                   \
		for (int pass = 0; pass <= PREPARE_BOUNCE; ++pass)         \
		{                                                          \
			count.bytes[pass] += pass == PREPARE ? 0 : ENDS_BYTES; \
			KIND##_ROWS(COUNT_ROW) KIND##_RARE_ROWS(COUNT_ROW)     \
		}                                                          \
		return count;                                              \
	}
#include "pools/kinds.def"
#undef CONSTRAINT_KIND

scree_traffic traffic_of_solve(const Counters* layout, int bodies, int substeps, const Step* step)
{
	Switches on = {.always = 1, .extras = step->extras, .bounces = step->bounces};
	PassBytes contact = contact_bytes(&on);

	// slot, collidables; what is found there; its flags say what is round; slot again for rare rows
	size_t rows = sizeof(int) + sizeof(Int2) + 2 * sizeof(Placed) + sizeof(Found) + contact.bytes[PREPARE];
	size_t ends = 0;
	if (step->round)
		rows += sizeof(Word);
	if (step->extras)
		rows += sizeof(int);
	if (step->bounces)
	{
		rows += contact.bytes[PREPARE_BOUNCE];
		ends += 2 * (sizeof(BodyState) + sizeof(Motion) + sizeof(Word64));
	}
	const size_t before[] = {
	    [BODY_STAYS] = 0,
	    [BODY_ACCELERATES] = 2 * sizeof(BodyState) + sizeof(Motion) + 2 * sizeof(Float4),
	    [BODY_MOVES] = 2 * sizeof(BodyState) + sizeof(Motion),
	};

	// a constraint; its bodies, of which a pass reads the row and writes the velocity; a body
	size_t a_body = VELOCITY + sizeof(Float4) + DISPLACEMENT;
	int passes = schedule_passes(substeps, step->bounces), constraints = 0;
	for (int q = 0; q < passes; ++q)
	{
		rows += contact.bytes[schedule_pass(substeps, q)];
		ends += 2 * (sizeof(BodyState) + VELOCITY);
		a_body += before[schedule_before(substeps, q)];
	}
	for (int color = 0; color <= COLORS; ++color)
		constraints += layout->layout[CONSTRAINT_CONTACT].count[color];
	return (scree_traffic){
	    .constraints = constraints,
	    .passes = passes,
	    .constraint_bytes = (uint64_t)constraints * rows,
	    .body_bytes = (uint64_t)constraints * ends + (uint64_t)bodies * a_body,
	};
}
