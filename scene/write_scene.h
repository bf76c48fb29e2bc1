// SPDX-License-Identifier: MIT
// write_scene.h -- writes a world as the text of a scene file.
#ifndef WRITE_SCENE_H
#define WRITE_SCENE_H
#include "scene/scene.h"
#include "scene/text.h"

// Writes a world as the text of a scene. scene: name, title, dt, substeps, steps, penetration limit, view and detail of the
// file; nothing else of it is read. A missing name is that of the file, a missing title the name. file: name of the file, also for
// messages. The caller frees the text also on failure; on failure the message is in `sentence` (SCENE_SENTENCE characters), or in
// scree_error if `sentence` is empty.
scree_status scene_write(const Scene* scene, scree_world* world, const char* file, Text* text, char* sentence);

// Writes the text of scene_write to a file, which is complete or, on failure, as it was.
scree_status scene_write_file(const Scene* scene, scree_world* world, const char* path, char* sentence);

#endif
