// SPDX-License-Identifier: MIT
// body_types.h -- declares the data of bodies: state, motion, presses, and data for continuous collision.
#ifndef BODY_TYPES_H
#define BODY_TYPES_H
#include "pools/limits.h"

#define CONTINUOUS_TRAVEL 0.2f    // maximum motion in a step without a test of the path, as a fraction of the thickness
#define CONTINUOUS_CROSS  1.0f    // the same if only moving shapes are near: to tunnel, a body must pass their middle
#define KINEMATIC_FEW     8       // maximum number of kinematic bodies that continuous collision tests without the tree
#define PRESS_FROM        2.0e-5f // m: overlap with a kinematic or static body above which a contact starts a press
#define PRESS_START       0.0001f // m: overlap with a static body above which a step searches for presses
#define PRESS_GAP         0.01f   // m: gap of a joint above which the joint presses a body that cannot follow
#define PRESS_MOST        0.015f  // m: maximum depth of a pressed body in a static one; loads need overlap
#define PRESS_MAY_WAIT    1       // bit of the argument of the press kernels: the constraint layout may have changed
#define PRESS_AGAIN       2       // bit of this argument: the round is not the first one
#define CONTINUOUS_SHARE  2       // least number of collidables of a body per work-item of the kernel continuous
#define CONTINUOUS_PARTS  64      // maximum number of work-items per body in the kernel continuous

typedef struct // 16 bytes: data of a dynamic body for continuous collision
{
	int first;   // 1 + index of the body's first collidable, 0 for none
	int parts;   // number of work-items that share the collidables of the body
	float way;   // m: CONTINUOUS_TRAVEL times the thickness of the body's thinnest collidable
	float reach; // m: upper bound of the distances from the center of mass to points of the body
} ContinuousBody;

typedef struct // 32 bytes: presses on a body
{
	int way[2];         // ways of the press by static and by kinematic bodies: contacts left and direction; 0: none
	int depth;          // float bits of the body's depth in a static body into which it is pressed, m
	int speed;          // float bits of the speed of the latest press, m/s
	int left;           // number of further steps in which the latest press limits the speed of the body
	int tight;          // 1 if the body is deep in another body
	float before, spun; // speed and spin of the body at the start of the step, m/s, rad/s
} Press;

typedef struct // 32 bytes: one memory sector, gathered at random by the solver
{
	float vx, vy, w;   // m/s, rad/s
	float inv_mass;    // 1/kg, 0 for static and kinematic bodies, which are never written
	float dx, dy, da;  // m, rad: motion since the start of the step
	float inv_inertia; // 1/(kg m^2)
} BodyState;

typedef struct // 32 bytes
{
	float fx, fy, torque;                       // N, N m; finalize clears them
#define X(name, least, most, value) float name; // 0 for static and kinematic bodies
#include "pools/body_values.def"
	float free_x, free_y; // 1, or 0 for a locked axis
} Motion;

typedef struct
{
#define X(name, least, most, value) float name;
#include "pools/body_values.def"
} BodyValues;

typedef struct // 16 bytes: the velocity of a disabled body
{
	float vx, vy, w;
	float stored; // 1, or 0 for an enabled body
} StoredVelocity;

typedef struct // 32 bytes: a body that moved, as listed for the user
{
	Float4 pose; // pose of the center of mass: x, y, cos, sin
	float vx, vy, w;
	int body;
} MovedBody;

typedef struct // indices of kinematic bodies; not in Step, as a variable index would put Step on the stack of a GPU
{
	int body[KINEMATIC_FEW];
} Kinematics;

#endif
