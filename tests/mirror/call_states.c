// SPDX-License-Identifier: MIT
// call_states.c -- calls that save, load, take out and put back worlds of a batch, with their mirrors.
#include "mirror/mirrored.h"
#include <stdlib.h>
#include <string.h>

// Returns whether a state is refused that fits the origin of the template: it has more slots for contacts than a batch with a limit,
// no own mass of a body of which the template has one, or a pending target that the template has reached.
static bool refused_by_template(const Mirror* m, scree_status status)
{
	return status == SCREE_ERROR_INVALID &&
	       ((m->contact_limit > 0 && strstr(scree_error(), "slots for contacts")) ||
	        strstr(scree_error(), "own mass") || strstr(scree_error(), "pending targets"));
}

// Gives a world the state of another world alone, except for its gravity.
static bool load_alone(Mirror* m, int world, scree_world* from)
{
	replace_alone(m, world, clone_alone(from));
	NEED(m, scree_world_set_gravity(m->alone[world], m->gravity[world]));
	touches_begin(m, world);
	return true;
}

static int origin_of(const Mirror* m, int world) { return m->templates[m->template_of[world]].origin; }

static void put_in_bank(Mirror* m, char* state, size_t bytes, int from)
{
	scree_world_destroy(m->bank.world);
	free(m->bank.state);
	m->bank = (Bank){state, bytes, clone_alone(m->alone[from]), origin_of(m, from)};
}

// Loads a state that was saved from world `from`, whose template may have another structure.
static bool load_copy(Mirror* m, int32_t from, int32_t to, const char* state, size_t bytes)
{
	scree_status status = scree_batch_load(m->batch, &to, 1, state, bytes);
	bool other = origin_of(m, from) != origin_of(m, to); // worlds of the same calls by chance fit
	if (status == SCREE_ERROR_INVALID && (other || refused_by_template(m, status)))
		return true;
	if (!needed(m, status, "scree_batch_load"))
		return false;
	return load_alone(m, to, m->alone[from]);
}

bool call_copy(Mirror* m)
{
	int32_t from = random_below(&m->dice, m->worlds), to = random_below(&m->dice, m->worlds);
	size_t least = scree_batch_get_state_bytes(m->batch), bytes = least + (one_in(&m->dice, 2) ? 16 : 0);
	char* state = malloc(bytes);
	note(m, "copy world %d to world %d", (int)from, (int)to);
	bool good = needed(m, scree_batch_save(m->batch, &from, 1, state, bytes), "scree_batch_save") &&
	            load_copy(m, from, to, state, one_in(&m->dice, 2) ? 0 : bytes) && compare_worlds(m);
	if (good && one_in(&m->dice, 3))
		put_in_bank(m, state, bytes, from);
	else
		free(state);
	return good;
}

bool call_bank(Mirror* m)
{
	int32_t to = random_below(&m->dice, m->worlds);
	if (!m->bank.state || origin_of(m, to) != m->bank.origin)
		return true;
	note(m, "load the bank to world %d", (int)to);
	scree_status status = scree_batch_load(m->batch, &to, 1, m->bank.state, m->bank.bytes);
	if (refused_by_template(m, status))
		return compare_worlds(m);
	if (!needed(m, status, "scree_batch_load"))
		return false;
	return load_alone(m, to, m->bank.world) && compare_worlds(m);
}

// Takes a world out; from now on it is the mirror.
bool call_extract(Mirror* m)
{
	int k = random_below(&m->dice, m->worlds);
	scree_world* taken;
	note(m, "extract world %d", k);
	NEED(m, scree_batch_extract(m->batch, k, NULL, &taken));
	bool same = world_hash(taken) == world_hash(m->alone[k]);
	replace_alone(m, k, taken);
	return same || fault(m, "world %d of template %d has another hash when it was taken out", k, m->template_of[k]);
}

static void change_clone(Mirror* m, scree_world* clone, const Objects* o)
{
	uint64_t* dice = &m->dice;
	int k = random_below(dice, o->body_count);
	scree_body body = o->bodies[k];
	switch (random_below(dice, 7))
	{
	case 0:
		if (o->types[k] != SCREE_BODY_STATIC)
			attempt(scree_body_set_velocity(clone, body, (scree_velocity){{1.0f, 2.0f}, -1.0f}));
		break;
	case 1:
		attempt(scree_body_set_pose(clone, body, scree_pose_make(random_between(dice, -1.0f, 1.0f), 0.0f, 1.0f)));
		break;
	case 2:
		if (o->types[k] == SCREE_BODY_DYNAMIC)
			attempt(scree_body_apply_force(clone, body, (scree_vec){5.0f, 5.0f}));
		break;
	case 3:
		attempt(scree_body_set_enabled(clone, body, one_in(dice, 2)));
		break;
	case 4:
		attempt(scree_world_step(clone, 1.0f / 60.0f, 4));
		break;
	case 5:
		if (o->joint_count > 0)
		{
			scree_joint joint = o->joints[random_below(dice, o->joint_count)];
			attempt(scree_joint_set_enabled(clone, joint, one_in(dice, 2)));
		}
		break;
	default:
		attempt(scree_body_set_awake(clone, body, one_in(dice, 2)));
	}
}

// Puts a changed clone of a world into a world of the same template. It is refused, for instance, if it has too many contacts.
bool call_insert(Mirror* m)
{
	int to = random_below(&m->dice, m->worlds), from = random_below(&m->dice, m->worlds);
	const Objects* o = &m->templates[m->template_of[from]].objects;
	if (m->template_of[to] != m->template_of[from])
		return true;
	note(m, "insert a clone of world %d to world %d", from, to);
	scree_world* clone = clone_alone(m->alone[from]);
	for (int k = 0; k < 3 && o->body_count > 0; ++k)
		change_clone(m, clone, o);
	scree_status status = scree_batch_insert(m->batch, to, clone);
	if (status == SCREE_OK)
	{
		replace_alone(m, to, clone);
		NEED(m, scree_world_set_gravity(clone, m->gravity[to]));
		touches_begin(m, to);
		return compare_worlds(m);
	}
	scree_world_destroy(clone);
	return (status == SCREE_ERROR_INVALID || needed(m, status, "scree_batch_insert")) && compare_worlds(m);
}
