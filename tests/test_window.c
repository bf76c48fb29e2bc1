// SPDX-License-Identifier: MIT
// test_window.c -- checks parts of the viewer that need no window: events by frame, frame times, tuning of a world.
#include "support/make_worlds.h"
#include "view/window/event_queue.h"
#include "view/window/history.h"
#include "view/window/live_tuning.h"
#include "view/window/session.h"
#include <string.h>

#define ENTER     257 // key codes of GLFW
#define BACKSPACE 259
#define SHIFT     340

static void add_key(Events* events, int key, int action)
{
	events_add(events, (WindowEvent){.kind = EVENT_KEY, .key = key, .action = action});
}

static void add_letter(Events* events, unsigned letter)
{
	events_add(events, (WindowEvent){.kind = EVENT_LETTER, .letter = letter});
}

// Checks the events of the next frames. The text `expected` has a letter for each event (k key, l letter, m cursor, b
// button, w wheel) and a space between frames.
static void assert_frames(Events* events, const char* expected)
{
	char given[128];
	int length = 0;
	for (int frame = 0; frame < 20 && (frame == 0 || events_wait(events)); ++frame)
	{
		WindowEvent event;
		if (frame > 0)
			given[length++] = ' ';
		events_begin(events);
		while (events_take(events, &event))
			given[length++] = "klmbw"[event.kind];
	}
	given[length] = 0;
	assert_string_equal(given, expected);
}

static void typing_keeps_its_order(void** state)
{
	(void)state;
	Events events = {0};
	// letters and their keys come in one frame; a key for editing, ENTER, may follow in the same frame
	add_key(&events, 'A', 1);
	add_letter(&events, 'a');
	add_key(&events, 'A', 0);
	add_key(&events, SHIFT, 1);
	add_key(&events, 'B', 1);
	add_letter(&events, 'B');
	add_key(&events, ENTER, 1);
	add_key(&events, ENTER, 0);
	assert_frames(&events, "klkkklk k");
	// a letter after backspace comes in the next frame; otherwise backspace would delete it
	add_key(&events, BACKSPACE, 1);
	add_key(&events, BACKSPACE, 0);
	add_letter(&events, 'c');
	assert_frames(&events, "k k l");
	assert_frames(&events, "");
	events_close(&events);
}

static void buttons_come_alone(void** state)
{
	(void)state;
	Events events = {0};
	WindowEvent event;
	const WindowEvent down = {.kind = EVENT_BUTTON, .action = 1}, up = {.kind = EVENT_BUTTON};
	// the panel needs the cursor position before the button, and the button before typed letters
	for (int k = 0; k < 3; ++k)
		events_add(&events, (WindowEvent){.kind = EVENT_CURSOR, .x = 10.0 * k, .y = 5.0, .seconds = 0.25});
	events_add(&events, down);
	events_add(&events, up);
	add_letter(&events, '6');
	add_key(&events, ENTER, 1);
	events_add(&events, (WindowEvent){.kind = EVENT_WHEEL, .y = 1.0});
	events_begin(&events);
	assert_true(events_take(&events, &event));
	assert_true(event.kind == EVENT_CURSOR && event.x == 20.0 && event.seconds == 0.75); // successive moves are merged
	assert_false(events_take(&events, &event));
	assert_frames(&events, "b b lkw");
	// the queue keeps many events
	for (int k = 0; k < 1000; ++k)
	{
		events_add(&events, down);
		events_add(&events, up);
	}
	for (int k = 0; k < 2000; ++k)
	{
		events_begin(&events);
		assert_true(events_take(&events, &event));
		assert_int_equal(event.action, k % 2 == 0);
		assert_false(events_take(&events, &event));
	}
	assert_false(events_wait(&events));
	events_close(&events);
}

