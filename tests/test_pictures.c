// SPDX-License-Identifier: MIT
// test_pictures.c -- checks contents of pictures: shades of bodies, a moving camera, the place of a detail.
#include "scene/detail.h"
#include "scene/shades.h"
#include "scene/sleepers.h"
#include "support/scene_text.h"
#include <math.h>
#include <string.h>

#define SCRATCH "test_pictures_scratch.json"

// The scene has bodies 1 to 11: one single body, five bodies with one attribute, and five bodies that choose between
// two attributes. The single body has the middle shade, 31. The five bodies with one attribute have shades from 0 to
// 62. The five bodies with a choice have shades from 62 / 4 to 3 * 62 / 4, rounded.
static void bodies_run_through_their_shades(void** state)
{
	(void)state;
	Scene* scene = load_good_text(
	    SCRATCH, HEAD GOOD_ATTRIBUTES
	    "\"bodies\": [{\"attribute\": \"a\"}, {\"attribute\": \"a\", \"repeat\": {\"index\": \"i\", \"to\": 5}}, "
	    "{\"attribute\": [\"a\", \"b\"], \"choose\": \"mod(i, 2)\", \"repeat\": {\"index\": \"i\", \"to\": 5}}]}");
	static const int expected[] = {31, 0, 16, 31, 47, 62, 16, 23, 31, 39, 47};
	ShadeWalk walk = {.scene = scene};
	for (uint32_t k = 0; k < 11; ++k)
		assert_int_equal(shade_next(&walk, k + 1), expected[k]);
	// a body that does not come from the scene, and a body without a scene, have the middle shade
	assert_int_equal(shade_next(&walk, 12), SHADE_MIDDLE);
	ShadeWalk none = {0};
	assert_int_equal(shade_next(&none, 3), SHADE_MIDDLE);
	scene_free(scene);
}

// Shades 0, 31 and 62 have the three colors of a palette, times a factor from 0.92 to 1.08. Palettes repeat: palette 8
// equals palette 0.
static void shades_have_three_colors(void** state)
{
	(void)state;
	const Shades shades = {{100, 0, 200}, {50, 100, 100}, {150, 200, 0}};
	const Color* ends[] = {&shades.first, &shades.middle, &shades.last};
	for (int place = 0; place < 3; ++place)
		for (uint32_t body = 0; body < 1000; ++body)
		{
			Color color = shades_color(&shades, place * SHADE_MIDDLE, body);
			assert_true(color.r >= (int)(0.92 * ends[place]->r) && color.r <= 1.08 * ends[place]->r);
			assert_true(color.g >= (int)(0.92 * ends[place]->g) && color.g <= 1.08 * ends[place]->g);
			assert_true(color.b >= (int)(0.92 * ends[place]->b) && color.b <= 1.08 * ends[place]->b);
		}
	Shades first = shades_of(0), again = shades_of(8), still = shades_of(-1);
	assert_memory_equal(&first, &again, sizeof first);
	assert_memory_equal(&still.first, &still.last, sizeof still.first);
}

// A picture reads which bodies are asleep, and only if the world sleeps. The color of a sleeping body is 0.4 times its own
// and 0.6 times that of the background.
static void sleepers_are_dim(void** state)
{
	(void)state;
	ScenePlayer player =
	    open_text(SCRATCH, HEAD GOOD_ATTRIBUTES
	              "\"world\": {\"sleep\": true}, \"bodies\": [{\"attribute\": \"a\"}, {\"attribute\": \"a\", "
	              "\"position\": [9, 0], \"asleep\": true}, {\"type\": \"static\", \"attribute\": \"a\"}]}");
	scree_body bodies[3];
	scree_tuning tuning;
	bool* awake = NULL;
	OK(player_step(&player));
	OK(sleepers_read(player.world, bodies, 3, &awake));
	assert_true(awake && awake[0] && !awake[1] && awake[2]);
	OK(scree_world_get_tuning(player.world, &tuning));
	tuning.sleep = false;
	OK(scree_world_set_tuning(player.world, &tuning));
	OK(sleepers_read(player.world, bodies, 3, &awake));
	assert_null(awake);
	close_text(&player);
	Color dim = shades_dim((Color){10, 100, 200}, (Color){250, 0, 50});
	assert_true(dim.r == 154 && dim.g == 40 && dim.b == 110);
}

