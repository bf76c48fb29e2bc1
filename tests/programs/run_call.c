// SPDX-License-Identifier: MIT
// run_call.c -- makes one call of a program on one world, through the public interface.
#include "programs/run_call.h"
#include <math.h>
#include <stdlib.h>
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

static scree_attribute attribute_at(const CallRun* r, const char* name)
{
	int k = call_whole(r, name);
	return k >= 0 && k < MOST_NAMES ? r->names->attributes[k] : (scree_attribute){0, 0};
}

static scree_attribute attribute_of(const CallRun* r) { return attribute_at(r, "attribute"); }

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

static scree_filter filter_of(const CallRun* r)
{
	int mask = call_whole(r, "mask");
	return (scree_filter){(uint64_t)call_whole(r, "category"), (uint64_t)(int64_t)mask, call_whole(r, "group")};
}

// Returns the collidable with a number, or one from the list of a body.
static scree_collidable collidable_of(const CallRun* r)
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
// attributes
// ---------------------------------------------------------------------------------------------------------------

static scree_status make_polygon(const CallRun* r, scree_shape* shape)
{
	scree_vec corners[16];
	int count = call_whole(r, "corners");
	count = count < 0 ? 0 : count > 16 ? 16 : count;
	for (int k = 0; k < count; ++k)
	{
		scree_rot q = scree_rot_make(call_real(r, "angle") + 6.28318531f * (float)k / (float)count);
		corners[k] = (scree_vec){0.5f * call_real(r, "width") * q.c, 0.5f * call_real(r, "height") * q.s};
	}
	return scree_shape_make_polygon(corners, count, call_real(r, "radius"), shape);
}

static scree_status make_hull(const CallRun* r, scree_shape* shape)
{
	scree_vec points[64];
	int count = call_whole(r, "points");
	count = count < 0 ? 0 : count > 64 ? 64 : count;
	uint32_t seed = (uint32_t)call_whole(r, "seed") + 1u;
	for (int k = 0; k < count; ++k)
	{
		float two[2];
		for (int i = 0; i < 2; ++i)
		{
			two[i] = call_real(r, "size") * ((float)(call_random(&seed) >> 16) / 65536.0f - 0.5f);
		}
		points[k] = (scree_vec){two[0], two[1]};
	}
	return scree_shape_make_hull(points, count, call_real(r, "radius"), shape);
}

static scree_status make_shape(const CallRun* r, scree_shape* shape)
{
	switch (r->call->kind)
	{
	case CALL_box:
		return scree_shape_make_box(0.5f * call_real(r, "width"), 0.5f * call_real(r, "height"), shape);
	case CALL_circle:
		return scree_shape_make_circle(call_vec(r, "x", "y"), call_real(r, "radius"), shape);
	case CALL_capsule:
		return scree_shape_make_capsule(call_vec(r, "x", "y"), call_vec(r, "x2", "y2"), call_real(r, "radius"), shape);
	case CALL_segment:
		return scree_shape_make_segment(call_vec(r, "x", "y"), call_vec(r, "x2", "y2"), shape);
	case CALL_polygon:
		return make_polygon(r, shape);
	case CALL_like:
	{
		scree_attribute_def def = scree_attribute_def_default();
		scree_status status = scree_attribute_get_def(r->world, attribute_at(r, "of"), &def);
		*shape = def.shape;
		return status;
	}
	default:
		return make_hull(r, shape);
	}
}

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

static scree_status run_attribute(const CallRun* r)
{
	scree_attribute_def def = scree_attribute_def_default();
	scree_attribute made = {0, 0};
	scree_status status = make_shape(r, &def.shape);
	def.density = call_real(r, "density");
	def.friction = call_real(r, "friction");
	def.restitution = call_real(r, "restitution");
	def.rolling_resistance = call_real(r, "rolling");
	def.tangent_speed = call_real(r, "tangent");
	def.one_way = call_vec(r, "way_x", "way_y");
	def.material = call_whole(r, "material");
	if (status == SCREE_OK)
		status = scree_attribute_create(r->world, &def, &made);
	int k = call_whole(r, "attribute");
	if (status == SCREE_OK && k >= 0 && k < MOST_NAMES)
		r->names->attributes[k] = made;
	return status;
}

// ---------------------------------------------------------------------------------------------------------------
// bodies and collidables
// ---------------------------------------------------------------------------------------------------------------

