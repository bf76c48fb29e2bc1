// SPDX-License-Identifier: MIT
// readers.h -- lets several threads read a world on the CPU at the same time, between two calls that change it.
//
// The first thread that reads after a change uploads it, under a lock; the others then find a world that no reader changes. Each
// thread has its own results of queries. Every other call is alone in its world (scree.h, "Threads").
#ifndef READERS_H
#define READERS_H
#include "world/world.h"

// Allocates and releases the readers of a world. world->readers may be null at the end.
scree_status readers_open(scree_world* world, const char* function);
void readers_close(scree_world* world);

// Called before and after each call that other threads must not make at the same time.
void readers_enter(scree_world* world);
void readers_leave(scree_world* world);

// Returns whether several threads may read the world at the same time, because it is on the CPU. Otherwise such a call is made
// between readers_lock and readers_unlock. readers_lock returns false if this thread has the lock already.
bool readers_parallel(const scree_world* world);
bool readers_lock(scree_world* world);
void readers_unlock(scree_world* world, bool locked);

// Uploads all changes, as world_upload does, for a function that several threads may call.
scree_status readers_upload(scree_world* world);

typedef struct // a query in progress
{
	bool alone;  // true: the query has the whole world, and may use the workers; false: other threads may query it too
	bool locked; // true: readers_end unlocks the readers
} Reading;

// Returns Reading.alone. In a build for WebAssembly every query is alone (api_calls.h), and the code of searches is left out.
static inline bool reading_is_alone(const Reading* reading)
{
#ifdef SCREE_SMALL
	(void)reading;
	return true;
#else
	return reading->alone;
#endif
}

// Uploads all changes and prepares the boxes for queries, before `count` queries. Such a call ends with readers_end, if it does not
// fail. readers_alone gives it the whole world, if it lacks that.
scree_status readers_begin(scree_world* world, int count, Reading* reading);
void readers_alone(scree_world* world, Reading* reading);
void readers_end(scree_world* world, const Reading* reading);

// Prepares the world for queries; called by scree_world_prepare_queries.
scree_status readers_prepare(scree_world* world);

// Adds the time since `since` to that of the current step, for device "auto" (auto_clock).
void readers_count(scree_world* world, double since);

// Returns the query results of this thread, or those of the library while it makes queries itself. On failure sets the message and
// returns null.
Queries* readers_queries(scree_world* world, const char* function);

#endif
