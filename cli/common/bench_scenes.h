// SPDX-License-Identifier: MIT
// bench_scenes.h -- measures each scene several times, checks that its work was done, and prints a row of CSV.
#ifndef BENCH_SCENES_H
#define BENCH_SCENES_H
#include "measurement.h"
#include "open_scene.h"

// Runs the scene of a measurement once and adds the results to it. timings: true measures each stage. Prints a sentence
// on failure. Returns an exit code.
typedef int RunScene(const Options* options, bool timings, Measurement* m);

// Measures the scenes of a list with the function `run`, and prints one row per scene. stages: names of the columns of
// Record.stages. Returns an exit code.
int bench_scenes(const Options* options, const SceneList* list, const char* const* stages, RunScene* run);

#endif
