// SPDX-License-Identifier: MIT
// test_scene_library.c -- checks the library scree_scene: what a written scene carries, what a program gets of a loaded one, and
// sentences for bad arguments and files.
#include "scree/scree_scene.h"
#include "support/make_bodies.h"
#include "support/make_worlds.h"
#include "support/written_scenes.h"
#include <float.h>
#include <locale.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#define SCRATCH "test_scene_library_scratch.json"

static scree_scene* load(const char* text)
{
	scree_scene* scene;
	OK(scree_scene_load_text(text, strlen(text), "level.json", NULL, &scene));
	return scene;
}

// Writes a world, loads it again and returns the scene; the text is in *text, which the caller frees.
static scree_scene* round_trip(scree_world* world, char** text)
{
	size_t size;
	*text = write_scene(world, NULL, &size);
	return load_written(*text, size, "cpu");
}

static scree_body body_at(const scree_scene* scene, int k)
{
	scree_body bodies[64];
	int count;
	OK(scree_world_get_bodies(scree_scene_get_world(scene), bodies, 64, &count));
	assert_true(k < count && count <= 64);
	return bodies[k];
}

static const char level[] =
    "{\"name\": \"level\", \"title\": \"A level\", \"parameters\": {\"n\": {\"default\": 3}}, "
    "\"world\": {\"gravity\": [0, -5], \"dt\": 0.02, \"substeps\": 2}, \"steps\": 50, \"view\": [-5, -5, 5, 5], "
    "\"attributes\": {\"ball\": {\"circle\": 0.5}}, \"bodies\": [{\"name\": \"link\", \"attribute\": \"ball\", "
    "\"repeat\": {\"index\": \"i\", \"to\": \"n\"}, \"position\": [\"2 * i\", 0]}, {\"attribute\": \"ball\", "
    "\"position\": [0, 9]}, "
    "{\"name\": \"car\", \"attribute\": \"ball\", \"position\": [0, 5]}], "
    "\"keys\": [{\"key\": \"up\", \"body\": \"car\", \"force\": [1000, 0]}]}";

// Checks names, settings, keys and steps of a loaded scene.
static void test_game(void** state)
{
	(void)state;
	const scree_scene_setting four = {"n", "2 + 2"};
	scree_world_def world = scree_world_def_default();
	scree_scene_def def = scree_scene_def_default();
	scree_scene_info info;
	scree_scene* scene;
	const char* names[4];
	scree_body bodies[8], all[8];
	int count;
	world.device = "cpu";
	world.threads = 1;
	world.gravity.y = 99.0f; // that of the scene holds
	def.world = &world;
	def.settings = &four;
	def.setting_count = 1;
	OK(scree_scene_load_text(level, strlen(level), "level.json", &def, &scene));
	OK(scree_scene_get_info(scene, &info));
	assert_string_equal(info.name, "level");
	assert_string_equal(info.title, "A level");
	assert_true(info.dt == 0.02f && info.substeps == 2 && info.steps == 50 && info.has_view && !info.has_detail);
	assert_true(info.view.lower.x == -5.0f && info.view.upper.y == 5.0f);
	assert_int_equal(info.body_count, 6);
	assert_int_equal(info.keys, SCREE_SCENE_KEY_UP);
	OK(scree_scene_get_names(scene, names, 4, &count));
	assert_int_equal(count, 2);
	assert_string_equal(names[0], "link");
	assert_string_equal(names[1], "car");
	OK(scree_world_get_bodies(scree_scene_get_world(scene), all, 8, &count));
	OK(scree_scene_get_bodies(scene, "link", bodies, 8, &count));
	assert_int_equal(count, 4);
	assert_true(scree_body_equals(bodies[3], all[3]));
	OK(scree_scene_get_bodies(scene, "car", bodies, 8, &count));
	assert_int_equal(count, 1);
	assert_true(scree_body_equals(bodies[0], all[5]));
	OK(scree_scene_set_keys(scene, SCREE_SCENE_KEY_UP));
	OK(scree_scene_step(scene));
	scree_velocity velocity;
	OK(scree_body_get_velocity(scree_scene_get_world(scene), bodies[0], &velocity));
	assert_true(velocity.linear.x > 1.0f);
	NEAR(velocity.linear.y, -5.0 * 0.02, 1e-6);
	scree_scene_destroy(scene);
	scree_scene_destroy(NULL);
	assert_null(scree_scene_get_world(NULL));
}

