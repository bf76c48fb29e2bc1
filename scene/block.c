// SPDX-License-Identifier: MIT
// block.c -- reading one block of a scene: like bodies, or collidables without a body.
#include "scene/block.h"
#include <stdlib.h>
#include <string.h>

static const Range any_index = {-1e9, 1e9, true, false};

static const char* const body_keys[] = {"type",
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
                                        "category",
                                        "mask",
                                        "group",
                                        "repeat",
                                        "churn",
                                        "description",
                                        NULL};
static const char* const churn_keys[] = {"moved",    "replaced",         "position",    "angle",
                                         "velocity", "angular_velocity", "description", NULL};
static const char* const free_keys[] = {"attribute", "choose", "position", "angle",       "category",
                                        "mask",      "group",  "repeat",   "description", NULL};
static const char* const part_keys[] = {"attribute", "choose", "position", "angle", "category",
                                        "mask",      "group",  "repeat",   NULL};
static const char* const loop_keys[] = {"index", "from", "to", NULL};

static bool read_number(Reader* reader, const Place* place, const json_t* object, const char* key, Range range,
                        double missing, Number* number)
{
	const json_t* value = json_object_get(object, key);
	*number = (Number){.constant = missing, .range = range};
	return !value || reader_number(reader, KEY(place, key), value, range, number);
}

static bool read_pair(Reader* reader, const Place* place, const json_t* object, const char* key, Range range,
                      Number pair[2])
{
	const json_t* value = json_object_get(object, key);
	pair[0] = pair[1] = (Number){.range = range};
	if (!value)
		return true;
	const Place* at = KEY(place, key);
	if (!json_is_array(value) || json_array_size(value) != 2)
		return reader_fail_value(reader, at, value, "must be a list of 2 numbers");
	return reader_number(reader, ELEMENT(at, 0), json_array_get(value, 0), range, &pair[0]) &&
	       reader_number(reader, ELEMENT(at, 1), json_array_get(value, 1), range, &pair[1]);
}

// A list of bit numbers, because a JSON number cannot hold 64 bits.
static bool read_bits(Reader* reader, const Place* place, const json_t* object, const char* key, uint64_t* bits)
{
	const json_t* value = json_object_get(object, key);
	if (!value)
		return true;
	const Place* at = KEY(place, key);
	if (!json_is_array(value))
		return reader_fail_value(reader, at, value, "must be a list of bits, 0 to 63");
	*bits = 0;
	for (int k = 0; k < (int)json_array_size(value); ++k)
	{
		double bit;
		if (!reader_constant(reader, ELEMENT(at, k), json_array_get(value, (size_t)k), (Range){0, 63, true, false},
		                     &bit))
			return false;
		*bits |= (uint64_t)1 << (int)bit;
	}
	return true;
}

static bool read_filter(Reader* reader, const Place* place, const json_t* object, scree_filter* filter)
{
	*filter = scree_filter_default();
	const json_t* group = json_object_get(object, "group");
	double number = 0;
	if (group && !reader_constant(reader, KEY(place, "group"), group, (Range){-1e9, 1e9, true, false}, &number))
		return false;
	filter->group = (int32_t)number;
	return read_bits(reader, place, object, "category", &filter->category) &&
	       read_bits(reader, place, object, "mask", &filter->mask);
}

static bool read_attribute_name(Reader* reader, const Place* place, const json_t* value, const Scene* scene, int* found)
{
	const char* name;
	if (!reader_string(reader, place, value, &name))
		return false;
	*found = attributes_find(scene, name);
	return *found >= 0 || reader_fail(reader, place, "\"%.60s\" is not among the attributes", name);
}

