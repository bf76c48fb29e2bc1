// SPDX-License-Identifier: MIT
// test_batch_sensors.c -- checks sensors of worlds of a batch, and outputs that are values of a world.
//
// Formula: hash, visits and counters of a world of a batch = those of the same world alone after the same calls. The hash
// covers the visits to sensors at the end of the last step.
#include "batch/batch.h"
#include "support/batch_checks.h"
#include "support/make_joints.h"
#include "support/second_device.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define SENSORS 5
#define WORLDS  7
#define KINDS   2 // templates: many balls and several sensors; few of both
#define VALUES  3 // outputs that are values of the world
#define STEPS   60
#define FEW     4  // balls of both templates
#define MANY    70 // further balls of the first one

typedef struct
{
	const char* device;
	int worlds, threads, lanes;
} Place;

typedef struct
{
	scree_world* world;
	scree_collidable sensors[SENSORS];
	scree_body ball; // one that falls
	int count;       // number of sensors
} Rig;

static scree_collidable add_sensor(scree_world* world, scree_body body, scree_shape shape, uint32_t sees, float x,
                                   float y)
{
	scree_collidable_def def = scree_collidable_def_default();
	def.body = body;
	def.attribute = shape_attribute(world, shape);
	def.pose = upright_at(x, y);
	def.sensor = sees;
	return create_collidable(world, &def);
}

// Opens a world with sensors that rest, that move by themselves, and that ride on falling bodies. kind: 0 or 1. unit:
// scree_world_def.length_unit.
static Rig open_rig(int kind, float unit)
{
	scree_world_def def = scree_world_def_default();
	def.device = "cpu";
	def.threads = 1;
	def.gravity.y = -10.0f;
	def.length_unit = unit;
	def.sleep = false;
	Rig r = {.world = create_world(&def), .count = kind ? 2 : SENSORS};
	scree_world* world = r.world;
	add_box(world, SCREE_BODY_STATIC, 20.0f, 0.5f, 0.0f, -0.5f);
	scree_body lift = add_box(world, SCREE_BODY_KINEMATIC, 0.3f, 0.1f, -6.0f, 1.0f);
	OK(scree_body_set_velocity(world, lift, (scree_velocity){{6.0f, 0.2f}, 3.0f}));
	for (int k = 0; k < FEW; ++k)
		r.ball = add_disc(world, 0.2f, -1.5f + (float)k, 2.0f + 0.1f * (float)k);
	r.sensors[0] = add_sensor(world, NOBODY, box_shape(2.0f, 0.6f), SCREE_SENSOR_MOVING, 0.0f, 0.5f);
	r.sensors[1] =
	    add_sensor(world, lift, box_shape(0.6f, 0.3f), SCREE_SENSOR_MOVING | SCREE_SENSOR_STATIC, 0.3f, 0.2f);
	if (kind)
		return r;
	r.sensors[2] = add_sensor(world, r.ball, circle_shape(0.5f), 7u, 0.0f, 0.0f);
	r.sensors[3] = add_sensor(world, NOBODY, circle_shape(1.0f), SCREE_SENSOR_SENSORS, 2.0f, 1.0f);
	r.sensors[4] = add_sensor(world, lift, capsule_shape(0.5f, 0.1f), SCREE_SENSOR_MOVING, 0.0f, 1.0f);
	for (int k = 0; k < MANY; ++k)
		add_disc(world, 0.2f, -3.0f + 0.41f * (float)(k % 14), 3.0f + 0.6f * (float)(k / 14));
	scree_filter filter;
	OK(scree_collidable_get_filter(world, r.sensors[4], &filter));
	filter.mask = 2;
	OK(scree_collidable_set_filter(world, r.sensors[4], filter));
	return r;
}

static void close_rigs(Rig* rigs)
{
	for (int k = 0; k < KINDS; ++k)
		scree_world_destroy(rigs[k].world);
}

static scree_batch* open_rigs(const Rig* rigs, int kinds, const Place* place)
{
	scree_world* worlds[KINDS];
	scree_batch_def def = scree_batch_def_default();
	scree_batch* batch;
	for (int k = 0; k < kinds; ++k)
		worlds[k] = rigs[k].world;
	def.worlds = place->worlds;
	def.templates = worlds;
	def.template_count = kinds;
	def.device = place->device;
	def.threads = place->threads;
	def.lanes = lanes_here(place->lanes);
	OK(scree_batch_create(&def, &batch));
	return batch;
}

