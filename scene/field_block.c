// SPDX-License-Identifier: MIT
// field_block.c -- the fields of a scene, and the explosions that it sets off between steps.
#include "scene/field_block.h"
#include "scene/attribute_block.h"
#include "scene/block_items.h"
#include "scene/joint_block.h"
#include "scene/part.h"
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#define MOST_FIELDS  100000 // of a scene, and explosions
#define MOST_NUMBERS 20

static const Range any_strength = {-1e12, 1e12, false, false};
static const Range no_less = {0, 1e12, false, false};
static const Range any_falloff = {0.001, SCREE_MAX_COORDINATE, false, false};
static const Range any_step = {0, 1e9, true, false};
static const Range any_reach = {0, SCREE_MAX_COORDINATE, false, false};

typedef struct // a number of a definition, or the first of two
{
	const char* key;
	size_t offset;
	const Range* range;
	bool pair;
} Member;

#define FIELD(member, range, pair)                                   \
	{                                                                \
#member, offsetof(scree_field_def, member), (&range), (pair) \
	}
static const Member field_members[] = {FIELD(acceleration, any_strength, true),
                                       FIELD(force, any_strength, true),
                                       FIELD(strength, any_strength, false),
                                       FIELD(radius, any_falloff, false),
                                       FIELD(softening, any_reach, false),
                                       FIELD(velocity, any_coordinate, true),
                                       FIELD(density, no_less, false),
                                       FIELD(drag, no_less, false),
                                       FIELD(lift, no_less, false),
                                       FIELD(linear_drag, no_less, false),
                                       FIELD(quadratic_drag, no_less, false),
                                       FIELD(spin_drag, no_less, false),
                                       FIELD(spin_drag_quadratic, no_less, false),
                                       {NULL, 0, NULL, false}};
#define BLAST(member, range, pair)                                   \
	{                                                                \
#member, offsetof(scree_blast_def, member), (&range), (pair) \
	}
static const Member blast_members[] = {BLAST(position, any_coordinate, true),
                                       BLAST(radius, any_reach, false),
                                       BLAST(falloff, any_reach, false),
                                       BLAST(impulse, any_strength, false),
                                       {NULL, 0, NULL, false}};

static const char* const field_keys[] = {"type",        "attribute",
                                         "body",        "position",
                                         "angle",       "disabled",
                                         "category",    "mask",
                                         "falloff",     "acceleration",
                                         "force",       "strength",
                                         "radius",      "softening",
                                         "velocity",    "density",
                                         "drag",        "lift",
                                         "linear_drag", "quadratic_drag",
                                         "spin_drag",   "spin_drag_quadratic",
                                         "repeat",      "description",
                                         NULL};
static const char* const blast_keys[] = {"step",     "position", "radius", "falloff",     "impulse",
                                         "category", "mask",     "repeat", "description", NULL};
static const char* const types[] = {"uniform", "radial", "vortex", "drag", "wind", "buoyancy", NULL};
static const char* const falloffs[] = {"constant", "linear", "inverse", "inverse_square", NULL};

typedef struct // an entry of the file, whose items are added to the scene
{
	Scene* scene;
	Reader* reader;
	const Location* location;
	const Member* members;
	Number numbers[MOST_NUMBERS][2]; // of each member that the file has
	bool there[MOST_NUMBERS];
	// of a field
	scree_field_def def;
	JointEnd body;
	Number position[2], angle;
	// of an explosion
	scree_blast_def blast;
	Number step;
} Entry;

static bool read_numbers(Entry* e, const json_t* value)
{
	for (int k = 0; e->members[k].key; ++k)
	{
		const Member* m = &e->members[k];
		const json_t* number = json_object_get(value, m->key);
		e->there[k] = number != NULL;
		if (!number)
			continue;
		if (m->pair ? !reader_pair(e->reader, e->location, value, m->key, *m->range, e->numbers[k])
		            : !reader_number(e->reader, KEY(e->location, m->key), number, *m->range, e->numbers[k]))
			return false;
	}
	return true;
}

static void free_entry(Entry* e)
{
	for (int k = 0; e->members[k].key; ++k)
		for (int i = 0; i < 2; ++i)
			number_free(&e->numbers[k][i]);
	for (int i = 0; i < 2; ++i)
		number_free(&e->position[i]);
	number_free(&e->angle);
	number_free(&e->body.index);
	number_free(&e->step);
}

static bool evaluate(const Items* items, const Entry* e, void* def)
{
	for (int k = 0; e->members[k].key; ++k)
	{
		float* place = (float*)((char*)def + e->members[k].offset);
		if (e->there[k] && (!items_float(items, &e->numbers[k][0], place) ||
		                    (e->members[k].pair && !items_float(items, &e->numbers[k][1], place + 1))))
			return false;
	}
	return true;
}

// Room for one more in a list of the scene.
static bool grow(const Entry* e, void** list, int count, size_t size)
{
	if (count >= MOST_FIELDS)
		return reader_fail(e->reader, e->location, "more than %d in a scene", MOST_FIELDS);
	void* larger = (count & (count - 1)) == 0 ? realloc(*list, size * (size_t)(count > 0 ? 2 * count : 1)) : *list;
	*list = larger ? larger : *list;
	return larger || reader_fail(e->reader, e->location, "out of memory");
}

static bool add_field(Items* items, void* context)
{
	Entry* e = context;
	SceneField field = {.def = e->def, .block = e->body.block};
	double index = 0;
	if (!evaluate(items, e, &field.def) || !items_pose(items, e->position, &e->angle, &field.def.pose) ||
	    (field.block >= 0 && !items_value(items, &e->body.index, &index)) ||
	    !grow(e, (void**)&e->scene->fields, e->scene->field_count, sizeof field))
		return false;
	field.index = (int)index;
	e->scene->fields[e->scene->field_count++] = field;
	return true;
}

