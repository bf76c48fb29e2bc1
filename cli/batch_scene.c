// SPDX-License-Identifier: MIT
// batch_scene.c -- parts that bench --worlds and run --worlds share: which scenes a batch takes, and its definition.
#include "batch_scene.h"
#include "scene/between_steps.h"
#include <string.h>

bool batch_takes(const Options* options, const Scene* scene)
{
	const char* has = scene_between_steps(scene);
	if (has)
		fprintf(stderr, "%s %s: %s has %s, which the worlds of a batch cannot have\n", program_name, options->name,
		        scene->name, has);
	return !has;
}

Options batch_options(const Options* options)
{
	Options changed = *options;
	if (strcmp(options->device, "auto") == 0)
		changed.device = "cpu";
	return changed;
}

scree_batch_def batch_definition(const Options* options, scree_world** world)
{
	scree_batch_def def = scree_batch_def_default();
	def.worlds = options->worlds;
	def.templates = world;
	def.template_count = 1;
	def.device = options->device;
	def.threads = options->threads;
	def.lanes = options->lanes;
	def.allow_unequal_bits = options->allow_unequal_bits;
	return def;
}
