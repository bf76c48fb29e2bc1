// SPDX-License-Identifier: MIT
// body_types.h -- declares the data of bodies: state, motion, presses, and data for continuous collision.
#ifndef BODY_TYPES_H
#define BODY_TYPES_H
#include "pools/limits.h"

#define CONTINUOUS_TRAVEL 0.2f    // maximum motion in a step without a path test, as a fraction of half the thickness
#define CONTINUOUS_CROSS  1.0f    // the same relative to a dynamic body: to tunnel, one must pass the other's middle
#define KINEMATIC_FEW     8       // maximum number of kinematic bodies that continuous collision tests without the tree
#define PRESS_FROM        2.0e-5f // m: overlap with a kinematic or static body above which a contact starts a way
#define PRESS_START       0.0001f // m: overlap with a static body above which a step searches for presses
#define PRESS_GAP         0.01f   // m: gap of a joint at an immovable body above which it presses the other body
#define PRESS_MOST        0.015f  // m: maximum depth of a pressed body in a static one; only an overlap carries a load
#define PRESS_MAY_WAIT    1       // bit of the argument of the press kernels: the constraint layout may have changed
#define PRESS_AGAIN       2       // bit of this argument: the round is the second or a later one
#define CONTINUOUS_SHARE  2       // minimum number of collidables per work-item if several share a body (continuous.h)
#define CONTINUOUS_PARTS  64      // maximum number of work-items per body in the kernel continuous

// Bits of the pool sleep. The lower bits are 1 + the number of the island, below MAX_ITEMS + 1.
#define SLEEP_LOCK_X (1 << 26) // the motion along x was locked when the body fell asleep
#define SLEEP_LOCK_Y (1 << 27) // the same along y
#define SLEEP_ISLAND (SLEEP_LOCK_X - 1)
#define SLEEP_TIME   0.5f // s: time at rest before an island falls asleep; less: bodies that only pause fall asleep
#define SLEEP_STEPS  8    // every step of this number searches for islands; larger: bodies fall asleep later

// s: less than SLEEP_TIME, so that a body that loses a touch in a step does not fall asleep in it (body_unsettle)
#define STILL_ALMOST 0.4999f

// Values of the pool still below 0.
#define STILL_FORCED  (-1.0f) // the user puts the island of the body to sleep
#define STILL_STIRRED (-2.0f) // the user moved the body, so its island stays awake in this step
// Created asleep since the last step, so its parts may still be added. The body ignores marks in the pool wake, which may
// be those of an earlier body of its slot; island_wake ends this value.
#define STILL_MADE  (-3.0f)
#define STILL_MOVED (-4.0f) // static or kinematic, has joints or fields, and was moved by the user

// Values of the pool wake, in rising order of strength.
#define WAKE_USER  1 // the user changed a body of the island; a later call may still put the island to sleep
#define WAKE_WORLD 2 // a touch, a joint, a support or a field wakes the island, whatever the user calls

// Arguments of the kernel sleep_begin: the step never searches for islands, does so if some body has been at rest for
// SLEEP_TIME, or does so in any case.
#define SEARCH_NEVER  0
#define SEARCH_DROWSY 1
#define SEARCH_NOW    2
#define SEARCH_BAYS   3 // in a batch: if bay_sleep found a world whose islands are to be searched

// Bits of the pool island_state.
#define ISLAND_RESTLESS 1 // some awake body has not been at rest for SLEEP_TIME
#define ISLAND_FORCED   2 // the user puts the island to sleep
#define ISLAND_WOKEN    4 // some sleeping body of the island is woken
#define ISLAND_STIRRED  8 // the island must not be put to sleep in this step

typedef struct // 16 bytes: data of a dynamic body for continuous collision
{
	int first;   // 1 + index of the body's first collidable; 0 for a body without collidables
	int parts;   // number of work-items that share the collidables of the body
	float way;   // m: CONTINUOUS_TRAVEL times the half thickness of the body's thinnest collidable
	float reach; // m: upper bound of the distances from the center of mass to points of the body
} ContinuousBody;

typedef struct // 32 bytes: presses on a body
{
	int way[2];         // codes (press_code) of the ways that begin at static [0] and at kinematic bodies [1]; 0: none
	int depth;          // float bits of the body's depth in a static body into which it is pressed, m
	int speed;          // float bits of the speed of the latest press, m/s
	int left;           // number of steps in which the body's speed is still limited after a press
	int tight;          // 1 if it overlaps another body by more than PRESS_MOST; `left` then stays the same
	float before, spun; // m/s, rad/s: linear and angular speed of the body at the start of the step
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
	float free_x, free_y; // 1 for a free axis, 0 for a locked one
} Motion;

typedef struct
{
#define X(name, least, most, value) float name;
#include "pools/body_values.def"
} BodyValues;

typedef struct // 16 bytes: the velocity of a disabled body
{
	float vx, vy, w;
	float stored; // 1 if the body is disabled, otherwise 0
} StoredVelocity;

typedef struct // 32 bytes: a body that moved, as listed for the user
{
	Float4 pose; // pose of the center of mass: x, y, cos, sin
	float vx, vy, w;
	int body; // index, plus MOVED_ASLEEP if the body sleeps
} MovedBody;

#define MOVED_ASLEEP MAX_ITEMS

typedef struct // indices of kinematic bodies; not in Step, as a variable index would put Step on the stack of a GPU
{
	int body[KINEMATIC_FEW];
} Kinematics;

#endif
