// SPDX-License-Identifier: MIT
// scene_lists.c -- prints scenes/scene.schema.json (scene_lists schema) or the tables of docs/manual/scenes.md (scene_lists
// tables).
//
// Both are made from scene/format.def. tools/lists.sh writes them to the sources; tests/test_lists.sh compares them.
#include "scene/format.h"
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define VISIBLE 1e5 // the tables do not show bounds of this size or larger

// Initializer of a type: its members in a JSON schema, and its words in a table. Both are null except for TYPE_OTHER
// and TYPE_TEXT, because FormatKey.type determines them.
#define GENERIC         NULL, NULL
#define NUMBER(...)     GENERIC
#define WHOLE(...)      GENERIC
#define PAIR(...)       GENERIC
#define WHOLE_PAIR(...) GENERIC
#define ROTATION        GENERIC
#define BOOLEAN         GENERIC
#define BITS            GENERIC
#define USER            GENERIC
#define NAME(list)      GENERIC
#define NAMES(list)     GENERIC
#define REF(of)         "\"$ref\": \"#/$defs/" #of "\""
#define ARRAY(of)       "\"type\": \"array\", \"items\": {" of "}"
#define MAP(of)         "\"type\": \"object\", \"additionalProperties\": {" of "}"
#define NEW(of)         MAP(of) ", \"propertyNames\": {" REF(name) "}"
#define LINK(of)        "[" #of "](#" #of ")"
#define STRING          "\"type\": \"string\""
#define POINTS(...)     ARRAY(REF(point)), "list of points"
#define ATTRIBUTE       REF(attribute_name), "name, or list of names"
#define BOX             ARRAY(REF(metres)) ", \"minItems\": 4, \"maxItems\": 4", "left, bottom, right, top"
#define BY_NAME(of)     MAP(REF(of)) ", \"propertyNames\": {" REF(label) "}", LINK(of) " by name"
#define CONSTANTS       NEW(REF(constant)), "numbers by name"
#define LABEL           REF(label), "text"
#define MANY(of)        ARRAY(REF(of)), "list of " LINK(of)
#define NEW_NAME        REF(name), "text"
#define NEW_NAMES(of)   NEW(REF(of)), LINK(of) " by name"
#define ONE(of)         REF(of), LINK(of)
#define ONE_OR_NULL(of) "\"oneOf\": [{\"type\": \"null\"}, {" REF(of) "}]", LINK(of) " or null"
#define END             ONE_OR_NULL(end)
#define PATH_POINTS(of) ARRAY("\"anyOf\": [{" REF(point) "}, {" REF(of) "}]"), "list of points and of " LINK(of)
#define REPEAT          REF(repeat), LINK(loop) ", or list of 1 to 4"
#define TEXT            STRING, "text"
#define WORD            STRING ", \"minLength\": 1", "text"

static const struct
{
	const char *schema, *words, *unit, *text;
} keys[] = {
// extra data of each key, in the order of format_keys
#define X(object, key, need, type, member, unit, text) {type, unit, text},
#define SPECIAL(object, key, need, type, unit, text)   {type, unit, text},
#include "scene/format.def"
};

static const struct
{
	const char *name, *text;
	size_t size; // bytes of the struct of an object
} objects[FORMAT_OBJECTS] = {
#define OBJECT(object, struct, value, text) {#object, text, sizeof(struct)},
#define PLAIN(object, text)                 {#object, text, 0},
#include "scene/format.def"
};

static const char beginning[] =
    "{\n\t\"$schema\": \"https://json-schema.org/draft/2020-12/schema\",\n\t\"$id\": \"scene.schema.json\",\n"
    "\t\"title\": \"A scene of Scree\",\n\t\"description\": \"Units are metres, kilograms, seconds and radians. "
    "Wherever a "
    "number may stand, a string may hold an expression: + - * / ( ), pi, abs, floor, ceil, sqrt, sin, cos, min(a, b), "
    "max(a, b), mod(a, b), random(a, b), and the names of parameters, constants and repeat indices. Each random() in "
    "the file draws its own numbers, a hash of seed and the item's number.\",\n"
    "\t\"$ref\": \"#/$defs/scene\",\n\t\"$defs\": {\n";

