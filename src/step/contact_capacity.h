// SPDX-License-Identifier: MIT
// contact_capacity.h -- computes the contact limit, and the error message of a step that exceeds it.
#ifndef CONTACT_CAPACITY_H
#define CONTACT_CAPACITY_H
#include "step/pipeline_state.h"

int contact_limit(const StepRequest* request);

// Fails with SCREE_ERROR_CONTACT_LIMIT, or with a failure of the device. The message names the most crowded place.
scree_status contact_limit_fail(Pipeline* pipeline, const Step* step);

#endif
