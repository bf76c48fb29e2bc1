// SPDX-License-Identifier: MIT
// test_batch_parameters.c -- checks inputs that set gravity, masses, surfaces, and which bodies and joints are enabled.
//
// Formula: hash of a world of a batch = hash of the same world alone, to which the same values were given by calls, bit by bit,
// through resets, pauses, and states that are saved, loaded, taken out and put back.
#include "support/batch_checks.h"
#include "support/make_joints.h"
#include "support/second_device.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define WORLDS   6
#define STEPS    50
#define LINKS    10 // bodies of a chain, whose joints are solved together
#define MASSES   4
#define SURFACES 5
#define BODIES   6
#define JOINTS   3
#define COLUMNS  (2 + 4 * MASSES + 4 * SURFACES + BODIES + JOINTS + 2)
#define CHANNELS (1 + MASSES + SURFACES + BODIES + JOINTS + 1)

typedef struct // a world with handles of the objects that channels name
{
	scree_world* world;
	scree_body masses[MASSES], bodies[BODIES];
	scree_collidable surfaces[SURFACES];
	scree_joint joints[JOINTS];
	int pace; // acts are rarer by this factor
} Rig;

static int slept; // number of steps of worlds in which some bodies slept

static float random_between(float low, float high) { return low + (high - low) * (float)random_word() / 16777216.0f; }

static scree_joint hinge(scree_world* world, scree_body a, scree_body b, float x, float y)
{
	scree_joint_def def = joint_def_at(world, SCREE_JOINT_REVOLUTE, a, b, x, y, 0.0f);
	return add_joint(world, &def);
}

// Adds a body with two discs of a shared attribute that the user made.
static scree_body dumbbell(scree_world* world, scree_collidable* second)
{
	scree_attribute_def attribute = scree_attribute_def_default();
	scree_attribute made;
	scree_body body = add_disc(world, 0.2f, -6.0f, 2.0f);
	scree_collidable_def def = scree_collidable_def_default();
	OK(scree_shape_make_circle((scree_vec){0.5f, 0.0f}, 0.2f, &attribute.shape));
	OK(scree_attribute_create(world, &attribute, &made));
	def.attribute = made;
	def.body = body;
	OK(scree_collidable_create(world, &def, second));
	return body;
}

static void add_sensor(scree_world* world, scree_body body, float x, float y)
{
	scree_collidable_def def = scree_collidable_def_default();
	def.body = body;
	def.attribute = shape_attribute(world, box_shape(1.0f, 0.7f));
	def.pose = upright_at(x, y);
	def.sensor = SCREE_SENSOR_MOVING;
	create_collidable(world, &def);
}

// Opens a world with boxes, a dumbbell, a chain that hangs, a hub with arms, a platform and sensors. unit:
// scree_world_def.length_unit. sleep: most bodies soon sleep, unless something wakes them.
static Rig open_rig(float unit, bool sleep)
{
	scree_world_def def = scree_world_def_default();
	def.device = "cpu";
	def.threads = 1;
	def.gravity.y = -10.0f;
	def.length_unit = unit;
	def.sleep = sleep;
	def.sleep_threshold = 1.0f;
	Rig r = {.world = create_world(&def), .pace = sleep ? 100 : 1};
	scree_world* world = r.world;
	scree_body floor = add_box(world, SCREE_BODY_STATIC, 20.0f, 0.5f, 0.0f, -0.5f), boxes[4], links[LINKS], arms[3];
	for (int k = 0; k < 4; ++k)
		boxes[k] = add_box(world, SCREE_BODY_DYNAMIC, 0.3f, 0.2f, -4.0f + 0.2f * (float)k, 0.2f + 0.45f * (float)k);
	scree_body weights = dumbbell(world, r.surfaces + 4);
	for (int k = 0; k < LINKS; ++k)
	{
		float x = 0.5f * (float)k;
		links[k] = add_box(world, SCREE_BODY_DYNAMIC, 0.22f, 0.1f, x + 0.25f, 4.0f);
		scree_joint joint = hinge(world, k ? links[k - 1] : NOBODY, links[k], x, 4.0f);
		if (k == 4)
			r.joints[0] = joint;
	}
	scree_body hub = add_disc(world, 0.3f, 8.0f, 1.5f);
	for (int k = 0; k < 3; ++k)
	{
		scree_rot turn = scree_rot_make(2.1f * (float)k);
		arms[k] = add_box(world, SCREE_BODY_DYNAMIC, 0.3f, 0.3f, 8.0f + 1.1f * turn.c, 1.5f + 1.1f * turn.s);
		r.joints[k == 2 ? 1 : 2] = hinge(world, hub, arms[k], 8.0f + 0.5f * turn.c, 1.5f + 0.5f * turn.s);
	}
	scree_body platform = add_box(world, SCREE_BODY_KINEMATIC, 1.0f, 0.1f, -4.0f, 3.0f);
	OK(scree_body_set_velocity(world, platform, (scree_velocity){{0.3f, -0.1f}, 0.2f}));
	scree_body masses[MASSES] = {boxes[0], links[5], hub, weights};
	scree_body bodies[BODIES] = {boxes[1], links[7], arms[0], platform, floor, weights};
	memcpy(r.masses, masses, sizeof masses);
	memcpy(r.bodies, bodies, sizeof bodies);
	r.surfaces[0] = collidable_of(world, boxes[0]);
	r.surfaces[1] = collidable_of(world, floor);
	r.surfaces[2] = collidable_of(world, boxes[2]);
	r.surfaces[3] = collidable_of(world, boxes[3]);
	add_sensor(world, floor, -4.0f, 0.8f);
	add_sensor(world, weights, 0.0f, 0.0f);
	add_sensor(world, platform, 0.0f, -1.0f);
	for (int k = 0; k < 30; ++k)
		OK(scree_world_step(world, STEP, SUBSTEPS));
	return r;
}

