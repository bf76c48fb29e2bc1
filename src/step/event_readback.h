// SPDX-License-Identifier: MIT
// event_readback.h -- the events of a step: their lists on the device, and the readback of these.
#ifndef EVENT_READBACK_H
#define EVENT_READBACK_H
#include "step/pipeline_state.h"

// Reserves space for the events of the next step, if some collidable reports any.
scree_status events_reserve(Pipeline* pipeline, const StepRequest* request);

// Lists the events of a step. Touches of contacts that it released are listed before the narrow phase.
scree_status events_list(Pipeline* pipeline, const Step* step);
scree_status events_count(Pipeline* pipeline, int counts[EVENT_LISTS]);

// Reads the contacts of all count events of a list, sorted by slot.
scree_status events_contacts(Pipeline* pipeline, int which, int count, ContactReport* rows);

// Reads the pairs of collidables of all count touches that ended, ascending; the first is in the upper half.
scree_status events_pairs(Pipeline* pipeline, int count, Word64* pairs);

#endif
