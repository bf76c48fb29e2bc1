// SPDX-License-Identifier: MIT
// bench_scenes.c -- measures each scene several times, checks that its work was done, and prints a row of CSV.
//
// Timings of each kernel slow down a GPU. So the repeats run without timings and give ms_step. One more run with
// timings gives the times of the stages; its hash must be the same.
#include "bench_scenes.h"
#include "csv.h"
#include <stdlib.h>

typedef struct
{
	const Options* options;
	RunScene* run;
	Known known;
	char settings[256];
	double bandwidth; // copy bandwidth of the device, bytes/s; 0 until it has been measured
	bool invalid;     // true if any row is invalid
} Bench;

static int measure(Bench* bench, const Scene* scene)
{
	const Options* options = bench->options;
	Measurement m = {.scene = scene, .steps = options_steps(options, scene), .bandwidth = bench->bandwidth};
	m.records = malloc((size_t)m.steps * (size_t)(options->repeats + 1) * sizeof(Record));
	int code = m.records ? EXIT_GOOD : EXIT_FAILED;
	if (!m.records)
		fprintf(stderr, "%s bench: out of memory for %d steps\n", program_name, m.steps);
	for (int repeat = 0; repeat <= options->repeats && code == EXIT_GOOD; ++repeat)
		code = bench->run(options, repeat == options->repeats, &m);
	if (code == EXIT_GOOD)
	{
		bool valid = measurement_check(&m, &bench->known, options, bench->settings);
		measurement_print(&m, bench->settings, valid);
		bench->invalid = bench->invalid || !valid;
		bench->bandwidth = m.bandwidth;
	}
	free(m.records);
	return code;
}

int bench_scenes(const Options* options, const SceneList* list, const char* const* stages, RunScene* run)
{
	Bench bench = {.options = options, .run = run};
	int code = known_open(options->known, &bench.known);
	settings_text(options, bench.settings, sizeof bench.settings);
	if (code == EXIT_GOOD)
		measurement_print_heading(stages);
	for (int k = 0; k < list->count && code == EXIT_GOOD; ++k)
		code = measure(&bench, list->scenes[k]);
	known_close(&bench.known);
	return code == EXIT_GOOD && bench.invalid ? EXIT_FAILED : code;
}
