// SPDX-License-Identifier: MIT
// recorder.c -- records the calls that change a world, in memory or into a file.
#include "world/record/recorder.h"
#include "platform/error.h"
#include "platform/processor.h"
#include "world/record/call_codec.h"
#include "world/recovery/recovery.h"
#include "world/snapshot/snapshot.h"
#include <errno.h>
#include <stdarg.h>
#include <string.h>

#define KEPT_BYTES ((size_t)1 << 20) // larger memory of one record is released after the record

// ---------------------------------------------------------------------------------------------------------------
// records
// ---------------------------------------------------------------------------------------------------------------

// Stops a recorder after its first failure.
static scree_status FORMAT(3, 4) recorder_fail(Recorder* r, scree_status status, const char* format, ...)
{
	va_list list;
	va_start(list, format);
	vsnprintf(r->sentence, sizeof r->sentence, format, list);
	va_end(list);
	r->status = status;
	if (r->begun)
		log_sentence(SCREE_LOG_WARNING, "%s", r->sentence);
	return status;
}

static scree_status no_memory(Recorder* r)
{
	return recorder_fail(r, SCREE_ERROR_OUT_OF_MEMORY,
	                     "scree_world_record: no memory for the recording after %lld steps", (long long)r->steps);
}

// Writes the records in memory to the file of a recorder.
static scree_status flush(Recorder* r)
{
	if (!r->file || r->status != SCREE_OK)
		return r->status;
	size_t size = r->written.used;
	r->written.used = 0;
	if (fwrite(r->written.bytes, 1, size, r->file) == size && fflush(r->file) == 0)
		return SCREE_OK;
	return recorder_fail(r, SCREE_ERROR_FILE, "scree_world_record: %s cannot be written: %s; it ends after %lld steps",
	                     r->path, strerror(errno), (long long)r->steps);
}

// Appends the payload as a record. Without memory the recording ends with the record before.
static scree_status add(Recorder* r, uint64_t number)
{
	size_t used = r->written.used;
	uint64_t chain = r->chain;
	if (r->payload.used == SIZE_MAX)
		return no_memory(r);
	log_add(&r->written, &r->chain, number, r->payload.bytes, r->payload.used);
	if (r->payload.capacity > KEPT_BYTES)
	{
		scree_release(r->payload.bytes);
		r->payload = (ChunkWriter){0};
	}
	if (r->written.used != SIZE_MAX)
		return r->file && r->written.used > KEPT_BYTES ? flush(r) : SCREE_OK;
	r->written.used = used;
	r->chain = chain;
	return no_memory(r);
}

static scree_status add_empty(Recorder* r, uint64_t number)
{
	r->payload.used = 0;
	return add(r, number);
}

static scree_status add_hash(scree_world* world, Recorder* r)
{
	uint64_t hash;
	TRY(scree_world_get_hash(world, &hash));
	r->payload.used = 0;
	bytes_write(&r->payload, &hash, sizeof hash);
	return add(r, RECORD_HASH);
}

// Adds a snapshot. Without memory the recorder fails; another failure is that of the device.
static scree_status add_snapshot(scree_world* world, Recorder* r)
{
	scree_status status;
	do
		status = snapshot_write(world, "scree_world_record", &r->payload);
	while (world_recovers(world, "scree_world_record", status));
	if (status == SCREE_ERROR_OUT_OF_MEMORY)
		return no_memory(r);
	return status == SCREE_OK ? add(r, RECORD_SNAPSHOT) : recorder_fail(r, status, "%s", scree_error());
}

static scree_status begin(scree_world* world, Recorder* r)
{
	r->written.used = r->payload.used = 0;
	r->steps = 0;
	r->saves = 0;
	log_begin(&r->written, &r->chain);
	lists_write(&r->payload);
	TRY(add(r, RECORD_LISTS));
	TRY(add_snapshot(world, r));
	return flush(r);
}

// ---------------------------------------------------------------------------------------------------------------
// recorders of a world
// ---------------------------------------------------------------------------------------------------------------

static scree_status open_file(const char* function, Recorder* r, const char* path)
{
	size_t size = strlen(path) + 1;
	r->path = scree_allocate(size);
	if (!r->path)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for a path of %zu bytes", function, size);
	memcpy(r->path, path, size);
	r->file = fopen(path, "wb");
	if (!r->file)
		return fail(SCREE_ERROR_FILE, "%s: def.path is \"%s\", which cannot be opened: %s", function, path,
		            strerror(errno));
	return SCREE_OK;
}

scree_status recorder_open(scree_world* world, const char* function, const char* path, int hash_interval,
                           Recorder** made)
{
	Recorder* r = scree_allocate(sizeof *r);
	*made = NULL;
	if (!r)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for a recording", function);
	r->hash_interval = hash_interval;
	scree_status status = path ? open_file(function, r, path) : SCREE_OK;
	if (status == SCREE_OK && begin(world, r) != SCREE_OK)
		status = fail(r->status, "%s", r->sentence);
	if (status != SCREE_OK)
	{
		recorder_free(r);
		return status;
	}
	r->begun = true;
	r->next = world->recorders.first;
	world->recorders.first = r;
	*made = r;
	return SCREE_OK;
}

