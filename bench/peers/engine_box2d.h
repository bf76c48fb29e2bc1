// SPDX-License-Identifier: MIT
// engine_box2d.h -- Box2D v3 as an engine.
#ifndef ENGINE_BOX2D_H
#define ENGINE_BOX2D_H
#include "validate/engine.h"
#include <box2d/box2d.h>

extern const Engine box2d_engine;

// The world of Box2D; state is that of box2d_engine.
b2WorldId box2d_world(void* state);

#endif
