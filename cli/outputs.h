// SPDX-License-Identifier: MIT
// outputs.h -- what a run leaves beside its table: a picture, a video, a CSV file.
#ifndef OUTPUTS_H
#define OUTPUTS_H
#include "picture_renderer.h"
#include "record.h"
#include "scene/video.h"

typedef struct
{
	PictureRenderer* renderer; // null when neither picture nor video is asked for
	Video video;
	FILE* picture_file;
	FILE* csv;
	const Options* options;
} Outputs;

// Opens what draws pictures, of which the world must know when it is made: *drawn are the options to make it with.
// Returns an exit code. To be closed also when this fails.
int outputs_begin(Outputs* outputs, const Options* options, Options* drawn);

// Opens all files before the first step, so that a bad path costs nothing. Returns an exit code.
int outputs_open(Outputs* outputs, Simulation* simulation);

// Adds a frame and a row. Returns an exit code.
int outputs_step(Outputs* outputs, Simulation* simulation, const Record* record);

// Writes the picture if the run was good, and closes everything. Returns the first exit code that is not good.
int outputs_close(Outputs* outputs, Simulation* simulation, int code);

#endif
