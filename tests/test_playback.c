// SPDX-License-Identifier: MIT
// test_playback.c -- checks the recording of the viewer without a window: its steps and its end, differences, and a time line over
// a step that fails.
#include "scene/load.h"
#include "support/change_call.h"
#include "support/make_bodies.h"
#include "support/recordings.h"
#include "view/window/past.h"
#include "view/window/playback.h"

#define FILE_NAME "test_playback.rec"
#define STEPS     9

// Records steps of different lengths: a crate is created before step 4, and pushed before step 6. hashes: null, or those of the
// world before the first step, and after each step.
static Saved record(uint64_t* hashes)
{
	scree_world* world = open_world(-10.0f);
	scree_body crate = SCREE_NULL_BODY;
	add_floor(world);
	add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 1.0f);
	record_hashes(world);
	for (int step = 1; step <= STEPS; ++step)
	{
		if (hashes)
			hashes[step - 1] = hash_of(world);
		if (step == 4)
			crate = add_crate(world, SCREE_BODY_DYNAMIC, 0.2f, 3.0f);
		if (step == 6)
			OK(scree_body_apply_impulse(world, crate, (scree_vec){1.0f, 2.0f}));
		OK(scree_world_step(world, step == 2 ? 0.5f * STEP : step == 3 ? 0.0f : STEP, step == 2 ? 2 : SUBSTEPS));
	}
	if (hashes)
		hashes[STEPS] = hash_of(world);
	OK(scree_world_set_gravity(world, (scree_vec){0.0f, 5.0f}));
	OK(scree_world_end_recording(world));
	Saved saved = recording_of(world);
	scree_world_destroy(world);
	return saved;
}

typedef struct
{
	Playback playback;
	Scene* scene;
	ScenePlayer player;
} Shown;

// Writes a recording into a file, opens it, and frees its bytes.
static void show(Saved saved, Shown* shown)
{
	char sentence[SENTENCE] = "";
	FILE* file = fopen(FILE_NAME, "wb");
	assert_non_null(file);
	assert_int_equal(fwrite(saved.bytes, 1, saved.size, file), saved.size);
	fclose(file);
	free(saved.bytes);
	shown->scene = playback_open(&shown->playback, FILE_NAME, sentence);
	assert_string_equal(sentence, "");
	const scree_world_def def = def_on("cpu", 1, 0);
	OK(playback_create_world(&shown->playback, shown->scene, &def, &shown->player));
	remove(FILE_NAME);
}

static void step(Shown* shown) { OK(playback_step(&shown->playback, shown->scene, &shown->player)); }

static void hide(Shown* shown)
{
	player_close(&shown->player);
	scene_free(shown->scene);
	playback_close(&shown->playback);
}

static void steps_are_those_of_the_recording(void** state)
{
	(void)state;
	uint64_t hashes[STEPS + 1];
	Shown shown;
	char sentence[SENTENCE];
	show(record(hashes), &shown);
	assert_string_equal(shown.scene->name, FILE_NAME);
	assert_non_null(strstr(shown.scene->title, "a recording of 9 steps by version"));
	assert_true(hash_of(shown.player.world) == hashes[0]);
	for (int k = 1; k <= STEPS; ++k)
	{
		step(&shown);
		assert_true(hash_of(shown.player.world) == hashes[k]);
		assert_int_equal(shown.player.steps, k);
		assert_true(shown.scene->dt == (k == 2 || k == 3 ? 0.5f * STEP : STEP)); // a step of 0 s keeps that of step 2
		assert_int_equal(shown.scene->substeps, k == 2 ? 2 : SUBSTEPS);
		assert_int_equal(shown.playback.changed, k == 4 || k == 6);
		assert_false(shown.playback.ended);
	}
	for (int k = 0; k < 2; ++k) // the call after the last step is repeated once
	{
		scree_vec gravity;
		step(&shown);
		OK(scree_world_get_gravity(shown.player.world, &gravity));
		assert_true(gravity.y == 5.0f);
		assert_true(shown.playback.ended && shown.player.steps == STEPS);
		assert_int_equal(shown.playback.changed, k == 0);
	}
	playback_write_end(&shown.playback, sentence);
	assert_string_equal(sentence, "the recording ends after 9 steps; hashes: 10, all equal");
	hide(&shown);
}