static bool read_choice(Reader* reader, const Place* place, const json_t* object, const Scene* scene, Choice* choice)
{
	const json_t* value = json_object_get(object, "attribute");
	const json_t* choose = json_object_get(object, "choose");
	const Place* at = KEY(place, "attribute");
	if (!value)
		return reader_fail(reader, place, "attribute is missing");
	bool list = json_is_array(value);
	choice->count = list ? (int)json_array_size(value) : 1;
	if (choice->count == 0)
		return reader_fail(reader, at, "an empty list");
	choice->attributes = calloc((size_t)choice->count, sizeof(int));
	if (!choice->attributes)
		return reader_fail(reader, at, "out of memory");
	for (int k = 0; k < choice->count; ++k)
	{
		const json_t* name = list ? json_array_get(value, (size_t)k) : value;
		if (!read_attribute_name(reader, list ? ELEMENT(at, k) : at, name, scene, &choice->attributes[k]))
			return false;
	}
	if (choice->count == 1 && choose)
		return reader_fail(reader, place, "choose needs a list of attributes to choose from");
	if (choice->count > 1 && !choose)
		return reader_fail(reader, place,
		                   "a list of attributes needs choose, an expression that picks one by position");
	// the whole part counts, so that random(0, 3) picks evenly from 3
	Range range = {0, choice->count - 1, false, true};
	return read_number(reader, place, object, "choose", range, 0, &choice->choose);
}

static bool read_part(Reader* reader, const Place* place, const json_t* value, const Scene* scene, Part* part)
{
	return read_choice(reader, place, value, scene, &part->choice) &&
	       read_pair(reader, place, value, "position", any_coordinate, part->position) &&
	       read_number(reader, place, value, "angle", any_angle, 0, &part->angle) &&
	       read_filter(reader, place, value, &part->filter);
}

static bool read_loop(Reader* reader, const Place* place, const json_t* value, Loop* loop)
{
	const char* index;
	if (!reader_object(reader, place, value, loop_keys))
		return false;
	if (!json_object_get(value, "to"))
		return reader_fail(reader, place, "to is missing");
	if (!reader_string(reader, KEY(place, "index"), json_object_get(value, "index"), &index))
		return false;
	if (!name_is_allowed(index) || scope_find(&reader->scope, index))
		return reader_fail(reader, KEY(place, "index"), "\"%.40s\" is taken or is no name in small letters", index);
	strcpy(loop->index, index);
	return read_number(reader, place, value, "from", any_index, 0, &loop->first) &&
	       read_number(reader, place, value, "to", any_index, 0, &loop->end);
}

// Lets expressions name an index: by slot when it varies from item to item, else (slot -1) by its value.
static bool add_index(Reader* reader, const Place* place, const Loop* loop, int slot, double value)
{
	if (reader->scope.count == MAX_NAMES)
		return reader_fail(reader, place, "more than %d names", MAX_NAMES);
	Name* name = &reader->scope.names[reader->scope.count++];
	*name = (Name){.slot = slot, .value = value};
	strcpy(name->text, loop->index);
	return true;
}

// Reads nested loops; each index is known to the loops inside it.
static bool read_loops(Reader* reader, const Place* place, const json_t* value, Block* block)
{
	bool list = json_is_array(value);
	size_t count = list ? json_array_size(value) : 1;
	if (count > MAX_LOOPS)
		return reader_fail(reader, place, "%zu nested ranges, at most %d are allowed", count, MAX_LOOPS);
	for (int k = 0; k < (int)count; ++k)
	{
		const json_t* entry = list ? json_array_get(value, (size_t)k) : value;
		const Place* at = list ? ELEMENT(place, k) : place;
		++block->loop_count;
		if (!read_loop(reader, at, entry, &block->loops[k]) || !add_index(reader, at, &block->loops[k], k, 0))
			return false;
	}
	return true;
}

// Room for more parts; returns the first of them.
static Part* add_parts(Block* block, int count)
{
	Part* parts = realloc(block->parts, (size_t)(block->part_count + count) * sizeof(Part));
	if (!parts)
		return NULL;
	block->parts = parts;
	memset(parts + block->part_count, 0, (size_t)count * sizeof(Part));
	block->part_count += count;
	return parts + block->part_count - count;
}

