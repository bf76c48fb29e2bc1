// SPDX-License-Identifier: MIT
// field_types.h -- declares the data of fields, and of the forces that they exert on bodies.
#ifndef FIELD_TYPES_H
#define FIELD_TYPES_H
#include "pools/collidable_types.h"

// Kinds of fields, as in scree_field_type.
#define FIELD_UNIFORM  0
#define FIELD_RADIAL   1
#define FIELD_VORTEX   2
#define FIELD_DRAG     3
#define FIELD_WIND     4 // acts on shapes, as does FIELD_BUOYANCY; all other fields act on bodies
#define FIELD_BUOYANCY 5

#define FIELD_FEW (ARITY * ARITY) // with more fields, each ARITY fields get a common box, for faster searches

// Falloff of a radial field and a vortex, as in scree_field_falloff.
#define FALLOFF_CONSTANT       0
#define FALLOFF_LINEAR         1
#define FALLOFF_INVERSE        2
#define FALLOFF_INVERSE_SQUARE 3

typedef struct // 288 bytes: a field as the host uploads it
{
	Attribute shape; // shape of the region; it has only corners, normals, radius and count; count 0: everywhere
	Float4 pose;     // pose of the region in the frame of the body, or in the world if `body` is -1: x, y (m), cos, sin
	Word64 category, mask; // filter of the bodies or shapes on which the field acts
	int all;               // 1 if `category` and `mask` have all bits
	int body;              // index of the body to which the field is attached, -1 if there is none
	int kind, falloff;     // FIELD_*, FALLOFF_*
	// Values in the frame of the region; not all kinds of fields use all of them.
	float acceleration_x, acceleration_y; // m/s^2
	float force_x, force_y;               // N
	float velocity_x, velocity_y;         // m/s: velocity of the medium
	float strength;                       // m/s^2: acceleration of a radial field or vortex where the falloff is 1
	float radius, softening;              // m: radius of the falloff; length whose square is added to squared distances
	float density;                        // kg/m^2: density of the medium
	float drag, lift;                     // coefficients of a shape in the medium
	float linear_drag, quadratic_drag;    // kg/s, kg/m; linear_drag of a buoyancy field: kg/s per m^2
	float spin_drag, spin_drag_quadratic; // N m s, N m s^2: linear and quadratic drag of the rotation
	float unused[4];
} Field;

typedef struct // 48 bytes: state of a field in this step
{
	Float4 pose;              // pose of the region: x, y (m), cos, sin
	float center_x, center_y; // m: vector from the position in `pose` to the center of mass of the body
	float vx, vy, w;          // m/s, rad/s: velocity of the body
	float unused[3];
} FieldSample;

typedef struct // 48 bytes: the force of fields on a body, about its center of mass
{
	float fx, fy, torque;              // N, N m: part that does not depend on the velocity of the body
	float drag_x, drag_y, drag_torque; // N, N m: part that depends on the velocity of the body
	// Sums of k, k x, k y and k (x^2 + y^2), over points (x, y), m, with drag coefficients k, kg/s.
	float rate, rate_x, rate_y, rate_w;
	float unused[2];
} FieldForce;

#endif
