// SPDX-License-Identifier: MIT
// pair.c -- runs a program on two worlds side by side, which must have equal statuses, results and hashes.
#include "backend/arithmetic.h"
#include "programs/run_call.h"
#include "world/recovery/recovery.h"
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

#include "platform/system.h" // on Windows it defines the names near and far, so it is the last one

// Returns a pseudo-random word for a call (Donald Knuth, multiplicative hashing). It depends only on this call and on
// `first`. Other calls have no influence, because they may be dropped when the program is shortened.
static uint32_t any_of(const Call* call, uint32_t first)
{
	uint32_t any = first + (uint32_t)call->kind;
	for (int i = 0; i < call_info(call->kind)->count; ++i)
	{
		uint32_t word;
		memcpy(&word, call->value + i, sizeof word);
		any = (any ^ any >> 15) * 2654435769u + word;
	}
	return (any ^ any >> 13) * 2654435769u;
}

// Reads a world between two calls, moves it to the device that it is on, replaces it by its snapshot, copies it into a batch, or
// does nothing. Returns whether the copies have the bits of the world.
// The results of later calls must not change. The list of moved bodies is not read, because each reading begins a new list.
static bool read_between(Pair* pair, CallRun run)
{
	uint32_t any = any_of(run.call, pair->first_read);
	uint64_t hash;
	Left left;
	Call call = call_make(CALL_read);
	scree_query_result found;
	run.call = &call;
	run.left = &left;
	call_set(&call, "body", (float)(any >> 16 & 63));
	switch (any >> 29)
	{
	case 0:
	case 1:
		run_call(&run);
		break;
	case 2:
	case 3:
		scree_world_cast_ray(run.world, (scree_vec){0.0f, 20.0f}, (scree_vec){0.0f, -40.0f}, &found);
		break;
	case 4:
		scree_world_get_hash(run.world, &hash);
		break;
	case 5:
		scree_world_move(run.world, scree_world_get_device(run.world));
		break;
	case 6:
		snapshot_repeat(run.world, any >> 24 & 1);
		break;
	default:
		return (any >> 25 & 15) != 0 || batch_repeat(run.world, run.place, &pair->batches);
	}
	return true;
}

// Lets the device of a world fail between two calls, or not; the world recovers in the next call that uses the device. A CPU counts
// as a device, whose threads are not counted, so that a state is kept.
static void fail_between(const Pair* pair, scree_world* world, const Call* call)
{
	world->backend->threads = 0;
	if (world->recovery->kept.save && any_of(call, pair->first_read) >> 28 == 0)
	{
		world->broken = SCREE_ERROR_DEVICE_FAILED;
		scree_world_wait(world);
	}
}

// Makes a call on world number k of the pair, and returns the outcome. hashes: whether the outcome of a step includes
// the hash of the world.
static Left make_call(Pair* pair, int k, const Call* call, bool hashes)
{
	Left left = {0};
	if (call->kind != CALL_step) // a step opens no device, and the worlds may take their steps at the same time
		arithmetic_setting.flush = pair->places[k].flush;
	CallRun run = {call, pair->worlds[k], pair->names[k], &pair->places[k], pair->homes[k], &left};
	if (pair->places[k].reads)
	{
		TreeState* moving = &pair->worlds[k]->pipeline.trees[0];
		pair->worlds[k]->pipeline.quiet = 0; // no step is skipped (step/pipeline.c)
		moving->boxed = 0;                   // boxes for queries are all computed (step/step_queries.c)
		moving->change = TREE_MOVED;         // all boxes of the tree are computed (step/stage_lists.c)
	}
	if (pair->places[k].faults)
		fail_between(pair, pair->worlds[k], call);
	left.status = run_call(&run);
	if (left.status != SCREE_OK)
		snprintf(left.error, sizeof left.error, "%s", scree_error());
	uint64_t hash = 0;
	if (left.status == SCREE_OK && call->kind == CALL_step && hashes)
		left.status = scree_world_get_hash(pair->worlds[k], &hash);
	left.word += hash;
	bool copied = pair->places[k].batches && call->kind == CALL_step && left.status == SCREE_OK;
	if ((pair->places[k].reads && !read_between(pair, run)) ||
	    (copied && !batch_repeat(run.world, run.place, &pair->batches)))
	{
		left.status = SCREE_ERROR_DEVICE_FAILED; // the other world has another status
		snprintf(left.error, sizeof left.error, "a copy in a batch differs");
	}
	return left;
}

// ---------------------------------------------------------------------------------------------------------------
// a thread that takes the steps of the reference while a GPU takes those of the other world
// ---------------------------------------------------------------------------------------------------------------

