// SPDX-License-Identifier: MIT
// validate_command.c -- scree validate: experiments that check physical behavior against limits.
#include "cli/common/library_error.h"
#include "commands.h"
#include "validate/engine_scree.h"
#include "validate/validate.h"

static int list_experiments(void)
{
	for (int k = 0; k < validate_count; ++k)
		printf("%s\n", validate_experiments[k].name);
	return EXIT_GOOD;
}

// Creates a world with the options and destroys it, so that an error is printed before the rows of results. Returns an
// exit code.
static int try_device(const EngineOptions* options)
{
	scree_world_def def = scree_world_def_default();
	engine_set_device(&def, options);
	scree_world* world;
	int code = report(scree_world_create(&def, &world));
	scree_world_destroy(world);
	return code;
}

int validate_command(const Options* options)
{
	if (options->names)
		return list_experiments();
	for (int k = 0; k < options->argument_count; ++k)
	{
		if (!validate_find(options->arguments[k]))
		{
			fprintf(stderr, "scree validate: no experiment is called \"%s\"; scree validate --names lists them\n",
			        options->arguments[k]);
			return EXIT_BAD;
		}
	}
	Validation v = {.engine = &scree_engine,
	                .executable = options->executable,
	                .quick = options->quick,
	                .out = stdout,
	                .options = {.device = options->device,
	                            .threads = options->threads,
	                            .lanes = options->lanes,
	                            .allow_unequal_bits = options->allow_unequal_bits}};
	int code = try_device(&v.options);
	if (code != EXIT_GOOD)
		return code;
	bool good = true;
	validate_heading(stdout);
	for (int k = 0; k < (options->argument_count ? options->argument_count : validate_count) && !v.broken; ++k)
	{
		const Experiment* e = options->argument_count ? validate_find(options->arguments[k]) : &validate_experiments[k];
		good = validate_run(&v, e) && good;
	}
	return good ? EXIT_GOOD : EXIT_FAILED;
}
