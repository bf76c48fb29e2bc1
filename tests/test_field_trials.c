// SPDX-License-Identifier: MIT
// test_field_trials.c -- checks fields in unusual use: floating bodies, moving fields, extreme values, changes between
// steps, all devices.
#include "support/allocations.h"
#include "support/make_fields.h"
#include "support/scenarios.h"
#include "tools/common/random_numbers.h"
#include <math.h>
#include <string.h>

static scree_field_def water_def(float density)
{
	scree_field_def def = scree_field_def_default(SCREE_FIELD_BUOYANCY);
	def.density = density;
	return def;
}

// A body with half of the density of the fluid floats half immersed, within 1 %, and stays at rest for minutes. A body
// denser than the fluid sinks.
static void bodies_float_and_sink(void** state)
{
	(void)state;
	scree_world* world = stay_awake(open_world((float)-G));
	scree_field_def def = water_def(2.0f);
	add_field(world, &def);
	scree_body flat = add_dense(world, box_shape(1.0f, 0.25f), 1.0f, 0.0f, 0.4f);
	scree_body disc = add_dense(world, circle_shape(0.5f), 1.0f, 5.0f, 0.3f);
	scree_body log = add_dense(world, capsule_shape(1.0f, 0.3f), 1.0f, 10.0f, 1.0f);
	scree_body stone = add_dense(world, box_shape(0.3f, 0.3f), 5.0f, 15.0f, 0.0f);
	scree_body third = add_dense(world, box_shape(1.0f, 0.15f), 0.5f, 20.0f, 0.0f);
	run_steps(world, 1200);
	NEAR(position_of(world, flat).y, 0.0, 0.0025);
	NEAR(position_of(world, disc).y, 0.0, 0.005);
	NEAR(position_of(world, log).y, 0.0, 0.003);
	NEAR(position_of(world, third).y, 0.15 - 0.3 * 0.25, 0.001);
	assert_true(position_of(world, stone).y < -10.0f);
	scree_world_destroy(world);

	// a floating body does not move for minutes, at the origin and 50 km away
	for (int far = 0; far < 2; ++far)
	{
		world = stay_awake(open_world((float)-G));
		add_field(world, &def);
		float x = far ? 50000.0f : 0.0f;
		flat = add_dense(world, box_shape(1.0f, 0.25f), 1.0f, x, 0.4f);
		run_steps(world, 1200);
		scree_vec before = position_of(world, flat);
		run_steps(world, quick() ? 600 : 7200);
		scree_velocity v = velocity_of(world, flat);
		NEAR(position_of(world, flat).y, before.y, 1e-4);
		NEAR(position_of(world, flat).x, before.x, far ? 0.02 : 1e-3);
		assert_true(fabsf(v.linear.x) < 1e-3f && fabsf(v.linear.y) < 1e-3f && fabsf(v.angular) < 1e-3f);
		scree_world_destroy(world);
	}
}

// Bodies with 1/50 to 1/1,000,000 of the density of the fluid dive and come up again. They are not thrown out of the
// fluid, and come to rest on its surface. Such bodies are common, because the default density is 1/1,000 of that of
// water. A raft with 1/20 of the density of the fluid carries fifteen times its own weight, at the depth given by
// Archimedes.
static void light_bodies_stay(void** state)
{
	(void)state;
	for (float density = 0.02f; density > 1e-7f; density *= 0.1f)
		for (int k = 0; k < 3; ++k)
		{
			scree_world* world = open_world((float)-G);
			scree_field_def def = water_def(1.0f);
			add_field(world, &def);
			scree_shape shape = k == 0 ? circle_shape(0.3f) : box_shape(k == 1 ? 0.3f : 1.0f, k == 1 ? 0.3f : 0.1f);
			scree_attribute_def attribute = surface_of(shape);
			attribute.density = density < 1e-6f ? 1e-6f : density;
			scree_body body = add_body(world, SCREE_BODY_DYNAMIC, add_attribute(world, &attribute), 0.0f, 2.0f, 0.3f);
			scree_body ball = add_dense(world, circle_shape(0.3f), attribute.density, 5.0f, -8.0f);
			float most = 0.0f;
			for (int step = 0; step < 1800; ++step)
			{
				run_steps(world, 1);
				most = fmaxf(most, position_of(world, ball).y);
			}
			assert_true(most < 3.0f);
			NEAR(position_of(world, body).y, k == 2 ? 0.1 : 0.3, 0.08);
			NEAR(position_of(world, ball).y, 0.3, 0.08);
			scree_world_destroy(world);
		}
	scree_world* world = open_world((float)-G);
	scree_field_def def = water_def(1.0f);
	add_field(world, &def);
	scree_body raft = add_dense(world, box_shape(1.0f, 0.5f), 0.05f, 0.0f, 0.0f);
	add_dense(world, box_shape(0.9f, 0.1f), 15.0f * 0.1f / 0.36f, 0.0f, 0.6f);
	OK(scree_body_set_locks(world, raft, SCREE_LOCK_ROTATION));
	run_steps(world, 1200);
	NEAR(position_of(world, raft).y, 0.5 - 16.0 * 0.1 / 2.0, 0.01);
	scree_world_destroy(world);
}