static void a_cut_recording_ends_early(void** state)
{
	(void)state;
	char sentence[SENTENCE];
	Saved saved = record(NULL);
	saved.size -= 60;
	Shown shown;
	show(saved, &shown);
	while (!shown.playback.ended)
		step(&shown);
	playback_write_end(&shown.playback, sentence);
	assert_non_null(strstr(sentence, ", its end is missing after "));
	hide(&shown);
}

static Saved change(const char* call, int at_step, size_t at)
{
	Saved saved = record(NULL), copy = change_call(saved, call, at_step, at);
	free(saved.bytes);
	return copy;
}

// The first difference is kept, and the steps go on.
static void differences_are_kept(void** state)
{
	(void)state;
	const struct
	{
		const char* call;
		size_t at;
		const char* words;
	} cases[] = {{"body_apply_impulse", 10, "step 6: the hash is "}, {"body_apply_impulse", 4, "step 6: a call fails"}};
	for (int k = 0; k < 2; ++k)
	{
		Shown shown;
		char sentence[SENTENCE];
		show(change(cases[k].call, 6, cases[k].at), &shown);
		for (int n = 1; n <= STEPS; ++n)
		{
			step(&shown);
			assert_int_equal(shown.player.steps, n);
			assert_int_equal(*shown.playback.difference != 0, n >= 6);
		}
		assert_non_null(strstr(shown.playback.difference, cases[k].words));
		step(&shown);
		assert_true(shown.playback.ended);
		playback_write_end(&shown.playback, sentence);
		assert_non_null(strstr(sentence, "it differs: scree_replay_step: step 6: "));
		hide(&shown);
	}
}

static void go_to(Past* past, Shown* shown, int k)
{
	int64_t note = shown->player.steps;
	const void* reached;
	do
		OK(past_go(past, shown->player.world, k, &note, &reached));
	while (past->at != k);
	memcpy(&shown->player.steps, reached, sizeof shown->player.steps);
	assert_int_equal(shown->player.steps, k);
}

// A step that fails in the replay only, here for its number of substeps, is a step of the time line without effect.
static void a_failed_step_keeps_its_place(void** state)
{
	(void)state;
	uint64_t hashes[STEPS + 1];
	Shown shown;
	Past past;
	show(change("world_step", 7, 7), &shown);
	past_begin(&past, shown.player.world, &shown.player.steps, sizeof shown.player.steps);
	hashes[0] = hash_of(shown.player.world);
	for (int k = 1; k <= STEPS; ++k)
	{
		step(&shown);
		past_add(&past, shown.player.world, &shown.player.steps, 1.0);
		hashes[k] = hash_of(shown.player.world);
	}
	assert_non_null(strstr(shown.playback.difference, "step 7: a call fails"));
	assert_true(hashes[6] == hashes[7] && hashes[7] != hashes[8]);
	for (int k = STEPS; k >= 0; --k)
	{
		go_to(&past, &shown, k);
		assert_true(hash_of(shown.player.world) == hashes[k]);
	}
	for (int k = 1; k <= STEPS; ++k)
	{
		go_to(&past, &shown, k);
		assert_true(hash_of(shown.player.world) == hashes[k]);
	}
	past_close(&past, shown.player.world);
	hide(&shown);
}

static void other_files_are_refused(void** state)
{
	(void)state;
	Playback playback;
	char sentence[SENTENCE];
	assert_null(playback_open(&playback, "nowhere.rec", sentence));
	assert_string_equal(sentence, "cannot read nowhere.rec: No such file or directory");
	playback_close(&playback);
	FILE* file = fopen(FILE_NAME, "wb");
	assert_non_null(file);
	fputs("no recording", file);
	fclose(file);
	assert_null(playback_open(&playback, FILE_NAME, sentence));
	assert_non_null(strstr(sentence, "scree_replay_open: these 12 bytes are not a recording"));
	playback_close(&playback);
	remove(FILE_NAME);
	assert_int_equal(scree_memory(), 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(steps_are_those_of_the_recording),
	    cmocka_unit_test(a_cut_recording_ends_early),
	    cmocka_unit_test(differences_are_kept),
	    cmocka_unit_test(a_failed_step_keeps_its_place),
	    cmocka_unit_test(other_files_are_refused),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
