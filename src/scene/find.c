// SPDX-License-Identifier: MIT
// find.c -- where scene files are: a path, or a name in one of the scene folders.
#include "scene/scene.h"
#include <dirent.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define FOLDERS 4

// The folders in the order of search; returns how many there are.
static int folders(const char* executable, char folder[FOLDERS][SCENE_PATH])
{
	int count = 0;
	const char* chosen = getenv("SCREE_SCENES");
	if (chosen && *chosen)
		snprintf(folder[count++], SCENE_PATH, "%s", chosen);
	snprintf(folder[count++], SCENE_PATH, "%s", SCREE_SCENE_DIR);
	snprintf(folder[count++], SCENE_PATH, "%s", SCREE_INSTALLED_SCENE_DIR);
	const char* slash = executable ? strrchr(executable, '/') : NULL;
	if (slash)
		snprintf(folder[count++], SCENE_PATH, "%.*s/../share/scree/scenes", (int)(slash - executable), executable);
	return count;
}

static bool ends_in_json(const char* name)
{
	size_t length = strlen(name);
	return length > 5 && strcmp(name + length - 5, ".json") == 0;
}

bool scene_find(const char* name, const char* executable, char* path, char* sentence)
{
	if (strlen(name) >= SCENE_PATH)
	{
		snprintf(sentence, SCENE_SENTENCE, "the path of the scene has more than %d characters", SCENE_PATH - 1);
		return false;
	}
	if (strchr(name, '/') || ends_in_json(name))
	{
		snprintf(path, SCENE_PATH, "%s", name);
		return true;
	}
	char folder[FOLDERS][SCENE_PATH];
	int count = folders(executable, folder);
	for (int k = 0; k < count; ++k)
	{
		int length = snprintf(path, SCENE_PATH, "%s/%s.json", folder[k], name);
		if (length < SCENE_PATH && access(path, F_OK) == 0)
			return true;
	}
	snprintf(sentence, SCENE_SENTENCE,
	         "no scene is called \"%.60s\"; scree scenes lists them, and a file needs its path", name);
	return false;
}

static int is_scene(const struct dirent* entry)
{
	return ends_in_json(entry->d_name) && !strstr(entry->d_name, ".schema.");
}

int scene_list(const char* executable, char*** names)
{
	char folder[FOLDERS][SCENE_PATH];
	int count = folders(executable, folder);
	for (int k = 0; k < count; ++k)
	{
		struct dirent** entries;
		int found = scandir(folder[k], &entries, is_scene, alphasort);
		if (found < 0)
			continue;
		char** list = calloc((size_t)found + 1, sizeof(char*));
		int kept = 0;
		for (int n = 0; n < found; ++n)
		{
			if (list)
				list[kept++] = strndup(entries[n]->d_name, strlen(entries[n]->d_name) - 5);
			free(entries[n]);
		}
		free(entries);
		if (kept > 0)
		{
			*names = list;
			return kept;
		}
		free(list);
	}
	*names = NULL;
	return 0;
}