static const char definitions[] =
    "\t\t\"number\": {\"description\": \"a number, or an expression over parameters, constants and repeat indices\", "
    "\"type\": [\"number\", \"string\"]},\n"
    "\t\t\"name\": {\"type\": \"string\", \"pattern\": \"^[a-z_][a-z0-9_]{0,30}$\"},\n"
    "\t\t\"label\": {\"type\": \"string\", \"minLength\": 1, \"maxLength\": 31},\n"
    "\t\t\"vector\": {" ARRAY(REF(
        number)) ", \"minItems\": 2, \"maxItems\": 2},\n"
                 "\t\t\"bits\": {\"description\": \"numbers of bits that are set, 0 to 63\", \"type\": "
                 "\"array\", "
                 "\"items\": {" REF(
                     number) ", \"minimum\": 0, \"maximum\": 63, \"multipleOf\": 1}},\n"
                             "\t\t\"attribute_name\": {\"oneOf\": [{" STRING "}, {" ARRAY(
                                 STRING) ", \"minItems\": 1}]},\n"
                                         "\t\t\"user\": {\"oneOf\": [{\"type\": \"integer\", \"minimum\": 0}, {" STRING
                                         ", \"pattern\": \"^0x[0-9a-fA-F]{1,16}$\"}]},\n"
                                         "\t\t\"repeat\": {\"oneOf\": [{" REF(loop) "}, {" ARRAY(
                                             REF(loop)) ", \"minItems\": 1, \"maxItems\": 4}]}";

// Returns a number with this many digits as text, with the exponent of 1e6 instead of 1e+06.
static const char* with_digits(double value, int digits)
{
	static char text[4][32];
	static int next;
	char* to = text[next++ % 4];
	snprintf(to, sizeof text[0], "%.*g", digits, value);
	char* e = strchr(to, 'e');
	if (e)
		snprintf(e + 1, 8, "%d", atoi(e + 1));
	return to;
}

static const char* number(double value) { return with_digits(value, 6); }

// Returns a limit as text, with as many digits as it needs: a rounded limit would be another one.
static const char* limit(double value)
{
	int digits = 6;
	while (digits < 9 && strtod(with_digits(value, digits), NULL) != value)
		++digits;
	return with_digits(value, digits);
}

// Prints the names of a list whose bits are set, with commas between them.
static void print_names(const char* const* names, uint32_t bits, const char* quote)
{
	const char* comma = "";
	for (int k = 0; names[k]; ++k)
	{
		if (!(bits >> k & 1))
			continue;
		printf("%s%s%s%s", comma, quote, names[k], quote);
		comma = ", ";
	}
}

// Prints the text `before`, then the default value of a key. Prints nothing if the key has no default. An unlimited
// number or a set of all bits is a word in a table, and nothing in JSON. json: true for JSON, false for a table.
static void print_default(const FormatKey* key, const char* made, const char* before, bool json)
{
	const char* member = made + key->offset;
	const char* quote = json ? "\"" : "";
	double value = key->special ? NAN : format_stored(member, 0, key->store);
	uint64_t bits = key->type == TYPE_BITS ? *(const uint64_t*)member : 0;
	if (key->special || key->need == NEED_MUST || key->type == TYPE_ROTATION ||
	    (key->store == STORE_FLOAT && isnan(value)))
		return;
	if ((key->type == TYPE_NUMBER && value >= FLT_MAX) || bits == ~(uint64_t)0)
	{
		printf("%s", json ? "" : bits ? "all" : "unlimited");
		return;
	}
	printf("%s", before);
	if (key->type == TYPE_NUMBER || key->type == TYPE_USER)
		printf("%s", number(value));
	else if (key->type == TYPE_PAIR)
		printf("[%s, %s]", number((double)((const float*)member)[0]), number((double)((const float*)member)[1]));
	else if (key->type == TYPE_BOOLEAN)
		printf("%s", *(const bool*)member ? "true" : "false");
	else if (key->type == TYPE_NAME)
		print_names(key->names, 1u << *(const uint32_t*)member, quote);
	else
	{
		printf("[");
		if (key->type == TYPE_NAMES)
			print_names(key->names, *(const uint32_t*)member, quote);
		for (int k = 0, first = 1; k < 64; ++k)
			if (bits >> k & 1)
				printf("%s%d", first-- > 0 ? "" : ", ", k);
		printf("]");
	}
}

