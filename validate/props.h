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

// A floor whose top lies at y = 0. Returns its index, as the others do that of their first body.
int add_floor(Lab* lab, double half_width);

// Boxes of half a meter's half size, one on the other, from the floor.
int add_column(Lab* lab, int count, double x, double jitter);

// Mixed bodies, or boxes and circles alone, of 0.4 to 0.7 m across in a bin with a floor and walls, in rows above it, at
// random angles; x is the middle of the bin.
int add_heap(Lab* lab, int count, bool mixed, double x);

// Mixed bodies of some sizes at random places and angles of a rectangle, whatever else is there.
int add_jumble(Lab* lab, int count, double small, double large, scree_box place, uint64_t* seed);

#endif
