// SPDX-License-Identifier: MIT
// between_steps.c -- names what changes the world of a scene between its steps.
#include "scene/between_steps.h"
#include "scene/block.h"

const char* scene_between_steps(const Scene* scene)
{
	for (int k = 0; k < scene->block_count; ++k)
		if (scene->blocks[k].churn.moved + scene->blocks[k].churn.replaced > 0)
			return "churn";
	if (scene->blast_count > 0)
		return "explosions";
	return scene->character_count > 0 ? "characters" : scene->fan_count > 0 ? "rays" : NULL;
}