struct Worker
{
	Thread thread;
	Mutex mutex;
	Condition changed;
	const Call* call; // call in progress, or null
	bool hashes, ends;
	Left left;
};

static THREAD_RESULT work(void* context)
{
	Pair* pair = context;
	struct Worker* h = pair->worker;
	mutex_lock(&h->mutex);
	for (;;)
	{
		while (!h->call && !h->ends)
			condition_wait(&h->changed, &h->mutex);
		if (h->ends)
			break;
		mutex_unlock(&h->mutex);
		Left left = make_call(pair, 0, h->call, h->hashes);
		mutex_lock(&h->mutex);
		h->left = left;
		h->call = NULL;
		condition_wake_all(&h->changed);
	}
	mutex_unlock(&h->mutex);
	return THREAD_END;
}

static void worker_open(Pair* pair)
{
	struct Worker* h = pair->worker = calloc(1, sizeof *h);
	if (!h)
		abort();
	mutex_open(&h->mutex);
	condition_open(&h->changed);
	if (!thread_start(&h->thread, work, pair))
		abort();
}

static void worker_close(struct Worker* h)
{
	mutex_lock(&h->mutex);
	h->ends = true;
	condition_wake_all(&h->changed);
	mutex_unlock(&h->mutex);
	thread_join(h->thread);
	condition_close(&h->changed);
	mutex_close(&h->mutex);
	free(h);
}

static void make_calls(Pair* pair, const Call* call, bool hashes, Left left[2])
{
	struct Worker* h = call->kind == CALL_step ? pair->worker : NULL;
	if (!h)
	{
		left[0] = make_call(pair, 0, call, hashes);
		left[1] = make_call(pair, 1, call, hashes);
		return;
	}
	mutex_lock(&h->mutex);
	h->call = call;
	h->hashes = hashes;
	condition_wake_all(&h->changed);
	mutex_unlock(&h->mutex);
	left[1] = make_call(pair, 1, call, hashes);
	mutex_lock(&h->mutex);
	while (h->call)
		condition_wait(&h->changed, &h->mutex);
	left[0] = h->left;
	mutex_unlock(&h->mutex);
}

// ---------------------------------------------------------------------------------------------------------------
// the pair
// ---------------------------------------------------------------------------------------------------------------

void pair_open(Pair* pair, const Place places[2])
{
	*pair = (Pair){.places = {places[0], places[1]}};
	for (int k = 0; k < 2; ++k)
		pair->names[k] = calloc(1, sizeof *pair->names[k]);
	if (!pair->names[0] || !pair->names[1])
		abort();
	if (strcmp(places[1].device, "cpu") == 0)
		return;
	worker_open(pair);
	const Call made = call_make(CALL_world);
	arithmetic_setting.flush = places[1].flush;
	// a failure is reported when the first program fails in the same way
	if (run_world(&places[1], &made, &pair->keeper) == SCREE_OK && (places[1].batches || places[1].reads))
		batch_keep(places[1].device, &pair->batch_keeper);
}

static void ignore_line(scree_log_level level, const char* sentence, void* context)
{
	(void)level;
	(void)sentence;
	(void)context;
}

scree_status pair_hide_log(void)
{
	const scree_hooks hooks = {.log = ignore_line};
	return scree_hooks_set(&hooks);
}

void pair_forget(Pair* pair)
{
	for (int k = 0; k < 2; ++k)
	{
		scree_world_destroy(pair->worlds[k]);
		pair->worlds[k] = NULL;
	}
	scree_world_destroy(pair->repeated);
	pair->repeated = NULL;
}

void pair_close(Pair* pair)
{
	pair_forget(pair);
	scree_batch_destroy(pair->batch_keeper);
	scree_world_destroy(pair->keeper);
	if (pair->worker)
		worker_close(pair->worker);
	for (int k = 0; k < 2; ++k)
	{
		names_clear(pair->names[k]);
		free(pair->names[k]);
	}
}

static bool left_differs(const Left* a, const Left* b, Outcome* outcome)
{
	bool refused = a->status == SCREE_ERROR_INVALID || a->status == SCREE_ERROR_STALE || a->status == SCREE_OK;
	if (a->status == b->status && a->word == b->word && refused)
		return false;
	outcome->differs = true;
	if (a->status != b->status || !refused)
		snprintf(outcome->sentence, sizeof outcome->sentence, "%s (%.100s) and %s (%.100s)",
		         scree_status_name(a->status), a->error, scree_status_name(b->status), b->error);
	else
		snprintf(outcome->sentence, sizeof outcome->sentence, "%016" PRIx64 " and %016" PRIx64, a->word, b->word);
	return true;
}

