// SPDX-License-Identifier: MIT
// hash_worlds.c -- scree hash --worlds: steps copies of a scene with random inputs in a batch, and sums their hashes.
#include "hash_worlds.h"
#include "batch_scene.h"
#include "cli/common/library_error.h"
#include "scene/wall_inputs.h"
#include <stdlib.h>

static int take_steps(const Options* options, const Scene* scene, scree_batch* batch, WallInputs* inputs)
{
	scree_status status = SCREE_OK;
	int steps = options_steps(options, scene);
	for (int step = 0; step < steps && status == SCREE_OK; ++step)
	{
		wall_inputs_draw(inputs, batch, step, scene->dt);
		status = scree_batch_step(batch, scene->dt, scene->substeps, 1);
	}
	return report(status);
}

// Binds the inputs to the bodies or motors of the template.
static int bind_inputs(const Options* options, scree_world* world, scree_batch* batch, WallInputs* inputs)
{
	char sentence[SCENE_SENTENCE] = "out of memory for the bodies";
	int count = 0, code = report(scree_world_get_bodies(world, NULL, 0, &count));
	scree_body* bodies = malloc(((size_t)count + 1) * sizeof *bodies);
	if (code == EXIT_GOOD && bodies)
		code = report(scree_world_get_bodies(world, bodies, count, &count));
	if (code == EXIT_GOOD && (!bodies || !wall_inputs_bind(inputs, batch, world, bodies, count, sentence)))
	{
		fprintf(stderr, "%s %s: %s\n", program_name, options->name, sentence);
		code = EXIT_FAILED;
	}
	free(bodies);
	return code;
}

int hash_worlds(const Options* options, const ScenePlayer* player, uint64_t* sum)
{
	scree_batch* batch;
	scree_world* world = player->world;
	WallInputs inputs = {0};
	scree_batch_def def = batch_definition(options, &world);
	int code = report(scree_batch_create(&def, &batch));
	if (code == EXIT_GOOD)
		code = bind_inputs(options, world, batch, &inputs);
	if (code == EXIT_GOOD)
		code = take_steps(options, player->scene, batch, &inputs);
	if (code == EXIT_GOOD)
		code = report(wall_sum(batch, sum));
	wall_inputs_close(&inputs);
	scree_batch_destroy(batch);
	return code;
}
