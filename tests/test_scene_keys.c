// SPDX-License-Identifier: MIT
// test_scene_keys.c -- checks every key of scene/format.def: a good value is stored in the member of the key, a bad
// value is refused with a message.
#include "scene/format.h"
#include "support/scene_text.h"
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define SCRATCH "test_scene_keys_scratch.json"

#define BODY(more) HEAD GOOD_ATTRIBUTES "\"bodies\": [{\"name\": \"one\", \"attribute\": \"a\"" more "}]"
#define TWO              \
	HEAD GOOD_ATTRIBUTES \
	    "\"bodies\": [{\"name\": \"one\", \"attribute\": \"a\"}, {\"name\": \"two\", \"attribute\": \"a\"}]"
#define JOINT(type)  "\"type\": \"" type "\";\"a\": null;\"b\": {\"body\": \"one\"}"
#define GEAR(more)   BODY("") ", \"joints\": [{\"type\": \"gear\", \"a\": null, \"b\": {\"body\": \"one\"}, " more "}]}"
#define RAIL         "\"paths\": {\"p\": {\"points\": [[0, 0], [1, 0]]}}"
#define HERO(more)   BODY(", \"type\": \"kinematic\"") ", \"characters\": [{" more "}]}"
#define SCENE(more)  BODY("") ", " more "}"
#define SHAPES(more) HEAD "\"attributes\": {\"a\": " more "}, \"bodies\": [{\"attribute\": \"a\"}]}"

typedef struct // a scene that contains an object of one kind
{
	FormatObject object;
	const char* only;  // name of the only key for which this scene is used; null: used for all other keys
	const char* place; // path of the object in the file
	const char* text;  // text of the file; %s stands for the members of the object
	const char* needs; // members that the object must have, separated by ;
} Place;

