// SPDX-License-Identifier: MIT
// auto.c -- device "auto": a world begins on the CPU, and moves to the device on which its steps take less time. A
// thread opens the GPU when the time that the GPU may save in the expected steps exceeds the time to open it. A trial
// measures a few steps on the other device. The next one begins when the world has worked many times as long as the
// last trial took. Both devices compute the same bits, so measured times may decide.
#include "world/device/auto.h"
#include "platform/error.h"
#include "platform/processor.h"
#include "world/device/devices.h"
#include "world/device/migrate.h"
#include "world/device/open_async.h"
#include "world/failure.h"
#include "world/world.h"
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// A world is expected to make HORIZON more steps, or as many more as it has already made if that number is larger.
#define HORIZON 500

// ms: assumed minimum time of a step on a GPU. An H200 takes 0.13 ms for 10,000 boxes (scene pyramids) or fewer.
#define LEAST_STEP 0.15

// ms: assumed time of a step on one thread per body, before one is measured; n threads take 1/n of it. It is less than
// the measured time of any scene (pyramids on 16 threads: 5e-4), so only very large worlds open the GPU before step 1.
#define BODY_STEP 4e-4

// ms: assumed time to open a GPU. An idle machine with an H200 and a cached program takes 215 to 235 ms.
#define OPENING 230

#define MOVE_SPEED 4e6 // bytes per ms: assumed speed of copying a world, less than that of the bus of any fast GPU

// Number of steps of a trial. The time of the first step is ignored, because the caches are cold. A trial ends early
// when it has taken longer than TRIAL_LIMIT steps on the previous device.
#define TRIAL_STEPS 4
#define TRIAL_LIMIT 20

// The next trial begins when the world has worked PATIENCE times as long as the last trial took. LIKELY_PATIENCE times
// suffice if a step on the other device is predicted to take less than LIKELY of the present time. Each consecutive
// failed trial, up to MOST_FAILURES, doubles the delay, unless the work has doubled or halved since the last one.
#define PATIENCE        100
#define LIKELY_PATIENCE 20
#define LIKELY          0.8 // fraction of the time of a step on the present device
#define MOST_FAILURES   10

static atomic_int async_open_milliseconds = OPENING; // last measured time to open a GPU in this process

double auto_clock(void) { return processor_milliseconds(); }

void auto_count(scree_world* world, double since) { world->auto_device.current += processor_milliseconds() - since; }

static int work_of(const scree_world* world)
{
	const Counters* c = &world->pipeline.counters;
	return 1 + world->bodies.alive + c->alive;
}

static void meter_note(StepMeter* m, double milliseconds)
{
	m->recent[m->count % RECENT_STEPS] = milliseconds;
	++m->count;
}

static int compare_times(const void* a, const void* b)
{
	double x = *(const double*)a, y = *(const double*)b;
	return (x > y) - (x < y);
}

// ms: Returns a quantile of the times of the last steps; the mean would change with each step that other work delays.
// share: 0 for the shortest time, 0.5 for the median. Ignores the first step after a move, unless it is the only one.
static double meter_step(const StepMeter* m, double share)
{
	double sorted[RECENT_STEPS];
	int count = m->count < RECENT_STEPS ? m->count : RECENT_STEPS;
	int first = m->count <= RECENT_STEPS && count > 1;
	memcpy(sorted, m->recent + first, sizeof(double) * (size_t)(count - first));
	qsort(sorted, (size_t)(count - first), sizeof *sorted, compare_times);
	return sorted[(int)(share * (double)(count - first - 1))];
}

#define MEDIAN   0.5
#define SHORTEST 0.0

static StepMeter* meter_of(scree_world* world, const Backend* b) { return &world->auto_device.meters[b->distant]; }

// ms: Returns an assumed lower bound of the time of a step on a device that has not been measured.
static double least_step(const scree_world* world, const Backend* b)
{
	return b->distant ? LEAST_STEP : BODY_STEP * world->bodies.alive / b->threads;
}

// ms: Returns the predicted time of a step on the other device: the last measured time, on a CPU in proportion to the
// number of bodies and contacts. Returns least_step() before the first measurement.
static double predicted_step(scree_world* world)
{
	const Backend* other = world->auto_device.other;
	const StepMeter* m = meter_of(world, other);
	if (m->step <= 0.0)
		return least_step(world, other);
	return other->distant ? m->step : m->step * work_of(world) / m->work;
}

static double steps_to_come(const scree_world* world)
{
	int64_t taken = world->pipeline.steps;
	return (double)(taken > HORIZON ? taken : HORIZON);
}

static bool opening_pays(scree_world* world)
{
	const StepMeter* m = meter_of(world, world->backend);
	if (m->count % RECENT_STEPS != 0)
		return false;
	double step = m->count > 0 ? meter_step(m, SHORTEST) : least_step(world, world->backend);
	return steps_to_come(world) * (step - LEAST_STEP) > atomic_load(&async_open_milliseconds);
}

static void spare_core(scree_world* world, bool core)
{
	Backend* b = world->backend;
	if (b->f->spare)
		b->f->spare(b, core);
}

static void take_opened(scree_world* world)
{
	AutoDevice* a = &world->auto_device;
	double milliseconds;
	spare_core(world, false);
	scree_status status = async_open_end(a->opening, &a->other, &milliseconds);
	a->opening = NULL;
	if (status == SCREE_OK)
	{
		atomic_store(&async_open_milliseconds, (int)milliseconds + 1);
		return;
	}
	a->alone = true;
	log_sentence(status == SCREE_ERROR_NO_DEVICE ? SCREE_LOG_INFO : SCREE_LOG_WARNING,
	             "scree_world_step: the world stays on the CPU: %s", scree_error());
}

