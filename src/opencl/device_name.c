// SPDX-License-Identifier: MIT
// device_name.c -- chooses an OpenCL device by a part of its name, and its number among devices of one name.
#include "opencl/device_name.h"
#include "platform/error.h"
#include <stdlib.h>
#include <string.h>

static char lower(char c) { return c >= 'A' && c <= 'Z' ? (char)(c + 'a' - 'A') : c; }

static bool has_part(const char* text, const char* part, size_t length)
{
	for (;; ++text)
	{
		size_t k = 0;
		while (k < length && lower(text[k]) == lower(part[k]))
			++k;
		if (k == length)
			return true;
		if (!*text)
			return false;
	}
}

// Returns the number at the end of a name such as "NVIDIA H200 #2", or -1. length: becomes that of the name without it.
static int number_at_end(const char* name, size_t* length)
{
	size_t end = strlen(name), digits = end;
	while (digits > 0 && name[digits - 1] >= '0' && name[digits - 1] <= '9')
		--digits;
	*length = end;
	if (digits == end || end - digits > 4 || digits == 0 || name[digits - 1] != '#')
		return -1;
	*length = digits - 1;
	while (*length > 0 && name[*length - 1] == ' ')
		--*length;
	return atoi(name + digits);
}

scree_status device_choose(const BackendOptions* options, Device* device)
{
	Device devices[MAX_DEVICES];
	int count = device_list(devices, MAX_DEVICES);
	if (count == 0)
		return fail(SCREE_ERROR_NO_DEVICE, "%s", device_hint(0));

	const char* part = options->device ? options->device : "";
	size_t length;
	int number = number_at_end(part, &length);
	const Device* best = NULL;
	int best_score = -1;
	for (int i = 0; i < count && i < MAX_DEVICES; ++i)
	{
		const Device* d = &devices[i];
		bool named = has_part(d->name, part, length);
		if (!named && !has_part(d->platform_name, part, length))
			continue;
		if (number >= 0 && d->number != number)
			continue;
		if (options->gpu && !(d->type & CL_DEVICE_TYPE_GPU))
			continue;
		bool allowed = d->about.equal_bits || (d->usable && options->allow_unequal_bits);
		bool whole = named && length == strlen(d->name);
		int score = 8 * allowed + 4 * whole + 2 * ((d->type & CL_DEVICE_TYPE_GPU) != 0) + d->about.equal_bits;
		if (score > best_score)
		{
			best = d;
			best_score = score;
		}
	}
	if (!best && options->gpu && !part[0])
		return fail(SCREE_ERROR_NO_DEVICE, "This machine has no OpenCL device that is a GPU.");
	if (!best)
		return fail(SCREE_ERROR_NO_DEVICE,
		            "No OpenCL device of this machine has \"%s\" in its name or in that of its driver, case ignored.",
		            part);
	if (!best->usable || (!best->about.equal_bits && !options->allow_unequal_bits))
		return fail(SCREE_ERROR_NO_DEVICE, "Device %s is refused: %s.", best->about.name, best->about.reason);
	*device = *best;
	return SCREE_OK;
}
