// SPDX-License-Identifier: MIT
// threads.h -- workers that do the blocks of a job together.
#ifndef THREADS_H
#define THREADS_H
#include <stdbool.h>

#define MAX_WORKERS 64

typedef struct Threads Threads;

// Does one block of a job. The number of blocks is given as well, because a block is a share of the items of a job.
typedef void BlockFunction(void* context, int block, int blocks);

// Starts workers - 1 threads, so none for 1; the caller of threads_run is worker 0. Null, with the error's sentence set,
// when that cannot be done.
Threads* threads_open(int workers);
void threads_close(Threads* t); // null is allowed

int threads_workers(const Threads* t);

// Wakes the workers, which takes them 50 us and more, and keeps them awake until threads_end. Jobs need not wait for that.
void threads_begin(Threads* t);
void threads_end(Threads* t);

// Does blocks 0 to blocks - 1, at most as many as workers, each once, and returns when all are done. Block k is done by worker k, whose
// caches have its data from the job before; but if worker k sleeps or has no core, by another one.
void threads_run(Threads* t, BlockFunction* function, void* context, int blocks);

// The same of one job, with as many blocks as workers.
void threads_run_once(Threads* t, BlockFunction* function, void* context);

#endif
