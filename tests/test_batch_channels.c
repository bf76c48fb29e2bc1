// SPDX-License-Identifier: MIT
// test_batch_channels.c -- checks that channels of a batch act as the calls of a world alone, and read the same values.
//
// Formula: hash and outputs of a world of a batch = hash and values of the same world alone, to which the same inputs were
// given by calls, bit by bit.
#include "support/batch_checks.h"
#include "support/make_joints.h"
#include "support/second_device.h"

#define WORLDS  7
#define INPUTS  11 // channels of each step
#define OUTPUTS 12
#define STEPS   40
#define RAYS    5
#define LULL    130 // steps of worlds that sleep: in the first ones of each PERIOD, inputs push nothing
#define PERIOD  150

typedef struct // a world with handles of the objects that channels name
{
	scree_world* world;
	scree_body boxes[4], car, wheels[2], lift, floor;
	scree_joint axles[2], spring;
} Rig;

static float random_between(float low, float high) { return low + (high - low) * (float)random_word() / 16777216.0f; }

static bool sleeps; // worlds sleep

static scree_world* open_alone(float unit)
{
	scree_world_def def = scree_world_def_default();
	def.device = "cpu";
	def.threads = 1;
	def.gravity.y = -10.0f;
	def.length_unit = unit;
	def.sleep = sleeps;
	return create_world(&def);
}

static scree_joint axle(scree_world* world, scree_body car, scree_body wheel, float x, float y)
{
	scree_joint_def def = joint_def_at(world, SCREE_JOINT_REVOLUTE, car, wheel, x, y, 0.0f);
	def.coordinates[SCREE_ANGLE].motor = true;
	def.coordinates[SCREE_ANGLE].motor_max = 5.0f;
	return add_joint(world, &def);
}

// Opens a world with boxes, a car and a lift. unit: scree_world_def.length_unit.
static Rig open_rig(float unit)
{
	Rig r = {.world = open_alone(unit)};
	scree_world* world = r.world;
	r.floor = add_box(world, SCREE_BODY_STATIC, 20.0f, 0.5f, 0.0f, -0.5f);
	for (int k = 0; k < 4; ++k)
		r.boxes[k] = add_box(world, SCREE_BODY_DYNAMIC, 0.3f, 0.2f, -4.0f + 0.2f * (float)k, 0.2f + 0.45f * (float)k);
	r.car = add_box(world, SCREE_BODY_DYNAMIC, 0.8f, 0.2f, 2.0f, 0.7f);
	for (int k = 0; k < 2; ++k)
	{
		float x = k ? 2.6f : 1.4f;
		r.wheels[k] = add_disc(world, 0.3f, x, 0.35f);
		r.axles[k] = axle(world, r.car, r.wheels[k], x, 0.35f);
	}
	r.lift = add_box(world, SCREE_BODY_KINEMATIC, 1.0f, 0.1f, 6.0f, 0.5f);
	scree_body load = add_box(world, SCREE_BODY_DYNAMIC, 0.2f, 0.2f, 6.0f, 0.85f);
	scree_joint_def def = joint_def_at(world, SCREE_JOINT_DISTANCE, NOBODY, load, 6.0f, 3.0f, 0.0f);
	def.coordinates[SCREE_ALONG].locked = false;
	def.coordinates[SCREE_ALONG].spring = true;
	def.coordinates[SCREE_ALONG].spring_hertz = 1.0f;
	r.spring = add_joint(world, &def);
	for (int k = 0; k < 10; ++k)
		OK(scree_world_step(world, STEP, SUBSTEPS));
	return r;
}

