// SPDX-License-Identifier: MIT
// measurement.c -- collects the steps of several runs of a scene, checks them, and prints their row in the CSV of
// bench.
#include "measurement.h"
#include "csv.h"
#include <inttypes.h>

// Number of steps at the start of each run that are not measured, because kernels are built, buffers grow and threads
// start. A run of at most this number of steps is measured in full.
#define WARM_UP 2

void measurement_add(Measurement* m, const Record* record, int step)
{
	if (deepest(record, 1) > m->penetration)
		m->penetration = deepest(record, 1);
	m->nonfinite += record->counters.frozen_bodies > 0;
	if (step >= WARM_UP || m->steps <= WARM_UP)
		m->records[m->count++] = *record;
}

void measurement_end_run(Measurement* m, const scree_world* world, bool timings, uint64_t hash, uint64_t answers)
{
	if (m->runs == 0)
	{
		m->hash = m->other = hash;
		m->answers = m->other_answers = answers;
	}
	m->other = hash == m->hash ? m->other : hash;
	if (answers != m->answers)
		m->other_answers = answers;
	if (timings)
		m->staged = m->count - m->begin;
	else
	{
		double middle = median(m->records + m->begin, m->count - m->begin, step_of, 0);
		m->least = m->runs == 0 || middle < m->least ? middle : m->least;
		m->most = middle > m->most ? middle : m->most;
	}
	snprintf(m->device, sizeof m->device, "%s", scree_world_get_device(world));
	m->threads = scree_world_get_threads(world);
	m->lanes = scree_world_get_lanes(world);
	m->begin = m->count;
	++m->runs;
}

bool measurement_check(const Measurement* m, const Known* known, const Options* options, const char* settings)
{
	const char* name = m->scene->name;
	bool valid = true;
	if (m->nonfinite > 0)
	{
		fprintf(stderr, "%s bench: %s is invalid: bodies whose state was not finite were frozen in %d steps\n",
		        program_name, name, m->nonfinite);
		valid = false;
	}
	if (!(m->penetration <= m->scene->penetration_limit))
	{
		fprintf(stderr, "%s bench: %s is invalid: its deepest overlap is %g m, its penetration_limit %g\n",
		        program_name, name, (double)m->penetration, (double)m->scene->penetration_limit);
		valid = false;
	}
	if (m->other != m->hash)
	{
		fprintf(stderr,
		        "%s bench: %s is invalid: its hash was %016" PRIx64 " in one run and %016" PRIx64 " in another\n",
		        program_name, name, m->hash, m->other);
		valid = false;
	}
	if (m->other_answers != m->answers)
	{
		fprintf(stderr,
		        "%s bench: %s is invalid: the hash of its rays was %016" PRIx64 " in one run and %016" PRIx64
		        " in another\n",
		        program_name, name, m->answers, m->other_answers);
		valid = false;
	}
	return known_agrees(known, options->known, name, settings, m->steps, m->hash) && valid;
}

void measurement_print_heading(const char* const* stages)
{
	printf("scene,settings,device,threads,lanes,bodies,contacts,touching,colors,steps,ms_step,ms_least,ms_most");
	for (int k = 0; k < STAGE_TIMES; ++k)
		printf(",ms_%s", stages[k]);
	printf(",bytes_a_body,mb_constraints,mb_bodies,gbs_solve,gbs_copy,rays,ray_hits,ms_rays,hash_rays,penetration,hash,"
	       "valid\n");
}

void measurement_print(Measurement* m, const char* settings, bool valid)
{
	csv_cell(m->device);
	int count = m->count - m->staged;
	const Record* staged = m->records + count;
	const scree_counters* last = &m->records[count - 1].counters;
	printf("%s,%s,%s,%d,%d,%d,%.0f,%.0f,%.0f,%d", m->scene->name, settings, m->device, m->threads, m->lanes,
	       last->bodies, median(m->records, count, contacts_of, 0), median(m->records, count, touching_of, 0),
	       median(m->records, count, colors_of, 0), m->steps);
	printf(",%.4f,%.4f,%.4f", median(m->records, count, step_of, 0), m->least, m->most);
	for (int k = 0; k < STAGE_TIMES; ++k)
		printf(",%.4f", median(staged, m->staged, stage_of, k));
	printf(",%.0f,%.3f,%.3f,%.2f,%.2f", last->bodies > 0 ? (double)last->device_bytes / last->bodies : 0.0,
	       1e-6 * median(m->records, count, constraint_bytes_of, 0), 1e-6 * median(m->records, count, body_bytes_of, 0),
	       1e-9 * median(staged, m->staged, solve_rate_of, 0), 1e-9 * m->bandwidth);
	printf(",%d,%.0f,%.4f,%016" PRIx64, m->records[count - 1].rays, median(m->records, count, hits_of, 0),
	       median(m->records, count, scan_of, 0), m->answers);
	printf(",%.5f,%016" PRIx64 ",%d\n", (double)m->penetration, m->hash, valid);
	fflush(stdout);
}