static int visits_alone(scree_world* world, scree_collidable sensor, scree_visit* visits, int capacity)
{
	int count;
	OK(scree_collidable_get_visits(world, sensor, visits, capacity, &count));
	return count;
}

// Binds the counts of all sensors, and the values of the world. Handles of the first template are those of the second one.
static float* bind_outputs(scree_batch* batch, const Rig* rig)
{
	scree_channel c[SENSORS + VALUES];
	for (int k = 0; k < SENSORS; ++k)
	{
		c[k] = scree_channel_make(SCREE_OUTPUT_SENSOR_COUNT);
		c[k].collidable = rig->sensors[k];
	}
	c[SENSORS] = scree_channel_make(SCREE_OUTPUT_OVERLAP);
	c[SENSORS + 1] = scree_channel_make(SCREE_OUTPUT_JOINT_GAP);
	c[SENSORS + 2] = scree_channel_make(SCREE_OUTPUT_NOT_FINITE);
	OK(scree_batch_bind(batch, SCREE_OUTPUTS, c, SENSORS + VALUES, NULL));
	assert_int_equal(scree_batch_get_columns(batch, SCREE_OUTPUTS), SENSORS + VALUES);
	return scree_batch_get_rows(batch, SCREE_OUTPUTS);
}

static int seen, changes; // numbers of visits, and of steps after which a count differs

static void check_row(const float* row, const float* before, scree_world* world, const Rig* rig, int count, int step)
{
	scree_counters counters;
	OK(scree_world_get_counters(world, &counters));
	const float expected[VALUES] = {counters.penetration, counters.joint_gap, counters.frozen_bodies > 0 ? 1.0f : 0.0f};
	for (int k = 0; k < count; ++k)
	{
		int visits = visits_alone(world, rig->sensors[k], NULL, 0);
		if (row[k] != (float)visits)
			fail_msg("step %d, sensor %d: %g visitors, alone %d", step, k, (double)row[k], visits);
		seen += visits;
		changes += row[k] != before[k];
	}
	for (int k = 0; k < VALUES; ++k)
		if (row[SENSORS + k] != expected[k])
			fail_msg("step %d, value %d: %g, alone %g", step, k, (double)row[SENSORS + k], (double)expected[k]);
}

static void check_events(scree_world* world, scree_world* taken)
{
	scree_events a = events_of(world), b = events_of(taken);
	assert_int_equal(a.visits_began_count, b.visits_began_count);
	assert_int_equal(a.visits_ended_count, b.visits_ended_count);
	for (int k = 0; k < a.visits_began_count; ++k)
		assert_memory_equal(a.visits_began + k, b.visits_began + k, sizeof *a.visits_began);
	for (int k = 0; k < a.visits_ended_count; ++k)
		assert_memory_equal(a.visits_ended + k, b.visits_ended + k, sizeof *a.visits_ended);
}

// Takes a world out, which lists the visits of the world alone, and begins and ends the same ones in the next steps.
static void check_taken(scree_batch* batch, int number, scree_world* alone, const Rig* rig, float dt)
{
	scree_world *taken, *world = clone_of(alone);
	scree_visit visits[2][80];
	OK(scree_batch_extract(batch, number, NULL, &taken));
	for (int k = 0; k < rig->count; ++k)
	{
		int count = visits_alone(world, rig->sensors[k], visits[0], 80);
		assert_int_equal(count, visits_alone(taken, rig->sensors[k], visits[1], 80));
		assert_memory_equal(visits[0], visits[1], sizeof *visits[0] * (size_t)count);
	}
	for (int step = 0; step < 4; ++step)
	{
		assert_true(hash_of(world) == hash_of(taken));
		OK(scree_world_step(world, dt, SUBSTEPS));
		OK(scree_world_step(taken, dt, SUBSTEPS));
		check_events(world, taken);
	}
	scree_world_destroy(world);
	scree_world_destroy(taken);
}

