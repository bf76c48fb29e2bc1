// SPDX-License-Identifier: MIT
// paths.c -- keeps the slots of paths and the positions of their samples in the pool, and uploads paths. The host keeps
// a copy of samples. A new path takes the first gap that is large enough, so positions depend only on the user's calls.
#include "world/objects/paths.h"
#include "dialect/hash_word.h"
#include "platform/error.h"
#include "world/memory.h"
#include "world/objects/path_samples.h"
#include <math.h>

// Returns the position of the first gap for `count` samples, or the end of all samples. *before: set to 1 + index of
// the path before this position, 0 for none.
static int find_place(const scree_world* world, int count, int* before)
{
	int end = 0;
	*before = 0;
	if (world->sample_end - world->samples_used < count)
	{
		*before = world->last_path;
		return world->sample_end;
	}
	for (int path = world->first_path; path > 0; path = world->host_paths[path - 1].next)
	{
		const HostPath* host = world->host_paths + path - 1;
		if (host->first - end >= count)
			return end;
		end = host->first + host->segments + 1;
		*before = path;
	}
	return end;
}

static void link_path(scree_world* world, int index, int before)
{
	HostPath* host = world->host_paths + index;
	host->previous = before;
	host->next = before > 0 ? world->host_paths[before - 1].next : world->first_path;
	*(before > 0 ? &world->host_paths[before - 1].next : &world->first_path) = index + 1;
	*(host->next > 0 ? &world->host_paths[host->next - 1].previous : &world->last_path) = index + 1;
}

static void unlink_path(scree_world* world, int index)
{
	const HostPath* host = world->host_paths + index;
	*(host->previous > 0 ? &world->host_paths[host->previous - 1].next : &world->first_path) = host->next;
	*(host->next > 0 ? &world->host_paths[host->next - 1].previous : &world->last_path) = host->previous;
}

static void note_end(scree_world* world)
{
	const HostPath* last = world->host_paths + world->last_path - 1;
	world->sample_end = world->last_path > 0 ? last->first + last->segments + 1 : 0;
}

static scree_status reserve(scree_world* world, const char* function, int samples)
{
	Slots* slots = &world->paths;
	if (world->sample_end + samples > MAX_ITEMS)
		return fail(SCREE_ERROR_INVALID, "%s: %d more samples beside %d: the paths of a world have at most %d",
		            function, samples, world->sample_end, MAX_ITEMS);
	if (!slots_reserve(slots, 1))
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for one more path", function);
	TRY(GROW(function, world->host_paths, world->host_path_capacity, slots->capacity));
	return GROW(function, world->edits.paths, world->edits.path_capacity, slots->capacity);
}

static uint64_t name_of(const PathSample* samples, int count)
{
	const float* numbers = &samples->x;
	Word64 name = 0;
	for (int k = 0; k < count * (int)(sizeof *samples / sizeof *numbers); ++k)
		name = hash_float(name, numbers[k]);
	return name;
}

scree_status path_put(scree_world* world, const char* function, const scree_path_def* def, int* index)
{
	int segments = PATH_SHARES * path_spans(def->count, def->closed), before;
	TRY(reserve(world, function, segments + 1));
	double* work = scree_allocate(path_work(def->count) * sizeof *work);
	PathSample* samples = scree_allocate((size_t)(segments + 1) * sizeof *samples);
	if (!work || !samples)
	{
		scree_release(work);
		scree_release(samples);
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for a path of %d points", function, def->count);
	}
	path_sample(def->points, def->count, def->closed, work, samples);
	scree_release(work);
	*index = slots_allocate(&world->paths);
	HostPath* host = world->host_paths + *index;
	if (!host->waiting)
		world->edits.paths[world->edits.path_count++] = *index;
	int first = find_place(world, segments + 1, &before);
	*host = (HostPath){.first = first,
	                   .segments = segments,
	                   .samples = samples,
	                   .name = name_of(samples, segments + 1),
	                   .user = def->user,
	                   .waiting = true};
	link_path(world, *index, before);
	world->samples_used += segments + 1;
	note_end(world);
	return SCREE_OK;
}

void path_remove(scree_world* world, int index)
{
	HostPath* host = world->host_paths + index;
	unlink_path(world, index);
	world->samples_used -= host->segments + 1;
	note_end(world);
	scree_release(host->samples);
	host->samples = NULL;
	slots_free(&world->paths, index);
}

scree_pose path_pose_at(const scree_world* world, int index, float along)
{
	PathCurve curve = path_curve_of(world, index);
	double rest = along, length = curve.length;
	if (curve.closed)
		rest -= length * floor(rest / length);
	rest = rest < 0.0 ? 0.0 : rest > length ? length : rest;
	int segment = path_segment(&curve, (float)rest);
	const PathSample* from = curve.samples + segment;
	PathFoot foot = path_foot_at(&curve, segment, path_share(((float)rest - from->along) / from->length));
	return (scree_pose){{foot.point.x, foot.point.y}, {foot.tangent.x, foot.tangent.y}};
}

scree_status upload_paths(scree_world* world)
{
	Edits* p = &world->edits;
	Backend* b = world->backend;
	for (int k = 0; k < p->path_count; ++k)
	{
		const HostPath* host = world->host_paths + p->paths[k];
		int end = host->first + host->segments + 1;
		if (!slots_in_use(&world->paths, p->paths[k]))
			continue;
		TRY(b->f->write(b, POOL_path_sample, host->first, host->segments + 1, host->samples));
		p->sample_rows = end > p->sample_rows ? end : p->sample_rows;
	}
	return SCREE_OK;
}

void paths_close(scree_world* world)
{
	for (int k = 0; k < world->host_path_capacity; ++k)
		scree_release(world->host_paths[k].samples);
	slots_close(&world->paths);
	scree_release(world->host_paths);
}
