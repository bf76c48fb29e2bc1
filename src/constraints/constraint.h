// SPDX-License-Identifier: MIT
// constraint.h -- declares macros that generate the code for the rows of a kind of constraint from a list of its rows.
// A kind lists its rows as X(name, gate, life, inert, read, written), and has two more rows, body_a and body_b.
//
//     gate           flag of Step without which the row is not used; always: in every step
//     life           PLACED: valid as long as the layout; PREPARED: within a step; KEPT: from step to step, an impulse
//     inert          value of the row where there is no constraint
//     read, written  IN_* bits of the passes that read and write it
#ifndef CONSTRAINT_H
#define CONSTRAINT_H
#include "constraints/schedule.h"
#include "pools/pools.h"

#define IN_NONE       0
#define IN_WARM_START (1 << PASS_WARM_START)
#define IN_BIAS       (1 << PASS_BIAS)
#define IN_RELAX      (1 << PASS_RELAX)
#define IN_BOUNCE     (1 << PASS_BOUNCE)
#define IN_PASSES     ((1 << PASS_KINDS) - 1)

// Preparations of rows, numbered after the passes.
#define PREPARE           PASS_KINDS
#define PREPARE_BOUNCE    (PASS_KINDS + 1) // prepared only in a world with restitution
#define IN_PREPARE        (1 << PREPARE)
#define IN_PREPARE_BOUNCE (1 << PREPARE_BOUNCE)

#define ROW_IF_KEPT_PLACED(x)
#define ROW_IF_KEPT_PREPARED(x)
#define ROW_IF_KEPT_KEPT(x) x

// Members for a block of MAX_LANES constraints.
#define CONSTRAINT_ENDS                                    int body_a[MAX_LANES], body_b[MAX_LANES];
#define ROW_MEMBER(name, gate, life, inert, read, written) float name[MAX_LANES];
// Members for a constraint in registers, or for LANES constraints.
#define ROW_REGISTER(name, gate, life, inert, read, written) Real name;
// Members for the values of one constraint that outlive the layout.
#define ROW_KEPT_MEMBER(name, gate, life, inert, read, written) ROW_IF_KEPT_##life(float name;)

#define KEPT_ALIGNED __attribute__((aligned(16))) // kept rows are copied whole, 16 bytes at a time

// The macros below process constraint `lane` of the block `rows`, and registers `u` or kept values `kept`.
#define ROW_PAD(name, gate, life, inert, read, written) rows->name[lane] = inert;
#define ROW_LOAD(name, gate, life, inert, read, written) \
	if ((read) >> pass & 1)                              \
		u->name = load(&rows->name[lane], 0);
#define ROW_STORE(name, gate, life, inert, read, written) \
	if ((written) >> pass & 1)                            \
		store(&rows->name[lane], 0, u->name);
#define ROW_LOAD_ALL(name, gate, life, inert, read, written) \
	ROW_UNLESS_PREPARED_##life(if (IN_PASSES & (read)) u->name = load(&rows->name[lane], 0);)
#define ROW_STORE_KEPT(name, gate, life, inert, read, written) \
	ROW_IF_KEPT_##life(if (IN_PASSES & (written)) store(&rows->name[lane], 0, u->name);)
#define ROW_KEEP(name, gate, life, inert, read, written)     ROW_IF_KEPT_##life(kept.name = rows->name[lane];)
#define ROW_PUT_BACK(name, gate, life, inert, read, written) ROW_IF_KEPT_##life(rows->name[lane] = kept.name;)
#define ROW_FETCH(name, gate, life, inert, read, written)    ROW_IF_KEPT_##life(fetch_soon(&rows->name[lane]);)
#define ROW_HASH(name, gate, life, inert, read, written)     ROW_IF_KEPT_##life(h = hash_float(h, rows->name[lane]);)

#define ROW_HASH_SLOT(name, gate, life, inert, read, written) ROW_IF_KEPT_##life(h = hash_float(h, kept->name);)

#define ROW_UNLESS_PREPARED_PLACED(x) x
#define ROW_UNLESS_PREPARED_PREPARED(x)
#define ROW_UNLESS_PREPARED_KEPT(x) x

// Raises a counter, the bits of a float, to the largest value of the lanes in the mask `lanes`. No value is negative.
INLINE void raise_lanes(GLOBAL int* counter, Real value, Word lanes)
{
	for (int k = 0; lanes >> k != 0; ++k)
		if (lanes >> k & 1)
			atomic_max_int(counter, float_bits(lane(value, k)));
}

#endif
