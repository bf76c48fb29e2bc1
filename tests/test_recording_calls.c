// SPDX-License-Identifier: MIT
// test_recording_calls.c -- checks which calls a recording contains, that a replay repeats them, and that it names the first step
// that differs.
#include "support/change_call.h"
#include "support/recordings.h"
#include "support/second_device.h"
#include "world/world.h"
#include <stdio.h>

// ---------------------------------------------------------------------------------------------------------------
// replays
// ---------------------------------------------------------------------------------------------------------------

// Calls that fail are left out, and calls that another call makes are recorded once.
static void what_is_recorded(void** state)
{
	(void)state;
	scree_world* world = open_world(-10.0f);
	add_floor(world);
	scree_body crate = add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 1.0f);
	run_steps(world, 3);
	record_hashes(world);
	assert_int_equal(scree_world_record(world, NULL), SCREE_ERROR_INVALID);
	assert_int_equal(scree_world_step(world, -1.0f, 4), SCREE_ERROR_INVALID);
	scree_blast_def blast = scree_blast_def_default();
	int pushed;
	OK(scree_world_blast(world, &blast, &pushed)); // applies impulses by another recorded call
	assert_int_equal(pushed, 1);
	OK(scree_body_set_user(world, crate, 77));
	assert_int_equal(scree_body_set_user(world, SCREE_NULL_BODY, 78), SCREE_ERROR_STALE);
	const void* bytes;
	size_t size;
	OK(scree_world_snapshot(world, &bytes, &size));
	OK(scree_body_destroy(world, crate));
	run_steps(world, 2);
	OK(scree_world_restore(world, bytes, size));
	run_steps(world, 1);
	OK(scree_body_set_gravity_scale(world, crate, 0.5f));
	OK(scree_world_end_recording(world));
	assert_int_equal(scree_world_end_recording(world), SCREE_ERROR_INVALID);
	Saved saved = recording_of(world);
	scree_replay* replay;
	OK(scree_replay_open(saved.bytes, saved.size, &replay));
	scree_replay_info info = info_of(replay);
	assert_true(info.ended && info.steps == 3 && info.calls == 8 && info.hashes == 4 && info.read == saved.size);
	assert_true(info.step == 0 && info.call == 0 && info.dt == 0.0f && info.substeps == 0);
	assert_string_equal(info.version, scree_version());
	uint64_t hash = hash_of(world);
	assert_true(repeat_on(saved, def_on("cpu", 1, 0)) == hash);

	// the same on an existing world, twice; the last call of a replay also repeats the calls after the last step
	for (int k = 0; k < 2; ++k)
	{
		OK(scree_replay_restore(replay, world));
		OK(repeat_steps(replay, world));
		assert_true(hash_of(world) == hash);
		info = info_of(replay);
		assert_true(info.step == 3 && info.call == 8 && info.dt == STEP && info.substeps == SUBSTEPS);
		uint64_t user;
		OK(scree_body_get_user(world, crate, &user));
		assert_true(user == 77);
	}
	scree_replay_close(replay);
	scree_world_destroy(world);
	free(saved.bytes);
	assert_int_equal(scree_memory(), 0);
}

// A step beyond the contact limit changes nothing but the events; the recording goes on behind it.
static void failing_steps_are_kept(void** state)
{
	(void)state;
	scree_world_def def = def_on("cpu", 1, 0);
	def.contact_limit = 3;
	scree_world* world = create_world(&def);
	record_hashes(world);
	scree_body crates[6];
	for (int k = 0; k < 6; ++k)
		crates[k] = add_crate(world, SCREE_BODY_DYNAMIC, 0.1f * (float)k, 0.0f);
	assert_int_equal(scree_world_step(world, STEP, SUBSTEPS), SCREE_ERROR_CONTACT_LIMIT);
	assert_non_null(strstr(scree_error(), "contact"));
	for (int k = 2; k < 6; ++k)
		OK(scree_body_destroy(world, crates[k]));
	run_steps(world, 4);
	OK(scree_world_end_recording(world));
	Saved saved = recording_of(world);
	assert_true(repeat_on(saved, def_on("cpu", 2, 1)) == hash_of(world));
	scree_world_destroy(world);
	free(saved.bytes);
}

// Saves are made again in a replay; a load of a save from before the recording is a snapshot.
static void saves_are_repeated(void** state)
{
	(void)state;
	scree_world* world = open_pile("cpu", true);
	run_steps(world, 3);
	OK(scree_world_save(world, 0));
	run_steps(world, 3);
	record_hashes(world);
	OK(scree_world_save(world, 1));
	run_steps(world, 4);
	OK(scree_world_load(world, 0));
	run_steps(world, 2);
	OK(scree_world_load(world, 1));
	OK(scree_world_save(world, 0));
	run_steps(world, 2);
	OK(scree_world_load(world, 0));
	OK(scree_world_discard(world, 1));
	run_steps(world, 1);
	OK(scree_world_end_recording(world));
	Saved saved = recording_of(world);
	assert_true(repeat_on(saved, def_on("cpu", 2, 1)) == hash_of(world));
	assert_true(hash_of(world) == hash_after(7));
	scree_world_destroy(world);
	free(saved.bytes);
	assert_int_equal(scree_memory(), 0);
}

