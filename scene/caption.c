// SPDX-License-Identifier: MIT
// caption.c -- writes the caption of a picture. The caption follows the title.
#include "scene/caption.h"
#include <inttypes.h>

void device_text(const scree_world* world, char* text, size_t size)
{
	const char* name = scree_world_get_device(world);
	int threads = scree_world_get_threads(world), lanes = scree_world_get_lanes(world);
	if (threads > 0)
		snprintf(text, size, "%s (%d thread%s, %d lane%s)", name, threads, threads == 1 ? "" : "s", lanes,
		         lanes == 1 ? "" : "s");
	else
		snprintf(text, size, "%s", name);
}

void caption_text(const Scene* scene, const scree_world* world, const scree_counters* counters, char* text, size_t size)
{
	char device[192];
	device_text(world, device, sizeof device);
	snprintf(text, size, "%.2f s   %d bodies   %d contacts   %s", (double)counters->steps * (double)scene->dt,
	         counters->bodies, counters->contacts, device);
}

void caption_exact(const Scene* scene, const scree_world* world, const scree_counters* counters, uint64_t hash,
                   char* text, size_t size)
{
	int length = snprintf(text, size, "step %lld   hash %016" PRIx64 "   ", (long long)counters->steps, hash);
	if (length > 0 && (size_t)length < size)
		caption_text(scene, world, counters, text + length, size - (size_t)length);
}
