// SPDX-License-Identifier: MIT
// outputs.h -- writes the files of a run: a picture, a video, a CSV file.
#ifndef OUTPUTS_H
#define OUTPUTS_H
#include "picture_renderer.h"
#include "scene/video.h"
#include "step_record.h"

typedef struct
{
	PictureRenderer* renderer; // null if there is neither a picture nor a video
	Video video;
	FILE* picture_file;
	FILE* csv;
	const Options* options;
} Outputs;

typedef struct // state that a picture shows
{
	const scree_counters* counters;
	uint64_t hash;
	const scree_pose* poses; // poses of all bodies, in the order of scree_world_get_bodies; null: poses of the world
} Snapshot;

// Opens the renderer. *drawn gets a copy of the options with the renderer's OpenGL context; the caller must create the
// world with *drawn. Returns an exit code. The caller closes the outputs also on failure.
int outputs_begin(Outputs* outputs, const Options* options, Options* drawn);

// Opens all files before the first step, so that a wrong path is reported early. stages: names of the columns of
// Record.stages. Returns an exit code.
int outputs_open(Outputs* outputs, const ScenePlayer* player, const char* const* stages);

// Writes the row of a step to the CSV file, and gives the step to the renderer. Returns an exit code.
int outputs_step(Outputs* outputs, const ScenePlayer* player, const Record* record);

// Returns the number of video frames that are due after this step.
int outputs_due(const Outputs* outputs, const ScenePlayer* player);
// Draws the world, and adds the picture to the video once for each frame that is due. Returns an exit code.
int outputs_frames(Outputs* outputs, const ScenePlayer* player, const Snapshot* snapshot);

// Writes the picture, unless the run has failed, and closes all files and the renderer. code: exit code so far. Returns
// the first exit code that is not EXIT_GOOD; EXIT_GOOD if there is none.
int outputs_close(Outputs* outputs, const ScenePlayer* player, const Snapshot* snapshot, int code);

#endif
