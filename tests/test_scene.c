// SPDX-License-Identifier: MIT
// test_scene.c -- checks the worlds that are built from scene files, churn, settings, and all scenes of the repository.
#include "scene/build.h"
#include "scene/churn.h"
#include "scene/controls.h"
#include "scene/find.h"
#include "scene/heading.h"
#include "scene/load.h"
#include "support/make_bodies.h"
#include "support/scene_text.h"
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define SCRATCH "test_scene_scratch.json"

static void test_missing_file(void** state)
{
	(void)state;
	char sentence[SCENE_SENTENCE];
	assert_null(scene_load("no/such/scene.json", NULL, 0, sentence));
	assert_string_equal(sentence, "no/such/scene.json: No such file or directory");
	assert_null(scene_load("/", NULL, 0, sentence));
	assert_string_equal(sentence, "/: is a folder");
}

static void test_settings(void** state)
{
	(void)state;
	const char* text = HEAD "\"parameters\": {\"n\": {\"default\": 2, \"min\": 1, \"max\": 9, \"integer\": true}}, "
	                        "\"attributes\": {\"a\": {\"circle\": 1}}, "
	                        "\"bodies\": [{\"attribute\": \"a\", \"repeat\": {\"index\": \"i\", \"to\": \"n * n\"}}]}";
	const struct
	{
		SceneSetting setting;
		const char* sentence; // expected message; null if the setting is valid
	} cases[] = {
	    {{"n", "3"}, NULL},
	    {{"n", "2 * 4"}, NULL},
	    {{"n", "0"}, "--set n=0: must be at least 1"},
	    {{"n", "10"}, "--set n=10: must be at most 9"},
	    {{"n", "2.5"}, "--set n=2.5: must be a whole number"},
	    {{"n", "nan"}, "--set n=nan: nan is no parameter"},
	    {{"n", "1/0"}, "--set n=1/0: division by zero"},
	    {{"m", "1"}, "no parameter \"m\" to set; there are n"},
	};
	for (size_t k = 0; k < sizeof cases / sizeof cases[0]; ++k)
	{
		char sentence[SCENE_SENTENCE] = "";
		Scene* scene = load_text(SCRATCH, text, &cases[k].setting, 1, sentence);
		if (!!scene == !!cases[k].sentence || (cases[k].sentence && !strstr(sentence, cases[k].sentence)))
			fail_msg("%s=%s: \"%s\"", cases[k].setting.name, cases[k].setting.value, sentence);
		if (k == 0)
			assert_int_equal(scene->body_count, 9);
		scene_free(scene);
	}
}

