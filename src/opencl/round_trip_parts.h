// SPDX-License-Identifier: MIT
// round_trip_parts.h -- executes a round trip on a GPU in parts that overlap.
#ifndef ROUND_TRIP_PARTS_H
#define ROUND_TRIP_PARTS_H
#include "opencl/opencl_state.h"

scree_status opencl_round_trip(Backend* b, const Step* step, const RoundTrip* trip);
void round_trip_close(OpenCl* d);

#endif
