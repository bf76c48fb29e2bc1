// SPDX-License-Identifier: MIT
// test_batch_trials.c -- checks cases in which a world of a batch once differed from the same world alone, or in which its outputs did.
//
// Formula: hash(world in a batch) = hash(same world alone), and each output is the value that the call for the world alone returns.
#include "support/batch_checks.h"
#include "support/make_bodies.h"
#include "support/second_device.h"
#include <pthread.h>
#include <stdio.h>
#include <string.h>

#define STEP (1.0f / 60.0f)

static const char* device;

static scree_world* open_cpu(bool sleeps)
{
	scree_world_def def = scree_world_def_default();
	scree_world* world;
	def.device = "cpu";
	def.threads = 1;
	def.sleep = sleeps;
	OK(scree_world_create(&def, &world));
	return world;
}

static scree_body box(scree_world* world, scree_body_type type, float x, float y, float half)
{
	scree_body body;
	OK(scree_body_create_box(world, type, (scree_pose){{x, y}, {1.0f, 0.0f}}, half, half, 0, &body));
	return body;
}

static scree_batch* open_batch(scree_world** templates, int count, int worlds)
{
	scree_batch_def def = batch_def_on(device, templates, count, worlds);
	scree_batch* batch;
	def.other_templates = count > 1;
	OK(scree_batch_create(&def, &batch));
	return batch;
}

static void equal(scree_batch* batch, int world, scree_world* alone)
{
	uint64_t hashes[8], hash;
	OK(scree_batch_get_hashes(batch, hashes));
	OK(scree_world_get_hash(alone, &hash));
	assert_true(hashes[world] == hash);
}

// The slots of contacts grow in the step in which a body on two opposed belts becomes a hub.
static void belts_turn_while_slots_grow(void** state)
{
	(void)state;
	scree_world* world = open_cpu(false);
	scree_body left = box(world, SCREE_BODY_STATIC, -0.5f, -0.5f, 0.5f);
	scree_body right = box(world, SCREE_BODY_STATIC, 0.5f, -0.5f, 0.5f);
	box(world, SCREE_BODY_DYNAMIC, 0.0f, 0.5f, 0.5f);
	scree_body crowd = box(world, SCREE_BODY_KINEMATIC, 100.0f, 0.0f, 5.0f);
	for (int k = 0; k < 40; ++k)
		box(world, SCREE_BODY_DYNAMIC, 200.0f + (float)k, 0.0f, 0.1f);
	for (int k = 0; k < 5; ++k)
		OK(scree_world_step(world, STEP, 4));
	scree_batch* batch = open_batch(&world, 1, 2);
	scree_world* alone = clone_of(world);
	scree_channel in[] = {scree_channel_make(SCREE_INPUT_SURFACE), scree_channel_make(SCREE_INPUT_SURFACE),
	                      scree_channel_make(SCREE_INPUT_POSE)};
	in[0].collidable = collidable_of(world, left);
	in[1].collidable = collidable_of(world, right);
	in[2].body = crowd;
	float rows[2][12];
	OK(scree_batch_bind(batch, SCREE_STEP_INPUTS, in, 3, rows[0]));
	for (int step = 0; step < 4; ++step)
	{
		const float row[12] = {0.6f, 0.0f, 0.0f, 1.5f, 0.6f, 0.0f, 0.0f, -1.5f, 100.0f, 0.0f, 1.0f, 0.0f};
		for (int k = 0; k < 2; ++k)
			memcpy(rows[k], row, sizeof row);
		rows[0][8] = step > 0 ? 220.0f : 100.0f; // world 0 gets many contacts
		OK(scree_batch_step(batch, STEP, 4, 1));
		for (int k = 0; k < 2; ++k)
		{
			scree_surface surface = scree_surface_default();
			surface.tangent_speed = row[4 * k + 3];
			OK(scree_collidable_set_surface(alone, in[k].collidable, &surface));
		}
		OK(scree_body_set_pose(alone, crowd, (scree_pose){{100.0f, 0.0f}, {1.0f, 0.0f}}));
		OK(scree_world_step(alone, STEP, 4));
		equal(batch, 1, alone);
	}
	scree_batch_destroy(batch);
	scree_world_destroy(alone);
	scree_world_destroy(world);
}

