// SPDX-License-Identifier: MIT
// test_flashes.c -- checks marks of events in pictures: touches, hits, sensors and broken joints. Also checks that
// marks fade, and that their number has a maximum.
#include "support/make_joints.h"
#include "view/flashes.h"
#include "view/outline.h"
#include <float.h>
#include <math.h>
#include <stdlib.h>

static const Camera camera = {.middle = {0.0f, 0.0f}, .scale = 50.0f, .width = 800, .height = 600};

// Adds a box of 1 m that falls and reports touches and hits. above: height of its lower side above the floor, m.
static scree_body drop(scree_world* world, float x, float above, float speed)
{
	scree_body_def def = scree_body_def_default();
	def.attribute = shape_attribute(world, box_shape(0.5f, 0.5f));
	def.pose.position = (scree_vec){x, 0.5f + above};
	def.velocity.linear.y = -speed;
	def.reports = SCREE_REPORT_TOUCHES | SCREE_REPORT_HITS;
	return create_body(world, &def);
}

static void step(scree_world* world, RenderTables* tables, Flashes* flashes, const Camera* eye, const Style* style,
                 int number)
{
	run_steps(world, 1);
	OK(flashes_step(flashes, tables, eye, style, number * (double)STEP));
}

static void touches_and_hits_flash(void** state)
{
	(void)state;
	scree_world* world = open_world(0.0f);
	RenderTables tables = {.world = world};
	Style style = {.layers[LAYER_touches] = true, .layers[LAYER_hits] = true};
	const Camera away = {.middle = {500.0f, 0.0f}, .scale = 50.0f, .width = 800, .height = 600};
	Flashes flashes = {0}, unseen = {0}, off = {0};
	Strokes strokes = {0};
	const Style none = {0};
	add_floor(world);
	drop(world, 0.0f, 0.04f, 6.0f);
	step(world, &tables, &flashes, &camera, &style, 1);
	OK(flashes_step(&unseen, &tables, &away, &style, 0.0));
	OK(flashes_step(&off, &tables, &camera, &none, 0.0));
	assert_int_equal(flashes.count, 2);
	assert_int_equal(flashes.seen, 2);
	assert_int_equal(unseen.count + unseen.seen + off.count, 0);
	for (int k = 0; k < 2; ++k)
	{
		NEAR(flashes.list[k].at.y, 0, 0.1);
		NEAR(flashes.list[k].diameter, 5 + 24 * 6.0 / 11.0, 0.1); // diameter at 6 m/s, px
	}

	// rings fade with the simulated time
	flashes_mark(&flashes, &strokes, &camera, (double)STEP);
	assert_int_equal(strokes.count, 2);
	assert_true(strokes.list[0].ring > 0 && strokes.list[0].color[3] == 255);
	flashes_mark(&flashes, &strokes, &camera, (double)STEP + 0.5 * FLASH_LASTS);
	assert_int_equal(strokes.count, 4);
	NEAR(strokes.list[2].color[3], 127, 2);
	flashes_mark(&flashes, &strokes, &camera, (double)STEP + 1.01 * FLASH_LASTS);
	assert_int_equal(strokes.count, 4);
	assert_int_equal(flashes.count, 0);
	free(strokes.list);
	flashes_close(&flashes);
	scree_world_destroy(world);
}

// 2,500 boxes touch the floor in one step. At most 1,000 flashes are stored, and the others are counted.
static void too_many_are_counted(void** state)
{
	(void)state;
	scree_world* world = open_world(0.0f);
	RenderTables tables = {.world = world};
	Style style = {.layers[LAYER_hits] = true};
	const Camera wide = {.middle = {0.0f, 0.0f}, .scale = 0.1f, .width = 800, .height = 600};
	Flashes flashes = {0};
	for (int k = 0; k < 2500; ++k)
	{
		float x = 1.5f * (float)(k - 1250);
		add_crate(world, SCREE_BODY_STATIC, x, -0.5f);
		drop(world, x, 0.01f, 4.0f);
	}
	step(world, &tables, &flashes, &wide, &style, 1);
	assert_int_equal(flashes.seen, 2500);
	assert_true(flashes.count <= 1000 && flashes.count > 500);
	assert_int_equal(flashes.left_out, 2500 - flashes.count);
	step(world, &tables, &flashes, &wide, &style, 2);
	assert_true(flashes.count <= 2000);
	flashes_close(&flashes);
	scree_world_destroy(world);
}

