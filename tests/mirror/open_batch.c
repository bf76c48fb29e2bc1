// SPDX-License-Identifier: MIT
// open_batch.c -- makes templates and a batch of them, and opens it again from clones of its worlds.
#include "batch/batch.h"
#include "mirror/mirrored.h"
#include "platform/processor.h"
#include "step/bay_layout.h"
#include <stdlib.h>
#include <string.h>

scree_world* clone_alone(scree_world* world)
{
	scree_world_def def = scree_world_def_default();
	scree_world* clone;
	def.device = "cpu";
	def.threads = 1;
	must(scree_world_clone(world, &def, &clone));
	return clone;
}

static int any_worlds(uint64_t* dice)
{
	int many = one_in(dice, 4) ? 20 + random_below(dice, MOST_WORLDS - 20) : 2 + random_below(dice, 8);
	return one_in(dice, 4) ? 1 + random_below(dice, 2) : many;
}

static int any_lanes(Mirror* m)
{
	int one = one_in(&m->dice, 2) ? 1 : 4, lanes = one_in(&m->dice, 2) ? 0 : one;
	lanes = m->setting.lanes > 0 ? m->setting.lanes : lanes;
	return processor_has_lanes(lanes) ? lanes : 0;
}

// Creates a batch with random threads, lanes, blocks and places, which change no bit.
static scree_status create(Mirror* m, int worlds, scree_world** templates, int count, scree_batch** batch)
{
	scree_batch_def def = scree_batch_def_default();
	def.worlds = worlds;
	def.templates = templates;
	def.template_count = count;
	def.device = m->setting.device;
	def.threads = 1 + random_below(&m->dice, 2);
	def.lanes = any_lanes(m);
	def.other_templates = m->varied;
	def.contact_limit = m->contact_limit;
	def.timings = one_in(&m->dice, 4);
	batch_parts_setting = random_below(&m->dice, 3);
	bays_tight_setting = one_in(&m->dice, 2);
	scree_status status = scree_batch_create(&def, batch);
	batch_parts_setting = 0;
	bays_tight_setting = false;
	m->counts->batches += status == SCREE_OK;
	return status;
}

static void source_read(Source* t, scree_world* world, int origin)
{
	objects_list(&t->objects, world);
	must(scree_world_get_gravity(world, &t->gravity));
	t->origin = origin;
}

// Gives each world the state of its template, and a mirror.
static void begin_worlds(Mirror* m)
{
	m->pulled = false;
	for (int k = 0; k < m->worlds; ++k)
	{
		m->template_of[k] = m->next_of[k] = k % m->template_count;
		m->paused[k] = 0;
		m->gravity[k] = m->templates[m->template_of[k]].gravity;
		m->alone[k] = clone_alone(m->templates[m->template_of[k]].world);
	}
	memset(m->lists, 0, sizeof m->lists);
}

// Lets the worlds that were templates go on, change or end, which changes no world of the batch.
static void leave_templates(Mirror* m, scree_world** given)
{
	for (int k = 0; k < m->template_count; ++k)
	{
		const Objects* o = &m->templates[k].objects;
		if (one_in(&m->dice, 2))
		{
			attempt(scree_world_step(given[k], 1.0f / 60.0f, 4));
			must(scree_world_set_gravity(given[k], (scree_vec){1.0f, 2.0f}));
			if (o->body_count > 0)
				must(scree_body_destroy(given[k], o->bodies[0]));
		}
		scree_world_destroy(given[k]);
	}
}

bool batch_open(Mirror* m)
{
	scree_world* given[MOST_TEMPLATES];
	uint64_t* dice = &m->dice;
	bool same_tuning = one_in(dice, 2);
	m->varied = one_in(dice, 2) && same_tuning;
	m->template_count = 1 + random_below(dice, MOST_TEMPLATES);
	m->worlds = any_worlds(dice);
	int limit = one_in(dice, 3) ? 1 : 1 + random_below(dice, 30);
	m->contact_limit = one_in(dice, 5) ? limit : 0;
	bool early = one_in(dice, 2); // a clone before the creation of the batch lacks the chains that the creation finds
	note(m, "create %d worlds of %d templates, at most %d contacts", m->worlds, m->template_count, m->contact_limit);
	for (int k = 0; k < m->template_count; ++k)
	{
		given[k] = hostile_world(random_word(dice), same_tuning);
		m->templates[k].world = early ? clone_alone(given[k]) : NULL;
		source_read(m->templates + k, given[k], k);
	}
	scree_status status = create(m, m->worlds, given, m->template_count, &m->batch);
	if (status == SCREE_ERROR_INVALID && m->contact_limit > 0) // the templates have more contacts
	{
		m->contact_limit = 0;
		status = create(m, m->worlds, given, m->template_count, &m->batch);
	}
	for (int k = 0; k < m->template_count && !early; ++k)
		m->templates[k].world = clone_alone(given[k]);
	leave_templates(m, given);
	if (status != SCREE_OK)
		return status == SCREE_ERROR_INVALID ? end_early(m) : needed(m, status, "scree_batch_create");
	begin_worlds(m);
	return compare_worlds(m);
}

// Makes templates of some worlds, taken out of the batch or cloned.
static bool take_templates(Mirror* m, Source* next, int count)
{
	for (int k = 0; k < count; ++k)
	{
		int from = random_below(&m->dice, m->worlds);
		if (one_in(&m->dice, 2))
			NEED(m, scree_batch_extract(m->batch, from, NULL, &next[k].world));
		else
			next[k].world = clone_alone(m->alone[from]);
		source_read(next + k, next[k].world, m->templates[m->template_of[from]].origin);
	}
	return true;
}

static void close_sources(Source* templates, int count)
{
	for (int k = 0; k < count; ++k)
		scree_world_destroy(templates[k].world);
}

static void close_worlds(Mirror* m)
{
	scree_batch_destroy(m->batch);
	for (int k = 0; k < m->worlds; ++k)
		scree_world_destroy(m->alone[k]);
	close_sources(m->templates, m->template_count);
}

bool batch_reopen(Mirror* m)
{
	Source next[MOST_TEMPLATES] = {{.world = NULL}};
	scree_world* given[MOST_TEMPLATES];
	scree_batch* batch = NULL;
	int most = m->worlds < MOST_TEMPLATES ? m->worlds : MOST_TEMPLATES, count = 1 + random_below(&m->dice, most);
	int worlds = any_worlds(&m->dice);
	note(m, "create %d worlds of %d of the worlds", worlds, count);
	bool taken = take_templates(m, next, count);
	for (int k = 0; k < count; ++k)
		given[k] = next[k].world;
	scree_status status = taken ? create(m, worlds, given, count, &batch) : SCREE_ERROR_INVALID;
	if (status != SCREE_OK) // the batch stays
	{
		close_sources(next, count);
		return taken && (status == SCREE_ERROR_INVALID || needed(m, status, "scree_batch_create"));
	}
	close_worlds(m);
	memcpy(m->templates, next, sizeof next);
	m->batch = batch;
	m->worlds = worlds;
	m->template_count = count;
	begin_worlds(m);
	return compare_worlds(m);
}

void batch_close(Mirror* m)
{
	close_worlds(m);
	scree_world_destroy(m->bank.world);
	free(m->bank.state);
}
