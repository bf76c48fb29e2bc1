// SPDX-License-Identifier: MIT
// test_scene_texts.c -- checks names, titles and settings of written scenes: every file that is written can be loaded again.
//
// Worked examples: a name of n bytes keeps its leading whole characters, at most 63 bytes; a byte that is no character of UTF-8
// (RFC 3629) is refused in a setting, and is a question mark in the name of a file.
#include "scree/scree_scene.h"
#include "support/make_worlds.h"
#include "support/written_scenes.h"
#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static scree_scene_info info_of(const scree_scene* scene)
{
	scree_scene_info info;
	OK(scree_scene_get_info(scene, &info));
	return info;
}

// Writes a world under a name, loads it again, and compares its name and title.
static void check_name(scree_world* world, const scree_scene_info* given, const char* file, const char* expected)
{
	char* text;
	size_t size;
	scree_scene* scene;
	OK(scree_scene_write_text(world, given, file, &text, &size));
	OK(scree_scene_load_text(text, size, file, NULL, &scene));
	scree_scene_info info = info_of(scene);
	assert_string_equal(info.name, expected);
	assert_string_equal(info.title, expected);
	// settings of a loaded scene write a scene that loads
	char* again = write_scene(scree_scene_get_world(scene), &info, &size);
	assert_string_equal(again, text);
	scree_scene_free_text(again);
	scree_scene_free_text(text);
	scree_scene_destroy(scene);
}

static void test_names(void** state)
{
	(void)state;
	scree_world* world = open_world(-10.0f);
	scree_scene_info info = scree_scene_info_default();
	char file[128] = "folder/a", expected[64] = "a";
	check_name(world, NULL, "a \"b\" \\ \xc3\xa4\xe2\x82\xac\xf0\x9f\x98\x80.json",
	           "a \"b\" \\ \xc3\xa4\xe2\x82\xac\xf0\x9f\x98\x80");
	check_name(world, NULL, ".json", ".json");
	check_name(world, NULL, "folder/", "scene");
	// 1 + 30 * 3 bytes: 20 characters of three bytes fit into 63
	for (int k = 0; k < 30; ++k)
		strcat(file, "\xe2\x82\xac");
	for (int k = 0; k < 20; ++k)
		strcat(expected, "\xe2\x82\xac");
	check_name(world, NULL, file, expected);
	// names of files in Latin-1, of control characters, and with parts of characters, long forms and surrogates
	check_name(world, NULL, "M\xfcll.json", "M?ll");
	check_name(world, NULL, "a\nb\x7f\xc2\x85", "a?b???");
	check_name(world, NULL, "\xc0\xaf|\xe0\x80\xaf|\xed\xa0\x80|\xf0\x80\x80\x80|\xf4\x90\x80\x80|\xf5|\xe2\x82",
	           "??|???|???|????|????|?|??");
	// the last characters before each gap
	strcpy(info.name,
	       "\xc2\xa0|\xdf\xbf|\xe0\xa0\x80|\xed\x9f\xbf|\xee\x80\x80|\xef\xbf\xbf|\xf0\x90\x80\x80|\xf4\x8f\xbf\xbf");
	strcpy(info.title, info.name);
	check_name(world, &info, "x", info.name);
	scree_world_destroy(world);
}

// Checks that a loaded name that is too long is cut between two characters.
static void test_long_names(void** state)
{
	(void)state;
	char text[512] = "{\"name\": \"a", name[64] = "a";
	for (int k = 0; k < 40; ++k)
		strcat(text, "\xc3\xa4");
	strcat(text, "\", \"title\": \"t\", \"attributes\": {}}");
	for (int k = 0; k < 31; ++k)
		strcat(name, "\xc3\xa4");
	scree_scene* scene;
	OK(scree_scene_load_text(text, strlen(text), "long", NULL, &scene));
	scree_scene_info info = info_of(scene);
	assert_string_equal(info.name, name);
	size_t size;
	char* written = write_scene(scree_scene_get_world(scene), &info, &size);
	scree_scene_destroy(load_written(written, size, "cpu"));
	scree_scene_free_text(written);
	scree_scene_destroy(scene);
}

static void check_refused(scree_world* world, const scree_scene_info* info, const char* part)
{
	char* text;
	size_t size;
	assert_int_equal(scree_scene_write_text(world, info, "c.json", &text, &size), SCREE_ERROR_INVALID);
	assert_null(text);
	if (!strstr(scree_error(), part))
		fail_msg("%s", scree_error());
}

static void test_bad_settings(void** state)
{
	(void)state;
	scree_world* world = open_world(-10.0f);
	const scree_scene_info made = scree_scene_info_default();
	scree_scene_info info = made;
	strcpy(info.name, "ab\xff");
	check_refused(world, &info, "info.name is not UTF-8: byte 2 is 0xff");
	info = made;
	strcpy(info.title, "\xe2\x82");
	check_refused(world, &info, "info.title is not UTF-8: byte 0 is 0xe2");
	info = made;
	memset(info.name, 'x', sizeof info.name);
	check_refused(world, &info, "info.name has no 0 at its end");
	info = made;
	info.dt = NAN;
	check_refused(world, &info, "c.json: world.dt: nan must be finite in a scene file");
	info.dt = -NAN;
	check_refused(world, &info, "world.dt: ");
	info = made;
	info.penetration_limit = NAN;
	check_refused(world, &info, "penetration_limit: nan must be finite in a scene file");
	scree_world_destroy(world);
}

// Checks the definition of a world from a program with another version of the header: members that it lacks have their defaults,
// and the memory behind it is not read.
static void test_versions_of_worlds(void** state)
{
	(void)state;
	static const char text[] = "{\"name\": \"a\", \"title\": \"a\", \"attributes\": {}}";
	size_t size = offsetof(scree_world_def, recovery_interval);
	scree_world_def* older = malloc(size);
	scree_world_def whole = scree_world_def_default();
	assert_non_null(older);
	whole.size = (uint32_t)size;
	whole.device = "cpu";
	whole.threads = 1;
	memcpy(older, &whole, size);
	scree_scene_def def = scree_scene_def_default();
	def.world = older;
	scree_scene* scene;
	OK(scree_scene_load_text(text, strlen(text), "a", &def, &scene));
	assert_int_equal(scree_world_get_threads(scree_scene_get_world(scene)), 1);
	scree_scene_destroy(scene);
	free(older);
	struct
	{
		scree_world_def def;
		uint64_t later;
	} newer = {scree_world_def_default(), 0};
	newer.def.size = sizeof newer;
	newer.def.device = "cpu";
	def.world = &newer.def;
	OK(scree_scene_load_text(text, strlen(text), "a", &def, &scene));
	scree_scene_destroy(scene);
	newer.later = 1;
	assert_int_equal(scree_scene_load_text(text, strlen(text), "a", &def, &scene), SCREE_ERROR_INVALID);
	assert_non_null(strstr(scree_error(), "def.world has a member that is newer than this library and not 0"));
	newer.def.size = 0;
	assert_int_equal(scree_scene_load_text(text, strlen(text), "a", &def, &scene), SCREE_ERROR_INVALID);
	assert_non_null(strstr(scree_error(), "def.world.size is 0"));
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(test_names),
	    cmocka_unit_test(test_long_names),
	    cmocka_unit_test(test_bad_settings),
	    cmocka_unit_test(test_versions_of_worlds),
	};
	return cmocka_run_group_tests(tests, NULL, memory_is_released);
}
