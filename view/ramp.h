// SPDX-License-Identifier: MIT
// ramp.h -- computes color ramps, which show numbers as colors, for shaders and legends.
#ifndef RAMP_H
#define RAMP_H
#include "view/style.h"

#define RAMP_COLORS 17 // number of colors; odd, so that one color is in the middle; row.glsl uses the same number

// Sets `colors` to the ramp of a paint, at equal steps from value 0 to value 1. In the paint by starting place the
// value is the position from left to right. Returns false for a paint without a ramp.
bool ramp_of(Paint paint, Color colors[RAMP_COLORS]);

// Return the color of a starting place at the bottom (ramp_low) or at the top (ramp_high) of the scene. color: color of
// its position from left to right, from the ramp.
Color ramp_low(Color color);
Color ramp_high(Color color);

// m/s: speed in the middle of the ramp; the ramp ends at infinite speed
#define RAMP_SPEED 3.0f

// Returns the color of kinematic or dynamic bodies. For static bodies use the color of the theme.
Color type_color(scree_body_type type);

#endif