static bool add_blast(Items* items, void* context)
{
	Entry* e = context;
	SceneBlast blast = {.def = e->blast};
	double step;
	if (!evaluate(items, e, &blast.def) || !items_value(items, &e->step, &step) ||
	    !grow(e, (void**)&e->scene->blasts, e->scene->blast_count, sizeof blast))
		return false;
	blast.step = (int64_t)step;
	e->scene->blasts[e->scene->blast_count++] = blast;
	return true;
}

// The position of a name in a list that ends with null.
static bool read_name(const Entry* e, const json_t* value, const char* key, const char* const* names, int* found)
{
	char must[160] = "must be one of ";
	const json_t* name = json_object_get(value, key);
	for (int k = 0; names[k]; ++k)
	{
		if (json_is_string(name) && strcmp(json_string_value(name), names[k]) == 0)
		{
			*found = k;
			return true;
		}
		snprintf(must + strlen(must), sizeof must - strlen(must), "%s%s", k ? ", " : "", names[k]);
	}
	return name ? reader_fail_value(e->reader, KEY(e->location, key), name, must)
	            : reader_fail(e->reader, e->location, "%s is missing, %s", key, must);
}

static bool read_region(Entry* e, const json_t* value)
{
	const char* name;
	const Location* at = KEY(e->location, "attribute");
	if (!json_object_get(value, "attribute"))
		return true;
	if (!reader_string(e->reader, at, json_object_get(value, "attribute"), &name))
		return false;
	int found = attributes_find(e->scene, name);
	if (found < 0)
		return reader_fail(e->reader, at, "\"%.60s\" is not among the attributes", name);
	e->def.shape = e->scene->attributes[found].def.shape;
	if (e->def.type == SCREE_FIELD_BUOYANCY && (e->def.shape.kind != SCREE_SHAPE_POLYGON || e->def.shape.radius > 0.0f))
		return reader_fail(e->reader, at, "a fluid needs a box or a polygon without rounding, and \"%.60s\" is none",
		                   name);
	return true;
}

static bool read_field(Entry* e, const json_t* value)
{
	int type = 0, falloff = SCREE_FALLOFF_INVERSE_SQUARE;
	const json_t* body = json_object_get(value, "body");
	if (!read_name(e, value, "type", types, &type) ||
	    (json_object_get(value, "falloff") && !read_name(e, value, "falloff", falloffs, &falloff)))
		return false;
	e->def = scree_field_def_default((scree_field_type)type);
	e->def.falloff = (scree_field_falloff)falloff;
	e->body.block = -1;
	return read_region(e, value) &&
	       (!body || joint_end_read(e->reader, KEY(e->location, "body"), body, e->scene, &e->body)) &&
	       reader_bits(e->reader, e->location, value, "category", &e->def.category) &&
	       reader_bits(e->reader, e->location, value, "mask", &e->def.mask) &&
	       reader_boolean(e->reader, KEY(e->location, "disabled"), json_object_get(value, "disabled"),
	                      &e->def.disabled) &&
	       (!json_object_get(value, "position") ||
	        reader_pair(e->reader, e->location, value, "position", any_coordinate, e->position)) &&
	       reader_member(e->reader, e->location, value, "angle", any_angle, 0, &e->angle) && read_numbers(e, value);
}

static bool read_blast(Entry* e, const json_t* value)
{
	e->blast = scree_blast_def_default();
	if (!json_object_get(value, "step"))
		return reader_fail(e->reader, e->location, "step is missing");
	return reader_member(e->reader, e->location, value, "step", any_step, 0, &e->step) &&
	       reader_bits(e->reader, e->location, value, "category", &e->blast.category) &&
	       reader_bits(e->reader, e->location, value, "mask", &e->blast.mask) && read_numbers(e, value);
}

static bool read_list(Reader* reader, const json_t* root, Scene* scene, bool fields)
{
	const char* key = fields ? "fields" : "blasts";
	const json_t* list = json_object_get(root, key);
	if (list && !json_is_array(list))
		return reader_fail_value(reader, KEY(NULL, key), list, "must be a list, [ ... ]");
	bool good = true;
	for (int k = 0; good && k < (int)json_array_size(list); ++k)
	{
		const Location* at = ELEMENT(KEY(NULL, key), k);
		const json_t* value = json_array_get(list, (size_t)k);
		int names = reader->scope.count;
		Loops loops = {0};
		Entry e = {.scene = scene, .reader = reader, .location = at, .members = fields ? field_members : blast_members};
		good = reader_object(reader, at, value, fields ? field_keys : blast_keys) &&
		       loops_read(reader, at, value, &loops) && (fields ? read_field(&e, value) : read_blast(&e, value)) &&
		       items_run(reader, &loops, fields ? add_field : add_blast, &e);
		reader->scope.count = names;
		loops_free(&loops);
		free_entry(&e);
	}
	return good;
}

bool fields_read(Reader* reader, const json_t* root, Scene* scene) { return read_list(reader, root, scene, true); }
bool blasts_read(Reader* reader, const json_t* root, Scene* scene) { return read_list(reader, root, scene, false); }

scree_status field_build(const SceneField* field, scree_world* world, scree_body body)
{
	scree_field_def def = field->def;
	def.body = body;
	return scree_field_create(world, &def, NULL);
}

scree_status blasts_fire(const Scene* scene, scree_world* world, int64_t step)
{
	scree_status status = SCREE_OK;
	for (int k = 0; k < scene->blast_count && status == SCREE_OK; ++k)
		if (scene->blasts[k].step == step)
			status = scree_world_blast(world, &scene->blasts[k].def, NULL);
	return status;
}
