// SPDX-License-Identifier: MIT
// props.h -- surfaces and arrangements that several experiments use.
#ifndef PROPS_H
#define PROPS_H
#include "validate.h"

// Surfaces with Scree's defaults: density 1 kg/m^2, friction 0.6, restitution 0.
scree_attribute_def box_of(double half_width, double half_height);
scree_attribute_def rounded_of(double half_width, double half_height, double radius); // sizes with the rounding
scree_attribute_def circle_of(double radius);
scree_attribute_def capsule_of(double half_length, double radius); // lies; half_length without the ends
scree_attribute_def polygon_of(const scree_vec* corners, int count);
scree_attribute_def wall_of(double height); // an upright segment through the origin

// These add bodies and return the index of the first. The top of a floor is at y = 0.
int add_floor(Lab* lab, double half_width);

// Boxes of 1 m x 1 m on each other, from the floor up.
int add_column(Lab* lab, int count, double x, double jitter);

// Mixed bodies, or only boxes and circles, 0.4 to 0.7 m wide, in rows in a bin of a floor and walls, at random angles; x: the
// middle of the bin.
int add_heap(Lab* lab, int count, bool mixed, double x);

// Mixed bodies at random places and angles in a rectangle. They may overlap.
int add_jumble(Lab* lab, int count, double small, double large, scree_box place, uint64_t* seed);

#endif
