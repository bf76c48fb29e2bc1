// SPDX-License-Identifier: MIT
// test_draw.c -- checks each kind of thing that scree_world_draw draws, its place and its color, on the CPU and on OpenCL.
#include "support/draw_log.h"
#include "support/make_fields.h"
#include "support/make_paths.h"
#include <math.h>
#include <string.h>

#define OPAQUE(color) ((color) | 0xffu)

static DrawLog drawing;

// Each shape is drawn once, with its vertices in the world: pose times local vertex.
static void shapes_are_at_their_poses(void** state)
{
	(void)state;
	scree_world* world = open_test_world(0.0f);
	add_body(world, SCREE_BODY_STATIC, box_attribute(world, 2.0f, 1.0f), 10.0f, 5.0f, (float)PI / 2);
	add_shape(world, SCREE_BODY_KINEMATIC, circle_shape(0.5f), -3.0f, 2.0f, 0.0f);
	add_shape(world, SCREE_BODY_DYNAMIC, capsule_shape(1.0f, 0.25f), 0.0f, 0.0f, 0.0f);
	add_shape(world, SCREE_BODY_STATIC, segment_shape(0, 0, 3, 4), 20.0f, 0.0f, 0.0f);
	scree_vec corners[3] = {{0, 0}, {1, 0}, {0, 1}};
	add_shape(world, SCREE_BODY_DYNAMIC, polygon_shape(corners, 3, 0.1f), -10.0f, 0.0f, 0.0f);
	draw_into(&drawing, world, SCREE_DRAW_SHAPES, NULL);
	// two polygons, a circle with its radius, a capsule, and a segment
	assert_int_equal(drawing.total, 6);

	const Drawn* box = drawn_at(&drawing, DRAWN_POLYGON, SCREE_COLOR_STATIC, 0);
	assert_true(box == drawing.entries && box->count == 4 && box->size == 0.0f);
	double low = 1e9, high = -1e9, wide = 0.0;
	for (int k = 0; k < 4; ++k)
	{
		low = fmin(low, box->points[k].y);
		high = fmax(high, box->points[k].y);
		wide = fmax(wide, fabs(box->points[k].x - 10.0));
	}
	NEAR(low, 3.0, 1e-5);
	NEAR(high, 7.0, 1e-5);
	NEAR(wide, 1.0, 1e-5);

	const Drawn* disc = drawn_at(&drawing, DRAWN_CIRCLE, SCREE_COLOR_KINEMATIC, 0);
	assert_true(disc->points[0].x == -3.0f && disc->points[0].y == 2.0f && disc->size == 0.5f);
	assert_true(has_line(&drawing, -3.0f, 2.0f, -2.5f, 2.0f, OPAQUE(SCREE_COLOR_KINEMATIC)));
	const Drawn* pill = drawn_at(&drawing, DRAWN_CAPSULE, SCREE_COLOR_DYNAMIC, 0);
	NEAR(fabs(pill->points[0].x - pill->points[1].x), 2.0, 1e-5);
	assert_true(pill->size == 0.25f);
	assert_true(has_line(&drawing, 20.0f, 0.0f, 23.0f, 4.0f, OPAQUE(SCREE_COLOR_STATIC)));
	const Drawn* rounded = drawn_at(&drawing, DRAWN_POLYGON, SCREE_COLOR_DYNAMIC, 0);
	assert_true(rounded->count == 3 && rounded->size == 0.1f);
	scree_world_destroy(world);
}