static scree_status run_body(const CallRun* r)
{
	scree_body_def def = scree_body_def_default();
	def.type = (scree_body_type)call_whole(r, "type");
	def.pose = call_pose(r);
	def.velocity = (scree_velocity){call_vec(r, "vx", "vy"), call_real(r, "w")};
	def.gravity_scale = call_real(r, "gravity");
	def.linear_damping = call_real(r, "linear");
	def.angular_damping = call_real(r, "angular");
	def.locks = (uint32_t)call_whole(r, "locks");
	def.disabled = call_whole(r, "disabled") != 0;
	def.filter = filter_of(r);
	def.reports = (uint32_t)call_whole(r, "reports");
	def.sensor = (uint32_t)call_whole(r, "sensor");
	if (call_real(r, "attribute") >= 0.0f)
		def.attribute = attribute_of(r);
	scree_body made = {0, 0};
	scree_status status = scree_body_create(r->world, &def, &made);
	int k = call_whole(r, "body");
	if (status == SCREE_OK && k >= 0 && k < MOST_NAMES)
		r->names->bodies[k] = made;
	return status;
}

static scree_status run_bodies(const CallRun* r)
{
	scree_body_def defs[MOST_BATCH];
	int count = call_batch(r, "body"), columns = call_whole(r, "columns"), first = call_whole(r, "body");
	columns = columns > 0 ? columns : 1;
	for (int k = 0; k < count; ++k)
	{
		defs[k] = scree_body_def_default();
		defs[k].type = (scree_body_type)call_whole(r, "type");
		defs[k].attribute = attribute_of(r);
		defs[k].pose.position.x = call_real(r, "x") + (float)(k % columns) * call_real(r, "dx");
		defs[k].pose.position.y = call_real(r, "y") + (float)(k / columns) * call_real(r, "dy");
		defs[k].velocity = (scree_velocity){call_vec(r, "vx", "vy"), call_real(r, "w")};
	}
	return scree_bodies_create(r->world, defs, count, r->names->bodies + (count > 0 ? first : 0));
}

static scree_status run_destroy(const CallRun* r)
{
	int first = call_whole(r, "body");
	if (call_whole(r, "count") == 0)
		return scree_body_destroy(r->world, call_body(r, first));
	int count = call_batch(r, "body");
	return scree_bodies_destroy(r->world, r->names->bodies + (count > 0 ? first : 0), count);
}

static scree_status run_collidable(const CallRun* r)
{
	scree_collidable_def def = scree_collidable_def_default();
	scree_collidable made = {0, 0};
	def.attribute = attribute_of(r);
	if (call_real(r, "body") >= 0.0f)
		def.body = call_body(r, call_whole(r, "body"));
	def.pose = call_pose(r);
	def.filter = filter_of(r);
	def.reports = (uint32_t)call_whole(r, "reports");
	def.sensor = (uint32_t)call_whole(r, "sensor");
	scree_status status = scree_collidable_create(r->world, &def, &made);
	int k = call_whole(r, "collidable");
	if (status == SCREE_OK && k >= 0 && k < MOST_NAMES)
		r->names->collidables[k] = made;
	return status;
}

static scree_status run_place(const CallRun* r)
{
	int k = call_whole(r, "collidable");
	scree_collidable collidable = k >= 0 && k < MOST_NAMES ? r->names->collidables[k] : (scree_collidable){0, 0};
	scree_pose pose = call_pose(r);
	return scree_collidables_set_poses(r->world, &collidable, &pose, 1);
}

// ---------------------------------------------------------------------------------------------------------------
// motion and settings
// ---------------------------------------------------------------------------------------------------------------

typedef struct // the same value for each body of a batch
{
	scree_body bodies[MOST_BATCH];
	scree_vec vectors[MOST_BATCH], points[MOST_BATCH];
	float numbers[MOST_BATCH];
	bool flags[MOST_BATCH];
	scree_velocity velocities[MOST_BATCH];
	scree_pose poses[MOST_BATCH];
} Batch;