static int inputs_of(const Rig* r, scree_channel* c)
{
	static const scree_channel_kind kinds[INPUTS] = {
	    SCREE_INPUT_FORCE,       SCREE_INPUT_THRUST,      SCREE_INPUT_TORQUE,       SCREE_INPUT_IMPULSE,
	    SCREE_INPUT_MOTOR_SPEED, SCREE_INPUT_MOTOR_SPEED, SCREE_INPUT_MOTOR_MAX,    SCREE_INPUT_ANGULAR_IMPULSE,
	    SCREE_INPUT_TARGET,      SCREE_INPUT_POSE,        SCREE_INPUT_JOINT_TARGET,
	};
	for (int k = 0; k < INPUTS; ++k)
		c[k] = scree_channel_make(kinds[k]);
	c[0].body = c[2].body = r->boxes[0];
	c[1].body = r->car;
	c[1].point = (scree_vec){-0.8f, 0.1f};
	c[3].body = c[7].body = r->boxes[1];
	c[4].joint = c[6].joint = r->axles[0];
	c[5].joint = r->axles[1];
	c[4].which = c[5].which = c[6].which = SCREE_ANGLE;
	c[8].body = r->lift;
	c[9].body = r->boxes[3];
	c[10].joint = r->spring;
	c[10].which = SCREE_ALONG;
	return 2 + 2 + 1 + 2 + 1 + 1 + 1 + 1 + 4 + 4 + 1;
}

// Writes inputs that push nothing, and otherwise change nothing.
static void idle_inputs(float* v)
{
	for (int k = 0; k < 7; ++k)
		v[k] = 0.0f;
	v[7] = v[8] = v[10] = 0.0f;
	v[11] = 6.0f;
	v[12] = 0.5f;
	v[13] = v[17] = 1.0f;
	v[14] = v[18] = 0.0f;
	v[15] = -12.0f;
	v[16] = 3.0f;
}

static void random_inputs(float* v, int step)
{
	float* to = v;
	if (sleeps && step % PERIOD < LULL)
	{
		idle_inputs(v);
		return;
	}
	for (int k = 0; k < 2; ++k) // force and thrust
		*to++ = random_between(-9.0f, 9.0f);
	for (int k = 0; k < 2; ++k)
		*to++ = random_between(0.0f, 5.0f);
	*to++ = random_between(-1.0f, 1.0f);
	for (int k = 0; k < 2; ++k) // impulse
		*to++ = random_between(-0.5f, 0.5f);
	*to++ = random_between(-9.0f, 9.0f); // motors
	*to++ = random_between(-9.0f, 9.0f);
	*to++ = random_between(0.0f, 9.0f);
	*to++ = random_between(-0.1f, 0.1f);
	float turn = random_between(-0.1f, 0.1f);
	scree_rot lift = scree_rot_make(turn), box = scree_rot_make(30.0f * turn);
	*to++ = (6.0f + random_between(-0.02f, 0.02f));
	*to++ = (0.5f + 0.01f * (float)(step % 20));
	*to++ = lift.c;
	*to++ = lift.s;
	*to++ = (-4.0f + random_between(-1.0f, 1.0f));
	*to++ = (3.0f + random_between(-1.0f, 1.0f));
	*to++ = box.c;
	*to++ = box.s;
	*to++ = random_between(0.5f, 3.0f);
}

static scree_pose pose_in(const float* v) { return (scree_pose){{v[0], v[1]}, {v[2], v[3]}}; }

