// SPDX-License-Identifier: MIT
// test_batch_fields.c -- checks worlds of a batch with fields: in the world, on bodies, in regions, others in each template.
//
// Formula: hash(world in a batch, age) = hash(same world alone, age), for each template, device, number of threads and lanes,
// after resets, pauses, and states that are loaded or taken out. A change of a field in a world alone changes its hash, so
// equal hashes and equal fields mean equal forces.
#include "support/batch_run.h"
#include "support/make_fields.h"

#define LEVELS 6

// ---------------------------------------------------------------------------------------------------------------
// levels
// ---------------------------------------------------------------------------------------------------------------

static scree_field_def field_at(scree_field_type type, scree_body body, float x, float y)
{
	scree_field_def def = scree_field_def_default(type);
	def.body = body;
	def.pose = upright_at(x, y);
	return def;
}

// Balls around two trucks. Each truck carries fields, which do not act on itself, but on the other one.
static void build_trucks(scree_world* world)
{
	scree_body trucks[2];
	for (int k = 0; k < 2; ++k)
	{
		trucks[k] = add_dense(world, box_shape(0.8f, 0.3f), 1.0f, 4.0f * (float)k, 2.0f * (float)k);
		throw_body(world, trucks[k], k ? -2.0f : 2.0f, 0.0f, k ? 1.0f : -0.5f);
		scree_field_def pull = field_at(SCREE_FIELD_RADIAL, trucks[k], 0.2f, 0.4f);
		pull.strength = 6.0f;
		add_field(world, &pull);
		scree_field_def fan = field_at(SCREE_FIELD_WIND, trucks[k], 2.0f, 0.0f);
		fan.shape = box_shape(2.0f, 1.0f);
		fan.velocity = (scree_vec){8.0f, 1.0f};
		fan.density = 1.0f;
		fan.lift = 0.5f;
		add_field(world, &fan);
	}
	for (int k = 0; k < 7; ++k)
		add_dense(world, k % 2 ? circle_shape(0.2f) : box_shape(0.2f, 0.3f), 0.5f, -2.0f + 1.3f * (float)k, 1.0f);
	scree_field_def drag = field_at(SCREE_FIELD_DRAG, SCREE_NULL_BODY, 0.0f, 0.0f);
	drag.linear_drag = 0.1f;
	drag.spin_drag = 0.02f;
	drag.mask = 1;
	add_field(world, &drag);
}

// A pond, in a region and with gravity, under wind everywhere; a boat of two parts, a disabled field, and one on a disabled body.
static void build_pond(scree_world* world)
{
	scree_field_def water = field_at(SCREE_FIELD_BUOYANCY, SCREE_NULL_BODY, 0.0f, -2.0f);
	water.shape = box_shape(8.0f, 2.0f);
	water.density = 2.0f;
	water.linear_drag = 0.5f;
	add_field(world, &water);
	scree_field_def air = field_at(SCREE_FIELD_WIND, SCREE_NULL_BODY, 0.0f, 0.0f);
	air.velocity.x = 5.0f;
	air.density = 0.3f;
	add_field(world, &air);
	scree_field_def off = field_at(SCREE_FIELD_UNIFORM, SCREE_NULL_BODY, 0.0f, 0.0f);
	off.acceleration.y = 50.0f;
	off.disabled = true;
	add_field(world, &off);
	scree_body gone = add_crate(world, SCREE_BODY_DYNAMIC, 2.0f, 20.0f);
	scree_field_def carried = field_at(SCREE_FIELD_VORTEX, gone, 0.0f, 0.0f);
	carried.strength = 30.0f;
	add_field(world, &carried);
	OK(scree_body_set_enabled(world, gone, false));
	add_box(world, SCREE_BODY_STATIC, 8.0f, 0.5f, 0.0f, -4.5f);
	scree_body boat = add_dense(world, box_shape(1.0f, 0.3f), 0.4f, -3.0f, 0.6f);
	scree_collidable_def keel = scree_collidable_def_default();
	keel.attribute = shape_attribute(world, box_shape(0.4f, 0.1f));
	keel.body = boat;
	keel.pose.position.y = -0.4f;
	OK(scree_collidable_create(world, &keel, NULL));
	add_dense(world, capsule_shape(0.6f, 0.2f), 0.7f, 0.0f, 1.0f);
	add_dense(world, circle_shape(0.4f), 3.0f, 1.0f, 2.0f);
	add_dense(world, box_shape(0.4f, 0.4f), 0.2f, 7.7f, -1.0f); // in the corner of the region
}

