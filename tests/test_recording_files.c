// SPDX-License-Identifier: MIT
// test_recording_files.c -- checks recordings whose end is cut off, that are damaged, hostile or of another version; files that
// cannot be written; and lack of memory.
#include "support/allocations.h"
#include "support/edit_recordings.h"
#include "support/second_device.h"
#include <stdio.h>

#define FILE_STEPS 3

// Records a few calls of each form: values, arrays, definitions, paths, results, a snapshot.
static Saved small_recording(void)
{
	scree_world* world = open_world(-10.0f);
	record_hashes(world);
	add_floor(world);
	scree_body crates[2] = {add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 1.0f),
	                        add_crate(world, SCREE_BODY_DYNAMIC, 3.0f, 1.0f)};
	scree_vec points[3] = {{0.0f, 0.0f}, {1.0f, 0.0f}, {2.0f, 1.0f}}, forces[2] = {{1.0f, 0.0f}, {0.0f, 1.0f}};
	bool awake[2] = {true, false};
	scree_path_def path = scree_path_def_default();
	path.points = points;
	path.count = 3;
	OK(scree_path_create(world, &path, NULL));
	for (int k = 0; k < FILE_STEPS; ++k)
	{
		OK(scree_bodies_apply_forces(world, crates, forces, 2));
		OK(scree_bodies_set_awake(world, crates, awake, 2));
		OK(scree_world_set_material_pair(world, 1, 2, NULL));
		run_steps(world, 1);
	}
	OK(scree_world_end_recording(world));
	Saved saved = recording_of(world);
	scree_world_destroy(world);
	return saved;
}

// Opens a recording whose end may be missing. Returns the number of its steps, or -1 if it is refused with a sentence.
static int steps_of(const void* bytes, size_t size, bool* ended)
{
	scree_replay* replay;
	*ended = false;
	if (scree_replay_open(bytes, size, &replay) != SCREE_OK)
	{
		assert_null(replay);
		assert_non_null(strstr(scree_error(), "scree_replay_open: "));
		assert_non_null(strstr(scree_error(), "recording"));
		return -1;
	}
	scree_replay_info info = info_of(replay);
	assert_true(info.read <= size && info.step == 0);
	*ended = info.ended;
	scree_replay_close(replay);
	return (int)info.steps;
}

// A recording that ends at any byte is read up to the last whole record.
static void cut_recordings_end_earlier(void** state)
{
	(void)state;
	Saved saved = small_recording();
	int last = -1;
	bool ended;
	for (size_t size = 0; size < saved.size; ++size)
	{
		// memory of exactly this size, so that the address sanitizer finds reads beyond it
		void* bytes = malloc(size + (size == 0));
		memcpy(bytes, saved.bytes, size);
		int steps = steps_of(bytes, size, &ended);
		assert_true(steps >= last && steps <= last + 1 + (last < 0) && !ended);
		last = steps;
		free(bytes);
	}
	assert_int_equal(last, FILE_STEPS);
	assert_int_equal(steps_of(saved.bytes, saved.size, &ended), FILE_STEPS);
	assert_true(ended);
	free(saved.bytes);
	assert_int_equal(scree_memory(), 0);
}

// A recording with a wrong byte is refused, or ends before it.
static void damaged_recordings_end_earlier(void** state)
{
	(void)state;
	Saved saved = small_recording();
	uint8_t* bytes = saved.bytes;
	int last = -1;
	bool ended;
	for (size_t at = 0; at < saved.size; ++at)
	{
		uint8_t old = bytes[at];
		bytes[at] = (uint8_t)(old ^ (1u << at % 8));
		int steps = steps_of(bytes, saved.size, &ended);
		assert_true(steps >= last && steps <= FILE_STEPS && !ended);
		last = steps;
		bytes[at] = old;
	}
	bytes[8] = 77;
	assert_int_equal(steps_of(bytes, saved.size, &ended), -1);
	assert_non_null(strstr(scree_error(), "has format 77"));
	assert_int_equal(steps_of("not a recording, but a text with some letters", 45, &ended), -1);
	assert_non_null(strstr(scree_error(), "are not a recording"));
	free(saved.bytes);
}

typedef struct // a word of a record that is replaced
{
	int record;
	size_t at;
	uint32_t value;
} WordChange;

static void replace_word(int k, const LogRecord* record, uint8_t* bytes, const void* context)
{
	const WordChange* change = context;
	for (size_t b = 0; b < 4 && k == change->record && change->at + b < record->size; ++b)
		bytes[change->at + b] = (uint8_t)(change->value >> 8 * b);
}