static const Place places[] = {
    {OBJECT_scene, NULL, "", "{%s}",
     "\"name\": \"x\";\"title\": \"y\";\"attributes\": {\"a\": {\"circle\": 1}};\"bodies\": [{\"attribute\": \"a\"}]"},
    {OBJECT_parameter, NULL, "parameters.p.", SCENE("\"parameters\": {\"p\": {%s}}"), "\"default\": 1"},
    {OBJECT_world, NULL, "world.", SCENE("\"world\": {%s}"), ""},
    {OBJECT_attribute, NULL, "attributes.a.", SHAPES("{%s}"), "\"circle\": 1"},
    {OBJECT_material, NULL, "materials[0].", SCENE("\"materials\": [{%s}]"), "\"between\": [1, 2]"},
    {OBJECT_body, NULL, "bodies[0].", HEAD GOOD_ATTRIBUTES "\"bodies\": [{%s}]}", "\"attribute\": \"a\""},
    {OBJECT_part, NULL, "bodies[0].collidables[0].", HEAD GOOD_ATTRIBUTES "\"bodies\": [{\"collidables\": [{%s}]}]}",
     "\"attribute\": \"a\""},
    {OBJECT_mass, NULL, "bodies[0].mass.", BODY(", \"mass\": {%s}") "}", "\"mass\": 1"},
    {OBJECT_churn, NULL, "bodies[0].churn.", BODY(", \"churn\": {%s}") "}", "\"position\": [0, 0];\"moved\": 1"},
    {OBJECT_collidable, NULL, "collidables[0].", SCENE("\"collidables\": [{%s}]"), "\"attribute\": \"a\""},
    {OBJECT_loop, NULL, "bodies[0].repeat.", BODY(", \"repeat\": {%s}") "}", "\"index\": \"i\";\"to\": 3"},
    {OBJECT_joint, "initial_along", "joints[0].", SCENE(RAIL ", \"joints\": [{%s}]"), JOINT("path") ";\"path\": \"p\""},
    {OBJECT_joint, NULL, "joints[0].", SCENE("\"joints\": [{%s}]"), JOINT("gear")},
    {OBJECT_end, NULL, "joints[0].b.", SCENE("\"joints\": [{\"type\": \"weld\", \"a\": null, \"b\": {%s}}]"),
     "\"body\": \"one\""},
    {OBJECT_frame, NULL, "joints[0].frame_b.", GEAR("\"frame_b\": {%s}"), ""},
    {OBJECT_coordinate, NULL, "joints[0].along.", GEAR("\"along\": {%s}"), "\"locked\": false"},
    {OBJECT_spring, NULL, "joints[0].along.spring.", GEAR("\"along\": {\"locked\": false, \"spring\": {%s}}"),
     "\"hertz\": 1"},
    {OBJECT_motor, NULL, "joints[0].along.motor.", GEAR("\"along\": {\"locked\": false, \"motor\": {%s}}"),
     "\"max\": 1"},
    {OBJECT_lock, NULL, "joints[0].along.lock.", GEAR("\"along\": {\"lock\": {%s}}"), ""},
    {OBJECT_side, NULL, "joints[0].side_b.", GEAR("\"side_b\": {%s}"), ""},
    {OBJECT_path, NULL, "paths.p.", SCENE("\"paths\": {\"p\": {%s}}"), "\"points\": [[0, 0], [1, 0], [1, 1]]"},
    {OBJECT_row, NULL, "paths.p.points[0].", SCENE("\"paths\": {\"p\": {\"points\": [{%s}, [1, 0]]}}"),
     "\"position\": [0, 0]"},
    {OBJECT_exclusion, NULL, "exclusions[0].", TWO ", \"exclusions\": [{%s}]}",
     "\"a\": {\"body\": \"one\"};\"b\": {\"body\": \"two\"}"},
    {OBJECT_field, NULL, "fields[0].", SCENE("\"fields\": [{%s}]"), "\"type\": \"drag\""},
    {OBJECT_blast, NULL, "blasts[0].", SCENE("\"blasts\": [{%s}]"), "\"step\": 1"},
    {OBJECT_fan, NULL, "rays[0].", SCENE("\"rays\": [{%s}]"), "\"count\": 1;\"length\": 1"},
    {OBJECT_control, NULL, "keys[0].", SCENE("\"keys\": [{%s}]"), "\"key\": \"up\";\"body\": \"one\";\"torque\": 1"},
    {OBJECT_character, NULL, "characters[0].", HERO("%s"), "\"body\": \"one\""},
    {OBJECT_cue, NULL, "characters[0].script[0].", HERO("\"body\": \"one\", \"script\": [{%s}]"),
     "\"step\": 1;\"hold\": []"},
};

static const Place* place_of(FormatObject object, const char* key)
{
	const Place* place = places;
	while (place < places + sizeof places / sizeof places[0] &&
	       (place->object != object || (place->only && strcmp(place->only, key) != 0)))
		++place;
	if (place == places + sizeof places / sizeof places[0])
		fail_msg("object %d with the key %s has no place here", object, key);
	return place;
}

// Writes the text of a scene with an object in which `key` has the value `value`; null: the object does not have the
// key.
static void compose(const Place* place, const char* key, const char* value, char text[2048])
{
	char quoted[64];
	const char* hole = strstr(place->text, "%s");
	snprintf(quoted, sizeof quoted, "\"%s\":", key);
	snprintf(text, 2048, "%.*s%s %s", (int)(hole - place->text), place->text, value ? quoted : "", value ? value : "");
	const char* comma = value ? ", " : "";
	for (const char* need = place->needs; *need; need += *need == ';')
	{
		int length = (int)strcspn(need, ";");
		if (strncmp(need, quoted, strlen(quoted)) != 0)
		{
			snprintf(text + strlen(text), 2048 - strlen(text), "%s%.*s", comma, length, need);
			comma = ", ";
		}
		need += length;
	}
	snprintf(text + strlen(text), 2048 - strlen(text), "%s", hole + 2);
}

