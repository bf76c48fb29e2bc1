// SPDX-License-Identifier: MIT
// character.h -- characters of a scene: a mover, the body that shows it, what it takes, and a script of the keys that it obeys.
#ifndef CHARACTER_H
#define CHARACTER_H
#include "scene/reader.h"
#include "scene/scene.h"

typedef struct // keys that are down from a step on
{
	int64_t step;
	uint32_t down; // bits by SceneKey
} Cue;

struct Character
{
	int block; // position in Scene.blocks of its body, the first one of a kinematic entry
	int takes; // that of the bodies with sensors that it takes when it comes into them; -1: nothing
	scree_mover_def def;
	float speed; // m/s: at a walk
	float jump;  // m/s: up, when it begins to jump
	Cue* cues;   // by rising steps
	int cue_count;
};

// Reads the member "characters" of a scene whose blocks have been read.
bool characters_read(Reader* reader, const json_t* root, Scene* scene);
void characters_free(Scene* scene);

#endif