// A load of 10 N breaks a joint with a threshold of 5 N. A cross marks the place of the joint, 2 m above the box.
static void broken_joints_have_a_cross(void** state)
{
	(void)state;
	scree_world* world = open_world(-10.0f);
	RenderTables tables = {.world = world};
	Style style = {.layers[LAYER_breaks] = true};
	Flashes flashes = {0};
	Strokes strokes = {0};
	scree_joint_def def = scree_joint_def_make(SCREE_JOINT_REVOLUTE);
	def.body_b = add_crate(world, SCREE_BODY_DYNAMIC, 1.0f, 0.0f);
	OK(scree_joint_def_place(world, &def, (scree_pose){{1.0f, 2.0f}, {1.0f, 0.0f}}));
	def.force_threshold = 5.0f;
	def.can_break = true;
	add_joint(world, &def);
	for (int k = 1; k <= 10; ++k)
		step(world, &tables, &flashes, &camera, &style, k);
	assert_int_equal(flashes.count, 1);
	NEAR(flashes.list[0].at.x, 1, 0.01);
	NEAR(flashes.list[0].at.y, 2, 0.05);
	flashes_mark(&flashes, &strokes, &camera, 10.0 * (double)STEP);
	assert_int_equal(strokes.count, 2);
	NEAR(strokes.list[0].b.y - strokes.list[0].a.y, -(strokes.list[1].b.y - strokes.list[1].a.y), 1e-5);
	free(strokes.list);
	flashes_close(&flashes);
	scree_world_destroy(world);
}

// A box enters one of two sensors. The mark of this sensor changes and flashes.
static void sensors_have_marks(void** state)
{
	(void)state;
	scree_world* world = open_world(-10.0f);
	scree_collidable_def def = scree_collidable_def_default();
	scree_collidable sensors[2];
	drop(world, 0.0f, 3.0f, 0.0f);
	def.attribute = shape_attribute(world, box_shape(1.0f, 1.0f));
	def.sensor = SCREE_SENSOR_MOVING;
	for (int k = 0; k < 2; ++k)
	{
		def.pose.position = (scree_vec){20.0f * (float)k, 1.5f};
		sensors[k] = create_collidable(world, &def);
	}
	Sprites sprites = {0};
	RenderTables tables = {.world = world};
	Style style = {.layers[LAYER_visits] = true};
	Flashes flashes = {0};
	assert_true(sprites_list(&sprites, NULL, world) && sensor_marks_list(&tables.sensors, &sprites));
	assert_int_equal(tables.sensors.count, 2);
	assert_int_equal(tables.sensors.rows, 3);
	assert_true(sensor_marks_update(&tables.sensors, world));
	// nothing has changed since the call above
	assert_false(sensor_marks_update(&tables.sensors, world));
	const uint8_t* marks = tables.sensors.marks;
	assert_true(marks[0] == 0 && marks[1] == MARK_SENSOR && marks[2] == MARK_SENSOR);
	int number = 0;
	while (!sensor_visited(world, sensors[0]) && number < 60)
		step(world, &tables, &flashes, &camera, &style, ++number);
	assert_in_range(number, 5, 59);
	tables.sensors.now = number * (double)STEP;
	assert_true(sensor_marks_update(&tables.sensors, world));
	assert_int_equal(marks[1], MARK_SENSOR | MARK_VISITED | 63 << 2);
	assert_int_equal(marks[2], MARK_SENSOR);
	tables.sensors.now += FLASH_LASTS;
	assert_true(sensor_marks_update(&tables.sensors, world));
	assert_int_equal(marks[1], MARK_SENSOR | MARK_VISITED);
	sensor_marks_close(&tables.sensors);
	sprites_free(&sprites);
	flashes_close(&flashes);
	scree_world_destroy(world);
}

// Outlines lie on the surfaces of shapes: the ends of all strokes have a distance of 0 from the shape.
static void outlines_follow_shapes(void** state)
{
	(void)state;
	scree_shape shapes[4] = {circle_shape(0.5f), box_shape(1.0f, 0.5f)};
	const scree_vec corners[] = {{-1.0f, -0.5f}, {1.0f, -0.5f}, {0.0f, 1.0f}};
	const scree_pose pose = {{2.0f, 1.0f}, scree_rot_make(0.7f)};
	OK(scree_shape_make_capsule((scree_vec){-1.0f, 0.0f}, (scree_vec){1.0f, 0.3f}, 0.4f, &shapes[2]));
	shapes[3] = polygon_shape(corners, 3, 0.2f);
	for (int n = 0; n < 4; ++n)
	{
		Strokes strokes = {0};
		outline_mark(&strokes, &shapes[n], pose, &camera, 2.0f, (Color){0});
		assert_true(strokes.count >= (n == 0 ? 1 : 4));
		for (int k = 0; k < strokes.count; ++k)
		{
			scree_distance distance;
			if (n == 0)
			{
				NEAR(strokes.list[k].width, 50, 1e-3); // diameter of the circle, px
				continue;
			}
			OK(scree_shapes_get_distance(&shapes[n], pose, NULL, (scree_pose){strokes.list[k].a, {1.0f, 0.0f}},
			                             &distance));
			NEAR(distance.distance, 0, 1e-4);
		}
		free(strokes.list);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(touches_and_hits_flash),     cmocka_unit_test(too_many_are_counted),
	    cmocka_unit_test(broken_joints_have_a_cross), cmocka_unit_test(sensors_have_marks),
	    cmocka_unit_test(outlines_follow_shapes),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
