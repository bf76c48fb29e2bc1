// SPDX-License-Identifier: MIT
// engine_scree.h -- Scree as an engine to be measured.
#ifndef ENGINE_SCREE_H
#define ENGINE_SCREE_H
#include "engine.h"

extern const Engine scree_engine;

#endif
