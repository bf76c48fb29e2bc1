// SPDX-License-Identifier: MIT
// event_readback.h -- lists the events of a step on the device, and reads the lists back.
#ifndef EVENT_READBACK_H
#define EVENT_READBACK_H
#include "step/pipeline_state.h"

// Reserves memory for the lists of events of the next step, if they are in use, and uploads approved pairs.
scree_status events_reserve(Pipeline* pipeline, const StepRequest* request);

// Lists the events of a step. Touches that ended with their contact were already listed by the narrow phase.
scree_status events_list(Pipeline* pipeline, const Step* step);
scree_status events_count(Pipeline* pipeline, int counts[EVENT_LISTS]);

// Reads the contacts of all `count` events in list `which` (EVENT_*), sorted by the slot of the contact.
scree_status events_contacts(Pipeline* pipeline, int which, int count, ContactReport* rows);

// Reads the pairs of all `count` touches that ended, in ascending order. The upper half of a pair is its first
// collidable.
scree_status events_pairs(Pipeline* pipeline, int count, Word64* pairs);

#endif
