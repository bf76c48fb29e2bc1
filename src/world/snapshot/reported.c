// SPDX-License-Identifier: MIT
// reported.c -- keeps the poses that the user has read last while a world goes back to another state.
#include "world/snapshot/reported.h"
#include "platform/error.h"
#include "world/device/lasting.h"
#include <string.h>

int reported_items(const scree_world* world)
{
	int bodies = lasting_items(world, PER_BODY);
	size_t bytes = (sizeof(Float4) + sizeof(int)) * (size_t)bodies, unit = pool_info[POOL_saved].bytes;
	return world->pipeline.tells ? (int)((bytes + unit - 1) / unit) : 0;
}

static scree_status copy(Backend* b, const Reported* r, int bodies, bool back)
{
	TRY(b->f->keep(b, POOL_reported_pose, 0, bodies, r->at, back));
	return b->f->keep(b, POOL_reported_sleep, 0, bodies, r->at + r->bodies, back);
}

scree_status reported_take(scree_world* world, const char* function, bool same, Reported* r)
{
	r->bodies = lasting_items(world, PER_BODY);
	r->used = world->bodies.used;
	r->unit = world->def.length_unit;
	if (!same)
	{
		size_t bytes = sizeof *r->generation * (size_t)r->used;
		r->generation = scree_allocate(bytes + 1);
		if (!r->generation)
			return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory to load a save", function);
		memcpy(r->generation, world->bodies.generation, bytes);
	}
	return copy(world->backend, r, r->bodies, false);
}

scree_status reported_return(scree_world* world, const Reported* r)
{
	Backend* b = world->backend;
	int bodies = lasting_items(world, PER_BODY), both = bodies < r->bodies ? bodies : r->bodies;
	int used = world->bodies.used < r->used ? world->bodies.used : r->used;
	both = r->unit == world->def.length_unit ? both : 0;
	world->pipeline.tells = true;
	TRY(copy(b, r, both, true));
	if (bodies > both)
		TRY(b->f->clear(b, POOL_reported_pose, both, bodies - both));
	for (int k = 0, end; r->generation && k < used; k = end + 1)
	{
		for (end = k; end < used && r->generation[end] != world->bodies.generation[end];)
			++end;
		if (end > k)
			TRY(b->f->clear(b, POOL_reported_pose, k, end - k));
	}
	return SCREE_OK;
}

void reported_close(Reported* r) { scree_release(r->generation); }

scree_status reported_keep(scree_world* world, scree_world* made, Float4* poses, int* sleeps)
{
	Backend* b = world->backend;
	const Slots *then = &world->bodies, *now = &made->bodies;
	int bodies = lasting_items(made, PER_BODY), before = lasting_items(world, PER_BODY);
	int both = bodies < before ? bodies : before;
	made->pipeline.tells = world->pipeline.tells;
	if (!poses)
		return SCREE_OK;
	memset(poses, 0, sizeof *poses * (size_t)bodies);
	if (!world->pipeline.tells || made->def.length_unit != world->def.length_unit)
		return SCREE_OK;
	TRY(b->f->read(b, POOL_reported_pose, 0, both, poses));
	TRY(b->f->read(b, POOL_reported_sleep, 0, both, sleeps));
	for (int k = 0; k < both; ++k)
		if (k >= then->used || k >= now->used || then->generation[k] != now->generation[k])
			poses[k] = make_float4(0.0f, 0.0f, 0.0f, 0.0f);
	return SCREE_OK;
}