// A body of 1e30 kg in one template changes no bit of the other template's worlds; an input cannot make a body so heavy.
static void heavy_worlds_stand_alone(void** state)
{
	(void)state;
	scree_world* templates[2] = {open_cpu(false), NULL};
	box(templates[0], SCREE_BODY_STATIC, 0.0f, -1.0f, 1.0f);
	scree_body body = box(templates[0], SCREE_BODY_DYNAMIC, 0.0f, 0.5f, 0.5f);
	scree_joint_def def = scree_joint_def_make(SCREE_JOINT_REVOLUTE);
	def.body_b = body;
	def.coordinates[SCREE_ANGLE].motor = true;
	def.coordinates[SCREE_ANGLE].motor_max = 1.0f;
	OK(scree_joint_def_place(templates[0], &def, (scree_pose){{0.0f, 0.5f}, {1.0f, 0.0f}}));
	OK(scree_joint_create(templates[0], &def, NULL));
	templates[1] = clone_of(templates[0]);
	OK(scree_body_set_mass(templates[0], body, (scree_mass){.mass = 1.0f, .inertia = 100.0f}));
	OK(scree_body_set_mass(templates[1], body, (scree_mass){.mass = 1.0e30f, .inertia = 1.0f}));
	scree_world* alone[2] = {clone_of(templates[0]), clone_of(templates[1])};
	scree_batch* batch = open_batch(templates, 2, 4);
	scree_channel in = scree_channel_make(SCREE_INPUT_MASS);
	float rows[4][4] = {{1.0f, 100.0f}, {1.0e30f, 1.0f}, {1.0f, 100.0f}, {1.0e30f, 1.0f}};
	in.body = body;
	OK(scree_batch_step(batch, STEP, 4, 1));
	for (int k = 0; k < 2; ++k)
	{
		OK(scree_world_step(alone[k], STEP, 4));
		equal(batch, k, alone[k]);
		equal(batch, k + 2, alone[k]);
	}
	OK(scree_batch_bind(batch, SCREE_STEP_INPUTS, &in, 1, rows[0]));
	assert_int_equal(scree_batch_step(batch, STEP, 4, 1), SCREE_ERROR_INVALID);
	assert_non_null(strstr(scree_error(), "inputs of world 1[0] is 1e+30, must be from 1e-15 to 1.09951"));
	equal(batch, 0, alone[0]);
	for (int list = 0; list < 2; ++list)
	{
		// the center of mass is so far from the joint that the inertia is above 2^40 kg m^2
		const float far[4][4] = {{1.0f, 100.0f}, {1.0f, 1.0f}, {2.0e9f, 1.0f, 1000.0f}, {1.0f, 1.0f}};
		memcpy(rows, far, sizeof rows);
		OK(scree_batch_bind(batch, SCREE_STEP_INPUTS, &in, list == 0, rows[0]));
		OK(scree_batch_bind(batch, SCREE_RESET_INPUTS, &in, list == 1, rows[0]));
		assert_int_equal(list ? scree_batch_reset(batch, NULL) : scree_batch_step(batch, STEP, 4, 1),
		                 SCREE_ERROR_INVALID);
		assert_non_null(strstr(scree_error(), "inputs of world 2[0] give a body an inertia above 1.09951"));
		equal(batch, 0, alone[0]);
	}
	assert_int_equal(scree_batch_insert(batch, 0, alone[1]), SCREE_ERROR_INVALID); // alone[1] is heavy
	scree_batch_destroy(batch);
	for (int k = 0; k < 2; ++k)
	{
		scree_world_destroy(alone[k]);
		scree_world_destroy(templates[k]);
	}
}