// Loads the scene that compose writes. If `part` is null, the scene must be accepted. Otherwise it must be refused, with
// a message that contains both texts, `part` and `must`.
static void load(const Place* place, const char* key, const char* value, const char* part, const char* must)
{
	char text[2048], sentence[SCENE_SENTENCE] = "";
	compose(place, key, value, text);
	Scene* scene = load_text(SCRATCH, text, NULL, 0, sentence);
	bool good = part ? !scene && strstr(sentence, part) && strstr(sentence, must) : scene != NULL;
	scene_free(scene);
	if (!good)
		fail_msg("%s\nsays \"%s\"\nnot  \"%s\" and \"%s\"", text, sentence, part ? part : "", part ? must : "");
}

// Checks that a value is refused. The message must name the key and `element`, which is an index such as [0], or empty.
static void refuse(const FormatKey* key, const char* value, const char* element, const char* must)
{
	char part[200];
	const Place* place = place_of(key->object, key->name);
	snprintf(part, sizeof part, ": %s%s%s: ", place->place, key->name, element);
	load(place, key->name, value, part, must);
}

// Checks that a bad number is refused, both as a number and as an expression. Bad numbers are outside of the range of
// the key, or have a fraction where the key needs a whole number.
static void refuse_number(const FormatKey* key, double number, const char* must)
{
	char value[64];
	bool pair = key->type == TYPE_PAIR;
	snprintf(value, sizeof value, pair ? "[0, %.17g]" : "%.17g", number);
	refuse(key, value, pair ? "[1]" : "", must);
	snprintf(value, sizeof value, pair ? "[0, \"1 * %.17g\"]" : "\"1 * %.17g\"", number);
	refuse(key, value, pair ? "[1]" : "", must);
}

static void test_bad_values(void** state)
{
	(void)state;
	for (const FormatKey* key = format_keys((FormatObject)0); key->object != FORMAT_OBJECTS; ++key)
	{
		const Range* range = &key->range;
		bool number = key->type == TYPE_NUMBER || key->type == TYPE_PAIR;
		if (key->type == TYPE_TEXT)
			refuse(key, "5", "", "5 must be a string");
		if (key->special)
			continue;
		if (number)
		{
			assert_true(range->low < range->high);
			refuse_number(key, range->low - 1 - fabs(range->low) / 8, "must ");
			if (range->high < (double)FLT_MAX)
				refuse_number(key, range->high + 1 + fabs(range->high) / 8, "must be at most ");
			if (range->whole)
				refuse_number(key, range->low + 0.5, "must be a whole number");
		}
		if (key->type == TYPE_NUMBER)
			refuse(key, "true", "", "true must be a number");
		if (key->type == TYPE_PAIR)
			refuse(key, "[1]", "", "[1] must be a list of 2 numbers");
		if (key->type == TYPE_ROTATION)
		{
			refuse(key, "[1]", "", "[1] must be a list of 2 numbers");
			refuse(key, "[0.9, 0.9]", "", "must be the cosine and sine of an angle");
		}
		if (key->type == TYPE_USER)
		{
			refuse(key, "-1", "", "-1 must be a whole number from 0");
			refuse(key, "\"0x\"", "", "must be a whole number from 0");
		}
		if (key->type == TYPE_BOOLEAN)
			refuse(key, "3", "", "3 must be true or false");
		if (key->type == TYPE_BITS)
			refuse(key, "[64]", "[0]", "64 must be at most 63");
		if (key->type == TYPE_NAME)
			refuse(key, "\"toy\"", "", "\"toy\" must be one of ");
		if (key->type == TYPE_NAMES)
			refuse(key, "[\"toy\"]", "[0]", "\"toy\" must be one of ");
	}
}

