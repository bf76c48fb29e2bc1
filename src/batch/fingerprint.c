// SPDX-License-Identifier: MIT
// fingerprint.c -- computes the hash of what neither steps nor inputs of a world change.
//
// Worlds with equal fingerprints may exchange states.
#include "batch/fingerprint.h"
#include "batch/row_structure.h"
#include "dialect/hash_word.h"
#include "world/pool_values.h"
#include <string.h>

static Word64 hash_bytes(Word64 h, const void* bytes, size_t size)
{
	Word word;
	for (size_t k = 0; k < size; k += sizeof word)
	{
		memcpy(&word, (const char*)bytes + k, sizeof word);
		h = hash_word(h, word);
	}
	return h;
}

// Hashes a body without its mass, which inputs of a batch may set. Without such a mass, it follows from the collidables.
static Word64 hash_body(Word64 h, const Template* from, const scree_world* world, int i)
{
	const HostBody* host = world->host_bodies + i;
	if (!slots_in_use(&world->bodies, i))
		return hash_word(h, 0);
	h = hash_word(hash_word(hash_word(h, 1), (Word)host->type), host->locks);
#define X(name, least, most, value) h = hash_float(h, host->values.name);
#include "pools/body_values.def"
	return hash_float(h, from->image.sleep_threshold[i]);
}

_Static_assert(sizeof(scree_shape) % sizeof(Word) == 0, "a shape consists of words");

// Hashes an attribute without its surface.
static Word64 hash_core(Word64 h, const scree_attribute_def* def)
{
	h = hash_bytes(h, &def->shape, sizeof def->shape);
	h = hash_float(hash_float(hash_float(h, def->density), def->one_way.x), def->one_way.y);
	return hash_word(h, (Word)def->material);
}

static Word64 hash_collidable(Word64 h, const scree_world* world, int i)
{
	const HostCollidable* host = world->host_collidables + i;
	if (!slots_in_use(&world->collidables, i))
		return hash_word(h, 0);
	h = hash_word(hash_word(hash_word(h, 1), (Word)host->body), (Word)host->next);
	h = hash_float4(h, pose_row(host->pose));
	h = hash_bytes(h, &host->filter.category, sizeof host->filter.category);
	h = hash_bytes(h, &host->filter.mask, sizeof host->filter.mask);
	h = hash_word(hash_word(h, (Word)host->filter.group), report_bits(host));
	return hash_core(hash_word(h, host->sensor), world->attributes + host->attribute);
}

// Hashes a joint without the values that inputs of a batch change.
static Word64 hash_joint(Word64 h, const Template* from, const scree_world* world, int i)
{
	JointStructure joint;
	joint_structure(&from->image, i, &joint);
	joint.flags &= ~(JOINT_ACTIVE | JOINT_COLLIDES);
	h = hash_bytes(h, &joint, sizeof joint);
	return joint.flags & JOINT_THERE ? hash_word(h, world->host_joints[i].def.collide_connected) : h;
}

static Word64 hash_settings(Word64 h, const StepRequest* request)
{
	const scree_tuning* tuning = &request->tuning;
	const float values[] = {tuning->contact_hertz, tuning->contact_damping_ratio, tuning->contact_push_speed,
	                        tuning->restitution_threshold, tuning->max_speed};
	h = request->sleep ? hash_float(hash_word(h, 1), request->sleep_threshold) : h;
	return hash_bytes(h, values, sizeof values);
}

uint64_t fingerprint_of(const Template* from, const scree_world* world)
{
	Word64 h = hash_settings(from->hidden, &from->request);
	h = hash_word(hash_word(h, (Word)from->bodies), (Word)from->collidables);
	h = hash_word(hash_word(h, (Word)from->joints), from->pipeline.heavy);
	for (int k = 0; k < from->bodies; ++k)
		h = hash_body(h, from, world, k);
	for (int k = 0; k < from->collidables; ++k)
		h = hash_collidable(h, world, k);
	for (int k = 0; k < from->own_rules.attributes; ++k)
		if (from->own_rules.claimed[k])
			h = hash_word(h, (Word)k);
	for (int k = 0; k < from->joints; ++k)
		h = hash_joint(h, from, world, k);
	Word64 kinematics = 0; // their list has no order
	for (int k = 0; k < from->request.kinematic; ++k)
		kinematics += hash_word(0, (Word)from->kinematics[k]);
	return hash_mix(h + kinematics);
}