// The first color that applies: disabled, sensor, static, kinematic, asleep, dynamic. Changes of the user that are pending
// are drawn.
static void colors_show_states(void** state)
{
	(void)state;
	scree_world* world = open_test_world(-10.0f);
	add_floor(world);
	scree_body crate = add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 0.5f);
	scree_body_def eye = crate_def(world, SCREE_BODY_STATIC, 50.0f, 5.0f);
	eye.sensor = SCREE_SENSOR_MOVING;
	create_body(world, &eye);
	scree_collidable_def zone = scree_collidable_def_default();
	zone.attribute = box_attribute(world, 1.0f, 1.0f);
	zone.pose.position.x = -50.0f;
	create_collidable(world, &zone);
	run_steps(world, 60);
	draw_into(&drawing, world, SCREE_DRAW_SHAPES | SCREE_DRAW_SENSORS, NULL);
	assert_int_equal(count_drawn(&drawing, DRAWN_POLYGON, SCREE_COLOR_STATIC), 1);
	assert_int_equal(count_drawn(&drawing, DRAWN_POLYGON, SCREE_COLOR_ASLEEP), 1);
	assert_int_equal(count_drawn(&drawing, DRAWN_POLYGON, SCREE_COLOR_SENSOR), 2);
	draw_into(&drawing, world, SCREE_DRAW_SHAPES, NULL);
	assert_int_equal(drawing.total, 2);
	draw_into(&drawing, world, SCREE_DRAW_SENSORS, NULL);
	assert_int_equal(drawing.total, 2);

	OK(scree_body_set_awake(world, crate, true));
	OK(scree_body_set_pose(world, crate, upright_at(3.0f, 7.0f)));
	draw_into(&drawing, world, SCREE_DRAW_SHAPES, NULL);
	const Drawn* moved = drawn_at(&drawing, DRAWN_POLYGON, SCREE_COLOR_DYNAMIC, 0);
	NEAR((moved->points[0].x + moved->points[2].x) / 2, 3.0, 1e-5);
	OK(scree_body_set_enabled(world, crate, false));
	draw_into(&drawing, world, SCREE_DRAW_SHAPES, NULL);
	const Drawn* disabled = drawn_at(&drawing, DRAWN_POLYGON, SCREE_COLOR_DISABLED, 0);
	assert_memory_equal(disabled->points, moved->points, sizeof moved->points);
	OK(scree_body_destroy(world, crate));
	draw_into(&drawing, world, SCREE_DRAW_SHAPES, NULL);
	assert_int_equal(drawing.total, 1);
	scree_world_destroy(world);
}

// A crate at rest: the impulses of its two points in a substep are together m g H, and their lines have this length times
// the scale. A crate that slides to the right is braked to the left.
static void contacts_and_impulses(void** state)
{
	(void)state;
	scree_world* world = stay_awake(open_test_world(-10.0f));
	add_floor(world);
	scree_body crate = add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 0.5f);
	run_steps(world, 120);
	scree_draw_def def = log_def(&drawing, SCREE_DRAW_CONTACTS | SCREE_DRAW_IMPULSES | SCREE_DRAW_LABELS);
	def.impulse_scale = 100.0f;
	OK(scree_world_draw(world, &def, NULL));
	int points = count_drawn(&drawing, DRAWN_POINT, SCREE_COLOR_TOUCHING) +
	             count_drawn(&drawing, DRAWN_POINT, SCREE_COLOR_SPECULATIVE);
	assert_int_equal(points, 2);
	assert_int_equal(count_drawn(&drawing, DRAWN_LINE, SCREE_COLOR_IMPULSE), 2);
	assert_int_equal(count_drawn(&drawing, DRAWN_TEXT, SCREE_COLOR_IMPULSE), 2);
	double sum = 0.0;
	for (int k = 0; k < 2; ++k)
	{
		const Drawn* line = drawn_at(&drawing, DRAWN_LINE, SCREE_COLOR_IMPULSE, k);
		sum += hypot(line->points[1].x - line->points[0].x, line->points[1].y - line->points[0].y);
		NEAR(line->points[0].y, 0.0, 0.02);
	}
	NEAR(sum, 100.0 * G * H, 1e-2);
	const char* label = drawn_at(&drawing, DRAWN_TEXT, SCREE_COLOR_IMPULSE, 0)->text;
	assert_non_null(strstr(label, " N s"));
	assert_true(label[0] == '0' && label[1] == '.');

	throw_body(world, crate, 5.0f, 0.0f, 0.0f);
	run_steps(world, 5);
	scree_contact contact;
	int count;
	OK(scree_body_get_contacts(world, crate, &contact, 1, &count));
	float side = scree_body_equals(contact.body_b, crate) ? -1.0f : 1.0f; // the line shows the impulse on collidable b
	draw_into(&drawing, world, SCREE_DRAW_IMPULSES, NULL);
	const Drawn* friction = drawn_at(&drawing, DRAWN_LINE, SCREE_COLOR_FRICTION, 0);
	assert_true(side * (friction->points[1].x - friction->points[0].x) > 0.0f);
	scree_world_destroy(world);
}

