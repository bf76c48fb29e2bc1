// SPDX-License-Identifier: MIT
// contact_capacity.h -- the contact limit, and the error for a place with too many contacts.
#ifndef CONTACT_CAPACITY_H
#define CONTACT_CAPACITY_H
#include "step/pipeline_state.h"

// Returns the contact limit of the definition, or the default.
int contact_limit(const StepRequest* request);

// Fails with SCREE_ERROR_CONTACT_LIMIT and a sentence that names the place where most boxes overlap. It must be called
// directly after the search that found too many pairs, while its counters and boxes are in the pools.
scree_status contact_limit_fail(Pipeline* pipeline, const Step* step);

#endif