static scree_status run_batch(const CallRun* r)
{
	static Batch b;
	CallKind kind = r->call->kind;
	int count = call_batch(r, "body"), first = call_whole(r, "body");
	bool at = kind == CALL_force_at || kind == CALL_impulse_at;
	bool number = kind == CALL_torque || kind == CALL_angular_impulse || kind == CALL_angular_velocity;
	for (int k = 0; k < count; ++k)
	{
		b.bodies[k] = call_body(r, first + k);
		if (kind == CALL_enabled)
		{
			b.flags[k] = call_whole(r, "enabled") != 0;
			continue;
		}
		b.numbers[k] = call_real(r, "x");
		b.vectors[k] = number ? (scree_vec){0} : call_vec(r, "x", "y");
		b.points[k] = at ? call_vec(r, "at_x", "at_y") : (scree_vec){0};
		if (kind == CALL_velocity)
			b.velocities[k] = (scree_velocity){call_vec(r, "x", "y"), call_real(r, "w")};
		if (kind == CALL_pose || kind == CALL_target)
			b.poses[k] = call_pose(r);
	}
	switch (kind)
	{
	case CALL_force:
		return scree_bodies_apply_forces(r->world, b.bodies, b.vectors, count);
	case CALL_force_at:
		return scree_bodies_apply_forces_at(r->world, b.bodies, b.vectors, b.points, count);
	case CALL_torque:
		return scree_bodies_apply_torques(r->world, b.bodies, b.numbers, count);
	case CALL_impulse:
		return scree_bodies_apply_impulses(r->world, b.bodies, b.vectors, count);
	case CALL_impulse_at:
		return scree_bodies_apply_impulses_at(r->world, b.bodies, b.vectors, b.points, count);
	case CALL_angular_impulse:
		return scree_bodies_apply_angular_impulses(r->world, b.bodies, b.numbers, count);
	case CALL_velocity:
		return scree_bodies_set_velocities(r->world, b.bodies, b.velocities, count);
	case CALL_linear_velocity:
		return scree_bodies_set_linear_velocities(r->world, b.bodies, b.vectors, count);
	case CALL_angular_velocity:
		return scree_bodies_set_angular_velocities(r->world, b.bodies, b.numbers, count);
	case CALL_target:
		return scree_bodies_set_targets(r->world, b.bodies, b.poses, count);
	case CALL_enabled:
		return scree_bodies_set_enabled(r->world, b.bodies, b.flags, count);
	default:
		return scree_bodies_set_poses(r->world, b.bodies, b.poses, count);
	}
}

static scree_status run_motion(const CallRun* r)
{
	scree_body body = call_body(r, call_whole(r, "body"));
	if (call_whole(r, "count") != 0)
		return run_batch(r);
	switch (r->call->kind)
	{
	case CALL_force:
		return scree_body_apply_force(r->world, body, call_vec(r, "x", "y"));
	case CALL_force_at:
		return scree_body_apply_force_at(r->world, body, call_vec(r, "x", "y"), call_vec(r, "at_x", "at_y"));
	case CALL_torque:
		return scree_body_apply_torque(r->world, body, call_real(r, "x"));
	case CALL_impulse:
		return scree_body_apply_impulse(r->world, body, call_vec(r, "x", "y"));
	case CALL_impulse_at:
		return scree_body_apply_impulse_at(r->world, body, call_vec(r, "x", "y"), call_vec(r, "at_x", "at_y"));
	case CALL_angular_impulse:
		return scree_body_apply_angular_impulse(r->world, body, call_real(r, "x"));
	case CALL_velocity:
		return scree_body_set_velocity(r->world, body, (scree_velocity){call_vec(r, "x", "y"), call_real(r, "w")});
	case CALL_linear_velocity:
		return scree_body_set_linear_velocity(r->world, body, call_vec(r, "x", "y"));
	case CALL_angular_velocity:
		return scree_body_set_angular_velocity(r->world, body, call_real(r, "x"));
	case CALL_target:
		return scree_body_set_target(r->world, body, call_pose(r));
	case CALL_enabled:
		return scree_body_set_enabled(r->world, body, call_whole(r, "enabled") != 0);
	default:
		return scree_body_set_pose(r->world, body, call_pose(r));
	}
}

static scree_status run_setting(const CallRun* r)
{
	scree_body body = call_body(r, call_whole(r, "body"));
	switch (r->call->kind)
	{
	case CALL_type:
		return scree_body_set_type(r->world, body, (scree_body_type)call_whole(r, "type"));
	case CALL_damping:
		return scree_body_set_damping(r->world, body, call_real(r, "linear"), call_real(r, "angular"));
	case CALL_gravity_scale:
		return scree_body_set_gravity_scale(r->world, body, call_real(r, "scale"));
	case CALL_locks:
		return scree_body_set_locks(r->world, body, (uint32_t)call_whole(r, "locks"));
	default:
		return scree_body_set_mass(r->world, body,
		                           (scree_mass){call_real(r, "mass"), call_real(r, "inertia"), call_vec(r, "x", "y")});
	}
}

// ---------------------------------------------------------------------------------------------------------------
// the world
// ---------------------------------------------------------------------------------------------------------------

