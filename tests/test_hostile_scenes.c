// SPDX-License-Identifier: MIT
// test_hostile_scenes.c -- checks that scene files made to exhaust time, memory or the stack are refused, and that files
// which are no text are.
//
// Limits: 64 MB for a file, 10^10 operations to read it, 256 MB for its collidables and expressions (scene/reader.h).
#include "scene/clean_text.h"
#include "scene/reader.h"
#include "support/scene_text.h"
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#define SCRATCH "test_hostile_scenes_scratch.json"

// Checks that a file is refused with a message that begins with its name.
static void assert_refused_file(const char* path, const char* words)
{
	char sentence[SCENE_SENTENCE] = "";
	Scene* scene = scene_load(path, NULL, 0, sentence);
	if (scene || !strstr(sentence, words) || strncmp(sentence, path, strlen(path)) != 0)
		fail_msg("%s says \"%s\", not \"%s\"", path, sentence, words);
}

static void refuse_bytes(const void* bytes, size_t size, const char* words)
{
	FILE* file = fopen(SCRATCH, "wb");
	assert_non_null(file);
	assert_int_equal(fwrite(bytes, 1, size, file), size);
	fclose(file);
	assert_refused_file(SCRATCH, words);
	remove(SCRATCH);
}

typedef struct // text that grows
{
	char* text;
	size_t used, capacity;
} Text;

static void add(Text* t, const char* more, int times)
{
	size_t length = strlen(more), wanted = t->used + length * (size_t)times + 1;
	if (wanted > t->capacity)
	{
		t->capacity = 2 * wanted;
		t->text = realloc(t->text, t->capacity);
		assert_non_null(t->text);
	}
	for (int k = 0; k < times; ++k, t->used += length)
		memcpy(t->text + t->used, more, length + 1);
}

// Checks that a text of three parts, of which the second is repeated, is refused.
static void refuse(const char* begin, const char* part, int times, const char* end, const char* words)
{
	Text t = {0};
	add(&t, begin, 1);
	add(&t, part, times);
	add(&t, end, 1);
	refuse_bytes(t.text, t.used, words);
	free(t.text);
}

#define BODY    HEAD GOOD_ATTRIBUTES "\"bodies\": [{\"attribute\": \"a\", "
#define REPEAT  "\"repeat\": {\"index\": \"i\", \"to\": "
#define MILLION REPEAT "1e6}, "

static void deep_and_long_texts(void** state)
{
	(void)state;
	refuse("", "[", 100000, "", "maximum parsing depth reached");
	refuse("", "{\"a\":", 100000, "", "maximum parsing depth reached");
	refuse(BODY "\"angle\": \"", "(", 100000, "1\"}]}", "too many parentheses");
	refuse(BODY "\"angle\": \"", "sin(", 100000, "1\"}]}", "too many parentheses");
	refuse(BODY "\"angle\": \"", "-", 1000000, "\"}]}", "unexpected end");
	refuse(BODY "\"angle\": \"", "x", 1000000, "\"}]}", "is no parameter");
	refuse(BODY "\"angle\": \"", "1", 1000000, "\"}]}", "number too long");
	refuse(BODY "\"angle\": 1", "0", 400, "}]}", "too big integer");
	refuse(BODY "\"angle\": ", "1e400", 1, "}]}", "real number overflow");
	refuse("{\"name\": \"", "x", 1000000, "\"}", "title: is missing");
	refuse(HEAD "\"attributes\": {\"", "x", 1000000, "\": {\"circle\": 1}}}", "a name has 1 to 31 characters");
	refuse(HEAD, "\"constants\": {\"a\": \"b\", \"b\": \"a\"}", 1, "}", "b is no parameter");
	refuse("", " ", (int)READER_BYTES + 1, "", "has more than 67108864 bytes");
}

#define EMPTY "{\"attribute\": \"a\", \"repeat\": [{\"index\": \"i\", \"to\": 4e5}, {\"index\": \"j\", \"to\": 0}]}, "

// Repeats multiply the work of a long expression, and rounds without items count too. The limit is lower here, so that the
// test is short.
static void repeats(void** state)
{
	(void)state;
	reader_most_work = 10000000;
	refuse(BODY MILLION "\"angle\": \"i", " - 0 * i", 20000, "\"}]}", "too many operations up to here");
	refuse(HEAD GOOD_ATTRIBUTES "\"bodies\": [", EMPTY, 40, "{}]}",
	       "bodies[12]: more than 10000000 operations up to here");
	refuse(HEAD "\"attributes\": {\"b\": {\"circle\": 1}}, \"bodies\": [{\"attribute\": [\"b\"", ", \"b\"", 6000000,
	       "], \"choose\": 0}]}", "more than 10000000 operations up to here");
	reader_most_work = READER_WORK;
}

#define PARTS "{" REPEAT "0}, \"collidables\": [{\"attribute\": \"a\", \"repeat\": {\"index\": \"k\", \"to\": 65536}}]}"

// A repeat multiplies the memory of the collidables of a body.
static void memory(void** state)
{
	(void)state;
	refuse(HEAD GOOD_ATTRIBUTES "\"bodies\": [" PARTS, ", " PARTS, 60, "]}", "need more than 268435456 bytes");
	refuse(HEAD GOOD_ATTRIBUTES "\"bodies\": [{" REPEAT
	                            "2}, \"collidables\": [{\"position\": [\"i + k\", 0], \"repeat\": {\"index\": \"k\", "
	                            "\"to\": 65536}, \"choose\": 0, \"attribute\": [\"a\"",
	       ", \"a\"", 10000, "]}]}]}", "need more than 268435456 bytes");
}

static void files_that_are_no_text(void** state)
{
	(void)state;
	refuse_bytes("", 0, "line 1, column 0");
	refuse_bytes("{\"name\": \"a\0b\"}", 15, "line 1");
	refuse_bytes("\0\0\0\0", 4, "line 1");
	refuse_bytes("{\"name\": \"\xff\"}", 13, "unable to decode byte 0xff");
	refuse_bytes("{\"name\": \"\xc0\x80\"}", 14, "unable to decode byte 0xc0");
	refuse_bytes("{\"name\": \"\xed\xa0\x80\"}", 15, "unable to decode byte 0xed");
	assert_refused_file(".", "is a folder");
	assert_refused_file("no/such/file.json", "No such file");
#ifndef _WIN32
	assert_refused_file("/dev/zero", "line 1");
	assert_refused_file("/dev/null", "line 1, column 0");
#endif
}

// A message and the title of a scene have no control characters, which a terminal would execute.
static void control_characters(void** state)
{
	(void)state;
	char text[] = "a\x1b[2J\n\t\x7f \xc2\x9b\xc3\xa9 z";
	clean_text(text);
	assert_string_equal(text, "a?[2J??? ??\xc3\xa9 z");
	refuse(BODY "\"angle\": \"", "\\u001b[31m", 1, "\"}]}", "\"?[31m\": unexpected character");
	refuse(BODY "\"", "\\u009b31m", 1, "\": 1}]}", "unknown key \"??31m\"");
	Scene* scene = load_good_text(SCRATCH, "{\"name\": \"x\", \"title\": \"a\\u0007b\\nc\", " GOOD_ATTRIBUTES
	                                       "\"bodies\": [{\"attribute\": \"a\"}]}");
	assert_string_equal(scene->title, "a?b?c");
	scene_free(scene);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(deep_and_long_texts),
	    cmocka_unit_test(repeats),
	    cmocka_unit_test(memory),
	    cmocka_unit_test(files_that_are_no_text),
	    cmocka_unit_test(control_characters),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
