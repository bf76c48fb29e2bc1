// SPDX-License-Identifier: MIT
// list_commands.c -- scree scenes and scree devices: print the lists of scenes and devices.
#include "cli/common/library_error.h"
#include "commands.h"
#include "scene/find.h"
#include "scene/heading.h"
#include <stdlib.h>

int scenes_command(const Options* options)
{
	char** names;
	char missing[SCENE_SENTENCE];
	int count = scene_list(options->executable, &names, missing);
	int code = EXIT_GOOD;
	for (int k = 0; k < count; ++k)
	{
		char path[SCENE_PATH], sentence[SCENE_SENTENCE], title[160], parameters[256];
		if (options->names)
			printf("%s\n", names[k]);
		else if (scene_find(names[k], options->executable, path, sentence) &&
		         scene_heading(path, title, sizeof title, parameters, sizeof parameters, sentence))
			printf("%-12s %-64s %s\n", names[k], title, parameters);
		else
		{
			fprintf(stderr, "scree: %s\n", sentence);
			code = EXIT_BAD;
		}
		free(names[k]);
	}
	free(names);
	if (count == 0)
	{
		fprintf(stderr, "scree scenes: %s\n", missing);
		code = EXIT_FAILED;
	}
	return code;
}

int devices_command(const Options* options)
{
	(void)options;
	int count = 0;
	scree_status status = scree_devices_get(NULL, 0, &count);
	scree_device* devices = calloc((size_t)count + 1, sizeof(scree_device));
	if (status == SCREE_OK && devices)
		status = scree_devices_get(devices, count, &count);
	if (status != SCREE_OK || !devices)
	{
		free(devices);
		return devices ? report(status) : EXIT_FAILED;
	}
	for (int k = 0; k < count; ++k)
	{
		const scree_device* d = &devices[k];
		printf("%s\n  driver      %s\n  units       %d\n  memory      %.1f GiB\n  equal bits  %s%s\n  drawing     %s\n",
		       d->name, d->driver, d->compute_units, (double)d->memory / (1 << 30),
		       d->equal_bits ? "yes" : "no: ", d->reason, scree_sharing_name(d->sharing));
	}
	free(devices);
	const char* remedy = scree_opencl_hint();
	if (*remedy)
		printf("%s\n", remedy);
	return EXIT_GOOD;
}
