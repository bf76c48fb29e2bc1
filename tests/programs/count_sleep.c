// SPDX-License-Identifier: MIT
// count_sleep.c -- counts the bodies of a world that fall asleep and wake, without a call that uploads changes.
#include "programs/program.h"
#include "world/objects/handles.h"
#include "world/world.h"
#include <stdlib.h>
#include <string.h>

void sleepers_count(Sleepers* s, scree_world* world, int* slept, int* woke)
{
	int used = world->bodies.used;
	int* sleep = read_items(world, POOL_sleep, used);
	if (used > s->slots)
	{
		s->sleepers = realloc(s->sleepers, (size_t)used * sizeof *s->sleepers);
		if (!s->sleepers)
			abort();
		memset(s->sleepers + s->slots, 0, (size_t)(used - s->slots) * sizeof *s->sleepers);
		s->slots = used;
	}
	for (int k = 0; k < used; ++k)
	{
		scree_body now = body_handle(world, k);
		bool same = s->sleepers[k].generation > 0 && scree_body_equals(s->sleepers[k], now);
		*slept += sleep[k] != 0 && !same;
		*woke += sleep[k] == 0 && same;
		s->sleepers[k] = sleep[k] ? now : (scree_body){0, 0};
	}
	free(sleep);
}

void sleepers_close(Sleepers* s)
{
	free(s->sleepers);
	*s = (Sleepers){0};
}
