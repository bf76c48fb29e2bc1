// SPDX-License-Identifier: MIT
// bad_input.h -- makes a world for calls with bad arguments, and checks that they are refused.
#ifndef BAD_INPUT_H
#define BAD_INPUT_H
#include "support/make_bodies.h"

// `world` has a static crate, `fixed`, with two dynamic crates above it; `other` is another world. Handles are valid in
// `world`, except for `foreign`, which belongs to `other`, and for stale handles.
extern scree_world *world, *other;
extern scree_attribute crate, foreign;
extern scree_body body, second, fixed, stale;
extern scree_collidable part, zone, stale_part;
extern uint64_t before; // hash of the world

static const scree_pose good_pose = {{1, 2}, {0, 1}};

int set_up_bad_input(void** state);
int tear_down_bad_input(void** state);

// Checks that a call returned the expected status, that its message contains both texts, `function` and `part_of`, and
// that `world` is unchanged.
void assert_refused(scree_status status, scree_status expected, const char* function, const char* part_of);

// REFUSED checks the call function(arguments).
#define REFUSED(function, arguments, status, sentence) \
	assert_refused(function arguments, status, #function ": ", sentence)
#define INVALID(function, arguments, sentence) REFUSED(function, arguments, SCREE_ERROR_INVALID, sentence)
#define STALE(function, arguments, sentence)   REFUSED(function, arguments, SCREE_ERROR_STALE, sentence)

#endif
