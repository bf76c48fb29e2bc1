// SPDX-License-Identifier: MIT
// threads.h -- workers that run one function together, and a barrier between them.
#ifndef THREADS_H
#define THREADS_H
#include <stdbool.h>

#define MAX_WORKERS 64

typedef struct Threads Threads;
typedef void WorkerFunction(void* context, int worker, int workers);

// Starts workers - 1 threads, so none for 1; the caller of threads_run is worker 0. Null, with the error's sentence set,
// when that cannot be done.
Threads* threads_open(int workers);
void threads_close(Threads* t); // null is allowed

int threads_workers(const Threads* t);

// Runs function(context, worker, workers) on all workers at once and returns when all have returned.
void threads_run(Threads* t, WorkerFunction* function, void* context);

// The barrier, for use inside of threads_run. Worker 0 gets true when all have arrived, may do what must be done alone, and
// calls threads_release; only then do the others get false. It is always the same one, for what is done alone has its
// data in the caches of the core that did it the last time.
bool threads_gather(Threads* t, int worker);
void threads_release(Threads* t);

// The barrier with nothing to do alone.
void threads_barrier(Threads* t);

#endif
