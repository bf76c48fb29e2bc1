// SPDX-License-Identifier: MIT
// test_batch_neighbors.c -- checks that worlds of other templates change no bit of a world of a batch, and that worlds that were taken
// out can be copied at once.
//
// Formula: hash(world in a batch) = hash(same world alone).
#include "batch/batch.h"
#include "support/batch_checks.h"
#include "support/second_device.h"
#include <string.h>

#define STEP (1.0f / 60.0f)
#define ROWS 4 // maximum number of worlds of a batch

static const char* device;

// Opens a world without gravity, on the CPU.
static scree_world* open_space(void)
{
	scree_world_def def = scree_world_def_default();
	scree_world* world;
	def.device = "cpu";
	def.threads = 1;
	def.sleep = false;
	def.gravity = (scree_vec){0.0f, 0.0f};
	OK(scree_world_create(&def, &world));
	return world;
}

static scree_body box(scree_world* world, scree_body_type type, float x, float half, float half_height)
{
	scree_body body;
	OK(scree_body_create_box(world, type, (scree_pose){{x, 0.0f}, {1.0f, 0.0f}}, half, half_height, 0, &body));
	return body;
}

static scree_batch* open_batch(scree_world** templates, int count, int contact_limit)
{
	scree_batch_def def = batch_def_on(device, templates, count, count);
	scree_batch* batch;
	def.contact_limit = contact_limit;
	OK(scree_batch_create(&def, &batch));
	return batch;
}

static uint64_t hash_alone(scree_world* world)
{
	uint64_t hash;
	OK(scree_world_get_hash(world, &hash));
	return hash;
}

static uint64_t hash_of_world(scree_batch* batch, int world)
{
	uint64_t hashes[ROWS];
	OK(scree_batch_get_hashes(batch, hashes));
	return hashes[world];
}

// Steps a world of a batch and the same world alone, and compares them after each step.
static void step_both(scree_batch* batch, int world, scree_world* alone, int steps)
{
	for (int k = 0; k < steps; ++k)
	{
		OK(scree_batch_step(batch, STEP, 4, 1));
		OK(scree_world_step(alone, STEP, 4));
		assert_true(hash_of_world(batch, world) == hash_alone(alone));
	}
}

static float between(float least, float most)
{
	return least + (most - least) * (float)random_below(1 << 20) / 1048576.0f;
}

// Adds two boxes with centers of mass beside them, which leave their predicted boxes when they spin.
static void add_spinners(scree_world* world)
{
	for (int k = 0; k < 2; ++k)
	{
		scree_body_def body = scree_body_def_default();
		scree_attribute_def attribute = scree_attribute_def_default();
		scree_body made;
		body.pose.position = (scree_vec){between(-0.5f, 0.5f), between(-0.5f, 0.5f)};
		body.pose.rotation = scree_rot_make(between(-3.0f, 3.0f));
		body.velocity.linear = (scree_vec){between(-1.0f, 1.0f), between(-1.0f, 1.0f)};
		body.velocity.angular = k == 0 ? 0.0f : between(-200.0f, 200.0f);
		OK(scree_shape_make_box(between(0.02f, 0.4f), between(0.003f, 0.1f), &attribute.shape));
		OK(scree_body_create_with_shape(world, &body, &attribute, &made));
		scree_mass mass;
		OK(scree_body_get_mass(world, made, &mass));
		mass.center = (scree_vec){between(-0.3f, 0.3f), between(-0.3f, 0.3f)};
		mass.inertia = 0.0f;
		OK(scree_body_set_mass(world, made, mass));
	}
}

