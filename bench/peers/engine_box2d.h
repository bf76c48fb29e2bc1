// SPDX-License-Identifier: MIT
// engine_box2d.h -- Box2D v3 as an engine to be measured.
#ifndef ENGINE_BOX2D_H
#define ENGINE_BOX2D_H
#include "engine.h"

extern const Engine box2d_engine;

#endif
