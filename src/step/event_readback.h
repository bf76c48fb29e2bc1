// SPDX-License-Identifier: MIT
// event_readback.h -- the events of a step: what the device lists of them, and reading that.
#ifndef EVENT_READBACK_H
#define EVENT_READBACK_H
#include "step/pipeline_state.h"

// Makes room for the events of the next step, if some collidable reports any.
scree_status events_reserve(Pipeline* pipeline, const StepRequest* request);

// Lists what happened in a step. Touches of contacts that were released in it are listed before the narrow phase.
scree_status events_list(Pipeline* pipeline, const Step* step);

// Reads the numbers of the events of the last step.
scree_status events_count(Pipeline* pipeline, int counts[EVENT_LISTS]);

// Reads the contacts of all count events of a list, in ascending slots.
scree_status events_contacts(Pipeline* pipeline, int which, int count, ContactReport* rows);

// Reads the pairs of collidables of all count touches that ended, in ascending order; the first one is in the upper half.
scree_status events_pairs(Pipeline* pipeline, int count, Word64* pairs);

#endif