// Words of records are replaced by hostile values, with right digests: the recording is refused, or its calls are repeated as
// far as they succeed, and memory stays small.
static void hostile_recordings_do_no_harm(void** state)
{
	(void)state;
	static const uint32_t values[] = {0xffffffffu, 0x7fffffffu, 0x0fffff80u, 2u, 0u, 0x01010101u, 0xfffffff0u};
	count_allocations();
	Saved saved = small_recording();
	int refused = 0, repeated = 0, records = 0;
	largest_allocation = 64 << 20; // an allocation beyond that would fail with SCREE_ERROR_OUT_OF_MEMORY
	ByteReader reader = {saved.bytes, (const uint8_t*)saved.bytes + saved.size};
	uint64_t chain;
	const char* version;
	int length;
	LogRecord record;
	OK(log_open("test", &reader, saved.size, &chain, &version, &length));
	for (; log_next(&reader, &chain, &record); ++records)
	{
		size_t apart = record.number == RECORD_SNAPSHOT ? 211 : record.number == RECORD_LISTS ? 3 : 1;
		for (size_t at = 0; at < record.size; at += apart * (quick() ? 5 : 1))
		{
			WordChange change = {records, at, values[(at + (size_t)records) % 7]};
			Saved copy = edit_recording(saved, replace_word, &change);
			scree_replay* replay;
			scree_status status = scree_replay_open(copy.bytes, copy.size, &replay);
			assert_true(status == SCREE_OK || status == SCREE_ERROR_INVALID);
			scree_world* world = NULL;
			scree_world_def def = def_on("cpu", 1, 1);
			if (status == SCREE_OK && scree_replay_create_world(replay, &def, &world) == SCREE_OK)
				repeat_steps(replay, world);
			++*(status == SCREE_OK ? &repeated : &refused);
			scree_world_destroy(world);
			scree_replay_close(replay);
			free(copy.bytes);
		}
	}
	print_message("%d refused, %d repeated\n", refused, repeated);
	assert_true(refused > 30 && repeated > 100);
	free(saved.bytes);
	assert_int_equal(scree_memory(), 0);
}

// ---------------------------------------------------------------------------------------------------------------
// other versions
// ---------------------------------------------------------------------------------------------------------------

typedef struct
{
	const char *from, *to; // equally long
} NameChange;

static void replace_name(int k, const LogRecord* record, uint8_t* bytes, const void* context)
{
	(void)k;
	const NameChange* change = context;
	size_t length = strlen(change->from);
	for (size_t at = 0; record->number == RECORD_LISTS && at + length <= record->size; ++at)
		if (memcmp(bytes + at, change->from, length) == 0)
			memcpy(bytes + at, change->to, length);
}

// Returns a recording as a library of another version would write it: with other names in its lists.
static Saved rename_in_lists(Saved saved, const char* from, const char* to)
{
	assert_int_equal(strlen(from), strlen(to));
	return edit_recording(saved, replace_name, &(NameChange){from, to});
}

// A call that the file names and the library lacks is refused only if it occurs; a member that the library lacks must be 0.
static void other_versions_are_read(void** state)
{
	(void)state;
	Saved saved = small_recording();
	bool ended;
	Saved unused = rename_in_lists(saved, "field_set_pose", "field_set_posy"),
	      used = rename_in_lists(saved, "path_create", "path_creaty"),
	      zero = rename_in_lists(saved, "stays_awake", "stays_awaky"),
	      set = rename_in_lists(saved, "gravity_scale", "gravity_scaly");
	assert_int_equal(steps_of(unused.bytes, unused.size, &ended), FILE_STEPS);
	assert_int_equal(steps_of(used.bytes, used.size, &ended), -1);
	assert_non_null(strstr(scree_error(), "of the library lacks"));
	assert_int_equal(steps_of(zero.bytes, zero.size, &ended), FILE_STEPS);
	repeat_on(zero, def_on("cpu", 1, 0));
	scree_replay* replay;
	assert_int_equal(scree_replay_open(set.bytes, set.size, &replay), SCREE_ERROR_INVALID);
	assert_non_null(
	    strstr(scree_error(), "a call of scree_body_create sets a member that this version of the library lacks"));
	free(saved.bytes);
	free(unused.bytes);
	free(used.bytes);
	free(zero.bytes);
	free(set.bytes);
}

// ---------------------------------------------------------------------------------------------------------------
// files and memory
// ---------------------------------------------------------------------------------------------------------------

static Saved read_file(const char* path)
{
	FILE* file = fopen(path, "rb");
	assert_non_null(file);
	Saved saved = {malloc(1 << 22), 0};
	saved.size = fread(saved.bytes, 1, 1 << 22, file);
	fclose(file);
	return saved;
}

// A file contains all calls before each step, also without an end.
static void files_are_written(void** state)
{
	(void)state;
	char path[4096];
	snprintf(path, sizeof path, "%s/test_recording.scree", getenv("SCREE_BUILD") ? getenv("SCREE_BUILD") : ".");
	scree_record_def def = scree_record_def_default();
	def.path = path;
	def.hash_interval = 2;
	scree_world* world = open_pile("cpu", true);
	OK(scree_world_record(world, &def));
	const void* bytes;
	size_t size;
	assert_int_equal(scree_world_get_recording(world, &bytes, &size), SCREE_ERROR_INVALID);
	run_steps(world, 5);
	bool ended;
	Saved early = read_file(path);
	assert_int_equal(steps_of(early.bytes, early.size, &ended), 5); // a step is written before it is taken
	assert_false(ended);
	OK(scree_world_end_recording(world));
	Saved whole = read_file(path);
	assert_int_equal(steps_of(whole.bytes, whole.size, &ended), 5);
	assert_true(ended && repeat_on(whole, def_on("cpu", 2, 4)) == hash_of(world));
	OK(scree_world_record(world, &def)); // replaces the file; the end of a world ends the recording
	run_steps(world, 1);
	scree_world_destroy(world);
	Saved again = read_file(path);
	assert_int_equal(steps_of(again.bytes, again.size, &ended), 1);
	assert_true(ended);
	remove(path);
	free(early.bytes);
	free(whole.bytes);
	free(again.bytes);
}

