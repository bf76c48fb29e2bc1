// SPDX-License-Identifier: MIT
// fingerprint.c -- computes the hash of what no step of a world changes.
//
// Worlds with equal fingerprints may exchange states.
#include "batch/fingerprint.h"
#include "dialect/hash_word.h"
#include <string.h>

// Bits of joint_flags that only calls of the user change.
#define JOINT_STRUCTURE (JOINT_THERE | JOINT_ACTIVE | JOINT_COLLIDES | JOINT_CAN_BREAK | JOINT_ACTS)

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

static Word64 hash_item(Word64 h, const Template* from, PoolId pool, int i)
{
	return hash_bytes(h, template_item(from, pool, i), pool_info[pool].bytes);
}

static Word64 hash_items(Word64 h, const Template* from, const PoolId* pools, int count, int i)
{
	for (int k = 0; k < count; ++k)
		h = hash_item(h, from, pools[k], i);
	return h;
}

#define HASH_ITEMS(h, from, pools, i) hash_items(h, from, pools, (int)(sizeof(pools) / sizeof *(pools)), i)

static Word64 hash_body(Word64 h, const Template* from, int i)
{
	static const PoolId pools[] = {POOL_local_center, POOL_continuous_body, POOL_sleep_threshold};
	const BodyState* body = from->image.body + i;
	const Motion* motion = from->image.motion + i;
	h = HASH_ITEMS(h, from, pools, i);
	h = hash_float(hash_float(h, body->inv_mass), body->inv_inertia);
#define X(name, least, most, value) h = hash_float(h, motion->name);
#include "pools/body_values.def"
	return hash_float(hash_float(h, motion->free_x), motion->free_y);
}

static Word64 hash_collidable(Word64 h, const Template* from, int i)
{
	static const PoolId pools[] = {POOL_collidable_kind, POOL_collidable_body, POOL_collidable_attribute,
	                               POOL_collidable_pose, POOL_next_collidable};
	static const PoolId shapes[] = {POOL_attribute, POOL_thickness, POOL_rule};
	const Filter* filter = from->image.filter + i;
	if (from->image.collidable_kind[i] == KIND_DEAD)
		return hash_word(h, KIND_DEAD);
	h = HASH_ITEMS(h, from, pools, i);
	h = hash_bytes(h, &filter->category, sizeof filter->category);
	h = hash_bytes(h, &filter->mask, sizeof filter->mask);
	h = hash_word(hash_word(h, (Word)filter->group), filter->reports);
	return HASH_ITEMS(h, from, shapes, from->image.collidable_attribute[i]);
}

// Hashes a joint without the values that inputs of a batch change.
static Word64 hash_joint_data(Word64 h, JointData data)
{
	for (int k = 0; k < JOINT_COORDINATES; ++k)
		data.lock[k].target = data.drive[k].speed = data.drive[k].motor_most = 0.0f;
	return hash_bytes(h, &data, sizeof data);
}

static Word64 hash_settings(Word64 h, const StepRequest* request)
{
	const scree_tuning* tuning = &request->tuning;
	const float values[] = {tuning->contact_hertz, tuning->contact_damping_ratio, tuning->contact_push_speed,
	                        tuning->restitution_threshold, tuning->max_speed};
	h = request->sleep ? hash_float(hash_word(h, 1), request->sleep_threshold) : h;
	return hash_bytes(h, values, sizeof values);
}

uint64_t fingerprint_of(const Template* from)
{
	Word64 h = hash_settings(from->hidden, &from->request);
	h = hash_word(hash_word(h, (Word)from->bodies), (Word)from->collidables);
	h = hash_word(hash_word(h, (Word)from->joints), (Word)from->attributes);
	for (int k = 0; k < from->bodies; ++k)
		h = hash_body(h, from, k);
	for (int k = 0; k < from->collidables; ++k)
		h = hash_collidable(h, from, k);
	for (int k = 0; k < from->joints; ++k)
	{
		int flags = from->image.joint_flags[k] & JOINT_STRUCTURE;
		h = hash_word(h, (Word)flags);
		if (flags & JOINT_THERE)
			h = hash_joint_data(h, from->image.joint_data[k]);
	}
	Word64 kinematics = 0; // their list has no order
	for (int k = 0; k < from->request.kinematic; ++k)
		kinematics += hash_word(0, (Word)from->kinematics[k]);
	return hash_mix(h + kinematics);
}
