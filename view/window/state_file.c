// SPDX-License-Identifier: MIT
// state_file.c -- saves the state of the viewer's world as a file, and loads such a file.
#include "view/window/state_file.h"
#include "scene/player_file.h"
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
	errno = 0;
	FILE* file = fopen(path, "wb");
	bool good = file && fwrite(bytes, 1, size, file) == size;
	good = file && fclose(file) == 0 && good;
	if (good)
		memcpy(v->saved, path, sizeof v->saved);
	say(v, good ? "the state is" : "cannot write", path, good ? "" : strerror(errno));
}

// Reads a file. The caller frees the bytes. Returns null on failure, with the reason in errno.
static void* read_file(const char* path, size_t* size)
{
	FILE* file = fopen(path, "rb");
	unsigned char* bytes = NULL;
	size_t capacity = 0;
	*size = 0;
	while (file && !feof(file) && !ferror(file))
	{
		if (*size == capacity)
		{
			capacity = 2 * capacity + 65536;
			unsigned char* more = realloc(bytes, capacity);
			if (!more)
				break;
			bytes = more;
		}
		*size += fread(bytes + *size, 1, capacity - *size, file);
	}
	bool good = file && feof(file) && !ferror(file);
	int error = errno;
	if (file)
		fclose(file);
	if (!good)
		free(bytes);
	errno = error;
	return good ? bytes : NULL;
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
	size_t size;
	path = path ? path : v->saved;
	if (!*path)
	{
		viewer_show(v, "no state has been saved yet");
		return false;
	}
	void* bytes = read_file(path, &size);
	if (!bytes)
		return say(v, "cannot read", path, strerror(errno));
	bool good = restore(v, path, bytes, size);
	free(bytes);
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
