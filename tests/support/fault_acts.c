// SPDX-License-Identifier: MIT
// fault_acts.c -- acts on bodies, collidables and contacts, for tests in which one call fails.
#include "support/fault_acts.h"
#include "support/make_bodies.h"

scree_status act_create_world(FaultRun* s)
{
	scree_world_def def = scree_world_def_default();
	def.device = s->device ? s->device : "cpu";
	def.threads = 2;
	def.device_timeout = s->device_timeout;
	def.recovery_interval = s->recovery_interval;
	def.contact_capacity = 8;
	def.timings = s->timings;
	return scree_world_create(&def, &s->world);
}

scree_status act_attributes(FaultRun* s)
{
	scree_attribute_def box = surface_of(box_shape(0.5f, 0.5f)), circle = surface_of(circle_shape(0.25f));
	scree_attribute_def slab = surface_of(box_shape(30.0f, 0.5f));
	scree_status status = scree_attribute_create(s->world, &box, &s->box);
	if (status == SCREE_OK)
		status = scree_attribute_create(s->world, &circle, &s->circle);
	return status ? status : scree_attribute_create(s->world, &slab, &s->slab);
}

// Creates more attributes than the first table has room for. If the act is repeated after a fault, it does not create
// existing attributes a second time.
scree_status act_more_attributes(FaultRun* s)
{
	for (int k = 0; k < 80; ++k)
	{
		scree_attribute_def def = surface_of(box_shape(0.5f, 0.5f));
		scree_attribute made;
		def.friction = 0.01f * (float)k;
		scree_status status = scree_attribute_create(s->world, &def, &made);
		if (status)
			return status;
	}
	return SCREE_OK;
}

// Creates a slab that can move, with 100 circles on it. The slab has more contacts than there are colors.
scree_status act_slab(FaultRun* s)
{
	scree_body_def defs[101];
	for (int k = 0; k <= 100; ++k)
	{
		defs[k] = scree_body_def_default();
		defs[k].attribute = k == 100 ? s->slab : s->circle;
		defs[k].pose.position = k == 100 ? (scree_vec){0.0f, -50.0f} : (scree_vec){-25.0f + 0.5f * (float)k, -49.25f};
	}
	scree_body made[101];
	scree_status status = scree_bodies_create(s->world, defs, 101, made);
	if (status == SCREE_OK)
		s->slab_body = made[100];
	return status;
}

// Creates boxes that overlap, so that each touches several others.
scree_status act_bodies(FaultRun* s)
{
	static scree_body_def defs[BODIES];
	for (int k = 0; k < BODIES; ++k)
	{
		defs[k] = scree_body_def_default();
		defs[k].attribute = s->box;
		defs[k].pose.position = (scree_vec){0.8f * (float)(k % 20), 0.9f * (float)(k / 20)};
	}
	return scree_bodies_create(s->world, defs, BODIES, s->bodies);
}

scree_status act_free(FaultRun* s)
{
	scree_collidable_def defs[FREE];
	for (int k = 0; k < FREE; ++k)
	{
		defs[k] = scree_collidable_def_default();
		defs[k].attribute = s->circle;
		defs[k].pose.position = (scree_vec){0.7f * (float)k, 3.0f};
	}
	return scree_collidables_create(s->world, defs, FREE, s->free);
}

scree_status act_forces(FaultRun* s)
{
	static scree_vec forces[BODIES];
	for (int k = 0; k < BODIES; ++k)
		forces[k] = (scree_vec){(float)(k % 7), 1.0f};
	return scree_bodies_apply_forces(s->world, s->bodies, forces, BODIES);
}

scree_status act_step(FaultRun* s) { return scree_world_step(s->world, STEP, SUBSTEPS); }

scree_status act_contacts(FaultRun* s)
{
	static scree_contact contacts[4000];
	int count;
	return scree_world_get_contacts(s->world, contacts, 4000, &count);
}

scree_status act_overlaps(FaultRun* s)
{
	static scree_contact contacts[100];
	int count;
	return scree_world_get_overlaps(s->world, contacts, 100, &count);
}

