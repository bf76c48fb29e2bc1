// SPDX-License-Identifier: MIT
// threads.h -- workers that share the blocks of a job.
#ifndef THREADS_H
#define THREADS_H
#include <stdbool.h>

#define MAX_WORKERS 64

typedef struct Threads Threads;

// Processes one of the blocks of a job, which are shares of its items.
typedef void BlockFunction(void* context, int block, int blocks);

// Starts workers - 1 threads; the caller of threads_run is worker 0. On failure returns null and sets the message.
Threads* threads_open(int workers);
void threads_close(Threads* t); // t may be null

int threads_workers(const Threads* t);

// Wakes the workers, which takes 50 us or more, and keeps them awake until threads_end. Jobs need not wait for that.
void threads_begin(Threads* t);
void threads_end(Threads* t);

// Processes blocks 0 to blocks - 1, at most as many as workers, and returns when all are done. Worker k processes block
// k, whose data its caches hold; if it sleeps or has no core, another worker does.
void threads_run(Threads* t, BlockFunction* function, void* context, int blocks);

// Does the same for a single job, with as many blocks as workers.
void threads_run_once(Threads* t, BlockFunction* function, void* context);

#endif