// Lists all parameters, and at last an impulse.
static void channels_of(const Rig* r, scree_channel* c)
{
	*c++ = scree_channel_make(SCREE_INPUT_GRAVITY);
	for (int k = 0; k < MASSES; ++k, ++c)
	{
		*c = scree_channel_make(SCREE_INPUT_MASS);
		c->body = r->masses[k];
	}
	for (int k = 0; k < SURFACES; ++k, ++c)
	{
		*c = scree_channel_make(SCREE_INPUT_SURFACE);
		c->collidable = r->surfaces[k];
	}
	for (int k = 0; k < BODIES; ++k, ++c)
	{
		*c = scree_channel_make(SCREE_INPUT_ENABLED);
		c->body = r->bodies[k];
	}
	for (int k = 0; k < JOINTS; ++k, ++c)
	{
		*c = scree_channel_make(SCREE_INPUT_JOINT_ENABLED);
		c->joint = r->joints[k];
	}
	*c = scree_channel_make(SCREE_INPUT_IMPULSE);
	c->body = r->masses[0];
}

static int one_of(int count) { return random_below(count) == 0; }

// Writes random values; every `rarely`-th value differs from those before. The first call sets all.
static void random_values(float* v, int rarely)
{
	static const float frictions[] = {0.6f, 0.1f, 0.9f, 1.0e-41f}, bounces[] = {0.0f, 0.0f, 0.5f, 0.9f};
	if (one_of(rarely))
	{
		v[0] = random_between(-2.0f, 2.0f);
		v[1] = random_between(-12.0f, 0.0f);
	}
	v += 2;
	for (int k = 0; k < MASSES; ++k, v += 4)
	{
		if (!one_of(rarely))
			continue;
		v[0] = one_of(3) ? random_between(0.001f, 0.01f) : random_between(0.5f, 9.0f);
		v[1] = one_of(4) ? 0.0f : random_between(0.0001f, 1.0f);
		v[2] = one_of(2) ? 0.0f : random_between(-0.1f, 0.1f);
		v[3] = one_of(2) ? -0.0f : random_between(-0.1f, 0.1f);
	}
	for (int k = 0; k < SURFACES; ++k, v += 4)
	{
		if (!one_of(rarely))
			continue;
		v[0] = frictions[random_below(4)];
		v[1] = bounces[random_below(4)];
		v[2] = one_of(3) ? 0.2f : -0.0f;
		v[3] = one_of(4) ? random_between(-3.0f, 3.0f) : 0.0f;
	}
	for (int k = 0; k < BODIES + JOINTS; ++k, ++v)
		if (one_of(rarely))
			*v = one_of(k == 4 ? 20 : 3) ? 0.0f : 1.0f;
	bool pushes = rarely < 10 || one_of(rarely);
	v[0] = pushes ? random_between(-0.5f, 0.5f) : 0.0f;
	v[1] = pushes ? random_between(-0.5f, 0.5f) : 0.0f;
}

static void first_values(float* v)
{
	memset(v, 0, sizeof(float) * COLUMNS);
	for (int k = 0; k < MASSES; ++k)
		v[2 + 4 * k] = v[3 + 4 * k] = 0.3f;
	for (int k = 0; k < BODIES + JOINTS; ++k)
		v[2 + 4 * (MASSES + SURFACES) + k] = 1.0f;
	random_values(v, 1);
}

