// SPDX-License-Identifier: MIT
// contact_capacity.h -- computes the contact limit, and reports the error for a place with too many contacts.
#ifndef CONTACT_CAPACITY_H
#define CONTACT_CAPACITY_H
#include "step/pipeline_state.h"

int contact_limit(const StepRequest* request);

// Fails with SCREE_ERROR_CONTACT_LIMIT. The message names the most crowded place in the last search for pairs.
scree_status contact_limit_fail(Pipeline* pipeline, const Step* step);

#endif