// A world is inserted with another surface while it is paused, and bodies of other worlds sleep.
static void paused_worlds_stay(void** state)
{
	(void)state;
	scree_world* templates[2] = {open_cpu(true), open_cpu(false)};
	scree_body body = {0};
	box(templates[0], SCREE_BODY_STATIC, 30.0f, -1.0f, 1.0f);
	for (int k = 0; k < 30; ++k)
	{
		box(templates[0], SCREE_BODY_STATIC, 3.0f * (float)k, -1.0f, 1.0f);
		body = box(templates[0], SCREE_BODY_DYNAMIC, 3.0f * (float)k, 0.5f, 0.5f);
	}
	box(templates[1], SCREE_BODY_DYNAMIC, 0.0f, 5.0f, 0.5f);
	for (int k = 0; k < 120; ++k)
		OK(scree_world_step(templates[0], STEP, 4));
	scree_batch* batch = open_batch(templates, 2, 8);
	const uint8_t mask[8] = {1};
	OK(scree_batch_pause(batch, mask));
	for (int k = 0; k < 60; ++k)
		OK(scree_batch_step(batch, STEP, 4, 1));
	scree_world* alone = clone_of(templates[0]);
	scree_surface surface = scree_surface_default();
	surface.friction = 0.3f;
	OK(scree_collidable_set_surface(alone, collidable_of(alone, body), &surface));
	OK(scree_world_step(alone, STEP, 4));
	OK(scree_batch_insert(batch, 0, alone));
	for (int k = 0; k < 3; ++k)
	{
		equal(batch, 0, alone);
		OK(scree_batch_step(batch, STEP, 1 + k, 1));
	}
	scree_batch_destroy(batch);
	scree_world_destroy(alone);
	for (int k = 0; k < 2; ++k)
		scree_world_destroy(templates[k]);
}

// A world is taken out whose own surface needs one attribute more than its template has room for.
static void attributes_beyond_the_slots(void** state)
{
	(void)state;
	scree_world* world = open_cpu(false);
	scree_body first = box(world, SCREE_BODY_STATIC, 0.0f, 0.0f, 0.5f);
	for (int k = 1; k < 16; ++k)
		box(world, SCREE_BODY_STATIC, 3.0f * (float)k, 0.0f, 0.5f + 0.01f * (float)k);
	scree_batch* batch = open_batch(&world, 1, 1);
	scree_channel in = scree_channel_make(SCREE_INPUT_SURFACE);
	float row[4] = {0.3f};
	in.collidable = collidable_of(world, first);
	OK(scree_batch_bind(batch, SCREE_STEP_INPUTS, &in, 1, row));
	OK(scree_batch_step(batch, STEP, 4, 1));
	for (int k = 0; k < 20; ++k)
	{
		scree_world* taken;
		OK(scree_batch_extract(batch, 0, NULL, &taken));
		equal(batch, 0, taken);
		scree_world_destroy(taken);
	}
	scree_batch_destroy(batch);
	scree_world_destroy(world);
}

// A velocity that locks take away wakes no body.
static void locked_bodies_sleep_on(void** state)
{
	(void)state;
	scree_world* world = open_cpu(true);
	scree_body body = box(world, SCREE_BODY_DYNAMIC, 0.0f, 5.0f, 0.5f);
	OK(scree_body_set_locks(world, body, SCREE_LOCK_X | SCREE_LOCK_Y));
	for (int k = 0; k < 60; ++k)
		OK(scree_world_step(world, STEP, 4));
	scree_world* alone = clone_of(world);
	scree_batch* batch = open_batch(&world, 1, 1);
	scree_channel in = scree_channel_make(SCREE_INPUT_VELOCITY);
	float rows[3][3] = {{1.0f, 0.0f, 0.0f}, {0.0f, -2.0f, 0.0f}, {0.0f, 0.0f, 0.5f}};
	in.body = body;
	for (int k = 0; k < 3; ++k)
	{
		OK(scree_batch_bind(batch, SCREE_STEP_INPUTS, &in, 1, rows[k]));
		OK(scree_batch_step(batch, STEP, 4, 1));
		OK(scree_body_set_velocity(alone, body, (scree_velocity){{rows[k][0], rows[k][1]}, rows[k][2]}));
		OK(scree_world_step(alone, STEP, 4));
		equal(batch, 0, alone);
	}
	scree_batch_destroy(batch);
	scree_world_destroy(alone);
	scree_world_destroy(world);
}