static void history_keeps_the_last_frames(void** state)
{
	(void)state;
	History h = {0};
	assert_true(history_top(&h) == 20.0f);
	history_frame(&h, 8.0f);
	assert_true(h.step[history_at(&h, 0)] < 0.0f); // negative: no step in this frame
	history_step(&h, 2.0f);
	history_step(&h, 4.0f);
	history_frame(&h, 9.0f);
	assert_true(h.step[history_at(&h, 1)] == 3.0f && h.frame[history_at(&h, 1)] == 9.0f);
	for (int k = 0; k < 1000; ++k)
		history_frame(&h, (float)k);
	assert_int_equal(h.count, HISTORY_FRAMES);
	assert_true(h.frame[history_at(&h, 0)] == 1000.0f - HISTORY_FRAMES);
	assert_true(h.frame[history_at(&h, HISTORY_FRAMES - 1)] == 999.0f);
	assert_true(history_top(&h) == 1000.0f);
	// a single long frame does not determine the scale of the graph
	h = (History){0};
	for (int k = 0; k < 100; ++k)
		history_frame(&h, k == 50 ? 4000.0f : 31.0f);
	assert_true(history_top(&h) == 50.0f);
}

static void tuning_changes_a_world_and_its_scene(void** state)
{
	(void)state;
	scree_world* world = open_world(-10.0f);
	Scene scene = {.dt = STEP, .substeps = 4};
	Tuning tuning, read;
	OK(tuning_read(&tuning, &scene, world));
	assert_false(tuning.changed);
	assert_true(tuning.gravity.y == -10.0f && tuning.substeps == 4);
	tuning.gravity = (scree_vec){3.0f, 0.5f};
	tuning.substeps = 9;
	tuning.solver.contact_hertz = 30.0f;
	OK(tuning_write(&tuning, &scene, world));
	OK(tuning_read(&read, &scene, world));
	assert_true(read.gravity.x == 3.0f && read.gravity.y == 0.5f && read.substeps == 9);
	assert_true(read.solver.contact_hertz == 30.0f);
	tuning.solver.contact_hertz = -1.0f;
	tuning.substeps = 2;
	assert_int_equal(tuning_write(&tuning, &scene, world), SCREE_ERROR_INVALID);
	assert_int_equal(scene.substeps, 9);
	scree_world_destroy(world);
}

// Settings of the tuning last over a restart of the scene. A fresh start of another scene resets them.
static void tuning_lasts_over_a_restart(void** state)
{
	(void)state;
	const ViewOptions options = {.scene = "pyramid", .device = "cpu", .threads = 1};
	Session session;
	char sentence[SCENE_SENTENCE];
	scree_vec gravity;
	assert_true(session_open(&session, &options, NULL, sentence));
	assert_int_equal(session.parameter_count, 1);
	assert_non_null(strstr(session.parameters[0].help, "1 to "));
	session.tuning.gravity.y = -2.0f;
	session.tuning.substeps = 7;
	session.tuning.changed = true;
	OK(tuning_write(&session.tuning, session.scene, session.player.world));
	assert_true(session_step(&session, sentence));
	assert_true(session_load(&session, session.name, false, sentence));
	OK(scree_world_get_gravity(session.player.world, &gravity));
	assert_true(gravity.y == -2.0f && session.scene->substeps == 7 && session.tuning.changed &&
	            session.player.steps == 0);
	assert_true(session_load(&session, "smash", true, sentence));
	OK(scree_world_get_gravity(session.player.world, &gravity));
	assert_true(gravity.y == 0.0f && !session.tuning.changed);
	// the list of scenes has the title of pyramid
	bool found = false;
	for (int k = 0; k < session.scene_count; ++k)
		if (strcmp(session.scenes[k], "pyramid") == 0)
			found = strcmp(session_title(&session, k), "A pyramid of boxes that must not topple") == 0;
	assert_true(found);
	session_close(&session);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(typing_keeps_its_order),        cmocka_unit_test(buttons_come_alone),
	    cmocka_unit_test(history_keeps_the_last_frames), cmocka_unit_test(tuning_changes_a_world_and_its_scene),
	    cmocka_unit_test(tuning_lasts_over_a_restart),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
