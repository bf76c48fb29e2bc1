// SPDX-License-Identifier: MIT
// test_batch_gravity.c -- checks worlds of a batch whose gravity, lengths of substeps, paths and materials differ.
//
// Formula: after any sequence of steps, resets, pauses and changes of gravity, hash(world in a batch) = hash(the same world alone
// after the same sequence), where alone a reset builds the world again, and scree_world_set_gravity sets its gravity.
#include "support/batch_twins.h"
#include "support/make_joints.h"
#include "support/make_paths.h"

// ---------------------------------------------------------------------------------------------------------------
// levels
// ---------------------------------------------------------------------------------------------------------------

// Elastic and small bodies, a kinematic one, and a heavy plate on many balls, which is a hub.
static void build_toys(scree_world* world)
{
	scree_attribute ball = add_surface(world, circle_shape(0.2f), 0.5f, 0.9f);
	scree_attribute grain = add_surface(world, box_shape(0.004f, 0.004f), 0.5f, 0.0f);
	add_floor(world);
	for (int k = 0; k < 8; ++k)
		add_body(world, SCREE_BODY_DYNAMIC, ball, 0.5f * (float)k, 0.4f + 0.3f * (float)k, 0.0f);
	for (int k = 0; k < 8; ++k)
		add_body(world, SCREE_BODY_DYNAMIC, grain, -1.0f - 0.005f * (float)(k % 2), 0.0041f + 0.0081f * (float)k, 0.0f);
	for (int k = 0; k < 40; ++k)
		add_disc(world, 0.1f, 10.0f + 0.21f * (float)k, 0.1f);
	add_box(world, SCREE_BODY_DYNAMIC, 4.4f, 0.2f, 14.1f, 0.41f);
	throw_body(world, add_box(world, SCREE_BODY_KINEMATIC, 0.5f, 0.2f, -4.0f, 0.21f), 1.0f, 0.0f, 0.0f);
}

// Two bodies that follow a path. high: m, height of the path.
static void add_ride(scree_world* world, float high)
{
	scree_vec points[9];
	for (int k = 0; k < 9; ++k)
		points[k] = (scree_vec){(float)k, high + 0.3f * (float)(k % 3)};
	scree_path path = add_path(world, points, 9, false);
	ride(world, path, add_wagon(world, path, 2.0f, 0.3f, 1.0f), true);
	ride(world, path, add_crate(world, SCREE_BODY_DYNAMIC, 6.0f, high + 0.1f), false);
}

static void build_ride(scree_world* world)
{
	add_floor(world);
	add_ride(world, 3.0f);
}

static void build_rides(scree_world* world)
{
	add_ride(world, 5.0f);
	add_ride(world, -5.0f);
	add_crate(world, SCREE_BODY_STATIC, 6.0f, 4.0f);
}

// Crates of materials, of which pairs set friction, restitution and tangent speed, or ignore one another.
static void add_materials(scree_world* world, int first, bool ignored)
{
	scree_attribute attributes[3];
	for (int k = 0; k < 3; ++k)
	{
		scree_attribute_def def = surface_of(box_shape(0.5f, 0.5f));
		def.material = first + k;
		attributes[k] = add_attribute(world, &def);
	}
	for (int k = 0; k < 9; ++k)
		add_body(world, k < 3 ? SCREE_BODY_STATIC : SCREE_BODY_DYNAMIC, attributes[k < 3 ? 0 : k % 3],
		         1.0f * (float)(k % 3) + 0.1f * (float)(k / 3), 1.2f * (float)(k / 3), 0.0f);
	scree_material_pair pair = scree_material_pair_default();
	pair.restitution = 0.7f;
	pair.friction = 0.1f;
	OK(scree_world_set_material_pair(world, first, first + 1, &pair));
	pair.tangent_speed = 2.0f;
	pair.ignored = ignored;
	OK(scree_world_set_material_pair(world, first, first + 2, &pair));
}
static void build_materials(scree_world* world) { add_materials(world, 0, false); }
static void build_ghosts(scree_world* world) { add_materials(world, 40, true); }