// Checks that the library accepts the lowest and the highest number that the format allows for each key: creates a world
// with this number, and takes steps.
static void test_limits(void** state)
{
	(void)state;
	char text[2048], value[64];
	for (const FormatKey* key = format_keys((FormatObject)0); key->object != FORMAT_OBJECTS; ++key)
	{
		const double limits[2] = {key->range.low, fmin(key->range.high, (double)FLT_MAX)};
		for (int k = 0; k < 2 && !key->special && (key->type == TYPE_NUMBER || key->type == TYPE_PAIR); ++k)
		{
			snprintf(value, sizeof value, key->type == TYPE_PAIR ? "[%.17g, %.17g]" : "%.17g", limits[k], limits[k]);
			compose(place_of(key->object, key->name), key->name, value, text);
			ScenePlayer player = open_text(SCRATCH, text);
			for (int n = 0; n < 3; ++n)
				if (player_step(&player) != SCREE_OK)
					fail_msg("%s: %s", text, scree_error());
			close_text(&player);
		}
	}
}

// Checks that an object without a key that it must have is refused, with the name of the key.
static void test_missing_keys(void** state)
{
	(void)state;
	for (const FormatKey* key = format_keys((FormatObject)0); key->object != FORMAT_OBJECTS; ++key)
		if (key->need == NEED_MUST)
			load(place_of(key->object, key->name), key->name, NULL, key->name, "");
}

static void test_unknown_keys(void** state)
{
	(void)state;
	for (FormatObject object = 0; object < FORMAT_OBJECTS; ++object)
	{
		char known[80];
		snprintf(known, sizeof known, ": unknown key \"no_such_key\"; known are %s, ", format_keys(object)->name);
		load(place_of(object, "no_such_key"), "no_such_key", "1", known, "");
	}
}

// Returns the number that is stored in the member of a key.
static double stored(const FormatKey* key, const char* made)
{
	if (key->store == STORE_NONE)
		fail_msg("%s has no number", key->name);
	return format_stored(made, key->offset, key->store);
}

// Calls format_read for an object that has one key and all mandatory keys.
static void read_one(const FormatKey* key, json_t* value, void* made)
{
	char sentence[SENTENCE_SIZE] = "";
	Reader* reader = calloc(1, sizeof *reader);
	json_t* object = json_object();
	assert_non_null(reader);
	reader->file = "";
	reader->sentence = sentence;
	// other mandatory keys of the object
	for (const FormatKey* k = format_keys(key->object); k->object == key->object; ++k)
		if (k->need == NEED_MUST && !k->special)
			json_object_set_new(object, k->name,
			                    k->type == TYPE_PAIR   ? json_pack("[ii]", 0, 0)
			                    : k->type == TYPE_NAME ? json_string(k->names[0])
			                                           : json_real(k->range.low));
	json_object_set_new(object, key->name, value);
	format_default(key->object, made);
	if (!format_read(reader, NULL, object, key->object, made, 0, NULL))
		fail_msg("%s", sentence);
	json_decref(object);
	free(reader);
}

static void test_good_values(void** state)
{
	(void)state;
	static _Alignas(max_align_t) char made[4096];
	for (const FormatKey* key = format_keys((FormatObject)0); key->object != FORMAT_OBJECTS; ++key)
	{
		const char* member = made + key->offset;
		double low = fmax(key->range.low, -3), high = fmin(key->range.high, 3);
		double number = key->range.whole ? floor((low + high) / 2) : low + 0.625 * (high - low);
		if (key->special)
			continue;
		for (const FormatKey* k = format_keys(key->object); k < key; ++k)
			assert_true(k->special || k->offset != key->offset || key->type == TYPE_ROTATION); // beside angle
		switch (key->type)
		{
		case TYPE_NUMBER:
			read_one(key, json_real(number), made);
			assert_true(fabs(stored(key, made) - number) < 1e-6);
			break;
		case TYPE_PAIR:
			read_one(key, json_pack("[ff]", low, number), made);
			assert_true(((const float*)member)[0] == (float)low && ((const float*)member)[1] == (float)number);
			break;
		case TYPE_ROTATION:
			read_one(key, json_pack("[ff]", 0.6, -0.8), made);
			assert_true(((const scree_rot*)member)->c == 0.6f && ((const scree_rot*)member)->s == -0.8f);
			break;
		case TYPE_USER:
			read_one(key, json_string("0xfedcba9876543210"), made);
			assert_true(*(const uint64_t*)member == 0xfedcba9876543210u);
			break;
		case TYPE_BOOLEAN:
			for (int k = 0; k < 2; ++k)
			{
				read_one(key, json_boolean(k), made);
				assert_int_equal(*(const bool*)member, k);
			}
			break;
		case TYPE_BITS:
			read_one(key, json_pack("[ii]", 2, 63), made);
			assert_true(*(const uint64_t*)member == ((uint64_t)1 << 63 | 4));
			break;
		case TYPE_NAME:
			for (int k = 0; key->names[k]; ++k)
			{
				read_one(key, json_string(key->names[k]), made);
				assert_int_equal(*(const uint32_t*)member, k);
			}
			break;
		case TYPE_NAMES:
			read_one(key, json_pack("[ss]", key->names[0], key->names[2]), made);
			assert_int_equal(*(const uint32_t*)member, 5);
			break;
		case TYPE_TEXT:
		case TYPE_OTHER:
			fail_msg("%s has a type that format_read does not read", key->name);
		}
	}
}

