// SPDX-License-Identifier: MIT
// task_pool.c -- pools of threads of a program, for scree_world_def.tasks: a plain one, and some that are hard to serve.
#include "support/task_pool.h"
#include "support/checks.h"

// Begins the next call of the task, with the mutex locked, which it unlocks meanwhile. Returns false if all calls have begun.
static bool call_next(TaskPool* pool)
{
	if (!pool->task || pool->next == pool->count)
		return false;
	int index = pool->next++;
	mutex_unlock(&pool->mutex);
	pool->task(index, pool->argument);
	mutex_lock(&pool->mutex);
	++pool->calls;
	if (++pool->done == pool->count)
		condition_wake_all(&pool->changed);
	return true;
}

static THREAD_RESULT pool_main(void* argument)
{
	TaskPool* pool = argument;
	mutex_lock(&pool->mutex);
	while (!pool->ends)
		if (!call_next(pool))
			condition_wait(&pool->changed, &pool->mutex);
	mutex_unlock(&pool->mutex);
	return THREAD_END;
}

static void wait_for_all(TaskPool* pool)
{
	while (pool->done < pool->count)
		condition_wait(&pool->changed, &pool->mutex);
	pool->task = NULL;
}

static void* enqueue(scree_task* task, void* argument, int count, void* context)
{
	TaskPool* pool = context;
	++pool->enqueued;
	assert_true(count >= 1);
	if (pool->kind == POOL_REFUSING)
		return NULL;
	mutex_lock(&pool->mutex);
	assert_null(pool->task);
	pool->task = task;
	pool->argument = argument;
	pool->count = count;
	pool->next = pool->done = 0;
	condition_wake_all(&pool->changed);
	if (pool->kind == POOL_AT_ONCE)
		while (call_next(pool))
			;
	if (pool->kind == POOL_AT_ONCE || pool->kind == POOL_BLOCKING)
		wait_for_all(pool);
	mutex_unlock(&pool->mutex);
	return pool->kind == POOL_AT_ONCE ? NULL : pool;
}

static void finish(void* enqueued, void* context)
{
	TaskPool* pool = context;
	assert_ptr_equal(enqueued, pool);
	++pool->finished;
	mutex_lock(&pool->mutex);
	while (call_next(pool)) // the calling thread runs the calls that have not begun
		;
	wait_for_all(pool);
	mutex_unlock(&pool->mutex);
}

void pool_open(TaskPool* pool, PoolKind kind, int threads)
{
	*pool = (TaskPool){.kind = kind, .thread_count = kind <= POOL_BLOCKING ? threads : 0};
	mutex_open(&pool->mutex);
	condition_open(&pool->changed);
	for (int k = 0; k < pool->thread_count; ++k)
		assert_true(thread_start(&pool->threads[k], pool_main, pool));
}

void pool_close(TaskPool* pool)
{
	mutex_lock(&pool->mutex);
	pool->ends = true;
	condition_wake_all(&pool->changed);
	mutex_unlock(&pool->mutex);
	for (int k = 0; k < pool->thread_count; ++k)
		thread_join(pool->threads[k]);
	condition_close(&pool->changed);
	mutex_close(&pool->mutex);
}

scree_tasks pool_tasks(TaskPool* pool) { return (scree_tasks){.enqueue = enqueue, .finish = finish, .context = pool}; }
