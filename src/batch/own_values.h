// SPDX-License-Identifier: MIT
// own_values.h -- declares the own values of a world of a batch: masses, surfaces, disabled bodies and joints.
//
// Inputs change these values in single worlds. The hash of a world contains the indices of the attributes of its collidables,
// which depend on the order of the user's calls, so own values contain the indices that the world has alone.
#ifndef OWN_VALUES_H
#define OWN_VALUES_H
#include "world/world.h"

typedef struct // 20 bytes
{
	scree_mass mass; // mass that the user set; mass.mass is 0 if it follows from the collidables
	int disabled;    // 1 if the body is disabled
} OwnBody;

typedef struct // 20 bytes
{
	float friction, restitution, rolling_resistance, tangent_speed;
	int attribute; // index of the attribute in the world alone
} OwnCollidable;

#define OWN_JOINT_DISABLED 1
#define OWN_JOINT_CHAINED  2 // the joint was in a chain or branch in the last step; the next one searches for them again

typedef struct // a view of the own values of a world, which are adjacent
{
	OwnBody* body;
	OwnCollidable* collidable;
	int* joint; // OWN_JOINT_* bits
	int bodies, collidables, joints;
} Own;

typedef struct // data of a template on which the indices of attributes depend
{
	int* core;        // per collidable: lowest index of a collidable whose attributes differ at most in their surface
	int* attribute;   // per collidable: index of its attribute in the template
	uint8_t* claimed; // per attribute: 1 if scree_attribute_create made it
	int attributes;   // number of these
} OwnRules;

// Returns the size of own values, bytes: a multiple of 16.
size_t own_bytes(int bodies, int collidables, int joints);
Own own_view(char* bytes, int bodies, int collidables, int joints);

// Reads the own values of a world, and their rules. joints: number of joint slots on the device. The caller owns both: scree_release, own_rules_close.
scree_status own_read(const scree_world* world, const char* function, int joints, char** bytes, OwnRules* rules);
void own_rules_close(OwnRules* rules);

// Sets the surface of a collidable, as scree_collidable_set_surface does. Returns false if it has this surface already.
bool own_set_surface(Own own, const OwnRules* rules, int index, const float surface[4]);

// Returns what own values add to hidden_hash_rest. world: the template.
uint64_t own_hash(const scree_world* world, Own own);

// Gives an ordinary world, which is a copy of the template with the own values `before`, other own values.
scree_status own_apply(scree_world* world, const char* function, Own before, Own own);

// Lets the next step of this world restart the joints that leave or enter a chain, if the chains were not searched for yet.
scree_status own_chains_before(scree_world* world, Own own);

#endif