// Reads one entry of a body's collidables. With a repeat it is read once for each value of the index, which is a
// constant to it: all items of a block have equally many collidables.
static bool read_part_entry(Reader* reader, const Place* place, const json_t* value, const Scene* scene, Block* block)
{
	if (!reader_object(reader, place, value, part_keys))
		return false;
	const json_t* repeat = json_object_get(value, "repeat");
	Loop loop = {0};
	int first = 0, count = 1;
	if (repeat)
	{
		const Place* at = KEY(place, "repeat");
		if (!read_loop(reader, at, repeat, &loop))
			return false;
		bool varies = loop.first.code || loop.end.code;
		first = (int)loop.first.constant;
		double span = loop.end.constant - loop.first.constant;
		number_free(&loop.first);
		number_free(&loop.end);
		if (varies || span < 0 || span > BATCH_SIZE - block->part_count)
			return reader_fail(reader, at, "must give the same 0 to %d collidables to each body", BATCH_SIZE);
		count = (int)span;
	}
	Part* part = add_parts(block, count);
	if (!part)
		return reader_fail(reader, place, "out of memory");
	for (int k = 0; k < count; ++k)
	{
		int names = reader->scope.count;
		if (repeat && !add_index(reader, place, &loop, -1, first + k))
			return false;
		if (!read_part(reader, place, value, scene, &part[k]))
			return false;
		reader->scope.count = names;
	}
	return true;
}

static bool read_parts(Reader* reader, const Place* place, const json_t* value, const Scene* scene, Block* block)
{
	static const char* const of_parts[] = {"attribute", "choose", "category", "mask", "group", NULL};
	const json_t* list = json_object_get(value, "collidables");
	block->simple = !list;
	if (!list)
	{
		Part* part = add_parts(block, 1);
		if (!part)
			return reader_fail(reader, place, "out of memory");
		if (!read_choice(reader, place, value, scene, &part->choice) ||
		    !read_filter(reader, place, value, &part->filter))
			return false;
		return block->bodies || (read_pair(reader, place, value, "position", any_coordinate, part->position) &&
		                         read_number(reader, place, value, "angle", any_angle, 0, &part->angle));
	}
	if (!json_is_array(list))
		return reader_fail_value(reader, KEY(place, "collidables"), list, "must be a list, [ ... ]");
	for (const char* const* key = of_parts; *key; ++key)
	{
		if (json_object_get(value, *key))
			return reader_fail(reader, place, "%s belongs into each of the collidables", *key);
	}
	for (int k = 0; k < (int)json_array_size(list); ++k)
	{
		const Place* at = ELEMENT(KEY(place, "collidables"), k);
		if (!read_part_entry(reader, at, json_array_get(list, (size_t)k), scene, block))
			return false;
	}
	return block->part_count > 0 || reader_fail(reader, KEY(place, "collidables"), "an empty list");
}

static bool read_type(Reader* reader, const Place* place, const json_t* value, scree_body_type* type)
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
	return reader_fail_value(reader, place, value, "must be \"static\", \"kinematic\" or \"dynamic\"");
}

static bool read_locks(Reader* reader, const Place* place, const json_t* value, uint32_t* locks)
{
	static const char* const names[] = {"x", "y", "rotation"};
	static const uint32_t bits[] = {SCREE_LOCK_X, SCREE_LOCK_Y, SCREE_LOCK_ROTATION};
	if (value && !json_is_array(value))
		return reader_fail_value(reader, place, value, "must be a list of \"x\", \"y\" and \"rotation\"");
	for (int k = 0; value && k < (int)json_array_size(value); ++k)
	{
		const json_t* lock = json_array_get(value, (size_t)k);
		uint32_t bit = 0;
		for (int n = 0; n < 3; ++n)
			bit |= json_is_string(lock) && strcmp(json_string_value(lock), names[n]) == 0 ? bits[n] : 0;
		if (bit == 0)
			return reader_fail_value(reader, ELEMENT(place, k), lock, "must be \"x\", \"y\" or \"rotation\"");
		*locks |= bit;
	}
	return true;
}