// Buoyancy acts on each collidable of a body. A narrow boat with a heavy keel turns upright, even if it starts on its
// side or almost upside down.
static void boats_right_themselves(void** state)
{
	(void)state;
	for (float turn = -2.6f; turn <= 2.6f; turn += 1.3f)
	{
		scree_world* world = open_world((float)-G);
		scree_field_def def = water_def(1.0f);
		add_field(world, &def);
		scree_attribute_def hull = surface_of(box_shape(0.5f, 0.4f)), keel = surface_of(box_shape(0.3f, 0.05f));
		hull.density = 0.2f;
		keel.density = 6.0f;
		scree_body boat = add_body(world, SCREE_BODY_DYNAMIC, add_attribute(world, &hull), 0.0f, 0.5f, turn);
		scree_collidable_def part = scree_collidable_def_default();
		part.attribute = add_attribute(world, &keel);
		part.body = boat;
		part.pose.position.y = -0.5f;
		OK(scree_collidable_create(world, &part, NULL));
		run_steps(world, 1800);
		NEAR(angle_of(world, boat), 0.0, 0.01);
		// mass of hull and keel = mass of the displaced fluid: 0.2 * 0.8 + 6 * 0.06 = 1 * draft + 0.06
		double draft = 0.2 * 0.8 + 6.0 * 0.06 - 0.06;
		NEAR(position_of(world, boat).y, 0.4 - draft, 0.01);
		scree_world_destroy(world);
	}
}

// A field on a moving body moves with this body, but does not push it.
static void fields_move_with_bodies(void** state)
{
	(void)state;
	scree_world* world = open_world(0.0f);
	scree_body truck = add_dense(world, box_shape(0.5f, 0.5f), 1.0f, 0.0f, 0.0f);
	throw_body(world, truck, 5.0f, 0.0f, 0.0f);
	scree_field_def def = scree_field_def_default(SCREE_FIELD_UNIFORM);
	def.body = truck;
	def.pose.position.x = 3.0f;
	def.shape = box_shape(1.0f, 1.0f);
	def.acceleration.y = 6.0f;
	scree_field field = add_field(world, &def);
	scree_body ahead = add_dense(world, circle_shape(0.1f), 1.0f, 12.0f, 0.0f);
	run_steps(world, 60); // the region reaches x = 12 m after 1.6 s
	NEAR(velocity_of(world, ahead).linear.y, 0.0, 1e-9);
	run_steps(world, 90);
	assert_true(velocity_of(world, ahead).linear.y > 1.0f);
	NEAR(velocity_of(world, truck).linear.y, 0.0, 1e-9);

	// the field of a disabled body does not act; the field of a destroyed body is destroyed too
	OK(scree_body_set_pose(world, ahead, upright_at(position_of(world, truck).x + 3.0f, 0.0f)));
	throw_body(world, ahead, 5.0f, 0.0f, 0.0f);
	OK(scree_body_set_enabled(world, truck, false));
	run_steps(world, 5);
	NEAR(velocity_of(world, ahead).linear.y, 0.0, 1e-9);
	OK(scree_body_set_enabled(world, truck, true));
	OK(scree_body_set_pose(world, ahead, upright_at(position_of(world, truck).x + 3.0f, 0.0f)));
	run_steps(world, 5);
	assert_true(velocity_of(world, ahead).linear.y > 0.1f);
	OK(scree_body_destroy(world, truck));
	assert_false(scree_field_is_valid(world, field));
	scree_field fields[1];
	int count;
	OK(scree_world_get_fields(world, fields, 1, &count));
	assert_int_equal(count, 0);
	scree_world_destroy(world);
}

