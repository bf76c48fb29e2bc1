// SPDX-License-Identifier: MIT
// run_body.c -- makes the calls of bodies: creation, settings and motion.
#include "programs/run_call.h"

static scree_status create(const CallRun* r)
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
	def.filter = call_filter(r);
	def.reports = (uint32_t)call_whole(r, "reports");
	def.sensor = (uint32_t)call_whole(r, "sensor");
	def.asleep = call_whole(r, "asleep") != 0;
	def.stays_awake = call_whole(r, "stays_awake") != 0;
	def.sleep_threshold = call_real(r, "sleep_threshold");
	if (call_real(r, "attribute") >= 0.0f)
		def.attribute = call_attribute(r, "attribute");
	scree_body made = {0, 0};
	scree_status status = scree_body_create(r->world, &def, &made);
	int k = call_whole(r, "body");
	if (status == SCREE_OK && k >= 0 && k < MOST_NAMES)
		r->names->bodies[k] = made;
	return status;
}

static scree_status create_batch(const CallRun* r)
{
	scree_body_def defs[MOST_BATCH];
	int count = call_batch(r, "body"), columns = call_whole(r, "columns"), first = call_whole(r, "body");
	columns = columns > 0 ? columns : 1;
	for (int k = 0; k < count; ++k)
	{
		defs[k] = scree_body_def_default();
		defs[k].type = (scree_body_type)call_whole(r, "type");
		defs[k].attribute = call_attribute(r, "attribute");
		defs[k].pose.position.x = call_real(r, "x") + (float)(k % columns) * call_real(r, "dx");
		defs[k].pose.position.y = call_real(r, "y") + (float)(k / columns) * call_real(r, "dy");
		defs[k].velocity = (scree_velocity){call_vec(r, "vx", "vy"), call_real(r, "w")};
		defs[k].asleep = call_whole(r, "asleep") != 0;
	}
	return scree_bodies_create(r->world, defs, count, r->names->bodies + (count > 0 ? first : 0));
}

static scree_status destroy(const CallRun* r)
{
	int first = call_whole(r, "body");
	if (call_whole(r, "count") == 0)
		return scree_body_destroy(r->world, call_body(r, first));
	int count = call_batch(r, "body");
	return scree_bodies_destroy(r->world, r->names->bodies + (count > 0 ? first : 0), count);
}

typedef struct // values of a batch, in which each body gets the same values
{
	scree_body bodies[MOST_BATCH];
	scree_vec vectors[MOST_BATCH], points[MOST_BATCH];
	float numbers[MOST_BATCH];
	bool flags[MOST_BATCH];
	scree_velocity velocities[MOST_BATCH];
	scree_pose poses[MOST_BATCH];
} Batch;

static scree_status move_batch(const CallRun* r)
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

static scree_status move(const CallRun* r)
{
	scree_body body = call_body(r, call_whole(r, "body"));
	if (call_whole(r, "count") != 0)
		return move_batch(r);
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

static scree_status set(const CallRun* r)
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

scree_status run_body(const CallRun* r)
{
	switch (r->call->kind)
	{
	case CALL_body:
		return create(r);
	case CALL_bodies:
		return create_batch(r);
	case CALL_destroy:
		return destroy(r);
	case CALL_type:
	case CALL_damping:
	case CALL_gravity_scale:
	case CALL_locks:
	case CALL_mass:
		return set(r);
	default:
		return move(r);
	}
}
