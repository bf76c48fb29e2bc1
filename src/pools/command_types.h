// SPDX-License-Identifier: MIT
// command_types.h -- declares commands: edits in the form that the device applies.
#ifndef COMMAND_TYPES_H
#define COMMAND_TYPES_H
#include "dialect/dialect.h"

typedef struct // 32 bytes: a change that the user made between steps
{
	int kind;  // COMMAND_*
	int index; // body or collidable
	int whole[2];
	Float4 value;
} Command;

// Values of Command.kind. A comment gives the contents of Command.value and Command.whole. Kinds from COMMAND_PLACE on
// apply to a collidable, other kinds to a body. For kinds below COMMAND_BODY and for COMMAND_TARGET, whole[1] contains
// these bits:
#define COMMAND_DISABLED 1 // the body is disabled
#define COMMAND_JOINED   2 // the body is static or kinematic, and has joints or fields
#define COMMAND_NEW      4 // the command initializes a new body, and wakes nothing

#define COMMAND_FORCE           0  // x, y: N
#define COMMAND_FORCE_AT        1  // force x, y, N; world point x, y, m
#define COMMAND_TORQUE          2  // x: N m
#define COMMAND_IMPULSE         3  // x, y: N s
#define COMMAND_IMPULSE_AT      4  // impulse x, y, N s; world point x, y, m
#define COMMAND_ANGULAR_IMPULSE 5  // x: N m s
#define COMMAND_VELOCITY        6  // linear velocity x, y, m/s; angular velocity, rad/s
#define COMMAND_POSE            7  // pose of the body's origin: x, y, cos, sin
#define COMMAND_MASS            8  // inverse mass, inverse inertia, local center of mass x, y; the origin does not move
#define COMMAND_MOTION          9  // gravity scale, linear damping, angular damping; whole[0]: locks
#define COMMAND_LINEAR_VELOCITY 10 // x, y: m/s; the spin does not change
#define COMMAND_SPIN            11 // x: rad/s; the linear velocity does not change
#define COMMAND_BODY            12 // new body without mass: pose of its center of mass; whole: bits of its local center
#define COMMAND_CONTINUOUS      13 // members of ContinuousBody; whole[0]: first; whole[1]: parts; x: way; y: reach
#define COMMAND_ENABLED         14 // whole[0]: 1, or 0 to disable the body
#define COMMAND_TARGET          15 // pose of the body's origin at the end of the step: x, y, cos, sin; whole[0]: locks
#define COMMAND_ARRIVE          16 // same contents as COMMAND_TARGET; moves the body there after the step, and stops it
#define COMMAND_AWAKE           17 // whole[0]: 1 to wake the body, 0 to put its island to sleep
#define COMMAND_SLEEP           18 // x: value of the pool sleep_threshold; whole[0]: one of the values below
#define COMMAND_JOINTS          19 // the user changed joints of the body, which only wakes its island
#define COMMAND_PLACE           20 // collidable without a body: x, y, cos, sin
#define COMMAND_COLLIDABLE      21 // local pose x, y, cos, sin; whole[0]: attribute; whole[1]: body; no contacts remain
#define COMMAND_ATTRIBUTE       22 // whole[0]: another attribute of the same shape
#define COMMAND_FILTER          23 // bits of category and mask; whole[0]: group; whole[1]: kind | Filter.reports << 8
#define COMMAND_NEXT            24 // whole[0]: 1 + index of the body's next collidable; 0 if this is the last one
#define COMMAND_REPORTS         25 // whole[0]: Filter.reports

// Changes of single worlds of a batch (stages/batch/bay_edit.h).
// COMMAND_SURFACE: friction, restitution, rolling resistance, tangent speed; whole[0]: attribute of the collidable that gets
// them; whole[1]: attribute with its shape.
#define COMMAND_SURFACE 26
#define COMMAND_SHARE   27 // collidable; whole[0]: attribute
#define COMMAND_JOINT   28 // joint slot; whole[0]: JOINT_* bits that the user decides
#define COMMAND_ORIGIN  29 // bay; whole[0]: first attribute of its world; whole[1]: 1 if surfaces change

#define SLEEP_AS_BEFORE  0 // only the threshold changes
#define SLEEP_NOT_YET    1 // a new body, which is awake
#define SLEEP_FROM_START 2 // a new body, which sleeps

#endif
