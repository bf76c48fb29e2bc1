// SPDX-License-Identifier: MIT
// run_call.c -- makes one call of a program on one world, through the public interface.
#include "programs/run_call.h"
#include <math.h>
#include <string.h>

// ---------------------------------------------------------------------------------------------------------------
// arguments
// ---------------------------------------------------------------------------------------------------------------

float call_real(const CallRun* r, const char* name) { return call_value(r->call, name); }

int call_whole(const CallRun* r, const char* name)
{
	float x = call_real(r, name);
	return x > -1e6f && x < 1e6f ? (int)x : 0;
}

scree_vec call_vec(const CallRun* r, const char* x, const char* y)
{
	return (scree_vec){call_real(r, x), call_real(r, y)};
}

scree_body call_body(const CallRun* r, int k)
{
	return k >= 0 && k < MOST_NAMES ? r->names->bodies[k] : (scree_body){0, 0};
}

scree_attribute call_attribute(const CallRun* r, const char* name)
{
	int k = call_whole(r, name);
	return k >= 0 && k < MOST_NAMES ? r->names->attributes[k] : (scree_attribute){0, 0};
}

scree_pose call_pose(const CallRun* r)
{
	return (scree_pose){call_vec(r, "x", "y"), scree_rot_make(call_real(r, "angle"))};
}

int call_batch(const CallRun* r, const char* name)
{
	int count = call_whole(r, "count"), first = call_whole(r, name);
	count = count < MOST_BATCH ? count : MOST_BATCH;
	return first < 0 || first + count > MOST_NAMES ? 0 : count;
}

scree_filter call_filter(const CallRun* r)
{
	int mask = call_whole(r, "mask");
	return (scree_filter){(uint64_t)call_whole(r, "category"), (uint64_t)(int64_t)mask, call_whole(r, "group")};
}

scree_collidable call_collidable(const CallRun* r)
{
	int k = call_whole(r, "collidable"), count = 0, which = call_whole(r, "which");
	if (k >= 0)
		return k < MOST_NAMES ? r->names->collidables[k] : (scree_collidable){0, 0};
	scree_collidable list[64];
	scree_body body = call_body(r, call_whole(r, "body"));
	if (scree_body_get_collidables(r->world, body, list, 64, &count) != SCREE_OK || count == 0)
		return (scree_collidable){0, 0};
	count = count < 64 ? count : 64;
	return list[((which % count) + count) % count];
}

uint32_t call_random(uint32_t* seed) { return *seed = *seed * 1664525u + 1013904223u; }
float call_random_part(uint32_t* seed) { return (float)(call_random(seed) >> 8) / 16777216.0f; }

// ---------------------------------------------------------------------------------------------------------------
// rules
// ---------------------------------------------------------------------------------------------------------------

static scree_status run_exclude(const CallRun* r)
{
	enum
	{
		MOST = 64
	};
	scree_body first[MOST], second[MOST], other = call_body(r, call_whole(r, "other"));
	bool excluded[MOST];
	int count = call_whole(r, "count"), body = call_whole(r, "body");
	if (count == 0)
		return scree_body_set_excluded(r->world, call_body(r, body), other, call_whole(r, "excluded") != 0);
	count = count < MOST ? count : MOST;
	for (int k = 0; k < count; ++k)
	{
		first[k] = call_body(r, body + k);
		second[k] = other;
		excluded[k] = call_whole(r, "excluded") != 0;
	}
	return scree_bodies_set_excluded(r->world, first, second, excluded, count);
}

static scree_status run_answer(const CallRun* r)
{
	enum
	{
		MOST = 4096
	};
	bool answers[MOST];
	scree_events events;
	scree_status status = scree_world_get_events(r->world, &events);
	if (status != SCREE_OK)
		return status;
	for (int k = 0; k < events.approval_count && k < MOST; ++k)
		answers[k] = call_whole(r, "bits") >> k % 8 & 1;
	return scree_world_approve_contacts(r->world, answers, events.approval_count < MOST ? events.approval_count : MOST);
}

static scree_status run_material(const CallRun* r)
{
	scree_material_pair pair = scree_material_pair_default();
	float friction = call_real(r, "friction"), restitution = call_real(r, "restitution"),
	      tangent = call_real(r, "tangent");
	if (friction != -1.0f)
		pair.friction = friction;
	if (restitution != -1.0f)
		pair.restitution = restitution;
	if (tangent != 1e30f)
		pair.tangent_speed = tangent;
	pair.ignored = call_whole(r, "ignored") != 0;
	return scree_world_set_material_pair(r->world, call_whole(r, "a"), call_whole(r, "b"),
	                                     call_whole(r, "unset") ? NULL : &pair);
}

// ---------------------------------------------------------------------------------------------------------------
// the world
// ---------------------------------------------------------------------------------------------------------------

#define MOST_READ 512

