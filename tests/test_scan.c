// SPDX-License-Identifier: MIT
// test_scan.c -- checks the rays of scenes: their ends, their hits, the selection for pictures, and equal results on
// all devices.
#include "support/scene_text.h"
#include "support/small_scenes.h"
#include <string.h>

#define SCRATCH "test_scan_scratch.json"
#define RAYS(bodies, rays) \
	HEAD GOOD_ATTRIBUTES "\"world\": {\"gravity\": [0, 0]}, \"bodies\": [" bodies "], \"rays\": [" rays "]}"

static void ask(ScenePlayer* s, const scree_box* box, int most)
{
	if (!s->scan.scene)
		OK(scan_open(&s->scan, s->scene, s->world));
	OK(scan_aim(&s->scan, s->world, box, most));
	OK(scan_cast(&s->scan, s->world));
}

// Three rays over a quarter of a circle point at -45, 0 and 45 degrees; four rays over a full circle point at 180, 270,
// 0 and 90 degrees.
static void fans_are_even(void** state)
{
	(void)state;
	const Fan quarter = {.count = 3, .spread = (float)(PI / 2)}, around = {.count = 4, .spread = (float)(2 * PI)},
	          alone = {.count = 1, .angle = 0.5f, .spread = 1.0f};
	for (int k = 0; k < 3; ++k)
		NEAR(scree_rot_get_angle(fan_direction(&quarter, k)), (k - 1) * PI / 4, 1e-5);
	NEAR(fan_direction(&around, 0).c, -1, 1e-5);
	NEAR(fan_direction(&around, 1).s, -1, 1e-5);
	NEAR(fan_direction(&around, 2).c, 1, 1e-5);
	NEAR(fan_direction(&around, 3).s, 1, 1e-5);
	NEAR(scree_rot_get_angle(fan_direction(&alone, 0)), 0.5, 1e-5);
}

// A circle of radius 1 m at the origin is turned by 90 degrees, so its rays begin 0.5 m to the left. One ray hits the
// side of a box at y = 4; the other finds nothing in 6 m downward. Rays do not hit their own circle.
static void rays_begin_at_the_eye(void** state)
{
	(void)state;
	ScenePlayer s =
	    open_text(SCRATCH, RAYS("{\"type\": \"static\", \"attribute\": \"b\", \"position\": [0, 6]},"
	                            "{\"name\": \"eye\", \"attribute\": \"a\", \"angle\": \"pi / 2\"}",
	                            "{\"from\": \"eye\", \"position\": [0, 0.5], \"count\": 2, \"length\": 6}"));
	ask(&s, NULL, 0);
	assert_int_equal(s.scan.count, 2);
	NEAR(s.scan.rays[0].origin.x, -0.5, 1e-6);
	NEAR(s.scan.rays[0].translation.y, -6, 1e-5);
	assert_false(s.scan.found[0].hit);
	assert_true(s.scan.found[1].hit);
	NEAR(s.scan.found[1].point.x, -0.5, 1e-5);
	NEAR(s.scan.found[1].point.y, 4, 1e-5);
	NEAR(s.scan.found[1].fraction, 4.0 / 6.0, 1e-5);

	ScanSum sum = {0};
	scan_add(&s.scan, &sum);
	uint64_t once = sum.hash;
	assert_true(sum.rays == 2 && sum.hits == 1 && once != 0);
	scan_add(&s.scan, &sum);
	assert_true(sum.rays == 4 && sum.hits == 2 && sum.hash != once);
	close_text(&s);
}

// Each fan casts rays at circles that it selects by mask or by kind. Each ray hits the nearest selected circle, or
// nothing if it meets none. A ray with a radius also hits a circle beside it.
static void fans_see_what_they_say(void** state)
{
	(void)state;
	ScenePlayer s = open_text(
	    SCRATCH,
	    RAYS("{\"type\": \"static\", \"attribute\": \"a\", \"position\": [10, 0]},"
	         "{\"attribute\": \"a\", \"position\": [20, 0], \"category\": [3]},"
	         "{\"type\": \"kinematic\", \"attribute\": \"a\", \"position\": [30, 0]},"
	         "{\"attribute\": \"a\", \"position\": [40, 0], \"sensor\": 1}, {\"attribute\": \"a\", \"position\": [50, "
	         "1.5]}",
	         "{\"count\": 1, \"length\": 100}, {\"count\": 1, \"length\": 100, \"mask\": [3]},"
	         "{\"count\": 1, \"length\": 100, \"sees\": [\"kinematic\"]}, {\"count\": 1, \"length\": 100, \"sees\": "
	         "[\"sensors\"]},"
	         "{\"count\": 1, \"length\": 100, \"sees\": [\"free\"]},"
	         "{\"count\": 1, \"position\": [45, 0], \"length\": 10, \"radius\": 1}"));
	const float nearest[] = {9, 19, 29, 39};
	ask(&s, NULL, 0);
	assert_int_equal(s.scan.count, 6);
	for (int k = 0; k < 4; ++k)
		NEAR(s.scan.found[k].point.x, nearest[k], 1e-4);
	assert_false(s.scan.found[4].hit);
	assert_true(s.scan.found[5].hit);
	close_text(&s);
}