// Checks every kind of object, with values other than the defaults.
static void test_all_objects(void** state)
{
	(void)state;
	scree_world* world = open_world(-10.0f);
	scree_attribute_def shape = scree_attribute_def_default();
	scree_attribute ball, platform;
	OK(scree_shape_make_circle((scree_vec){0.25f, -0.0f}, 0.3f, &shape.shape));
	shape.friction = 0.1f;
	shape.material = 7;
	OK(scree_attribute_create(world, &shape, &ball));
	shape = scree_attribute_def_default();
	shape.one_way = (scree_vec){0.0f, 1.0f};
	shape.tangent_speed = -2.0f;
	OK(scree_attribute_create(world, &shape, &platform));
	scree_material_pair pair = scree_material_pair_default();
	pair.restitution = 0.7f;
	OK(scree_world_set_material_pair(world, 7, 0, &pair));
	OK(scree_world_set_hit_thresholds(world, 3.0f, 0.5f));

	scree_body bodies[4];
	for (int k = 0; k < 4; ++k)
	{
		scree_body_def def = scree_body_def_default();
		// those of bodies whose center of mass moves after their creation are not rounded
		def.pose =
		    k % 3 == 0 ? pose_at(3.0f * (float)k, 0.25f, 0.0f) : pose_at(3.0f * (float)k, 1.0f / 3.0f, 0.7f + (float)k);
		def.attribute = k == 1 ? platform : ball;
		def.user = k == 2 ? UINT64_MAX : 1000 + (uint64_t)k;
		def.linear_damping = 0.1f * (float)k;
		def.velocity = (scree_velocity){{0.1f, -0.0f}, 0.3f};
		def.locks = k == 3 ? SCREE_LOCK_X : 0;
		def.filter.group = INT32_MIN;
		def.sleep_threshold = k == 3 ? 0.2f : 0.0f;
		OK(scree_body_create(world, &def, &bodies[k]));
	}
	OK(scree_body_set_mass(world, bodies[0], (scree_mass){3.0f, 2.0f, {0.5f, 0.25f}}));
	OK(scree_body_set_velocity(world, bodies[0], (scree_velocity){{0.1f, 0.2f}, 0.9f}));
	scree_collidable_def part = scree_collidable_def_default();
	part.attribute = platform;
	part.body = bodies[3];
	part.pose.position.y = -0.5f;
	part.user = 5;
	part.reports = SCREE_REPORT_HITS;
	part.sensor = SCREE_SENSOR_STATIC;
	OK(scree_collidable_create(world, &part, NULL));
	part.body = SCREE_NULL_BODY;
	OK(scree_collidable_create(world, &part, NULL));
	scree_body_def empty = scree_body_def_default();
	OK(scree_body_create(world, &empty, NULL));
	OK(scree_body_set_excluded(world, bodies[0], bodies[2], true));

	scree_joint_def joint = scree_joint_def_make(SCREE_JOINT_WHEEL);
	joint.body_a = bodies[1];
	joint.body_b = bodies[2];
	joint.frame_a.rotation = scree_rot_make(0.3f);
	joint.coordinates[SCREE_ALONG].spring = false;
	joint.coordinates[SCREE_ANGLE].motor = true;
	joint.coordinates[SCREE_ANGLE].motor_speed = 3.0f;
	joint.coordinates[SCREE_ANGLE].motor_max = FLT_MAX / 1.0000001f;
	joint.user = 77;
	OK(scree_joint_create(world, &joint, NULL));
	joint = scree_joint_def_make(SCREE_JOINT_DISTANCE);
	joint.body_b = bodies[2];
	joint.coordinates[SCREE_ALONG].target = 4.0f / 3.0f;
	joint.coordinates[SCREE_ALONG].lock_hertz = 7.0f;
	joint.can_break = true;
	joint.force_threshold = 1e6f;
	OK(scree_joint_create(world, &joint, NULL));
	joint = scree_joint_def_make(SCREE_JOINT_GEAR);
	joint.body_a = bodies[2];
	joint.body_b = bodies[3];
	joint.ratio = -2.5f;
	OK(scree_joint_def_couple(world, &joint));
	OK(scree_joint_create(world, &joint, NULL));
	scree_path_def path = scree_path_def_default();
	const scree_vec points[] = {{0.0f, 0.1f}, {1.0f, 0.2f}, {2.0f, 0.0f}};
	path.points = points;
	path.count = 3;
	path.closed = true;
	path.user = 1u << 20;
	scree_path rail;
	OK(scree_path_create(world, &path, &rail));
	joint = scree_joint_def_make(SCREE_JOINT_PATH);
	joint.body_b = bodies[3];
	joint.path = rail;
	joint.initial_along = 0.5f;
	joint.coordinates[SCREE_ALONG].limited = true;
	joint.coordinates[SCREE_ALONG].lower = -0.25f;
	joint.coordinates[SCREE_ALONG].upper = 1e5f;
	OK(scree_joint_create(world, &joint, NULL));
	scree_field_def field = scree_field_def_default(SCREE_FIELD_BUOYANCY);
	OK(scree_shape_make_box(9.0f, 2.0f, &field.shape));
	field.body = bodies[1];
	field.velocity.x = 0.3f;
	field.user = 4;
	OK(scree_field_create(world, &field, NULL));

	char* text;
	scree_scene* scene = round_trip(world, &text);
	check_same_hash("all objects", world, scree_scene_get_world(scene));
	for (int step = 0; step < 100; ++step)
	{
		OK(scree_world_step(world, 1.0f / 60.0f, 4));
		OK(scree_scene_step(scene));
		check_same_hash("all objects", world, scree_scene_get_world(scene));
	}
	scree_world_def def;
	uint64_t user;
	OK(scree_world_get_def(scree_scene_get_world(scene), &def));
	assert_true(def.hit_speed == 3.0f && def.hit_impulse == 0.5f);
	OK(scree_body_get_user(scree_scene_get_world(scene), body_at(scene, 2), &user));
	assert_true(user == UINT64_MAX);
	scree_mass mass;
	OK(scree_body_get_own_mass(scree_scene_get_world(scene), body_at(scene, 0), &mass));
	assert_true(mass.mass == 3.0f && mass.center.y == 0.25f);
	OK(scree_body_get_own_mass(scree_scene_get_world(scene), body_at(scene, 1), &mass));
	assert_true(mass.mass == 0.0f);
	assert_true(scree_body_is_excluded(scree_scene_get_world(scene), body_at(scene, 2), body_at(scene, 0)));
	check_same_text("all objects", world, NULL, 3);
	scree_scene_destroy(scene);
	scree_scene_free_text(text);
	scree_world_destroy(world);
}