// Returns whether the contacts of a body are exactly the entries of the list `all` that contain the body, in the same
// order.
static bool contacts_agree(const CallRun* r, scree_body body, const scree_contact* all, int count)
{
	static scree_contact some[MOST_READ];
	int listed = 0, next = 0;
	if (scree_body_get_contacts(r->world, body, some, MOST_READ, &listed) != SCREE_OK)
		return false;
	for (int k = 0; k < count; ++k)
	{
		if (!scree_body_equals(all[k].body_a, body) && !scree_body_equals(all[k].body_b, body))
			continue;
		if (next == listed || memcmp(&some[next++], &all[k], sizeof all[k]) != 0)
			return false;
	}
	return next == listed;
}

static scree_status run_read(const CallRun* r)
{
	static scree_contact contacts[MOST_READ];
	static scree_render_row shown[MOST_READ];
	static scree_pose between[MOST_READ];
	uint64_t word = HASH_BEGIN;
	int counts[3] = {0};
	scree_status status = scree_world_get_contacts(r->world, contacts, MOST_READ, &counts[0]);
	scree_body body = call_body(r, call_whole(r, "body"));
	if (status == SCREE_OK && counts[0] <= MOST_READ && scree_body_is_valid(r->world, body) &&
	    !contacts_agree(r, body, contacts, counts[0]))
		return SCREE_ERROR_DEVICE_FAILED;
	for (int k = 0; k < counts[0] && k < MOST_READ && status == SCREE_OK; ++k)
		word = mix_contact(word, &contacts[k]);
	if (status == SCREE_OK)
		status = scree_world_get_overlaps(r->world, contacts, 0, &counts[1]);
	if (status == SCREE_OK)
		status = scree_world_get_render_rows(r->world, shown, MOST_READ, &counts[2]);
	if (status == SCREE_OK)
		word = hash_words(word, shown, (size_t)(counts[2] < MOST_READ ? counts[2] : MOST_READ) * sizeof shown[0]);
	int listed = 0;
	if (status == SCREE_OK) // these poses differ after a move or a recovery, which only the other world has
		status = scree_world_get_interpolated(r->world, 0.3f, NULL, between, MOST_READ, &listed);
	word = hash_words(word, counts, sizeof counts);
	scree_counters c;
	if (status == SCREE_OK)
		status = scree_world_get_counters(r->world, &c);
	if (status == SCREE_OK)
	{
		int more[] = {c.bodies, c.dynamic_bodies, c.collidables,  c.contacts,     c.touching,
		              c.colors, c.spokes,         c.new_contacts, c.frozen_bodies};
		float depths[] = {c.penetration, c.joint_gap};
		word = hash_words(hash_words(word, more, sizeof more), depths, sizeof depths);
	}
	scree_pose pose = {0};
	scree_velocity velocity = {0};
	if (status == SCREE_OK && scree_body_is_valid(r->world, body))
	{
		status = scree_body_get_pose(r->world, body, &pose);
		if (status == SCREE_OK)
			status = scree_body_get_velocity(r->world, body, &velocity);
		word = hash_words(hash_words(word, &pose, sizeof pose), &velocity, sizeof velocity);
	}
	if (status == SCREE_OK)
		status = read_sleep(r, body, &word);
	if (status == SCREE_OK)
		status = read_joints(r, &word);
	if (status == SCREE_OK)
		status = read_paths(r, &word);
	if (status == SCREE_OK)
		status = read_fields(r, &word);
	if (status == SCREE_OK)
		status = read_drawing(r, &word);
	r->left->word = word;
	return status;
}

static scree_status run_tuning(const CallRun* r)
{
	scree_tuning tuning;
	scree_status status = scree_world_get_tuning(r->world, &tuning);
	tuning.contact_hertz = call_real(r, "hertz");
	tuning.contact_damping_ratio = call_real(r, "ratio");
	tuning.contact_push_speed = call_real(r, "push");
	tuning.restitution_threshold = call_real(r, "threshold");
	tuning.max_speed = call_real(r, "max_speed");
	tuning.sleep = call_whole(r, "sleep") != 0;
	tuning.sleep_threshold = call_real(r, "sleep_threshold");
	return status == SCREE_OK ? scree_world_set_tuning(r->world, &tuning) : status;
}

static scree_status run_clear(const CallRun* r)
{
	static scree_body bodies[MOST_NAMES];
	static scree_collidable collidables[MOST_NAMES];
	int count;
	scree_status status = scree_world_get_bodies(r->world, bodies, MOST_NAMES, &count);
	if (status == SCREE_OK)
		status = scree_bodies_destroy(r->world, bodies, count < MOST_NAMES ? count : MOST_NAMES);
	if (status == SCREE_OK)
		status = scree_body_get_collidables(r->world, (scree_body){0, 0}, collidables, MOST_NAMES, &count);
	if (status == SCREE_OK)
		status = scree_collidables_destroy(r->world, collidables, count < MOST_NAMES ? count : MOST_NAMES);
	if (status == SCREE_OK)
		status = clear_paths(r);
	if (status == SCREE_OK)
		status = clear_fields(r);
	const Open open = r->names->open; // keeps the open touches and visits, which end with the next step
	memset(r->names, 0, sizeof *r->names);
	r->names->open = open;
	return status;
}

