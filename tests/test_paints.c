// SPDX-License-Identifier: MIT
// test_paints.c -- checks colors of bodies and their legends: forces of contacts, starting places, ramps, and boxes
// around most bodies.
#include "support/make_bodies.h"
#include "view/bounds.h"
#include "view/contact_loads.h"
#include "view/legend.h"
#include "view/ramp.h"
#include "view/start_places.h"
#include <float.h>
#include <math.h>
#include <string.h>

static scree_body add_crate_at(scree_world* world, float y)
{
	scree_body_def def = scree_body_def_default();
	def.attribute = shape_attribute(world, box_shape(0.5f, 0.5f));
	def.pose.position.y = y;
	return create_body(world, &def);
}

// Three crates of m kg stand on each other. The floor carries 3 m g. The force of a crate is the sum of the forces
// above and below it.
static void forces_are_those_of_a_column(void** state)
{
	(void)state;
	scree_world* world = open_world(-10.0f);
	scree_body crates[3];
	scree_contact contacts[16];
	float forces[16] = {0};
	int count;
	add_floor(world);
	for (int k = 0; k < 3; ++k)
		crates[k] = add_crate_at(world, 0.5f + (float)k);
	run_steps(world, 120);
	OK(scree_world_get_contacts(world, contacts, 16, &count));
	assert_int_equal(count, 3);
	scree_mass mass = mass_of(world, crates[0]);
	loads_sum(contacts, count, STEP / 4.0f, forces, 16);
	float weight = 10.0f * mass.mass;
	const float expected[] = {5.0f, 3.0f, 1.0f};
	for (int k = 0; k < 3; ++k)
		NEAR(forces[crates[k].index], expected[k] * weight, 0.02f * weight);
	scree_world_destroy(world);
}

static void ranges_are_round_and_stay(void** state)
{
	(void)state;
	float forces[1000];
	for (int k = 0; k < 1000; ++k)
		forces[k] = 0.1f * (float)k; // the largest force is 99.9 N
	// the bin that contains the quantile of 99.5 % ends at 104 N, so the range is 200 N
	assert_true(loads_range(forces, 1000, 0.0f) == 200.0f);
	assert_true(loads_range(forces, 500, 0.0f) == 100.0f || loads_range(forces, 500, 0.0f) == 50.0f);
	forces[999] = 1.0e9f; // far above most of the forces, so it does not change the range
	forces[998] = NAN;
	forces[997] = -5.0f;
	assert_true(loads_range(forces, 1000, 0.0f) == 200.0f);
	assert_true(loads_range(forces, 1000, 300.0f) == 300.0f);
	assert_true(loads_range(forces, 1000, 1000.0f) == 200.0f);
	assert_true(loads_range(forces, 1000, 10.0f) == 200.0f);
	const float none[4] = {0};
	assert_true(loads_range(none, 4, 0.0f) == 1.0f);
	assert_true(loads_range(none, 4, 50.0f) == 50.0f);
	const float extreme[2] = {FLT_MIN, FLT_MAX};
	assert_true(isfinite(loads_range(extreme, 2, 0.0f)));
}

static void starts_are_remembered(void** state)
{
	(void)state;
	Starts starts = {0};
	const scree_body bodies[] = {{1, 1}, {2, 1}, {5, 3}};
	scree_pose poses[] = {{{0, 0}, {1, 0}}, {{10, 4}, {1, 0}}, {{5, 1}, {1, 0}}};
	scree_vec points[] = {{0, 0}, {10, 4}, {5, 1}};
	assert_true(starts_frame(&starts, points, 3));
	assert_true(starts_add(&starts, bodies, poses, 3));
	poses[2].position = (scree_vec){9, 9};
	assert_true(starts_add(&starts, bodies, poses, 3)); // bodies that were added before keep their starting places
	scree_vec share = starts_share(&starts, bodies[2]);
	assert_true(share.x == 0.5f && share.y == 0.25f);
	// a new body has the index of an earlier body and no starting place; then it gets one outside of the box
	const scree_body other = {5, 4};
	assert_true(starts_misses(&starts, other));
	share = starts_share(&starts, other);
	assert_true(share.x == 0.5f && share.y == 0.5f);
	assert_true(starts_add(&starts, &other, &(scree_pose){{-7, 40}, {1, 0}}, 1));
	assert_false(starts_misses(&starts, other));
	share = starts_share(&starts, other);
	assert_true(share.x == 0.0f && share.y == 1.0f);
	starts_close(&starts);
	// all bodies start at one place
	const scree_vec same[] = {{2, 3}, {2, 3}};
	assert_true(starts_frame(&starts, same, 2));
	assert_true(starts_add(&starts, bodies, (scree_pose[]){{{2, 3}, {1, 0}}}, 1));
	share = starts_share(&starts, bodies[0]);
	assert_true(share.x == 0.5f && share.y == 0.5f);
	starts_close(&starts);
}

