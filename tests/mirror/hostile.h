// SPDX-License-Identifier: MIT
// hostile.h -- makes worlds at the limits of what calls accept, which become the templates of a batch.
#ifndef HOSTILE_H
#define HOSTILE_H
#include "mirror/dice.h"

#define MOST_BODIES      96 // maximum numbers of objects that calls and channels choose among
#define MOST_JOINTS      64
#define MOST_COLLIDABLES 250

typedef struct
{
	scree_body bodies[MOST_BODIES];
	scree_body_type types[MOST_BODIES];
	scree_joint joints[MOST_JOINTS];
	scree_collidable collidables[MOST_COLLIDABLES];
	bool sensors[MOST_COLLIDABLES];
	int body_count, joint_count, collidable_count;
} Objects;

typedef struct
{
	float size, spread; // m: largest half size of a shape; largest distance of a body from the center, along each axis
	scree_vec center;   // m
	int least, most;    // number of bodies
	bool uneven;        // densities differ by 10,000
	bool plate;         // all bodies lie on a plate, which becomes a hub
	bool explodes;      // bodies overlap, and get the largest speeds and forces
} Theme;

typedef struct // a world while it is made
{
	scree_world* world;
	uint64_t dice;
	const Theme* theme;
	Objects objects;
} Hostile;

// hostile_world.c: makes a world on the CPU. same_tuning: it has the default tuning, and sleeps.
scree_world* hostile_world(uint64_t seed, bool same_tuning);

// hostile_objects.c
void must(scree_status status);    // ends the program if a call failed that is correct in every world
void attempt(scree_status status); // ignores a refused call: values are at the limits, or beyond
void objects_list(Objects* objects, scree_world* world);
scree_shape hostile_shape(Hostile* h);
float hostile_size(Hostile* h);       // half of the size of a shape, m
scree_pose hostile_place(Hostile* h); // pose within two half sizes of the origin, for collidables and frames

void hostile_body(Hostile* h);                   // hostile_body.c: adds a body
void hostile_joint(Hostile* h, scree_path path); // hostile_joint.c: joins two of the listed bodies, if there are two
void hostile_change(Hostile* h); // hostile_change.c: makes a call that changes one of the listed objects

#endif