// Checks a world without objects, bodies far away, sleeping bodies, destroyed ones, and a broken joint.
static void test_special_worlds(void** state)
{
	(void)state;
	scree_world* world = open_world(-10.0f);
	char* text;
	scree_scene* scene = round_trip(world, &text);
	check_same_hash("empty", world, scree_scene_get_world(scene));
	assert_string_equal(
	    text,
	    "{\n\t\"name\": \"written\",\n\t\"title\": \"written\",\n\t\"world\": {},\n\t\"attributes\": {\n\t}\n}\n");
	scree_scene_free_text(text);
	scree_scene_destroy(scene);

	// far away, floats are 8 mm apart; a disabled body and one that sleeps
	scree_body bodies[6];
	scree_attribute_def shape = scree_attribute_def_default();
	for (int k = 0; k < 6; ++k)
	{
		scree_body_def def = scree_body_def_default();
		def.pose = pose_at(99000.0f + 10.0f * (float)k, -99000.01f, 0.0f);
		def.user = (uint64_t)k;
		def.disabled = k == 1;
		OK(scree_body_create_with_shape(world, &def, &shape, &bodies[k]));
	}
	scene = round_trip(world, &text);
	check_same_hash("far away", world, scree_scene_get_world(scene));
	scree_scene_free_text(text);
	scree_scene_destroy(scene);

	// a destroyed body leaves a gap, so later indices differ, in the same order
	scree_joint_def joint = scree_joint_def_make(SCREE_JOINT_WELD);
	joint.body_a = bodies[4];
	joint.body_b = bodies[5];
	joint.can_break = true;
	joint.force_threshold = 0.0f;
	scree_joint weld;
	scree_joint_state held;
	OK(scree_joint_create(world, &joint, &weld));
	OK(scree_body_destroy(world, bodies[2]));
	OK(scree_body_set_velocity(world, bodies[5], (scree_velocity){{0.0f, 30.0f}, 0.0f}));
	for (int k = 0; k < 5; ++k)
		OK(scree_world_step(world, 1.0f / 60.0f, 4));
	OK(scree_joint_get_state(world, weld, &held));
	assert_true(held.broken);
	scene = round_trip(world, &text);
	assert_null(strstr(text, "joints"));
	uint64_t user;
	OK(scree_body_get_user(scree_scene_get_world(scene), body_at(scene, 2), &user));
	assert_int_equal(user, 3);
	scree_pose was, now;
	OK(scree_body_get_pose(world, bodies[3], &was));
	OK(scree_body_get_pose(scree_scene_get_world(scene), body_at(scene, 2), &now));
	assert_memory_equal(&was, &now, sizeof was);
	scree_scene_free_text(text);
	scree_scene_destroy(scene);
	scree_world_destroy(world);
}