static void test_shipped(void** state)
{
	(void)state;
	const struct
	{
		const char* name;
		int bodies, collidables, joints;
	} cases[] = {
	    {"pyramid", 5051, 5051, 0},       {"pyramids", 22020, 22020, 0},
	    {"pile", 2003, 2003, 0},          {"tumbler", 2026, 2029, 0},
	    {"smash", 9601, 9601, 0},         {"dominoes", 661, 661, 0},
	    {"billiards", 305, 305, 0},       {"slope", 21, 21, 0},
	    {"washer", 2570, 2641, 0},        {"shapes", 140, 140, 0},
	    {"million", 1000112, 1000112, 0}, {"storm", 20457, 20513, 0},
	    {"drift", 2504, 2504, 0},         {"churn", 50004, 50004, 0},
	    {"bridge", 142, 142, 61},         {"ragdolls", 683, 683, 600},
	    {"cars", 344, 344, 48},           {"wrecking-ball", 210, 210, 17},
	    {"cloth", 1801, 1801, 3521},      {"chains", 648, 648, 648},
	    {"windmill", 863, 905, 21},       {"machine", 184, 216, 224},
	    {"gears", 51, 719, 91},           {"coaster", 13, 21, 20},
	    {"pond", 2028, 2048, 0},          {"blast", 730, 730, 0},
	    {"lidar", 1941, 1951, 0},         {"platformer", 58, 58, 4},
	    {"platforms", 279, 279, 0},       {"city", 4153, 4153, 1308},
	    {"alarm-clock", 170, 198, 32},    {"walker", 12, 12, 6},
	    {"cart-pole", 3, 5, 2},           {"lander", 13, 15, 2},
	    {"gripper", 12, 15, 4},           {"pusher", 12, 12, 1},
	};
	char **names, missing[SCENE_SENTENCE];
	int count = scene_list(NULL, &names, missing);
	assert_int_equal(count, sizeof cases / sizeof cases[0]);
	for (int k = 0; k < count; ++k)
	{
		char path[SCENE_PATH], sentence[SCENE_SENTENCE], title[160], parameters[256];
		size_t n = 0;
		while (n < sizeof cases / sizeof cases[0] && strcmp(cases[n].name, names[k]) != 0)
			++n;
		assert_true(n < sizeof cases / sizeof cases[0]);
		assert_true(scene_find(names[k], NULL, path, sentence));
		assert_true(scene_heading(path, title, sizeof title, parameters, sizeof parameters, sentence));
		Scene* scene = scene_load(path, NULL, 0, sentence);
		if (!scene)
			fail_msg("%s", sentence);
		assert_string_equal(scene->name, names[k]);
		assert_string_equal(scene->title, title);
		assert_int_equal(scene->body_count, cases[n].bodies);
		assert_int_equal(scene->collidable_count, cases[n].collidables);
		assert_int_equal(scene->joint_count, cases[n].joints);
		assert_true(scene->has_view);
		scene_free(scene);
		free(names[k]);
	}
	free(names);
}

// Ten million boxes stay within 5 km of the origin, and a city of ten million bodies within 8 km. There floats are 0.5 mm
// apart.
static void test_ten_million(void** state)
{
	(void)state;
	skip_if_quick();
	char path[SCENE_PATH], sentence[SCENE_SENTENCE];
	const struct
	{
		const char* name;
		SceneSetting settings[2];
		int count, least; // number of settings, and least number of bodies
		float far;        // m
	} cases[] = {{"pyramids", {{"columns", "426"}, {"rows", "427"}}, 2, 10000000, 5000},
	             {"city", {{"bodies", "10000000"}}, 1, 9800000, 8000}};
	for (size_t k = 0; k < sizeof cases / sizeof cases[0]; ++k)
	{
		assert_true(scene_find(cases[k].name, NULL, path, sentence));
		Scene* scene = scene_load(path, cases[k].settings, cases[k].count, sentence);
		assert_non_null(scene);
		assert_true(scene->body_count > cases[k].least);
		assert_true(scene->view.lower.x > -cases[k].far && scene->view.lower.y > -cases[k].far);
		scene_free(scene);
	}
}

// Checks that a scene may have as many bodies as a world.
static void test_most_bodies(void** state)
{
	(void)state;
	scree_world* world;
	scree_world_def def = scree_world_def_default();
	def.body_capacity = SCENE_MAX_BODIES + 1;
	assert_int_equal(scree_world_create(&def, &world), SCREE_ERROR_INVALID);
	assert_non_null(strstr(scree_error(), "is 16777217, must be from 0 to 16777216"));
	Scene* scene =
	    load_good_text(SCRATCH, HEAD GOOD_ATTRIBUTES
	                   "\"bodies\": [{\"attribute\": \"a\", \"repeat\": {\"index\": \"i\", \"to\": 16777216}}]}");
	assert_int_equal(scene->body_count, SCENE_MAX_BODIES);
	assert_int_equal(scene->world.body_capacity, SCENE_MAX_BODIES);
	scene_free(scene);
}