// Gives a world alone the forces of a row; `all`: all inputs.
static void give_alone(const Rig* r, const float* v, bool all)
{
	scree_world* world = r->world;
	scree_pose car = pose_of(world, r->car);
	scree_vec at,
	    thrust = {car.rotation.c * v[2] - car.rotation.s * v[3], car.rotation.s * v[2] + car.rotation.c * v[3]};
	scree_joint_coordinate motor;
	OK(scree_body_apply_force(world, r->boxes[0], (scree_vec){v[0], v[1]}));
	OK(scree_body_get_world_point(world, r->car, (scree_vec){-0.8f, 0.1f}, &at));
	OK(scree_body_apply_force_at(world, r->car, thrust, at));
	OK(scree_body_apply_torque(world, r->boxes[0], v[4]));
	if (!all)
		return;
	OK(scree_body_apply_impulse(world, r->boxes[1], (scree_vec){v[5], v[6]}));
	OK(scree_joint_set_motor_speed(world, r->axles[0], SCREE_ANGLE, v[7]));
	OK(scree_joint_set_motor_speed(world, r->axles[1], SCREE_ANGLE, v[8]));
	OK(scree_joint_get_coordinate(world, r->axles[0], SCREE_ANGLE, &motor));
	motor.motor_max = v[9];
	OK(scree_joint_set_coordinate(world, r->axles[0], SCREE_ANGLE, &motor));
	OK(scree_body_apply_angular_impulse(world, r->boxes[1], v[10]));
	OK(scree_body_set_target(world, r->lift, pose_in(v + 11)));
	OK(scree_body_set_pose(world, r->boxes[3], pose_in(v + 15)));
	OK(scree_joint_set_target(world, r->spring, SCREE_ALONG, v[19]));
}

static int outputs_of(const Rig* r, scree_channel* c)
{
	static const scree_channel_kind kinds[OUTPUTS] = {
	    SCREE_OUTPUT_POSE,        SCREE_OUTPUT_RELATIVE_POSE, SCREE_OUTPUT_JOINT_VALUE, SCREE_OUTPUT_TOUCH,
	    SCREE_OUTPUT_JOINT_SPEED, SCREE_OUTPUT_RAYS,          SCREE_OUTPUT_JOINT_FORCE, SCREE_OUTPUT_VELOCITY,
	    SCREE_OUTPUT_TOUCH,       SCREE_OUTPUT_RAYS,          SCREE_OUTPUT_JOINT_VALUE, SCREE_OUTPUT_JOINT_SPEED,
	};
	for (int k = 0; k < OUTPUTS; ++k)
		c[k] = scree_channel_make(kinds[k]);
	c[0].body = c[1].body = c[7].body = r->car;
	c[1].other = r->boxes[2];
	c[2].joint = c[6].joint = r->axles[1];
	c[2].which = SCREE_ANGLE;
	c[3].body = r->boxes[0];
	c[4].joint = r->spring;
	c[5].body = r->car;
	c[5].point = (scree_vec){0.0f, 0.3f};
	c[5].translation = (scree_vec){-8.0f, 0.0f};
	c[5].rays = RAYS;
	c[5].spread = 2.0f;
	c[8].collidable = collidable_of(r->world, r->boxes[1]);
	c[8].other_collidable = collidable_of(r->world, r->boxes[0]);
	c[9].point = (scree_vec){-4.0f, 9.0f};
	c[9].translation = (scree_vec){0.1f, -12.0f};
	c[10].joint = c[11].joint = r->axles[0];
	c[10].which = c[11].which = SCREE_ANGLE;
	return 4 + 4 + 1 + 3 + 1 + RAYS + 3 + 3 + 3 + 1 + 2;
}

// Writes the number of touches of a body, with another one only unless it is null, and the sum of their impulses.
static void touches_alone(scree_world* world, scree_body body, scree_body other, float* before, float* to)
{
	scree_contact contacts[32];
	int count;
	float touches = 0.0f, sum = 0.0f;
	OK(scree_body_get_contacts(world, body, contacts, 32, &count));
	for (int k = 0; k < count; ++k)
	{
		scree_body with = scree_body_equals(contacts[k].body_a, body) ? contacts[k].body_b : contacts[k].body_a;
		if (!scree_body_is_null(other) && !scree_body_equals(with, other))
			continue;
		float second = contacts[k].count > 1 ? contacts[k].points[1].normal_impulse : 0.0f;
		sum = sum + (contacts[k].points[0].normal_impulse + second);
		touches += 1.0f;
	}
	to[0] = touches;
	to[1] = touches > 0.0f && *before == 0.0f ? 1.0f : 0.0f;
	to[2] = sum;
	*before = touches;
}

