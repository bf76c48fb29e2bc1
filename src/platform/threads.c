// SPDX-License-Identifier: MIT
// threads.c -- implements workers that share the blocks of a job.
//
// The caller publishes a job as one word, the turn: the number of the job and the number of its blocks. Each worker
// claims and processes the block that has the worker's number. Soon after, idle workers claim the remaining blocks. So
// a worker that sleeps, or has lost its core, delays no other worker unless it has claimed a block. A claim contains
// the number of the job: a late worker finds all blocks of its job claimed, and continues with the current job. A
// similar method: Erin Catto, SIMD Matters, box2d.org, 2024.
//
// A waiting worker spins first, because a step has hundreds of jobs of about 1 us. Then it yields its core, because
// another worker may need the core on a busy machine; adapt_spins adapts the number of spins. After its yields a worker
// sleeps, but never between threads_begin and threads_end; threads_begin wakes it.
//
// With threads of the user, the first shared job after threads_begin is enqueued as a task for each other worker. A task
// serves this job and later ones, and returns at threads_end or after a long wait. No job waits for a task: worker 0
// processes each block that nobody has claimed. So the user's threads may run the tasks late, one after another, on the
// thread of worker 0, or not at all.
#include "platform/threads.h"
#include "platform/error.h"
#include "platform/processor.h"
#include "platform/system.h"
#include "platform/zones.h"
#include <stdatomic.h>
#include <stdint.h>

#define CACHE_LINE 64

// Number of pause instructions, 20 to 50 ns each, in a spin. If all workers run, a spin must take longer than a job. It
// must be shorter than a time slice, because a spinning worker may occupy the core of a working one.
#define SPINS        1000
#define FEWEST_SPINS 16
#define YIELDS       20 // number of yields after the spin, before the worker sleeps; its wake-up takes about 50 us
#define HELP_SPINS   40 // number of pause instructions before an idle worker claims blocks of late workers
#define WAKES        2  // number of workers that a worker wakes after its own wake-up
#define BLOCK_BITS   8  // lowest bits of a turn, which hold the number of blocks
#define TASK_YIELDS  20 // number of yields after the spin of a task, before the task returns

typedef struct
{
	Threads* threads;
	int worker;
	Thread thread;
	Mutex mutex;
	Condition woken;
	bool sleeps;                                // protected by mutex
	_Alignas(CACHE_LINE) atomic_ullong claimed; // number of the latest job that had its block of this seat claimed
} Seat;

struct Threads
{
	int workers, most_spins;
	BlockFunction* function;
	void* context;
	Seat seats[MAX_WORKERS];                  // seat 0 is that of the caller of threads_run, which never sleeps
	_Alignas(CACHE_LINE) atomic_ullong turn;  // number of the current job << BLOCK_BITS, plus number of its blocks
	_Alignas(CACHE_LINE) atomic_int done;     // number of finished blocks of the current job
	_Alignas(CACHE_LINE) atomic_int sleepers; // number of workers that sleep or are about to sleep
	_Alignas(CACHE_LINE) atomic_int spins;    // number of pause instructions in the next spin; rarely written
	atomic_bool awake;                        // true: no worker may fall asleep, and no task need return
	atomic_bool ends;
	// threads of the user
	scree_tasks tasks;      // enqueue is null: the workers are threads of the library
	bool enqueued;          // tasks were enqueued since threads_begin, and are not finished
	bool alone;             // worker 0 processes all later jobs until threads_end
	void* enqueued_task;    // result of scree_tasks.enqueue
	const char* caller;     // identifies the thread of worker 0
	atomic_int returned;    // number of tasks that have returned since they were enqueued
	atomic_int task_blocks; // number of blocks that these tasks have processed
};

static _Thread_local char this_thread; // its address identifies the thread

static void pause_core(void)
{
#if defined(__x86_64__) || defined(__i386__)
	__builtin_ia32_pause();
#elif defined(__aarch64__)
	__asm__ volatile("yield");
#elif defined(__wasm__)
	// WebAssembly has no pause instruction; these accesses to memory take about the same time
	for (volatile int k = 0; k < 8; ++k)
		;
#endif
}

// Adapts the number of pause instructions in later spins. at_once false (the job came after exactly one yield): lowers
// it, because workers share a core. at_once true: raises it, because workers run at the same time.
static void adapt_spins(Threads* t, int spins, bool at_once)
{
	int next = at_once ? spins + spins / 4 + 1 : spins - spins / 4;
	next = next < FEWEST_SPINS ? FEWEST_SPINS : next;
	next = next < t->most_spins ? next : t->most_spins;
	if (next != spins)
		atomic_store_explicit(&t->spins, next, memory_order_relaxed);
}

static bool wake(Seat* seat)
{
	mutex_lock(&seat->mutex);
	bool slept = seat->sleeps;
	seat->sleeps = false;
	condition_wake_all(&seat->woken);
	mutex_unlock(&seat->mutex);
	return slept;
}