static void test_sleep(void** state)
{
	(void)state;
	scree_world* world = open_world(-10.0f);
	scree_body body;
	bool awake;
	OK(scree_body_create_box(world, SCREE_BODY_STATIC, pose_at(0.0f, -0.5f, 0.0f), 20.0f, 0.5f, 0, NULL));
	OK(scree_body_create_box(world, SCREE_BODY_DYNAMIC, pose_at(0.0f, 0.5f, 0.0f), 0.5f, 0.5f, 0, &body));
	for (int k = 0; k < 120; ++k)
		OK(scree_world_step(world, 1.0f / 60.0f, 4));
	OK(scree_body_get_awake(world, body, &awake));
	assert_false(awake);
	char* text;
	scree_scene* scene = round_trip(world, &text);
	assert_non_null(strstr(text, "\"asleep\": true"));
	for (int k = 0; k < 10; ++k)
		OK(scree_scene_step(scene));
	OK(scree_body_get_awake(scree_scene_get_world(scene), body_at(scene, 1), &awake));
	assert_false(awake);
	scree_scene_free_text(text);
	scree_scene_destroy(scene);
	scree_world_destroy(world);
}

static int fail_count;
static char fail_function[64], fail_sentence[600];

static void count_failures(const char* function, scree_status status, const char* sentence, void* context)
{
	(void)status, (void)context;
	++fail_count;
	snprintf(fail_function, sizeof fail_function, "%s", function);
	snprintf(fail_sentence, sizeof fail_sentence, "%s", sentence);
}

// Fails unless the call has this status, one report to the hook, and this part of the sentence.
#define REFUSED(status, call, part)                                                          \
	do                                                                                       \
	{                                                                                        \
		fail_count = 0;                                                                      \
		assert_int_equal(call, status);                                                      \
		if (fail_count != 1 || !strstr(fail_sentence, part) || !strstr(scree_error(), part)) \
			fail_msg("%d reports, %s: %s", fail_count, fail_function, scree_error());        \
	} while (0)