// Worlds of many kinds, whose templates had substeps of other lengths, or no step.
static void gravity_may_differ(void** state)
{
	(void)state;
	static const Level levels[] = {
	    {.build = build_toys},
	    {.build = build_toys, .steps = 40, .dt = STEP, .substeps = 4},
	    {.scene = "bridge", .steps = 20, .dt = STEP, .substeps = 2},
	    {.scene = "chains", .steps = 10, .dt = STEP, .substeps = 4},
	    {.scene = "pyramids", .steps = 30, .dt = STEP, .substeps = 4},
	    {.scene = "ragdolls", .steps = 25, .dt = STEP / 2, .substeps = 4},
	    {.scene = "machine", .steps = 12, .dt = STEP, .substeps = 8},
	    {.scene = "windmill", .steps = 9, .dt = STEP, .substeps = 4},
	    {.scene = "washer", .steps = 30, .dt = STEP, .substeps = 4},
	    {.scene = "tumbler", .steps = 30, .dt = STEP, .substeps = 3},
	    {.scene = "coaster", .steps = 5, .dt = STEP, .substeps = 4},
	    {.scene = "gears"},
	};
	check_levels(levels, COUNT_OF(levels), COUNT_OF(levels) + 5, 60, 1, true);
}

// Tables of paths and pairs of materials of several templates, beside templates without.
static void tables_may_differ(void** state)
{
	(void)state;
	static const Level levels[] = {
	    {.build = build_ride, .steps = 3, .dt = STEP, .substeps = 4},
	    {.build = build_materials, .steps = 8, .dt = STEP, .substeps = 4},
	    {.build = build_toys, .steps = 8, .dt = STEP, .substeps = 4},
	    {.build = build_rides, .steps = 8, .dt = STEP, .substeps = 2},
	    {.build = build_ghosts},
	    {.scene = "platforms", .steps = 30, .dt = STEP, .substeps = 4},
	};
	check_levels(levels, COUNT_OF(levels), 2 * COUNT_OF(levels) + 1, 90, 1, true);
}

// Gravity is in the unit of length of each world's template.
static void units_may_differ(void** state)
{
	(void)state;
	static const Level levels[] = {
	    {.build = build_toys, .unit = 4.0f, .steps = 4, .dt = STEP, .substeps = 4},
	    {.build = build_toys},
	    {.build = build_toys, .unit = 3.0f, .steps = 2, .dt = STEP, .substeps = 4},
	};
	check_levels(levels, COUNT_OF(levels), 9, 40, 1, false);
}

static void bad_templates_are_refused(void** state)
{
	(void)state;
	static const Level levels[] = {{.build = build_toys}, {.build = build_ride, .steps = 2, .dt = STEP, .substeps = 4}};
	Twins t = {.levels = levels, .level_count = 2, .worlds = 3, .rare = 1};
	const int32_t next[3] = {1, 1, 0}, bad[3] = {1, 2, 0};
	open_twins(&t, "cpu", 1, 0);
	REFUSED(scree_batch_set_templates(t.batch, next),
	        "scree_batch_set_templates: the batch was created without scree_batch_def.other_templates");
	close_twins(&t);
	t.varied = true;
	open_twins(&t, "cpu", 1, 0);
	REFUSED(scree_batch_set_templates(t.batch, bad),
	        "scree_batch_set_templates: template_of[1] is 2, must be from 0 to 1");
	REFUSED(scree_batch_set_templates(t.batch, NULL), "scree_batch_set_templates: template_of is null");
	run_twins(&t, 20);
	close_twins(&t);
}

static void bad_gravity_is_refused(void** state)
{
	(void)state;
	static const Level levels[] = {{.build = build_ride, .steps = 2, .dt = STEP, .substeps = 4},
	                               {.build = build_toys, .unit = 4.0f, .steps = 2, .dt = STEP, .substeps = 4}};
	Twins t = {.levels = levels, .level_count = 2, .worlds = 4, .rare = 1};
	open_twins(&t, "cpu", 1, 0);
	scree_vec bad[4] = {{1.0f, 2.0f}, {0.0f, 0.0f}, {0.0f, NAN}, {0.0f, 0.0f}};
	assert_int_equal(scree_batch_set_gravity(t.batch, bad), SCREE_ERROR_INVALID);
	assert_string_equal(scree_error(), "scree_batch_set_gravity: gravity[2].y is nan, must be finite");
	assert_int_equal(scree_batch_set_gravity(NULL, bad), SCREE_ERROR_INVALID);
	assert_string_equal(scree_error(), "scree_batch_set_gravity: batch is null");
	run_twins(&t, 10); // nothing has changed
	close_twins(&t);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(gravity_may_differ),        cmocka_unit_test(tables_may_differ),
	    cmocka_unit_test(units_may_differ),          cmocka_unit_test(bad_gravity_is_refused),
	    cmocka_unit_test(bad_templates_are_refused),
	};
	return cmocka_run_group_tests(tests, find_second_device, NULL);
}