// Joints, fields and gravity of another world do not decide which bodies are tested for collisions on their paths.
static void calm_worlds_stay_calm(void** state)
{
	(void)state;
	int trials = device[0] == 'c' ? 1500 : 4;
	scree_world* jointed = open_space();
	scree_joint_def joint = scree_joint_def_make(SCREE_JOINT_REVOLUTE);
	joint.body_b = box(jointed, SCREE_BODY_DYNAMIC, 0.0f, 0.5f, 0.5f);
	OK(scree_joint_create(jointed, &joint, NULL));
	for (int k = 0; k < trials; ++k)
	{
		scree_world* templates[] = {open_space(), jointed};
		add_spinners(templates[0]);
		scree_world* alone = clone_of(templates[0]);
		scree_batch* batch = open_batch(templates, 2, 0);
		const scree_vec pulls[2] = {{0.0f, 0.0f}, {0.0f, -1000.0f}};
		if (k % 2 == 1)
			OK(scree_batch_set_gravity(batch, pulls));
		step_both(batch, 0, alone, 2);
		scree_batch_destroy(batch);
		scree_world_destroy(alone);
		scree_world_destroy(templates[0]);
	}
	scree_world_destroy(jointed);
}

static scree_world* open_pair(bool excluded)
{
	scree_world* world = open_space();
	scree_body a = box(world, SCREE_BODY_DYNAMIC, 0.0f, 0.5f, 0.5f),
	           b = box(world, SCREE_BODY_DYNAMIC, 1.2f, 0.5f, 0.5f);
	OK(scree_body_set_velocity(world, b, (scree_velocity){{-1.0f, 0.0f}, 0.0f}));
	if (excluded)
		OK(scree_body_set_excluded(world, a, b, true));
	return world;
}

// The pairs that never touch in the world that was in a bay before do not apply to the next one.
static void exclusions_leave_with_their_world(void** state)
{
	(void)state;
	scree_world *templates[] = {open_pair(true), open_pair(false)}, *alone = clone_of(templates[1]);
	scree_batch* batch = open_batch(templates, 2, 0);
	const uint8_t both[] = {1, 1}, second[] = {0, 1};
	OK(scree_batch_step(batch, STEP, 4, 3));
	OK(scree_batch_pause(batch, both));
	OK(scree_batch_reset(batch, second));
	step_both(batch, 1, alone, 20);
	scree_batch_destroy(batch);
	scree_world_destroy(alone);
	for (int k = 0; k < 2; ++k)
		scree_world_destroy(templates[k]);
}

// A world is taken out just after the wall was disabled again. The speed of a body that was pressed is still limited.
static void take_out_pressed(scree_batch* batch, scree_world* alone, scree_body pressed, scree_body wall, float* on)
{
	const scree_velocity fast = {{0.0f, 50.0f}, 10.0f};
	scree_world* taken;
	*on = 0.0f;
	OK(scree_body_set_enabled(alone, wall, false));
	step_both(batch, 0, alone, 1);
	OK(scree_batch_extract(batch, 0, NULL, &taken));
	OK(scree_body_set_velocity(taken, pressed, fast));
	OK(scree_body_set_velocity(alone, pressed, fast));
	for (int k = 0; k < 10; ++k)
	{
		OK(scree_world_step(taken, STEP, 4));
		OK(scree_world_step(alone, STEP, 4));
		assert_true(hash_alone(taken) == hash_alone(alone));
	}
	scree_world_destroy(taken);
}

// A moving body presses another one against the only static body, which has always been disabled in the template.
static void disabled_walls_press(void** state)
{
	(void)state;
	scree_world* world = open_space();
	scree_body pressed = box(world, SCREE_BODY_DYNAMIC, 0.0f, 0.2f, 0.2f);
	scree_body ram = box(world, SCREE_BODY_KINEMATIC, -0.5f, 0.25f, 0.5f), wall;
	OK(scree_body_set_velocity(world, ram, (scree_velocity){{8.0f, 0.0f}, 0.0f}));
	scree_body_def body = scree_body_def_default();
	scree_attribute_def attribute = scree_attribute_def_default();
	body.type = SCREE_BODY_STATIC;
	body.disabled = true;
	body.pose.position.x = 0.5f;
	OK(scree_shape_make_box(0.25f, 1.0f, &attribute.shape));
	OK(scree_body_create_with_shape(world, &body, &attribute, &wall));
	scree_world* alone = clone_of(world);
	OK(scree_body_set_enabled(alone, wall, true));
	for (int way = 0, steps = 1; steps <= 12; steps += way, way = !way) // by an input, by a world that is put in
	{
		scree_world* copy = clone_of(alone);
		scree_batch* batch = open_batch(&world, 1, 0);
		scree_channel channel = scree_channel_make(SCREE_INPUT_ENABLED);
		float on = 1.0f;
		channel.body = wall;
		if (way == 0)
			OK(scree_batch_bind(batch, SCREE_STEP_INPUTS, &channel, 1, &on));
		else
			OK(scree_batch_insert(batch, 0, copy));
		step_both(batch, 0, copy, steps);
		if (way == 0)
			take_out_pressed(batch, copy, pressed, wall, &on);
		scree_batch_destroy(batch);
		scree_world_destroy(copy);
	}
	scree_world_destroy(alone);
	scree_world_destroy(world);
}

