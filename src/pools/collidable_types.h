// SPDX-License-Identifier: MIT
// collidable_types.h -- declares the data of collidables: kinds, flags, attributes, surfaces and filters.
#ifndef COLLIDABLE_TYPES_H
#define COLLIDABLE_TYPES_H
#include "pools/limits.h"

// Types of hashed pools that contain indices. A hash contains the indices within the world (hash_types.h).
typedef int BodyIndex, AttributeIndex; // -1 for none
typedef Int2 CollidablePair;           // -1, -1 for none

// Bits of Filter.reports: events of a collidable that are listed for the user.
#define REPORT_TOUCHES  1u // begins and ends of touches of the collidable
#define REPORT_HITS     2u // hits that the collidable gives or receives
#define REPORT_APPROVAL 4u // contacts that need approval before they act

// More bits of Filter.reports: collidables that a sensor detects.
#define SENSOR_MOVING  0x100u // collidables of dynamic and kinematic bodies
#define SENSOR_STATIC  0x200u // collidables of static bodies, or without a body
#define SENSOR_SENSORS 0x400u // other sensors
#define SENSOR_SHIFT   8
#define SENSOR_BITS    (SENSOR_MOVING | SENSOR_STATIC | SENSOR_SENSORS)

// Bits of the pool collidable_flags.
#define COLLIDABLE_NEW_BOX 1         // the enlarged box is new in this step; old_box has the previous one
#define COLLIDABLE_FAST    2         // the motion in this step may exceed half of the distance at which contacts begin
#define COLLIDABLE_MOVING  4         // the motion in this step exceeds a small tolerance (SWEEP_REST)
#define COLLIDABLE_CHANGED (1 << 23) // the user changed its surface, or a refused step had found that it was moved
#define COLLIDABLE_SHIFTED (1 << 24) // static or kinematic, and moves, or was moved by the user
// Its contacts restarted since the last step, so those that touched have ended; only in a batch, or in a world that left one.
#define COLLIDABLE_RESTARTED (1 << 25)
#define GRAIN_SIZE           (2.0f * SPECULATIVE_DISTANCE) // m: thinner dynamic collidables have smaller tolerances
// First of the bits for thickness. Bit k of them is set for a dynamic collidable that is thinner than GRAIN_SIZE / 2^k.
// The tolerances of a contact are halved for each bit that one of its collidables has, because they could otherwise
// exceed the size of the smaller body.
#define COLLIDABLE_GRAIN 8 // bit 0
#define GRAIN_LEVELS     5
// First of the bits for the reach. Bit k of the reach is set if a collidable has bits for thickness and its reach is
// below 4 GRAIN_SIZE / 2^k. The bits for the reach scale the largest gap of contact points: a long body needs points at
// both ends.
#define COLLIDABLE_REACH  (COLLIDABLE_GRAIN << GRAIN_LEVELS)
#define COLLIDABLE_GRAINS (COLLIDABLE_GRAIN * ((1 << 2 * GRAIN_LEVELS) - 1))

#define KIND_DEAD      0
#define KIND_STATIC    1
#define KIND_KINEMATIC 2
#define KIND_DYNAMIC   3
#define KIND_FREE      4 // collidable in the world, without a body
#define KIND_SENSOR    8 // flag added to the kind of a sensor

typedef struct // 160 bytes
{
	Float2 vertices[8]; // m, counter-clockwise
	Float2 normals[8];  // outward unit normal of the edge from vertex i to vertex i + 1
	float radius;       // m
	int count;          // number of vertices: 1 circle, 2 capsule and segment, 3 to 8 polygon
	float friction, restitution, rolling_resistance;
	float tangent_speed; // m/s
	float margin;        // m: distance from the tight box to the enlarged box
	float reach;         // m: largest distance from the origin to a point of the shape
} Attribute;

typedef struct // 16 bytes: properties of an attribute that the kernels for rules read
{
	float up_x, up_y; // unit vector in the frame of the shape, toward the side from which a one-way platform is solid
	int one_way;      // 1 for a one-way platform
	int material;     // below MATERIALS; in a batch plus MATERIALS times the number of the table of its template
} Rule;

#define MATERIALS 256

// Bits of MaterialPair.sets.
#define MATERIAL_FRICTION    1
#define MATERIAL_RESTITUTION 2
#define MATERIAL_SPEED       4
#define MATERIAL_IGNORED     8

typedef struct // 16 bytes: surface of a pair of materials, which replaces the mix of two attributes
{
	float friction, restitution;
	float tangent_speed; // m/s, as in Attribute
	int sets;            // MATERIAL_* bits of the values that are set
} MaterialPair;

// Index of a pair of materials in the pool material_pair. In a batch the pool has several tables of equal size. Pairs with the same higher material are adjacent.
#define MATERIAL_PLACE(low, high) ((high) * ((high) + 1) / 2 + (low))

typedef struct // 24 bytes
{
	Word64 category, mask;
	int group;
	Word reports; // REPORT_* and SENSOR_* bits
} Filter;

typedef struct // 32 bytes: one memory sector
{
	float x, y, c, s;         // world pose
	float center_x, center_y; // m, world axes: vector from (x, y) to the body's center of mass
	int attribute, body;
} WorldShape;

#endif
