// SPDX-License-Identifier: MIT
// engine_scree.h -- Scree as an engine.
#ifndef ENGINE_SCREE_H
#define ENGINE_SCREE_H
#include "engine.h"

extern const Engine scree_engine;

// Sets the device of a definition, and the threads, lanes and bits.
void engine_set_device(scree_world_def* def, const EngineOptions* options);

// The number of bodies that a body overlaps; state is that of scree_engine.
int engine_overlaps(void* state, int body);

#endif