// A bead moves on a path, far from bodies that meet with more contacts than are allowed.
static scree_world* open_bead(int contact_limit)
{
	scree_world_def def = scree_world_def_default();
	scree_world* world;
	scree_body bead, fast;
	def.device = device;
	def.threads = 1;
	def.sleep = false;
	def.gravity = (scree_vec){0.0f, 0.0f};
	def.contact_limit = contact_limit;
	OK(scree_world_create(&def, &world));
	const scree_pose start = {{0.0f, 0.0f}, {1.0f, 0.0f}}, far = {{100.0f, 0.0f}, {1.0f, 0.0f}},
	                 farther = {{110.0f, 0.0f}, {1.0f, 0.0f}};
	OK(scree_body_create_circle(world, SCREE_BODY_DYNAMIC, start, 0.05f, 0, &bead));
	scree_vec points[16];
	for (int k = 0; k < 16; ++k)
		points[k] = (scree_vec){0.5f * (float)k, 0.1f * (float)(k % 2)};
	scree_path_def path = scree_path_def_default();
	scree_joint_def joint = scree_joint_def_make(SCREE_JOINT_PATH);
	path.points = points;
	path.count = 16;
	OK(scree_path_create(world, &path, &joint.path));
	joint.body_b = bead;
	OK(scree_joint_def_mount(world, &joint, 0.1f));
	OK(scree_joint_create(world, &joint, NULL));
	OK(scree_body_set_velocity(world, bead, (scree_velocity){{20.0f, 0.0f}, 0.0f}));
	for (int k = 0; k < 4; ++k)
		OK(scree_body_create_circle(world, SCREE_BODY_DYNAMIC, far, 0.2f, 0, NULL));
	OK(scree_body_create_circle(world, SCREE_BODY_DYNAMIC, farther, 0.2f, 0, &fast));
	OK(scree_body_set_velocity(world, fast, (scree_velocity){{-50.0f, 0.0f}, 0.0f}));
	return world;
}

// A step that is refused because of its contacts leaves also the places on paths.
static void refused_steps_leave_paths(void** state)
{
	(void)state;
	scree_world *free_world = open_bead(0), *limited = open_bead(7);
	scree_batch* batch = open_batch(&free_world, 1, 7);
	scree_batch_counters counters = {.crowded = 0};
	scree_status status = SCREE_OK;
	for (int k = 0; k < 40 && (status == SCREE_OK || counters.crowded == 0); ++k)
	{
		uint64_t before = hash_of_world(batch, 0), before_alone = hash_alone(limited);
		assert_true(before == before_alone);
		status = scree_world_step(limited, STEP, 4);
		OK(scree_batch_step(batch, STEP, 4, 1));
		OK(scree_batch_get_counters(batch, &counters));
		assert_true((status == SCREE_ERROR_CONTACT_LIMIT) == (counters.crowded > 0));
		assert_true(counters.crowded == 0 || hash_of_world(batch, 0) == before);
		assert_true(status == SCREE_OK || hash_alone(limited) == before_alone);
	}
	assert_true(counters.crowded > 0);
	scree_batch_destroy(batch);
	scree_world_destroy(limited);
	scree_world_destroy(free_world);
}

