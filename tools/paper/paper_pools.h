// SPDX-License-Identifier: MIT
// paper_pools.h -- the pools of the paper's pipeline, for C and OpenCL C alike: one array of structs each, as in its Figure 1.
//
// The paper has mass in the attributes. Here it is in the body, because it is the sum of the body's collidables.
#ifndef PAPER_POOLS_H
#define PAPER_POOLS_H
#include "pools/pools.h"

typedef struct // 224 bytes
{
	Float4 place;       // pose in the frame of the body's center of mass, in the world without one: x, y (m), cos, sin
	Attribute instance; // the attribute in world coordinates; transform
	Filter filter;
	int attribute, body; // body -1 for none
	int kind;            // KIND_*
	int unused[3];
} PaperCollidable;

typedef struct // 80 bytes, none of them padding: the hash covers all
{
	Float4 pose;       // center of mass x, y (m), rotation cos, sin; integrate and resolve
	Motion motion;     // its forces are the accumulators
	float vx, vy, w;   // m/s, rad/s; integrate and resolve
	float inv_mass;    // 1/kg, zero for static and kinematic bodies
	float inv_inertia; // 1/(kg m^2)
	int unused;
	Float2 local_center; // center of mass in the body's frame, m
} PaperBody;

typedef struct // 64 bytes, none of them padding
{
	int a, b;            // collidables, a < b
	int body_a, body_b;  // theirs, -1 for none
	Float2 normal;       // from a to b
	Float2 point[2];     // m, world
	float separation[2]; // m, negative where they overlap
	float friction, restitution;
	int count; // points, 1 or 2
	int unused;
} PaperContact;

typedef struct // constants of one step, by value to every stage
{
	float dt;                   // s
	float gravity_x, gravity_y; // m/s^2
	int attributes, bodies, collidables, contact_capacity;
} PaperStep;

// X(type, name, items): items is the number of items, an expression in a PaperStep* step.
#define PAPER_POOLS(X)                                                                           \
	X(Attribute, attribute, step->attributes)                                                    \
	X(PaperCollidable, collidable, step->collidables)                                            \
	X(PaperBody, body, step->bodies)                                                             \
	X(PaperContact, contact, step->contact_capacity) /* in no order until the host sorts them */ \
	X(int, contact_count, 1)                         /* contacts found, also those that did not fit */

// X(name, items) in the order of the step
#define PAPER_STAGES(X)       \
	X(integrate, bodies)      \
	X(transform, collidables) \
	X(detect, collidables)

typedef struct
{
#define X(type, name, items) GLOBAL type* name;
	PAPER_POOLS(X)
#undef X
	PaperStep step;
} PaperPools;

#endif