// After the device has failed, the recording of a world can be ended and read; it contains the step that failed as such.
static void failed_devices_leave_a_recording(void** state)
{
	(void)state;
	scree_world* world = open_pile("cpu", true);
	record_hashes(world);
	run_steps(world, 5);
	uint64_t hash = hash_of(world);
	world->broken = SCREE_ERROR_DEVICE_FAILED;
	assert_int_equal(scree_world_step(world, STEP, SUBSTEPS), SCREE_ERROR_DEVICE_FAILED);
	OK(scree_world_end_recording(world));
	Saved saved = recording_of(world);
	assert_true(repeat_on(saved, def_on("cpu", 1, 0)) == hash);
	scree_world_destroy(world);
	free(saved.bytes);
	assert_int_equal(scree_memory(), 0);
}

// ---------------------------------------------------------------------------------------------------------------
// differences
// ---------------------------------------------------------------------------------------------------------------

static void differs_in(Saved saved, int step, const char* words)
{
	scree_replay* replay;
	scree_world* world;
	scree_world_def def = def_on("cpu", 1, 0);
	OK(scree_replay_open(saved.bytes, saved.size, &replay));
	OK(scree_replay_create_world(replay, &def, &world));
	assert_int_equal(repeat_steps(replay, world), SCREE_ERROR_DIFFERENT);
	char sentence[512];
	snprintf(sentence, sizeof sentence, "%s", scree_error());
	char place[32];
	snprintf(place, sizeof place, "step %d: ", step);
	if (!strstr(sentence, place) || !strstr(sentence, words))
		fail_msg("\"%s\" does not contain \"%s\" and \"%s\"", sentence, place, words);
	bool stepped = true; // the replay goes on up to the end of the recording
	while (stepped)
		assert_int_not_equal(scree_replay_step(replay, world, &stepped), SCREE_ERROR_INVALID);
	scree_replay_info info = info_of(replay);
	assert_true(info.step == info.steps);
	scree_world_destroy(world);
	scree_replay_close(replay);
	free(saved.bytes);
}

static void differences_are_named(void** state)
{
	(void)state;
	scree_world* world = open_pile("cpu", true);
	record_hashes(world);
	scree_body crate = SCREE_NULL_BODY;
	for (int step = 1; step <= 9; ++step)
	{
		if (step == 4)
			crate = add_crate(world, SCREE_BODY_DYNAMIC, 50.0f, 5.0f);
		if (step == 6)
			OK(scree_body_apply_impulse(world, crate, (scree_vec){1.0f, 2.0f}));
		run_steps(world, 1);
	}
	OK(scree_world_end_recording(world));
	Saved saved = recording_of(world);
	differs_in(change_call(saved, "world_step", 3, 2), 3, "the hash is ");          // dt
	differs_in(change_call(saved, "body_apply_impulse", 6, 10), 6, "the hash is "); // the impulse
	differs_in(change_call(saved, "body_apply_impulse", 6, 4), 6, "a call fails");  // the body
	differs_in(change_call(saved, "world_step", 7, 7), 7, "must be from 1 to 64");  // substeps
	scree_world_destroy(world);
	free(saved.bytes);
}

// A world whose handles differ from those of the recording is found at the call that creates an object.
static void other_handles_are_named(void** state)
{
	(void)state;
	scree_world *world = open_world(-10.0f), *other;
	record_hashes(world);
	add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 5.0f);
	run_steps(world, 1);
	Saved saved = recording_of(world);
	scree_replay* replay;
	scree_world_def def = def_on("cpu", 1, 0);
	bool stepped;
	OK(scree_replay_open(saved.bytes, saved.size, &replay));
	assert_false(info_of(replay).ended);
	OK(scree_replay_create_world(replay, &def, &other));
	add_crate(other, SCREE_BODY_DYNAMIC, 0.0f, 5.0f);
	assert_int_equal(scree_replay_step(replay, other, &stepped), SCREE_ERROR_DIFFERENT);
	assert_non_null(strstr(scree_error(), "step 1: scree_body_create returns another body than in the recording"));
	scree_replay_close(replay);
	scree_world_destroy(world);
	scree_world_destroy(other);
	free(saved.bytes);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(what_is_recorded),      cmocka_unit_test(failing_steps_are_kept),
	    cmocka_unit_test(saves_are_repeated),    cmocka_unit_test(failed_devices_leave_a_recording),
	    cmocka_unit_test(differences_are_named), cmocka_unit_test(other_handles_are_named),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
