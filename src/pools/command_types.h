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
// apply to a collidable, other kinds to a body. For kinds below COMMAND_BODY, whole[1] is 1 if the body is disabled.
#define COMMAND_FORCE           0  // x, y: N
#define COMMAND_FORCE_AT        1  // force x, y, world point x, y
#define COMMAND_TORQUE          2  // x: N m
#define COMMAND_IMPULSE         3  // x, y: N s
#define COMMAND_IMPULSE_AT      4  // impulse x, y, world point x, y
#define COMMAND_ANGULAR_IMPULSE 5  // x: N m s
#define COMMAND_VELOCITY        6  // linear x, y, angular
#define COMMAND_POSE            7  // pose of the body's origin: x, y, cos, sin
#define COMMAND_MASS            8  // inverse mass, inverse inertia, local center x, y; keeps the origin
#define COMMAND_MOTION          9  // gravity scale, linear damping, angular damping; whole[0]: locks
#define COMMAND_LINEAR_VELOCITY 10 // x, y: m/s; the spin does not change
#define COMMAND_SPIN            11 // x: rad/s; the linear velocity does not change
#define COMMAND_BODY            12 // new body without mass: pose of its center of mass; whole: bits of its local center
#define COMMAND_CONTINUOUS      13 // ContinuousBody: first and parts in whole; way in x, reach in y
#define COMMAND_ENABLED         14 // whole[0]: 1, or 0 to disable the body
#define COMMAND_TARGET          15 // pose of the body's origin at the end of the step: x, y, cos, sin; whole[0]: locks
#define COMMAND_ARRIVE          16 // contents of COMMAND_TARGET, after that step: moves the body there and stops it
#define COMMAND_PLACE           17 // collidable without a body: x, y, cos, sin
#define COMMAND_COLLIDABLE      18 // local pose x, y, cos, sin; whole: attribute, body; contacts are created again
#define COMMAND_ATTRIBUTE       19 // whole[0]: another attribute of the same shape
#define COMMAND_FILTER          20 // bits of category and mask; whole: group; kind, plus REPORT_* bits from bit 8 on
#define COMMAND_NEXT            21 // whole[0]: 1 + index of the body's next collidable, 0 for none
#define COMMAND_REPORTS         22 // whole[0]: REPORT_* bits

#endif