// Such a step leaves also the marks that wake bodies: here a sleeping body hangs on one that begins to move.
static void refused_steps_leave_sleepers(void** state)
{
	(void)state;
	scree_world_def def = scree_world_def_default();
	scree_world* world;
	scree_counters counters = {.asleep_bodies = 0};
	def.device = device;
	def.threads = 1;
	def.gravity = (scree_vec){0.0f, 0.0f};
	def.contact_limit = 7;
	OK(scree_world_create(&def, &world));
	scree_joint_def joint = scree_joint_def_make(SCREE_JOINT_REVOLUTE);
	joint.body_a = box(world, SCREE_BODY_KINEMATIC, 0.0f, 0.5f, 0.5f);
	joint.body_b = box(world, SCREE_BODY_DYNAMIC, 1.2f, 0.5f, 0.5f);
	const scree_pose middle = {{0.6f, 0.0f}, {1.0f, 0.0f}}, far = {{100.0f, 0.0f}, {1.0f, 0.0f}};
	OK(scree_joint_def_place(world, &joint, middle));
	OK(scree_joint_create(world, &joint, NULL));
	for (int k = 0; k < 300 && counters.asleep_bodies == 0; ++k)
	{
		OK(scree_world_step(world, STEP, 4));
		OK(scree_world_get_counters(world, &counters));
	}
	assert_int_equal(counters.asleep_bodies, 1);
	OK(scree_body_set_velocity(world, joint.body_a, (scree_velocity){{5.0f, 0.0f}, 0.0f}));
	for (int k = 0; k < 5; ++k)
		OK(scree_body_create_circle(world, SCREE_BODY_DYNAMIC, far, 0.2f, 0, NULL));
	uint64_t before = hash_alone(world);
	assert_int_equal(scree_world_step(world, STEP, 4), SCREE_ERROR_CONTACT_LIMIT);
	assert_true(hash_alone(world) == before);
	scree_batch* batch = open_batch(&world, 1, 7);
	scree_batch_counters crowd;
	OK(scree_batch_step(batch, STEP, 4, 1));
	OK(scree_batch_get_counters(batch, &crowd));
	assert_true(crowd.crowded > 0 && hash_of_world(batch, 0) == before);
	scree_batch_destroy(batch);
	scree_world_destroy(world);
}

// Takes world 0 out, and checks that it can be copied.
static void take_out(scree_batch* batch)
{
	scree_world *taken, *copy;
	OK(scree_batch_extract(batch, 0, NULL, &taken));
	copy = clone_of(taken);
	for (int k = 0; k < 3; ++k)
	{
		assert_true(hash_alone(taken) == hash_alone(copy));
		OK(scree_world_step(taken, STEP, 4));
		OK(scree_world_step(copy, STEP, 4));
	}
	scree_world_destroy(copy);
	scree_world_destroy(taken);
}

static void worlds_are_copied_at_once(void** state)
{
	(void)state;
	scree_world* world = open_space(); // no step has reserved memory for reports
	scree_body a = box(world, SCREE_BODY_STATIC, 0.0f, 0.5f, 0.5f),
	           b = box(world, SCREE_BODY_DYNAMIC, 1.0f, 0.5f, 0.5f);
	scree_channel surfaces[2];
	scree_body bodies[2] = {a, b};
	int count;
	for (int k = 0; k < 2; ++k)
	{
		surfaces[k] = scree_channel_make(SCREE_INPUT_SURFACE);
		OK(scree_body_get_collidables(world, bodies[k], &surfaces[k].collidable, 1, &count));
		box(world, SCREE_BODY_STATIC, 20.0f + 5.0f * (float)k, 0.5f, 0.5f); // shares the attribute
	}
	OK(scree_collidable_set_reports(world, surfaces[1].collidable, SCREE_REPORT_TOUCHES));
	scree_batch* batch = open_batch(&world, 1, 0);
	OK(scree_batch_step(batch, STEP, 4, 3));
	take_out(batch);
	// the attribute that the first surface had is free, below that of the second one
	const float frictions[3][2] = {{0.1f, 0.6f}, {0.1f, 0.2f}, {0.6f, 0.2f}};
	float row[8] = {0.0f};
	OK(scree_batch_bind(batch, SCREE_STEP_INPUTS, surfaces, 2, row));
	for (int k = 0; k < 3; ++k)
	{
		row[0] = frictions[k][0];
		row[4] = frictions[k][1];
		OK(scree_batch_step(batch, STEP, 4, 1));
		take_out(batch);
	}
	scree_batch_destroy(batch);
	scree_world_destroy(world);
}

