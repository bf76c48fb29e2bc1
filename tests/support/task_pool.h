// SPDX-License-Identifier: MIT
// task_pool.h -- pools of threads of a program, for scree_world_def.tasks: a plain one, and some that are hard to serve.
#ifndef TASK_POOL_H
#define TASK_POOL_H
#include "platform/system.h"
#include "scree/scree.h"
#include <stdbool.h>

#define POOL_THREADS 8

typedef enum
{
	POOL_PLAIN,    // threads take tasks from a list, at the same time
	POOL_BLOCKING, // the same, but enqueue returns after the tasks, which may run one after another
	POOL_AT_ONCE,  // enqueue calls the tasks one after another on the calling thread, and returns null
	POOL_LATE,     // finish calls the tasks on the calling thread
	POOL_REFUSING, // enqueue returns null, and calls nothing
	POOL_KINDS
} PoolKind;

typedef struct TaskPool
{
	PoolKind kind;
	Mutex mutex;
	Condition changed;
	Thread threads[POOL_THREADS];
	int thread_count;
	scree_task* task; // the task that was enqueued and is not finished; at most one
	void* argument;
	int count, next, done; // number of calls: all, begun, returned
	bool ends;
	int enqueued, finished, calls; // totals
} TaskPool;

// Opens a pool. threads: 0 to POOL_THREADS, unused by kinds that call tasks on the calling thread.
void pool_open(TaskPool* pool, PoolKind kind, int threads);
void pool_close(TaskPool* pool);

// Returns the functions of a pool. The pool must outlive its worlds.
scree_tasks pool_tasks(TaskPool* pool);

#endif