// Checks that bodies of the world have the values of the scene file.
static void test_build(void** state)
{
	(void)state;
	const char* text = HEAD
	    "\"parameters\": {\"n\": {\"default\": 3}}, \"world\": {\"gravity\": [1, \"-n\"]}, " GOOD_ATTRIBUTES
	    "\"bodies\": ["
	    "{\"type\": \"static\", \"attribute\": \"b\", \"position\": [0, -5]},"
	    "{\"attribute\": [\"a\", \"b\"], \"choose\": \"j\", \"position\": [\"10 * i\", \"20 * j\"],"
	    " \"velocity\": [\"i\", 2], \"repeat\": [{\"index\": \"i\", \"to\": \"n\"}, {\"index\": \"j\", \"to\": 2}]},"
	    "{\"type\": \"kinematic\", \"angular_velocity\": 0.5, \"position\": [-20, 0], \"collidables\": ["
	    " {\"attribute\": \"b\", \"position\": [\"k\", 0], \"repeat\": {\"index\": \"k\", \"to\": 3}},"
	    " {\"attribute\": \"a\", \"group\": -2, \"category\": [3], \"mask\": [0, 63]}]}],"
	    "\"collidables\": [{\"attribute\": \"a\", \"position\": [50, 0]}]}";
	ScenePlayer player = open_text(SCRATCH, text);
	scree_world* world = player.world;
	scree_counters counters = counters_of(world);
	assert_int_equal(counters.bodies, 8);
	assert_int_equal(counters.dynamic_bodies, 6);
	assert_int_equal(counters.collidables, 12);
	assert_int_equal(counters.attributes, 2);
	scree_vec gravity;
	OK(scree_world_get_gravity(world, &gravity));
	assert_true(gravity.x == 1 && gravity.y == -3);

	scree_body bodies[8];
	scree_pose poses[8];
	scree_velocity velocities[8];
	scree_collidable collidables[8];
	scree_filter filter;
	scree_body_type type;
	int count;
	OK(scree_world_get_bodies(world, bodies, 8, &count));
	OK(scree_bodies_get_poses(world, bodies, poses, 8));
	OK(scree_bodies_get_velocities(world, bodies, velocities, 8));
	// the last of the six bodies has i = 2, j = 1
	assert_true(poses[6].position.x == 20 && poses[6].position.y == 20);
	assert_true(velocities[6].linear.x == 2 && velocities[6].linear.y == 2);
	assert_true(velocities[7].angular == 0.5f);
	OK(scree_body_get_type(world, bodies[7], &type));
	assert_int_equal(type, SCREE_BODY_KINEMATIC);
	OK(scree_body_get_collidables(world, bodies[7], collidables, 8, &count));
	assert_int_equal(count, 4);
	OK(scree_collidable_get_local_pose(world, collidables[2], &poses[0]));
	assert_true(poses[0].position.x == 2);
	OK(scree_collidable_get_filter(world, collidables[3], &filter));
	assert_true(filter.group == -2 && filter.category == 8 && filter.mask == 0x8000000000000001u);
	OK(scree_body_get_collidables(world, (scree_body){0, 0}, collidables, 8, &count));
	assert_int_equal(count, 1);
	close_text(&player);
}

// The end of the inner range is random, from 1 to 3, in each of 12 rounds. The world must have as many bodies as the
// loaded scene counts, between 12 and 36.
static void test_random_ranges(void** state)
{
	(void)state;
	const char* text = HEAD GOOD_ATTRIBUTES
	    "\"bodies\": [{\"name\": \"n\", \"attribute\": \"a\", \"repeat\": [{\"index\": \"i\", \"to\": 12},"
	    " {\"index\": \"j\", \"to\": \"floor(random(1, 4))\"}]}]}";
	ScenePlayer player = open_text(SCRATCH, text);
	scree_world* world = player.world;
	int count = 0;
	assert_int_equal(scree_world_get_bodies(world, NULL, 0, &count), SCREE_OK);
	assert_int_equal(count, player.scene->body_count);
	assert_true(count > 12 && count < 36);
	close_text(&player);
}

