// SPDX-License-Identifier: MIT
// run_call.c -- one call of a program on one world, through the public interface.
#include "programs/run_call.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

// ---------------------------------------------------------------------------------------------------------------
// arguments
// ---------------------------------------------------------------------------------------------------------------

float call_real(const Turn* t, const char* name) { return call_value(t->call, name); }

int call_whole(const Turn* t, const char* name)
{
	float x = call_real(t, name);
	return x > -1e6f && x < 1e6f ? (int)x : 0;
}

scree_vec call_vec(const Turn* t, const char* x, const char* y)
{
	return (scree_vec){call_real(t, x), call_real(t, y)};
}

scree_body call_body(const Turn* t, int k)
{
	return k >= 0 && k < MOST_NAMES ? t->names->bodies[k] : (scree_body){0, 0};
}

static scree_attribute attribute_at(const Turn* t, const char* name)
{
	int k = call_whole(t, name);
	return k >= 0 && k < MOST_NAMES ? t->names->attributes[k] : (scree_attribute){0, 0};
}

static scree_attribute attribute_of(const Turn* t) { return attribute_at(t, "attribute"); }

scree_pose call_pose(const Turn* t)
{
	return (scree_pose){call_vec(t, "x", "y"), scree_rot_make(call_real(t, "angle"))};
}

int call_batch(const Turn* t, const char* name)
{
	int count = call_whole(t, "count"), first = call_whole(t, name);
	count = count < MOST_BATCH ? count : MOST_BATCH;
	return first < 0 || first + count > MOST_NAMES ? 0 : count;
}

static scree_filter filter_of(const Turn* t)
{
	int mask = call_whole(t, "mask");
	return (scree_filter){(uint64_t)call_whole(t, "category"), (uint64_t)(int64_t)mask, call_whole(t, "group")};
}

// A number's collidable, or that one of a body's list.
static scree_collidable collidable_of(const Turn* t)
{
	int k = call_whole(t, "collidable"), count = 0, which = call_whole(t, "which");
	if (k >= 0)
		return k < MOST_NAMES ? t->names->collidables[k] : (scree_collidable){0, 0};
	scree_collidable list[64];
	scree_body body = call_body(t, call_whole(t, "body"));
	if (scree_body_get_collidables(t->world, body, list, 64, &count) != SCREE_OK || count == 0)
		return (scree_collidable){0, 0};
	count = count < 64 ? count : 64;
	return list[((which % count) + count) % count];
}

// ---------------------------------------------------------------------------------------------------------------
// attributes
// ---------------------------------------------------------------------------------------------------------------

static scree_status make_polygon(const Turn* t, scree_shape* shape)
{
	scree_vec corners[16];
	int count = call_whole(t, "corners");
	count = count < 0 ? 0 : count > 16 ? 16 : count;
	for (int k = 0; k < count; ++k)
	{
		scree_rot q = scree_rot_make(call_real(t, "angle") + 6.28318531f * (float)k / (float)count);
		corners[k] = (scree_vec){0.5f * call_real(t, "width") * q.c, 0.5f * call_real(t, "height") * q.s};
	}
	return scree_shape_make_polygon(corners, count, call_real(t, "radius"), shape);
}

static scree_status make_hull(const Turn* t, scree_shape* shape)
{
	scree_vec points[64];
	int count = call_whole(t, "points");
	count = count < 0 ? 0 : count > 64 ? 64 : count;
	uint32_t x = (uint32_t)call_whole(t, "seed") + 1u;
	for (int k = 0; k < count; ++k)
	{
		float two[2];
		for (int i = 0; i < 2; ++i)
		{
			x = x * 1664525u + 1013904223u; // Donald Knuth, H. W. Lewis
			two[i] = call_real(t, "size") * ((float)(x >> 16) / 65536.0f - 0.5f);
		}
		points[k] = (scree_vec){two[0], two[1]};
	}
	return scree_shape_make_hull(points, count, call_real(t, "radius"), shape);
}

