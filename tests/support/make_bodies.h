// SPDX-License-Identifier: MIT
// make_bodies.h -- creates shapes and bodies for tests, and reads their state.
#ifndef MAKE_BODIES_H
#define MAKE_BODIES_H
#include "support/make_worlds.h"

// ---------------------------------------------------------------------------------------------------------------
// shapes
// ---------------------------------------------------------------------------------------------------------------

scree_shape box_shape(float half_width, float half_height);
scree_shape circle_shape(float radius);
scree_shape capsule_shape(float half, float radius); // the axis lies along x; half: half of its length, m
scree_shape segment_shape(float ax, float ay, float bx, float by);
scree_shape polygon_shape(const scree_vec* corners, int count, float radius);

// Returns the definition of an attribute with this shape and the default surface. The test may change it.
scree_attribute_def surface_of(scree_shape shape);
scree_attribute add_attribute(scree_world* world, const scree_attribute_def* def);

scree_attribute add_surface(scree_world* world, scree_shape shape, float friction, float restitution);

// Adds an attribute with this shape and the default surface.
scree_attribute shape_attribute(scree_world* world, scree_shape shape);
scree_attribute box_attribute(scree_world* world, float half_width, float half_height);

// ---------------------------------------------------------------------------------------------------------------
// bodies
// ---------------------------------------------------------------------------------------------------------------

scree_body create_body(scree_world* world, const scree_body_def* def);
scree_collidable create_collidable(scree_world* world, const scree_collidable_def* def);

// Each function returns a definition that the test may change. A crate is a box of 1 m.
scree_body_def body_def(scree_body_type type, scree_attribute attribute, float x, float y);
scree_body_def crate_def(scree_world* world, scree_body_type type, float x, float y);

// Each function adds a body with one collidable at its origin. add_disc, add_thrown and add_reporter add dynamic
// bodies.
scree_body add_body(scree_world* world, scree_body_type type, scree_attribute attribute, float x, float y,
                    float radians);
scree_body add_shape(scree_world* world, scree_body_type type, scree_shape shape, float x, float y, float radians);
scree_body add_box(scree_world* world, scree_body_type type, float half_width, float half_height, float x, float y);
scree_body add_crate(scree_world* world, scree_body_type type, float x, float y);
scree_body add_disc(scree_world* world, float radius, float x, float y);
scree_body add_thrown(scree_world* world, scree_shape shape, float x, float y, float vx, float vy);
scree_body add_reporter(scree_world* world, scree_shape shape, uint32_t reports, float x, float y);
scree_body add_floor(scree_world* world); // box of 200 m by 2 m, with its surface at y = 0

void throw_body(scree_world* world, scree_body body, float x, float y, float spin); // sets the velocity of a body

// ---------------------------------------------------------------------------------------------------------------
// poses, velocities, masses
// ---------------------------------------------------------------------------------------------------------------

scree_collidable collidable_of(scree_world* world, scree_body body); // the only collidable of a body
scree_pose pose_at(float x, float y, float radians);
scree_pose upright_at(float x, float y);
scree_pose pose_of(scree_world* world, scree_body body);
scree_vec position_of(scree_world* world, scree_body body);
float angle_of(scree_world* world, scree_body body);
scree_velocity velocity_of(scree_world* world, scree_body body);
double speed_of(scree_world* world, scree_body body); // m/s
scree_mass mass_of(scree_world* world, scree_body body);

// Takes some steps. Returns the mean of v^2 + (reach w)^2 over all bodies and steps, m^2/s^2. v: speed of a body; w:
// spin of this body.
double mean_square_speed(scree_world* world, const scree_body* bodies, int count, double reach, int steps);

typedef struct
{
	double x, y, spin; // x, y: sum of m v; spin: sum of m r x v + I w about the origin
	double size;       // sum of m |v|
	double energy;     // kinetic energy, J
} Momentum;

Momentum momentum_of(scree_world* world, const scree_body* bodies, int count);

// Each function fails unless the pose or velocity of a body is bitwise equal to the expected value.
void expect_pose(scree_world* world, scree_body body, scree_pose expected);
void expect_velocity(scree_world* world, scree_body body, float x, float y, float spin);

#endif
