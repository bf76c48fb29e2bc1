// SPDX-License-Identifier: MIT
// bench_whole.c -- scree bench --whole: measures runs from end to end, including the time to open the device.
//
// Nothing is read back between the steps, and the clock stops when the device has finished the last one. For exact
// results each run needs a separate process (--repeats 1), because a process starts a driver only once.
#include "bench_whole.h"
#include "cli/common/library_error.h"
#include "cli/common/open_scene.h"
#include "tools/common/clock.h"
#include <inttypes.h>

static scree_status take_steps(ScenePlayer* player, int steps)
{
	for (int step = 0; step < steps; ++step)
	{
		scree_status status = player_step(player);
		if (status != SCREE_OK)
			return status;
	}
	return scree_world_wait(player->world);
}

static int measure_once(const Options* options, const Scene* scene)
{
	ScenePlayer player;
	int steps = options_steps(options, scene);
	int code = open_player(options, scene, false, &player);
	if (code != EXIT_GOOD)
		return code;
	scree_counters counters;
	uint64_t hash;
	double begin = seconds_now();
	scree_status status = take_steps(&player, steps);
	double taken = seconds_now() - begin;
	if (status == SCREE_OK)
		status = scree_world_get_counters(player.world, &counters);
	if (status == SCREE_OK)
		status = scree_world_get_hash(player.world, &hash);
	if (status == SCREE_OK)
		printf("%s,%s,%s,%d,%d,%.1f,%.1f,%.1f,%.1f,%.5f,%016" PRIx64 "\n", scene->name, options->device,
		       scree_world_get_device(player.world), counters.bodies, steps, 1e3 * player.opening,
		       1e3 * player.building, 1e3 * taken, 1e3 * (player.opening + taken), (double)counters.penetration, hash);
	fflush(stdout);
	player_close(&player);
	return report(status);
}

int measure_whole_runs(const Options* options, Scene** scenes, int count)
{
	printf("scene,device,device_at_end,bodies,steps,ms_open,ms_build,ms_steps,ms_wait,penetration,hash\n");
	int code = EXIT_GOOD;
	for (int k = 0; k < count && code == EXIT_GOOD; ++k)
		for (int repeat = 0; repeat < options->repeats && code == EXIT_GOOD; ++repeat)
			code = measure_once(options, scenes[k]);
	return code;
}
