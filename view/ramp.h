// SPDX-License-Identifier: MIT
// ramp.h -- computes color ramps, the colors of numbers, for shaders and legends.
#ifndef RAMP_H
#define RAMP_H
#include "view/style.h"

#define RAMP_COLORS 17 // an odd number, so that one color is in the middle; row.glsl uses the same number

// Sets `colors` to the ramp of a paint, at equal distances from 0 to 1; for the paint by starting place, from left to
// right. Returns false for a paint without a ramp.
bool ramp_of(Paint paint, Color colors[RAMP_COLORS]);

// Return the color of a starting place at the bottom (ramp_low) and at the top (ramp_high). color: its color in the
// ramp.
Color ramp_low(Color color);
Color ramp_high(Color color);

// m/s: speed in the middle of the ramp; the ramp ends at infinite speed
#define RAMP_SPEED 3.0f

// Returns the color of kinematic or dynamic bodies. For static bodies use the color of the theme.
Color type_color(scree_body_type type);

#endif
