// SPDX-License-Identifier: MIT
// replays.c -- repeats the calls of a recording, and compares their results and the hashes of the world.
#include "platform/error.h"
#include "platform/processor.h"
#include "world/failure.h"
#include "world/record/api_calls.h"
#include "world/record/repeat.h"
#include <inttypes.h>
#include <stdio.h>
#include <string.h>

struct scree_replay
{
	const uint8_t *begin, *end; // the snapshot of the beginning, and the end of the last whole record
	LogRecord snapshot;
	ByteReader reader; // the next record
	FileLists lists;
	CallArguments arguments;
	scree_replay_info info;
};

// ---------------------------------------------------------------------------------------------------------------
// opening
// ---------------------------------------------------------------------------------------------------------------

// Checks a record behind the snapshot, and counts it.
static scree_status check_record(const char* function, scree_replay* r, const LogRecord* record)
{
	if (record->number >= RECORD_CALLS)
	{
		TRY(call_read(function, &r->lists, record, &r->arguments));
		++r->info.calls;
		r->info.steps += r->arguments.call == RECORDED_world_step;
		return SCREE_OK;
	}
	r->info.ended = record->number == RECORD_END;
	r->info.hashes += record->number == RECORD_HASH;
	if (record->number == RECORD_FAILED)
	{
		--r->info.calls;
		--r->info.steps;
	}
	bool known = record->number == RECORD_HASH ? record->size == sizeof(uint64_t)
	             : record->number == RECORD_SNAPSHOT
	                 ? true
	                 : (record->number == RECORD_END || record->number == RECORD_FAILED) && record->size == 0;
	if (!known || r->info.steps < 0)
		return fail(SCREE_ERROR_INVALID, "%s: record %" PRIu64 " with %zu bytes is no record of this version, %s",
		            function, record->number, record->size, scree_version());
	return SCREE_OK;
}

static scree_status read_all(const char* function, scree_replay* r, size_t size)
{
	uint64_t chain;
	const char* version;
	int length;
	LogRecord record;
	const uint8_t* start = r->reader.at;
	TRY(log_open(function, &r->reader, size, &chain, &version, &length));
	snprintf(r->info.version, sizeof r->info.version, "%.*s", length, version);
	if (!log_next(&r->reader, &chain, &record) || record.number != RECORD_LISTS)
		return fail(SCREE_ERROR_INVALID, "%s: the recording is damaged or cut off in its list of calls", function);
	ByteReader lists = {record.bytes, record.bytes + record.size};
	TRY(lists_read(function, &lists, &r->lists));
	if (!log_next(&r->reader, &chain, &r->snapshot) || r->snapshot.number != RECORD_SNAPSHOT)
		return fail(SCREE_ERROR_INVALID, "%s: the recording is damaged or cut off in its first snapshot", function);
	r->begin = r->reader.at;
	while (!r->info.ended && log_next(&r->reader, &chain, &record))
		TRY(check_record(function, r, &record));
	r->end = r->reader.end = r->reader.at;
	r->reader.at = r->begin;
	r->info.read = (size_t)(r->end - start);
	return SCREE_OK;
}

scree_status api_replay_open(const void* bytes, size_t size, scree_replay** replay)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_replay_open";
	TRY(check_pointer(function, "replay", replay));
	*replay = NULL;
	TRY(check_pointer(function, "bytes", bytes));
	scree_replay* made = scree_allocate(sizeof *made);
	if (!made)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for a replay", function);
	made->reader = (ByteReader){bytes, (const uint8_t*)bytes + size};
	scree_status status = read_all(function, made, size);
	if (status == SCREE_OK)
		*replay = made;
	else
		scree_replay_close(made);
	return status;
}

void scree_replay_close(scree_replay* replay)
{
	if (!replay)
		return;
	lists_close(&replay->lists);
	arguments_close(&replay->arguments);
	scree_release(replay);
}

scree_status api_replay_get_info_sized(const scree_replay* replay, scree_replay_info* info, size_t size)
{
	FLOAT_MODE_HERE;
	TRY(check_pointer("scree_replay_get_info", "replay", replay));
	TRY(check_pointer("scree_replay_get_info", "info", info));
	write_result(info, size, &replay->info, sizeof replay->info);
	return SCREE_OK;
}

// ---------------------------------------------------------------------------------------------------------------
// worlds
// ---------------------------------------------------------------------------------------------------------------

static void begin_again(scree_replay* replay)
{
	scree_replay_info* info = &replay->info;
	replay->reader.at = replay->begin;
	info->step = info->call = 0;
	info->dt = 0.0f;
	info->substeps = 0;
}