// Random resets, pauses, saves and loads: each world has the hash and the visits of the world alone.
static void check_place(const Rig* rigs, const Place* place, int steps)
{
	scree_batch* batch = open_rigs(rigs, KINDS, place);
	float *output = bind_outputs(batch, rigs), before[WORLDS][SENSORS + VALUES] = {{0.0f}};
	scree_world* worlds[WORLDS];
	uint64_t hashes[WORLDS];
	uint8_t mask[WORLDS] = {0}, paused[WORLDS] = {0};
	size_t bytes = 0;
	char* state = NULL;
	scree_world* saved = NULL;
	for (int w = 0; w < WORLDS; ++w)
		worlds[w] = clone_of(rigs[w % KINDS].world);
	for (int step = 0; step < steps; ++step)
	{
		int more = 1 + random_below(3), w = random_below(WORLDS), from = random_below(WORLDS);
		float dt = step % 9 == 4 ? 0.0f : STEP;
		memset(mask, 0, sizeof mask);
		mask[w] = random_below(4) == 0;
		if (mask[w])
		{
			scree_world_destroy(worlds[w]);
			worlds[w] = clone_of(rigs[w % KINDS].world);
			paused[w] = 0;
		}
		OK(scree_batch_reset(batch, mask));
		if (step % 5 == 2)
		{
			paused[from] = !paused[from];
			OK(scree_batch_pause(batch, paused));
		}
		if (step % 7 == 3)
		{
			const int32_t first = from, second = w - w % KINDS;
			free(state);
			bytes = scree_batch_get_state_bytes(batch);
			state = malloc(bytes);
			OK(scree_batch_save(batch, &first, 1, state, bytes));
			scree_world_destroy(saved);
			saved = clone_of(worlds[from]);
			if (from % KINDS == second % KINDS)
			{
				OK(scree_batch_load(batch, &second, 1, state, 0));
				scree_world_destroy(worlds[second]);
				worlds[second] = clone_of(saved);
			}
		}
		OK(scree_batch_get_hashes(batch, hashes));
		for (int n = 0; n < WORLDS; ++n)
			if (hashes[n] != hash_of(worlds[n]))
				fail_msg("%s: before step %d, world %d: another hash than alone", place->device, step, n);
		OK(scree_batch_step(batch, dt, SUBSTEPS, more));
		OK(scree_batch_get_hashes(batch, hashes));
		for (int n = 0; n < WORLDS; ++n)
		{
			for (int k = 0; k < more && !paused[n]; ++k)
				OK(scree_world_step(worlds[n], dt, SUBSTEPS));
			if (hashes[n] != hash_of(worlds[n]))
				fail_msg("%s: step %d, world %d: another hash than alone", place->device, step, n);
			if (!paused[n])
				check_row(output + n * (SENSORS + VALUES), before[n], worlds[n], rigs, rigs[n % KINDS].count, step);
		}
		memcpy(before, output, sizeof before);
		if (step % 6 == 1)
			check_taken(batch, w, worlds[w], rigs + w % KINDS, STEP);
	}
	free(state);
	scree_world_destroy(saved);
	for (int w = 0; w < WORLDS; ++w)
		scree_world_destroy(worlds[w]);
	scree_batch_destroy(batch);
}

static void visits_are_those_alone(void** state)
{
	(void)state;
	const Place places[] = {{"cpu", WORLDS, 1, 0},
	                        {"cpu", WORLDS, 2, 1},
	                        {"cpu", WORLDS, 1, 4},
	                        {"cpu", WORLDS, 3, 8},
	                        {second_device, WORLDS, 0, 0}};
	random_state = 3;
	for (int age = 0; age < 2; ++age)
	{
		Rig rigs[KINDS] = {open_rig(0, age ? 2.0f : 1.0f), open_rig(1, age ? 2.0f : 1.0f)};
		for (int k = 0; k < 20 * age; ++k)
			for (int kind = 0; kind < KINDS; ++kind)
				OK(scree_world_step(rigs[kind].world, STEP, SUBSTEPS));
		for (size_t k = 0; k < sizeof places / sizeof *places; ++k)
			if (places[k].device[0])
				check_place(rigs, places + k, k == 4 ? 16 : quick() ? STEPS / 3 : STEPS);
		close_rigs(rigs);
	}
	assert_true(seen > 1000 && changes > 100);
	assert_int_equal(scree_memory(), 0);
}

