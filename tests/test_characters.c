// SPDX-License-Identifier: MIT
// test_characters.c -- checks characters of scenes: control by keys and by a script, coins, belts, and the scene
// platformer.
#include "scene/scene_keys.h"
#include "support/make_bodies.h"
#include "support/scene_text.h"
#include "support/small_scenes.h"
#include <math.h>

#define SCRATCH "test_characters_scratch.json"
#define TOWN(more)                                                                                                    \
	"{\"name\": \"town\", \"title\": \"t\", \"world\": {\"gravity\": [0, -10]}, \"attributes\": {\"floor\": "         \
	"{\"box\": [50, 1]}, "                                                                                            \
	"\"belt\": {\"box\": [50, 1], \"tangent_speed\": 3}, \"hero\": {\"capsule\": [[0, -0.3], [0, 0.3]], \"radius\": " \
	"0.3}, "                                                                                                          \
	"\"coin\": {\"circle\": 0.2}}, \"bodies\": [{\"name\": \"hero\", \"type\": \"kinematic\", \"attribute\": "        \
	"\"hero\", "                                                                                                      \
	"\"position\": [0, 0.61]}, {\"name\": \"coin\", \"type\": \"static\", \"collidables\": [{\"attribute\": "         \
	"\"coin\", "                                                                                                      \
	"\"sensor\": 1}], \"repeat\": {\"index\": \"k\", \"to\": 3}, \"position\": [\"2 * k + 2\", 0.6]}, "               \
	"{\"type\": \"static\", \"attribute\": \"floor\", \"position\": [0, -1]}, "                                       \
	"{\"type\": \"static\", \"attribute\": \"belt\", \"position\": [0, 99]}], "                                       \
	"\"characters\": [{\"body\": \"hero\", \"takes\": \"coin\", \"speed\": 4, \"jump\": 5" more "}]}"

static scree_vec after(ScenePlayer* player, int steps, uint32_t down)
{
	player->down = down;
	for (int k = 0; k < steps; ++k)
		OK(player_step(player));
	return position_of(player->world, player->characters.bodies[0]);
}

#define KEY_BIT(name) (1u << SCENE_KEY_##name)

static void keys_move_it(void** state)
{
	(void)state;
	ScenePlayer town = open_text(SCRATCH, TOWN(""));
	assert_int_equal(characters_keys(town.scene), KEY_BIT(left) | KEY_BIT(right) | KEY_BIT(up) | KEY_BIT(down));
	scree_vec at = after(&town, 60, 0);
	NEAR(at.x, 0.0, 1e-6);
	NEAR(at.y, 0.61, 1e-3);
	at = after(&town, 60, KEY_BIT(right));
	NEAR(at.x, 4.0, 0.3);
	assert_int_equal(town.characters.state.taken, 2); // the coins at 2 m and 4 m
	at = after(&town, 60, KEY_BIT(right));
	NEAR(at.x, 8.0, 0.3);
	assert_int_equal(town.characters.state.taken, 3);
	at = after(&town, 120, KEY_BIT(left));
	NEAR(at.x, 0.4, 0.4);
	assert_int_equal(town.characters.state.taken, 3);

	// a key that stays down makes one jump
	float highest = 0.0f;
	for (int k = 0; k < 60; ++k)
		highest = fmaxf(highest, after(&town, 1, KEY_BIT(up)).y);
	NEAR(highest, 0.61 + 5.0 * 5.0 / 20.0, 0.1);
	NEAR(after(&town, 60, KEY_BIT(up)).y, 0.61, 1e-3);
	close_text(&town);
}

static void scripts_hold_keys(void** state)
{
	(void)state;
	ScenePlayer town =
	    open_text(SCRATCH, TOWN(", \"script\": [{\"step\": 10, \"hold\": [\"right\"]}, {\"step\": 70, \"hold\": []}]"));
	NEAR(after(&town, 10, 0).x, 0.0, 1e-6);
	NEAR(after(&town, 120, 0).x, 4.0, 0.4);
	close_text(&town);

	// the script ends when the user presses a key
	town = open_text(SCRATCH, TOWN(", \"script\": [{\"step\": 10, \"hold\": [\"right\"]}]"));
	after(&town, 10, KEY_BIT(left));
	scree_vec at = after(&town, 60, 0);
	assert_true(at.x < 0.0f && at.x > -1.0f);
	close_text(&town);
}

// A belt carries characters at its speed, and a character that jumps off keeps that speed.
static void belts_carry(void** state)
{
	(void)state;
	ScenePlayer town = open_text(SCRATCH, TOWN(""));
	OK(scree_body_set_enabled(town.world, town.characters.bodies[4], false)); // the belt takes the place of the floor
	OK(scree_body_set_pose(town.world, town.characters.bodies[5], (scree_pose){{0.0f, -1.0f}, {1.0f, 0.0f}}));
	after(&town, 30, 0);
	scree_vec from = after(&town, 1, 0), to = after(&town, 60, 0);
	NEAR(to.x - from.x, 3.0, 0.05);
	from = after(&town, 1, KEY_BIT(up));
	to = after(&town, 30, 0);
	assert_true(to.y > 1.0f && to.x - from.x > 0.5f);
	close_text(&town);
}

// A character with the key "push" pushes a crate at its speed; without the key it stops at the crate. Its body follows.
static void crates_are_pushed(void** state)
{
	(void)state;
	for (int k = 0; k < 2; ++k)
	{
		ScenePlayer town = open_text(SCRATCH, k == 0 ? TOWN("") : TOWN(", \"push\": 500"));
		scree_body crate = add_crate(town.world, SCREE_BODY_DYNAMIC, 3.0f, 0.5f);
		after(&town, 120, KEY_BIT(right));
		scree_vec at = after(&town, 60, KEY_BIT(right));
		NEAR(at.x, position_of(town.world, crate).x - 0.81, 0.02 + (k == 0 ? 0.0 : 4.0 / 60.0));
		NEAR(position_of(town.world, crate).x, k == 0 ? 3.0 : 12.3, 0.5);
		assert_int_equal(town.characters.state.taken, k == 0 ? 1 : 3);
		close_text(&town);
	}
}

static void the_scene_is_played(void** state)
{
	(void)state;
	Scenario scenario = small_scene("platformer");
	ScenePlayer player;
	OK(player_open(&player, scenario.context, &scenario.def));
	for (int step = 0; step < player.scene->steps; ++step)
		OK(player_step(&player));
	print_message("%d of 30 coins\n", player.characters.state.taken);
	assert_true(player.characters.state.taken >= 15);
	close_text(&player);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(keys_move_it),      cmocka_unit_test(scripts_hold_keys),   cmocka_unit_test(belts_carry),
	    cmocka_unit_test(crates_are_pushed), cmocka_unit_test(the_scene_is_played),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
