// SPDX-License-Identifier: MIT
// test_bad_paths.c -- checks that every function of paths, and of joints on them, refuses bad arguments with a message
// that names argument and value, and changes nothing.
#include "support/bad_input.h"
#include "support/make_joints.h"
#include <float.h>
#include <math.h>
#include <stdio.h>

static const scree_vec good_points[] = {{0.0f, 0.0f}, {1.0f, 0.0f}, {1.0f, 1.0f}, {0.0f, 1.0f}};
static scree_path path, gone, alien;
static scree_joint joint;

static scree_path_def good_path(void)
{
	scree_path_def def = scree_path_def_default();
	def.points = good_points;
	def.count = 4;
	return def;
}

static scree_joint_def good_joint(void)
{
	scree_joint_def def = scree_joint_def_make(SCREE_JOINT_PATH);
	def.body_b = body;
	def.path = path;
	return def;
}

static int set_up(void** state)
{
	set_up_bad_input(state);
	scree_path_def def = good_path();
	OK(scree_path_create(world, &def, &path));
	OK(scree_path_create(world, &def, &gone));
	OK(scree_path_destroy(world, gone));
	for (int k = 0; k < 3; ++k)
		OK(scree_path_create(other, &def, &alien));
	scree_joint_def joint_def = good_joint();
	joint = add_joint(world, &joint_def);
	run_steps(world, 1);
	before = hash_of(world);
	return 0;
}

static void definitions(void** state)
{
	(void)state;
	scree_path_def def = good_path();
	scree_path made;
	INVALID(scree_path_create, (NULL, &def, &made), "world is null");
	INVALID(scree_path_create, (world, NULL, &made), "def is null");
#define DEF(change, sentence) \
	def = good_path();        \
	def.change;               \
	INVALID(scree_path_create, (world, &def, &made), "def" sentence)
	DEF(size = 0, ".size is 0: the definition was not made by scree_path_def_default");
	DEF(points = NULL, ".points is null");
	DEF(count = 1, ".count is 1, must be from 2 to 65536 for an open path");
	DEF(count = 0, ".count is 0");
	DEF(count = -4, ".count is -4");
	DEF(count = 65537, ".count is 65537, must be from 2 to 65536");
#undef DEF
	def = good_path();
	def.closed = true;
	def.count = 2;
	INVALID(scree_path_create, (world, &def, &made), "def.count is 2, must be from 3 to 65536 for a closed path");
}

static void points(void** state)
{
	(void)state;
	scree_path_def def = good_path();
	scree_path made;
	scree_vec own[4];
#define POINT(k, change, sentence)                                               \
	for (int closed = 0; closed < 2; ++closed)                                   \
	{                                                                            \
		for (int n = 0; n < 4; ++n)                                              \
			own[n] = good_points[n];                                             \
		own[k].change;                                                           \
		def.points = own;                                                        \
		def.closed = closed;                                                     \
		INVALID(scree_path_create, (world, &def, &made), "def.points" sentence); \
	}
	POINT(0, x = NAN, "[0].x is nan");
	POINT(3, y = NAN, "[3].y is nan");
	POINT(2, x = INFINITY, "[2].x is inf");
	POINT(1, y = -1.1e5f, "[1].y is -110000, must be from -100000 to 100000");
	POINT(1, x = 0.0f, "[1] is 0 m from the one before it, must be at least 0.0001");
	POINT(3, x = 1.0f, "[3] is 0 m from the one before it");
	POINT(2, y = 5e-5f, "[2] is 5e-05 m from the one before it");
#undef POINT
	for (int n = 0; n < 4; ++n)
		own[n] = good_points[n % 3];
	def.closed = true;
	INVALID(scree_path_create, (world, &def, &made),
	        "def.points[3] is 0 m from the first one, must be at least 0.0001 if closed");
	def.closed = false;
	OK(scree_path_create(other, &def, &made)); // an open path may end at its first point, but a closed path may not
}