// Fields push enabled dynamic bodies with a category in the mask of the field. They do not push a body in a locked
// direction.
static void who_is_pushed(void** state)
{
	(void)state;
	scree_world* world = open_world(0.0f);
	scree_field_def def = scree_field_def_default(SCREE_FIELD_UNIFORM);
	def.acceleration.x = 6.0f;
	def.mask = 2;
	scree_field field = add_field(world, &def);
	scree_body crate = add_dense(world, box_shape(0.5f, 0.5f), 1.0f, 0.0f, 0.0f);
	scree_body off = add_dense(world, box_shape(0.5f, 0.5f), 1.0f, 0.0f, 5.0f);
	scree_body held = add_dense(world, box_shape(0.5f, 0.5f), 1.0f, 0.0f, 10.0f);
	add_crate(world, SCREE_BODY_KINEMATIC, 0.0f, 15.0f);
	OK(scree_body_set_enabled(world, off, false));
	OK(scree_body_set_locks(world, held, SCREE_LOCK_X));
	run_steps(world, 10);
	NEAR(velocity_of(world, crate).linear.x, 0.0, 1e-9);
	scree_collidable part = collidable_of(world, crate);
	OK(scree_collidable_set_filter(world, part, (scree_filter){.category = 3, .mask = UINT64_MAX}));
	run_steps(world, 10);
	NEAR(velocity_of(world, crate).linear.x, 1.0, 1e-5);
	OK(scree_field_get_def(world, field, &def));
	def.mask = def.category;
	OK(scree_field_set_def(world, field, &def));
	run_steps(world, 10);
	NEAR(velocity_of(world, crate).linear.x, 2.0, 1e-5);
	NEAR(velocity_of(world, off).linear.x, 0.0, 1e-9);
	NEAR(velocity_of(world, held).linear.x, 0.0, 1e-9);
	OK(scree_body_set_enabled(world, off, true));
	NEAR(velocity_of(world, off).linear.x, 0.0, 1e-9);
	scree_world_destroy(world);
}

// Drag does not move a body that rests on the floor, for any coefficient.
static void drag_leaves_weights_alone(void** state)
{
	(void)state;
	scree_world* world = open_world((float)-G);
	add_floor(world);
	scree_field_def def = scree_field_def_default(SCREE_FIELD_DRAG);
	def.linear_drag = 1e6f;
	add_field(world, &def);
	scree_body box = add_dense(world, box_shape(0.5f, 0.5f), 3.0f, 0.0f, 0.5f);
	run_steps(world, 120);
	scree_vec before = position_of(world, box);
	run_steps(world, 600);
	NEAR(position_of(world, box).y, before.y, 1e-5);
	NEAR(position_of(world, box).y, 0.5, 0.005);
	scree_world_destroy(world);
}