static bool read_body(Reader* reader, const Place* place, const json_t* value, Block* block)
{
	return read_type(reader, KEY(place, "type"), json_object_get(value, "type"), &block->type) &&
	       read_pair(reader, place, value, "position", any_coordinate, block->position) &&
	       read_number(reader, place, value, "angle", any_angle, 0, &block->angle) &&
	       read_pair(reader, place, value, "velocity", any_speed, block->velocity) &&
	       read_number(reader, place, value, "angular_velocity", any_speed, 0, &block->angular_velocity) &&
	       read_number(reader, place, value, "gravity_scale", any_speed, 1, &block->gravity_scale) &&
	       read_number(reader, place, value, "linear_damping", not_negative, 0, &block->linear_damping) &&
	       read_number(reader, place, value, "angular_damping", not_negative, 0, &block->angular_damping) &&
	       read_locks(reader, KEY(place, "locks"), json_object_get(value, "locks"), &block->locks);
}

static bool read_share(Reader* reader, const Place* place, const json_t* object, const char* key, int* share)
{
	const json_t* value = json_object_get(object, key);
	double number = 0;
	bool good =
	    !value || reader_constant(reader, KEY(place, key), value, (Range){0, SCENE_MAX_BODIES, true, false}, &number);
	*share = (int)number;
	return good;
}

static bool read_churn(Reader* reader, const Place* place, const json_t* value, Block* block)
{
	Churn* churn = &block->churn;
	if (!value)
		return true;
	if (!reader_object(reader, place, value, churn_keys) || !read_share(reader, place, value, "moved", &churn->moved) ||
	    !read_share(reader, place, value, "replaced", &churn->replaced))
		return false;
	if (!json_object_get(value, "position"))
		return reader_fail(reader, place, "position is missing");
	if (!block->simple && churn->replaced > 0)
		return reader_fail(reader, KEY(place, "replaced"), "a body that is made anew needs attribute, not collidables");
	reader->redraws = true;
	bool good = read_pair(reader, place, value, "position", any_coordinate, churn->position) &&
	            read_number(reader, place, value, "angle", any_angle, 0, &churn->angle) &&
	            read_pair(reader, place, value, "velocity", any_speed, churn->velocity) &&
	            read_number(reader, place, value, "angular_velocity", any_speed, 0, &churn->angular_velocity);
	reader->redraws = false;
	return good;
}

bool block_read(Reader* reader, const Place* place, const json_t* value, const Scene* scene, bool bodies, Block* block)
{
	int names = reader->scope.count;
	block->bodies = bodies;
	const json_t* repeat = json_is_object(value) ? json_object_get(value, "repeat") : NULL;
	bool good = reader_object(reader, place, value, bodies ? body_keys : free_keys) &&
	            (!repeat || read_loops(reader, KEY(place, "repeat"), repeat, block)) &&
	            read_parts(reader, place, value, scene, block) && (!bodies || read_body(reader, place, value, block));
	reader->scope.count = names;
	return good && read_churn(reader, KEY(place, "churn"), json_object_get(value, "churn"), block);
}

static void choice_free(Choice* choice)
{
	free(choice->attributes);
	number_free(&choice->choose);
}

void block_free(Block* block)
{
	for (int k = 0; k < block->loop_count; ++k)
	{
		number_free(&block->loops[k].first);
		number_free(&block->loops[k].end);
	}
	for (int k = 0; k < block->part_count; ++k)
	{
		choice_free(&block->parts[k].choice);
		number_free(&block->parts[k].position[0]);
		number_free(&block->parts[k].position[1]);
		number_free(&block->parts[k].angle);
	}
	free(block->parts);
	free(block->churn.items);
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