static void bodies_and_boxes(void** state)
{
	(void)state;
	scree_world* world = open_test_world(0.0f);
	scree_body crate = add_crate(world, SCREE_BODY_DYNAMIC, 1.0f, 2.0f);
	throw_body(world, crate, 3.0f, -4.0f, 0.0f);
	draw_into(&drawing, world, SCREE_DRAW_CENTERS | SCREE_DRAW_SPEEDS | SCREE_DRAW_LABELS, NULL);
	const Drawn* center = drawn_at(&drawing, DRAWN_POINT, SCREE_COLOR_CENTER, 0);
	assert_true(center->points[0].x == 1.0f && center->points[0].y == 2.0f);
	assert_true(has_line(&drawing, 1.0f, 2.0f, 1.25f, 2.0f, SCREE_COLOR_CENTER));
	assert_true(has_line(&drawing, 1.0f, 2.0f, 1.3f, 1.6f, SCREE_COLOR_SPEED));
	assert_string_equal(drawn_at(&drawing, DRAWN_TEXT, SCREE_COLOR_CENTER, 0)->text, "1");
	assert_string_equal(drawn_at(&drawing, DRAWN_TEXT, SCREE_COLOR_SPEED, 0)->text, "5 m/s");

	// the box of broad phase exists after a step, and encloses the crate with a margin
	draw_into(&drawing, world, SCREE_DRAW_BOXES, NULL);
	assert_int_equal(drawing.total, 0);
	update_contacts(world);
	draw_into(&drawing, world, SCREE_DRAW_BOXES, NULL);
	assert_int_equal(count_drawn(&drawing, DRAWN_LINE, SCREE_COLOR_BOX), 4);
	const Drawn* side = drawn_at(&drawing, DRAWN_LINE, SCREE_COLOR_BOX, 0);
	assert_true(side->points[0].x <= 0.5f && side->points[0].x > 0.0f && side->points[1].x >= 1.5f);
	OK(scree_body_set_enabled(world, crate, false));
	draw_into(&drawing, world, SCREE_DRAW_BOXES | SCREE_DRAW_SPEEDS, NULL);
	assert_int_equal(drawing.total, 0);
	scree_world_destroy(world);
}

static void joints_and_paths(void** state)
{
	(void)state;
	scree_world* world = open_test_world(0.0f);
	scree_body a = add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 0.0f),
	           b = add_crate(world, SCREE_BODY_DYNAMIC, 4.0f, 0.0f);
	scree_joint_def hinge = joint_def_at(world, SCREE_JOINT_REVOLUTE, a, b, 2.0f, 1.0f, 0.0f);
	hinge.coordinates[SCREE_ANGLE].limited = true;
	hinge.coordinates[SCREE_ANGLE].upper = (float)PI / 2;
	scree_joint joint = add_joint(world, &hinge);
	uint32_t flags = SCREE_DRAW_JOINTS | SCREE_DRAW_LABELS;
	draw_into(&drawing, world, flags, NULL);
	assert_true(has_line(&drawing, 0.0f, 0.0f, 2.0f, 1.0f, SCREE_COLOR_JOINT));
	assert_true(has_line(&drawing, 4.0f, 0.0f, 2.0f, 1.0f, SCREE_COLOR_JOINT));
	assert_true(has_line(&drawing, 2.0f, 1.0f, 2.0f, 1.25f, SCREE_COLOR_JOINT)); // the upper limit of the angle
	assert_string_equal(drawn_at(&drawing, DRAWN_TEXT, SCREE_COLOR_JOINT, 0)->text, "revolute");
	OK(scree_joint_set_enabled(world, joint, false));
	draw_into(&drawing, world, flags, NULL);
	assert_true(has_line(&drawing, 0.0f, 0.0f, 2.0f, 1.0f, OPAQUE(SCREE_COLOR_DISABLED)));
	OK(scree_joint_set_enabled(world, joint, true));
	OK(scree_joint_set_thresholds(world, joint, 1.0f, 1.0f, true));
	throw_body(world, b, 100.0f, 100.0f, 0.0f);
	run_steps(world, 1);
	assert_true(joint_state_of(world, joint).broken);
	draw_into(&drawing, world, flags, NULL);
	assert_true(count_drawn(&drawing, DRAWN_LINE, SCREE_COLOR_BROKEN) > 0);
	assert_int_equal(count_drawn(&drawing, DRAWN_LINE, SCREE_COLOR_JOINT), 0);
	OK(scree_joint_destroy(world, joint));

	scree_joint_def slider = joint_def_at(world, SCREE_JOINT_PRISMATIC, NOBODY, a, 0.0f, 0.0f, 0.0f);
	slider.coordinates[SCREE_ALONG] = (scree_joint_coordinate){.limited = true, .lower = -3.0f, .upper = 2.0f};
	slider.frame_a = upright_at(7.0f, 8.0f);
	add_joint(world, &slider);
	scree_joint_def pulley = joint_def_at(world, SCREE_JOINT_PULLEY, a, b, 0.0f, 0.0f, 0.0f);
	pulley.frame_a = pulley.frame_b = upright_at(0.0f, 0.0f);
	pulley.sides[0].base.position = (scree_vec){0.0f, 9.0f};
	pulley.sides[1].base.position = (scree_vec){4.0f, 9.0f};
	couple(world, &pulley);
	draw_into(&drawing, world, SCREE_DRAW_JOINTS, NULL);
	assert_true(has_line(&drawing, 4.0f, 8.0f, 9.0f, 8.0f, SCREE_COLOR_JOINT));
	assert_true(has_line(&drawing, 0.0f, 9.0f, 4.0f, 9.0f, SCREE_COLOR_JOINT));

	// two beads on a path draw it once
	scree_vec points[3] = {{0, 20}, {5, 20}, {10, 20}};
	scree_path path = add_path(world, points, 3, false);
	scree_box high = {{-INFINITY, 19.0f}, {INFINITY, INFINITY}};
	for (int k = 0; k < 2; ++k)
		ride(world, path, add_crate(world, SCREE_BODY_DYNAMIC, 2.0f + 4.0f * (float)k, 20.0f), false);
	draw_into(&drawing, world, SCREE_DRAW_JOINTS, &high);
	double length = 0.0;
	for (int k = 0; k < count_drawn(&drawing, DRAWN_LINE, SCREE_COLOR_JOINT); ++k)
	{
		const Drawn* line = drawn_at(&drawing, DRAWN_LINE, SCREE_COLOR_JOINT, k);
		length += fabs((double)line->points[1].x - line->points[0].x);
	}
	NEAR(length, 10.0, 1e-3);
	assert_int_equal(count_drawn(&drawing, DRAWN_POINT, SCREE_COLOR_JOINT), 2);
	scree_world_destroy(world);
}