static void wrong_arguments_are_refused(void** state)
{
	(void)state;
	scree_world* world = open_world(0.0f);
	const struct
	{
		size_t offset;
		float value;
		const char* sentence;
	} cases[] = {
	    {offsetof(scree_field_def, strength), NAN,
	     "scree_field_create: def.strength is nan, must be from -1e+12 to 1e+12"},
	    {offsetof(scree_field_def, radius), 0.0f, "scree_field_create: def.radius is 0, must be from 0.001 to 100000"},
	    {offsetof(scree_field_def, softening), -1.0f,
	     "scree_field_create: def.softening is -1, must be from 0 to 100000"},
	    {offsetof(scree_field_def, density), -1.0f, "scree_field_create: def.density is -1, must be from 0 to 1e+12"},
	    {offsetof(scree_field_def, velocity), 2e5f,
	     "scree_field_create: def.velocity.x is 200000, must be from -100000 to 100000"},
	    {offsetof(scree_field_def, force), INFINITY,
	     "scree_field_create: def.force.x is inf, must be from -1e+12 to 1e+12"},
	};
	uint64_t before = hash_of(world);
	for (size_t k = 0; k < sizeof cases / sizeof *cases; ++k)
	{
		scree_field_def def = scree_field_def_default(SCREE_FIELD_WIND);
		memcpy((char*)&def + cases[k].offset, &cases[k].value, sizeof(float));
		assert_int_equal(scree_field_create(world, &def, NULL), SCREE_ERROR_INVALID);
		assert_string_equal(scree_error(), cases[k].sentence);
	}
	scree_field_def def = scree_field_def_default(SCREE_FIELD_BUOYANCY);
	def.shape = circle_shape(1.0f);
	assert_int_equal(scree_field_create(world, &def, NULL), SCREE_ERROR_INVALID);
	assert_string_equal(scree_error(), "scree_field_create: def.shape must be a polygon without rounding, or none");
	def = scree_field_def_default((scree_field_type)6);
	assert_int_equal(scree_field_create(world, &def, NULL), SCREE_ERROR_INVALID);
	assert_string_equal(scree_error(), "scree_field_create: def.type is 6, not a scree_field_type");
	def = scree_field_def_default(SCREE_FIELD_DRAG);
	def.body = (scree_body){77, 1};
	assert_int_equal(scree_field_create(world, &def, NULL), SCREE_ERROR_STALE);
	def = scree_field_def_default(SCREE_FIELD_DRAG);
	def.shape.kind = SCREE_SHAPE_POLYGON;
	def.shape.count = 2;
	assert_int_equal(scree_field_create(world, &def, NULL), SCREE_ERROR_INVALID);
	assert_string_equal(scree_error(), "scree_field_create: def.shape.count is 2, must be from 3 to 8 for this kind");
	assert_int_equal(scree_field_destroy(world, SCREE_NULL_FIELD), SCREE_ERROR_STALE);
	assert_string_equal(scree_error(), "scree_field_destroy: field is null");
	def = scree_field_def_default(SCREE_FIELD_DRAG);
	scree_field field = add_field(world, &def);
	OK(scree_field_destroy(world, field));
	assert_int_equal(scree_field_set_enabled(world, field, true), SCREE_ERROR_STALE);
	assert_true(hash_of(world) == before);
	scree_world_destroy(world);
}

// Makes each allocation fail in turn, while a field is created and the next step is taken. The failing call returns a
// status and changes nothing.
static void memory_runs_out(void** state)
{
	(void)state;
	scree_field_def def = water_def(2.0f);
	count_allocations();
	for (int left = 0, failures = 1; failures > 0; ++left)
	{
		scree_world* worlds[2];
		failures = 0;
		for (int k = 0; k < 2; ++k)
		{
			worlds[k] = open_world((float)-G);
			add_dense(worlds[k], box_shape(0.5f, 0.5f), 1.0f, 0.0f, 0.0f);
			run_steps(worlds[k], 1);
			allocations_left = k == 0 ? left : -1;
			scree_status status = scree_field_create(worlds[k], &def, NULL);
			if (status == SCREE_OK)
				status = scree_world_step(worlds[k], STEP, SUBSTEPS);
			allocations_left = -1;
			if (status == SCREE_OK)
				continue;
			assert_int_equal(status, SCREE_ERROR_OUT_OF_MEMORY);
			++failures;
			int count;
			OK(scree_world_get_fields(worlds[k], NULL, 0, &count));
			if (count == 0)
				add_field(worlds[k], &def);
			run_steps(worlds[k], 1);
		}
		assert_true(hash_of(worlds[0]) == hash_of(worlds[1]));
		for (int k = 0; k < 2; ++k)
			scree_world_destroy(worlds[k]);
		assert_true(left < 100);
	}
	OK(scree_hooks_set(NULL));
}