// Poses of a reset change no visits before the next step, as calls for a world alone, also in a world that is taken out.
static void placed_bodies_keep_visits(void** state)
{
	(void)state;
	Rig rig = open_rig(0, 1.0f);
	for (int k = 0; k < 40; ++k)
		OK(scree_world_step(rig.world, STEP, SUBSTEPS));
	const Place place = {"cpu", 3, 1, 0};
	scree_batch* batch = open_rigs(&rig, 1, &place);
	scree_channel pose = scree_channel_make(SCREE_INPUT_POSE);
	float rows[3][4] = {{9.0f, 3.0f, 1.0f, 0.0f}, {0.0f, 0.5f, 1.0f, 0.0f}, {-9.0f, 4.0f, 1.0f, 0.0f}};
	uint64_t hashes[3];
	pose.body = rig.ball;
	OK(scree_batch_bind(batch, SCREE_RESET_INPUTS, &pose, 1, rows[0]));
	float* output = bind_outputs(batch, &rig);
	OK(scree_batch_step(batch, STEP, SUBSTEPS, 5));
	OK(scree_batch_reset(batch, NULL));
	OK(scree_batch_observe(batch));
	OK(scree_batch_get_hashes(batch, hashes));
	for (int w = 0; w < 3; ++w)
	{
		scree_world* alone = clone_of(rig.world);
		scree_pose to = {{rows[w][0], rows[w][1]}, {1.0f, 0.0f}};
		OK(scree_body_set_pose(alone, rig.ball, to));
		assert_true(hashes[w] == hash_of(alone));
		check_row(output + w * (SENSORS + VALUES), output, alone, &rig, SENSORS, 0);
		scree_world* taken;
		OK(scree_batch_extract(batch, w, NULL, &taken));
		assert_true(hash_of(taken) == hash_of(alone));
		for (int step = 0; step < 3; ++step)
		{
			OK(scree_world_step(alone, STEP, SUBSTEPS));
			OK(scree_world_step(taken, STEP, SUBSTEPS));
			assert_true(hash_of(taken) == hash_of(alone));
			check_events(alone, taken);
		}
		scree_world_destroy(alone);
		scree_world_destroy(taken);
	}
	scree_batch_destroy(batch);
	scree_world_destroy(rig.world);
	assert_int_equal(scree_memory(), 0);
}

// A world that is paused in the middle of a call, because it has too many contacts, keeps the visits of its last step. A
// world alone with this limit refuses the same step.
static void crowded_worlds_keep_visits(void** state)
{
	(void)state;
	const int limit = 12;
	scree_world_def def = scree_world_def_default();
	def.device = "cpu";
	def.threads = 1;
	def.gravity.y = -10.0f;
	def.sleep = false;
	def.contact_limit = limit;
	scree_world* world = create_world(&def);
	add_floor(world);
	for (int k = 0; k < 20; ++k)
		add_crate(world, SCREE_BODY_DYNAMIC, 0.3f * (float)(k % 3), 1.0f + 1.3f * (float)k);
	scree_collidable sensor = add_sensor(world, NOBODY, box_shape(3.0f, 3.0f), SCREE_SENSOR_MOVING, 0.0f, 3.0f);
	scree_world* alone;
	scree_batch* batch;
	scree_batch_def many = scree_batch_def_default();
	scree_batch_counters counters[2];
	uint64_t hashes[2];
	many.worlds = 2;
	many.templates = &world;
	many.template_count = 1;
	many.contact_limit = limit;
	alone = clone_of(world);
	OK(scree_batch_create(&many, &batch));
	OK(scree_batch_step(batch, STEP, SUBSTEPS, 400));
	OK(scree_batch_get_counters(batch, counters));
	OK(scree_batch_get_hashes(batch, hashes));
	int steps = 0;
	while (steps < 400 && scree_world_step(alone, STEP, SUBSTEPS) == SCREE_OK)
		++steps;
	assert_true(steps > 10 && steps < 400 && counters[1].crowded > limit);
	assert_true(visits_alone(alone, sensor, NULL, 0) > 0);
	assert_true(hashes[0] == hash_of(alone) && hashes[1] == hashes[0]);
	scree_batch_destroy(batch);
	scree_world_destroy(world);
	scree_world_destroy(alone);
	assert_int_equal(scree_memory(), 0);
}