static scree_status make_shape(const Turn* t, scree_shape* shape)
{
	switch (t->call->kind)
	{
	case CALL_box:
		return scree_shape_make_box(0.5f * call_real(t, "width"), 0.5f * call_real(t, "height"), shape);
	case CALL_circle:
		return scree_shape_make_circle(call_vec(t, "x", "y"), call_real(t, "radius"), shape);
	case CALL_capsule:
		return scree_shape_make_capsule(call_vec(t, "x", "y"), call_vec(t, "x2", "y2"), call_real(t, "radius"), shape);
	case CALL_segment:
		return scree_shape_make_segment(call_vec(t, "x", "y"), call_vec(t, "x2", "y2"), shape);
	case CALL_polygon:
		return make_polygon(t, shape);
	case CALL_like:
	{
		scree_attribute_def def = scree_attribute_def_default();
		scree_status status = scree_attribute_get_def(t->world, attribute_at(t, "of"), &def);
		*shape = def.shape;
		return status;
	}
	default:
		return make_hull(t, shape);
	}
}

static scree_status run_exclude(const Turn* t)
{
	enum
	{
		MOST = 64
	};
	scree_body first[MOST], second[MOST], other = call_body(t, call_whole(t, "other"));
	bool excluded[MOST];
	int count = call_whole(t, "count"), body = call_whole(t, "body");
	if (count == 0)
		return scree_body_set_excluded(t->world, call_body(t, body), other, call_whole(t, "excluded") != 0);
	count = count < MOST ? count : MOST;
	for (int k = 0; k < count; ++k)
	{
		first[k] = call_body(t, body + k);
		second[k] = other;
		excluded[k] = call_whole(t, "excluded") != 0;
	}
	return scree_bodies_set_excluded(t->world, first, second, excluded, count);
}

static scree_status run_answer(const Turn* t)
{
	enum
	{
		MOST = 4096
	};
	bool answers[MOST];
	scree_events events;
	scree_status status = scree_world_get_events(t->world, &events);
	if (status != SCREE_OK)
		return status;
	for (int k = 0; k < events.approval_count && k < MOST; ++k)
		answers[k] = call_whole(t, "bits") >> k % 8 & 1;
	return scree_world_approve_contacts(t->world, answers, events.approval_count < MOST ? events.approval_count : MOST);
}

static scree_status run_material(const Turn* t)
{
	scree_material_pair pair = scree_material_pair_default();
	float friction = call_real(t, "friction"), restitution = call_real(t, "restitution"),
	      tangent = call_real(t, "tangent");
	if (friction != -1.0f)
		pair.friction = friction;
	if (restitution != -1.0f)
		pair.restitution = restitution;
	if (tangent != 1e30f)
		pair.tangent_speed = tangent;
	pair.ignored = call_whole(t, "ignored") != 0;
	return scree_world_set_material_pair(t->world, call_whole(t, "a"), call_whole(t, "b"),
	                                     call_whole(t, "unset") ? NULL : &pair);
}

static scree_status run_attribute(const Turn* t)
{
	scree_attribute_def def = scree_attribute_def_default();
	scree_attribute made = {0, 0};
	scree_status status = make_shape(t, &def.shape);
	def.density = call_real(t, "density");
	def.friction = call_real(t, "friction");
	def.restitution = call_real(t, "restitution");
	def.rolling_resistance = call_real(t, "rolling");
	def.tangent_speed = call_real(t, "tangent");
	def.one_way = call_vec(t, "way_x", "way_y");
	def.material = call_whole(t, "material");
	if (status == SCREE_OK)
		status = scree_attribute_create(t->world, &def, &made);
	int k = call_whole(t, "attribute");
	if (status == SCREE_OK && k >= 0 && k < MOST_NAMES)
		t->names->attributes[k] = made;
	return status;
}

// ---------------------------------------------------------------------------------------------------------------
// bodies and collidables
// ---------------------------------------------------------------------------------------------------------------

