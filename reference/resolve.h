// SPDX-License-Identifier: MIT
// resolve.h -- the fourth stage, on the host: resolves one contact after the other, always the most severe.
#ifndef REFERENCE_RESOLVE_H
#define REFERENCE_RESOLVE_H
#include "reference/state.h"

// Sorts the contacts of the host and resolves them.
scree_status paper_resolve(Paper* paper);

#endif