static int warnings;

static void count_warnings(scree_log_level level, const char* sentence, void* context)
{
	(void)context;
	warnings += level == SCREE_LOG_WARNING && strstr(sentence, "scree_world_record: ") != NULL;
}

static void files_that_cannot_be_written(void** state)
{
	(void)state;
	const scree_hooks hooks = {.log = count_warnings};
	OK(scree_hooks_set(&hooks));
	scree_world* world = open_pile("cpu", true);
	scree_record_def def = scree_record_def_default();
	def.path = "/no/such/folder/file";
	assert_int_equal(scree_world_record(world, &def), SCREE_ERROR_FILE);
	assert_non_null(strstr(scree_error(), "def.path is \"/no/such/folder/file\", which cannot be opened: "));
	assert_int_equal(scree_world_end_recording(world), SCREE_ERROR_INVALID);
	def.path = NULL;
	def.hash_interval = -1;
	assert_int_equal(scree_world_record(world, &def), SCREE_ERROR_INVALID);
#ifdef __linux__
	def.path = "/dev/full"; // a disk without space
	def.hash_interval = 1;
	assert_int_equal(scree_world_record(world, &def), SCREE_ERROR_FILE);
	assert_non_null(strstr(scree_error(), "/dev/full cannot be written: "));
	assert_int_equal(warnings, 0); // the call has failed

	// a file that becomes full later
	Recorder* recorder;
	OK(recorder_open(world, "test", NULL, 1, &recorder));
	recorder->file = fopen("/dev/full", "wb");
	recorder->path = scree_allocate(10);
	strcpy(recorder->path, "/dev/full");
	uint64_t hash = hash_of(world);
	run_steps(world, 2);
	assert_true(hash_of(world) != hash);
	assert_int_equal(warnings, 1);
	assert_int_equal(recorder_end(world, recorder, "test", true), SCREE_ERROR_FILE);
	assert_non_null(strstr(scree_error(), "test: scree_world_record: /dev/full cannot be written: "));
	recorder_free(recorder);
#endif
	scree_world_destroy(world);
	const scree_hooks none = {0};
	OK(scree_hooks_set(&none));
}

// Lack of memory ends a recording with its last whole record, and no other call fails.
static void memory_runs_out(void** state)
{
	(void)state;
	count_allocations();
	scree_world* world = open_pile("cpu", true);
	int failures = 0;
	for (;; ++failures)
	{
		allocations_left = failures;
		scree_status status = scree_world_record(world, NULL);
		if (status == SCREE_OK)
			break;
		end_of_shortage(status);
		assert_int_equal(scree_world_end_recording(world), SCREE_ERROR_INVALID);
	}
	assert_true(failures > 2);
	allocations_left = -1;
	run_steps(world, 1);
	allocations_left = 0;
	scree_body crate;
	OK(scree_world_get_bodies(world, &crate, 1, &(int){0}));
	int calls = 0;
	for (; calls < 1000000 && world->recorders.own->status == SCREE_OK; ++calls)
		OK(scree_body_set_user(world, crate, 5));
	assert_true(calls > 0 && calls < 1000000);
	allocations_left = -1;
	run_steps(world, 1);
	assert_int_equal(scree_world_end_recording(world), SCREE_ERROR_OUT_OF_MEMORY);
	assert_non_null(strstr(scree_error(),
	                       "scree_world_end_recording: scree_world_record: no memory for the recording after 1 steps"));
	Saved saved = recording_of(world);
	bool ended;
	assert_int_equal(steps_of(saved.bytes, saved.size, &ended), 1);
	assert_false(ended);
	for (int k = 0;; ++k)
	{
		scree_replay* replay;
		allocations_left = k;
		scree_status status = scree_replay_open(saved.bytes, saved.size, &replay);
		if (status == SCREE_OK)
		{
			scree_replay_close(replay);
			break;
		}
		end_of_shortage(status);
		assert_null(replay);
	}
	allocations_left = -1;
	scree_world_destroy(world);
	free(saved.bytes);
	assert_int_equal(scree_memory(), 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(cut_recordings_end_earlier),
	    cmocka_unit_test(damaged_recordings_end_earlier),
	    cmocka_unit_test(other_versions_are_read),
	    cmocka_unit_test(files_are_written),
	    cmocka_unit_test(files_that_cannot_be_written),
	    cmocka_unit_test(hostile_recordings_do_no_harm),
	    cmocka_unit_test(memory_runs_out),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