// A pose of a body on a path wakes both bodies of the joint, also in a step of length 0.
static void paths_stir_both_bodies(void** state)
{
	(void)state;
	scree_world* world = open_cpu(true);
	scree_body bodies[2] = {box(world, SCREE_BODY_DYNAMIC, 0.0f, 0.0f, 0.3f),
	                        box(world, SCREE_BODY_DYNAMIC, 1.0f, 0.0f, 0.3f)};
	scree_vec points[3] = {{0.0f, 0.0f}, {1.0f, 0.0f}, {2.0f, 0.5f}};
	scree_path path;
	scree_path_def path_def = scree_path_def_default();
	path_def.points = points;
	path_def.count = 3;
	OK(scree_path_create(world, &path_def, &path));
	scree_joint_def def = scree_joint_def_make(SCREE_JOINT_PATH);
	def.path = path;
	def.body_a = bodies[0];
	def.body_b = bodies[1];
	OK(scree_joint_def_mount(world, &def, 1.0f));
	OK(scree_joint_create(world, &def, NULL));
	OK(scree_world_set_gravity(world, (scree_vec){0.0f, 0.0f}));
	for (int steps = 3; steps < 64; steps += 60)
	{
		for (int k = 0; k < steps; ++k)
			OK(scree_world_step(world, STEP, 4));
		for (int which = 0; which < 2; ++which)
		{
			scree_world* alone = clone_of(world);
			scree_batch* batch = open_batch(&world, 1, 1);
			scree_channel in = scree_channel_make(SCREE_INPUT_POSE);
			float row[4] = {(float)which, 0.1f, 1.0f, 0.0f};
			in.body = bodies[which];
			OK(scree_batch_bind(batch, SCREE_STEP_INPUTS, &in, 1, row));
			for (int k = 0; k < 3; ++k)
			{
				float dt = k > 0 ? STEP : 0.0f;
				OK(scree_batch_step(batch, dt, 4, 1));
				OK(scree_body_set_pose(alone, bodies[which], (scree_pose){{row[0], row[1]}, {1.0f, 0.0f}}));
				OK(scree_world_step(alone, dt, 4));
				equal(batch, 0, alone);
			}
			scree_batch_destroy(batch);
			scree_world_destroy(alone);
		}
	}
	scree_world_destroy(world);
}

// Two templates have joints with the same index and other generations, the second one after steps of another length; world 1 gets
// the other template, which lacks the joint of its own.
static void joints_of_two_templates(void** state)
{
	(void)state;
	scree_world* templates[2];
	scree_joint joints[2];
	scree_body bodies[2];
	for (int k = 0; k < 2; ++k)
	{
		scree_joint_def def = scree_joint_def_make(SCREE_JOINT_SLOT);
		templates[k] = open_cpu(false);
		bodies[k] = box(templates[k], SCREE_BODY_DYNAMIC, 0.0f, 0.0f, 0.5f);
		def.body_b = bodies[k];
		for (int n = 0; n <= k; ++n) // the joint of template 1 is the second one in its slot
		{
			if (n > 0)
				OK(scree_joint_destroy(templates[k], joints[k]));
			OK(scree_world_step(templates[k], STEP, 4));
			OK(scree_joint_create(templates[k], &def, joints + k));
		}
		for (int n = 0; n < 10; ++n)
			OK(scree_world_step(templates[k], k > 0 ? 1.0f / 30.0f : STEP, 4));
	}
	assert_int_equal(joints[0].index, joints[1].index);
	assert_int_not_equal(joints[0].generation, joints[1].generation);
	scree_batch* batch = open_batch(templates, 2, 2);
	scree_channel out[3] = {scree_channel_make(SCREE_OUTPUT_JOINT_FORCE), scree_channel_make(SCREE_OUTPUT_JOINT_FORCE),
	                        scree_channel_make(SCREE_OUTPUT_JOINT_GAP)};
	float rows[2][7];
	out[0].joint = joints[0];
	out[1].joint = joints[1];
	OK(scree_batch_bind(batch, SCREE_OUTPUTS, out, 3, rows[0]));
	for (int other = 0; other < 2; ++other)
	{
		OK(scree_batch_observe(batch));
		for (int k = 0; k < 2; ++k)
		{
			int number = k == 1 && other == 1 ? 0 : k;
			scree_joint_state now;
			OK(scree_joint_get_state(templates[number], joints[number], &now));
			const float force[3] = {now.force.x, now.force.y, now.torque}, none[3] = {0.0f, 0.0f, 0.0f};
			assert_memory_equal(rows[k] + 3 * number, force, sizeof force);
			assert_memory_equal(rows[k] + 3 * (1 - number), none, sizeof none);
			assert_true(rows[k][6] < 0.01f);
		}
		OK(scree_batch_set_templates(batch, (const int32_t[]){0, 0}));
		OK(scree_batch_reset(batch, NULL));
	}
	scree_batch_destroy(batch);
	for (int k = 0; k < 2; ++k)
		scree_world_destroy(templates[k]);
}

