// SPDX-License-Identifier: MIT
// change_call.c -- copies a recording with a call that has other arguments, so that its replay differs.
#include "support/change_call.h"
#include "support/edit_recordings.h"

typedef struct
{
	const char* call;
	int step;
	size_t at;
} CallChange;

static void flip_bit(int k, const LogRecord* record, uint8_t* bytes, const void* context)
{
	static int steps; // steps before this record
	const CallChange* change = context;
	steps = k == 0 ? 0 : steps;
	if (record->number < RECORD_CALLS)
		return;
	uint64_t call = record->number - RECORD_CALLS;
	if (strcmp(recorded_calls[call].name, change->call) == 0 && steps + 1 == change->step)
		bytes[change->at] ^= 1;
	steps += call == RECORDED_world_step;
}

Saved change_call(Saved saved, const char* call, int step, size_t at)
{
	return edit_recording(saved, flip_bit, &(CallChange){call, step, at});
}
