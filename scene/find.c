// SPDX-License-Identifier: MIT
// find.c -- finds scene files: by path, or by name in the scene folders.
#include "scene/find.h"
#include <dirent.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#define FOLDERS 4

// Writes the folders in the order of search and returns their number.
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

// Returns false and writes an error message if $SCREE_SCENES is set but is not a folder.
static bool check_chosen(char* sentence)
{
	const char* chosen = getenv("SCREE_SCENES");
	struct stat about;
	if (!chosen || !*chosen || (stat(chosen, &about) == 0 && S_ISDIR(about.st_mode)))
		return true;
	snprintf(sentence, SCENE_SENTENCE, "SCREE_SCENES is \"%.160s\", which is no folder", chosen);
	return false;
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
	if (!check_chosen(sentence))
		return false;
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

static int compare_names(const void* a, const void* b) { return strcmp(*(char* const*)a, *(char* const*)b); }

// Adds the scenes of a folder that are not in the list yet. Returns the new number of names, -1 if memory is short.
static int list_folder(const char* folder, char*** names, int count)
{
	struct dirent** entries;
	int found = scandir(folder, &entries, is_scene, NULL);
	char** list = found > 0 ? realloc(*names, (size_t)(count + found) * sizeof(char*)) : NULL;
	int kept = found > 0 && !list ? -1 : count;
	*names = list ? list : *names;
	for (int n = 0; n < found; ++n)
	{
		char* name = list ? strndup(entries[n]->d_name, strlen(entries[n]->d_name) - 5) : NULL;
		if (name && (count == 0 || !bsearch(&name, list, (size_t)count, sizeof *list, compare_names)))
			list[kept++] = name;
		else
			free(name);
		free(entries[n]);
	}
	if (found >= 0)
		free(entries);
	if (kept > count)
		qsort(list, (size_t)kept, sizeof *list, compare_names);
	return kept;
}

int scene_list(const char* executable, char*** names, char* sentence)
{
	*names = NULL;
	if (!check_chosen(sentence))
		return 0;
	char folder[FOLDERS][SCENE_PATH];
	int folder_count = folders(executable, folder), count = 0;
	for (int k = 0; k < folder_count && count >= 0; ++k)
	{
		int known = count;
		count = list_folder(folder[k], names, count);
		for (int n = 0; n < known && count < 0; ++n)
			free((*names)[n]);
	}
	if (count <= 0)
		snprintf(sentence, SCENE_SENTENCE, "%s",
		         count < 0 ? "there is no memory to list the scenes"
		                   : "there are no scenes; SCREE_SCENES may name their folder");
	return count > 0 ? count : 0;
}