#define LINKS 12

// Opens a world with a row of boxes that hang together. With a heavy last box they are solved as a chain.
static scree_world* open_row(int links, float last_mass, scree_body* last, scree_joint joints[LINKS])
{
	scree_world* world = open_space();
	scree_body before = {0};
	for (int k = 0; k < links; ++k)
	{
		scree_joint_def joint = scree_joint_def_make(SCREE_JOINT_REVOLUTE);
		const scree_pose place = {{(float)k - 0.5f, 0.0f}, {1.0f, 0.0f}};
		*last = box(world, SCREE_BODY_DYNAMIC, (float)k, 0.5f, 0.1f);
		if (k > 0)
			joint.body_a = before;
		joint.body_b = before = *last;
		OK(scree_joint_def_place(world, &joint, place));
		OK(scree_joint_create(world, &joint, joints + k));
	}
	OK(scree_body_set_mass(world, *last, (scree_mass){last_mass, last_mass, {0.0f, 0.0f}}));
	OK(scree_body_set_velocity(world, *last, (scree_velocity){{0.0f, 3.0f}, 0.0f}));
	for (int k = 0; k < 3; ++k)
		OK(scree_world_step(world, STEP, 4));
	return world;
}

// The places in a chain of the world that was in a bay before do not apply to the next one.
static void chains_leave_with_their_world(void** state)
{
	(void)state;
	scree_joint joints[LINKS];
	scree_channel channel = scree_channel_make(SCREE_INPUT_MASS);
	scree_world *world = open_row(5, 1.0f, &channel.body, joints), *templates[ROWS] = {world, world, world, world};
	scree_world *first = clone_of(world), *last = clone_of(world);
	scree_batch* batch = open_batch(templates, ROWS, 0);
	const uint8_t all[ROWS] = {1, 1, 1, 1}, one[ROWS] = {1, 0, 0, 0}, others[ROWS] = {0, 1, 1, 1};
	float rows[4 * ROWS] = {0.0f};
	for (int k = 0; k < ROWS; ++k)
		rows[4 * k] = rows[4 * k + 1] = 1000.0f;
	OK(scree_batch_bind(batch, SCREE_STEP_INPUTS, &channel, 1, rows));
	OK(scree_batch_step(batch, STEP, 4, 2));
	assert_true(batch->blocks[0].pipeline.chain_places > 0 && !world->pipeline.chain_places);
	OK(scree_batch_bind(batch, SCREE_STEP_INPUTS, NULL, 0, NULL));
	OK(scree_batch_reset(batch, NULL));
	OK(scree_batch_pause(batch, all));
	OK(scree_batch_reset(batch, one)); // only its bay gets new places
	step_both(batch, 0, first, 3);
	OK(scree_batch_reset(batch, others));
	step_both(batch, ROWS - 1, last, 20);
	scree_batch_destroy(batch);
	scree_world_destroy(first);
	scree_world_destroy(last);
	scree_world_destroy(world);
}

// A reset disables the joints of a chain, whose search comes with the next step.
static void chains_end_in_a_reset(void** state)
{
	(void)state;
	scree_joint joints[LINKS];
	scree_body last;
	scree_world* world = open_row(LINKS, 1000.0f, &last, joints);
	scree_channel channels[LINKS];
	float row[LINKS] = {0.0f};
	for (int k = 0; k < LINKS; ++k)
	{
		channels[k] = scree_channel_make(SCREE_INPUT_JOINT_ENABLED);
		channels[k].joint = joints[k];
	}
	for (int on = 0; on < 2; ++on)
	{
		scree_world *alone = clone_of(world), *taken;
		scree_batch* batch = open_batch(&world, 1, 0);
		OK(scree_batch_bind(batch, SCREE_RESET_INPUTS, channels, LINKS, row));
		OK(scree_batch_reset(batch, NULL));
		take_out(batch);
		OK(scree_batch_extract(batch, 0, NULL, &taken));
		for (int k = 0; k < LINKS; ++k)
			OK(scree_joint_set_enabled(alone, channels[k].joint, false));
		for (int k = 0; k < LINKS && on; ++k) // the joints are enabled again before the search
		{
			OK(scree_joint_set_enabled(alone, channels[k].joint, true));
			OK(scree_joint_set_enabled(taken, channels[k].joint, true));
		}
		for (int k = 0; k < 3; ++k)
		{
			OK(scree_world_step(alone, STEP, 4));
			OK(scree_world_step(taken, STEP, 4));
			assert_true(hash_alone(taken) == hash_alone(alone));
		}
		scree_world_destroy(taken);
		scree_world_destroy(alone);
		scree_batch_destroy(batch);
	}
	scree_world_destroy(world);
}

