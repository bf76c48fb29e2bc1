// SPDX-License-Identifier: MIT
// round_trip.h -- executes a round trip in one part: uploads the items, runs the kernel, checks the items, and reads the results.
#ifndef ROUND_TRIP_H
#define ROUND_TRIP_H
#include "backend/backend.h"

scree_status round_trip_whole(Backend* b, const Step* step, const RoundTrip* trip);

#endif