// Checks that joints connect the bodies that the scene names, and have the values of the scene or the defaults of their
// type.
static void test_joints(void** state)
{
	(void)state;
	const char* text = HEAD GOOD_ATTRIBUTES
	    "\"bodies\": [{\"attribute\": \"b\", \"type\": \"static\", \"position\": [0, -50]},"
	    "{\"name\": \"link\", \"attribute\": \"a\", \"position\": [\"10 * i\", 20], \"angle\": \"pi / 2\","
	    " \"repeat\": {\"index\": \"i\", \"to\": 4}, \"group\": \"-i - 1\"}],"
	    "\"joints\": [{\"type\": \"wheel\", \"a\": {\"body\": \"link\", \"index\": \"i\"}, \"b\": {\"body\": \"link\", "
	    "\"index\": \"i + 1\"}, \"repeat\": {\"index\": \"i\", \"to\": 3}, \"at\": [\"10 * i + 4\", 23], \"axis\": "
	    "\"pi / 2\","
	    " \"along\": {\"limits\": [-1, \"i\"], \"spring\": {\"hertz\": 4, \"push\": 5, \"pull\": \"i\"}}, \"angle\": "
	    "{\"motor\": {\"speed\": 5, "
	    "\"max\": \"i\"}},"
	    " \"hertz\": 30, \"can_break\": true, \"force_threshold\": \"100 + i\", \"collide_connected\": true, "
	    "\"disabled\": true, \"elliptic\": true},"
	    "{\"type\": \"distance\", \"a\": {\"body\": \"link\", \"index\": 2}, \"b\": null, \"at\": [20, 20], \"to\": "
	    "[23, 24]},"
	    "{\"type\": \"weld\", \"a\": null, \"b\": {\"body\": \"link\", \"index\": 3}, \"frame_b\": {\"position\": [1, "
	    "2], "
	    "\"angle\": \"pi / 2\"}, \"angle\": {\"locked\": false, \"target\": 0.5}, \"across\": {\"lock\": {\"hertz\": "
	    "7}}}]}";
	ScenePlayer player = open_text(SCRATCH, text);
	scree_world* world = player.world;
	scree_joint joints[5];
	scree_joint_def defs[5];
	scree_body bodies[5];
	int count;
	assert_int_equal(player.scene->joint_count, 5);
	OK(scree_world_get_joints(world, joints, 5, &count));
	assert_int_equal(count, 5);
	OK(scree_world_get_bodies(world, bodies, 5, &count));
	for (int k = 0; k < 5; ++k)
		OK(scree_joint_get_def(world, joints[k], &defs[k]));

	// joint of the wheel at i = 2: both bodies and the axis are turned by 90 degrees, so that x in a body is y in the
	// world
	const scree_joint_def* d = &defs[2];
	const scree_joint_coordinate *along = &d->coordinates[SCREE_ALONG], *angle = &d->coordinates[SCREE_ANGLE];
	assert_int_equal(d->type, SCREE_JOINT_WHEEL);
	assert_true(scree_body_equals(d->body_a, bodies[3]) && scree_body_equals(d->body_b, bodies[4]));
	assert_true(fabsf(d->frame_a.position.x - 3) < 1e-5f && fabsf(d->frame_a.position.y + 4) < 1e-5f);
	assert_true(fabsf(d->frame_b.position.x - 3) < 1e-5f && fabsf(d->frame_b.position.y - 6) < 1e-5f);
	assert_true(d->frame_a.rotation.c > 0.999999f && d->frame_b.rotation.c > 0.999999f);
	assert_true(along->limited && along->lower == -1 && along->upper == 2);
	assert_true(along->spring && along->spring_hertz == 4 && along->spring_damping_ratio == 0.7f);
	assert_true(d->coordinates[SCREE_ACROSS].locked && !along->locked && !along->motor);
	assert_true(angle->motor && angle->motor_speed == 5 && angle->motor_max == 2 && !angle->limited);
	assert_true(d->hertz == 30 && d->damping_ratio == 2 && d->can_break && d->force_threshold == 102);
	assert_true(along->spring_push == 5 && along->spring_pull == 2 && along->spring_max == FLT_MAX);
	assert_true(d->collide_connected && !defs[3].collide_connected);
	assert_true(d->disabled && d->elliptic && !defs[3].disabled && !defs[3].elliptic);

	// 3 m apart in x and 4 m in y: a distance of 5 m
	assert_true(scree_body_is_null(defs[3].body_b));
	assert_true(defs[3].coordinates[SCREE_ALONG].target == 5 && defs[3].coordinates[SCREE_ALONG].locked);
	assert_true(defs[3].frame_b.position.x == 23 && defs[3].frame_b.position.y == 24);

	assert_true(scree_body_is_null(defs[4].body_a) && defs[4].frame_a.rotation.c == 1);
	assert_true(defs[4].frame_b.position.x == 1 && defs[4].frame_b.rotation.s > 0.999999f);
	assert_true(!defs[4].coordinates[SCREE_ANGLE].locked && defs[4].coordinates[SCREE_ANGLE].target == 0.5f);
	assert_true(defs[4].coordinates[SCREE_ACROSS].locked && defs[4].coordinates[SCREE_ACROSS].lock_hertz == 7);

	scree_collidable collidable;
	scree_filter filter;
	OK(scree_body_get_collidables(world, bodies[4], &collidable, 1, &count));
	OK(scree_collidable_get_filter(world, collidable, &filter));
	assert_int_equal(filter.group, -4);
	close_text(&player);
}