// A center of mass that is too near to the origin for the device moves no output.
static void outputs_are_the_poses_of_calls(void** state)
{
	(void)state;
	scree_world* world = open_space();
	scree_body body = box(world, SCREE_BODY_DYNAMIC, 0.0f, 0.5f, 0.5f);
	OK(scree_body_set_mass(world, body, (scree_mass){1.0f, 1.0f, {0.0f, 4.33680869e-19f}}));
	scree_batch* batch = open_batch(&world, 1, 0);
	scree_channel channel = scree_channel_make(SCREE_OUTPUT_POSE);
	float row[4];
	channel.body = body;
	OK(scree_batch_bind(batch, SCREE_OUTPUTS, &channel, 1, row));
	for (int k = 0; k < 2; ++k)
	{
		scree_pose pose;
		OK(scree_batch_step(batch, STEP, 4, 1));
		OK(scree_world_step(world, STEP, 4));
		OK(scree_body_get_pose(world, body, &pose));
		assert_memory_equal(row, &pose, sizeof pose);
	}
	scree_batch_destroy(batch);
	scree_world_destroy(world);
}

// The force of a motor is an output before the first step, although the first world of the batch has no motors.
static void motors_have_forces_at_once(void** state)
{
	(void)state;
	scree_world *worlds[2] = {open_space(), open_space()}, *world = worlds[1];
	scree_joint_def def = scree_joint_def_make(SCREE_JOINT_REVOLUTE);
	scree_channel channel = scree_channel_make(SCREE_OUTPUT_JOINT_FORCE);
	scree_joint_state alone;
	float rows[2][3];
	box(worlds[0], SCREE_BODY_DYNAMIC, 0.0f, 0.5f, 0.5f);
	def.body_b = box(world, SCREE_BODY_DYNAMIC, 0.0f, 0.5f, 0.5f);
	def.coordinates[SCREE_ANGLE].motor = true;
	def.coordinates[SCREE_ANGLE].motor_speed = 100.0f;
	def.coordinates[SCREE_ANGLE].motor_max = 2.0f;
	OK(scree_joint_create(world, &def, &channel.joint));
	OK(scree_world_step(world, STEP, 4));
	OK(scree_joint_get_state(world, channel.joint, &alone));
	assert_true(alone.torque > 1.9f);
	scree_batch* batch = open_batch(worlds, 2, 0);
	OK(scree_batch_bind(batch, SCREE_OUTPUTS, &channel, 1, &rows[0][0]));
	OK(scree_batch_observe(batch));
	assert_true(rows[1][2] == alone.torque);
	OK(scree_batch_step(batch, 0.0f, 4, 1));
	assert_true(rows[1][2] == alone.torque);
	scree_batch_destroy(batch);
	scree_world_destroy(worlds[0]);
	scree_world_destroy(worlds[1]);
}

// A body of a template that was destroyed after the last step touches nothing, also before the first step of a batch.
static void destroyed_bodies_touch_nothing(void** state)
{
	(void)state;
	scree_world* world = open_space();
	scree_body left = box(world, SCREE_BODY_DYNAMIC, 0.0f, 0.5f, 0.5f),
	           right = box(world, SCREE_BODY_DYNAMIC, 1.0f, 0.5f, 0.5f);
	scree_channel channel = scree_channel_make(SCREE_OUTPUT_TOUCH);
	float row[3];
	channel.body = left;
	OK(scree_world_step(world, STEP, 4));
	for (int k = 0; k < 2; ++k)
	{
		scree_batch* batch = open_batch(&world, 1, 0);
		OK(scree_batch_bind(batch, SCREE_OUTPUTS, &channel, 1, row));
		OK(scree_batch_observe(batch));
		assert_int_equal((int)row[0], k == 0);
		OK(scree_batch_step(batch, STEP, 4, 1));
		assert_int_equal((int)row[0], k == 0);
		scree_batch_destroy(batch);
		if (k == 0)
			OK(scree_body_destroy(world, right));
	}
	scree_world_destroy(world);
}

