// SPDX-License-Identifier: MIT
// sleepers.c -- reads which bodies of a world are asleep, for pictures; uses only the public interface of Scree.
#include "scene/sleepers.h"
#include <stdlib.h>
#include <string.h>

scree_status sleepers_read(scree_world* world, scree_body* bodies, int count, bool** awake)
{
	scree_tuning tuning;
	int found = 0;
	scree_status status = scree_world_get_tuning(world, &tuning);
	if (status != SCREE_OK || !tuning.sleep)
	{
		free(*awake);
		*awake = NULL;
		return status;
	}
	if (!*awake)
		*awake = malloc((size_t)count + 1);
	if (!*awake)
		return SCREE_ERROR_OUT_OF_MEMORY;
	memset(*awake, true, (size_t)count);
	status = scree_world_get_bodies(world, bodies, count, &found);
	return status == SCREE_OK ? scree_bodies_get_awake(world, bodies, *awake, found < count ? found : count) : status;
}