static bool trial_pays(scree_world* world)
{
	AutoDevice* a = &world->auto_device;
	const Backend *here = world->backend, *there = a->other;
	const StepMeter* m = meter_of(world, here);
	if (m->count < RECENT_STEPS || a->spent < LIKELY_PATIENCE * a->cost)
		return false;
	// needs memory for three such worlds: a world may grow, and a step that runs out of memory cannot be undone
	if (there->memory > 0 && 3 * here->bytes > there->memory)
		return false;
	double step = meter_step(m, MEDIAN), predicted = predicted_step(world);
	if (a->cost <= 0.0)
		return a->named[0] || steps_to_come(world) * (step - predicted) > 2.0 * (double)here->bytes / MOVE_SPEED;
	int work = work_of(world);
	bool another = work > 2 * a->failures_work || work < a->failures_work / 2;
	double patience = predicted < LIKELY * step ? LIKELY_PATIENCE : PATIENCE;
	return a->spent > patience * a->cost * (double)(1 << (another ? 0 : a->failures));
}

static bool change_over(scree_world* world)
{
	AutoDevice* a = &world->auto_device;
	Backend* from = world->backend;
	scree_status status = world_move(world, a->other);
	if (status == SCREE_OK)
	{
		a->other = from;
		meter_of(world, world->backend)->count = 0;
		return true;
	}
	if (!world->broken)
		log_sentence(SCREE_LOG_WARNING, "scree_world_step: the world stays on %s: %s", world->device, scree_error());
	a->other->f->close(a->other);
	a->other = NULL;
	a->alone = true;
	return false;
}

static void begin_trial(scree_world* world)
{
	AutoDevice* a = &world->auto_device;
	StepMeter* m = meter_of(world, world->backend);
	m->step = meter_step(m, MEDIAN);
	m->work = work_of(world);
	a->started = auto_clock();
	a->trial = change_over(world);
}

static void end_trial(scree_world* world)
{
	AutoDevice* a = &world->auto_device;
	StepMeter *here = meter_of(world, world->backend), *before = meter_of(world, a->other);
	here->step = meter_step(here, MEDIAN);
	here->work = work_of(world);
	a->trial = false;
	bool faster = here->step < before->step;
	const char *to = world->backend->name, *from = a->other->name;
	log_sentence(SCREE_LOG_INFO, "scree_world_step: %s %s: %.4f ms a step, and %.4f ms on %s",
	             faster ? "the world moves to" : "the world does not stay on", to, here->step, before->step, from);
	a->failures = faster ? 0 : a->failures < MOST_FAILURES ? a->failures + 1 : MOST_FAILURES;
	a->failures_work = here->work;
	if (!faster)
		change_over(world);
	a->cost = auto_clock() - a->started;
	a->spent = 0.0;
}

static bool trial_is_over(scree_world* world)
{
	const AutoDevice* a = &world->auto_device;
	const StepMeter *here = meter_of(world, world->backend), *before = meter_of(world, a->other);
	return here->count >= TRIAL_STEPS || (here->count > 0 && auto_clock() - a->started > TRIAL_LIMIT * before->step);
}

bool auto_is_cpu(const scree_world* world)
{
	const char* named = getenv("SCREE_AUTO");
	// a thread that opens a GPU, or that of a driver, is none of the user's pool
	return world->def.tasks || (named && strcmp(named, "cpu") == 0);
}

void auto_open(scree_world* world, TestWorlds* test)
{
	AutoDevice* a = &world->auto_device;
	if (a->on)
		return;
	*a = (AutoDevice){.on = true, .test = test};
	const char* named = getenv("SCREE_AUTO");
	if (named)
		snprintf(a->named, sizeof a->named, "%s", named);
	a->alone = auto_is_cpu(world);
	if (a->alone || !world->backend->distant)
		return;
	scree_world_def def = world->def;
	def.device = "cpu";
	a->alone = device_open(&def, a->test, &a->other) != SCREE_OK;
}

void auto_close(scree_world* world)
{
	AutoDevice* a = &world->auto_device;
	double milliseconds;
	if (a->opening)
	{
		spare_core(world, false);
		async_open_end(a->opening, &a->other, &milliseconds);
	}
	if (a->other)
		a->other->f->close(a->other);
	*a = (AutoDevice){0};
}

bool auto_choose(scree_world* world)
{
	AutoDevice* a = &world->auto_device;
	if (!a->on || a->alone)
		return false;
	if (world->pipeline.rested) // the last step was skipped, so its time is no measure of a device
	{
		a->current = 0.0;
		return false;
	}
	if (world->pipeline.steps > 0)
		meter_note(meter_of(world, world->backend), a->current);
	a->spent += a->current;
	a->current = 0.0;

	if (!a->other && !a->opening && (a->named[0] || opening_pays(world)))
	{
		a->opening = async_open_begin(&world->def, a->named[0] ? a->named : NULL, a->test);
		a->alone = !a->opening;
		spare_core(world, !a->alone);
	}
	if (a->opening && (a->named[0] || async_open_done(a->opening)))
		take_opened(world);
	return a->trial ? trial_is_over(world) : a->other && trial_pays(world);
}

scree_status auto_change(scree_world* world)
{
	if (world->auto_device.trial)
		end_trial(world);
	else
		begin_trial(world);
	return world->broken; // with the message of the failed move
}