static void test_refusals(void** state)
{
	(void)state;
	scree_scene* scene;
	scree_scene_def def = scree_scene_def_default();
	scree_scene_info info = scree_scene_info_default();
	scree_world_def slow = scree_world_def_default();
	scree_world* world = open_world(-10.0f);
	char* text;
	size_t size;
	int count;
	scree_fail_hook_set(count_failures, NULL);
	REFUSED(SCREE_ERROR_FILE, scree_scene_load("nowhere/x.json", NULL, &scene), "nowhere/x.json: No such file");
	assert_null(scene);
	assert_string_equal(fail_function, "scree_scene_load");
	REFUSED(SCREE_ERROR_INVALID, scree_scene_load(NULL, NULL, &scene), "scree_scene_load: path is null");
	REFUSED(SCREE_ERROR_INVALID, scree_scene_load("x", NULL, NULL), "scene is null");
	REFUSED(SCREE_ERROR_INVALID, scree_scene_load(".", NULL, &scene), "is a folder");
	REFUSED(SCREE_ERROR_INVALID, scree_scene_load_text("{\"name\": oops}", 14, "a.json", NULL, &scene),
	        "a.json: line 1, column");
	REFUSED(SCREE_ERROR_INVALID, scree_scene_load_text("", 0, "a.json", NULL, &scene), "a.json: line 1");
	REFUSED(SCREE_ERROR_INVALID, scree_scene_load_text(NULL, 3, "a.json", NULL, &scene), "text is null");
	// a bad shape is reported once, with its place
	const char bad[] =
	    "{\"name\": \"x\", \"title\": \"y\", \"attributes\": {\"a\": {\"polygon\": [[0, 0], [1, 0], [2, 0]]}}}";
	REFUSED(SCREE_ERROR_INVALID, scree_scene_load_text(bad, strlen(bad), "b.json", NULL, &scene),
	        "b.json: attributes.a.polygon: ");
	assert_string_equal(fail_function, "scree_scene_load_text");
	def.setting_count = 1;
	REFUSED(SCREE_ERROR_INVALID, scree_scene_load_text(level, strlen(level), "l", &def, &scene),
	        "def.settings is null");
	def = scree_scene_def_default();
	def.size = 0;
	REFUSED(SCREE_ERROR_INVALID, scree_scene_load_text(level, strlen(level), "l", &def, &scene), "def.size is 0");
	def = scree_scene_def_default();
	slow.threads = 99;
	def.world = &slow;
	REFUSED(SCREE_ERROR_INVALID, scree_scene_load_text(level, strlen(level), "l", &def, &scene), "threads is 99");

	REFUSED(SCREE_ERROR_INVALID, scree_scene_write(NULL, NULL, SCRATCH), "scree_scene_write: world is null");
	REFUSED(SCREE_ERROR_INVALID, scree_scene_write(world, NULL, NULL), "path is null");
	REFUSED(SCREE_ERROR_FILE, scree_scene_write(world, NULL, "nowhere/x.json"),
	        "nowhere/x.json: cannot be written: No such");
	REFUSED(SCREE_ERROR_FILE, scree_scene_write(world, NULL, "."), ".: cannot be written: Is a directory");
	info.dt = 2.0f;
	REFUSED(SCREE_ERROR_INVALID, scree_scene_write_text(world, &info, "c.json", &text, &size),
	        "c.json: world.dt: 2 must be at most 1 in a scene file");
	assert_null(text);
	info = scree_scene_info_default();
	info.has_view = true;
	REFUSED(SCREE_ERROR_INVALID, scree_scene_write_text(world, &info, "c.json", &text, &size), "info.view is narrower");
	info = scree_scene_info_default();
	memset(info.title, 'x', sizeof info.title);
	REFUSED(SCREE_ERROR_INVALID, scree_scene_write_text(world, &info, "c.json", &text, &size), "has no 0 at its end");
	REFUSED(SCREE_ERROR_INVALID, scree_scene_get_names(NULL, NULL, 0, &count), "scene is null");
	scene = load(level);
	REFUSED(SCREE_ERROR_INVALID, scree_scene_get_bodies(scene, "lnk", NULL, 0, &count), "\"lnk\" is not the name");
	REFUSED(SCREE_ERROR_INVALID, scree_scene_get_bodies(scene, "", NULL, 0, &count), "is not the name");
	REFUSED(SCREE_ERROR_INVALID, scree_scene_set_keys(scene, 1u << 30), "has bits that are no keys");
	REFUSED(SCREE_ERROR_INVALID, scree_scene_step(NULL), "scene is null");
	scree_scene_destroy(scene);
	scree_fail_hook_set(NULL, NULL);
	scree_world_destroy(world);
}

// Checks worlds with values that no scene file has: a body that fell out of the world, and another unit of length.
static void test_beyond(void** state)
{
	(void)state;
	scree_world* world = open_world(-10.0f);
	scree_body body;
	char* text;
	size_t size;
	OK(scree_body_create_box(world, SCREE_BODY_DYNAMIC, pose_at(0.0f, -99999.0f, 0.0f), 0.5f, 0.5f, 0, &body));
	OK(scree_body_set_velocity(world, body, (scree_velocity){{0.0f, -400.0f}, 0.0f}));
	for (int k = 0; k < 30; ++k)
		OK(scree_world_step(world, 1.0f / 60.0f, 4));
	assert_int_equal(scree_scene_write_text(world, NULL, "d.json", &text, &size), SCREE_ERROR_INVALID);
	assert_non_null(strstr(scree_error(), "d.json: bodies[0].position[1]: -100"));
	assert_non_null(strstr(scree_error(), "must be at least -100000 in a scene file"));
	scree_world_destroy(world);
	scree_world_def def = scree_world_def_default();
	def.device = "cpu";
	def.length_unit = 100.0f;
	OK(scree_world_create(&def, &world));
	assert_int_equal(scree_scene_write_text(world, NULL, "d.json", &text, &size), SCREE_ERROR_INVALID);
	assert_non_null(strstr(scree_error(), "the length_unit of the world is 100, must be 1"));
	scree_world_destroy(world);
}