typedef struct // state of all 12 bodies at one step
{
	scree_body bodies[12];
	scree_pose poses[12];
	scree_velocity velocities[12];
} Bodies;

static Bodies read_bodies(scree_world* world)
{
	Bodies all;
	int count;
	OK(scree_world_get_bodies(world, all.bodies, 12, &count));
	assert_int_equal(count, 12);
	OK(scree_bodies_get_poses(world, all.bodies, all.poses, 12));
	OK(scree_bodies_get_velocities(world, all.bodies, all.velocities, 12));
	return all;
}

// Checks that a changed body has a pose and a velocity within the ranges of its churn, and the locks of its block.
static void check_changed(const scree_world* world, const Bodies* after, int k)
{
	uint32_t locks;
	scree_pose pose = after->poses[k];
	assert_true(pose.position.x > 1000 && pose.position.x < 2000 && pose.position.y == 7);
	assert_true(pose.rotation.s > 0.999f);
	assert_true(after->velocities[k].linear.y > -3 && after->velocities[k].linear.y < -1);
	OK(scree_body_get_locks(world, after->bodies[k], &locks));
	assert_int_equal(locks, SCREE_LOCK_ROTATION);
}

// Applies and checks the churn of one step: two bodies move, three are replaced, and each keeps its attribute. Adds 1
// to turns[k] for each changed body k.
static void check_step(const Scene* scene, scree_world* world, int step, int turns[12])
{
	Bodies before = read_bodies(world);
	OK(scene_churn(scene, world, step));
	Bodies after = read_bodies(world);
	int moved = 0, replaced = 0, count;
	for (int k = 0; k < 12; ++k)
	{
		scree_collidable part;
		scree_attribute attribute;
		scree_attribute_def surface;
		OK(scree_body_get_collidables(world, after.bodies[k], &part, 1, &count));
		OK(scree_collidable_get_attribute(world, part, &attribute));
		OK(scree_attribute_get_def(world, attribute, &surface));
		bool is_box = k == 0 || (k < 11 && k % 2 == 0);
		assert_int_equal(surface.shape.kind, is_box ? SCREE_SHAPE_POLYGON : SCREE_SHAPE_CIRCLE);
		bool other = before.bodies[k].generation != after.bodies[k].generation;
		bool changed = other || after.poses[k].position.x != before.poses[k].position.x;
		replaced += other;
		moved += changed && !other;
		turns[k] += changed;
		if (changed)
			check_changed(world, &after, k);
	}
	assert_int_equal(moved, 2);
	assert_int_equal(replaced, 3);
}

