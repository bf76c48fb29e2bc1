// SPDX-License-Identifier: MIT
// player.c -- the scene player: fills a world with a scene, and applies churn, characters and keys before each step.
#include "scene/player.h"
#include "platform/processor.h"
#include "scene/build.h"
#include "scene/churn.h"
#include "scene/controls.h"
#include "tools/common/clock.h"

scree_status player_fill(ScenePlayer* player, const Scene* scene, scree_world* world)
{
	FLOAT_MODE_HERE;
	*player = (ScenePlayer){.scene = scene, .world = world};
	double begin = seconds_now();
	scree_status status = scene_build(scene, world);
	player->building = seconds_now() - begin;
	return status == SCREE_OK ? characters_open(&player->characters, scene, world) : status;
}

scree_status player_open(ScenePlayer* player, const Scene* scene, const scree_world_def* def)
{
	FLOAT_MODE_HERE;
	*player = (ScenePlayer){0};
	double begin = seconds_now();
	scree_status status = scree_world_create(def, &player->world);
	double opening = seconds_now() - begin;
	if (status == SCREE_OK)
		status = player_fill(player, scene, player->world);
	player->opening = opening;
	player->owns = true;
	return status;
}

void player_close(ScenePlayer* player)
{
	scan_close(&player->scan);
	characters_close(&player->characters);
	if (player->owns)
		scree_world_destroy(player->world);
	*player = (ScenePlayer){0};
}

scree_status player_change(ScenePlayer* player)
{
	FLOAT_MODE_HERE;
	scree_status status = scene_churn(player->scene, player->world, player->steps);
	if (status == SCREE_OK)
		status = characters_move(&player->characters, player->world, player->steps, player->down);
	return status == SCREE_OK ? controls_apply(player->scene, player->world, player->down) : status;
}

scree_status player_advance(ScenePlayer* player)
{
	FLOAT_MODE_HERE;
	scree_status status = scree_world_step(player->world, player->scene->dt, player->scene->substeps);
	player->steps += status == SCREE_OK;
	return status;
}

scree_status player_step(ScenePlayer* player)
{
	scree_status status = player_change(player);
	return status == SCREE_OK ? player_advance(player) : status;
}

scree_status player_scan(ScenePlayer* player)
{
	FLOAT_MODE_HERE;
	if (player->scene->fan_count == 0)
		return SCREE_OK;
	scree_status status = player->scan.scene ? SCREE_OK : scan_open(&player->scan, player->scene, player->world);
	if (status == SCREE_OK)
		status = scan_aim(&player->scan, player->world, NULL, 0);
	double begin = seconds_now();
	if (status == SCREE_OK)
		status = scan_cast(&player->scan, player->world);
	player->scanning = seconds_now() - begin;
	if (status == SCREE_OK)
		scan_add(&player->scan, &player->answered);
	return status;
}

uint32_t player_keys(const Scene* scene) { return controls_keys(scene) | characters_keys(scene); }