// Rows of a paused world stay when another list is bound; rays meet no collidable without a body.
static void rows_stay_and_rays_pass(void** state)
{
	(void)state;
	scree_world* world = open_cpu(false);
	scree_shape shape = box_shape(0.5f, 0.5f);
	scree_attribute_def attribute_def = scree_attribute_def_default();
	scree_attribute attribute;
	attribute_def.shape = shape;
	OK(scree_attribute_create(world, &attribute_def, &attribute));
	box(world, SCREE_BODY_STATIC, 0.0f, -0.5f, 0.5f);
	scree_body body = box(world, SCREE_BODY_DYNAMIC, 0.0f, 0.5f, 0.5f);
	box(world, SCREE_BODY_STATIC, 9.0f, 5.0f, 0.5f);
	scree_collidable_def free_def = scree_collidable_def_default();
	free_def.attribute = attribute;
	free_def.pose = (scree_pose){{4.0f, 5.0f}, {1.0f, 0.0f}};
	OK(scree_collidable_create(world, &free_def, NULL));
	for (int k = 0; k < 5; ++k)
		OK(scree_world_step(world, STEP, 4));
	scree_batch* batch = open_batch(&world, 1, 2);
	scree_channel out[2] = {scree_channel_make(SCREE_OUTPUT_TOUCH), scree_channel_make(SCREE_OUTPUT_RAYS)};
	scree_channel in = scree_channel_make(SCREE_INPUT_FORCE);
	float rows[2][4], kept[4], force[2][2] = {{0}};
	const uint8_t mask[2] = {0, 1};
	out[0].body = in.body = body;
	out[1].point = (scree_vec){0.0f, 5.0f};
	out[1].translation = (scree_vec){20.0f, 0.0f};
	OK(scree_batch_bind(batch, SCREE_OUTPUTS, out, 2, rows[0]));
	OK(scree_batch_step(batch, STEP, 4, 1));
	scree_ray ray = {.origin = out[1].point, .translation = out[1].translation};
	scree_query_result found;
	OK(scree_world_cast_ray(world, ray.origin, ray.translation, &found));
	assert_true(rows[1][3] == found.fraction && found.fraction > 0.4f);
	assert_true(rows[1][0] == 1.0f && rows[1][1] == 0.0f);
	memcpy(kept, rows[1], sizeof kept);
	OK(scree_batch_pause(batch, mask));
	OK(scree_batch_bind(batch, SCREE_STEP_INPUTS, &in, 1, force[0]));
	OK(scree_batch_step(batch, STEP, 4, 1));
	assert_memory_equal(rows[1], kept, sizeof kept);
	OK(scree_batch_pause(batch, NULL));
	OK(scree_batch_step(batch, STEP, 4, 1));
	assert_true(rows[1][0] == 1.0f && rows[1][1] == 0.0f); // it has touched all the time
	scree_batch_destroy(batch);
	scree_world_destroy(world);
}

// A surface is set, a step is made, and it is set again before the world is inserted: its first attribute is gone.
static void surfaces_change_twice(void** state)
{
	(void)state;
	scree_world* world = open_cpu(false);
	scree_body floor = box(world, SCREE_BODY_STATIC, 0.0f, -1.0f, 1.0f);
	box(world, SCREE_BODY_DYNAMIC, 0.0f, 0.5f, 0.5f);
	OK(scree_world_step(world, STEP, 4));
	scree_batch* batch = open_batch(&world, 1, 2);
	scree_world* changed = clone_of(world);
	scree_surface surface = scree_surface_default();
	for (int k = 0; k < 3; ++k)
	{
		surface.friction = 0.1f + 0.1f * (float)k;
		OK(scree_collidable_set_surface(changed, collidable_of(changed, floor), &surface));
		OK(scree_batch_insert(batch, k % 2, changed));
		equal(batch, k % 2, changed);
		OK(scree_batch_step(batch, STEP, 4, 1));
		OK(scree_world_step(changed, STEP, 4));
		equal(batch, k % 2, changed);
	}
	scree_batch_destroy(batch);
	scree_world_destroy(changed);
	scree_world_destroy(world);
}

