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

void body_structure(const Template* from, int i, BodyStructure* to)
{
	const BodyState* body = from->image.body + i;
	const Motion* motion = from->image.motion + i;
	memset(to, 0, sizeof *to);
	to->local_center = from->image.local_center[i];
	to->continuous = from->image.continuous_body[i];
	to->sleep_threshold = from->image.sleep_threshold[i];
	to->inv_mass = body->inv_mass;
	to->inv_inertia = body->inv_inertia;
#define X(name, least, most, value) to->values.name = motion->name;
#include "pools/body_values.def"
	int sleep = from->image.sleep[i]; // a sleeping body keeps its locks there
	to->free_x = sleep ? (sleep & SLEEP_LOCK_X ? 0.0f : 1.0f) : motion->free_x;
	to->free_y = sleep ? (sleep & SLEEP_LOCK_Y ? 0.0f : 1.0f) : motion->free_y;
}

void collidable_structure(const Template* from, int i, CollidableStructure* to)
{
	const Filter* filter = from->image.filter + i;
	memset(to, 0, sizeof *to);
	to->kind = from->image.collidable_kind[i];
	if (to->kind == KIND_DEAD)
		return;
	to->body = from->image.collidable_body[i];
	to->attribute = from->image.collidable_attribute[i] - from->first_attribute;
	to->next = from->image.next_collidable[i];
	to->pose = from->image.collidable_pose[i];
	to->category = filter->category;
	to->mask = filter->mask;
	to->group = filter->group;
	to->reports = filter->reports;
}

void joint_structure(const Template* from, int i, JointStructure* to)
{
	memset(to, 0, sizeof *to);
	to->flags = from->image.joint_flags[i] & JOINT_STRUCTURE;
	if (!(to->flags & JOINT_THERE))
		return;
	to->data = from->image.joint_data[i];
	for (int k = 0; k < JOINT_COORDINATES; ++k)
		to->data.lock[k].target = to->data.drive[k].speed = to->data.drive[k].motor_most = 0.0f;
}

static Word64 hash_body(Word64 h, const Template* from, int i)
{
	BodyStructure body;
	body_structure(from, i, &body);
	return hash_bytes(h, &body, sizeof body);
}

static Word64 hash_collidable(Word64 h, const Template* from, int i)
{
	static const PoolId shapes[] = {POOL_attribute, POOL_thickness, POOL_rule};
	CollidableStructure collidable;
	collidable_structure(from, i, &collidable);
	h = hash_bytes(h, &collidable, sizeof collidable);
	for (size_t k = 0; k < sizeof shapes / sizeof *shapes && collidable.kind != KIND_DEAD; ++k)
		h = hash_bytes(h, template_item(from, shapes[k], from->image.collidable_attribute[i]),
		               pool_info[shapes[k]].bytes);
	return h;
}

static Word64 hash_joint(Word64 h, const Template* from, int i)
{
	JointStructure joint;
	joint_structure(from, i, &joint);
	return hash_bytes(h, &joint, sizeof joint);
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
		h = hash_joint(h, from, k);
	Word64 kinematics = 0; // their list has no order
	for (int k = 0; k < from->request.kinematic; ++k)
		kinematics += hash_word(0, (Word)from->kinematics[k]);
	return hash_mix(h + kinematics);
}
