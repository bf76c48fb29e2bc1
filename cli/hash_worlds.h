// SPDX-License-Identifier: MIT
// hash_worlds.h -- scree hash --worlds: steps copies of a scene with random inputs in a batch, and sums their hashes.
#ifndef HASH_WORLDS_H
#define HASH_WORLDS_H
#include "cli/common/open_scene.h"

// Takes the steps of the wall of scree view --worlds, and computes the sum of the hashes of its worlds, modulo 2^64. options: as
// batch_options returns them. Returns an exit code.
int hash_worlds(const Options* options, const ScenePlayer* player, uint64_t* sum);

#endif
