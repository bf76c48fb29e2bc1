// SPDX-License-Identifier: MIT
// ramp.h -- rows of colors that stand for numbers, for shaders and legends.
#ifndef RAMP_H
#define RAMP_H
#include "view/style.h"

#define RAMP_COLORS 17 // an odd number, so that one color is in the middle; row.glsl has the same

// The colors of a paint from 0 to 1, evenly spaced: of the speed, of the force, of starting places from left to right. False for a
// paint that has none.
bool ramp_of(Paint paint, Color colors[RAMP_COLORS]);

// Colors of starting places at the bottom and at the top; between them they change evenly.
Color ramp_low(Color color);
Color ramp_high(Color color);

// Speed in m/s to a place on the ramp and back: the middle is 3 m/s, the end infinite.
#define RAMP_SPEED 3.0f

// Colors of body types, static first. What is static has the color of the theme.
Color type_color(scree_body_type type);

#endif