static scree_status run_body(const Turn* t)
{
	scree_body_def def = scree_body_def_default();
	def.type = (scree_body_type)call_whole(t, "type");
	def.pose = call_pose(t);
	def.velocity = (scree_velocity){call_vec(t, "vx", "vy"), call_real(t, "w")};
	def.gravity_scale = call_real(t, "gravity");
	def.linear_damping = call_real(t, "linear");
	def.angular_damping = call_real(t, "angular");
	def.locks = (uint32_t)call_whole(t, "locks");
	def.disabled = call_whole(t, "disabled") != 0;
	def.filter = filter_of(t);
	def.reports = (uint32_t)call_whole(t, "reports");
	def.sensor = (uint32_t)call_whole(t, "sensor");
	if (call_real(t, "attribute") >= 0.0f)
		def.attribute = attribute_of(t);
	scree_body made = {0, 0};
	scree_status status = scree_body_create(t->world, &def, &made);
	int k = call_whole(t, "body");
	if (status == SCREE_OK && k >= 0 && k < MOST_NAMES)
		t->names->bodies[k] = made;
	return status;
}

static scree_status run_bodies(const Turn* t)
{
	scree_body_def defs[MOST_BATCH];
	int count = call_batch(t, "body"), columns = call_whole(t, "columns"), first = call_whole(t, "body");
	columns = columns > 0 ? columns : 1;
	for (int k = 0; k < count; ++k)
	{
		defs[k] = scree_body_def_default();
		defs[k].type = (scree_body_type)call_whole(t, "type");
		defs[k].attribute = attribute_of(t);
		defs[k].pose.position.x = call_real(t, "x") + (float)(k % columns) * call_real(t, "dx");
		defs[k].pose.position.y = call_real(t, "y") + (float)(k / columns) * call_real(t, "dy");
		defs[k].velocity = (scree_velocity){call_vec(t, "vx", "vy"), call_real(t, "w")};
	}
	return scree_bodies_create(t->world, defs, count, t->names->bodies + (count > 0 ? first : 0));
}

static scree_status run_destroy(const Turn* t)
{
	int first = call_whole(t, "body");
	if (call_whole(t, "count") == 0)
		return scree_body_destroy(t->world, call_body(t, first));
	int count = call_batch(t, "body");
	return scree_bodies_destroy(t->world, t->names->bodies + (count > 0 ? first : 0), count);
}

static scree_status run_collidable(const Turn* t)
{
	scree_collidable_def def = scree_collidable_def_default();
	scree_collidable made = {0, 0};
	def.attribute = attribute_of(t);
	if (call_real(t, "body") >= 0.0f)
		def.body = call_body(t, call_whole(t, "body"));
	def.pose = call_pose(t);
	def.filter = filter_of(t);
	def.reports = (uint32_t)call_whole(t, "reports");
	def.sensor = (uint32_t)call_whole(t, "sensor");
	scree_status status = scree_collidable_create(t->world, &def, &made);
	int k = call_whole(t, "collidable");
	if (status == SCREE_OK && k >= 0 && k < MOST_NAMES)
		t->names->collidables[k] = made;
	return status;
}

static scree_status run_place(const Turn* t)
{
	int k = call_whole(t, "collidable");
	scree_collidable collidable = k >= 0 && k < MOST_NAMES ? t->names->collidables[k] : (scree_collidable){0, 0};
	scree_pose pose = call_pose(t);
	return scree_collidables_set_poses(t->world, &collidable, &pose, 1);
}

// ---------------------------------------------------------------------------------------------------------------
// motion and settings
// ---------------------------------------------------------------------------------------------------------------

typedef struct // the same value for each of a batch
{
	scree_body bodies[MOST_BATCH];
	scree_vec vectors[MOST_BATCH], points[MOST_BATCH];
	float numbers[MOST_BATCH];
	bool flags[MOST_BATCH];
	scree_velocity velocities[MOST_BATCH];
	scree_pose poses[MOST_BATCH];
} Batch;

