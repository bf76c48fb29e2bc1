// SPDX-License-Identifier: MIT
// session.c -- the scene or recording in the viewer: loads and steps it, and moves it to another device.
#include "view/window/session.h"
#include "scene/find.h"
#include "scene/heading.h"
#include "scene/load.h"
#include "tools/common/recording_file.h"
#include "view/shader.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define SMOOTH 0.1f // weight of the last step in the displayed average

static bool failed(char* sentence)
{
	snprintf(sentence, SENTENCE, "%s", scree_error());
	return false;
}

// Copies a text. If it does not fit into size characters, writes a sentence and returns false.
static bool copy_text(const char* text, char* copy, size_t size, const char* what, char* sentence)
{
	if (strlen(text) < size)
		return strcpy(copy, text);
	snprintf(sentence, SENTENCE, "%s %.60s... has more than %zu characters, which the panel cannot hold", what, text,
	         size - 1);
	return false;
}

// Reads the parameters of a scene file from its heading, a text such as "rows=100 columns=20". If `set` is true, values
// in the options replace values of the file. Returns false and writes a sentence on failure.
static bool read_parameters(Session* session, const char* path, bool set, char* sentence)
{
	char title[160], text[MAX_PARAMETERS * 128];
	if (!scene_heading(path, title, sizeof title, text, sizeof text, sentence))
		return false;
	session->parameter_count = 0;
	char* rest = NULL;
	for (char* word = strtok_r(text, " ", &rest); word; word = strtok_r(NULL, " ", &rest))
	{
		char* equals = strchr(word, '=');
		if (!equals)
			continue;
		if (session->parameter_count == MAX_PARAMETERS)
		{
			snprintf(sentence, SENTENCE, "%.400s has more than %d parameters, which the panel cannot hold", path,
			         MAX_PARAMETERS);
			return false;
		}
		*equals = 0;
		Parameter* p = &session->parameters[session->parameter_count++];
		const char* value = equals + 1;
		for (int k = 0; k < session->options->setting_count && set; ++k)
			if (strcmp(session->options->settings[k].name, word) == 0)
				value = session->options->settings[k].value;
		if (!copy_text(word, p->name, sizeof p->name, "the parameter", sentence) ||
		    !copy_text(value, p->value, sizeof p->value, "the value", sentence) ||
		    !scene_parameter_help(path, word, p->help, sizeof p->help, sentence))
			return false;
	}
	return true;
}

static Scene* load_scene(Session* session, bool fresh, char* sentence)
{
	SceneSetting settings[MAX_PARAMETERS];
	char path[SCENE_PATH];
	const ViewOptions* options = session->options;
	bool chosen = strcmp(session->name, options->scene) == 0;
	if (!scene_find(session->name, options->executable, path, sentence) ||
	    (fresh && !read_parameters(session, path, chosen, sentence)))
		return NULL;
	if (fresh && chosen)
		return scene_load(path, options->settings, options->setting_count, sentence);
	for (int k = 0; k < session->parameter_count; ++k)
		settings[k] = (SceneSetting){session->parameters[k].name, session->parameters[k].value};
	return scene_load(path, settings, session->parameter_count, sentence);
}

// Loads the scene or the recording of Session.name, and sets Session.playback.
static Scene* load(Session* session, bool fresh, char* sentence)
{
	session->playback = (Playback){0};
	if (!recording_file(session->name))
		return load_scene(session, fresh, sentence);
	session->parameter_count = 0;
	return playback_open(&session->playback, session->name, sentence);
}

static scree_status open_player(Session* session, const Scene* scene, ScenePlayer* player)
{
	scree_world_def def = scene->world;
	def.device = session->device;
	def.threads = session->options->threads;
	def.lanes = session->options->lanes;
	def.allow_unequal_bits = session->options->allow_unequal_bits;
	def.timings = true;
	def.sleep = scene_sleeps(scene, session->options->sleep);
	def.opengl = session->opengl;
	if (session_replays(session))
		return playback_create_world(&session->playback, scene, &def, player);
	return player_open(player, scene, &def);
}

