// SPDX-License-Identifier: MIT
// find.h -- finds scene files: by path, or by name in the scene folders.
#ifndef FIND_H
#define FIND_H
#include "scene/scene.h"

// Finds the file of a scene. A name with a slash or the ending .json is a path. Any other name is searched in
// $SCREE_SCENES, in the folders set at build time, and beside the executable (may be null). path has SCENE_PATH
// characters. Returns false and writes a sentence on failure.
bool scene_find(const char* name, const char* executable, char* path, char* sentence);

// Lists the names of the scenes in these folders, sorted, into *names (free each, then the list). Returns their count;
// if it is 0, writes a sentence.
int scene_list(const char* executable, char*** names, char* sentence);

#endif
