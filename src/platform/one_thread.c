// SPDX-License-Identifier: MIT
// one_thread.c -- implements threads.h on a platform without threads: the caller processes all blocks.
#include "platform/error.h"
#include "platform/threads.h"

struct Threads
{
	char unused;
};

Threads* threads_open(int workers, const scree_tasks* tasks)
{
	static Threads alone;
	(void)tasks;
	if (workers == 1)
		return &alone;
	fail(SCREE_ERROR_OUT_OF_MEMORY, "threads is %d, must be 1 in a build without threads", workers);
	return NULL;
}

void threads_close(Threads* t) { (void)t; }
void threads_begin(Threads* t) { (void)t; }
void threads_end(Threads* t) { (void)t; }

int threads_workers(const Threads* t)
{
	(void)t;
	return 1;
}

void threads_run(Threads* t, BlockFunction* function, void* context, int blocks)
{
	(void)t;
	(void)blocks; // at most the number of workers, which is 1
	function(context, 0, 1);
}

void threads_run_once(Threads* t, BlockFunction* function, void* context) { threads_run(t, function, context, 1); }
