// SPDX-License-Identifier: MIT
// character.h -- reads the characters of a scene. A character is a mover, with the body that shows it, the bodies that
// it takes, and a script of its keys.
#ifndef CHARACTER_H
#define CHARACTER_H
#include "scene/reader.h"
#include "scene/scene.h"

struct Cue // keys that are down from a step on, until the next cue
{
	int64_t step;
	uint32_t down; // bits by SceneKey
};

// Reads the member "characters" of a scene whose blocks have been read.
bool characters_read(Reader* reader, const json_t* root, Scene* scene);
void characters_free(Scene* scene);

#endif
