// SPDX-License-Identifier: MIT
// solve_pass.h -- runs one pass of soft sequential impulses over the constraints of one color and kind.
#ifndef SOLVE_PASS_H
#define SOLVE_PASS_H
#include "constraints/constraint_kinds.h"

#define SOLVE_PASS(kind, Kind, name, which)                  \
	WIDE_KERNEL(kind##_##name)                               \
	{                                                        \
		Int ia = load_int(&kind##_row(p, body_a, i), 0);     \
		Int ib = load_int(&kind##_row(p, body_b, i), 0);     \
		Body a = body_gather(p, ia), b = body_gather(p, ib); \
		Kind u;                                              \
		kind##_load(p, i, which, &u);                        \
		kind##_pass(p, which, i, 0, &u, &a, &b);             \
		kind##_store(p, i, which, &u);                       \
		body_scatter(p, ia, a);                              \
		body_scatter(p, ib, b);                              \
	}
#define CONSTRAINT_KIND(kind, Kind, KIND)               \
	SOLVE_PASS(kind, Kind, warm_start, PASS_WARM_START) \
	SOLVE_PASS(kind, Kind, bias, PASS_BIAS)             \
	SOLVE_PASS(kind, Kind, relax, PASS_RELAX)           \
	SOLVE_PASS(kind, Kind, bounce, PASS_BOUNCE)
#include "pools/kinds.def"
#undef CONSTRAINT_KIND

#endif