static void wake_some(Threads* t)
{
	int left = WAKES;
	for (int k = 1; k < t->workers && left > 0 && atomic_load(&t->sleepers) > 0; ++k)
		left -= wake(&t->seats[k]);
}

// Puts the worker to sleep until another thread wakes it. All accesses are sequentially consistent: this worker adds
// itself to sleepers, then reads awake and the turn; the other thread sets one of these two, then reads sleepers. So at
// least one of the threads reads the change of the other.
static void sleep_until_woken(Seat* seat, unsigned long long turn)
{
	Threads* t = seat->threads;
	mutex_lock(&seat->mutex);
	seat->sleeps = true;
	atomic_fetch_add(&t->sleepers, 1);
	while (seat->sleeps && !atomic_load(&t->awake) && atomic_load(&t->turn) == turn)
		condition_wait(&seat->woken, &seat->mutex);
	bool woken = !seat->sleeps;
	seat->sleeps = false;
	atomic_fetch_sub(&t->sleepers, 1);
	mutex_unlock(&seat->mutex);
	if (woken)
		wake_some(t);
}

static bool spin(const Threads* t, unsigned long long turn, int spins)
{
	for (int k = 0; k < spins; ++k)
	{
		if (atomic_load_explicit(&t->turn, memory_order_acquire) != turn)
			return true;
		pause_core();
	}
	return false;
}

static void wait_for_turn(Seat* seat, unsigned long long turn)
{
	Threads* t = seat->threads;
	int spins = atomic_load_explicit(&t->spins, memory_order_relaxed);
	if (spin(t, turn, spins))
	{
		adapt_spins(t, spins, true);
		return;
	}
	for (int k = 0; k < YIELDS || atomic_load_explicit(&t->awake, memory_order_relaxed); ++k)
	{
		if (atomic_load_explicit(&t->turn, memory_order_acquire) != turn)
		{
			adapt_spins(t, spins, k != 1); // a job after exactly one yield: another worker needed this core
			return;
		}
		give_core_away();
	}
	sleep_until_woken(seat, turn);
}

static int blocks_of(unsigned long long turn) { return (int)(turn & ((1 << BLOCK_BITS) - 1)); }

// Claims and processes a block of a job, unless it is claimed. The data of the job exist until all blocks are done.
// Returns whether it has processed the block.
static bool try_block(Threads* t, unsigned long long turn, int block)
{
	unsigned long long job = turn >> BLOCK_BITS,
	                   last = atomic_load_explicit(&t->seats[block].claimed, memory_order_relaxed);
	if (last >= job || !atomic_compare_exchange_strong_explicit(&t->seats[block].claimed, &last, job,
	                                                            memory_order_acq_rel, memory_order_relaxed))
		return false;
	t->function(t->context, block, blocks_of(turn));
	atomic_fetch_add_explicit(&t->done, 1, memory_order_release);
	return true;
}

// Returns the number of blocks that it has processed.
static int help(Threads* t, unsigned long long turn, int worker)
{
	int blocks = blocks_of(turn), processed = 0;
	for (int k = 1; k <= blocks; ++k)
		processed += try_block(t, turn, (worker + k) % blocks);
	return processed;
}

// Waits for another job. Returns false if the task should return: after threads_end, or after a long wait.
static bool task_waits(const Threads* t, unsigned long long turn)
{
	if (spin(t, turn, atomic_load_explicit(&t->spins, memory_order_relaxed)))
		return true;
	for (int k = 0; k < TASK_YIELDS && atomic_load_explicit(&t->awake, memory_order_acquire); ++k)
	{
		if (atomic_load_explicit(&t->turn, memory_order_acquire) != turn)
			return true;
		give_core_away();
	}
	return false;
}

// A task for the user's threads. On the thread of worker 0 it processes all blocks of the current job and returns,
// because worker 0 cannot publish another job before that.
static void serve_jobs(int index, void* argument)
{
	Threads* t = argument;
	int worker = index + 1, processed = 0;
	bool on_caller = t->caller == &this_thread;
	ZONE_BEGIN(zone, "scree: task");
	FloatMode found = float_mode_enter();
	unsigned long long turn = atomic_load_explicit(&t->turn, memory_order_acquire);
	while (atomic_load_explicit(&t->awake, memory_order_acquire))
	{
		if (worker < blocks_of(turn))
			processed += try_block(t, turn, worker);
		if (on_caller || !spin(t, turn, HELP_SPINS))
			processed += help(t, turn, worker);
		if (on_caller || !task_waits(t, turn))
			break;
		turn = atomic_load_explicit(&t->turn, memory_order_acquire);
	}
	float_mode_leave(found);
	ZONE_END(zone);
	atomic_fetch_add(&t->task_blocks, processed);
	atomic_fetch_add(&t->returned, 1);
}

static void finish_tasks(Threads* t)
{
	FLOAT_MODE_HERE; // the call may run other work of the user, which changes the mode
	if (t->enqueued_task)
		t->tasks.finish(t->enqueued_task, t->tasks.context);
	t->enqueued_task = NULL;
	t->enqueued = false;
}