bool session_load(Session* session, const char* name, bool fresh, char* sentence)
{
	Session old = *session;
	ScenePlayer player = {0};
	scree_counters counters;
	Tuning tuning = session->tuning;
	tuning.changed = tuning.changed && !fresh && strcmp(name, session->name) == 0;
	if (name != session->name)
		snprintf(session->name, sizeof session->name, "%s", name);
	Scene* scene = load(session, fresh, sentence);
	bool good = scene && ((open_player(session, scene, &player) == SCREE_OK &&
	                       (tuning.changed ? tuning_write(&tuning, scene, player.world)
	                                       : tuning_read(&tuning, scene, player.world)) == SCREE_OK &&
	                       scree_world_get_counters(player.world, &counters) == SCREE_OK) ||
	                      failed(sentence));
	if (!good)
	{
		player_close(&player);
		scene_free(scene);
		playback_close(&session->playback);
		*session = old;
		return false;
	}
	player_close(&session->player);
	scene_free(session->scene);
	playback_close(&old.playback);
	session->player = player;
	session->scene = scene;
	session->counters = counters;
	session->deepest = 0.0f;
	session->tuning = tuning;
	session->accumulator = session->seconds = 0;
	session->due = 0;
	session->hashed = false;
	session->step = 0;
	memset(session->stages, 0, sizeof session->stages);
	return true;
}

bool session_open(Session* session, const ViewOptions* options, const scree_opengl* opengl, char* sentence)
{
	*session = (Session){.options = options, .opengl = opengl, .rate = 1.0f};
	snprintf(session->device, sizeof session->device, "%s", options->device);
	session->scene_count = scene_list(options->executable, &session->scenes, sentence);
	session->titles = calloc((size_t)session->scene_count + 1, sizeof *session->titles);
	int count = 0;
	scree_devices_get(NULL, 0, &count);
	session->devices = calloc((size_t)count + 1, sizeof *session->devices);
	if (!session->devices || scree_devices_get(session->devices, count, &session->device_count) != SCREE_OK)
		session->device_count = 0;
	return session_load(session, options->scene, true, sentence);
}

void session_close(Session* session)
{
	player_close(&session->player);
	scene_free(session->scene);
	playback_close(&session->playback);
	for (int k = 0; k < session->scene_count; ++k)
		free(session->scenes[k]);
	free(session->scenes);
	free(session->titles);
	free(session->devices);
	*session = (Session){0};
}

const char* session_title(Session* session, int k)
{
	char path[SCENE_PATH], parameters[MAX_PARAMETERS * 128], sentence[SENTENCE];
	if (!session->titles)
		return "";
	char* title = session->titles[k];
	if (!*title && (!scene_find(session->scenes[k], session->options->executable, path, sentence) ||
	                !scene_heading(path, title, sizeof session->titles[k], parameters, sizeof parameters, sentence)))
		snprintf(title, sizeof session->titles[k], "cannot be read");
	return title;
}

bool session_move(Session* session, const char* device, char* sentence)
{
	if (scree_world_move(session->player.world, device) != SCREE_OK)
		return failed(sentence);
	snprintf(session->device, sizeof session->device, "%s", device);
	session->step = 0;
	memset(session->stages, 0, sizeof session->stages);
	return true;
}

static void smooth(float* shown, float now) { *shown = *shown == 0.0f ? now : *shown + SMOOTH * (now - *shown); }

bool session_replays(const Session* session) { return session->playback.replay; }

// Repeats a step of a recording. The calls before it may have changed what the panel shows.
static scree_status repeat_step(Session* session)
{
	scree_status status = playback_step(&session->playback, session->scene, &session->player);
	return status == SCREE_OK ? tuning_read(&session->tuning, session->scene, session->player.world) : status;
}

bool session_step(Session* session, char* sentence)
{
	scree_timings t;
	session->hashed = false;
	if ((session_replays(session) ? repeat_step(session) : player_step(&session->player)) != SCREE_OK ||
	    scree_world_get_counters(session->player.world, &session->counters) != SCREE_OK ||
	    scree_world_get_timings(session->player.world, &t) != SCREE_OK)
		return failed(sentence);
	if (session->playback.ended)
		return true;
	session->deepest = fmaxf(session->deepest, session->counters.penetration);
	float stages[STAGE_TIMES];
	stage_times(&t, stages);
	for (int k = 0; k < STAGE_TIMES; ++k)
		smooth(&session->stages[k], stages[k]);
	smooth(&session->step, t.step);
	session->last = t.step;
	session->seconds += (double)session->scene->dt;
	return true;
}

bool session_hash(Session* session, char* sentence)
{
	if (scree_world_get_hash(session->player.world, &session->hash) != SCREE_OK)
		return failed(sentence);
	session->hashed = true;
	return true;
}
