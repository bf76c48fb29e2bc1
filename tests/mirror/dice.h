// SPDX-License-Identifier: MIT
// dice.h -- draws random numbers for hostile worlds and calls.
//
// C leaves the order of two operands or arguments open. So an expression has one random number that is not an argument of
// another, and a seed is the same run for every compiler.
#ifndef DICE_H
#define DICE_H
#include "scree/scree.h"
#include "scree/scree_math.h"
#include "tools/common/random_numbers.h"
#include <stdbool.h>

static inline bool one_in(uint64_t* dice, int count) { return random_below(dice, count) == 0; }

// Returns `rare` in one of `count` cases, else `usual`.
static inline float rarely(uint64_t* dice, int count, float rare, float usual)
{
	return one_in(dice, count) ? rare : usual;
}

static inline scree_vec random_vec(uint64_t* dice, float reach)
{
	float x = random_between(dice, -reach, reach);
	return (scree_vec){x, random_between(dice, -reach, reach)};
}

static inline scree_rot random_rot(uint64_t* dice) { return scree_rot_make(random_between(dice, -3.0f, 3.0f)); }

#endif