static float ray_alone(scree_world* world, scree_body ignored, scree_vec origin, scree_vec translation)
{
	scree_ray ray = {.origin = origin, .translation = translation, .ignored = ignored};
	scree_query_result found;
	OK(scree_world_cast_rays(world, NULL, &ray, 1, &found));
	return found.hit ? found.fraction : 1.0f;
}

static void read_alone(const Rig* r, float* before, float* to)
{
	scree_world* world = r->world;
	scree_pose car = pose_of(world, r->car), box = pose_of(world, r->boxes[2]);
	scree_rot a = box.rotation, b = car.rotation;
	scree_vec d = {car.position.x - box.position.x, car.position.y - box.position.y}, at;
	scree_velocity v = velocity_of(world, r->car);
	scree_joint_state wheel = joint_state_of(world, r->axles[1]), spring = joint_state_of(world, r->spring);
	*to++ = car.position.x, *to++ = car.position.y, *to++ = b.c, *to++ = b.s;
	*to++ = a.c * d.x + a.s * d.y, *to++ = a.c * d.y - a.s * d.x;
	*to++ = a.c * b.c + a.s * b.s, *to++ = a.c * b.s - a.s * b.c;
	*to++ = wheel.values[SCREE_ANGLE];
	touches_alone(world, r->boxes[0], NOBODY, before, to);
	to += 3;
	*to++ = spring.speeds[SCREE_ALONG];
	OK(scree_body_get_world_point(world, r->car, (scree_vec){0.0f, 0.3f}, &at));
	for (int k = 0; k < RAYS; ++k)
	{
		scree_rot turn = scree_rot_make((float)(((double)k / (RAYS - 1) - 0.5) * 2.0));
		scree_vec way = {turn.c * -8.0f - turn.s * 0.0f, turn.s * -8.0f + turn.c * 0.0f};
		scree_vec path = {b.c * way.x - b.s * way.y, b.s * way.x + b.c * way.y};
		*to++ = ray_alone(world, r->car, at, path);
	}
	*to++ = wheel.force.x, *to++ = wheel.force.y, *to++ = wheel.torque;
	*to++ = v.linear.x, *to++ = v.linear.y, *to++ = v.angular;
	touches_alone(world, r->boxes[1], r->boxes[0], before + 1, to);
	to += 3;
	*to++ = ray_alone(world, NOBODY, (scree_vec){-4.0f, 9.0f}, (scree_vec){0.1f, -12.0f});
	scree_joint_state other = joint_state_of(world, r->axles[0]);
	*to++ = other.values[SCREE_ANGLE], *to++ = other.speeds[SCREE_ANGLE];
}

typedef struct
{
	const char* device;
	int threads, lanes, steps;
} Place;

static scree_batch* open_batch(const Rig* rig, const Place* place)
{
	scree_batch_def def = scree_batch_def_default();
	scree_batch* batch;
	scree_world* template = rig->world;
	def.worlds = WORLDS;
	def.templates = &template;
	def.template_count = 1;
	def.device = place->device;
	def.threads = place->threads;
	def.lanes = lanes_here(place->lanes);
	OK(scree_batch_create(&def, &batch));
	return batch;
}

static int asleep; // number of worlds of which half of the bodies slept after a step

// Counts a world whose boxes sleep.
static void count_asleep(const Rig* rig)
{
	scree_counters counters;
	OK(scree_world_get_counters(rig->world, &counters));
	asleep += counters.asleep_bodies >= 3;
}

static int began, hits, pulls; // values of outputs that are not those of a world at rest

static void check_row(const float* row, const float* alone, int columns, int world, int step)
{
	began += row[10] == 1.0f;
	hits += row[17] < 1.0f;
	pulls += row[18] != 0.0f;
	for (int k = 0; k < columns; ++k)
		if (row[k] != alone[k])
			fail_msg("step %d, world %d, column %d: %.9g, alone %.9g", step, world, k, (double)row[k],
			         (double)alone[k]);
}