// More fields than FIELD_FEW, in small regions, some on a kinematic body.
static void build_many(scree_world* world)
{
	scree_body ship = add_box(world, SCREE_BODY_KINEMATIC, 0.5f, 0.1f, 0.0f, 3.0f);
	throw_body(world, ship, 3.0f, -0.5f, 0.4f);
	for (int k = 0; k < 75; ++k)
	{
		scree_field_def def = field_at(k % 3 ? SCREE_FIELD_UNIFORM : SCREE_FIELD_VORTEX,
		                               k % 5 == 0 ? ship : SCREE_NULL_BODY, 0.3f * (float)(k % 25), (float)(k / 25));
		def.shape = k % 2 ? circle_shape(0.4f) : box_shape(0.3f, 0.5f);
		def.acceleration = (scree_vec){0.4f * (float)(k % 7) - 1.0f, 3.0f};
		def.force.x = 0.1f;
		def.strength = 4.0f;
		add_field(world, &def);
	}
	for (int k = 0; k < 9; ++k)
		add_dense(world, circle_shape(0.15f), 1.0f, 0.8f * (float)k, 0.2f + 0.25f * (float)(k % 4));
}

// No fields.
static void build_plain(scree_world* world)
{
	add_floor(world);
	for (int k = 0; k < 5; ++k)
		add_crate(world, SCREE_BODY_DYNAMIC, 0.3f * (float)(k % 3), 1.0f + 1.3f * (float)k);
}

// One field, of a kind that acts on bodies only, on the last of the bodies.
static void build_star(scree_world* world)
{
	for (int k = 0; k < 5; ++k)
		add_dense(world, circle_shape(0.2f), 1.0f, (float)k, 0.5f * (float)(k * k));
	scree_body star = add_dense(world, circle_shape(0.3f), 9.0f, 2.0f, 4.0f);
	scree_field_def pull = field_at(SCREE_FIELD_RADIAL, star, 0.0f, 0.0f);
	pull.strength = 10.0f;
	pull.falloff = SCREE_FALLOFF_INVERSE;
	add_field(world, &pull);
}

static void (*const build[LEVELS])(scree_world*) = {build_trucks, build_pond, build_many,
                                                    build_plain,  build_star, build_pond};
static const float gravity[LEVELS] = {0.0f, -10.0f, 0.0f, -10.0f, -1.0f, -9.0f};

static scree_world* open_level(int k)
{
	scree_world_def def = scree_world_def_default();
	def.device = "cpu";
	def.threads = 1;
	def.gravity.y = gravity[k];
	def.sleep = false;
	def.length_unit = k == LEVELS - 1 ? 0.5f : 0.0f;
	scree_world* world = create_world(&def);
	build[k](world);
	return world;
}

// Opens templates of some levels, a number of steps after they were built.
static Templates open_levels(const int* levels, int count, int steps)
{
	Templates t = {.count = count, .dt = STEP, .substeps = SUBSTEPS};
	for (int k = 0; k < count; ++k)
	{
		t.worlds[k] = open_level(levels[k]);
		for (int step = 0; step < steps * k; ++step)
			OK(scree_world_step(t.worlds[k], t.dt, t.substeps));
	}
	return t;
}

static const int all_levels[LEVELS] = {0, 1, 2, 3, 4, 5};

// ---------------------------------------------------------------------------------------------------------------
// equal bits
// ---------------------------------------------------------------------------------------------------------------

static void worlds_are_equal(void** state)
{
	(void)state;
	const Place places[] = {{"cpu", MOST_WORLDS, 1, 1},  {"cpu", 25, 2, 4}, {"cpu", 30, 1, 8},
	                        {"cpu", MOST_WORLDS, 1, 16}, {"cpu", 7, 1, 0},  {second_device, 17, 0, 0}};
	for (size_t k = 0; k < sizeof places / sizeof *places; ++k)
	{
		if (!places[k].device[0])
			continue;
		for (int steps = 0; steps <= 7; steps += 7) // templates before their first step; in motion
		{
			// the last levels alone too: fewer fields, whose bays have fewer spots; and no fields that act on shapes
			for (int first = 0; first <= 4; first += k == 1 ? 1 : 4)
			{
				Templates t = open_levels(all_levels + first, LEVELS - first - (first == 4), steps);
				BatchRun r = {.t = &t, .worlds = places[k].worlds};
				random_state = (uint32_t)(k + 1);
				r.batch = open_batch(&t, places + k, r.template_of);
				record_alone(&t);
				run_at_random(&r, quick() || k == 5 ? 15 : 60, "fields");
				close_templates(&t);
			}
		}
	}
	assert_int_equal(scree_memory(), 0);
}

