// SPDX-License-Identifier: MIT
// batch_scene.h -- parts that bench --worlds and run --worlds share: which scenes a batch takes, and its definition.
#ifndef BATCH_SCENE_H
#define BATCH_SCENE_H
#include "cli/common/open_scene.h"

// Returns whether nothing changes the world of a scene between its steps. If not, prints the reason.
bool batch_takes(const Options* options, const Scene* scene);

// Returns the options of a batch and its template: the device is the CPU unless the options name another one.
Options batch_options(const Options* options);

// Returns the definition of a batch with one template. options: those of batch_options. *world must stay where it is
// until the batch is created.
scree_batch_def batch_definition(const Options* options, scree_world** world);

#endif
