// SPDX-License-Identifier: MIT
// crowd.h -- how many contacts a world may have, and where there are too many.
#ifndef CROWD_H
#define CROWD_H
#include "step/state.h"

// The most contacts that the world may have: its definition's, or the default.
int contact_limit(const StepRequest* request);

// Fails with SCREE_ERROR_CROWDED and a sentence that names the place that most boxes share. The counters and the boxes of the
// search that found too many pairs are still there.
scree_status crowd_fail(Pipeline* pipeline, const Step* step);

#endif
