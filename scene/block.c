// SPDX-License-Identifier: MIT
// block.c -- a block of a scene: bodies of one kind, or collidables without a body, repeated over nested loops.
#include "scene/block.h"
#include <stdlib.h>
#include <string.h>

static const char* const body_keys[] = {"name",
                                        "type",
                                        "attribute",
                                        "choose",
                                        "collidables",
                                        "position",
                                        "angle",
                                        "velocity",
                                        "angular_velocity",
                                        "gravity_scale",
                                        "linear_damping",
                                        "angular_damping",
                                        "locks",
                                        "disabled",
                                        "category",
                                        "mask",
                                        "group",
                                        "reports",
                                        "sensor",
                                        "repeat",
                                        "churn",
                                        "description",
                                        NULL};
static const char* const churn_keys[] = {"moved",    "replaced",         "position",    "angle",
                                         "velocity", "angular_velocity", "description", NULL};
static const char* const free_keys[] = {"attribute", "choose",  "position", "angle",  "category",    "mask",
                                        "group",     "reports", "sensor",   "repeat", "description", NULL};

int block_find(const Scene* scene, const char* name)
{
	for (int k = 0; k < scene->block_count; ++k)
	{
		if (strcmp(scene->blocks[k].name, name) == 0)
			return k;
	}
	return -1;
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
	if (block_find(scene, text) >= 0)
		return reader_fail(reader, location, "\"%s\" is the name of bodies above", text);
	strcpy(name, text);
	return true;
}

static bool read_type(Reader* reader, const Location* location, const json_t* value, scree_body_type* type)
{
	static const char* const names[] = {"static", "kinematic", "dynamic"};
	static const scree_body_type types[] = {SCREE_BODY_STATIC, SCREE_BODY_KINEMATIC, SCREE_BODY_DYNAMIC};
	*type = SCREE_BODY_DYNAMIC;
	if (!value)
		return true;
	for (int k = 0; k < 3; ++k)
	{
		if (json_is_string(value) && strcmp(json_string_value(value), names[k]) == 0)
		{
			*type = types[k];
			return true;
		}
	}
	return reader_fail_value(reader, location, value, "must be \"static\", \"kinematic\" or \"dynamic\"");
}

static bool read_locks(Reader* reader, const Location* location, const json_t* value, uint32_t* locks)
{
	static const char* const names[] = {"x", "y", "rotation"};
	static const uint32_t bits[] = {SCREE_LOCK_X, SCREE_LOCK_Y, SCREE_LOCK_ROTATION};
	if (value && !json_is_array(value))
		return reader_fail_value(reader, location, value, "must be a list of \"x\", \"y\" and \"rotation\"");
	for (int k = 0; value && k < (int)json_array_size(value); ++k)
	{
		const json_t* lock = json_array_get(value, (size_t)k);
		uint32_t bit = 0;
		for (int n = 0; n < 3; ++n)
			bit |= json_is_string(lock) && strcmp(json_string_value(lock), names[n]) == 0 ? bits[n] : 0;
		if (bit == 0)
			return reader_fail_value(reader, ELEMENT(location, k), lock, "must be \"x\", \"y\" or \"rotation\"");
		*locks |= bit;
	}
	return true;
}

static bool read_body(Reader* reader, const Location* location, const json_t* value, Block* block)
{
	return read_type(reader, KEY(location, "type"), json_object_get(value, "type"), &block->type) &&
	       reader_pair(reader, location, value, "position", any_coordinate, block->position) &&
	       reader_member(reader, location, value, "angle", any_angle, 0, &block->angle) &&
	       reader_pair(reader, location, value, "velocity", any_speed, block->velocity) &&
	       reader_member(reader, location, value, "angular_velocity", any_speed, 0, &block->angular_velocity) &&
	       reader_member(reader, location, value, "gravity_scale", any_speed, 1, &block->gravity_scale) &&
	       reader_member(reader, location, value, "linear_damping", not_negative, 0, &block->linear_damping) &&
	       reader_member(reader, location, value, "angular_damping", not_negative, 0, &block->angular_damping) &&
	       read_locks(reader, KEY(location, "locks"), json_object_get(value, "locks"), &block->locks) &&
	       reader_boolean(reader, KEY(location, "disabled"), json_object_get(value, "disabled"), &block->disabled);
}

static bool read_share(Reader* reader, const Location* location, const json_t* object, const char* key, int* share)
{
	const json_t* value = json_object_get(object, key);
	double number = 0;
	bool good = !value ||
	            reader_constant(reader, KEY(location, key), value, (Range){0, SCENE_MAX_BODIES, true, false}, &number);
	*share = (int)number;
	return good;
}

static bool read_churn(Reader* reader, const Location* location, const json_t* value, Block* block)
{
	Churn* churn = &block->churn;
	if (!value)
		return true;
	if (!reader_object(reader, location, value, churn_keys) ||
	    !read_share(reader, location, value, "moved", &churn->moved) ||
	    !read_share(reader, location, value, "replaced", &churn->replaced))
		return false;
	if (!json_object_get(value, "position"))
		return reader_fail(reader, location, "position is missing");
	if (!block->parts.simple && churn->replaced > 0)
		return reader_fail(reader, KEY(location, "replaced"),
		                   "a body that is made anew needs attribute, not collidables");
	reader->redraws = true;
	bool good = reader_pair(reader, location, value, "position", any_coordinate, churn->position) &&
	            reader_member(reader, location, value, "angle", any_angle, 0, &churn->angle) &&
	            reader_pair(reader, location, value, "velocity", any_speed, churn->velocity) &&
	            reader_member(reader, location, value, "angular_velocity", any_speed, 0, &churn->angular_velocity);
	reader->redraws = false;
	return good;
}

bool block_read(Reader* reader, const Location* location, const json_t* value, const Scene* scene, bool bodies,
                Block* block)
{
	int names = reader->scope.count;
	block->bodies = bodies;
	bool good = reader_object(reader, location, value, bodies ? body_keys : free_keys) &&
	            read_name(reader, KEY(location, "name"), json_object_get(value, "name"), scene, block->name) &&
	            loops_read(reader, location, value, &block->loops) &&
	            parts_read(reader, location, value, scene, bodies, &block->parts) &&
	            (!bodies || read_body(reader, location, value, block));
	reader->scope.count = names;
	return good && read_churn(reader, KEY(location, "churn"), json_object_get(value, "churn"), block);
}

void block_free(Block* block)
{
	loops_free(&block->loops);
	parts_free(&block->parts);
	free(block->churn.items);
	free(block->poses);
	Number* numbers[] = {&block->position[0],
	                     &block->position[1],
	                     &block->velocity[0],
	                     &block->velocity[1],
	                     &block->angle,
	                     &block->angular_velocity,
	                     &block->gravity_scale,
	                     &block->linear_damping,
	                     &block->angular_damping,
	                     &block->churn.position[0],
	                     &block->churn.position[1],
	                     &block->churn.velocity[0],
	                     &block->churn.velocity[1],
	                     &block->churn.angle,
	                     &block->churn.angular_velocity};
	for (size_t k = 0; k < sizeof numbers / sizeof numbers[0]; ++k)
		number_free(numbers[k]);
}
