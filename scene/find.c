// SPDX-License-Identifier: MIT
// find.c -- finds scene files: by path, or by name in the scene folders.
#include "scene/find.h"
#include <dirent.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#define FOLDERS 4

// Returns the last character between a folder and a name in a path, or null.
static const char* last_slash(const char* path)
{
	const char* slash = strrchr(path, '/');
#ifdef _WIN32
	const char* back = strrchr(path, '\\');
	slash = !slash || (back && back > slash) ? back : slash;
#endif
	return slash;
}

// Writes the folders in the order of search and returns their number.
static int folders(const char* executable, char folder[FOLDERS][SCENE_PATH])
{
	int count = 0;
	const char* chosen = getenv("SCREE_SCENES");
	if (chosen && *chosen)
		snprintf(folder[count++], SCENE_PATH, "%s", chosen);
	snprintf(folder[count++], SCENE_PATH, "%s", SCREE_SCENE_DIR);
	snprintf(folder[count++], SCENE_PATH, "%s", SCREE_INSTALLED_SCENE_DIR);
	const char* slash = executable ? last_slash(executable) : NULL;
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
	if (last_slash(name) || ends_in_json(name))
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

static bool is_scene(const char* name) { return ends_in_json(name) && !strstr(name, ".schema."); }

static int compare_names(const void* a, const void* b) { return strcmp(*(char* const*)a, *(char* const*)b); }

// Adds a name without .json to a list of count names, unless it is among the first ones, which are sorted. Returns false if
// memory is short.
static bool list_name(const char* name, char*** names, int sorted, int* count)
{
	size_t length = strlen(name) - strlen(".json");
	char* copy = malloc(length + 1);
	char** list = realloc(*names, (size_t)(*count + 1) * sizeof *list);
	*names = list ? list : *names;
	if (copy && list)
	{
		memcpy(copy, name, length);
		copy[length] = 0;
		if (sorted == 0 || !bsearch(&copy, list, (size_t)sorted, sizeof *list, compare_names))
		{
			list[(*count)++] = copy;
			return true;
		}
	}
	free(copy);
	return copy && list;
}

// Adds the scenes of a folder that are not in the list yet. Returns the new number of names; -1 if memory is short, and
// then the list keeps the first count names.
static int list_folder(const char* folder, char*** names, int count)
{
	DIR* directory = opendir(folder);
	int listed = count;
	bool good = true;
	for (struct dirent* entry; good && directory && (entry = readdir(directory));)
		good = !is_scene(entry->d_name) || list_name(entry->d_name, names, count, &listed);
	if (directory)
		closedir(directory);
	if (!good)
	{
		while (listed > count)
			free((*names)[--listed]);
		return -1;
	}
	if (listed > count)
		qsort(*names, (size_t)listed, sizeof **names, compare_names);
	return listed;
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
