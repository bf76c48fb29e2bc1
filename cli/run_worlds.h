// SPDX-License-Identifier: MIT
// run_worlds.h -- scree run --worlds: steps copies of a scene in a batch, and takes out one of them.
#ifndef RUN_WORLDS_H
#define RUN_WORLDS_H
#include "cli/common/open_scene.h"
#include "cli/common/run_report.h"

// Returns whether a batch can do what the options ask for. If not, prints the reason.
bool run_worlds_can(const Options* options, const Scene* scene);

// Copies the world of a player Options.worlds times, takes the steps in a batch, and then gives the world the state of the
// copy Options.show, which the totals describe. options: those of batch_options. Returns an exit code.
int run_worlds(const Options* options, ScenePlayer* player, int steps, Totals* totals);

#endif
