// SPDX-License-Identifier: MIT
// recovery.c -- decides when a state of a world is kept, and whether a call is repeated on the CPU.
#include "world/recovery/recovery.h"
#include "platform/error.h"
#include "platform/processor.h"
#include "world/record/record_log.h"
#include "world/recovery/rescue.h"
#include <stdio.h>

#ifdef SCREE_SMALL // a build for WebAssembly has no device but the CPU
scree_status recovery_begin(scree_world* world, const char* function)
{
	(void)world;
	(void)function;
	return SCREE_OK;
}
scree_status recovery_prepare(scree_world* world, const char* function) { return recovery_begin(world, function); }
bool world_recovers(scree_world* world, const char* function, scree_status status)
{
	(void)status;
	return recovery_begin(world, function) != SCREE_OK;
}
#else

// bytes: a state is kept when the calls since need more memory than the state, but not below this size.
#define LEAST_CALLS ((size_t)1 << 20)

static bool on_cpu(const scree_world* world) { return world->backend->threads > 0; }

static void plan(Recovery* r)
{
	size_t state = pool_info[POOL_saved].bytes * (size_t)r->kept.items;
	r->most = state > LEAST_CALLS ? state : LEAST_CALLS;
	r->waited = 0;
	r->due = false;
}

static scree_status keep(scree_world* world, const char* function)
{
	TRY(kept_state_take(world, function, &world->recovery->kept));
	plan(world->recovery);
	return SCREE_OK;
}

// Keeps a state. No call of the user fails for lack of memory here. complete: the calls since the last state are complete.
static void keep_after(scree_world* world, const char* function, bool complete)
{
	FLOAT_MODE_HERE;
	Recovery* r = world->recovery;
	Sentence sentence = sentence_keep();
	scree_status status = keep(world, function);
	if (status != SCREE_OK && !complete)
		kept_state_close(world, &r->kept);
	if (status != SCREE_OK && !world->broken)
	{
		log_sentence(SCREE_LOG_WARNING, "%s; the state of step %lld is not kept for recovery", scree_error(),
		             (long long)world->pipeline.steps);
		plan(r);
		r->most += r->kept.calls.used;
	}
	else if (r->kept.save)
		world_recovers(world, function, status);
	if (!world->broken)
		sentence_restore(&sentence);
}

// After a call: keeps a state if one is due, or gives it up if the world has moved to the CPU. call: name without "scree_".
static void update(scree_world* world, const char* call, bool complete)
{
	Recovery* r = world->recovery;
	if (world->broken)
		return;
	if (on_cpu(world))
	{
		kept_state_close(world, &r->kept);
		r->due = true;
	}
	else if (r->due || !complete || r->waited >= world->def.recovery_interval || r->kept.calls.used > r->most)
	{
		char function[64];
		snprintf(function, sizeof function, "scree_%s", call);
		keep_after(world, function, complete);
	}
}

scree_status recovery_prepare(scree_world* world, const char* function)
{
	Recovery* r = world->recovery;
	if (r && r->due && !r->kept.save)
		keep_after(world, function, true);
	return world->broken;
}

scree_status recovery_begin(scree_world* world, const char* function)
{
	if (world->def.recovery_interval == 0)
		return SCREE_OK;
	if (!world->recovery)
		world->recovery = scree_allocate(sizeof *world->recovery);
	if (!world->recovery)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for recovery", function);
	world->recovery->due = true;
	return on_cpu(world) ? SCREE_OK : keep(world, function);
}

void recovery_close(scree_world* world)
{
	if (world->recovery)
		kept_state_close(world, &world->recovery->kept);
	scree_release(world->recovery);
	world->recovery = NULL;
}

bool world_recovers(scree_world* world, const char* function, scree_status status)
{
	Recovery* r = world->recovery;
	// a call within another one is repeated with it
	if (status == SCREE_OK || !world->broken || !r || world->recorders.depth > 1)
		return false;
	FLOAT_MODE_HERE;
	if (!r->kept.save || on_cpu(world))
	{
		Sentence cause = sentence_keep();
		fail(status, "%.400s; no state of the world is kept, and it can only be destroyed", cause.text);
		return false;
	}
	if (world_rescue(world, function, &r->kept) != SCREE_OK)
		return false;
	kept_state_close(world, &r->kept);
	r->due = true;
	return true;
}

void recovery_note(scree_world* world, RecordedCallId call, const void* const* values, scree_status status)
{
	Recovery* r = world->recovery;
	// a call that is refused for its arguments has changed nothing
	if (!r || status == SCREE_ERROR_INVALID || status == SCREE_ERROR_STALE)
		return;
	bool complete = true;
	if (status != SCREE_OK)
		r->due = true; // less depends on memory that ran out
	else if (r->kept.save)
	{
		// a state is kept at once where one is at hand, and after a load of a save that a later save may replace
		r->due |= call == RECORDED_world_restore;
		complete = kept_state_add(&r->kept, RECORD_CALLS + (uint64_t)call, values);
		r->due |= r->kept.read != 0;
	}
	r->waited += call == RECORDED_world_step;
	update(world, recorded_calls[call].name, complete);
}

void recovery_read(scree_world* world, const char* call, bool noted)
{
	KeptState* kept = &world->recovery->kept;
	if (world->recorders.depth > 0) // the call around it may be half done
		return;
	update(world, call, !noted || !kept->save || kept_state_add(kept, RECORD_MOVED, NULL));
}
#endif