// Enqueues tasks for the published job, unless earlier tasks are still there to serve it. Tasks that have returned
// without work came too late, or run on the thread of worker 0; then no others follow until threads_end.
static void enqueue_tasks(Threads* t)
{
	FLOAT_MODE_HERE;
	int count = t->workers - 1;
	if (t->alone || (t->enqueued && atomic_load(&t->returned) < count))
		return;
	if (t->enqueued)
	{
		t->alone = atomic_load(&t->task_blocks) == 0;
		finish_tasks(t);
		if (t->alone)
			return;
	}
	atomic_store(&t->returned, 0);
	atomic_store(&t->task_blocks, 0);
	t->caller = &this_thread;
	t->enqueued = true;
	t->enqueued_task = t->tasks.enqueue(serve_jobs, t, count, t->tasks.context);
	// without a task to finish, all tasks have run within the call, or none will
	t->alone = !t->enqueued_task || atomic_load(&t->returned) == count;
}

static THREAD_RESULT thread_main(void* argument)
{
	Seat* seat = argument;
	Threads* t = seat->threads;
	unsigned long long turn = 0;
	(void)float_mode_enter(); // the thread keeps this mode until its end, because it belongs to the library
	while (!atomic_load(&t->ends))
	{
		wait_for_turn(seat, turn);
		turn = atomic_load_explicit(&t->turn, memory_order_acquire);
		if (seat->worker < blocks_of(turn))
			try_block(t, turn, seat->worker);
		if (!spin(t, turn, HELP_SPINS))
			help(t, turn, seat->worker);
	}
	return THREAD_END;
}

Threads* threads_open(int workers, const scree_tasks* tasks)
{
	Threads* t = scree_allocate(sizeof(Threads));
	if (!t)
	{
		fail(SCREE_ERROR_OUT_OF_MEMORY, "no memory for %d threads", workers);
		return NULL;
	}
	t->most_spins = workers > processor_cores() ? 0 : SPINS;
	atomic_init(&t->spins, t->most_spins);
	if (tasks)
		t->tasks = *tasks;
	t->workers = tasks ? workers : 1;
	for (; t->workers < workers; ++t->workers)
	{
		Seat* seat = &t->seats[t->workers];
		seat->threads = t;
		seat->worker = t->workers;
		mutex_open(&seat->mutex);
		condition_open(&seat->woken);
		if (thread_start(&seat->thread, thread_main, seat))
			continue;
		int started = t->workers;
		condition_close(&seat->woken);
		mutex_close(&seat->mutex);
		threads_close(t);
		fail(SCREE_ERROR_OUT_OF_MEMORY, "the system refuses to start thread %d of %d; create the world with fewer",
		     started + 1, workers);
		return NULL;
	}
	return t;
}

static unsigned long long publish(Threads* t, int blocks)
{
	unsigned long long turn = ((atomic_load_explicit(&t->turn, memory_order_relaxed) >> BLOCK_BITS) + 1) << BLOCK_BITS;
	atomic_store(&t->turn, turn | (unsigned long long)blocks);
	return turn | (unsigned long long)blocks;
}

void threads_close(Threads* t)
{
	if (!t)
		return;
	if (t->tasks.enqueue)
		t->workers = 1; // no seat has a thread
	atomic_store(&t->ends, true);
	publish(t, 0);
	for (int k = 1; k < t->workers; ++k)
		wake(&t->seats[k]);
	for (int k = 1; k < t->workers; ++k)
		thread_join(t->seats[k].thread);
	// all threads must end before any seat is closed, because a worker may be waking another worker
	for (int k = 1; k < t->workers; ++k)
	{
		condition_close(&t->seats[k].woken);
		mutex_close(&t->seats[k].mutex);
	}
	scree_release(t);
}

int threads_workers(const Threads* t) { return t->workers; }

void threads_begin(Threads* t)
{
	atomic_store(&t->awake, true);
	t->alone = false;
	if (atomic_load(&t->sleepers) > 0)
		wake_some(t);
}

void threads_end(Threads* t)
{
	atomic_store_explicit(&t->awake, false, memory_order_release);
	if (!t->enqueued)
		return;
	publish(t, 0); // ends the spins of tasks
	finish_tasks(t);
}

void threads_run_once(Threads* t, BlockFunction* function, void* context)
{
	threads_begin(t);
	threads_run(t, function, context, t->workers);
	threads_end(t);
}

void threads_run(Threads* t, BlockFunction* function, void* context, int blocks)
{
	if (blocks == 1)
	{
		function(context, 0, 1);
		return;
	}
	t->function = function;
	t->context = context;
	atomic_store_explicit(&t->done, 0, memory_order_relaxed);
	unsigned long long turn = publish(t, blocks);
	if (t->tasks.enqueue)
		enqueue_tasks(t);
	try_block(t, turn, 0);
	for (int k = 0; atomic_load_explicit(&t->done, memory_order_acquire) < blocks; ++k)
	{
		if (k == (t->alone ? 0 : HELP_SPINS))
			help(t, turn, 0);
		if (k < t->most_spins)
			pause_core();
		else
			give_core_away();
	}
}
