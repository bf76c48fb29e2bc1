// SPDX-License-Identifier: MIT
// engine_box2d.h -- declares Box2D v3 as an Engine.
#ifndef ENGINE_BOX2D_H
#define ENGINE_BOX2D_H
#include "validate/engine.h"
#include <box2d/box2d.h>

extern const Engine box2d_engine;

// Returns the world of Box2D in the state that box2d_engine.open returned.
b2WorldId box2d_world(void* state);

#endif
