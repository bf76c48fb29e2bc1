// SPDX-License-Identifier: MIT
// batch_run.h -- resets, pauses, saves, loads, takes out and puts back worlds of a batch at random, for tests.
#ifndef BATCH_RUN_H
#define BATCH_RUN_H
#include "support/batch_worlds.h"

#define MOST_WORLDS 30 // maximum number of worlds of a batch

typedef struct // a batch, and what left it
{
	scree_batch* batch;
	const Templates* t;
	int worlds, template_of[MOST_WORLDS], ages[MOST_WORLDS];
	uint8_t paused[MOST_WORLDS];
	char* row;
	int row_template, row_age;
	scree_world* taken;
	int taken_template, taken_age;
} BatchRun;

static inline void reset_some(BatchRun* r)
{
	uint8_t mask[MOST_WORLDS];
	for (int k = 0; k < r->worlds; ++k)
	{
		mask[k] = r->ages[k] == AGES || random_below(15) == 0;
		r->ages[k] = mask[k] ? 0 : r->ages[k];
		r->paused[k] = mask[k] ? 0 : r->paused[k];
	}
	OK(scree_batch_reset(r->batch, mask));
}

static inline void pause_some(BatchRun* r)
{
	for (int k = 0; k < r->worlds; ++k)
		r->paused[k] = random_below(4) == 0;
	OK(scree_batch_pause(r->batch, r->paused));
}

// Saves a world, or loads the state of an earlier call into a world of the same template.
static inline void move_row(BatchRun* r)
{
	int32_t world = random_below(r->worlds);
	size_t bytes = scree_batch_get_state_bytes(r->batch);
	if (!r->row || random_below(2))
	{
		free(r->row);
		r->row = malloc(bytes);
		OK(scree_batch_save(r->batch, &world, 1, r->row, bytes));
		r->row_template = r->template_of[world];
		r->row_age = r->ages[world];
	}
	else if (r->template_of[world] == r->row_template)
	{
		OK(scree_batch_load(r->batch, &world, 1, r->row, 0));
		r->ages[world] = r->row_age;
	}
}

// Takes a world out, or puts it back into a world of the same template.
static inline void take(BatchRun* r)
{
	int world = random_below(r->worlds);
	if (!r->taken)
	{
		OK(scree_batch_extract(r->batch, world, NULL, &r->taken));
		r->taken_template = r->template_of[world];
		r->taken_age = r->ages[world];
	}
	else if (r->template_of[world] == r->taken_template)
	{
		OK(scree_batch_insert(r->batch, world, r->taken));
		r->ages[world] = r->taken_age;
		scree_world_destroy(r->taken);
		r->taken = NULL;
	}
}

static inline void step_run(BatchRun* r, const char* name)
{
	OK(scree_batch_step(r->batch, r->t->dt, r->t->substeps, 1));
	for (int k = 0; k < r->worlds; ++k)
		r->ages[k] += !r->paused[k];
	if (!r->taken)
		return;
	if (r->taken_age < AGES)
	{
		OK(scree_world_step(r->taken, r->t->dt, r->t->substeps));
		++r->taken_age;
	}
	if (hash_of(r->taken) != r->t->hashes[r->taken_template][r->taken_age])
		fail_msg("%s: a world that was taken out, of template %d, age %d, differs", name, r->taken_template,
		         r->taken_age);
}

// Steps a batch, and compares all worlds with their templates, which record_alone has stepped. Closes the batch.
static inline void run_at_random(BatchRun* r, int steps, const char* name)
{
	for (int step = 0; step < steps; ++step)
	{
		reset_some(r);
		if (random_below(3) == 0)
			pause_some(r);
		if (random_below(2))
			move_row(r);
		if (random_below(2))
			take(r);
		check_hashes(r->batch, r->t, r->template_of, r->ages, name);
		step_run(r, name);
	}
	check_hashes(r->batch, r->t, r->template_of, r->ages, name);
	free(r->row);
	scree_world_destroy(r->taken);
	scree_batch_destroy(r->batch);
}

#endif