scree_status act_poses(FaultRun* s)
{
	static scree_pose poses[BODIES];
	return scree_bodies_get_poses(s->world, s->bodies, poses, 100);
}

scree_status act_counters(FaultRun* s)
{
	scree_counters counters;
	return scree_world_get_counters(s->world, &counters);
}

scree_status act_timings(FaultRun* s)
{
	scree_timings timings;
	return scree_world_get_timings(s->world, &timings);
}

scree_status act_destroy(FaultRun* s) { return scree_bodies_destroy(s->world, s->bodies + 200, 90); }
scree_status act_destroy_free(FaultRun* s) { return scree_collidables_destroy(s->world, s->free, 5); }

scree_status act_again(FaultRun* s)
{
	scree_body_def defs[120];
	for (int k = 0; k < 120; ++k)
	{
		defs[k] = scree_body_def_default();
		defs[k].attribute = k % 3 ? s->circle : s->box;
		defs[k].pose.position = (scree_vec){0.3f * (float)k, 20.0f};
	}
	return scree_bodies_create(s->world, defs, 120, NULL);
}

scree_status act_type(FaultRun* s) { return scree_body_set_type(s->world, s->slab_body, SCREE_BODY_STATIC); }

scree_status act_filter(FaultRun* s)
{
	scree_filter filter = scree_filter_default();
	filter.group = 3;
	return scree_collidable_set_filter(s->world, s->free[10], filter);
}

scree_status act_place(FaultRun* s)
{
	scree_pose pose = {{4.0f, 4.0f}, {1.0f, 0.0f}};
	return scree_collidables_set_poses(s->world, s->free + 7, &pose, 1);
}

scree_status act_mass(FaultRun* s)
{
	return scree_body_set_mass(s->world, s->bodies[0], (scree_mass){3.0f, 1.0f, {0.0f, 0.0f}});
}

static scree_status switch_bodies(FaultRun* s, bool on)
{
	static bool enabled[BODIES];
	for (int k = 0; k < BODIES; ++k)
		enabled[k] = on;
	return scree_bodies_set_enabled(s->world, s->bodies, enabled, 200);
}

scree_status act_disable(FaultRun* s) { return switch_bodies(s, false); }
scree_status act_enable(FaultRun* s) { return switch_bodies(s, true); }
scree_status act_look(FaultRun* s) { return scree_world_step(s->world, 0.0f, 1); }
scree_status act_kinematic(FaultRun* s) { return scree_body_set_type(s->world, s->slab_body, SCREE_BODY_KINEMATIC); }

scree_status act_target(FaultRun* s)
{
	return scree_body_set_target(s->world, s->slab_body, (scree_pose){{0.5f, -50.0f}, {1.0f, 0.0f}});
}

// Gives another surface to one collidable without a body, and another shape to a second such collidable.
scree_status act_dress(FaultRun* s)
{
	scree_attribute made;
	scree_attribute_def def = surface_of(circle_shape(0.25f));
	def.friction = 0.987f;
	scree_status status = scree_attribute_create(s->world, &def, &made);
	if (status == SCREE_OK)
		status = scree_collidable_set_attribute(s->world, s->free[10], made);
	return status ? status : scree_collidable_set_attribute(s->world, s->free[11], s->box);
}

scree_status act_body_contacts(FaultRun* s)
{
	static scree_contact contacts[200];
	int count;
	return scree_body_get_contacts(s->world, s->slab_body, contacts, 200, &count);
}

// Creates a sensor for moving and static collidables.
scree_status act_sensor(FaultRun* s)
{
	scree_collidable_def def = scree_collidable_def_default();
	def.attribute = s->slab;
	def.sensor = SCREE_SENSOR_MOVING | SCREE_SENSOR_STATIC;
	return scree_collidable_create(s->world, &def, &s->sensor);
}

scree_status act_events(FaultRun* s)
{
	scree_events events;
	return scree_world_get_events(s->world, &events);
}
