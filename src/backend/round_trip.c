// SPDX-License-Identifier: MIT
// round_trip.c -- executes a round trip in one part: uploads the items, runs the kernel, checks the items, and reads the results.
#include "backend/round_trip.h"
#include "platform/error.h"

scree_status round_trip_whole(Backend* b, const Step* step, const RoundTrip* trip)
{
	int count = trip->run.end;
	TRY(b->f->write(b, trip->asked, 0, count, trip->items));
	TRY(b->f->run(b, step, &trip->run, 1));
	if (trip->check)
		TRY(trip->check(trip->context, 0, count));
	return b->f->read(b, trip->answered, 0, count, trip->answers);
}
