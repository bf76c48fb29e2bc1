// SPDX-License-Identifier: MIT
// session.c -- the scene that is on view: begun, stepped, paused, moved to another device.
#include "view/window/session.h"
#include "view/shader.h"
#include <stdlib.h>
#include <string.h>

#define SMOOTH 0.1f // share of the last step in what is shown

const char* const play_stages[STAGES] = {"transform", "broad phase", "narrow phase", "color", "solve", "finalize"};

static bool failed(char* sentence)
{
	snprintf(sentence, SENTENCE, "%s", scree_error());
	return false;
}

// A copy that is whole, or none.
static bool fits(const char* text, char* room, size_t size, const char* what, char* sentence)
{
	if (strlen(text) < size)
		return strcpy(room, text);
	snprintf(sentence, SENTENCE, "%s %.60s... has more than %zu characters, which the panel cannot hold", what, text,
	         size - 1);
	return false;
}

// Takes the parameters of a scene file, "rows=100 columns=20", and what the options set.
static bool read_parameters(Play* play, const char* path, bool set, char* sentence)
{
	char title[160], text[MAX_PARAMETERS * 128];
	if (!scene_heading(path, title, sizeof title, text, sizeof text, sentence))
		return false;
	play->parameter_count = 0;
	char* rest = NULL;
	for (char* word = strtok_r(text, " ", &rest); word; word = strtok_r(NULL, " ", &rest))
	{
		char* equals = strchr(word, '=');
		if (!equals)
			continue;
		if (play->parameter_count == MAX_PARAMETERS)
		{
			snprintf(sentence, SENTENCE, "%.400s has more than %d parameters, which the panel cannot hold", path,
			         MAX_PARAMETERS);
			return false;
		}
		*equals = 0;
		Parameter* p = &play->parameters[play->parameter_count++];
		const char* value = equals + 1;
		for (int k = 0; k < play->options->setting_count && set; ++k)
			if (strcmp(play->options->settings[k].name, word) == 0)
				value = play->options->settings[k].value;
		if (!fits(word, p->name, sizeof p->name, "the parameter", sentence) ||
		    !fits(value, p->value, sizeof p->value, "the value", sentence))
			return false;
	}
	return true;
}

static Scene* load(Play* play, const char* path, bool fresh, char* sentence)
{
	SceneSetting settings[MAX_PARAMETERS];
	const ViewOptions* options = play->options;
	if (fresh && strcmp(play->name, options->scene) == 0)
		return scene_load(path, options->settings, options->setting_count, sentence);
	for (int k = 0; k < play->parameter_count; ++k)
		settings[k] = (SceneSetting){play->parameters[k].name, play->parameters[k].value};
	return scene_load(path, settings, play->parameter_count, sentence);
}

static bool build(const Play* play, const Scene* scene, scree_world** world, char* sentence)
{
	scree_world_def def = scene->world;
	def.device = play->device;
	def.threads = play->options->threads;
	def.lanes = play->options->lanes;
	def.allow_unequal_bits = play->options->allow_unequal_bits;
	def.timings = true;
	def.opengl = play->opengl;
	scree_status status = scree_world_create(&def, world);
	if (status == SCREE_OK)
		status = scene_build(scene, *world);
	if (status == SCREE_OK)
		return true;
	failed(sentence);
	scree_world_destroy(*world);
	*world = NULL;
	return false;
}

bool play_begin(Play* play, const char* name, bool fresh, char* sentence)
{
	Play kept = *play;
	char path[SCENE_PATH];
	scree_world* world = NULL;
	scree_counters counters;
	if (name != play->name)
		snprintf(play->name, sizeof play->name, "%s", name);
	bool set = strcmp(play->name, play->options->scene) == 0;
	bool good = scene_find(play->name, play->options->executable, path, sentence) &&
	            (!fresh || read_parameters(play, path, set, sentence));
	Scene* scene = good ? load(play, path, fresh, sentence) : NULL;
	good = scene && build(play, scene, &world, sentence) &&
	       (scree_world_get_counters(world, &counters) == SCREE_OK || failed(sentence));
	if (!good)
	{
		scree_world_destroy(world);
		scene_free(scene);
		*play = kept;
		return false;
	}
	scene_free(play->scene);
	scree_world_destroy(play->world);
	play->scene = scene;
	play->world = world;
	play->counters = counters;
	play->owed = 0;
	play->steps = 0;
	play->hashed = false;
	play->step = 0;
	memset(play->stages, 0, sizeof play->stages);
	return true;
}

bool play_open(Play* play, const ViewOptions* options, const scree_opengl* opengl, char* sentence)
{
	*play = (Play){.options = options, .opengl = opengl, .rate = 1.0f};
	snprintf(play->device, sizeof play->device, "%s", options->device);
	play->scene_count = scene_list(options->executable, &play->scenes, sentence);
	int count = 0;
	scree_devices_get(NULL, 0, &count);
	play->devices = calloc((size_t)count + 1, sizeof *play->devices);
	if (!play->devices || scree_devices_get(play->devices, count, &play->device_count) != SCREE_OK)
		play->device_count = 0;
	return play_begin(play, options->scene, true, sentence);
}

void play_close(Play* play)
{
	scree_world_destroy(play->world);
	scene_free(play->scene);
	for (int k = 0; k < play->scene_count; ++k)
		free(play->scenes[k]);
	free(play->scenes);
	free(play->devices);
	*play = (Play){0};
}

bool play_move(Play* play, const char* device, char* sentence)
{
	if (scree_world_move(play->world, device) != SCREE_OK)
		return failed(sentence);
	snprintf(play->device, sizeof play->device, "%s", device);
	play->step = 0;
	memset(play->stages, 0, sizeof play->stages);
	return true;
}

static void smooth(float* shown, float now) { *shown = *shown == 0.0f ? now : *shown + SMOOTH * (now - *shown); }

bool play_step(Play* play, char* sentence)
{
	scree_timings t;
	if (scene_churn(play->scene, play->world, play->steps++) != SCREE_OK ||
	    scree_world_step(play->world, play->scene->dt, play->scene->substeps) != SCREE_OK ||
	    scree_world_get_counters(play->world, &play->counters) != SCREE_OK ||
	    scree_world_get_timings(play->world, &t) != SCREE_OK)
		return failed(sentence);
	const float stages[STAGES] = {t.transform, t.broad_phase, t.narrow_phase, t.color, t.solve, t.finalize};
	for (int k = 0; k < STAGES; ++k)
		smooth(&play->stages[k], stages[k]);
	smooth(&play->step, t.step);
	play->hashed = false;
	return true;
}

bool play_hash(Play* play, char* sentence)
{
	if (scree_world_get_hash(play->world, &play->hash) != SCREE_OK)
		return failed(sentence);
	play->hashed = true;
	return true;
}
