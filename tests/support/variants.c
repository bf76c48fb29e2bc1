// SPDX-License-Identifier: MIT
// variants.c -- lists the devices, numbers of threads and lanes, and forms of the solve on which a world must have the
// same bits.
#include "support/variants.h"
#include "platform/processor.h"
#include "support/form_names.h"
#include <stdio.h>
#include <string.h>

static int add_variant(Variant variants[MAX_VARIANTS], int count, const char* device, int threads, int lanes,
                       SolveForm form)
{
	if (count == MAX_VARIANTS)
		return count;
	Variant* variant = variants + count;
	*variant = (Variant){.threads = threads, .lanes = lanes, .form = form};
	snprintf(variant->device, sizeof variant->device, "%.127s", device);
	if (threads > 0)
		snprintf(variant->name, sizeof variant->name, "%d thread%s, %d lane%s", threads, threads > 1 ? "s" : "", lanes,
		         lanes > 1 ? "s" : "");
	else
		snprintf(variant->name, sizeof variant->name, "%.127s, solver: %s", device, solve_form_names[form]);
	return count + 1;
}

static int add_moving_variant(Variant variants[MAX_VARIANTS], int count, const char* device)
{
	if (count == MAX_VARIANTS)
		return count;
	Variant* variant = variants + count;
	*variant = (Variant){.device = "cpu", .threads = 2};
	snprintf(variant->other, sizeof variant->other, "%.127s", device);
	snprintf(variant->name, sizeof variant->name, "between cpu and %.127s", device);
	return count + 1;
}

int list_variants(Variant variants[MAX_VARIANTS])
{
	int count = 0;
	for (int threads = 1; threads <= 2; ++threads)
		for (int lanes = 1; lanes <= 16; lanes *= 2)
			if (lanes != 2 && processor_has_lanes(lanes) && !(quick() && threads == 1 && lanes > 1))
				count = add_variant(variants, count, "cpu", threads, lanes, FORM_ANY);

	scree_device devices[MAX_VARIANTS];
	int found;
	OK(scree_devices_get(devices, MAX_VARIANTS, &found));
	for (int k = 0; k < found && k < MAX_VARIANTS; ++k)
	{
		if (strcmp(devices[k].name, "cpu") == 0 || !devices[k].equal_bits)
			continue;
		static const SolveForm forms[] = {FORM_LAUNCHES, FORM_RELAY, FORM_TILES};
		for (int i = 0; i < 3; ++i)
			count = add_variant(variants, count, devices[k].name, 0, 0, forms[i]);
		count = add_moving_variant(variants, count, devices[k].name);
	}
	return count;
}

void print_variants(void)
{
	Variant variants[MAX_VARIANTS];
	int count = list_variants(variants);
	for (int k = 0; k < count; ++k)
		print_message("variant %d: %s\n", k, variants[k].name);
	if (scree_opencl_hint()[0])
		print_message("no OpenCL: %s\n", scree_opencl_hint());
}

bool variant_is_due(const Variant* variants, int count, int k, int round)
{
	int first = 0;
	while (first < count && variants[first].threads > 0 && !variants[first].other[0])
		++first;
	return !quick() || k < first || k - first == round % (count - first);
}

scree_world* open_variant(const Variant* variant, const scree_world_def* given)
{
	scree_world_def def = *given;
	def.device = variant->device;
	def.threads = variant->threads;
	def.lanes = variant->lanes;
	solve_form_setting = variant->form;
	scree_world* world;
	scree_status status = scree_world_create(&def, &world);
	solve_form_setting = FORM_ANY;
	if (status != SCREE_OK)
		fail_msg("%s: %s", variant->name, scree_error());
	return world;
}

scree_world* open_default_variant(const Variant* variant)
{
	scree_world_def def = scree_world_def_default();
	return open_variant(variant, &def);
}
