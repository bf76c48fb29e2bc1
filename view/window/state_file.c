// SPDX-License-Identifier: MIT
// state_file.c -- saves the state of the viewer's world as a file, and loads such a file.
#include "view/window/state_file.h"
#include "scene/player_file.h"
#include "tools/common/whole_file.h"
#include "view/window/rewind.h"
#include "view/window/viewer.h"
#include <errno.h>
#include <stdlib.h>
#include <string.h>

static bool say(Viewer* v, const char* what, const char* path, const char* why)
{
	char sentence[SENTENCE];
	snprintf(sentence, sizeof sentence, "%s %.200s%s%.250s", what, path, *why ? ": " : "", why);
	viewer_show(v, sentence);
	return false;
}

void state_save(Viewer* v)
{
	const void* bytes;
	size_t size;
	char sentence[SENTENCE], path[sizeof v->saved];
	if (!capture_name(path, "snap", sentence))
	{
		viewer_show(v, sentence);
		return;
	}
	if (player_save(&v->session.player, NULL, 0, &bytes, &size) != SCREE_OK)
	{
		viewer_show(v, scree_error());
		return;
	}
	bool good = whole_file_write(path, bytes, size);
	if (good)
		memcpy(v->saved, path, sizeof v->saved);
	say(v, good ? "the state is" : "cannot write", path, good ? "" : strerror(errno));
}

// Restores the world, and begins a new time line. A snapshot of another scene may have fewer bodies, which churn would miss.
static bool restore(Viewer* v, const char* path, const void* bytes, size_t size)
{
	ScenePlayer* player = &v->session.player;
	scree_counters* counters = &v->session.counters;
	scree_status status = player_load(player, bytes, size, NULL, 0);
	if (status != SCREE_OK && status != SCREE_ERROR_DIFFERENT)
		return say(v, "cannot load", path, scree_error());
	rewind_end(v);
	if (status != SCREE_OK || scree_world_get_counters(player->world, counters) != SCREE_OK ||
	    tuning_read(&v->session.tuning, v->session.scene, player->world) != SCREE_OK)
	{
		char why[SENTENCE];
		snprintf(why, sizeof why, "%.*s", SENTENCE - 1, scree_error());
		viewer_load(v, v->session.name, false);
		return say(v, "cannot load", path, why);
	}
	v->grab.joint = SCREE_NULL_JOINT;
	v->grab.thrown_size = 0.0f;
	v->tools.pour = (Pour){.rate = v->tools.pour.rate};
	v->session.hashed = false;
	v->session.paused = true;
	rewind_begin(v);
	say(v, "loaded", path, "");
	return viewer_update_world(v);
}

bool state_load(Viewer* v, const char* path)
{
	FileBytes file;
	if (!viewer_may_change(v))
		return false;
	path = path ? path : v->saved;
	if (!*path)
	{
		viewer_show(v, "no state has been saved yet");
		return false;
	}
	if (!whole_file_read(path, &file))
		return say(v, "cannot read", path, strerror(errno));
	bool good = restore(v, path, file.bytes, file.size);
	free(file.bytes);
	return good;
}

static bool failed(char* sentence)
{
	snprintf(sentence, SENTENCE, "%s", scree_error());
	return false;
}

bool state_record(Viewer* v, char* sentence)
{
	scree_record_def def = scree_record_def_default();
	def.path = v->options->record;
	def.hash_interval = v->options->hash_interval;
	if (!def.path)
		return true;
	v->recorded = scree_world_record(v->session.player.world, &def) == SCREE_OK ? v->session.player.world : NULL;
	return v->recorded || failed(sentence);
}

bool state_end_recording(Viewer* v, char* sentence)
{
	bool recorded = v->recorded && v->recorded == v->session.player.world;
	v->recorded = NULL;
	return !recorded || scree_world_end_recording(v->session.player.world) == SCREE_OK || failed(sentence);
}