// Random inputs and random resets, with velocities at the reset: each world has the bits of the world alone.
static void check_place(const Rig* rig, const Place* place)
{
	scree_channel in[INPUTS], out[OUTPUTS], start = scree_channel_make(SCREE_INPUT_VELOCITY);
	int columns = inputs_of(rig, in), seen = outputs_of(rig, out);
	float *input, *output;
	float velocity[WORLDS][3], alone[64], before[WORLDS][2];
	uint64_t hashes[WORLDS];
	Rig worlds[WORLDS];
	scree_batch* batch = open_batch(rig, place);
	start.body = rig->boxes[2];
	// the batch replaces its own memory by memory of the same kind, or the program's by its own
	OK(scree_batch_bind(batch, SCREE_OUTPUTS, out, 1, place->lanes ? &alone[0] : NULL));
	OK(scree_batch_bind(batch, SCREE_STEP_INPUTS, in, INPUTS, NULL));
	OK(scree_batch_bind(batch, SCREE_OUTPUTS, out, OUTPUTS, NULL));
	input = scree_batch_get_rows(batch, SCREE_STEP_INPUTS);
	output = scree_batch_get_rows(batch, SCREE_OUTPUTS);
	OK(scree_batch_bind(batch, SCREE_RESET_INPUTS, &start, 1, &velocity[0][0]));
	assert_int_equal(scree_batch_get_columns(batch, SCREE_STEP_INPUTS), columns);
	assert_int_equal(scree_batch_get_columns(batch, SCREE_OUTPUTS), seen);
	OK(scree_batch_observe(batch));
	for (int w = 0; w < WORLDS; ++w)
	{
		worlds[w] = *rig;
		worlds[w].world = clone_of(rig->world);
		before[w][0] = output[w * seen + 9];
		before[w][1] = output[w * seen + 9 + 3 + 1 + RAYS + 6];
	}
	for (int step = 0; step < place->steps; ++step)
	{
		uint8_t mask[WORLDS];
		for (int w = 0; w < WORLDS; ++w)
		{
			random_inputs(input + w * columns, step);
			mask[w] = random_between(0.0f, 1.0f) < (sleeps ? 0.01f : 0.1f);
			for (int k = 0; k < 3; ++k)
				velocity[w][k] = random_between(-2.0f, 2.0f);
			if (!mask[w])
				continue;
			scree_world_destroy(worlds[w].world);
			worlds[w].world = clone_of(rig->world);
			float unused[3];
			touches_alone(worlds[w].world, rig->boxes[0], NOBODY, before[w], unused);
			touches_alone(worlds[w].world, rig->boxes[1], rig->boxes[0], before[w] + 1, unused);
			OK(scree_body_set_velocity(worlds[w].world, rig->boxes[2],
			                           (scree_velocity){{velocity[w][0], velocity[w][1]}, velocity[w][2]}));
		}
		OK(scree_batch_reset(batch, mask));
		OK(scree_batch_step(batch, STEP, SUBSTEPS, 1 + step % 2));
		OK(scree_batch_get_hashes(batch, hashes));
		for (int w = 0; w < WORLDS; ++w)
		{
			give_alone(worlds + w, input + w * columns, true);
			OK(scree_world_step(worlds[w].world, STEP, SUBSTEPS));
			if (step % 2)
			{
				give_alone(worlds + w, input + w * columns, false);
				OK(scree_world_step(worlds[w].world, STEP, SUBSTEPS));
			}
			if (hashes[w] != hash_of(worlds[w].world))
				fail_msg("%s: step %d, world %d: another hash than alone", place->device, step, w);
			count_asleep(worlds + w);
			read_alone(worlds + w, before[w], alone);
			check_row(output + w * seen, alone, seen, w, step);
		}
	}
	for (int w = 0; w < WORLDS; ++w)
		scree_world_destroy(worlds[w].world);
	scree_batch_destroy(batch);
}

