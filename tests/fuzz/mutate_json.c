// SPDX-License-Identifier: MIT
// mutate_json.c -- changes a scene file at random, and keeps it JSON with keys of the format.
#include "fuzz/mutate_json.h"
#include "scene/format.h"
#include "tools/common/random_numbers.h"
#include <string.h>

#define MOST_VALUES 4096

typedef struct // places of all values of a text; those of the root have no parent
{
	json_t *parents[MOST_VALUES], *values[MOST_VALUES];
	const char* keys[MOST_VALUES]; // key of a member; null for an element
	size_t indices[MOST_VALUES];   // index of an element
	int count;
	uint64_t seed;
} Values;

static void list_values(Values* v, json_t* value)
{
	const char* key;
	json_t* child;
	json_object_foreach(value, key, child)
	{
		if (v->count == MOST_VALUES)
			return;
		v->parents[v->count] = value;
		v->values[v->count] = child;
		v->keys[v->count++] = key;
		list_values(v, child);
	}
	for (size_t k = 0; k < json_array_size(value) && v->count < MOST_VALUES; ++k)
	{
		v->parents[v->count] = value;
		v->values[v->count] = json_array_get(value, k);
		v->indices[v->count] = k;
		v->keys[v->count++] = NULL;
		list_values(v, json_array_get(value, k));
	}
}

// Returns a key of the format, of any object.
static const char* any_key(Values* v)
{
	static int count;
	const FormatKey* keys = format_keys((FormatObject)0);
	while (keys[count].object != FORMAT_OBJECTS)
		++count;
	return keys[random_below(&v->seed, count)].name;
}

static json_t* any_number(Values* v)
{
	static const double numbers[] = {0.0,   -0.0,   1.0,  -1.0,  0.5,       2.0,        3.0,          63.0,
	                                 64.0,  1e-3,   1e-6, 1e-30, 1e5,       -1e5,       1e6,          99999.0,
	                                 1e9,   1e12,   1e15, 1e38,  1e300,     255.0,      256.0,        65536.0,
	                                 1e-45, 5e-324, 1e7,  300.0, 6.2831853, 16777216.0, 2147483647.0, 9e15};
	if (random_below(&v->seed, 3) == 0)
		return json_integer(random_below(&v->seed, 12) - 2);
	return json_real(numbers[random_below(&v->seed, (int)(sizeof numbers / sizeof *numbers))]);
}

static json_t* any_text(Values* v)
{
	static const char* const texts[] = {"i",
	                                    "i + 1",
	                                    "random(0, 1)",
	                                    "random(-5, 5) * i",
	                                    "1 / i",
	                                    "mod(i, 3)",
	                                    "sqrt(i - 1)",
	                                    "sin(i) * 1e9",
	                                    "((((i))))",
	                                    "-(-i)",
	                                    "floor(i / 2)",
	                                    "1e308 * 10",
	                                    "max(i, 2)",
	                                    "a",
	                                    "b",
	                                    "dynamic",
	                                    "kinematic",
	                                    "static",
	                                    "revolute",
	                                    "path",
	                                    "gear",
	                                    "pulley",
	                                    "weld",
	                                    "prismatic",
	                                    "radial",
	                                    "buoyancy",
	                                    "left",
	                                    "x\x1b[31m",
	                                    ""};
	return json_string(texts[random_below(&v->seed, (int)(sizeof texts / sizeof *texts))]);
}

// Returns a new value, or a copy of a value of the text.
static json_t* any_value(Values* v)
{
	switch (random_below(&v->seed, 8))
	{
	case 0:
	case 1:
		return any_number(v);
	case 2:
		return any_text(v);
	case 3:
		return random_below(&v->seed, 2) ? json_boolean(random_below(&v->seed, 2)) : json_null();
	case 4:
		return random_below(&v->seed, 2) ? json_pack("{s:s,s:i}", "index", "i", "to", random_below(&v->seed, 9))
		                                 : json_pack("[ff]", 1.0, 2.0);
	default:
		return json_deep_copy(v->values[random_below(&v->seed, v->count)]);
	}
}

static void change_value(Values* v)
{
	int k = random_below(&v->seed, v->count);
	json_t *parent = v->parents[k], *value = v->values[k];
	int change = random_below(&v->seed, 8);
	if (change == 0 && json_is_object(value))
		json_object_set_new(value, any_key(v), any_value(v));
	else if (change <= 1 && json_is_array(value))
		json_array_append_new(value, any_value(v));
	else if (change == 2 && v->keys[k])
		json_object_del(parent, v->keys[k]);
	else if (change == 2)
		json_array_remove(parent, v->indices[k]);
	else if (change == 3 && v->keys[k] && json_is_object(parent))
		json_object_set_new(parent, any_key(v), json_deep_copy(value));
	else
	{
		// a number mostly stays a number, and a text a text
		bool kept = random_below(&v->seed, 4) > 0;
		json_t* other = json_is_number(value) && kept   ? (random_below(&v->seed, 3) ? any_number(v) : any_text(v))
		                : json_is_string(value) && kept ? any_text(v)
		                                                : any_value(v);
		if (v->keys[k])
			json_object_set_new(parent, v->keys[k], other);
		else
			json_array_set_new(parent, v->indices[k], other);
	}
}

size_t mutate_json(uint8_t* text, size_t size, size_t most, uint64_t seed)
{
	static Values v;
	json_t* root = json_loadb((const char*)text, size, 0, NULL);
	v.seed = seed;
	for (int k = 1 + random_below(&v.seed, 4); root && k > 0; --k)
	{
		v.count = 0;
		list_values(&v, root);
		if (v.count > 0)
			change_value(&v);
	}
	size_t written = root ? json_dumpb(root, (char*)text, most, JSON_COMPACT | JSON_REAL_PRECISION(9)) : 0;
	json_decref(root);
	return written <= most ? written : 0;
}