// Ten bodies with churn have attributes `a` and `b` in turn; the first and last of the 12 bodies have no churn. Before
// each step two of the ten are moved and three replaced. Each of the ten is changed equally often, keeps its index in
// the list and its attribute, and gets a pose within the ranges of the churn.
static void test_churn(void** state)
{
	(void)state;
	const char* text = HEAD
	    "\"attributes\": {\"a\": {\"circle\": 1}, \"b\": {\"box\": [2, 1]}}, \"world\": {\"gravity\": [0, 0]},"
	    "\"bodies\": [{\"type\": \"static\", \"attribute\": \"b\", \"position\": [0, -50]},"
	    "{\"attribute\": [\"a\", \"b\"], \"choose\": \"mod(i, 2)\", \"position\": [\"10 * i\", 0], \"locks\": "
	    "[\"rotation\"],"
	    " \"repeat\": {\"index\": \"i\", \"to\": 10}, \"churn\": {\"moved\": 2, \"replaced\": 3,"
	    " \"position\": [\"random(1000, 2000)\", 7], \"angle\": \"pi / 2\", \"velocity\": [0, \"random(-3, -1)\"]}},"
	    "{\"type\": \"kinematic\", \"attribute\": \"a\", \"position\": [0, 60]}]}";
	ScenePlayer player = open_text(SCRATCH, text);
	scree_world* world = player.world;
	assert_true(scene_churns(player.scene));
	int turns[12] = {0};
	for (int step = 0; step < 20; ++step)
		check_step(player.scene, world, step, turns);
	for (int k = 0; k < 12; ++k)
		assert_int_equal(turns[k], k == 0 || k == 11 ? 0 : 10);
	close_text(&player);
}

// If the scene enables contact details, a ball that lands reports its approach speed, 5 m/s.
static void test_contact_details(void** state)
{
	(void)state;
	for (int wanted = 0; wanted <= 1; ++wanted)
	{
		char text[512];
		snprintf(text, sizeof text,
		         HEAD "\"world\": {\"contact_details\": %s}, \"attributes\": {\"a\": {\"circle\": 1}, \"b\": {\"box\": "
		              "[9, 1]}}, \"bodies\": [{\"type\": \"static\", \"attribute\": \"b\", \"position\": [0, -1]},"
		              "{\"attribute\": \"a\", \"position\": [0, 1.01], \"velocity\": [0, -5]}]}",
		         wanted ? "true" : "false");
		ScenePlayer player = open_text(SCRATCH, text);
		scree_world* world = player.world;
		run_steps(world, 1);
		scree_contact contact;
		int count;
		OK(scree_world_get_contacts(world, &contact, 1, &count));
		assert_int_equal(count, 1);
		float speed = contact.details[0].approach_speed;
		assert_true(wanted ? fabsf(speed - 5.0f) < 0.2f : speed == 0.0f);
		close_text(&player);
	}
}