static void read_whole(const char* path, char* to, size_t size)
{
	FILE* file = fopen(path, "r");
	assert_non_null(file);
	to[fread(to, 1, size - 1, file)] = 0;
	fclose(file);
}

// Checks that a file is complete or as it was.
static void test_files(void** state)
{
	(void)state;
	scree_world* world = open_world(-10.0f);
	char before[4096], after[4096];
	struct stat found;
	OK(scree_scene_write(world, NULL, SCRATCH));
	read_whole(SCRATCH, before, sizeof before);
	assert_non_null(strstr(before, "\"name\": \"test_scene_library_scratch\""));
	scree_scene* scene;
	OK(scree_scene_load(SCRATCH, NULL, &scene));
	scree_scene_destroy(scene);
	// a failure of the world leaves the file
	scree_world_def def = scree_world_def_default();
	scree_world* pixels;
	def.device = "cpu";
	def.length_unit = 64.0f;
	OK(scree_world_create(&def, &pixels));
	assert_int_equal(scree_scene_write(pixels, NULL, SCRATCH), SCREE_ERROR_INVALID);
	read_whole(SCRATCH, after, sizeof after);
	assert_string_equal(before, after);
	scree_world_destroy(pixels);
	assert_int_not_equal(stat(SCRATCH ".part", &found), 0);
#ifndef _WIN32
	// a link stays a link, and its file is replaced
	assert_int_equal(symlink(SCRATCH, SCRATCH ".link"), 0);
	OK(scree_body_create_box(world, SCREE_BODY_STATIC, pose_at(0.0f, 0.0f, 0.0f), 1.0f, 1.0f, 0, NULL));
	OK(scree_scene_write(world, NULL, SCRATCH ".link"));
	assert_int_equal(lstat(SCRATCH ".link", &found), 0);
	assert_true(S_ISLNK(found.st_mode));
	read_whole(SCRATCH, after, sizeof after);
	assert_non_null(strstr(after, "\"type\": \"static\""));
	remove(SCRATCH ".link");
	// a full device
	if (access("/dev/full", W_OK) == 0)
	{
		assert_int_equal(scree_scene_write(world, NULL, "/dev/full"), SCREE_ERROR_FILE);
		assert_non_null(strstr(scree_error(), "/dev/full: cannot be written: No space left"));
	}
	// the file of another user; root may write all files
	if (geteuid() != 0)
	{
		assert_int_equal(chmod(SCRATCH, 0400), 0);
		assert_int_equal(scree_scene_write(world, NULL, SCRATCH), SCREE_ERROR_FILE);
		assert_non_null(strstr(scree_error(), "Permission denied"));
	}
#endif
	remove(SCRATCH);
	scree_world_destroy(world);
}

// Checks numbers in a program whose locale has a comma for the point.
static void test_locale(void** state)
{
	(void)state;
	static const char* const names[] = {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8", "nl_NL.UTF-8", "de_DE"};
	const char* found = NULL;
	for (size_t k = 0; k < sizeof names / sizeof *names && !found; ++k)
		found = setlocale(LC_NUMERIC, names[k]);
	if (!found)
		skip();
	scree_world* world = open_world(-10.0f);
	OK(scree_body_create_box(world, SCREE_BODY_STATIC, pose_at(0.1f, 1e-9f, 0.0f), 1.5f, 1.0f, 0, NULL));
	char* text;
	scree_scene* scene = round_trip(world, &text);
	check_same_hash(found, world, scree_scene_get_world(scene));
	scree_scene_destroy(scene);
	scree_scene_free_text(text);
	scree_world_destroy(world);
	const char expression[] =
	    "{\"name\": \"x\", \"title\": \"y\", \"attributes\": {\"a\": {\"circle\": \"0.5 * 1.5\"}}}";
	scene = load(expression);
	scree_scene_destroy(scene);
	setlocale(LC_NUMERIC, "C");
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(test_game),  cmocka_unit_test(test_all_objects), cmocka_unit_test(test_special_worlds),
	    cmocka_unit_test(test_sleep), cmocka_unit_test(test_refusals),    cmocka_unit_test(test_beyond),
	    cmocka_unit_test(test_files), cmocka_unit_test(test_locale),
	};
	return cmocka_run_group_tests(tests, NULL, memory_is_released);
}
