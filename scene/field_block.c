// SPDX-License-Identifier: MIT
// field_block.c -- reads the fields of a scene and the explosions between its steps, and creates them in a world.
#include "scene/field_block.h"
#include "scene/attribute_block.h"
#include "scene/block_items.h"
#include "scene/format.h"
#include "scene/joint_block.h"
#include <stdlib.h>

typedef struct // entry of "fields" or "blasts"; each of its items is added to the scene
{
	Scene* scene;
	Reader* reader;
	const Location* location;
	FormatNumbers numbers;
	// only for a field
	scree_field_def def;
	JointEnd body;
	// only for an explosion
	SceneBlast blast;
} Entry;

// Makes room for another entry in a list of the scene. size: bytes of an entry. Fails if there is no memory or the list
// is too long.
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
	if (!items_store(items, &e->numbers, &field.def) ||
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
	SceneBlast blast = e->blast;
	if (!items_store(items, &e->numbers, &blast) ||
	    !grow(e, (void**)&e->scene->blasts, e->scene->blast_count, sizeof blast))
		return false;
	e->scene->blasts[e->scene->blast_count++] = blast;
	return true;
}

static bool read_region(Entry* e, const json_t* value)
{
	const char* name;
	const Location* at = KEY(e->location, "attribute");
	if (!json_object_get(value, "attribute"))
		return true;
	if (!reader_string(e->reader, at, json_object_get(value, "attribute"), &name))
		return false;
	int found;
	if (!attributes_find(e->scene, e->reader, at, name, &found))
		return false;
	e->def.shape = e->scene->attributes[found].def.shape;
	if (e->def.type == SCREE_FIELD_BUOYANCY && (e->def.shape.kind != SCREE_SHAPE_POLYGON || e->def.shape.radius > 0.0f))
		return reader_fail(e->reader, at, "a fluid needs a box or a polygon without rounding, and \"%.60s\" is none",
		                   name);
	return true;
}

static bool read_field(Entry* e, const json_t* value)
{
	uint32_t type;
	const json_t* body = json_object_get(value, "body");
	if (!reader_name(e->reader, KEY(e->location, "type"), json_object_get(value, "type"), field_type_names, &type))
		return false;
	e->def = scree_field_def_default((scree_field_type)type);
	e->body.block = -1;
	return read_region(e, value) &&
	       (!body || joint_end_read(e->reader, KEY(e->location, "body"), body, e->scene, &e->body)) &&
	       format_read(e->reader, e->location, value, OBJECT_field, &e->def, 0, &e->numbers);
}

static bool read_blast(Entry* e, const json_t* value)
{
	format_default(OBJECT_blast, &e->blast);
	return format_read(e->reader, e->location, value, OBJECT_blast, &e->blast, 0, &e->numbers);
}

static bool read_list(Reader* reader, const json_t* root, Scene* scene, bool fields)
{
	const char* key = fields ? "fields" : "blasts";
	const json_t* list = json_object_get(root, key);
	bool good = reader_list(reader, KEY(NULL, key), list);
	for (int k = 0; good && k < (int)json_array_size(list); ++k)
	{
		const Location* at = ELEMENT(KEY(NULL, key), k);
		const json_t* value = json_array_get(list, (size_t)k);
		int names = reader->scope.count;
		Loops loops = {0};
		Entry e = {.scene = scene, .reader = reader, .location = at};
		good = format_check(reader, at, value, fields ? OBJECT_field : OBJECT_blast) &&
		       loops_read(reader, at, value, &loops) && (fields ? read_field(&e, value) : read_blast(&e, value)) &&
		       block_items_run(reader, &loops, fields ? add_field : add_blast, &e);
		reader->scope.count = names;
		loops_free(&loops);
		number_free(&e.body.index);
		format_free(&e.numbers);
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
