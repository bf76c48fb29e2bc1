// SPDX-License-Identifier: MIT
// readers.c -- lets several threads read a world on the CPU at the same time, between two calls that change it.
//
// A call that changes the world, or that uses memory of the world for its results, is alone (Readers.alone); at its end the state
// is READERS_CHANGED. Readers raise the state under the lock. They read the world without the lock only after they have read the
// state, so that they see all writes of the thread that raised it.
#include "world/upload/readers.h"
#include "platform/system.h"
#include "platform/zones.h"
#include "step/step_queries.h"
#include "world/device/auto.h"
#include "world/failure.h"
#include "world/objects/handles.h"
#include "world/upload/upload.h"
#include <stdatomic.h>

// Number of queries of a call that are shared by the workers, if no other query uses them. A thread takes about 1 us per query, and
// to wake a worker takes 50 us.
#define WHOLE_QUERIES 256

enum
{
	READERS_CHANGED,  // changes may be pending
	READERS_UPLOADED, // no change is pending
	READERS_PREPARED, // and the boxes for queries match the poses
};

typedef struct Reader // a thread that has made queries
{
	const void* thread; // address that identifies the thread
	Queries queries;
	struct Reader* next;
} Reader;

typedef struct Readers
{
	Mutex lock;    // held while the state is raised, and during a query that has the whole world
	int alone;     // number of calls in progress that are alone in the world; one may make another
	bool prepared; // scree_world_prepare_queries is in progress, and has prepared the world
	atomic_int state;
	_Atomic(const char*) holder; // this_thread of the thread between readers_lock and readers_unlock, or null
	atomic_ullong nanoseconds;   // time of queries that is not yet added to that of the step
	_Atomic(Reader*) first;      // list of readers, which only grows
} Readers;

static _Thread_local char this_thread; // its address identifies the thread

static void close_queries(const Queries* queries)
{
	scree_release(queries->found);
	scree_release(queries->query);
	scree_release(queries->first);
}

scree_status readers_open(scree_world* world, const char* function)
{
	Readers* readers = world->readers = scree_allocate(sizeof *readers);
	if (!readers)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for queries", function);
	mutex_open(&readers->lock);
	return SCREE_OK;
}

void readers_close(scree_world* world)
{
	Readers* readers = world->readers;
	close_queries(&world->own_queries);
	if (!readers)
		return;
	for (Reader* reader = atomic_load(&readers->first); reader;)
	{
		Reader* next = reader->next;
		close_queries(&reader->queries);
		scree_release(reader);
		reader = next;
	}
	mutex_close(&readers->lock);
	scree_release(readers);
}

void readers_enter(scree_world* world) { ++world->readers->alone; }

void readers_leave(scree_world* world)
{
	Readers* readers = world->readers;
	--readers->alone;
	atomic_store(&readers->state, readers->prepared ? READERS_PREPARED : READERS_CHANGED);
	readers->prepared = false;
	unsigned long long nanoseconds = atomic_load_explicit(&readers->nanoseconds, memory_order_relaxed);
	if (nanoseconds == 0)
		return;
	world->auto_device.current += 1e-6 * (double)nanoseconds;
	atomic_store_explicit(&readers->nanoseconds, 0, memory_order_relaxed);
}

void readers_count(scree_world* world, double since)
{
	const AutoDevice* a = &world->auto_device;
	if (world->readers->alone)
		auto_count(world, since);
	else if (a->on && !a->alone)
		atomic_fetch_add_explicit(&world->readers->nanoseconds, (unsigned long long)(1e6 * (auto_clock() - since)),
		                          memory_order_relaxed);
}

bool readers_parallel(const scree_world* world) { return world->backend->f->search; }

bool readers_lock(scree_world* world)
{
	Readers* readers = world->readers;
	if (atomic_load(&readers->holder) == &this_thread)
		return false;
	mutex_lock(&readers->lock);
	atomic_store(&readers->holder, &this_thread);
	return true;
}