static scree_status run_batch(const Turn* t)
{
	static Batch b;
	CallKind kind = t->call->kind;
	int count = call_batch(t, "body"), first = call_whole(t, "body");
	bool at = kind == CALL_force_at || kind == CALL_impulse_at;
	bool number = kind == CALL_torque || kind == CALL_angular_impulse || kind == CALL_angular_velocity;
	for (int k = 0; k < count; ++k)
	{
		b.bodies[k] = call_body(t, first + k);
		if (kind == CALL_enabled)
		{
			b.flags[k] = call_whole(t, "enabled") != 0;
			continue;
		}
		b.numbers[k] = call_real(t, "x");
		b.vectors[k] = number ? (scree_vec){0} : call_vec(t, "x", "y");
		b.points[k] = at ? call_vec(t, "at_x", "at_y") : (scree_vec){0};
		if (kind == CALL_velocity)
			b.velocities[k] = (scree_velocity){call_vec(t, "x", "y"), call_real(t, "w")};
		if (kind == CALL_pose || kind == CALL_target)
			b.poses[k] = call_pose(t);
	}
	switch (kind)
	{
	case CALL_force:
		return scree_bodies_apply_forces(t->world, b.bodies, b.vectors, count);
	case CALL_force_at:
		return scree_bodies_apply_forces_at(t->world, b.bodies, b.vectors, b.points, count);
	case CALL_torque:
		return scree_bodies_apply_torques(t->world, b.bodies, b.numbers, count);
	case CALL_impulse:
		return scree_bodies_apply_impulses(t->world, b.bodies, b.vectors, count);
	case CALL_impulse_at:
		return scree_bodies_apply_impulses_at(t->world, b.bodies, b.vectors, b.points, count);
	case CALL_angular_impulse:
		return scree_bodies_apply_angular_impulses(t->world, b.bodies, b.numbers, count);
	case CALL_velocity:
		return scree_bodies_set_velocities(t->world, b.bodies, b.velocities, count);
	case CALL_linear_velocity:
		return scree_bodies_set_linear_velocities(t->world, b.bodies, b.vectors, count);
	case CALL_angular_velocity:
		return scree_bodies_set_angular_velocities(t->world, b.bodies, b.numbers, count);
	case CALL_target:
		return scree_bodies_set_targets(t->world, b.bodies, b.poses, count);
	case CALL_enabled:
		return scree_bodies_set_enabled(t->world, b.bodies, b.flags, count);
	default:
		return scree_bodies_set_poses(t->world, b.bodies, b.poses, count);
	}
}

static scree_status run_motion(const Turn* t)
{
	scree_body body = call_body(t, call_whole(t, "body"));
	if (call_whole(t, "count") != 0)
		return run_batch(t);
	switch (t->call->kind)
	{
	case CALL_force:
		return scree_body_apply_force(t->world, body, call_vec(t, "x", "y"));
	case CALL_force_at:
		return scree_body_apply_force_at(t->world, body, call_vec(t, "x", "y"), call_vec(t, "at_x", "at_y"));
	case CALL_torque:
		return scree_body_apply_torque(t->world, body, call_real(t, "x"));
	case CALL_impulse:
		return scree_body_apply_impulse(t->world, body, call_vec(t, "x", "y"));
	case CALL_impulse_at:
		return scree_body_apply_impulse_at(t->world, body, call_vec(t, "x", "y"), call_vec(t, "at_x", "at_y"));
	case CALL_angular_impulse:
		return scree_body_apply_angular_impulse(t->world, body, call_real(t, "x"));
	case CALL_velocity:
		return scree_body_set_velocity(t->world, body, (scree_velocity){call_vec(t, "x", "y"), call_real(t, "w")});
	case CALL_linear_velocity:
		return scree_body_set_linear_velocity(t->world, body, call_vec(t, "x", "y"));
	case CALL_angular_velocity:
		return scree_body_set_angular_velocity(t->world, body, call_real(t, "x"));
	case CALL_target:
		return scree_body_set_target(t->world, body, call_pose(t));
	case CALL_enabled:
		return scree_body_set_enabled(t->world, body, call_whole(t, "enabled") != 0);
	default:
		return scree_body_set_pose(t->world, body, call_pose(t));
	}
}

static scree_status run_setting(const Turn* t)
{
	scree_body body = call_body(t, call_whole(t, "body"));
	switch (t->call->kind)
	{
	case CALL_type:
		return scree_body_set_type(t->world, body, (scree_body_type)call_whole(t, "type"));
	case CALL_damping:
		return scree_body_set_damping(t->world, body, call_real(t, "linear"), call_real(t, "angular"));
	case CALL_gravity_scale:
		return scree_body_set_gravity_scale(t->world, body, call_real(t, "scale"));
	case CALL_locks:
		return scree_body_set_locks(t->world, body, (uint32_t)call_whole(t, "locks"));
	default:
		return scree_body_set_mass(t->world, body,
		                           (scree_mass){call_real(t, "mass"), call_real(t, "inertia"), call_vec(t, "x", "y")});
	}
}