static void print_range(Range range)
{
	if (range.low > (double)-FLT_MAX)
		printf(", \"minimum\": %s", limit(range.low));
	if (range.high < (double)FLT_MAX)
		printf(", \"maximum\": %s", limit(range.high));
	if (range.whole)
		printf(", \"multipleOf\": 1");
}

// Prints the definitions that have limits.
static void print_limited(void)
{
	printf(",\n\t\t\"metres\": {" REF(number));
	print_range(any_coordinate);
	printf("},\n\t\t\"point\": {" ARRAY(REF(metres)) ", \"minItems\": 2, \"maxItems\": 2},\n");
	printf("\t\t\"constant\": {" REF(number));
	print_range(any_constant);
	printf("}");
}

static void print_key(const FormatKey* key, size_t index, const char* made)
{
	const char *unit = keys[index].unit, *schema = keys[index].schema;
	printf("\"%s\": {\"description\": \"%s%s%s\"", key->name, unit, *unit ? ": " : "", keys[index].text);
	print_default(key, made, ", \"default\": ", true);
	switch (key->type)
	{
	case TYPE_NUMBER:
		printf(", " REF(number));
		print_range(key->range);
		break;
	case TYPE_PAIR:
		printf(", " REF(vector) ", \"items\": {" REF(number));
		print_range(key->range);
		printf("}");
		break;
	case TYPE_ROTATION:
		printf(", " ARRAY("\"type\": \"number\"") ", \"minItems\": 2, \"maxItems\": 2");
		break;
	case TYPE_USER:
		printf(", " REF(user));
		break;
	case TYPE_BOOLEAN:
		printf(", \"type\": \"boolean\"");
		break;
	case TYPE_BITS:
		printf(", " REF(bits));
		break;
	case TYPE_NAME:
	case TYPE_NAMES:
		printf(key->type == TYPE_NAME ? ", \"enum\": [" : ", \"type\": \"array\", \"items\": {\"enum\": [");
		print_names(key->names, UINT32_MAX, "\"");
		printf(key->type == TYPE_NAME ? "]" : "]}");
		break;
	case TYPE_TEXT:
	case TYPE_OTHER:
		printf(", %s", schema);
		if (key->range.high > 0)
			printf(", \"minItems\": %s, \"maxItems\": %s", number(key->range.low), number(key->range.high));
	}
	printf("}");
}

// Prints the member of the schema that lists those keys of an object whose need is `need`. Prints nothing if the object
// has no such key.
static void print_needs(FormatObject object, FormatNeed need, const char* before, const char* begin, const char* end,
                        const char* after)
{
	bool any = false;
	for (const FormatKey* key = format_keys(object); key->object == object; ++key)
	{
		if (key->need != need)
			continue;
		printf("%s%s\"%s\"%s", any ? ", " : before, begin, key->name, end);
		any = true;
	}
	printf("%s", any ? after : "");
}

