// SPDX-License-Identifier: MIT
// playback.h -- the recording in the viewer: opens a file, and repeats its steps in a world.
#ifndef PLAYBACK_H
#define PLAYBACK_H
#include "scene/player.h"
#include "tools/common/whole_file.h"
#include "view/shader.h"

typedef struct
{
	FileBytes file;            // bytes of the recording, which the replay reads
	scree_replay* replay;      // null: the viewer shows a scene
	scree_replay_info info;    // after the last step
	bool ended;                // true: the last call of playback_step found no step left
	bool changed;              // true: that call repeated others than a step, so the world may have other bodies
	char difference[SENTENCE]; // the first difference from the recording; empty: none so far
} Playback;

// Opens a recording. Returns a scene without bodies that has the name of its file, for the parts of the viewer that need one; the
// caller frees it. On failure writes a sentence, and returns null; the caller closes the playback also then.
Scene* playback_open(Playback* playback, const char* path, char* sentence);
void playback_close(Playback* playback);

// Creates the world in which the recording is repeated. The caller closes the player also on failure.
scree_status playback_create_world(Playback* playback, const Scene* scene, const scree_world_def* def,
                                   ScenePlayer* player);

// Repeats the calls of the recording up to the next step, and counts it in ScenePlayer.steps. Sets Scene.dt and Scene.substeps to
// those of the step. A difference from the recording is no failure.
scree_status playback_step(Playback* playback, Scene* scene, ScenePlayer* player);

// Writes a sentence that says that the recording has ended, and whether it differed.
void playback_write_end(const Playback* playback, char* sentence);

#endif