static scree_status run_forge(const CallRun* r)
{
	struct Names* names = r->names;
	int number = call_whole(r, "number");
	uint32_t index = (uint32_t)call_whole(r, "index"), generation = (uint32_t)call_whole(r, "generation");
	if (number < 0 || number >= MOST_NAMES)
		return SCREE_OK;
	switch (call_whole(r, "type"))
	{
#define FORGE(type, objects)                             \
	case type:                                           \
		names->objects[number].index += index;           \
		names->objects[number].generation += generation; \
		break;
		FORGE(0, bodies)
		FORGE(1, collidables)
		FORGE(2, attributes)
		FORGE(3, joints)
		FORGE(4, paths)
		FORGE(5, fields)
	default:
		break;
	}
	return SCREE_OK;
}

static scree_status run_move(const CallRun* r)
{
	if (!r->place->other[0])
		return SCREE_OK;
	return scree_world_move(r->world, call_whole(r, "back") ? r->home : r->place->other);
}

scree_status run_call(const CallRun* r)
{
	switch (r->call->kind)
	{
	case CALL_box:
	case CALL_circle:
	case CALL_capsule:
	case CALL_segment:
	case CALL_polygon:
	case CALL_hull:
	case CALL_like:
	case CALL_drop:
		return run_attribute(r);
	case CALL_collidable:
	case CALL_remove:
	case CALL_filter:
	case CALL_reports:
	case CALL_sensor:
	case CALL_dress:
	case CALL_place:
		return run_collidable(r);
	case CALL_own_bodies:
	case CALL_own_collidable:
	case CALL_surface:
	case CALL_adopt:
		return run_own(r);
	case CALL_material:
		return run_material(r);
	case CALL_exclude:
		return run_exclude(r);
	case CALL_answer:
		return run_answer(r);
	case CALL_path:
	case CALL_path_destroy:
		return run_path(r);
	case CALL_field:
	case CALL_field_destroy:
	case CALL_field_pose:
	case CALL_field_enabled:
		return run_field(r);
	case CALL_joint:
	case CALL_joints:
	case CALL_joint_destroy:
	case CALL_joint_coordinate:
	case CALL_joint_target:
	case CALL_joint_speed:
	case CALL_joint_frames:
	case CALL_joint_ratio:
	case CALL_joint_bases:
	case CALL_joint_stiffness:
	case CALL_joint_enabled:
	case CALL_joint_elliptic:
	case CALL_joint_thresholds:
	case CALL_collide_connected:
		return run_joint(r);
	case CALL_awake:
	case CALL_awake_box:
	case CALL_awake_world:
	case CALL_awake_get:
	case CALL_sleep_threshold:
	case CALL_stays_awake:
		return run_sleep(r);
	case CALL_gravity:
		return scree_world_set_gravity(r->world, call_vec(r, "x", "y"));
	case CALL_tuning:
		return run_tuning(r);
	case CALL_hits:
		return scree_world_set_hit_thresholds(r->world, call_real(r, "speed"), call_real(r, "impulse"));
	case CALL_step:
		return run_step(r);
	case CALL_move:
		return run_move(r);
	case CALL_blast:
		return run_blast(r);
	case CALL_walk:
		return run_walk(r);
	case CALL_ask:
		return run_ask(r);
	case CALL_read:
		return run_read(r);
	case CALL_save:
		return run_save(r);
	case CALL_load:
		return run_load(r);
	case CALL_forge:
		return run_forge(r);
	case CALL_clear:
		return run_clear(r);
	case CALL_world:
	case CALL_KINDS:
		return SCREE_OK;
	default:
		return run_body(r);
	}
}

scree_status run_world(const Place* place, const Call* call, scree_world** world)
{
	CallRun t = {.call = call};
	scree_world_def def = scree_world_def_default();
	def.device = place->device;
	def.threads = place->threads;
	def.lanes = place->lanes;
	def.gravity = call_vec(&t, "gravity_x", "gravity_y");
	def.contact_hertz = call_real(&t, "hertz");
	def.contact_damping_ratio = call_real(&t, "ratio");
	def.contact_push_speed = call_real(&t, "push");
	def.restitution_threshold = call_real(&t, "threshold");
	def.max_speed = call_real(&t, "max_speed");
	def.body_capacity = call_whole(&t, "bodies");
	def.contact_capacity = call_whole(&t, "contacts");
	def.contact_details = call_whole(&t, "details") != 0;
	def.sleep = call_whole(&t, "sleep") != 0;
	def.sleep_threshold = call_real(&t, "sleep_threshold");
	def.length_unit = call_real(&t, "unit");
	def.recovery_interval = place->faults ? FAULTY_INTERVAL : 0;
	return scree_world_create(&def, world);
}