static void channels_are_calls(void** state)
{
	(void)state;
	const Place places[] = {{"cpu", 1, 0, STEPS}, {"cpu", 2, 1, STEPS}, {"cpu", 1, 4, STEPS}, {second_device, 0, 0, 8}};
	random_state = 7;
	Rig rig = open_rig(1.0f);
	for (size_t k = 0; k < sizeof places / sizeof *places; ++k)
		if (places[k].device[0])
			check_place(&rig, places + k);
	assert_true(began > 10 && hits > 100 && pulls > 100);
	scree_world_destroy(rig.world);
	rig = open_rig(2.0f); // values are in units of length, and a power of two rounds nothing
	check_place(&rig, places);
	scree_world_destroy(rig.world);
	assert_int_equal(scree_memory(), 0);
}

// In worlds that sleep, inputs wake bodies as calls do. Motors and targets of unchanged values wake nothing.
static void inputs_wake_bodies(void** state)
{
	(void)state;
	const Place places[] = {{"cpu", 1, 0, 320}, {"cpu", 2, 1, 320}, {"cpu", 1, 4, 320}, {second_device, 0, 0, 160}};
	random_state = 11;
	sleeps = true;
	asleep = 0;
	Rig rig = open_rig(1.0f);
	for (size_t k = 0; k < sizeof places / sizeof *places; ++k)
		if (places[k].device[0])
			check_place(&rig, places + k);
	assert_true(asleep > 500);
	scree_world_destroy(rig.world);
	sleeps = false;
	assert_int_equal(scree_memory(), 0);
}

// Inputs of a template that lacks their object have no effect, and outputs are 0.
static void templates_may_lack_objects(void** state)
{
	(void)state;
	Rig rig = open_rig(1.0f);
	scree_world* worlds[2] = {rig.world, clone_of(rig.world)};
	OK(scree_body_destroy(worlds[1], rig.boxes[1]));
	OK(scree_world_step(worlds[0], STEP, SUBSTEPS));
	OK(scree_world_step(worlds[1], STEP, SUBSTEPS));
	scree_batch_def def = scree_batch_def_default();
	scree_batch* batch;
	scree_channel in = scree_channel_make(SCREE_INPUT_IMPULSE), out = scree_channel_make(SCREE_OUTPUT_POSE);
	float input[4][2] = {{0.1f, 0.2f}, {0.1f, 0.2f}, {0.3f, 0.0f}, {0.3f, 0.0f}}, output[4][4];
	uint64_t hashes[4];
	def.worlds = 4;
	def.templates = worlds;
	def.template_count = 2;
	OK(scree_batch_create(&def, &batch));
	in.body = out.body = rig.boxes[1];
	OK(scree_batch_bind(batch, SCREE_STEP_INPUTS, &in, 1, input[0]));
	OK(scree_batch_bind(batch, SCREE_OUTPUTS, &out, 1, output[0]));
	OK(scree_batch_step(batch, STEP, SUBSTEPS, 1));
	OK(scree_batch_get_hashes(batch, hashes));
	OK(scree_body_apply_impulse(worlds[0], rig.boxes[1], (scree_vec){0.1f, 0.2f}));
	OK(scree_world_step(worlds[0], STEP, SUBSTEPS));
	OK(scree_world_step(worlds[1], STEP, SUBSTEPS));
	assert_true(hashes[0] == hash_of(worlds[0]) && hashes[1] == hash_of(worlds[1]));
	assert_true(hashes[2] != hashes[0] && hashes[3] == hashes[1]);
	assert_true(output[0][0] == pose_of(worlds[0], rig.boxes[1]).position.x && output[1][0] == 0.0f &&
	            output[1][2] == 0.0f);
	scree_batch_destroy(batch);
	scree_world_destroy(worlds[0]);
	scree_world_destroy(worlds[1]);
	assert_int_equal(scree_memory(), 0);
}