// A body is disabled, perhaps enabled again, or its shape made a sensor, after the step: its contact has ended.
static void touches_end_at_once(void** state)
{
	(void)state;
	for (int act = 0; act < 4; ++act)
	{
		scree_world* world = open_cpu(false);
		scree_body floor = box(world, SCREE_BODY_STATIC, 0.0f, -1.0f, 1.0f);
		scree_body crate = box(world, SCREE_BODY_DYNAMIC, 0.0f, 0.5f, 0.5f);
		for (int k = 0; k < 10; ++k)
			OK(scree_world_step(world, STEP, 4));
		if (act == 0 || act == 3)
			OK(scree_body_set_enabled(world, floor, false));
		if (act == 3)
			OK(scree_body_set_enabled(world, floor, true));
		if (act == 1)
			OK(scree_collidable_set_sensor(world, collidable_of(world, floor), SCREE_SENSOR_MOVING));
		scree_batch* batch = open_batch(&world, 1, 1);
		scree_channel out = scree_channel_make(SCREE_OUTPUT_TOUCH), in = scree_channel_make(SCREE_INPUT_ENABLED);
		float row[3], enabled = 0.0f;
		out.body = in.body = crate;
		OK(scree_batch_bind(batch, SCREE_OUTPUTS, &out, 1, row));
		OK(scree_batch_bind(batch, SCREE_RESET_INPUTS, &in, act == 2, &enabled));
		OK(scree_batch_reset(batch, NULL));
		OK(scree_batch_observe(batch));
		assert_true(row[0] == 0.0f && row[2] == 0.0f);
		OK(scree_batch_step(batch, STEP, 4, 1));
		assert_true(row[0] == (act == 3 ? 1.0f : 0.0f) && row[1] == row[0]);
		scree_batch_destroy(batch);
		scree_world_destroy(world);
	}
}

// Outputs are bound, or a state is loaded, while the world is paused: its touch has not begun when it runs again.
static void touches_last_through_a_pause(void** state)
{
	(void)state;
	static char saved[1 << 16];
	const int32_t first = 0;
	const uint8_t mask[1] = {1};
	scree_world* world = open_cpu(false);
	box(world, SCREE_BODY_STATIC, 0.0f, -1.0f, 1.0f);
	scree_channel out = scree_channel_make(SCREE_OUTPUT_TOUCH);
	out.body = box(world, SCREE_BODY_DYNAMIC, 0.0f, 0.5f, 0.5f);
	scree_batch* batch = open_batch(&world, 1, 1);
	float row[3];
	OK(scree_batch_step(batch, STEP, 4, 10));
	assert_true(scree_batch_get_state_bytes(batch) <= sizeof saved);
	OK(scree_batch_save(batch, &first, 1, saved, sizeof saved));
	for (int act = 0; act < 2; ++act)
	{
		if (act == 1)
		{
			OK(scree_batch_reset(batch, NULL)); // the crate has no contact
			OK(scree_batch_observe(batch));
			assert_true(row[0] == 0.0f);
		}
		OK(scree_batch_pause(batch, mask));
		if (act == 0)
			OK(scree_batch_bind(batch, SCREE_OUTPUTS, &out, 1, row));
		else
			OK(scree_batch_load(batch, &first, 1, saved, 0));
		OK(scree_batch_pause(batch, NULL));
		OK(scree_batch_step(batch, STEP, 4, 1));
		assert_true(row[0] == 1.0f && row[1] == 0.0f);
	}
	scree_batch_destroy(batch);
	scree_world_destroy(world);
}

typedef struct
{
	scree_world* template;
	uint64_t hash; // that of the only world after 30 steps
} Creation;

static void* create_and_step(void* argument)
{
	Creation* made = argument;
	scree_batch* batch = open_batch(&made->template, 1, 1);
	OK(scree_batch_step(batch, STEP, 4, 30));
	OK(scree_batch_get_hashes(batch, &made->hash));
	scree_batch_destroy(batch);
	return NULL;
}

