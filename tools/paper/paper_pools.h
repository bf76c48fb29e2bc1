// SPDX-License-Identifier: MIT
// paper_pools.h -- declares the pools of the paper's pipeline, for C and OpenCL C: each is an array of structs, as in
// Figure 1 of the paper.
//
// In the paper attributes have masses. Here each body has a mass, which is the sum of its collidables.
#ifndef PAPER_POOLS_H
#define PAPER_POOLS_H
#include "pools/pools.h"

typedef struct // 224 bytes
{
	// position (m) and rotation (cos, sin), relative to the body's center of mass; in the world if there is no body
	Float4 place;
	Attribute instance; // attribute in world coordinates; written by transform
	Filter filter;
	int attribute, body; // index of the attribute; index of the body, -1: no body
	int kind;            // KIND_*
	int unused[3];
} PaperCollidable;

typedef struct // 80 bytes without padding, because the hash covers all bytes
{
	Float4 pose;       // position of the center of mass (m), rotation (cos, sin); written by integrate and resolve
	Motion motion;     // damping, gravity scale and locks; forces and torque for the next step
	float vx, vy, w;   // m/s, rad/s; written by integrate and resolve
	float inv_mass;    // 1/kg; zero for static and kinematic bodies
	float inv_inertia; // 1/(kg m^2)
	int unused;
	Float2 local_center; // center of mass in the body's frame, m
} PaperBody;

typedef struct // 64 bytes without padding, because the hash covers all bytes
{
	int a, b;            // indices of the collidables, a < b
	int body_a, body_b;  // indices of their bodies; -1: no body
	Float2 normal;       // unit vector from collidable a to collidable b
	Float2 point[2];     // m: contact points, in world coordinates
	float separation[2]; // m; negative: the collidables overlap
	float friction, restitution;
	int count; // number of points, 1 or 2
	int unused;
} PaperContact;

typedef struct // constants of a step, which each stage gets by value
{
	float dt;                   // s
	float gravity_x, gravity_y; // m/s^2
	int attributes, bodies, collidables, contact_capacity;
} PaperStep;

// X(type, name, items). items: expression for the number of items, in terms of a PaperStep* step.
#define PAPER_POOLS(X)                                                                           \
	X(Attribute, attribute, step->attributes)                                                    \
	X(PaperCollidable, collidable, step->collidables)                                            \
	X(PaperBody, body, step->bodies)                                                             \
	X(PaperContact, contact, step->contact_capacity) /* in no order until the host sorts them */ \
	X(int, contact_count, 1)                         /* contacts found, also those that did not fit */

// X(name, items): the stages in the order of the step, with the pool over whose items a stage runs
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
