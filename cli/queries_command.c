// SPDX-License-Identifier: MIT
// queries_command.c -- scree bench queries: measures batches of rays, moving circles, overlaps and nearest points at
// the end of a run.
#include "cli/common/csv.h"
#include "cli/common/library_error.h"
#include "cli/common/open_scene.h"
#include "cli/common/step_record.h"
#include "commands.h"
#include "scene/load.h"
#include "tools/common/byte_hash.h"
#include "tools/common/clock.h"
#include "tools/common/median.h"
#include "tools/common/random_numbers.h"
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define MANY   1000000 // default of --queries
#define LENGTH 20.0f   // m: length of a ray
#define RADIUS 0.5f    // m: radius of a circle

typedef enum
{
	RAYS,
	ANY_RAYS,
	CIRCLES,
	OVERLAPS,
	NEAREST,
	KINDS
} Kind;
static const char* const names[KINDS] = {"rays", "any_rays", "circle_casts", "overlaps", "nearest"};

typedef struct
{
	scree_world* world;
	int count;
	scree_ray* rays;
	scree_probe* probes;
	scree_query_result* found;
	scree_shape circle;
} Batch;

// Computes the box around the positions of all bodies. Returns false if there are no bodies, or on failure.
static bool bounds(scree_world* world, scree_vec* low, scree_vec* high)
{
	int count = 0;
	if (scree_world_get_states(world, NULL, NULL, 0, &count) != SCREE_OK || count == 0)
		return false;
	scree_body_state* states = malloc((size_t)count * sizeof *states);
	bool good = states && scree_world_get_states(world, NULL, states, count, &count) == SCREE_OK;
	for (int k = 0; good && k < count; ++k)
	{
		scree_vec at = states[k].pose.position;
		*low = k == 0 ? at : (scree_vec){fminf(low->x, at.x), fminf(low->y, at.y)};
		*high = k == 0 ? at : (scree_vec){fmaxf(high->x, at.x), fmaxf(high->y, at.y)};
	}
	free(states);
	return good;
}

static bool fill(Batch* batch)
{
	scree_vec low = {0.0f, 0.0f}, high = low;
	uint64_t seed = 1;
	if (!bounds(batch->world, &low, &high) || scree_shape_make_circle((scree_vec){0}, RADIUS, &batch->circle))
		return false;
	for (int k = 0; k < batch->count; ++k)
	{
		scree_vec at = {knuth_between(&seed, low.x, high.x), knuth_between(&seed, low.y, high.y)};
		scree_rot turn = scree_rot_make(knuth_between(&seed, -3.14f, 3.14f));
		scree_vec path = {LENGTH * turn.c, LENGTH * turn.s};
		batch->rays[k] = (scree_ray){.origin = at, .translation = path};
		batch->probes[k] = (scree_probe){.pose = {at, turn}, .translation = path};
	}
	return true;
}

static scree_status ask(Batch* b, Kind kind, int* found, uint64_t* hash)
{
	scree_query_def def = scree_query_def_default();
	scree_status status;
	scree_query_results list = {.results = b->found, .count = b->count};
	def.any = kind == ANY_RAYS;
	if (kind <= ANY_RAYS)
		status = scree_world_cast_rays(b->world, &def, b->rays, b->count, b->found);
	else if (kind == CIRCLES)
		status = scree_world_cast_shapes(b->world, &def, &b->circle, b->probes, b->count, b->found);
	else if (kind == OVERLAPS)
		status = scree_world_list_shapes(b->world, &def, &b->circle, b->probes, b->count, &list);
	else
		status = scree_world_find_nearest(b->world, &def, NULL, b->probes, b->count, LENGTH, b->found);
	if (!hash || status != SCREE_OK)
		return status;
	*found = 0;
	*hash = hash_bytes(HASH_BEGIN, list.results, (size_t)list.count * sizeof *list.results);
	for (int k = 0; k < list.count; ++k)
		*found += list.results[k].hit;
	return status;
}

// Executes a batch of queries `repeats` times and prints the median times. A first execution, which is not measured,
// allocates memory; its results are hashed.
static scree_status measure(Batch* batch, Kind kind, const char* scene, int repeats, double* times[2])
{
	int found = 0;
	uint64_t hash = 0;
	for (int k = 0; kind >= OVERLAPS && k < batch->count; ++k)
		batch->probes[k].translation = (scree_vec){0.0f, 0.0f};
	scree_status status = ask(batch, kind, &found, &hash);
	for (int k = 0; k < repeats && status == SCREE_OK; ++k)
	{
		scree_timings timings = {0};
		double begin = seconds_now();
		status = ask(batch, kind, NULL, NULL);
		times[0][k] = 1e3 * (seconds_now() - begin);
		if (status == SCREE_OK)
			status = scree_world_get_timings(batch->world, &timings);
		times[1][k] = (double)timings.queries;
	}
	if (status != SCREE_OK)
		return status;
	char device[160];
	snprintf(device, sizeof device, "%s", scree_world_get_device(batch->world));
	csv_cell(device);
	printf("%s,%s,%d,%s,%d,%d,%.4f,%.4f,%016" PRIx64 "\n", scene, device, scree_world_get_threads(batch->world),
	       names[kind], batch->count, found, median_of(times[0], repeats), median_of(times[1], repeats), hash);
	fflush(stdout);
	return SCREE_OK;
}

int queries_command(const Options* options)
{
	Scene* scene = open_scene(options, options->arguments[0]);
	ScenePlayer player;
	if (!scene)
		return EXIT_BAD;
	int code = open_player(options, scene, true, &player);
	if (code != EXIT_GOOD)
	{
		scene_free(scene);
		return code;
	}
	int steps = options_steps(options, scene), repeats = options->repeats;
	scree_status status = SCREE_OK;
	for (int k = 0; k < steps && status == SCREE_OK; ++k)
		status = player_step(&player);
	Batch batch = {.world = player.world, .count = options->queries > 0 ? options->queries : MANY};
	size_t count = (size_t)batch.count;
	batch.rays = malloc(count * sizeof *batch.rays);
	batch.probes = malloc(count * sizeof *batch.probes);
	batch.found = malloc(count * sizeof *batch.found);
	double* times[2] = {malloc((size_t)repeats * sizeof(double)), malloc((size_t)repeats * sizeof(double))};
	if (status == SCREE_OK && (!batch.rays || !batch.probes || !batch.found || !times[0] || !times[1] || !fill(&batch)))
	{
		fprintf(stderr, "scree bench: no memory for %d queries, or the scene has no bodies\n", batch.count);
		code = EXIT_FAILED;
	}
	else
		printf("scene,device,threads,query,queries,found,ms,ms_device,hash\n");
	for (int kind = 0; kind < KINDS && code == EXIT_GOOD && status == SCREE_OK; ++kind)
		status = measure(&batch, (Kind)kind, scene->name, repeats, times);
	if (code == EXIT_GOOD)
		code = report(status);
	free(batch.rays);
	free(batch.probes);
	free(batch.found);
	free(times[0]);
	free(times[1]);
	player_close(&player);
	scene_free(scene);
	return code;
}
