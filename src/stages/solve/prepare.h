// SPDX-License-Identifier: MIT
// prepare.h -- computes the terms of the constraints for the passes, once per step.
#ifndef PREPARE_H
#define PREPARE_H
#include "constraints/constraint_kinds.h"
#include "constraints/contact_bounce.h"
#include "constraints/contact_prepare.h"
#include "constraints/joint_prepare.h"

#define CONSTRAINT_KIND(kind, Kind, KIND)                          \
	WIDE_KERNEL(kind##_prepare)                                    \
	{                                                              \
		Kind u;                                                    \
		kind##_setup(p, i, load_int(p->kind##_place_slot, i), &u); \
		kind##_store(p, i, PREPARE, &u);                           \
	}
#include "pools/kinds.def"
#undef CONSTRAINT_KIND

SMALL_BEGIN
#include "constraints/joint_rare.h"

// Computes the rare rows from the rows that the kernel above has written.
#define CONSTRAINT_KIND(kind, Kind, KIND)      \
	WIDE_KERNEL(kind##_prepare_rare)           \
	{                                          \
		Kind u;                                \
		kind##_load(p, i, PREPARE_BOUNCE, &u); \
		kind##_setup_rare(p, i, &u);           \
	}
#include "pools/kinds.def"
#undef CONSTRAINT_KIND
SMALL_END

#endif
