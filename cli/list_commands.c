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

// Lists the devices. The caller frees the array. Returns null after a failure, with its exit code in *code.
static scree_device* list_devices(int* count, int* code)
{
	*count = 0;
	*code = EXIT_FAILED;
	scree_status status = scree_devices_get(NULL, 0, count);
	scree_device* devices = calloc((size_t)*count + 1, sizeof(scree_device));
	if (status == SCREE_OK && devices)
		status = scree_devices_get(devices, *count, count);
	if (status == SCREE_OK && devices)
		return devices;
	if (status != SCREE_OK)
		*code = report(status);
	free(devices);
	return NULL;
}

// Prints what is known about the bits of a device; OpenCL devices are compared with the CPU.
static void print_bits(const scree_device* d)
{
	if (!d->equal_bits)
		printf("  equal bits  no: %s\n", d->reason);
	else if (!d->tested)
		printf("  equal bits  not tested yet: the first world tests the device, or scree devices --test\n");
	else if (d->tested_results == 0)
		printf("  equal bits  yes\n");
	else
		printf("  equal bits  yes: tested by %d float results and %d worlds\n", d->tested_results, d->tested_worlds);
	if (d->tested_results > 0)
		printf("  denormals   %s\n  zeros       %s\n  rounding    of quotients and roots: by %s\n",
		       d->keeps_denormals ? "kept" : "flushed to zero",
		       d->keeps_zeros ? "with their signs" : "without a sign after operations with a constant 0",
		       d->own_rounding ? "integers" : "the device");
}

static void print_device(const scree_device* d)
{
	printf("%s\n  driver      %s\n  units       %d\n  memory      %.1f GiB\n", d->name, d->driver, d->compute_units,
	       (double)d->memory / (1 << 30));
	print_bits(d);
	printf("  drawing     %s\n", scree_sharing_name(d->sharing));
}

int devices_command(const Options* options)
{
	int count, code, end = EXIT_GOOD;
	scree_device* devices = list_devices(&count, &code);
	for (int k = 0; options->test && devices && k < count; ++k)
		if (report(scree_device_test(devices[k].name)) != EXIT_GOOD)
			end = EXIT_FAILED;
	if (options->test)
	{
		free(devices);
		devices = list_devices(&count, &code);
	}
	if (!devices)
		return code;
	for (int k = 0; k < count; ++k)
		print_device(&devices[k]);
	free(devices);
	const char* remedy = scree_opencl_hint();
	if (*remedy)
		printf("%s\n", remedy);
	return end;
}
