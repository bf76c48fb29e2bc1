// SPDX-License-Identifier: MIT
// props.h -- makes surfaces and arrangements of bodies for several experiments.
#ifndef PROPS_H
#define PROPS_H
#include "validate.h"

// These functions return surfaces with Scree's defaults: density 1 kg/m^2, friction 0.6, restitution 0.
scree_attribute_def box_of(double half_width, double half_height);
scree_attribute_def rounded_of(double half_width, double half_height, double radius); // half sizes include the rounding
scree_attribute_def circle_of(double radius);
scree_attribute_def capsule_of(double half_length, double radius); // horizontal; half_length excludes the round ends
scree_attribute_def polygon_of(const scree_vec* corners, int count);
scree_attribute_def wall_of(double height); // vertical segment through the origin

// These functions add bodies and return the index of the first. The top of a floor is at y = 0.
int add_floor(Lab* lab, double half_width);

// Adds a column of boxes of 1 m x 1 m that stands on the floor. jitter: maximum random offset of each box in x, m.
int add_column(Lab* lab, int count, double x, double jitter);

// Adds a bin, which is a floor and two walls, with its middle at `x`, and rows of bodies in it, 0.4 to 0.72 m in size,
// at random angles. mixed: bodies of six kinds; otherwise boxes and circles. Returns the first body in the bin.
int add_heap(Lab* lab, int count, bool mixed, double x);

// Adds bodies of six kinds at random places in `place` and at random angles; they may overlap. small, large: range of
// their sizes, m.
int add_jumble(Lab* lab, int count, double small, double large, scree_box place, uint64_t* seed);

#endif