// Several threads create batches of one template at once, as for several devices.
static void threads_share_a_template(void** state)
{
	(void)state;
	enum
	{
		THREADS = 4
	};
	scree_world* world = open_cpu(false);
	box(world, SCREE_BODY_STATIC, 0.0f, -0.5f, 0.5f);
	for (int k = 0; k < 40; ++k)
		box(world, SCREE_BODY_DYNAMIC, 0.1f * (float)k, 0.5f + (float)k, 0.4f);
	pthread_t threads[THREADS];
	Creation made[THREADS];
	for (int k = 0; k < THREADS; ++k)
	{
		made[k].template = world;
		assert_int_equal(pthread_create(threads + k, NULL, create_and_step, made + k), 0);
	}
	for (int k = 0; k < THREADS; ++k)
		assert_int_equal(pthread_join(threads[k], NULL), 0);
	run_steps(world, 30);
	for (int k = 0; k < THREADS; ++k)
		assert_true(made[k].hash == hash_of(world));
	scree_world_destroy(world);
}

static void refusals(void** state)
{
	(void)state;
	scree_world* templates[2];
	scree_joint joint;
	const scree_joint_type types[2] = {SCREE_JOINT_SLOT, SCREE_JOINT_REVOLUTE};
	for (int k = 0; k < 2; ++k)
	{
		scree_world_def def = scree_world_def_default();
		def.device = "cpu";
		def.length_unit = 100.0f;
		OK(scree_world_create(&def, templates + k));
		scree_joint_def joint_def = scree_joint_def_make(types[k]);
		joint_def.body_b = box(templates[k], SCREE_BODY_DYNAMIC, 0.0f, 0.0f, 50.0f);
		OK(scree_joint_create(templates[k], &joint_def, &joint));
	}
	scree_batch* batch = open_batch(templates, 2, 2);
	scree_channel c = scree_channel_make(SCREE_INPUT_JOINT_TARGET);
	float rows[2][1];
	c.joint = joint;
	for (int which = -1; which < 4; which += 4)
	{
		char sentence[128];
		c.which = (scree_coordinate)which;
		snprintf(sentence, sizeof sentence, "scree_batch_bind: channels[0].which is %d, not a coordinate", which);
		REFUSED(scree_batch_bind(batch, SCREE_STEP_INPUTS, &c, 1, rows[0]), sentence);
	}
	c = scree_channel_make(SCREE_INPUT_TARGET);
	REFUSED(
	    scree_batch_bind(batch, SCREE_RESET_INPUTS, &c, 1, rows[0]),
	    "scree_batch_bind: channels[0].kind is a target, which only a step can reach; bind it as SCREE_STEP_INPUTS");
	scree_batch_def def = scree_batch_def_default();
	def.templates = templates;
	def.template_count = 1;
	for (int threads = -1; threads < 66; threads += 66)
	{
		scree_batch* made;
		def.threads = threads;
		assert_int_equal(scree_batch_create(&def, &made), SCREE_ERROR_INVALID);
		assert_non_null(strstr(scree_error(), "must be from 0 to 64"));
	}
	scree_batch_destroy(batch);
	for (int k = 0; k < 2; ++k)
		scree_world_destroy(templates[k]);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(belts_turn_while_slots_grow),
	    cmocka_unit_test(heavy_worlds_stand_alone),
	    cmocka_unit_test(paused_worlds_stay),
	    cmocka_unit_test(attributes_beyond_the_slots),
	    cmocka_unit_test(locked_bodies_sleep_on),
	    cmocka_unit_test(paths_stir_both_bodies),
	    cmocka_unit_test(joints_of_two_templates),
	    cmocka_unit_test(rows_stay_and_rays_pass),
	    cmocka_unit_test(surfaces_change_twice),
	    cmocka_unit_test(touches_end_at_once),
	    cmocka_unit_test(touches_last_through_a_pause),
	    cmocka_unit_test(threads_share_a_template),
	    cmocka_unit_test(refusals),
	};
	int failures = 0;
	find_second_device(NULL);
	for (int k = 0; k < 2; ++k)
	{
		device = k == 0 ? "cpu" : second_device;
		if (device[0])
			failures += cmocka_run_group_tests_name(device, tests, NULL, memory_is_released);
	}
	return failures;
}
