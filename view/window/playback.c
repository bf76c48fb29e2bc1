// SPDX-License-Identifier: MIT
// playback.c -- the recording in the viewer: opens a file, and repeats its steps in a world.
#include "view/window/playback.h"
#include "scene/clean_text.h"
#include <errno.h>
#include <stdlib.h>
#include <string.h>

#define FIRST_DT       (1.0f / 60.0f) // s: duration of the picture before the first step, whose length is not known yet
#define FIRST_SUBSTEPS 4

// Returns a scene without bodies.
static Scene* make_scene(const Playback* playback, const char* path, char* sentence)
{
	Scene* scene = calloc(1, sizeof *scene);
	if (!scene)
	{
		snprintf(sentence, SENTENCE, "no memory for %.400s", path);
		return NULL;
	}
	const char* slash = strrchr(path, '/');
	scene->world = scree_world_def_default();
	scene->dt = FIRST_DT;
	scene->substeps = FIRST_SUBSTEPS;
	snprintf(scene->name, sizeof scene->name, "%.63s", slash ? slash + 1 : path);
	clean_text(scene->name);
	snprintf(scene->title, sizeof scene->title, "%s, a recording of %lld steps by version %s", scene->name,
	         (long long)playback->info.steps, playback->info.version);
	clean_text(scene->title);
	return scene;
}

Scene* playback_open(Playback* playback, const char* path, char* sentence)
{
	*playback = (Playback){0};
	if (!whole_file_read(path, &playback->file))
	{
		snprintf(sentence, SENTENCE, "cannot read %.400s: %s", path, strerror(errno));
		return NULL;
	}
	scree_status status = scree_replay_open(playback->file.bytes, playback->file.size, &playback->replay);
	if (status == SCREE_OK)
		status = scree_replay_get_info(playback->replay, &playback->info);
	if (status == SCREE_OK)
		return make_scene(playback, path, sentence);
	snprintf(sentence, SENTENCE, "%.200s: %s", path, scree_error());
	return NULL;
}

void playback_close(Playback* playback)
{
	scree_replay_close(playback->replay);
	free(playback->file.bytes);
	*playback = (Playback){0};
}

scree_status playback_create_world(Playback* playback, const Scene* scene, const scree_world_def* def,
                                   ScenePlayer* player)
{
	*player = (ScenePlayer){.scene = scene, .owns = true};
	return scree_replay_create_world(playback->replay, def, &player->world);
}

// Repeats calls until a step is taken or no call is left. A call that differs from the recording ends scree_replay_step, also before
// its step.
static scree_status repeat_step(Playback* playback, scree_world* world, bool* stepped)
{
	scree_replay_info* info = &playback->info;
	int64_t before = info->step, calls = info->call;
	scree_status status;
	do
	{
		status = scree_replay_step(playback->replay, world, stepped);
		if (status == SCREE_ERROR_DIFFERENT && !*playback->difference)
			snprintf(playback->difference, SENTENCE, "%s", scree_error());
		scree_replay_get_info(playback->replay, info);
	} while (status == SCREE_ERROR_DIFFERENT && *stepped && info->step == before);
	*stepped = info->step > before;
	playback->ended = !*stepped;
	playback->changed = info->call > calls + *stepped;
	return status == SCREE_ERROR_DIFFERENT ? SCREE_OK : status;
}

scree_status playback_step(Playback* playback, Scene* scene, ScenePlayer* player)
{
	const scree_replay_info* info = &playback->info;
	scree_counters old, now;
	bool stepped;
	scree_status status = scree_world_get_counters(player->world, &old);
	if (status == SCREE_OK)
		status = repeat_step(playback, player->world, &stepped);
	if (status == SCREE_OK)
		status = scree_world_get_counters(player->world, &now);
	if (status != SCREE_OK)
		return status;
	playback->changed = playback->changed || now.steps != old.steps + stepped; // a snapshot was restored
	player->steps = info->step;
	if (info->dt > 0.0f) // a step of length 0 is shown as long as the one before
		scene->dt = info->dt;
	if (info->substeps > 0)
		scene->substeps = info->substeps;
	return SCREE_OK;
}

void playback_write_end(const Playback* playback, char* sentence)
{
	const scree_replay_info* info = &playback->info;
	char end[80] = "";
	if (!info->ended)
		snprintf(end, sizeof end, ", its end is missing after %zu bytes", info->read);
	if (*playback->difference)
		snprintf(sentence, SENTENCE, "the recording ends after %lld steps%s; it differs: %.300s", (long long)info->step,
		         end, playback->difference);
	else
		snprintf(sentence, SENTENCE, "the recording ends after %lld steps%s; hashes: %lld, all equal",
		         (long long)info->step, end, (long long)info->hashes);
}