static void bad_channels_are_refused(void** state)
{
	(void)state;
	Rig rig = open_rig(1.0f);
	static const Place place = {"cpu", 1, 0, 0};
	scree_batch* batch = open_batch(&rig, &place);
	float rows[WORLDS][4] = {{0.0f}};
	uint64_t before[WORLDS], after[WORLDS];
	scree_channel c = scree_channel_make(SCREE_INPUT_FORCE);
	OK(scree_batch_get_hashes(batch, before));
	assert_int_equal(scree_batch_bind(batch, SCREE_STEP_INPUTS, &c, 1, rows[0]), SCREE_ERROR_STALE);
	assert_string_equal(scree_error(), "scree_batch_bind: channels[0] has an object that no template has");
	c.body = rig.lift;
	REFUSED(scree_batch_bind(batch, SCREE_STEP_INPUTS, &c, 1, rows[0]),
	        "scree_batch_bind: channels[0] pushes a body that is not dynamic (template 0)");
	REFUSED(scree_batch_bind(batch, SCREE_OUTPUTS, &c, 1, rows[0]), "scree_batch_bind: channels[0].kind is an input");
	REFUSED(scree_batch_bind(batch, (scree_channels)3, &c, 1, rows[0]),
	        "scree_batch_bind: list is 3, not a list of channels");
	REFUSED(scree_batch_bind(NULL, SCREE_STEP_INPUTS, &c, 1, rows[0]), "scree_batch_bind: batch is null");
	c = scree_channel_make(SCREE_OUTPUT_RAYS);
	c.rays = 0;
	REFUSED(scree_batch_bind(batch, SCREE_OUTPUTS, &c, 1, rows[0]),
	        "scree_batch_bind: channels[0].rays is 0, must be from 1 to 1024");
	c = scree_channel_make(SCREE_INPUT_MOTOR_SPEED);
	c.joint = rig.spring;
	REFUSED(
	    scree_batch_bind(batch, SCREE_STEP_INPUTS, &c, 1, rows[0]),
	    "scree_batch_bind: channels[0] drives a coordinate of a joint without a motor, or with a lock (template 0)");
	c = scree_channel_make(SCREE_INPUT_POSE);
	c.body = rig.boxes[0];
	OK(scree_batch_bind(batch, SCREE_STEP_INPUTS, &c, 1, rows[0]));
	REFUSED(scree_batch_step(batch, STEP, SUBSTEPS, 1),
	        "scree_batch_step: inputs of world 0[0].rotation is (0, 0), not the cosine and sine of an angle: see "
	        "scree_rot_make");
	for (int w = 0; w < WORLDS; ++w)
		rows[w][2] = 1.0f;
	rows[5][1] = 1.0e30f;
	REFUSED(scree_batch_step(batch, STEP, SUBSTEPS, 1),
	        "scree_batch_step: inputs of world 5[0].position.y is 1e+30, must be from -100000 to 100000");
	OK(scree_batch_get_hashes(batch, after));
	assert_memory_equal(before, after, sizeof before);
	OK(scree_batch_bind(batch, SCREE_STEP_INPUTS, NULL, 0, NULL));
	assert_null(scree_batch_get_rows(batch, SCREE_STEP_INPUTS));
	OK(scree_batch_step(batch, STEP, SUBSTEPS, 1));
	OK(scree_batch_observe(batch));
	assert_int_equal(scree_batch_get_columns(NULL, SCREE_OUTPUTS), 0);
	scree_batch_destroy(batch);
	scree_world_destroy(rig.world);
	assert_int_equal(scree_memory(), 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(channels_are_calls),
	    cmocka_unit_test(inputs_wake_bodies),
	    cmocka_unit_test(templates_may_lack_objects),
	    cmocka_unit_test(bad_channels_are_refused),
	};
	return cmocka_run_group_tests(tests, find_second_device, NULL);
}
