// SPDX-License-Identifier: MIT
// run_files.h -- the files of scree run that contain the state of the world: snapshots, a scene and a recording.
#ifndef RUN_FILES_H
#define RUN_FILES_H
#include "cli/common/options.h"
#include "scene/player.h"

// Before the first step: replaces the world by a snapshot, and begins a recording, if the options say so. Steps are then counted
// on from those of the snapshot, so that churn goes on. On failure it prints an error message. Returns an exit code.
int run_files_begin(const Options* options, ScenePlayer* player);

// After the last step: ends the recording, and writes a snapshot and a scene, unless the run has failed. code: exit code so far. Returns the
// first exit code that is not EXIT_GOOD.
int run_files_end(const Options* options, ScenePlayer* player, int code);

#endif