// A step that is refused because of too many contacts changes nothing. The forces of fields do not act twice in the
// step after it.
static void refused_steps_push_nothing(void** state)
{
	(void)state;
	scree_world* worlds[2];
	for (int k = 0; k < 2; ++k)
	{
		scree_world_def world_def = scree_world_def_default();
		world_def.device = "cpu";
		world_def.contact_limit = 3;
		worlds[k] = create_world(&world_def);
		scree_field_def def = scree_field_def_default(SCREE_FIELD_UNIFORM);
		def.acceleration.x = 6.0f;
		add_field(worlds[k], &def);
		add_dense(worlds[k], box_shape(0.5f, 0.5f), 1.0f, 0.0f, 0.0f);
		run_steps(worlds[k], 2);
		scree_body crowd[5];
		for (int i = 0; i < 5; ++i)
			crowd[i] = add_dense(worlds[k], box_shape(0.5f, 0.5f), 1.0f, 9.0f, 9.0f);
		for (int i = 0; i < 3 && k == 0; ++i)
			assert_int_equal(scree_world_step(worlds[k], STEP, SUBSTEPS), SCREE_ERROR_CONTACT_LIMIT);
		OK(scree_bodies_destroy(worlds[k], crowd, 5));
		run_steps(worlds[k], 2);
	}
	assert_true(hash_of(worlds[0]) == hash_of(worlds[1]));
	for (int k = 0; k < 2; ++k)
		scree_world_destroy(worlds[k]);
}

// ---------------------------------------------------------------------------------------------------------------
// all devices
// ---------------------------------------------------------------------------------------------------------------

#define FIELDS 200

// Returns a random definition of a field of any type, on a body or in the world. extreme: true allows numbers of up to
// 1e12.
static scree_field_def any_def(scree_world* world, uint64_t* seed, bool extreme)
{
	scree_field_def def = scree_field_def_default((scree_field_type)random_below(seed, 6));
	scree_body bodies[64];
	int count;
	OK(scree_world_get_bodies(world, bodies, 64, &count));
	if (random_below(seed, 3) == 0 && count > 0)
		def.body = bodies[random_below(seed, count < 64 ? count : 64)];
	int shape = random_below(seed, def.type == SCREE_FIELD_BUOYANCY ? 2 : 4);
	if (shape == 1)
		def.shape = box_shape(random_between(seed, 0.2f, 6.0f), random_between(seed, 0.2f, 4.0f));
	if (shape == 2)
		def.shape = circle_shape(random_between(seed, 0.2f, 6.0f));
	if (shape == 3)
		def.shape = capsule_shape(random_between(seed, 0.2f, 6.0f), 1.0f);
	float most = extreme && random_below(seed, 3) == 0 ? (random_below(seed, 2) ? 1e12f : 1e6f) : 2.0f;
	def.pose.position = (scree_vec){random_between(seed, -6.0f, 6.0f), random_between(seed, -2.0f, 8.0f)};
	def.pose.rotation = scree_rot_make(random_between(seed, -3.0f, 3.0f));
	def.falloff = (scree_field_falloff)random_below(seed, 4);
	def.strength = random_between(seed, -most, most);
	def.softening = random_below(seed, 2) ? 0.0f : 0.3f;
	def.acceleration = (scree_vec){random_between(seed, -most, most), random_between(seed, -most, most)};
	def.force = (scree_vec){random_between(seed, -most, most), random_between(seed, -most, most)};
	def.velocity = (scree_vec){random_between(seed, -9.0f, 9.0f), random_between(seed, -9.0f, 9.0f)};
	def.density = random_between(seed, 0.0f, most);
	def.lift = random_between(seed, 0.0f, most);
	def.linear_drag = random_between(seed, 0.0f, most);
	def.quadratic_drag = random_between(seed, 0.0f, most);
	def.spin_drag = random_between(seed, 0.0f, most);
	return def;
}

static void build_crowd(scree_world* world, const void* context)
{
	const bool* extreme = context;
	uint64_t seed = 5;
	add_floor(world);
	const scree_vec corners[] = {{-0.3f, -0.2f}, {0.3f, -0.2f}, {0.2f, 0.3f}};
	scree_shape rounded = polygon_shape(corners, 3, 0.05f);
	const scree_shape shapes[] = {box_shape(0.3f, 0.2f), circle_shape(0.25f), capsule_shape(0.3f, 0.15f), rounded};
	for (int k = 0; k < 120; ++k)
		add_dense(world, shapes[k % 4],
		          k % 7 == 0   ? 100.0f
		          : k % 5 == 0 ? 0.01f
		                       : 1.0f,
		          (float)(k % 12) - 6.0f, 0.5f + (float)(k / 12));
	add_crate(world, SCREE_BODY_KINEMATIC, 0.0f, 12.0f);
	for (int k = 0; k < (*extreme ? FIELDS : 12); ++k)
	{
		scree_field_def def = any_def(world, &seed, *extreme);
		add_field(world, &def);
	}
}