// ---------------------------------------------------------------------------------------------------------------
// the world
// ---------------------------------------------------------------------------------------------------------------

uint64_t read_mixed(uint64_t word, const void* bytes, size_t count)
{
	const unsigned char* p = bytes;
	for (size_t k = 0; k < count; ++k)
		word = (word ^ p[k]) * 0x100000001b3u; // Fowler, Noll, Vo
	return word;
}

#define MOST_READ 512

// The contacts of one body are those of all in which it is.
static bool contacts_agree(const Turn* t, scree_body body, const scree_contact* all, int count)
{
	static scree_contact some[MOST_READ];
	int listed = 0, next = 0;
	if (scree_body_get_contacts(t->world, body, some, MOST_READ, &listed) != SCREE_OK)
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

static scree_status run_read(const Turn* t)
{
	static scree_contact contacts[MOST_READ];
	static scree_render_row shown[MOST_READ];
	uint64_t word = 0xcbf29ce484222325u;
	int counts[3] = {0};
	scree_status status = scree_world_get_contacts(t->world, contacts, MOST_READ, &counts[0]);
	scree_body body = call_body(t, call_whole(t, "body"));
	if (status == SCREE_OK && counts[0] <= MOST_READ && scree_body_is_valid(t->world, body) &&
	    !contacts_agree(t, body, contacts, counts[0]))
		return SCREE_ERROR_DEVICE_FAILED;
	for (int k = 0; k < counts[0] && k < MOST_READ && status == SCREE_OK; ++k)
	{
		contacts[k].points[1] = contacts[k].count > 1 ? contacts[k].points[1] : (scree_contact_point){.feature = 0};
		contacts[k].details[1] = contacts[k].count > 1 ? contacts[k].details[1] : (scree_contact_detail){.touched = 0};
		word = read_mixed(word, &contacts[k], sizeof contacts[k]);
	}
	if (status == SCREE_OK)
		status = scree_world_get_overlaps(t->world, contacts, 0, &counts[1]);
	if (status == SCREE_OK)
		status = scree_world_get_render_rows(t->world, shown, MOST_READ, &counts[2]);
	if (status == SCREE_OK)
		word = read_mixed(word, shown, (size_t)(counts[2] < MOST_READ ? counts[2] : MOST_READ) * sizeof shown[0]);
	word = read_mixed(word, counts, sizeof counts);
	scree_counters c;
	if (status == SCREE_OK)
		status = scree_world_get_counters(t->world, &c);
	if (status == SCREE_OK)
	{
		int more[] = {c.bodies, c.dynamic_bodies, c.collidables,  c.contacts,     c.touching,
		              c.colors, c.spokes,         c.new_contacts, c.frozen_bodies};
		float depths[] = {c.penetration, c.joint_gap};
		word = read_mixed(read_mixed(word, more, sizeof more), depths, sizeof depths);
	}
	scree_pose pose = {0};
	scree_velocity velocity = {0};
	if (status == SCREE_OK && scree_body_is_valid(t->world, body))
	{
		status = scree_body_get_pose(t->world, body, &pose);
		if (status == SCREE_OK)
			status = scree_body_get_velocity(t->world, body, &velocity);
		word = read_mixed(read_mixed(word, &pose, sizeof pose), &velocity, sizeof velocity);
	}
	if (status == SCREE_OK)
		status = read_joints(t, &word);
	if (status == SCREE_OK)
		status = read_paths(t, &word);
	if (status == SCREE_OK)
		status = read_fields(t, &word);
	t->left->word = word;
	return status;
}

static scree_status run_tuning(const Turn* t)
{
	scree_tuning tuning;
	scree_status status = scree_world_get_tuning(t->world, &tuning);
	tuning.contact_hertz = call_real(t, "hertz");
	tuning.contact_damping_ratio = call_real(t, "ratio");
	tuning.contact_push_speed = call_real(t, "push");
	tuning.restitution_threshold = call_real(t, "threshold");
	tuning.max_speed = call_real(t, "max_speed");
	return status == SCREE_OK ? scree_world_set_tuning(t->world, &tuning) : status;
}

static scree_status run_clear(const Turn* t)
{
	static scree_body bodies[MOST_NAMES];
	static scree_collidable collidables[MOST_NAMES];
	int count;
	scree_status status = scree_world_get_bodies(t->world, bodies, MOST_NAMES, &count);
	if (status == SCREE_OK)
		status = scree_bodies_destroy(t->world, bodies, count < MOST_NAMES ? count : MOST_NAMES);
	if (status == SCREE_OK)
		status = scree_body_get_collidables(t->world, (scree_body){0, 0}, collidables, MOST_NAMES, &count);
	if (status == SCREE_OK)
		status = scree_collidables_destroy(t->world, collidables, count < MOST_NAMES ? count : MOST_NAMES);
	if (status == SCREE_OK)
		status = clear_paths(t);
	if (status == SCREE_OK)
		status = clear_fields(t);
	const Open open = t->names->open; // touches end with the next step
	memset(t->names, 0, sizeof *t->names);
	t->names->open = open;
	return status;
}

static scree_status run_move(const Turn* t)
{
	if (!t->place->other[0])
		return SCREE_OK;
	return scree_world_move(t->world, call_whole(t, "back") ? t->home : t->place->other);
}

scree_status run_call(const Turn* t)
{
	switch (t->call->kind)
	{
	case CALL_box:
	case CALL_circle:
	case CALL_capsule:
	case CALL_segment:
	case CALL_polygon:
	case CALL_hull:
	case CALL_like:
		return run_attribute(t);
	case CALL_drop:
		return scree_attribute_destroy(t->world, attribute_of(t));
	case CALL_body:
		return run_body(t);
	case CALL_bodies:
		return run_bodies(t);
	case CALL_destroy:
		return run_destroy(t);
	case CALL_type:
	case CALL_damping:
	case CALL_gravity_scale:
	case CALL_locks:
	case CALL_mass:
		return run_setting(t);
	case CALL_collidable:
		return run_collidable(t);
	case CALL_remove:
		return scree_collidable_destroy(t->world, collidable_of(t));
	case CALL_filter:
		return scree_collidable_set_filter(t->world, collidable_of(t), filter_of(t));
	case CALL_material:
		return run_material(t);
	case CALL_exclude:
		return run_exclude(t);
	case CALL_answer:
		return run_answer(t);
	case CALL_reports:
		return scree_collidable_set_reports(t->world, collidable_of(t), (uint32_t)call_whole(t, "reports"));
	case CALL_sensor:
		return scree_collidable_set_sensor(t->world, collidable_of(t), (uint32_t)call_whole(t, "sensor"));
	case CALL_dress:
		return scree_collidable_set_attribute(t->world, collidable_of(t), attribute_of(t));
	case CALL_place:
		return run_place(t);
	case CALL_path:
	case CALL_path_destroy:
		return run_path(t);
	case CALL_field:
	case CALL_field_destroy:
	case CALL_field_pose:
	case CALL_field_enabled:
		return run_field(t);
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
		return run_joint(t);
	case CALL_gravity:
		return scree_world_set_gravity(t->world, call_vec(t, "x", "y"));
	case CALL_tuning:
		return run_tuning(t);
	case CALL_hits:
		return scree_world_set_hit_thresholds(t->world, call_real(t, "speed"), call_real(t, "impulse"));
	case CALL_step:
		return run_step(t);
	case CALL_move:
		return run_move(t);
	case CALL_blast:
		return run_blast(t);
	case CALL_ask:
		return run_ask(t);
	case CALL_read:
		return run_read(t);
	case CALL_clear:
		return run_clear(t);
	case CALL_world:
	case CALL_KINDS:
		return SCREE_OK;
	default:
		return run_motion(t);
	}
}

scree_status run_world(const Place* place, const Call* call, scree_world** world)
{
	Turn t = {.call = call};
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