// Gives a world alone the values of a row by calls.
static void give_alone(scree_world* world, const Rig* r, const float* v)
{
	OK(scree_world_set_gravity(world, (scree_vec){v[0], v[1]}));
	v += 2;
	for (int k = 0; k < MASSES; ++k, v += 4)
	{
		scree_mass mass = {v[0], v[1], {v[2], v[3]}}, now;
		OK(scree_body_get_own_mass(world, r->masses[k], &now));
		if (memcmp(&mass, &now, sizeof mass) != 0)
			OK(scree_body_set_mass(world, r->masses[k], mass));
	}
	for (int k = 0; k < SURFACES; ++k, v += 4)
	{
		scree_surface surface = scree_surface_default();
		surface.friction = v[0];
		surface.restitution = v[1];
		surface.rolling_resistance = v[2];
		surface.tangent_speed = v[3];
		OK(scree_collidable_set_surface(world, r->surfaces[k], &surface));
	}
	for (int k = 0; k < BODIES; ++k)
		OK(scree_body_set_enabled(world, r->bodies[k], *v++ == 1.0f));
	for (int k = 0; k < JOINTS; ++k)
		OK(scree_joint_set_enabled(world, r->joints[k], *v++ == 1.0f));
	OK(scree_body_apply_impulse(world, r->masses[0], (scree_vec){v[0], v[1]}));
}

typedef struct
{
	const char* device;
	int threads, lanes, steps;
} Place;

typedef struct // a batch, and the same worlds alone
{
	scree_batch* batch;
	scree_world* alone[WORLDS];
	scree_vec gravity[WORLDS];
	bool paused[WORLDS];
} Pair;

static Pair open_pair(const Rig* rig, const Place* place)
{
	scree_batch_def def = scree_batch_def_default();
	scree_world* template = rig->world;
	Pair pair = {.batch = NULL};
	def.worlds = WORLDS;
	def.templates = &template;
	def.template_count = 1;
	def.device = place->device;
	def.threads = place->threads;
	def.lanes = lanes_here(place->lanes);
	OK(scree_batch_create(&def, &pair.batch));
	for (int w = 0; w < WORLDS; ++w)
	{
		pair.alone[w] = clone_of(rig->world);
		OK(scree_world_get_gravity(rig->world, pair.gravity + w));
	}
	return pair;
}

static void close_pair(Pair* pair)
{
	for (int w = 0; w < WORLDS; ++w)
		scree_world_destroy(pair->alone[w]);
	scree_batch_destroy(pair->batch);
}

static void replace(Pair* pair, int w, scree_world* from)
{
	scree_world* before = pair->alone[w]; // may be `from`
	pair->alone[w] = clone_of(from);
	scree_world_destroy(before);
	OK(scree_world_set_gravity(pair->alone[w], pair->gravity[w]));
}

static void check_pair(const Pair* pair, const char* what, int step)
{
	uint64_t hashes[WORLDS];
	OK(scree_batch_get_hashes(pair->batch, hashes));
	for (int w = 0; w < WORLDS; ++w)
		if (hashes[w] != hash_of(pair->alone[w]))
			fail_msg("step %d, world %d: another hash than alone after %s", step, w, what);
}

// Saves a world of one batch, and loads it into a world of the other one.
static void move_state(Pair* from, Pair* to, int step)
{
	int32_t saved = random_below(WORLDS), loaded = random_below(WORLDS);
	size_t bytes = scree_batch_get_state_bytes(from->batch);
	char* row = malloc(bytes + 1);
	OK(scree_batch_save(from->batch, &saved, 1, row + 1, bytes));
	OK(scree_batch_load(to->batch, &loaded, 1, row + 1, bytes));
	free(row);
	replace(to, loaded, from->alone[saved]);
	check_pair(to, "a load", step);
}

// Takes a world out, steps it, changes it, and puts it into a world of the other batch.
static void move_world(Pair* from, Pair* to, const Rig* rig, int step)
{
	int taken = random_below(WORLDS), put = random_below(WORLDS);
	float values[COLUMNS];
	scree_world *made, *alone = clone_of(from->alone[taken]);
	OK(scree_batch_extract(from->batch, taken, NULL, &made));
	assert_true(hash_of(made) == hash_of(alone));
	first_values(values);
	for (int k = 0; k < 4; ++k)
	{
		if (k == 2)
		{
			give_alone(made, rig, values);
			give_alone(alone, rig, values);
		}
		OK(scree_world_step(made, STEP, SUBSTEPS));
		OK(scree_world_step(alone, STEP, SUBSTEPS));
		if (hash_of(made) != hash_of(alone))
			fail_msg("step %d: a world that was taken out differs after %d steps", step, k + 1);
	}
	OK(scree_batch_insert(to->batch, put, made));
	replace(to, put, alone);
	scree_world_destroy(made);
	scree_world_destroy(alone);
	check_pair(to, "an insertion", step);
}