static void boxes_leave_out_what_is_far_away(void** state)
{
	(void)state;
	scree_vec points[100];
	scree_box box;
	for (int k = 0; k < 100; ++k)
		points[k] = (scree_vec){(float)(k % 10), (float)(k / 10)};
	assert_true(bounds_find(points, 100, 0.5f, &box));
	assert_true(box.lower.x == -0.5f && box.upper.x == 9.5f && box.lower.y == -0.5f && box.upper.y == 9.5f);
	points[7] = (scree_vec){4.0f, -8000.0f};
	points[8] = (scree_vec){5000.0f, 3.0f};
	points[9] = (scree_vec){NAN, 0.0f};
	assert_true(bounds_find(points, 100, 0.5f, &box));
	assert_true(box.upper.x == 9.5f && box.lower.y == -0.5f);
	points[8] = (scree_vec){15.0f, 3.0f}; // the box includes this point, which is only a little away from the others
	assert_true(bounds_find(points, 100, 0.5f, &box));
	assert_true(box.upper.x == 15.5f);
	// boxes around a column of points, around two points and around one point; there is no box around no point
	for (int k = 0; k < 20; ++k)
		points[k] = (scree_vec){3.0f, (float)k};
	assert_true(bounds_find(points, 20, 1.0f, &box));
	assert_true(box.lower.x == 2.0f && box.upper.x == 4.0f && box.upper.y == 20.0f);
	assert_true(bounds_find(points, 2, 1.0f, &box) && box.upper.y == 2.0f);
	assert_true(bounds_find(points, 1, 1.0f, &box) && box.lower.y == -1.0f);
	assert_false(bounds_find(points, 0, 1.0f, &box));
	box = bounds_limit((scree_box){{-100, 2}, {4, 900}}, (scree_box){{0, 0}, {10, 10}}, 3.0f);
	assert_true(box.lower.x == -30.0f && box.lower.y == 2.0f && box.upper.x == 4.0f && box.upper.y == 40.0f);
}

// Checks that every paint except PAINT_KIND has a legend, with ticks in rising order.
static void legends_have_numbers(void** state)
{
	(void)state;
	scree_contact contacts[3] = {{.color = 0}, {.color = 4}, {.color = 63}};
	Renderer renderer = {.contacts = contacts, .contact_count = 3};
	renderer.tables.force_range = 2.0e4f;
	for (int k = 0; k < PAINTS; ++k)
	{
		Style style = {.paint = (Paint)k};
		Legend legend;
		assert_int_equal(legend_of_paint(&legend, &renderer, &style), k != PAINT_KIND);
		for (int n = 0; n + 1 < legend.tick_count; ++n)
			assert_true(legend.ticks[n].at >= 0.0f && legend.ticks[n].at < legend.ticks[n + 1].at);
		if (k == PAINT_FORCE)
		{
			assert_string_equal(legend.title, "contact force, N");
			assert_string_equal(legend.ticks[1].text, "5000"); // middle of a square-root scale: a quarter of 20 kN
			assert_string_equal(legend.ticks[2].text, "20 k");
		}
		if (k == PAINT_SOLVER)
			assert_string_equal(legend.ticks[2].text, "hub");
		if (k == PAINT_SPEED)
			assert_true(legend.ticks[2].at == 0.5f && strcmp(legend.ticks[2].text, "3") == 0);
	}
	Legend legend;
	assert_false(legend_of_joints(&legend, &renderer, &(Style){.layers[LAYER_joints] = true}));
	renderer.joint_lines.links.count = 1;
	renderer.joint_lines.largest = 8.0f;
	assert_true(legend_of_joints(&legend, &renderer, &(Style){.layers[LAYER_joints] = true}));
	assert_string_equal(legend.ticks[2].text, "8");
}

// Checks that the ramp of forces gets lighter from its first to its last color.
static void the_ramp_of_force_rises(void** state)
{
	(void)state;
	Color colors[RAMP_COLORS];
	assert_true(ramp_of(PAINT_FORCE, colors));
	for (int k = 0; k + 1 < RAMP_COLORS; ++k)
	{
		int before = 3 * colors[k].r + 6 * colors[k].g + colors[k].b,
		    after = 3 * colors[k + 1].r + 6 * colors[k + 1].g + colors[k + 1].b;
		assert_true(after > before);
	}
	assert_false(ramp_of(PAINT_KIND, colors));
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(forces_are_those_of_a_column), cmocka_unit_test(ranges_are_round_and_stay),
	    cmocka_unit_test(starts_are_remembered),        cmocka_unit_test(boxes_leave_out_what_is_far_away),
	    cmocka_unit_test(legends_have_numbers),         cmocka_unit_test(the_ramp_of_force_rises),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