// Destroys, creates and changes fields in each step. In some steps also destroys, disables or enables a body, which may
// carry a field. Fails if a state is not finite.
static void change_crowd(scree_world* world, int step, const void* context)
{
	const bool* extreme = context;
	uint64_t seed = (uint64_t)step + 77;
	scree_field fields[FIELDS + 100];
	int count;
	OK(scree_world_get_fields(world, fields, FIELDS + 100, &count));
	if (count > 3)
	{
		scree_field_def def = any_def(world, &seed, *extreme);
		OK(scree_field_destroy(world, fields[random_below(&seed, count)]));
		OK(scree_field_create(world, &def, NULL));
		OK(scree_world_get_fields(world, fields, FIELDS + 100, &count));
		def = any_def(world, &seed, *extreme);
		OK(scree_field_set_def(world, fields[random_below(&seed, count)], &def));
		OK(scree_field_set_enabled(world, fields[random_below(&seed, count)], step % 2));
		OK(scree_field_set_pose(world, fields[random_below(&seed, count)], upright_at(0.1f * (float)step, 1.0f)));
	}
	scree_body bodies[64];
	OK(scree_world_get_bodies(world, bodies, 64, &count));
	if (step % 16 == 7)
		OK(scree_body_destroy(world, bodies[1 + random_below(&seed, 30)]));
	if (step % 16 == 3)
		OK(scree_body_set_enabled(world, bodies[1 + random_below(&seed, 30)], step % 32 == 3));
	check_finite(world);
}

static void all_devices_agree(void** state)
{
	(void)state;
	for (int extreme = 0; extreme < 2; ++extreme)
	{
		bool hard = extreme != 0;
		Scenario scenario = scenario_of(hard ? "200 fields, some of 1e12" : "12 fields", quick() ? 20 : 80, build_crowd,
		                                change_crowd, &hard);
		scree_counters last;
		check_parity(&scenario, &last);
		assert_int_equal(last.frozen_bodies, 0);
	}
}

// Builds a heap, which comes to rest. A field on a kinematic body passes over the heap and presses it down, although no
// contact begins or ends and the user changes nothing.
static void build_passing(scree_world* world, const void* context)
{
	(void)context;
	add_floor(world);
	scree_attribute attribute = shape_attribute(world, box_shape(0.25f, 0.25f));
	for (int k = 0; k < 120; ++k)
		add_body(world, SCREE_BODY_DYNAMIC, attribute, 0.6f * (float)(k % 30), 0.25f + 0.5f * (float)(k / 30), 0.0f);
	scree_field_def def = scree_field_def_default(SCREE_FIELD_UNIFORM);
	def.body = add_crate(world, SCREE_BODY_KINEMATIC, -4.0f, 30.0f);
	def.pose.position.y = -30.0f;
	def.shape = box_shape(1.0f, 4.0f);
	def.acceleration = (scree_vec){0.5f, -1.0f};
	add_field(world, &def);
	throw_body(world, def.body, 12.0f, 0.0f, 0.0f);
}

static void forms_see_what_comes(void** state)
{
	(void)state;
	Scenario scenario = scenario_of("a field that passes over a heap", quick() ? 40 : 120, build_passing, NULL, NULL);
	check_parity(&scenario, NULL);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(bodies_float_and_sink),
	    cmocka_unit_test(light_bodies_stay),
	    cmocka_unit_test(boats_right_themselves),
	    cmocka_unit_test(fields_move_with_bodies),
	    cmocka_unit_test(who_is_pushed),
	    cmocka_unit_test(drag_leaves_weights_alone),
	    cmocka_unit_test(wrong_arguments_are_refused),
	    cmocka_unit_test(memory_runs_out),
	    cmocka_unit_test(refused_steps_push_nothing),
	    cmocka_unit_test(forms_see_what_comes),
	    cmocka_unit_test(all_devices_agree),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