// Checks that the lists of names are in the order of the enumerators and bits of scree.h.
static void test_names(void** state)
{
	(void)state;
	const struct
	{
		const char* const* list;
		int position;
		const char* name;
		int value;    // enumerator or bit of scree.h
		int expected; // value that the enumerator must have at this position
	} cases[] = {
	    {body_type_names, 0, "static", SCREE_BODY_STATIC, 0},
	    {body_type_names, 1, "kinematic", SCREE_BODY_KINEMATIC, 1},
	    {body_type_names, 2, "dynamic", SCREE_BODY_DYNAMIC, 2},
	    {lock_names, 0, "x", SCREE_LOCK_X, 1},
	    {lock_names, 1, "y", SCREE_LOCK_Y, 2},
	    {lock_names, 2, "rotation", SCREE_LOCK_ROTATION, 4},
	    {query_kind_names, 0, "static", SCREE_QUERY_STATIC, 1},
	    {query_kind_names, 1, "kinematic", SCREE_QUERY_KINEMATIC, 2},
	    {query_kind_names, 2, "dynamic", SCREE_QUERY_DYNAMIC, 4},
	    {query_kind_names, 3, "free", SCREE_QUERY_FREE, 8},
	    {query_kind_names, 4, "sensors", SCREE_QUERY_SENSORS, 16},
	    {measure_names, 0, "angle", SCREE_MEASURE_ANGLE, 0},
	    {measure_names, 1, "translation", SCREE_MEASURE_TRANSLATION, 1},
	    {measure_names, 2, "distance", SCREE_MEASURE_DISTANCE, 2},
	    {field_type_names, 0, "uniform", SCREE_FIELD_UNIFORM, 0},
	    {field_type_names, 3, "drag", SCREE_FIELD_DRAG, 3},
	    {field_type_names, 5, "buoyancy", SCREE_FIELD_BUOYANCY, 5},
	    {falloff_names, 1, "linear", SCREE_FALLOFF_LINEAR, 1},
	    {falloff_names, 3, "inverse_square", SCREE_FALLOFF_INVERSE_SQUARE, 3},
	};
	for (size_t k = 0; k < sizeof cases / sizeof cases[0]; ++k)
	{
		assert_string_equal(cases[k].list[cases[k].position], cases[k].name);
		assert_int_equal(cases[k].value, cases[k].expected);
	}
	// the list has all types of joints, and no other names
	int type = 0;
	for (; joint_type_names[type]; ++type)
		assert_string_equal(joint_type_names[type], scree_joint_type_name((scree_joint_type)type));
	assert_string_equal(scree_joint_type_name((scree_joint_type)type), scree_joint_type_name((scree_joint_type)-1));
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(test_bad_values),   cmocka_unit_test(test_limits),      cmocka_unit_test(test_missing_keys),
	    cmocka_unit_test(test_unknown_keys), cmocka_unit_test(test_good_values), cmocka_unit_test(test_names),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