// A body that is not finite is frozen in its next step. The output of its world is 1 after this step only.
static void frozen_bodies_are_noticed(void** state)
{
	(void)state;
	const Place places[] = {{"cpu", 3, 1, 0}, {"cpu", 3, 1, 1}, {second_device, 3, 0, 0}};
	Rig rig = open_rig(1, 1.0f);
	for (size_t k = 0; k < sizeof places / sizeof *places; ++k)
	{
		if (!places[k].device[0])
			continue;
		scree_batch* batch = open_rigs(&rig, 1, places + k);
		scree_channel c = scree_channel_make(SCREE_OUTPUT_NOT_FINITE);
		float rows[3] = {9.0f, 9.0f, 9.0f};
		OK(scree_batch_bind(batch, SCREE_OUTPUTS, &c, 1, rows));
		OK(scree_batch_step(batch, STEP, SUBSTEPS, 1));
		assert_true(rows[0] == 0.0f && rows[1] == 0.0f && rows[2] == 0.0f);
		Backend* b = batch->blocks[0].backend;
		int body = batch->blocks[0].pipeline.bays.bodies + (int)rig.ball.index;
		BodyState wrong;
		OK(b->f->read(b, POOL_body, body, 1, &wrong));
		wrong.vx = NAN;
		OK(b->f->write(b, POOL_body, body, 1, &wrong));
		OK(scree_batch_step(batch, STEP, SUBSTEPS, 1));
		assert_true(rows[0] == 0.0f && rows[1] == 1.0f && rows[2] == 0.0f);
		OK(scree_batch_step(batch, STEP, SUBSTEPS, 1));
		assert_true(rows[0] == 0.0f && rows[1] == 0.0f && rows[2] == 0.0f);
		scree_batch_destroy(batch);
	}
	scree_world_destroy(rig.world);
	assert_int_equal(scree_memory(), 0);
}

// A visit to a collidable that is no longer a sensor ends in the next step, so it is refused before it.
static void bad_sensors_are_refused(void** state)
{
	(void)state;
	Rig rig = open_rig(0, 1.0f);
	const Place place = {"cpu", 2, 1, 0};
	float rows[2][4];
	for (int k = 0; k < 40; ++k)
		OK(scree_world_step(rig.world, STEP, SUBSTEPS));
	scree_batch* batch = open_rigs(&rig, 1, &place);
	scree_channel c = scree_channel_make(SCREE_OUTPUT_SENSOR_COUNT);
	REFUSED(scree_batch_bind(batch, SCREE_OUTPUTS, &c, 1, rows[0]),
	        "scree_batch_bind: channels[0] has no collidable (template 0)");
	scree_body floor = add_box(rig.world, SCREE_BODY_STATIC, 1.0f, 1.0f, 30.0f, 0.0f);
	scree_batch_destroy(batch);
	batch = open_rigs(&rig, 1, &place);
	c.collidable = collidable_of(rig.world, floor);
	REFUSED(scree_batch_bind(batch, SCREE_OUTPUTS, &c, 1, rows[0]),
	        "scree_batch_bind: channels[0] counts the visitors of a collidable that is no sensor (template 0)");
	c = scree_channel_make(SCREE_OUTPUT_OVERLAP);
	c.body = rig.ball;
	char sentence[160];
	snprintf(sentence, sizeof sentence,
	         "scree_batch_bind: channels[0].body (index %u) must be null, because the channel is a value of the world",
	         rig.ball.index);
	REFUSED(scree_batch_bind(batch, SCREE_OUTPUTS, &c, 1, rows[0]), sentence);
	REFUSED(scree_batch_bind(batch, SCREE_STEP_INPUTS, &c, 1, rows[0]),
	        "scree_batch_bind: channels[0].kind is an output");
	assert_true(visits_alone(rig.world, rig.sensors[0], NULL, 0) > 0);
	OK(scree_collidable_set_sensor(rig.world, rig.sensors[0], 0));
	REFUSED(scree_batch_insert(batch, 0, rig.world),
	        "scree_batch_insert: the world has visits to a collidable that is no "
	        "longer a sensor, which worlds of a batch cannot have yet");
	OK(scree_world_step(rig.world, STEP, SUBSTEPS));
	REFUSED(scree_batch_insert(batch, 0, rig.world), "scree_batch_insert: from has other settings, or other shapes, "
	                                                 "densities, joints or rules, than the template of "
	                                                 "world 0");
	scree_batch_destroy(batch);
	batch = open_rigs(&rig, 1, &place);
	scree_batch_destroy(batch);
	scree_world_destroy(rig.world);
	assert_int_equal(scree_memory(), 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(visits_are_those_alone),     cmocka_unit_test(placed_bodies_keep_visits),
	    cmocka_unit_test(crowded_worlds_keep_visits), cmocka_unit_test(frozen_bodies_are_noticed),
	    cmocka_unit_test(bad_sensors_are_refused),
	};
	return cmocka_run_group_tests(tests, find_second_device, NULL);
}