// Balls in the air fall unless they are asleep, and a ball is asleep only in a scene that sleeps. Balls that are replaced
// are awake. Thresholds and stays_awake arrive at the bodies.
static void test_sleep(void** state)
{
	(void)state;
	for (int sleeps = 0; sleeps <= 1; ++sleeps)
	{
		char text[640];
		snprintf(text, sizeof text,
		         HEAD
		         "\"world\": {\"sleep\": %s, \"sleep_threshold\": 0.25}, \"attributes\": {\"a\": {\"circle\": 1}}, "
		         "\"bodies\": [{\"attribute\": \"a\", \"asleep\": true, \"sleep_threshold\": \"0.5 * i\", "
		         "\"repeat\": {\"index\": \"i\", \"to\": 2}, \"position\": [\"9 * i\", 0]}, {\"attribute\": "
		         "\"a\", \"position\": [18, 0], \"stays_awake\": true}, {\"attribute\": \"a\", \"asleep\": true, "
		         "\"position\": [27, 0], \"churn\": {\"replaced\": 1, \"position\": [27, 90]}}]}",
		         sleeps ? "true" : "false");
		ScenePlayer player = open_text(SCRATCH, text);
		scree_world* world = player.world;
		scree_tuning tuning = {.size = sizeof tuning};
		OK(scree_world_get_tuning(world, &tuning));
		assert_true(tuning.sleep == sleeps && tuning.sleep_threshold == 0.25f);
		OK(player_step(&player));
		scree_body bodies[4];
		int count;
		OK(scree_world_get_bodies(world, bodies, 4, &count));
		assert_int_equal(count, 4);
		for (int k = 0; k < 4; ++k)
		{
			bool awake, stays;
			float threshold;
			OK(scree_body_get_awake(world, bodies[k], &awake));
			OK(scree_body_get_stays_awake(world, bodies[k], &stays));
			OK(scree_body_get_sleep_threshold(world, bodies[k], &threshold));
			assert_true(awake == (k > 1 || !sleeps) && stays == (k == 2) && threshold == (k == 1 ? 0.5f : 0.0f));
			float start = k == 3 ? 90.0f : 0.0f;
			assert_true((pose_of(world, bodies[k]).position.y < start) == awake);
		}
		close_text(&player);
	}
}

// A disabled body does not fall; an enabled one does.
static void test_disabled(void** state)
{
	(void)state;
	const char* text =
	    HEAD "\"attributes\": {\"a\": {\"circle\": 1}}, \"bodies\": [{\"attribute\": \"a\", \"disabled\": true},"
	         "{\"attribute\": \"a\", \"position\": [9, 0], \"disabled\": false}]}";
	ScenePlayer player = open_text(SCRATCH, text);
	scree_world* world = player.world;
	run_steps(world, 1);
	scree_body bodies[2];
	int count;
	OK(scree_world_get_bodies(world, bodies, 2, &count));
	for (int k = 0; k < 2; ++k)
	{
		assert_int_equal(scree_body_is_enabled(world, bodies[k]), k == 1);
		scree_pose pose = pose_of(world, bodies[k]);
		assert_int_equal(pose.position.y < 0, k == 1);
	}
	close_text(&player);
}

// Checks that fields of a scene, in the world and on bodies of a row, have the values of the scene. An explosion acts
// before its step.
static void test_fields(void** state)
{
	(void)state;
	ScenePlayer player = open_text(
	    SCRATCH, HEAD GOOD_ATTRIBUTES
	    "\"world\": {\"gravity\": [0, 0]}, \"bodies\": [{\"name\": \"row\", \"attribute\": \"a\", \"repeat\": "
	    "{\"index\": \"i\", "
	    "\"to\": 3}, \"position\": [\"10 * i\", 0]}], \"fields\": [{\"type\": \"drag\", \"body\": {\"body\": "
	    "\"row\", \"index\": \"i\"}, \"attribute\": \"b\", \"repeat\": {\"index\": \"i\", \"to\": 2}, \"position\": "
	    "[0, \"i + 2\"], \"linear_drag\": \"3 + i\"}, {\"type\": \"uniform\", \"acceleration\": [0, 6], "
	    "\"mask\": [3]}], \"blasts\": [{\"step\": 4, \"position\": [-2, 0], \"radius\": 3, \"falloff\": 0, "
	    "\"impulse\": 5}]}");
	scree_world* world = player.world;
	scree_field fields[4];
	scree_field_def def;
	scree_body bodies[4];
	scree_velocity v;
	int count;
	OK(scree_world_get_bodies(world, bodies, 4, &count));
	OK(scree_world_get_fields(world, fields, 4, &count));
	assert_int_equal(count, 3);
	OK(scree_field_get_def(world, fields[1], &def));
	assert_true(scree_body_equals(def.body, bodies[1]) && def.pose.position.y == 3 && def.linear_drag == 4);
	assert_true(def.shape.count == 4 && def.type == SCREE_FIELD_DRAG);
	OK(scree_field_get_def(world, fields[2], &def));
	assert_true(scree_body_is_null(def.body) && def.acceleration.y == 6 && def.mask == 8 && def.shape.count == 0);
	for (int step = 0; step < 6; ++step)
	{
		v = velocity_of(world, bodies[0]);
		assert_true((v.linear.x > 0) == (step > 4));
		OK(player_step(&player));
	}
	close_text(&player);
}