// A state with more contacts than the limit is accepted, as the batch with the limit may have saved it; new ones are not.
static void states_above_the_limit(void** state)
{
	(void)state;
	char row[16384];
	const int first = 0;
	scree_world* world = open_space();
	for (int k = 0; k < 3; ++k)
		box(world, SCREE_BODY_DYNAMIC, 0.0f, 0.5f, 0.5f);
	scree_batch *free_batch = open_batch(&world, 1, 0), *limited = open_batch(&world, 1, 2);
	size_t bytes = scree_batch_get_state_bytes(free_batch);
	assert_true(bytes <= sizeof row);
	OK(scree_batch_step(free_batch, STEP, 4, 1));
	OK(scree_batch_save(free_batch, &first, 1, row, sizeof row));
	OK(scree_batch_load(limited, &first, 1, row, 0));
	assert_true(hash_of_world(limited, 0) == hash_of_world(free_batch, 0));
	OK(scree_batch_save(limited, &first, 1, row, sizeof row));
	OK(scree_batch_load(limited, &first, 1, row, 0));
	scree_batch_destroy(limited);
	scree_batch_destroy(free_batch);
	scree_world* none[2] = {world, NULL};
	scree_batch_def def = scree_batch_def_default();
	def.device = device;
	def.templates = none;
	def.template_count = 2;
	REFUSED(scree_batch_create(&def, &limited), "scree_batch_create: def.templates[1] is null");
	scree_world_destroy(world);
}

// The contacts of the template end after its last step, but not those of a world with as many steps.
static void contacts_of_the_state(void** state)
{
	(void)state;
	static char row[65536];
	const int32_t first = 0;
	scree_world *world = open_space(), *taken;
	scree_body floor = box(world, SCREE_BODY_STATIC, 0.0f, 5.0f, 0.5f),
	           crate = box(world, SCREE_BODY_DYNAMIC, 0.0f, 0.5f, 0.8f);
	for (int k = 0; k < 5; ++k)
		OK(scree_world_step(world, STEP, 4));
	scree_batch* before = open_batch(&world, 1, 0);
	OK(scree_batch_save(before, &first, 1, row, sizeof row));
	OK(scree_body_set_enabled(world, floor, false));
	OK(scree_body_set_enabled(world, floor, true));
	scree_batch* after = open_batch(&world, 1, 0);
	for (int loaded = 0; loaded < 2; ++loaded)
	{
		int contacts;
		if (loaded)
			OK(scree_batch_load(after, &first, 1, row, 0));
		OK(scree_batch_extract(after, 0, NULL, &taken));
		OK(scree_body_get_contacts(taken, crate, NULL, 0, &contacts));
		assert_int_equal(contacts, loaded);
		scree_world_destroy(taken);
	}
	scree_batch_destroy(before);
	scree_batch_destroy(after);
	scree_world_destroy(world);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(calm_worlds_stay_calm),          cmocka_unit_test(exclusions_leave_with_their_world),
	    cmocka_unit_test(disabled_walls_press),           cmocka_unit_test(refused_steps_leave_paths),
	    cmocka_unit_test(refused_steps_leave_sleepers),   cmocka_unit_test(worlds_are_copied_at_once),
	    cmocka_unit_test(chains_leave_with_their_world),  cmocka_unit_test(chains_end_in_a_reset),
	    cmocka_unit_test(outputs_are_the_poses_of_calls), cmocka_unit_test(states_above_the_limit),
	    cmocka_unit_test(contacts_of_the_state),          cmocka_unit_test(motors_have_forces_at_once),
	    cmocka_unit_test(destroyed_bodies_touch_nothing),
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