// Fields of one world never act in another one: a star of a world beside a world of the same bodies without the field.
static void worlds_stay_apart(void** state)
{
	(void)state;
	Templates t = {.count = 2, .dt = STEP, .substeps = SUBSTEPS};
	int template_of[2];
	scree_field fields[1];
	int count;
	for (int k = 0; k < 2; ++k)
		t.worlds[k] = open_level(4);
	OK(scree_world_get_fields(t.worlds[1], fields, 1, &count));
	OK(scree_field_set_enabled(t.worlds[1], fields[0], false));
	scree_batch_def def = scree_batch_def_default();
	scree_batch* batch;
	def.worlds = 2;
	def.templates = t.worlds;
	def.template_count = 2;
	OK(scree_batch_create(&def, &batch));
	OK(scree_batch_step(batch, STEP, SUBSTEPS, 30));
	record_alone(&t);
	template_of[0] = 0;
	template_of[1] = 1;
	check_hashes(batch, &t, template_of, (const int[]){30, 30}, "apart");
	scree_world* taken[2];
	float x[2];
	for (int k = 0; k < 2; ++k)
	{
		OK(scree_batch_extract(batch, k, NULL, taken + k));
		scree_body bodies[8];
		OK(scree_world_get_bodies(taken[k], bodies, 8, &count));
		x[k] = position_of(taken[k], bodies[0]).x;
		scree_world_destroy(taken[k]);
	}
	assert_true(x[0] > 0.1f); // pulled by the star
	NEAR(x[1], 0.0, 1e-9);
	scree_batch_destroy(batch);
	close_templates(&t);
	assert_int_equal(scree_memory(), 0);
}

// Buoyancy uses the gravity of its world.
static void gravity_may_differ(void** state)
{
	(void)state;
	scree_world* world = open_level(1);
	scree_batch_def many = scree_batch_def_default();
	scree_batch* batch;
	scree_world* alone[3];
	scree_vec pulls[3] = {{0.0f, -10.0f}, {3.0f, -20.0f}, {0.0f, 0.0f}};
	uint64_t hashes[3];
	many.worlds = 3;
	many.templates = &world;
	many.template_count = 1;
	OK(scree_batch_create(&many, &batch));
	OK(scree_batch_set_gravity(batch, pulls));
	for (int k = 0; k < 3; ++k)
	{
		alone[k] = clone_of(world);
		OK(scree_world_set_gravity(alone[k], pulls[k]));
	}
	for (int step = 0; step < 50; ++step)
	{
		OK(scree_batch_step(batch, STEP, SUBSTEPS, 1));
		OK(scree_batch_get_hashes(batch, hashes));
		for (int k = 0; k < 3; ++k)
		{
			OK(scree_world_step(alone[k], STEP, SUBSTEPS));
			assert_true(hashes[k] == hash_of(alone[k]));
		}
	}
	for (int k = 0; k < 3; ++k)
		scree_world_destroy(alone[k]);
	scree_batch_destroy(batch);
	scree_world_destroy(world);
	assert_int_equal(scree_memory(), 0);
}

// The scene with fields fits into a batch; test_batch compares its worlds.
static void scenes_with_fields_fit(void** state)
{
	(void)state;
	Scenario scenario = small_scene("pond");
	Templates t = {.count = 1, .worlds = {scene_world(&scenario, 3)}};
	const Place place = {"cpu", 1, 1, 0};
	int template_of;
	scree_batch_destroy(open_batch(&t, &place, &template_of));
	close_templates(&t);
	scene_free((Scene*)scenario.context);
	player_close(small_players);
	player_close(small_players + 1);
	assert_int_equal(scree_memory(), 0);
}

// A world with another field is no state of the template.
static void other_fields_are_refused(void** state)
{
	(void)state;
	scree_world *world = open_level(4), *other = open_level(4);
	scree_batch_def def = scree_batch_def_default();
	scree_batch* batch;
	scree_field field;
	int count;
	def.templates = &world;
	def.template_count = 1;
	OK(scree_batch_create(&def, &batch));
	OK(scree_batch_insert(batch, 0, other));
	OK(scree_world_get_fields(other, &field, 1, &count));
	OK(scree_field_set_enabled(other, field, false));
	REFUSED(scree_batch_insert(batch, 0, other), "scree_batch_insert: from has other settings, or other shapes, "
	                                             "densities, joints or rules, than the template of "
	                                             "world 0");
	scree_batch_destroy(batch);
	scree_world_destroy(world);
	scree_world_destroy(other);
	assert_int_equal(scree_memory(), 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(worlds_are_equal),         cmocka_unit_test(worlds_stay_apart),
	    cmocka_unit_test(gravity_may_differ),       cmocka_unit_test(scenes_with_fields_fit),
	    cmocka_unit_test(other_fields_are_refused),
	};
	return cmocka_run_group_tests(tests, find_second_device, NULL);
}