static void reset_some(Pair* pair, const Rig* rig, bool inputs, float rows[WORLDS][COLUMNS], int step)
{
	uint8_t mask[WORLDS];
	for (int w = 0; w < WORLDS; ++w)
	{
		mask[w] = (uint8_t)one_of(8 * rig->pace);
		first_values(rows[w]);
		if (!mask[w])
			continue;
		replace(pair, w, rig->world);
		pair->paused[w] = false;
		if (!inputs)
			continue;
		give_alone(pair->alone[w], rig, rows[w]);
		pair->gravity[w] = (scree_vec){rows[w][0], rows[w][1]};
	}
	OK(scree_batch_reset(pair->batch, mask));
	check_pair(pair, "a reset", step);
}

static void pause_some(Pair* pair)
{
	uint8_t mask[WORLDS];
	for (int w = 0; w < WORLDS; ++w)
		mask[w] = pair->paused[w] = one_of(5);
	OK(scree_batch_pause(pair->batch, mask));
}

// rows: inputs, or null.
static void step_pair(Pair* pair, const Rig* rig, const float* rows, int step)
{
	OK(scree_batch_step(pair->batch, STEP, SUBSTEPS, 1));
	for (int w = 0; w < WORLDS; ++w)
	{
		if (pair->paused[w])
			continue;
		if (rows)
		{
			give_alone(pair->alone[w], rig, rows + w * COLUMNS);
			pair->gravity[w] = (scree_vec){rows[w * COLUMNS], rows[w * COLUMNS + 1]};
		}
		OK(scree_world_step(pair->alone[w], STEP, SUBSTEPS));
		slept += counters_of(pair->alone[w]).asleep_bodies > 3;
	}
	check_pair(pair, "a step", step);
}

// Two batches: only the first one has inputs. Worlds move between them.
static void check_place(const Rig* rig, const Place* place)
{
	scree_channel channels[CHANNELS];
	float starts[WORLDS][COLUMNS], rows[WORLDS][COLUMNS];
	Pair a = open_pair(rig, place), b = open_pair(rig, place);
	channels_of(rig, channels);
	for (int w = 0; w < WORLDS; ++w)
		first_values(rows[w]);
	for (int step = 0; step < place->steps; ++step)
	{
		if (step == 3)
		{
			OK(scree_batch_bind(a.batch, SCREE_STEP_INPUTS, channels, CHANNELS, rows[0]));
			OK(scree_batch_bind(a.batch, SCREE_RESET_INPUTS, channels, CHANNELS, starts[0]));
			assert_int_equal(scree_batch_get_columns(a.batch, SCREE_STEP_INPUTS), COLUMNS);
		}
		for (int w = 0; w < WORLDS; ++w)
			random_values(rows[w], 6 * rig->pace);
		reset_some(&a, rig, step >= 3, starts, step);
		if (one_of(3))
			pause_some(&a);
		step_pair(&a, rig, step >= 3 ? rows[0] : NULL, step);
		reset_some(&b, rig, false, starts, step);
		if (one_of(3))
			pause_some(&b);
		step_pair(&b, rig, NULL, step);
		if (one_of(2 * rig->pace))
			move_state(&a, one_of(2) ? &a : &b, step);
		if (one_of(3 * rig->pace))
			move_state(&b, &a, step);
		if (one_of(4 * rig->pace))
			move_world(&a, one_of(2) ? &a : &b, rig, step);
		if (one_of(6 * rig->pace))
			move_world(&b, &a, rig, step);
	}
	close_pair(&a);
	close_pair(&b);
}

static void parameters_are_calls(void** state)
{
	(void)state;
	const Place places[] = {{"cpu", 1, 0, STEPS}, {"cpu", 3, 1, STEPS},  {"cpu", 1, 4, STEPS},
	                        {"cpu", 2, 8, STEPS}, {"cpu", 1, 16, STEPS}, {second_device, 0, 0, 8}};
	random_state = 17;
	Rig rig = open_rig(1.0f, false);
	for (size_t k = 0; k < sizeof places / sizeof *places; ++k)
		if (places[k].device[0])
			check_place(&rig, places + k);
	scree_world_destroy(rig.world);
	rig = open_rig(2.0f, false); // values are in units of length, and a power of two rounds nothing
	check_place(&rig, places);
	scree_world_destroy(rig.world);
	assert_int_equal(scree_memory(), 0);
}

