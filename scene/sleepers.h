// SPDX-License-Identifier: MIT
// sleepers.h -- reads which bodies of a world are asleep, for pictures; uses only the public interface of Scree.
#ifndef SLEEPERS_H
#define SLEEPERS_H
#include "scene/scene.h"

// Reads the handles of all bodies of a world again, because a scene may replace bodies, and whether each is awake.
// count: number of bodies. *awake: null, or the array of the last call, of this number of bodies; the caller frees it.
// Sets *awake to null if the world does not sleep; then nothing else is read.
scree_status sleepers_read(scree_world* world, scree_body* bodies, int count, bool** awake);

#endif
