// SPDX-License-Identifier: MIT
// body_types.h -- bodies: their state, their motion, presses, and data for continuous collision.
#ifndef BODY_TYPES_H
#define BODY_TYPES_H
#include "pools/limits.h"

#define CONTINUOUS_TRAVEL 0.2f    // share of its thickness that a body may travel in a step before its path is tested
#define CONTINUOUS_CROSS  1.0f    // the same if only moving shapes are near: the body must get past the middle of one
#define KINEMATIC_FEW     8       // with more kinematic bodies, continuous collision searches the tree for those nearby
#define PRESS_FROM        2.0e-5f // m: overlap with a kinematic or static body from which on a contact starts a press
#define PRESS_START       0.0001f // m: the same for a static body, in the search for bodies that may be pressed
#define PRESS_GAP         0.01f   // m: gap of a joint from which on it drags a body that cannot follow
// m: greatest depth of a press into a static body; less would remove the small overlap at which contacts carry a load
#define PRESS_MOST       0.015f
#define PRESS_MAY_WAIT   1  // bit of the argument of the press kernels: the constraint layout may have changed
#define PRESS_AGAIN      2  // the same: this is not the first round
#define CONTINUOUS_SHARE 2  // fewest collidables of a body per work-item of continuous
#define CONTINUOUS_PARTS 64 // most work-items per body

typedef struct // 16 bytes: data of a dynamic body for continuous collision
{
	int first;   // 1 + index of its first collidable, 0 for none
	int parts;   // number of work-items that share its collidables
	float way;   // m: CONTINUOUS_TRAVEL times the thickness of its thinnest collidable
	float reach; // m: bound of the distance of its points from the center of mass
} ContinuousBody;

typedef struct // 32 bytes: presses on a body
{
	int way[2];         // presses by static and by kinematic bodies: hops left and direction, 0 for none
	int depth;          // float bits of its depth in a static body into which it is pressed, m
	int speed;          // float bits of the speed of the latest press, m/s
	int left;           // steps for which it gets no faster than that press
	int tight;          // 1 if it is still deep in another body
	float before, spun; // its own speed and spin at the start of the step, m/s, rad/s
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

typedef struct // 32 bytes: a body that moved, as reported to the user
{
	Float4 pose; // pose of the center of mass: x, y, cos, sin
	float vx, vy, w;
	int body;
} MovedBody;

// Step does not contain them, because an index that is not constant would put Step on a GPU's stack.
typedef struct
{
	int body[KINEMATIC_FEW];
} Kinematics;

#endif
