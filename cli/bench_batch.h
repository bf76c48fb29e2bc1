// SPDX-License-Identifier: MIT
// bench_batch.h -- scree bench --worlds: measures many copies of a scene in a batch, and compares them with one world alone.
#ifndef BENCH_BATCH_H
#define BENCH_BATCH_H
#include "cli/common/open_scene.h"

// Measures all scenes and prints one row per scene. Returns an exit code.
int measure_batches(const Options* options, const SceneList* list);

#endif