void readers_unlock(scree_world* world, bool locked)
{
	if (!locked)
		return;
	atomic_store(&world->readers->holder, NULL);
	mutex_unlock(&world->readers->lock);
}

// Returns whether other threads may read the world during this call. A call that holds the lock began on a device that has failed
// since, and is repeated on the CPU. In a build for WebAssembly no call marks itself as alone (api_calls.h).
static bool shares(const scree_world* world)
{
#ifdef SCREE_SMALL
	(void)world;
	return false;
#else
	const Readers* readers = world->readers;
	return readers_parallel(world) && !readers->alone && atomic_load(&readers->holder) != &this_thread;
#endif
}

static scree_status prepare(scree_world* world)
{
	ZONE_BEGIN(zone, "scree: prepare queries");
	Names collidables = collidable_names(world), bodies = body_names(world);
	scree_status status = world_note(world, searches_prepare(&world->pipeline, &collidables, &bodies));
	ZONE_END(zone);
	return status;
}

// Raises the state, unless it is as high already. The user's pool is not used: its threads may wait for this lock.
static scree_status raise_state(scree_world* world, int state)
{
	Readers* readers = world->readers;
	if (atomic_load_explicit(&readers->state, memory_order_acquire) >= state)
		return SCREE_OK;
	mutex_lock(&readers->lock);
	scree_status status = SCREE_OK;
	int now = atomic_load_explicit(&readers->state, memory_order_relaxed);
	world->backend->alone = world->def.tasks;
	if (now < READERS_UPLOADED)
		status = world_upload(world);
	if (!status && now < state && state == READERS_PREPARED)
	{
		double begin = auto_clock();
		status = prepare(world);
		readers_count(world, begin);
	}
	world->backend->alone = false;
	if (!status && now < state)
		atomic_store_explicit(&readers->state, state, memory_order_release);
	mutex_unlock(&readers->lock);
	return status;
}

scree_status readers_upload(scree_world* world)
{
	return shares(world) ? raise_state(world, READERS_UPLOADED) : world_upload(world);
}

scree_status readers_prepare(scree_world* world)
{
	TRY(world_upload(world));
	double begin = auto_clock();
	scree_status status = prepare(world);
	auto_count(world, begin);
	world->readers->prepared = status == SCREE_OK && readers_parallel(world);
	return status;
}

scree_status readers_begin(scree_world* world, int count, Reading* reading)
{
	*reading = (Reading){.alone = true};
	if (!shares(world))
		return world_upload(world);
	TRY(raise_state(world, READERS_PREPARED));
	reading->alone = false;
	if (world->def.timings)
		readers_alone(world, reading); // stores the time of the queries
	else if (count >= WHOLE_QUERIES && !world->def.tasks && world->backend->threads > 1)
		reading->alone = reading->locked = mutex_try(&world->readers->lock);
	return SCREE_OK;
}

void readers_alone(scree_world* world, Reading* reading)
{
	if (reading->alone)
		return;
	mutex_lock(&world->readers->lock);
	world->backend->alone = world->def.tasks;
	reading->alone = reading->locked = true;
}

void readers_end(scree_world* world, const Reading* reading)
{
	if (!reading->locked)
		return;
	world->backend->alone = false;
	mutex_unlock(&world->readers->lock);
}

Queries* readers_queries(scree_world* world, const char* function)
{
	Readers* readers = world->readers;
	if (world->makes_queries)
		return &world->own_queries;
	Reader* first = atomic_load_explicit(&readers->first, memory_order_acquire);
	for (Reader* reader = first; reader; reader = reader->next)
	{
		if (reader->thread == &this_thread)
			return &reader->queries;
	}
	Reader* made = scree_allocate(sizeof *made);
	if (!made)
	{
		fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for the results", function);
		return NULL;
	}
	made->thread = &this_thread;
	made->next = first;
	while (!atomic_compare_exchange_weak_explicit(&readers->first, &made->next, made, memory_order_release,
	                                              memory_order_acquire))
		;
	return &made->queries;
}