void program_add_empty(Program* program)
{
	static const CallKind kinds[] = {CALL_move, CALL_clear, CALL_step, CALL_step, CALL_gravity, CALL_tuning};
	const Call made = program->calls[0];
	for (size_t k = 0; k < sizeof kinds / sizeof kinds[0]; ++k)
	{
		Call call = call_make(kinds[k]);
		if (call.kind == CALL_move)
			call_set(&call, "back", 1.0f);
		if (call.kind == CALL_gravity)
		{
			call_set(&call, "x", call_value(&made, "gravity_x"));
			call_set(&call, "y", call_value(&made, "gravity_y"));
		}
		for (int i = 0; i < call_info(CALL_tuning)->count && call.kind == CALL_tuning; ++i)
			call_set(&call, call_info(CALL_tuning)->names[i], call_value(&made, call_info(CALL_tuning)->names[i]));
		program_add(program, call);
	}
}

// Empties both worlds of a pair. Returns whether all calls for this succeed with equal results.
static bool pair_empty(Pair* pair)
{
	Program program = {0};
	Outcome outcome = {0};
	bool same = true;
	program_add(&program, pair->made);
	program_add_empty(&program);
	for (int i = 1; i < program.count && same; ++i)
	{
		Left left[2];
		make_calls(pair, &program.calls[i], true, left);
		same = left[0].status == SCREE_OK && !left_differs(&left[0], &left[1], &outcome);
	}
	program_close(&program);
	return same;
}

static bool pair_ready(Pair* pair, const Call* made, Outcome* outcome)
{
	bool same = pair->worlds[0] && memcmp(&pair->made, made, sizeof *made) == 0;
	if (same && !pair->anew && pair_empty(pair))
		return true;
	pair_forget(pair);
	pair->made = *made;
	Left left[2] = {{0}, {0}};
	for (int k = 0; k < 2; ++k)
	{
		names_clear(pair->names[k]);
		arithmetic_setting.flush = pair->places[k].flush;
		left[k].status = run_world(&pair->places[k], made, &pair->worlds[k]);
		if (left[k].status != SCREE_OK)
			snprintf(left[k].error, sizeof left[k].error, "%s", scree_error());
		// keeps the full name of the device
		snprintf(pair->homes[k], sizeof pair->homes[k], "%s", scree_world_get_device(pair->worlds[k]));
	}
	if (left[0].status == SCREE_OK && left[1].status == SCREE_OK)
		return true;
	left_differs(&left[0], &left[1], outcome);
	pair_forget(pair);
	return false;
}

Outcome pair_run(Pair* pair, const Program* program, FILE* details)
{
	Outcome outcome = {0};
	Sleepers sleepers = {0};
	if (!pair_ready(pair, &program->calls[0], &outcome))
		return outcome;
	recorded_begin(pair);
	int batches = pair->batches;
	for (int i = 1; i < program->count; ++i)
	{
		const Call* call = &program->calls[i];
		Left left[2];
		outcome.call = i;
		outcome.steps += call->kind == CALL_step;
		bool hashes = pair->every < 2 || outcome.steps % pair->every == 0 || i + 1 == program->count;
		make_calls(pair, call, hashes, left);
		bool differs = left_differs(&left[0], &left[1], &outcome);
		outcome.hash = (outcome.hash ^ left[0].word) * 0x9e3779b97f4a7c15u;
		outcome.hash ^= outcome.hash >> 29;
		// only a step with dt above 0 can find and correct values that are not finite or too large
		bool moved = call->kind == CALL_step && call_value(call, "dt") > 0.0f;
		if (!differs && moved && left[0].status == SCREE_OK && hashes)
		{
			outcome.frozen += state_frozen(pair->worlds[0]);
			sleepers_count(&sleepers, pair->worlds[0], &outcome.slept, &outcome.woke);
			bool good = (pair->infinite || state_finite(pair->worlds[0], outcome.sentence)) &&
			            state_colored(pair->worlds[0], outcome.sentence) &&
			            state_sleeps(pair->worlds[0], outcome.sentence) &&
			            (!pair->limits || state_limited(pair->worlds[0], outcome.sentence));
			differs = outcome.differs = !good;
		}
		if (!differs)
			continue;
		if (details && left[0].status == SCREE_OK && left[1].status == SCREE_OK)
			different_print(pair->worlds[0], pair->worlds[1], details);
		break;
	}
	recorded_end(pair, &outcome);
	outcome.batches = pair->batches - batches;
	sleepers_close(&sleepers);
	return outcome;
}