scree_status recorder_end(scree_world* world, Recorder* recorder, const char* function, bool hash)
{
	Recorder** place = &world->recorders.first;
	while (*place != recorder)
		place = &(*place)->next;
	*place = recorder->next;
	if (recorder->status == SCREE_OK && hash && !world->broken)
		add_hash(world, recorder);
	if (recorder->status == SCREE_OK && add_empty(recorder, RECORD_END) == SCREE_OK)
		flush(recorder);
	if (recorder->file && fclose(recorder->file) != 0 && recorder->status == SCREE_OK)
		recorder_fail(recorder, SCREE_ERROR_FILE, "scree_world_record: %s cannot be closed: %s", recorder->path,
		              strerror(errno));
	recorder->file = NULL;
	recorder->ended = true;
	return recorder->status == SCREE_OK ? SCREE_OK : fail(recorder->status, "%s: %s", function, recorder->sentence);
}

void recorder_free(Recorder* recorder)
{
	if (!recorder)
		return;
	if (recorder->file)
		fclose(recorder->file);
	scree_release(recorder->path);
	scree_release(recorder->written.bytes);
	scree_release(recorder->payload.bytes);
	scree_release(recorder);
}

void recorders_close(scree_world* world)
{
	Recorder* own = world->recorders.own;
	world->recorders.own = NULL;
	while (world->recorders.first)
	{
		Recorder* recorder = world->recorders.first;
		recorder_end(world, recorder, "scree_world_destroy", false);
		if (recorder != own)
			recorder_free(recorder);
	}
	recorder_free(own);
}

// ---------------------------------------------------------------------------------------------------------------
// calls
// ---------------------------------------------------------------------------------------------------------------

void recorders_enter(scree_world* world) { ++world->recorders.depth; }

// Counts a call that concerns saves. Returns whether a replay can make the call: it has no saves from before the recording.
static bool note_save(Recorder* r, RecordedCallId call, const void* const* values)
{
	uint64_t bit = call == RECORDED_world_save || call == RECORDED_world_load || call == RECORDED_world_discard
	                   ? (uint64_t)1 << *(const int*)values[0]
	                   : 0;
	if (call == RECORDED_world_save)
		r->saves |= bit;
	if (call == RECORDED_world_discard)
		r->saves &= ~bit;
	return call != RECORDED_world_load || (r->saves & bit);
}

static void add_call(scree_world* world, RecordedCallId call, const void* const* values)
{
	for (Recorder* r = world->recorders.first; r; r = r->next)
	{
		if (r->status != SCREE_OK)
			continue;
		if (!note_save(r, call, values))
		{
			add_snapshot(world, r);
			continue;
		}
		r->payload.used = 0;
		call_write(&r->payload, call, values);
		add(r, RECORD_CALLS + (uint64_t)call);
	}
}

// A call that is refused for its arguments has changed nothing. After another failure, for instance of a step beyond the contact
// limit, a recording goes on with a snapshot: less depends on memory that ran out.
static void add_failure(scree_world* world, scree_status status)
{
	if (!world->recorders.first || status == SCREE_ERROR_INVALID || status == SCREE_ERROR_STALE || world->broken)
		return;
	Sentence sentence = sentence_keep();
	for (Recorder* r = world->recorders.first; r; r = r->next)
		if (r->status == SCREE_OK)
			add_snapshot(world, r);
	sentence_restore(&sentence);
}

scree_status recorders_leave(scree_world* world, RecordedCallId call, const void* const* values, scree_status status)
{
	FLOAT_MODE_HERE;
	if (--world->recorders.depth > 0)
		return status;
	recovery_note(world, call, values, status); // first, because the recorders may read from the device
	if (status == SCREE_OK)
		add_call(world, call, values);
	else
		add_failure(world, status);
	return status;
}

void recorders_enter_step(scree_world* world, RecordedCallId call, const void* const* values)
{
	recorders_enter(world);
	add_call(world, call, values);
	for (Recorder* r = world->recorders.first; r; r = r->next)
		flush(r);
}

scree_status recorders_leave_step(scree_world* world, RecordedCallId call, const void* const* values,
                                  scree_status status)
{
	FLOAT_MODE_HERE;
	--world->recorders.depth;
	recovery_note(world, call, values, status);
	for (Recorder* r = world->recorders.first; r; r = r->next)
	{
		if (r->status != SCREE_OK)
			continue;
		if (status != SCREE_OK)
			add_empty(r, RECORD_FAILED);
		else if (++r->steps, r->hash_interval > 0 && r->steps % r->hash_interval == 0)
			add_hash(world, r);
	}
	if (status != SCREE_OK)
		add_failure(world, status);
	return status;
}