// A camera moves from a view 100 m wide to a view 1 m wide. Halfway the view is 10 m wide, because the camera magnifies
// at a constant rate. The views at both ends are exact, except for rounding.
static void cameras_magnify_steadily(void** state)
{
	(void)state;
	const scree_box from = {{-50, -25}, {50, 25}}, to = {{9.5f, 4.75f}, {10.5f, 5.25f}};
	scree_box begin = viewport_between(from, to, 0), middle = viewport_between(from, to, 0.5),
	          end = viewport_between(from, to, 1);
	assert_true(begin.lower.x == -50 && begin.upper.x == 50 && begin.lower.y == -25 && begin.upper.y == 25);
	assert_true(fabsf(end.lower.x - 9.5f) < 1e-5f && fabsf(end.upper.y - 5.25f) < 1e-5f);
	assert_true(fabsf(middle.upper.x - middle.lower.x - 10) < 1e-4f &&
	            fabsf(middle.upper.y - middle.lower.y - 5) < 1e-4f);
	// one point of the world keeps its place in the picture: 10 m / 0.99 from the center of the first view
	float still = 10.0f / 0.99f;
	assert_true(fabsf((still - middle.lower.x) / 10 - (still + 50) / 100) < 1e-4f);
	// the camera moves at a constant speed if its view keeps its size
	const scree_box aside = {{50, -25}, {150, 25}};
	assert_true(fabsf(viewport_between(from, aside, 0.25).lower.x + 25) < 1e-3f);
}

// A square view of 10 m is 840 px wide in a picture of 1600x900. The detail of 2 m by 1 m gets the rest of the width
// without the margins: 1600 - 2 * 12 - 840 - 24 = 712 px. The detail is centered vertically.
static void details_fill_wide_pictures(void** state)
{
	(void)state;
	Scene* scene = load_good_text(SCRATCH, HEAD "\"view\": [0, 0, 10, 10], \"detail\": [4, 4, 6, 5], " GOOD_ATTRIBUTES
	                                            "\"bodies\": [{\"attribute\": \"a\"}]}");
	Detail detail;
	assert_true(detail_open(&detail, scene, 1600, 900));
	assert_true(detail.left == 876 && detail.width == 712 && detail.top == MARGIN && detail.height == 840);
	Viewport whole = viewport_show(detail.whole, 1600, 900), part = viewport_show(detail.part, 1600, 900);
	assert_true(fabs(whole.scale - 84) < 1e-3 && fabs(-whole.left * whole.scale - MARGIN) < 1e-2);
	assert_true(fabs(part.scale - 356) < 1e-2);
	assert_true(fabs((4 - part.left) * part.scale - 876) < 0.1 && fabs((6 - part.left) * part.scale - 876 - 712) < 0.1);
	assert_true(fabs((4.5 - part.bottom) * part.scale - (900 - BAND) / 2.0) < 0.1);
	detail_close(&detail);
	// a square picture has no space for a detail, and a scene may lack a detail
	assert_false(detail_open(&detail, scene, 900, 900));
	scene->has_detail = false;
	assert_false(detail_open(&detail, scene, 1600, 900));
	scene_free(scene);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(bodies_run_through_their_shades), cmocka_unit_test(sleepers_are_dim),
	    cmocka_unit_test(shades_have_three_colors),        cmocka_unit_test(cameras_magnify_steadily),
	    cmocka_unit_test(details_fill_wide_pictures),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