static void print_object(FormatObject object, const char* made)
{
	const FormatKey* all = format_keys((FormatObject)0);
	const char* comma = "";
	printf("\t\t\"%s\": {\n\t\t\t\"description\": \"%s\",\n\t\t\t\"type\": \"object\",\n\t\t\t\"properties\": {",
	       objects[object].name, objects[object].text);
	for (const FormatKey* key = format_keys(object); key->object == object; ++key)
	{
		printf("%s\n\t\t\t\t", comma);
		print_key(key, (size_t)(key - all), made);
		comma = ",";
	}
	printf("\n\t\t\t},\n\t\t\t\"additionalProperties\": false");
	print_needs(object, NEED_MUST, ",\n\t\t\t\"required\": [", "", "", "]");
	print_needs(object, NEED_EITHER, ",\n\t\t\t\"oneOf\": [", "{\"required\": [", "]}", "]");
	print_needs(object, NEED_ALONE, ",\n\t\t\t\"dependentRequired\": {", "", ": [\"attribute\"]", "}");
	printf("\n\t\t}");
}

// Prints the type of a key in the words of a table.
static void print_type(const FormatKey* key, size_t index)
{
	static const char* const words[][2] = {[TYPE_NUMBER] = {"number", "whole number"},
	                                       [TYPE_PAIR] = {"2 numbers", "2 whole numbers"},
	                                       [TYPE_ROTATION] = {"cosine and sine"},
	                                       [TYPE_USER] = {"whole number, or hexadecimal digits as \"0x1f\""},
	                                       [TYPE_BOOLEAN] = {"true or false"},
	                                       [TYPE_BITS] = {"list of bits"},
	                                       [TYPE_NAME] = {"one of "},
	                                       [TYPE_NAMES] = {"list of "}};
	const char* unit = keys[index].unit;
	bool numbers = key->type == TYPE_NUMBER || key->type == TYPE_PAIR;
	printf("%s", keys[index].words ? keys[index].words : words[key->type][numbers && key->range.whole]);
	if (key->names)
		print_names(key->names, UINT32_MAX, "");
	printf("%s%s", *unit ? ", " : "", unit);
	bool low = key->range.low > -VISIBLE, high = key->range.high < VISIBLE;
	if (numbers && low && high)
		printf(", %s to %s", limit(key->range.low), limit(key->range.high));
	else if (numbers && (low || high))
		printf(low ? ", at least %s" : ", at most %s", limit(low ? key->range.low : key->range.high));
}

static void print_table(FormatObject object, const char* made)
{
	const FormatKey* all = format_keys((FormatObject)0);
	printf("### %s\n\n%s\n\n| key | value | if missing | meaning |\n| --- | --- | --- | --- |\n", objects[object].name,
	       objects[object].text);
	for (const FormatKey* key = format_keys(object); key->object == object; ++key)
	{
		size_t index = (size_t)(key - all);
		printf("| `%s` | ", key->name);
		print_type(key, index);
		printf(" | %s", key->need == NEED_MUST ? "needed" : key->need == NEED_EITHER ? "one of these" : "");
		print_default(key, made, "", false);
		printf(" | %s |\n", keys[index].text);
	}
	printf("\n");
}

int main(int count, char** arguments)
{
	// default values of the object that the loop below prints, as its struct
	static _Alignas(max_align_t) char made[4096];
	bool schema = count == 2 && strcmp(arguments[1], "schema") == 0;
	if (!schema && !(count == 2 && strcmp(arguments[1], "tables") == 0))
	{
		fprintf(stderr, "usage: scene_lists schema|tables\n");
		return 2;
	}
	if (schema)
	{
		printf("%s%s", beginning, definitions);
		print_limited();
	}
	for (int object = 0; object < FORMAT_OBJECTS; ++object)
	{
		if (objects[object].size > sizeof made)
			return 1;
		format_default((FormatObject)object, made);
		printf("%s", schema ? ",\n" : "");
		(schema ? print_object : print_table)((FormatObject)object, made);
	}
	printf("%s", schema ? "\n\t}\n}\n" : "");
	return 0;
}
