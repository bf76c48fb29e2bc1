// SPDX-License-Identifier: MIT
// engine_scree.h -- implements the functions of engine.h with Scree.
#ifndef ENGINE_SCREE_H
#define ENGINE_SCREE_H
#include "engine.h"

extern const Engine scree_engine;

// Copies device, threads, lanes and allow_unequal_bits of the options to a definition.
void engine_set_device(scree_world_def* def, const EngineOptions* options);

// Returns the number of bodies that a body overlaps. state: state that scree_engine has opened.
int engine_overlaps(void* state, int body);

#endif