static void fields_follow_their_bodies(void** state)
{
	(void)state;
	scree_world* world = open_test_world(0.0f);
	scree_field_def wind = scree_field_def_default(SCREE_FIELD_UNIFORM);
	wind.body = add_crate(world, SCREE_BODY_KINEMATIC, 5.0f, 6.0f);
	wind.pose.position.x = 1.0f;
	wind.shape = circle_shape(2.0f);
	wind.acceleration = (scree_vec){0.0f, -30.0f};
	scree_field field = add_field(world, &wind);
	draw_into(&drawing, world, SCREE_DRAW_FIELDS, NULL);
	const Drawn* region = drawn_at(&drawing, DRAWN_CIRCLE, SCREE_COLOR_FIELD, 0);
	assert_true(region->points[0].x == 6.0f && region->points[0].y == 6.0f && region->size == 2.0f);
	assert_true(has_line(&drawing, 6.0f, 6.0f, 6.0f, 5.75f, OPAQUE(SCREE_COLOR_FIELD)));
	OK(scree_field_set_enabled(world, field, false));
	draw_into(&drawing, world, SCREE_DRAW_FIELDS, NULL);
	assert_int_equal(count_drawn(&drawing, DRAWN_CIRCLE, SCREE_COLOR_DISABLED), 1);

	// a field without a region is its origin alone
	scree_field_def pull = scree_field_def_default(SCREE_FIELD_RADIAL);
	OK(scree_field_destroy(world, field));
	add_field(world, &pull);
	draw_into(&drawing, world, SCREE_DRAW_FIELDS, NULL);
	assert_int_equal(drawing.total, 1);
	assert_int_equal(count_drawn(&drawing, DRAWN_POINT, OPAQUE(SCREE_COLOR_FIELD)), 1);
	scree_world_destroy(world);
}

// A function that is null is skipped; the others are called as before.
static void null_functions_are_skipped(void** state)
{
	(void)state;
	scree_world* world = open_test_world(-10.0f);
	add_floor(world);
	add_shape(world, SCREE_BODY_DYNAMIC, circle_shape(0.5f), 0.0f, 0.5f, 0.0f);
	run_steps(world, 5);
	uint32_t all = 2 * SCREE_DRAW_LABELS - 1;
	draw_into(&drawing, world, all, NULL);
	int total = drawing.total, circles = drawing.counts[DRAWN_CIRCLE], texts = drawing.counts[DRAWN_TEXT];
	scree_draw_def def = log_def(&drawing, all);
	def.circle = NULL;
	def.text = NULL;
	OK(scree_world_draw(world, &def, NULL));
	assert_true(circles > 0 && texts > 0);
	assert_int_equal(drawing.total, total - circles - texts);
	scree_draw_def none = scree_draw_def_default();
	none.flags = all;
	OK(scree_world_draw(world, &none, NULL));
	scree_world_destroy(world);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(shapes_are_at_their_poses),  cmocka_unit_test(colors_show_states),
	    cmocka_unit_test(contacts_and_impulses),      cmocka_unit_test(bodies_and_boxes),
	    cmocka_unit_test(joints_and_paths),           cmocka_unit_test(fields_follow_their_bodies),
	    cmocka_unit_test(null_functions_are_skipped),
	};
	return RUN_ON_DEVICES(tests);
}