static void functions(void** state)
{
	(void)state;
	float number;
	scree_pose pose;
	uint64_t user;
	int count;
	INVALID(scree_path_destroy, (NULL, path), "world is null");
	INVALID(scree_path_destroy, (world, path), "path is that of 1 joint: destroy it first");
	const scree_path bad[] = {{0, 0}, gone, alien, {7, 1}};
	static const char* const sentences[] = {"path is null", "path (index 2", "path (index 3", "path (index 7"};
	for (int k = 0; k < 4; ++k)
	{
		STALE(scree_path_destroy, (world, bad[k]), sentences[k]);
		STALE(scree_path_get_length, (world, bad[k], &number), sentences[k]);
		STALE(scree_path_get_pose, (world, bad[k], 0.0f, &pose), sentences[k]);
		STALE(scree_path_get_nearest, (world, bad[k], (scree_vec){0, 0}, &number), sentences[k]);
		STALE(scree_path_get_points, (world, bad[k], NULL, 0, &count), sentences[k]);
		STALE(scree_path_get_user, (world, bad[k], &user), sentences[k]);
		STALE(scree_path_set_user, (world, bad[k], 1), sentences[k]);
		assert_false(scree_path_is_valid(world, bad[k]));
		assert_false(scree_path_is_closed(world, bad[k]));
	}
	assert_false(scree_path_is_valid(NULL, path));
	INVALID(scree_path_get_length, (NULL, path, &number), "world is null");
	INVALID(scree_path_get_length, (world, path, NULL), "length is null");
	INVALID(scree_path_get_pose, (world, path, NAN, &pose), "along is nan");
	INVALID(scree_path_get_pose, (world, path, 0.0f, NULL), "pose is null");
	INVALID(scree_path_get_nearest, (world, path, (scree_vec){NAN, 0}, &number), "point.x is nan");
	INVALID(scree_path_get_nearest, (world, path, (scree_vec){0, 2e5f}, &number), "point.y is 200000");
	INVALID(scree_path_get_nearest, (world, path, (scree_vec){0, 0}, NULL), "along is null");
	INVALID(scree_path_get_points, (world, path, NULL, 2, &count), "points is null");
	INVALID(scree_path_get_points, (world, path, NULL, -1, &count), "capacity is -1");
	INVALID(scree_path_get_points, (world, path, NULL, 0, NULL), "count is null");
	INVALID(scree_path_get_user, (world, path, NULL), "user is null");
	INVALID(scree_path_set_user, (NULL, path, 1), "world is null");
	INVALID(scree_world_get_paths, (NULL, NULL, 0, &count), "world is null");
	INVALID(scree_world_get_paths, (world, NULL, 0, NULL), "count is null");
}

static void joints(void** state)
{
	(void)state;
	scree_joint_def def = good_joint();
	scree_joint made;
#define DEF(change, status, sentence) \
	def = good_joint();               \
	def.change;                       \
	REFUSED(scree_joint_create, (world, &def, &made), status, "def" sentence)
	DEF(path = SCREE_NULL_PATH, SCREE_ERROR_STALE, ".path is null");
	DEF(path = gone, SCREE_ERROR_STALE, ".path (index 2");
	DEF(path = alien, SCREE_ERROR_STALE, ".path (index 3");
	DEF(initial_along = NAN, SCREE_ERROR_INVALID, ".initial_along is nan");
	DEF(initial_along = 2e5f, SCREE_ERROR_INVALID, ".initial_along is 200000");
	DEF(size = (uint32_t)offsetof(scree_joint_def, path), SCREE_ERROR_STALE, ".path is null");
#undef DEF
	def = good_joint();
	INVALID(scree_joint_def_mount, (NULL, &def, 0.0f), "world is null");
	INVALID(scree_joint_def_mount, (world, NULL, 0.0f), "def is null");
	INVALID(scree_joint_def_mount, (world, &def, NAN), "along is nan");
	INVALID(scree_joint_def_mount, (world, &def, 2e5f), "along is 200000");
#define DEF(change, status, sentence) \
	def = good_joint();               \
	def.change;                       \
	REFUSED(scree_joint_def_mount, (world, &def, 1.0f), status, "def" sentence)
	DEF(size = 0, SCREE_ERROR_INVALID, ".size is 0");
	DEF(size = (uint32_t)offsetof(scree_joint_def, path), SCREE_ERROR_INVALID, ".size is");
	DEF(type = SCREE_JOINT_WHEEL, SCREE_ERROR_INVALID, ".type is wheel: only a path can be mounted");
	DEF(path = gone, SCREE_ERROR_STALE, ".path (index 2");
	DEF(body_a = stale, SCREE_ERROR_STALE, ".body_a (index");
	DEF(body_b = stale, SCREE_ERROR_STALE, ".body_b (index");
	DEF(frame_a.position.x = NAN, SCREE_ERROR_INVALID, ".frame_a.position.x is nan");
#undef DEF
	INVALID(scree_joint_set_ratio, (world, joint, 2.0f), "joint is of type path, not a gear or a pulley");
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(definitions), cmocka_unit_test(points),
	                                   cmocka_unit_test(functions), cmocka_unit_test(joints)};
	return cmocka_run_group_tests(tests, set_up, tear_down_bad_input);
}
