// SPDX-License-Identifier: MIT
// peer_validate.c -- scree_peers validate: makes the experiments of scree validate with both engines.
#include "peer_validate.h"
#include "engine_box2d.h"
#include "process.h"
#include "validate/engine_scree.h"
#include "validate/validate.h"
#include <getopt.h>
#include <stdlib.h>
#include <string.h>

static const char* const help = "usage: scree_peers validate [OPTION]... [NAME]...\n"
                                "\n"
                                "Makes the experiments of scree validate, all without a name, with both engines; CSV "
                                "on standard output. Limits are\n"
                                "Scree's: a row of Box2D beyond them is marked, but is no failure.\n"
                                "\n"
                                "  -e, --engine NAME   scree or box2d alone\n"
                                "  -q, --quick         fewer and shorter runs\n"
                                "  -t, --threads N     threads of both, 1 without it\n"
                                "  -d, --device NAME   where Scree runs, cpu without it\n"
                                "  -h, --help          this text\n";

static const struct option words_known[] = {
    {"engine", required_argument, NULL, 'e'},  {"quick", no_argument, NULL, 'q'},
    {"threads", required_argument, NULL, 't'}, {"device", required_argument, NULL, 'd'},
    {"help", no_argument, NULL, 'h'},          {0},
};

static const Engine* const engines[2] = {&scree_engine, &box2d_engine};

static bool read_option(int letter, Validation* v, bool* left_out)
{
	switch (letter)
	{
	case 'e':
		left_out[0] = strcmp(optarg, scree_engine.name) != 0;
		left_out[1] = strcmp(optarg, box2d_engine.name) != 0;
		if (left_out[0] && left_out[1])
			fprintf(stderr, "scree_peers validate: --engine %s: must be scree or box2d\n", optarg);
		return !(left_out[0] && left_out[1]);
	case 'q':
		v->quick = true;
		return true;
	case 't':
		v->options.threads = atoi(optarg);
		if (v->options.threads < 1 || v->options.threads > 64)
			fprintf(stderr, "scree_peers validate: --threads %s: must be a whole number from 1 to 64\n", optarg);
		return v->options.threads >= 1 && v->options.threads <= 64;
	case 'd':
		v->options.device = optarg;
		return true;
	case 'h':
		printf("%s", help);
		exit(EXIT_GOOD);
	default:
		return false;
	}
}

int validate_peers(int count, char** words, const char* executable)
{
	Validation v = {
	    .executable = executable, .out = stdout, .options = {.device = "cpu", .threads = 1, .continuous = true}};
	bool left_out[2] = {false, false};
	for (int letter; (letter = getopt_long(count, words, "e:qt:d:h", words_known, NULL)) != -1;)
	{
		if (!read_option(letter, &v, left_out))
			return EXIT_BAD;
	}
	for (int k = optind; k < count; ++k)
	{
		if (!validate_find(words[k]))
		{
			fprintf(stderr, "scree_peers validate: no experiment is called \"%s\"\n", words[k]);
			return EXIT_BAD;
		}
	}
	validate_heading(stdout);
	bool good = true;
	for (int k = 0; k < (optind < count ? count - optind : validate_count); ++k)
	{
		const Experiment* e = optind < count ? validate_find(words[optind + k]) : &validate_experiments[k];
		for (int side = 0; side < 2 && !v.broken; ++side)
		{
			v.engine = engines[side];
			bool passed = left_out[side] || validate_run(&v, e);
			good = good && (passed || side == 1);
		}
	}
	return good && !v.broken ? EXIT_GOOD : EXIT_FAILED;
}
