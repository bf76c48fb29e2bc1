// SPDX-License-Identifier: MIT
// past.c -- keeps the past of a world as recordings, and returns the world to an earlier step.
#include "view/window/past.h"
#include "tools/common/clock.h"
#include "world/record/recorder.h"
#include "world/world.h"
#include <stdlib.h>
#include <string.h>

#define BUDGET     ((size_t)512 << 20) // bytes of all recordings; the oldest are dropped
#define BODY_BYTES 800                 // bytes of a body in a snapshot, about
#define OFTEN      30                  // minimum number of steps in a part
#define SHARE      8.0                 // minimum time of the steps of a part, divided by the time of its snapshot

static size_t part_bytes(const PastPart* part) { return part->recorder->written.capacity; }

static void free_part(PastPart* part, scree_world* world)
{
	if (!part->recorder->ended)
		recorder_end(world, part->recorder, "past", false);
	recorder_free(part->recorder);
}

static void end_replay(Past* past)
{
	scree_replay_close(past->replay);
	past->replay = NULL;
}

void past_close(Past* past, scree_world* world)
{
	end_replay(past);
	for (int k = 0; k < past->count; ++k)
		free_part(past->parts + k, world);
	free(past->parts);
	free(past->notes);
	*past = (Past){.off = true};
}

static bool set_note(Past* past, const void* note)
{
	int64_t place = past->at - past->first;
	if (place >= past->note_capacity)
	{
		int64_t capacity = 2 * place + 256;
		unsigned char* notes = realloc(past->notes, (size_t)capacity * past->note);
		if (!notes)
			return false;
		past->notes = notes;
		past->note_capacity = capacity;
	}
	memcpy(past->notes + (size_t)place * past->note, note, past->note);
	return true;
}

// Ends the recording of the last part.
static void stop(Past* past, scree_world* world)
{
	if (past->records)
		recorder_end(world, past->parts[past->count - 1].recorder, "past", false);
	past->records = false;
}

// Drops the oldest parts while all parts together exceed the budget.
static void forget(Past* past, scree_world* world)
{
	size_t all = 0;
	int dropped = 0;
	for (int k = 0; k < past->count; ++k)
		all += part_bytes(past->parts + k);
	for (; all > BUDGET && dropped < past->count - 1; ++dropped)
	{
		all -= part_bytes(past->parts + dropped);
		free_part(past->parts + dropped, world);
	}
	if (dropped == 0)
		return;
	past->count -= dropped;
	memmove(past->parts, past->parts + dropped, (size_t)past->count * sizeof *past->parts);
	int64_t steps = past->parts[0].first - past->first;
	past->first += steps;
	memmove(past->notes, past->notes + (size_t)steps * past->note, (size_t)(past->end - past->first + 1) * past->note);
}

// Begins a part at the current step. Returns false if memory is short.
static bool begin_part(Past* past, scree_world* world)
{
	if (past->count == past->capacity)
	{
		int capacity = 2 * past->count + 16;
		PastPart* parts = realloc(past->parts, (size_t)capacity * sizeof *parts);
		if (!parts)
			return false;
		past->parts = parts;
		past->capacity = capacity;
	}
	double begin = seconds_now();
	PastPart* part = past->parts + past->count;
	*part = (PastPart){.first = past->at, .last = past->at};
	if (recorder_open(world, "past", NULL, 0, &part->recorder) != SCREE_OK)
		return false;
	++past->count;
	past->records = true;
	past->spent = 0.0;
	past->cost = 1000.0 * (seconds_now() - begin);
	forget(past, world);
	return true;
}

void past_begin(Past* past, scree_world* world, const void* note, size_t bytes)
{
	scree_counters counters;
	*past = (Past){.note = bytes};
	if (scree_world_get_counters(world, &counters) != SCREE_OK || (size_t)counters.bodies * BODY_BYTES > BUDGET / 2 ||
	    !set_note(past, note) || !begin_part(past, world))
		past_close(past, world);
}

void past_add(Past* past, scree_world* world, const void* note, double time)
{
	if (past->off)
		return;
	PastPart* part = past->parts + past->count - 1;
	past->end = ++past->at;
	bool taken = part->recorder->steps == past->at - part->first; // false: a replay counts a step that failed
	part->last += taken;
	past->spent += time;
	bool good = set_note(past, note) && part->recorder->status == SCREE_OK;
	if (good && (!taken || (past->at - part->first >= OFTEN && past->spent >= SHARE * past->cost)))
	{
		stop(past, world);
		good = begin_part(past, world);
	}
	if (!good)
		past_close(past, world);
}

// Opens the part from which a step is computed, and restores its snapshot.
static scree_status restore(Past* past, scree_world* world, int64_t step)
{
	int k = past->count - 1;
	while (past->parts[k].first > step)
		--k;
	end_replay(past);
	const ChunkWriter* written = &past->parts[k].recorder->written;
	scree_status status = scree_replay_open(written->bytes, written->used, &past->replay);
	if (status == SCREE_OK)
		status = scree_replay_restore(past->replay, world);
	past->repeated = k;
	past->at = past->parts[k].first;
	bool stepped;
	if (status == SCREE_OK && past->at == past->end)
		status = scree_replay_step(past->replay, world, &stepped); // calls after the last step
	return status;
}

static scree_status go(Past* past, scree_world* world, int64_t step, const void* now)
{
	bool stepped;
	if (past->records && !set_note(past, now)) // the tools may have changed since the step
		return SCREE_ERROR_OUT_OF_MEMORY;
	stop(past, world);
	bool later = past->replay && step > past->at && past->at < past->parts[past->repeated].last &&
	             (past->repeated == past->count - 1 || past->parts[past->repeated + 1].first > step);
	if (!later)
		return restore(past, world, step);
	scree_status status = scree_replay_step(past->replay, world, &stepped);
	++past->at;
	if (status == SCREE_OK && past->at == past->end)
		status = scree_replay_step(past->replay, world, &stepped);
	return status;
}

scree_status past_go(Past* past, scree_world* world, int64_t step, const void* now, const void** note)
{
	scree_status status = go(past, world, step, now);
	if (status == SCREE_OK)
		*note = past->notes + (size_t)(past->at - past->first) * past->note;
	else
		past_close(past, world);
	return status;
}

bool past_cut(Past* past, scree_world* world)
{
	if (past->off || past->records)
		return false;
	end_replay(past);
	while (past->count > 0 && past->parts[past->count - 1].first >= past->at)
		free_part(past->parts + --past->count, world);
	if (past->count > 0)
		past->parts[past->count - 1].last = past->at;
	past->end = past->at;
	if (!begin_part(past, world))
		past_close(past, world);
	return true;
}