scree_status api_replay_create_world(scree_replay* replay, const scree_world_def* def, scree_world** world)
{
	FLOAT_MODE_HERE;
	TRY(check_pointer("scree_replay_create_world", "world", world));
	*world = NULL;
	TRY(check_pointer("scree_replay_create_world", "replay", replay));
	TRY(scree_world_create_from(def, replay->snapshot.bytes, replay->snapshot.size, world));
	begin_again(replay);
	return SCREE_OK;
}

scree_status api_replay_restore(scree_replay* replay, scree_world* world)
{
	FLOAT_MODE_HERE;
	TRY(check_pointer("scree_replay_restore", "replay", replay));
	TRY(scree_world_restore(world, replay->snapshot.bytes, replay->snapshot.size));
	begin_again(replay);
	return SCREE_OK;
}

// ---------------------------------------------------------------------------------------------------------------
// steps
// ---------------------------------------------------------------------------------------------------------------

// Reads the next record without moving on. Returns its number, or RECORD_END at the end.
static uint64_t next_number(const scree_replay* r)
{
	ByteReader ahead = r->reader;
	LogRecord record = {.number = RECORD_END};
	if (ahead.at < ahead.end)
		log_again(&ahead, &record);
	return record.number;
}

static scree_status repeat(const char* function, scree_replay* r, scree_world* world, const LogRecord* record,
                           bool* step)
{
	TRY(call_read(function, &r->lists, record, &r->arguments));
	*step = false;
	if (next_number(r) == RECORD_FAILED)
	{
		log_again(&r->reader, &(LogRecord){0});
		return SCREE_OK;
	}
	const char* name = recorded_calls[r->arguments.call].name;
	*step = r->arguments.call == RECORDED_world_step;
	r->info.step += *step;
	++r->info.call;
	long long number = r->info.step + !*step;
	scree_status status = call_repeat(world, &r->arguments);
	if (status != SCREE_OK)
	{
		char sentence[512];
		snprintf(sentence, sizeof sentence, "%s", scree_error());
		bool world_fails =
		    status != SCREE_ERROR_INVALID && status != SCREE_ERROR_STALE && status != SCREE_ERROR_CONTACT_LIMIT;
		return fail(world_fails ? status : SCREE_ERROR_DIFFERENT,
		            "%s: step %lld: a call fails that did not fail in the recording: %s", function, number, sentence);
	}
	if (*step)
	{
		memcpy(&r->info.dt, r->arguments.values[0], sizeof r->info.dt);
		memcpy(&r->info.substeps, r->arguments.values[1], sizeof r->info.substeps);
	}
	const char* result = results_differ(&r->arguments);
	if (result)
		return fail(SCREE_ERROR_DIFFERENT, "%s: step %lld: scree_%s returns another %s than in the recording", function,
		            number, name, result);
	return SCREE_OK;
}

static scree_status compare_hash(const char* function, const scree_replay* r, scree_world* world,
                                 const LogRecord* record)
{
	uint64_t recorded, hash;
	memcpy(&recorded, record->bytes, sizeof recorded);
	TRY(scree_world_get_hash(world, &hash));
	if (hash == recorded)
		return SCREE_OK;
	return fail(SCREE_ERROR_DIFFERENT, "%s: step %lld: the hash is %016" PRIx64 ", and %016" PRIx64 " in the recording",
	            function, (long long)r->info.step, hash, recorded);
}

// Repeats calls up to the next step and its hash.
static scree_status replay_step(const char* function, scree_replay* r, scree_world* world, bool* stepped)
{
	while (r->reader.at < r->reader.end)
	{
		uint64_t number = next_number(r);
		if (*stepped && number != RECORD_HASH)
			return SCREE_OK;
		LogRecord record;
		log_again(&r->reader, &record);
		if (number >= RECORD_CALLS)
			TRY(repeat(function, r, world, &record, stepped));
		else if (number == RECORD_HASH)
			TRY(compare_hash(function, r, world, &record));
		else if (number == RECORD_SNAPSHOT)
			TRY(scree_world_restore(world, record.bytes, record.size));
	}
	return SCREE_OK;
}

scree_status api_replay_step(scree_replay* replay, scree_world* world, bool* stepped)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_replay_step";
	TRY(check_pointer(function, "replay", replay));
	TRY(check_pointer(function, "stepped", stepped));
	TRY(world_check(world, function));
	*stepped = false;
	scree_status status = replay_step(function, replay, world, stepped);
	if (status != SCREE_OK) // so that a loop can go on
		*stepped = replay->reader.at < replay->reader.end;
	return status;
}
