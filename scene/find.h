// SPDX-License-Identifier: MIT
// find.h -- finds scene files: by path, or by name in the scene folders.
#ifndef FIND_H
#define FIND_H
#include "scene/scene.h"

// Finds the file of a scene and writes its path (SCENE_PATH characters). A name with a slash or the ending .json is a
// path. Any other name is searched in $SCREE_SCENES, in the folders set at build time, and in a folder relative to the
// executable (may be null). On failure it returns false and writes an error message.
bool scene_find(const char* name, const char* executable, char* path, char* sentence);

// Lists the names of all scenes in the folders of scene_find, sorted, into *names. The caller frees each name, then the
// list. Returns the number of names; if it is 0, an error message is written.
int scene_list(const char* executable, char*** names, char* sentence);

#endif
