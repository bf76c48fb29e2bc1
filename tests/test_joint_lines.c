// SPDX-License-Identifier: MIT
// test_joint_lines.c -- checks lines of joints in pictures: the ends of the lines, their color by load, and that lines
// disappear with broken and destroyed joints.
#include "support/make_joints.h"
#include "view/joint_lines.h"
#include <float.h>
#include <stdlib.h>

// Adds a box and a pin that joins it to the world. above: height of the pin above the center of the box, m. Returns the
// pin.
static scree_joint hang(scree_world* world, float x, float half, float above, float threshold)
{
	scree_joint_def def = scree_joint_def_make(SCREE_JOINT_REVOLUTE);
	def.body_b = add_box(world, SCREE_BODY_DYNAMIC, half, half, x, 5.0f);
	OK(scree_joint_def_place(world, &def, (scree_pose){{x, 5.0f + above}, {1.0f, 0.0f}}));
	def.force_threshold = threshold;
	def.can_break = true;
	return add_joint(world, &def);
}

// Three joints carry the weights of their boxes: 40, 10 and 10 N. The second joint breaks, and the third is destroyed.
static void lines_follow_joints(void** state)
{
	scree_world* world = open_world(-10.0f);
	scree_body bodies[3];
	int count;
	hang(world, 0.0f, 1.0f, 2.0f, FLT_MAX);
	hang(world, 10.0f, 0.5f, 2.0f, 5.0f);
	scree_joint destroyed = hang(world, 20.0f, 0.5f, 2.0f, FLT_MAX);
	OK(scree_world_get_bodies(world, bodies, 3, &count));

	const RenderTables tables = {.world = world, .bodies = bodies, .body_count = 3};
	const Camera camera = {.middle = {0.0f, 5.0f}, .scale = 50.0f, .width = 800, .height = 600};
	JointLines lines = {0};
	Strokes strokes = {0};
	assert_true(joint_lines_build(&lines, &tables));
	assert_int_equal(lines.links.count, 3);
	OK(joint_lines_update(&lines, &tables));
	assert_int_equal(lines.links.count, 3);
	run_steps(world, 60);
	OK(joint_lines_update(&lines, &tables));
	assert_int_equal(lines.links.count, 2);
	OK(scree_joint_destroy(world, destroyed));
	OK(joint_lines_update(&lines, &tables));
	assert_int_equal(lines.links.count, 1);

	// dots at both anchors, a line between the anchors, and a line to the center of the box; the line to the center is
	// red because it has the largest load
	joint_lines_mark(&lines, tables.awake, &strokes, &camera, &(Style){.detail = 1.0f});
	assert_int_equal(strokes.count, 4);
	NEAR(strokes.list[1].a.y, 7.0f, 0.01f);
	NEAR(strokes.list[1].b.y, 5.0f, 0.01f);
	assert_true(strokes.list[1].color[0] > 200 && strokes.list[1].color[1] < 60);
	// the same line is dim if the box is asleep: 0.4 times its color, and 0.6 times that of the background, 247, 245, 240
	const Stroke red = strokes.list[1];
	const bool awake[3] = {false, true, true};
	strokes.count = 0;
	joint_lines_mark(&lines, awake, &strokes, &camera, &(Style){.detail = 1.0f});
	assert_int_equal(strokes.count, 4);
	NEAR(strokes.list[1].color[0], 0.4f * (float)red.color[0] + 0.6f * 247.0f, 1.0f);
	NEAR(strokes.list[1].color[1], 0.4f * (float)red.color[1] + 0.6f * 245.0f, 1.0f);
	joint_lines_close(&lines);
	free(strokes.list);
	scree_world_destroy(world);
	(void)state;
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(lines_follow_joints)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