// While a key is down, it pushes its bodies by a torque or by a force that turns with the body. It does not push other
// bodies.
static void test_keys(void** state)
{
	(void)state;
	ScenePlayer player =
	    open_text(SCRATCH, HEAD GOOD_ATTRIBUTES
	              "\"world\": {\"gravity\": [0, 0]}, \"bodies\": [{\"attribute\": \"b\", \"position\": [0, 50]}, "
	              "{\"name\": \"car\", "
	              "\"attribute\": \"a\", \"angle\": \"pi / 2\", \"repeat\": {\"index\": \"i\", \"to\": 2}, "
	              "\"position\": [\"10 * i\", 0]}], "
	              "\"keys\": [{\"key\": \"up\", \"body\": \"car\", \"index\": 1, \"force\": [6, 0], \"turns\": true}, "
	              "{\"key\": \"left\", \"body\": \"car\", \"torque\": 3}]}");
	scree_world* world = player.world;
	scree_body bodies[3];
	scree_velocity v[3];
	int count;
	assert_int_equal(controls_keys(player.scene), 1u << SCENE_KEY_up | 1u << SCENE_KEY_left);
	OK(scree_world_get_bodies(world, bodies, 3, &count));
	uint32_t down[] = {0, 1u << SCENE_KEY_up, 1u << SCENE_KEY_left | 1u << SCENE_KEY_space};
	for (int k = 0; k < 3; ++k)
	{
		assert_int_equal(controls_apply(player.scene, world, down[k]), SCREE_OK);
		OK(scree_world_step(world, 0.1f, 4));
	}
	OK(scree_bodies_get_velocities(world, bodies, v, 3));
	// bodies are circles of radius 1 m: mass pi kg, inertia pi / 2 kg m^2
	assert_true(v[0].linear.x == 0 && v[0].linear.y == 0 && v[0].angular == 0);
	assert_true(v[1].linear.x == 0 && v[1].linear.y == 0);
	assert_true(fabsf(v[2].linear.y - 0.6f / 3.14159f) < 1e-4f && fabsf(v[2].linear.x) < 1e-4f);
	for (int k = 1; k < 3; ++k)
		assert_true(fabsf(v[k].angular - 0.6f / 3.14159f) < 1e-4f);
	// a key has no effect after its body is destroyed
	OK(scree_bodies_destroy(world, bodies + 1, 2));
	assert_int_equal(controls_apply(player.scene, world, down[1]), SCREE_OK);
	close_text(&player);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(test_joints),          cmocka_unit_test(test_missing_file), cmocka_unit_test(test_settings),
	    cmocka_unit_test(test_shipped),         cmocka_unit_test(test_most_bodies),  cmocka_unit_test(test_ten_million),
	    cmocka_unit_test(test_build),           cmocka_unit_test(test_churn),        cmocka_unit_test(test_disabled),
	    cmocka_unit_test(test_contact_details), cmocka_unit_test(test_fields),       cmocka_unit_test(test_keys),
	    cmocka_unit_test(test_random_ranges),   cmocka_unit_test(test_sleep),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
