// SPDX-License-Identifier: MIT
// between_steps.h -- names what changes the world of a scene between its steps.
#ifndef BETWEEN_STEPS_H
#define BETWEEN_STEPS_H
#include "scene/scene.h"

// Returns what changes the world of a scene, or reads it, between its steps, such as "churn"; null if nothing does. The
// worlds of a batch cannot have it.
const char* scene_between_steps(const Scene* scene);

#endif
