// SPDX-License-Identifier: MIT
// make_worlds.c -- creates worlds for tests, steps them, and reads their state.
#include "support/make_worlds.h"
#include <math.h>
#include <stdlib.h>

const char* test_device;

scree_world* create_world(const scree_world_def* def)
{
	scree_world* world;
	OK(scree_world_create(def, &world));
	return world;
}

scree_world* open_world_on(const char* device, int threads, float gravity_y)
{
	scree_world_def def = scree_world_def_default();
	def.device = device;
	def.threads = threads;
	def.gravity.y = gravity_y;
	return create_world(&def);
}

scree_world* open_world(float gravity_y) { return open_world_on("cpu", 1, gravity_y); }

scree_world* open_test_world(float gravity_y) { return open_world_on(test_device, 2, gravity_y); }

scree_world* stay_awake(scree_world* world)
{
	scree_tuning tuning;
	OK(scree_world_get_tuning(world, &tuning));
	tuning.sleep = false;
	OK(scree_world_set_tuning(world, &tuning));
	return world;
}

void run_steps(scree_world* world, int steps)
{
	for (int k = 0; k < steps; ++k)
		OK(scree_world_step(world, STEP, SUBSTEPS));
}

void update_contacts(scree_world* world) { OK(scree_world_step(world, 0.0f, SUBSTEPS)); }

float deepest_of(scree_world* world, int steps)
{
	float deepest = 0.0f;
	for (int k = 0; k < steps; ++k)
	{
		run_steps(world, 1);
		float depth = counters_of(world).penetration;
		deepest = depth > deepest ? depth : deepest;
	}
	return deepest;
}

uint64_t hash_of(scree_world* world)
{
	uint64_t hash;
	OK(scree_world_get_hash(world, &hash));
	return hash;
}

scree_counters counters_of(scree_world* world)
{
	scree_counters counters;
	OK(scree_world_get_counters(world, &counters));
	return counters;
}

scree_events events_of(scree_world* world)
{
	scree_events events;
	OK(scree_world_get_events(world, &events));
	return events;
}

int contacts_of(scree_world* world)
{
	int count;
	OK(scree_world_get_contacts(world, NULL, 0, &count));
	return count;
}

int contacts_with(scree_world* world, scree_body body)
{
	int count;
	OK(scree_body_get_contacts(world, body, NULL, 0, &count));
	return count;
}

int read_contacts(scree_world* world, scree_contact** contacts)
{
	int count = contacts_of(world);
	*contacts = calloc((size_t)count + 1, sizeof **contacts);
	assert_non_null(*contacts);
	OK(scree_world_get_contacts(world, *contacts, count, &count));
	return count;
}

void check_finite(scree_world* world)
{
	int count;
	OK(scree_world_get_bodies(world, NULL, 0, &count));
	scree_body* bodies = calloc((size_t)count + 1, sizeof *bodies);
	scree_pose* poses = calloc((size_t)count + 1, sizeof *poses);
	scree_velocity* velocities = calloc((size_t)count + 1, sizeof *velocities);
	OK(scree_world_get_bodies(world, bodies, count, &count));
	OK(scree_bodies_get_poses(world, bodies, poses, count));
	OK(scree_bodies_get_velocities(world, bodies, velocities, count));
	for (int k = 0; k < count; ++k)
	{
		scree_pose p = poses[k];
		scree_velocity v = velocities[k];
		if (!isfinite(p.position.x + p.position.y + p.rotation.c + p.rotation.s) ||
		    !isfinite(v.linear.x + v.linear.y + v.angular))
			fail_msg("body %u is not finite", bodies[k].index);
		double length = (double)p.rotation.c * p.rotation.c + (double)p.rotation.s * p.rotation.s;
		NEAR(length, 1.0, 1e-6);
	}
	free(bodies);
	free(poses);
	free(velocities);
}

int use_cpu(void** state)
{
	(void)state;
	test_device = "cpu";
	return 0;
}

int use_opencl(void** state)
{
	(void)state;
	test_device = "opencl";
	return 0;
}