#define MOST_READ 512

// Returns whether the contacts of a body are those of the list of all contacts that contain it, in the same order.
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
	uint64_t word = HASH_BEGIN;
	int counts[3] = {0};
	scree_status status = scree_world_get_contacts(r->world, contacts, MOST_READ, &counts[0]);
	scree_body body = call_body(r, call_whole(r, "body"));
	if (status == SCREE_OK && counts[0] <= MOST_READ && scree_body_is_valid(r->world, body) &&
	    !contacts_agree(r, body, contacts, counts[0]))
		return SCREE_ERROR_DEVICE_FAILED;
	for (int k = 0; k < counts[0] && k < MOST_READ && status == SCREE_OK; ++k)
	{
		contacts[k].points[1] = contacts[k].count > 1 ? contacts[k].points[1] : (scree_contact_point){.feature = 0};
		contacts[k].details[1] = contacts[k].count > 1 ? contacts[k].details[1] : (scree_contact_detail){.touched = 0};
		word = hash_bytes(word, &contacts[k], sizeof contacts[k]);
	}
	if (status == SCREE_OK)
		status = scree_world_get_overlaps(r->world, contacts, 0, &counts[1]);
	if (status == SCREE_OK)
		status = scree_world_get_render_rows(r->world, shown, MOST_READ, &counts[2]);
	if (status == SCREE_OK)
		word = hash_bytes(word, shown, (size_t)(counts[2] < MOST_READ ? counts[2] : MOST_READ) * sizeof shown[0]);
	word = hash_bytes(word, counts, sizeof counts);
	scree_counters c;
	if (status == SCREE_OK)
		status = scree_world_get_counters(r->world, &c);
	if (status == SCREE_OK)
	{
		int more[] = {c.bodies, c.dynamic_bodies, c.collidables,  c.contacts,     c.touching,
		              c.colors, c.spokes,         c.new_contacts, c.frozen_bodies};
		float depths[] = {c.penetration, c.joint_gap};
		word = hash_bytes(hash_bytes(word, more, sizeof more), depths, sizeof depths);
	}
	scree_pose pose = {0};
	scree_velocity velocity = {0};
	if (status == SCREE_OK && scree_body_is_valid(r->world, body))
	{
		status = scree_body_get_pose(r->world, body, &pose);
		if (status == SCREE_OK)
			status = scree_body_get_velocity(r->world, body, &velocity);
		word = hash_bytes(hash_bytes(word, &pose, sizeof pose), &velocity, sizeof velocity);
	}
	if (status == SCREE_OK)
		status = read_joints(r, &word);
	if (status == SCREE_OK)
		status = read_paths(r, &word);
	if (status == SCREE_OK)
		status = read_fields(r, &word);
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
	const Open open = r->names->open; // open touches end with the next step
	memset(r->names, 0, sizeof *r->names);
	r->names->open = open;
	return status;
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
		return run_attribute(r);
	case CALL_drop:
		return scree_attribute_destroy(r->world, attribute_of(r));
	case CALL_body:
		return run_body(r);
	case CALL_bodies:
		return run_bodies(r);
	case CALL_destroy:
		return run_destroy(r);
	case CALL_type:
	case CALL_damping:
	case CALL_gravity_scale:
	case CALL_locks:
	case CALL_mass:
		return run_setting(r);
	case CALL_collidable:
		return run_collidable(r);
	case CALL_remove:
		return scree_collidable_destroy(r->world, collidable_of(r));
	case CALL_filter:
		return scree_collidable_set_filter(r->world, collidable_of(r), filter_of(r));
	case CALL_material:
		return run_material(r);
	case CALL_exclude:
		return run_exclude(r);
	case CALL_answer:
		return run_answer(r);
	case CALL_reports:
		return scree_collidable_set_reports(r->world, collidable_of(r), (uint32_t)call_whole(r, "reports"));
	case CALL_sensor:
		return scree_collidable_set_sensor(r->world, collidable_of(r), (uint32_t)call_whole(r, "sensor"));
	case CALL_dress:
		return scree_collidable_set_attribute(r->world, collidable_of(r), attribute_of(r));
	case CALL_place:
		return run_place(r);
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
	case CALL_ask:
		return run_ask(r);
	case CALL_read:
		return run_read(r);
	case CALL_clear:
		return run_clear(r);
	case CALL_world:
	case CALL_KINDS:
		return SCREE_OK;
	default:
		return run_motion(r);
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
	return scree_world_create(&def, world);
}
