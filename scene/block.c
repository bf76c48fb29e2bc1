// SPDX-License-Identifier: MIT
// block.c -- reads a block of a scene: bodies of one kind, or collidables without a body, repeated over nested loops.
#include "scene/block.h"
#include "scene/format.h"
#include "scene/names.h"
#include <stdlib.h>
#include <string.h>

bool block_read_name(Reader* reader, const Location* location, const json_t* value, const Scene* scene, int* block)
{
	const char* name;
	if (!reader_string(reader, location, value, &name))
		return false;
	return names_find(&scene->names->blocks, reader, location, name, block) &&
	       (*block >= 0 || reader_fail(reader, location, "\"%.60s\" is not the name of an entry of bodies", name));
}

int block_first(const Scene* scene, int block)
{
	int64_t first = 0;
	for (int k = 0; k < block; ++k)
		first += scene->blocks[k].bodies ? scene->blocks[k].count : 0;
	return (int)first;
}

static bool read_name(Reader* reader, const Location* location, const json_t* value, const Scene* scene, char* name)
{
	const char* text;
	if (!value)
		return true;
	if (!reader_string(reader, location, value, &text))
		return false;
	if (strlen(text) >= NAME_SIZE)
		return reader_fail(reader, location, "a name has 1 to %d characters", NAME_SIZE - 1);
	int above;
	if (!names_find(&scene->names->blocks, reader, location, text, &above))
		return false;
	if (above >= 0)
		return reader_fail(reader, location, "\"%s\" is the name of bodies above", text);
	strcpy(name, text);
	return names_add(&scene->names->blocks, name, scene->block_count - 1) ||
	       reader_fail(reader, location, "out of memory");
}

static bool read_share(Reader* reader, const Location* location, const json_t* object, const char* key, int* share)
{
	const json_t* value = json_object_get(object, key);
	double number = 0;
	bool good = !value || reader_constant(reader, KEY(location, key), value, format_range(OBJECT_churn, key), &number);
	*share = (int)number;
	return good;
}

static bool read_churn(Reader* reader, const Location* location, const json_t* value, Block* block)
{
	Churn* churn = &block->churn;
	if (!value)
		return true;
	format_default(OBJECT_churn, churn);
	if (!format_check(reader, location, value, OBJECT_churn) ||
	    !read_share(reader, location, value, "moved", &churn->moved) ||
	    !read_share(reader, location, value, "replaced", &churn->replaced))
		return false;
	if (!block->parts.simple && churn->replaced > 0)
		return reader_fail(reader, KEY(location, "replaced"),
		                   "a body that is made anew needs attribute, not collidables");
	reader->redraws = true;
	bool good = format_read(reader, location, value, OBJECT_churn, churn, 0, &block->churn_numbers);
	reader->redraws = false;
	return good;
}

static bool read_mass(Reader* reader, const Location* location, const json_t* value, Block* block)
{
	if (!value)
		return true;
	block->massed = true;
	format_default(OBJECT_mass, &block->mass);
	if (block->def.type != SCREE_BODY_DYNAMIC)
		return reader_fail(reader, location, "only a dynamic body has a mass");
	if (!format_check(reader, location, value, OBJECT_mass) ||
	    !format_read(reader, location, value, OBJECT_mass, &block->mass, 0, &block->mass_numbers))
		return false;
	return block->mass.inertia == 0.0f || block->mass.inertia >= 1e-20f ||
	       reader_fail_value(reader, KEY(location, "inertia"), json_object_get(value, "inertia"), "is too close to 0");
}

static bool read_centered(Reader* reader, const Location* location, const json_t* value, Block* block)
{
	const char* key = "center_velocity";
	block->centered = block->massed;
	return reader_boolean(reader, KEY(location, key), json_object_get(value, key), &block->centered);
}

bool block_read(Reader* reader, const Location* location, const json_t* value, const Scene* scene, bool bodies,
                Block* block)
{
	int names = reader->scope.count;
	block->bodies = bodies;
	format_default(OBJECT_body, &block->def);
	bool good = format_check(reader, location, value, bodies ? OBJECT_body : OBJECT_collidable) &&
	            read_name(reader, KEY(location, "name"), json_object_get(value, "name"), scene, block->name) &&
	            loops_read(reader, location, value, &block->loops) &&
	            parts_read(reader, location, value, scene, bodies, &block->parts) &&
	            (!bodies || format_read(reader, location, value, OBJECT_body, &block->def, 0, &block->numbers)) &&
	            read_mass(reader, KEY(location, "mass"), json_object_get(value, "mass"), block) &&
	            read_centered(reader, location, value, block);
	reader->scope.count = names;
	if (!good || !read_churn(reader, KEY(location, "churn"), json_object_get(value, "churn"), block))
		return false;
	return !block->massed || block->churn.replaced == 0 ||
	       reader_fail(reader, KEY(location, "mass"), "the bodies are replaced, which ends their mass");
}

void block_free(Block* block)
{
	loops_free(&block->loops);
	parts_free(&block->parts);
	free(block->churn.items);
	free(block->poses);
	format_free(&block->numbers);
	format_free(&block->churn_numbers);
	format_free(&block->mass_numbers);
}