// The same in worlds that sleep, whose values change rarely.
static void parameters_wake(void** state)
{
	(void)state;
	const Place places[] = {
	    {"cpu", 1, 0, 8 * STEPS}, {"cpu", 3, 1, 8 * STEPS}, {"cpu", 1, 8, 8 * STEPS}, {second_device, 0, 0, 8}};
	random_state = 18;
	Rig rig = open_rig(1.0f, true);
	slept = 0;
	for (size_t k = 0; k < sizeof places / sizeof *places; ++k)
		if (places[k].device[0])
			check_place(&rig, places + k);
	assert_true(slept > 8 * STEPS);
	scree_world_destroy(rig.world);
	assert_int_equal(scree_memory(), 0);
}

static void bad_parameters_are_refused(void** state)
{
	(void)state;
	static const Place place = {"cpu", 1, 0, 0};
	Rig rig = open_rig(1.0f, false);
	Pair pair = open_pair(&rig, &place);
	float rows[WORLDS][4];
	scree_channel c = scree_channel_make(SCREE_INPUT_MASS);
	for (int w = 0; w < WORLDS; ++w)
		rows[w][0] = rows[w][1] = rows[w][2] = rows[w][3] = 1.0f;
	c.body = rig.bodies[3];
	REFUSED(scree_batch_bind(pair.batch, SCREE_STEP_INPUTS, &c, 1, rows[0]),
	        "scree_batch_bind: channels[0] sets the mass of a body that is not dynamic (template 0)");
	REFUSED(scree_batch_bind(pair.batch, SCREE_OUTPUTS, &c, 1, rows[0]),
	        "scree_batch_bind: channels[0].kind is an input");
	c.body = rig.masses[0];
	OK(scree_batch_bind(pair.batch, SCREE_STEP_INPUTS, &c, 1, rows[0]));
	rows[2][0] = 0.0f;
	REFUSED(scree_batch_step(pair.batch, STEP, SUBSTEPS, 1),
	        "scree_batch_step: inputs of world 2[0] is 0, must be from 1e-15 to 1.0995116e+12");
	rows[2][0] = 1.0f;
	rows[3][1] = 1.0e-30f;
	REFUSED(scree_batch_step(pair.batch, STEP, SUBSTEPS, 1),
	        "scree_batch_step: inputs of world 3[1] (when it is not 0) is 1e-30, must be from 1e-20 to 1.0995116e+12");
	rows[3][1] = 0.0f;
	c = scree_channel_make(SCREE_INPUT_SURFACE);
	REFUSED(scree_batch_bind(pair.batch, SCREE_STEP_INPUTS, &c, 1, rows[0]),
	        "scree_batch_bind: channels[0] has no collidable (template 0)");
	c.collidable = rig.surfaces[0];
	OK(scree_batch_bind(pair.batch, SCREE_STEP_INPUTS, &c, 1, rows[0]));
	rows[1][1] = 100.5f;
	REFUSED(scree_batch_step(pair.batch, STEP, SUBSTEPS, 1),
	        "scree_batch_step: inputs of world 1[1] is 100.5, must be from 0 to 100");
	c = scree_channel_make(SCREE_INPUT_JOINT_ENABLED);
	c.joint = rig.joints[0];
	OK(scree_batch_bind(pair.batch, SCREE_STEP_INPUTS, &c, 1, rows[0]));
	rows[1][0] = 0.5f;
	REFUSED(scree_batch_step(pair.batch, STEP, SUBSTEPS, 1),
	        "scree_batch_step: inputs of world 4[0] is 0.5, must be 0 or 1");
	c = scree_channel_make(SCREE_INPUT_GRAVITY);
	scree_channel twice[2] = {c, c};
	REFUSED(scree_batch_bind(pair.batch, SCREE_STEP_INPUTS, twice, 2, rows[0]),
	        "scree_batch_bind: columns 0 and 2 set the same value of a world (template 0)");
	OK(scree_batch_bind(pair.batch, SCREE_STEP_INPUTS, &c, 1, rows[0]));
	rows[1][0] = NAN;
	REFUSED(scree_batch_step(pair.batch, STEP, SUBSTEPS, 1),
	        "scree_batch_step: inputs of world 2[0] is nan, must be finite");
	check_pair(&pair, "refused inputs", 0);
	close_pair(&pair);
	scree_world_destroy(rig.world);
	assert_int_equal(scree_memory(), 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(bad_parameters_are_refused),
	    cmocka_unit_test(parameters_are_calls),
	    cmocka_unit_test(parameters_wake),
	};
	return cmocka_run_group_tests(tests, find_second_device, NULL);
}