// 20 circles in a row, 10 m apart, each cast 64 rays of 4 m. A picture contains only rays in its view. If the view has
// more rays than the limit of the picture, the picture contains only every n-th of them.
static void pictures_take_some_in_view(void** state)
{
	(void)state;
	ScenePlayer s =
	    open_text(SCRATCH, RAYS("{\"name\": \"eye\", \"attribute\": \"a\", \"repeat\": {\"index\": \"i\", \"to\": 20}, "
	                            "\"position\": [\"10 * i\", 0]}",
	                            "{\"from\": \"eye\", \"count\": 64, \"length\": 4}"));
	const scree_box all = {{-1000, -10}, {1000, 10}}, five = {{-3, -1}, {43, 1}}, none = {{5000, 0}, {5001, 1}};
	ask(&s, NULL, 1);
	assert_int_equal(s.scan.count, 20 * 64);
	ask(&s, &all, 20 * 64);
	assert_int_equal(s.scan.count, 20 * 64);
	ask(&s, &five, 10000);
	assert_int_equal(s.scan.count, 5 * 64);
	ask(&s, &all, 200); // every eighth ray is drawn
	assert_int_equal(s.scan.count, 160);
	assert_int_equal(s.scan.in_view, 20 * 64);
	ask(&s, &five, 200); // every second ray is drawn
	assert_int_equal(s.scan.count, 160);
	ask(&s, &all, 1);
	assert_true(s.scan.count <= 1);
	ask(&s, &none, 200);
	assert_int_equal(s.scan.count, 0);
	close_text(&s);
}

// A body outside the space of queries casts no rays; the other bodies do.
static void far_bodies_cast_none(void** state)
{
	(void)state;
	ScenePlayer s =
	    open_text(SCRATCH, RAYS("{\"name\": \"eye\", \"attribute\": \"a\", \"repeat\": {\"index\": \"i\", \"to\": 2}, "
	                            "\"position\": [\"99900 * i\", 0], \"velocity\": [300, 0]}",
	                            "{\"from\": \"eye\", \"count\": 4, \"length\": 50}"));
	ask(&s, NULL, 0);
	assert_int_equal(s.scan.count, 8);
	run_steps(s.world, 60);
	ask(&s, NULL, 0);
	assert_int_equal(s.scan.count, 4);
	close_text(&s);
}

// A scene replaces bodies before each step. The new bodies cast as many rays as the bodies that they replace.
static void new_bodies_cast(void** state)
{
	(void)state;
	ScenePlayer s =
	    open_text(SCRATCH, RAYS("{\"attribute\": \"b\", \"position\": [0, 50]}, {\"name\": \"eye\", \"attribute\": "
	                            "\"a\", \"repeat\": {\"index\": \"i\", "
	                            "\"to\": 3}, \"position\": [\"10 * i\", 0], \"churn\": {\"replaced\": 2, "
	                            "\"position\": [\"random(0, 100)\", -20]}}",
	                            "{\"from\": \"eye\", \"count\": 5, \"length\": 100}"));
	for (int step = 0; step < 4; ++step)
	{
		OK(player_step(&s));
		ask(&s, NULL, 0);
		assert_int_equal(s.scan.count, 15);
		for (int k = 0; k < 15; ++k)
			assert_false(s.scan.found[k].inside); // no ray hits its own body
	}
	close_text(&s);
}

// ---------------------------------------------------------------------------------------------------------------
// all devices
// ---------------------------------------------------------------------------------------------------------------

static ScanSum sum;

static void scan_before(scree_world* world, int step, const void* context)
{
	(void)step, (void)context;
	OK(player_scan(player_of(world)));
	sum = player_of(world)->answered;
}

// Formula: hash of the results(device, lanes, threads) = hash of the results(cpu, 1, 1). Rays do not change the hash of
// the world.
static void answers_are_equal(void** state)
{
	(void)state;
	static Variant variants[MAX_VARIANTS];
	static uint64_t hashes[240], plain[240];
	int count = list_variants(variants);
	Scenario scenario = small_scene("lidar");
	scenario.steps = quick() ? 10 : 60;
	record(&scenario, &variants[0], plain, NULL);
	scenario.act = scan_before;
	ScanSum first = {0};
	for (int k = 0; k < count; ++k)
	{
		if (!variant_is_due(variants, count, k, 0))
			continue;
		record(&scenario, &variants[k], hashes, NULL);
		first = k == 0 ? sum : first;
		if (sum.hash != first.hash || sum.hits != first.hits)
			fail_msg("%s: the answers have another hash than those of %s", variants[k].name, variants[0].name);
		assert_memory_equal(hashes, plain, (size_t)scenario.steps * sizeof *hashes);
	}
	print_message("%d steps, %d rays, %d hits: %016llx\n", scenario.steps, (int)first.rays, (int)first.hits,
	              (unsigned long long)first.hash);
	assert_true(first.hits > 0 && first.hits < first.rays);
	scene_free((Scene*)scenario.context);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(fans_are_even),          cmocka_unit_test(rays_begin_at_the_eye),
	    cmocka_unit_test(fans_see_what_they_say), cmocka_unit_test(pictures_take_some_in_view),
	    cmocka_unit_test(far_bodies_cast_none),   cmocka_unit_test(new_bodies_cast),
	    cmocka_unit_test(answers_are_equal),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
