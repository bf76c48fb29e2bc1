// SPDX-License-Identifier: MIT
// joint_block.c -- reads a block of joints of a scene: joints of one type, repeated over nested loops.
#include "scene/joint_block.h"
#include "scene/block.h"
#include "scene/names.h"
#include <string.h>

// Reads an object of a coordinate (spring, motor, lock). Sets *there to true if the file has the object, to false if it is null. needed: member
// without which the object has no effect; null: no such member.
static bool read_group(Reader* reader, const Location* location, const json_t* object, const char* key,
                       FormatObject group, const char* needed, size_t start, JointBlock* block, bool* there)
{
	const json_t* value = json_object_get(object, key);
	const Location* at = KEY(location, key);
	if (!value)
		return true;
	*there = !json_is_null(value);
	if (!*there)
		return true;
	if (!format_check(reader, at, value, group))
		return false;
	if (needed && !json_object_get(value, needed))
		return reader_fail(reader, at, "%s is missing, and without it a %s does nothing", needed, key);
	return format_read(reader, at, value, group, &block->def, start, &block->numbers);
}

static bool read_coordinate(Reader* reader, const Location* location, const json_t* value, scree_coordinate which,
                            JointBlock* block)
{
	static const char* const of_free[] = {"limits", "spring", "motor", NULL};
	scree_joint_coordinate* c = &block->def.coordinates[which];
	size_t start = offsetof(scree_joint_def, coordinates) + (size_t)which * sizeof *c;
	if (!value)
		return true;
	if (!format_check(reader, location, value, OBJECT_coordinate) ||
	    !format_read(reader, location, value, OBJECT_coordinate, &block->def, start, &block->numbers))
		return false;
	for (const char* const* key = of_free; c->locked && *key; ++key)
	{
		if (json_object_get(value, *key))
			return reader_fail(reader, location, "a locked coordinate has no %s; \"locked\": false frees it", *key);
	}
	if (!c->locked && json_object_get(value, "lock"))
		return reader_fail(reader, location, "lock is the stiffness of a locked coordinate, and this one is free");
	c->limited = json_object_get(value, "limits") != NULL;
	bool there;
	const char* hertz = c->spring_hertz > 0.0f ? NULL : "hertz";
	return read_group(reader, location, value, "spring", OBJECT_spring, hertz, start, block, &c->spring) &&
	       read_group(reader, location, value, "motor", OBJECT_motor, "max", start, block, &c->motor) &&
	       read_group(reader, location, value, "lock", OBJECT_lock, NULL, start, block, &there);
}

bool joint_end_read(Reader* reader, const Location* location, const json_t* value, const Scene* scene, JointEnd* end)
{
	end->block = -1;
	if (json_is_null(value))
		return true;
	if (!format_check(reader, location, value, OBJECT_end) ||
	    !block_read_name(reader, KEY(location, "body"), json_object_get(value, "body"), scene, &end->block))
		return false;
	const Block* bodies = &scene->blocks[end->block];
	const char* name = bodies->name;
	if (bodies->churn.replaced > 0)
		return reader_fail(reader, KEY(location, "body"),
		                   "the bodies \"%s\" are replaced, which ends their joints and fields", name);
	if (!json_object_get(value, "index") && bodies->count != 1)
		return reader_fail(reader, location, "index is missing: the number of bodies \"%s\" is %.9g", name,
		                   (double)bodies->count);
	Range range = {0, (double)bodies->count - 1, true, false};
	return reader_member(reader, location, value, "index", range, 0, &end->index);
}

static bool read_ends(Reader* reader, const Location* location, const json_t* value, const Scene* scene,
                      JointBlock* block)
{
	return joint_end_read(reader, KEY(location, "a"), json_object_get(value, "a"), scene, &block->ends[0]) &&
	       joint_end_read(reader, KEY(location, "b"), json_object_get(value, "b"), scene, &block->ends[1]) &&
	       (block->ends[0].block >= 0 || block->ends[1].block >= 0 ||
	        reader_fail(reader, location, "a and b are both null; a joint needs a body"));
}

// Reads anchors in the world.
static bool read_anchors(Reader* reader, const Location* location, const json_t* value, JointBlock* block)
{
	bool apart = json_object_get(value, "to") != NULL;
	const json_t* target = json_object_get(json_object_get(value, "along"), "target");
	if (!json_object_get(value, "at"))
		return reader_fail(reader, location, "at is missing");
	if (block->def.type == SCREE_JOINT_PATH && apart)
		return reader_fail(reader, location, "to: a path joint has one anchor, that of b");
	if (block->def.type == SCREE_JOINT_DISTANCE && !apart)
		return reader_fail(reader, location, "a distance joint with at needs to, the anchor of b");
	block->placed = true;
	block->measured = block->def.type == SCREE_JOINT_DISTANCE && !target;
	Range range = format_range(OBJECT_joint, "at");
	return reader_pair(reader, location, value, "at", range, block->anchors[0]) &&
	       reader_pair(reader, location, value, apart ? "to" : "at", range, block->anchors[1]) &&
	       reader_member(reader, location, value, "axis", format_range(OBJECT_joint, "axis"), 0, &block->axis);
}

static bool read_place(Reader* reader, const Location* location, const json_t* value, JointBlock* block)
{
	static const char* const frames[] = {"frame_a", "frame_b"};
	static const char* const anchors[] = {"at", "to", "axis"};
	const char* anchor = NULL;
	for (int k = 0; k < 3 && !anchor; ++k)
		anchor = json_object_get(value, anchors[k]) ? anchors[k] : NULL;
	for (int k = 0; k < 2; ++k)
	{
		const json_t* frame = json_object_get(value, frames[k]);
		const Location* at = KEY(location, frames[k]);
		if (!frame)
			continue;
		if (anchor)
			return reader_fail(reader, location,
			                   "both %s and %s; a joint has anchors in the world or frames in its bodies", anchor,
			                   frames[k]);
		size_t start = k == 0 ? offsetof(scree_joint_def, frame_a) : offsetof(scree_joint_def, frame_b);
		if (!format_check(reader, at, frame, OBJECT_frame) ||
		    !format_read(reader, at, frame, OBJECT_frame, &block->def, start, &block->numbers))
			return false;
	}
	return !anchor || read_anchors(reader, location, value, block);
}

static bool read_side(Reader* reader, const Location* location, const json_t* value, int side, JointBlock* block)
{
	size_t start = offsetof(scree_joint_def, sides) + (size_t)side * sizeof(scree_joint_side);
	return !value || (format_check(reader, location, value, OBJECT_side) &&
	                  format_read(reader, location, value, OBJECT_side, &block->def, start, &block->numbers));
}

// Reads the members that only gears and pulleys have.
static bool read_coupling(Reader* reader, const Location* location, const json_t* value, JointBlock* block)
{
	static const char* const keys[] = {"side_a", "side_b", "ratio"};
	block->coupled = block->def.type == SCREE_JOINT_GEAR || block->def.type == SCREE_JOINT_PULLEY;
	for (int k = 0; !block->coupled && k < 3; ++k)
		if (json_object_get(value, keys[k]))
			return reader_fail(reader, KEY(location, keys[k]), "only a gear or a pulley has it");
	for (int k = 0; block->coupled && k < 2; ++k)
	{
		const char* key = k ? "across" : "angle";
		if (json_object_get(value, key))
			return reader_fail(reader, KEY(location, key), "a gear or a pulley has the coordinate along only");
		const json_t* side = json_object_get(value, keys[k]);
		block->turned[k] = json_object_get(side, "initial_angle") != NULL;
		if (!read_side(reader, KEY(location, keys[k]), side, k, block))
			return false;
	}
	block->measured |= block->coupled && !json_object_get(json_object_get(value, "along"), "target");
	return true;
}

// Reads the members that only joints on paths have.
static bool read_on(Reader* reader, const Location* location, const json_t* value, const Scene* scene,
                    JointBlock* block)
{
	static const char* const keys[] = {"path", "initial_along"};
	const char* name;
	block->on = -1;
	for (int k = 0; block->def.type != SCREE_JOINT_PATH && k < 2; ++k)
		if (json_object_get(value, keys[k]))
			return reader_fail(reader, KEY(location, keys[k]), "only a path joint has it");
	if (block->def.type != SCREE_JOINT_PATH)
		return true;
	if (!reader_string(reader, KEY(location, "path"), json_object_get(value, "path"), &name))
		return false;
	return names_find(&scene->names->paths, reader, KEY(location, "path"), name, &block->on) &&
	       (block->on >= 0 || reader_fail(reader, KEY(location, "path"), "\"%.60s\" is not among the paths", name));
}

static bool read_joint(Reader* reader, const Location* location, const json_t* value, const Scene* scene,
                       JointBlock* block)
{
	static const char* const coordinates[] = {"along", "across", "angle"};
	uint32_t type;
	if (!reader_name(reader, KEY(location, "type"), json_object_get(value, "type"), joint_type_names, &type))
		return false;
	block->def = scree_joint_def_make((scree_joint_type)type);
	for (int k = 0; k < 3; ++k)
	{
		if (!read_coordinate(reader, KEY(location, coordinates[k]), json_object_get(value, coordinates[k]),
		                     (scree_coordinate)k, block))
			return false;
	}
	return read_ends(reader, location, value, scene, block) && read_place(reader, location, value, block) &&
	       read_coupling(reader, location, value, block) && read_on(reader, location, value, scene, block) &&
	       format_read(reader, location, value, OBJECT_joint, &block->def, 0, &block->numbers);
}

bool joint_block_read(Reader* reader, const Location* location, const json_t* value, const Scene* scene,
                      JointBlock* block)
{
	int names = reader->scope.count;
	location_text(location, block->path, sizeof block->path);
	bool good = format_check(reader, location, value, OBJECT_joint) &&
	            loops_read(reader, location, value, &block->loops) && read_joint(reader, location, value, scene, block);
	reader->scope.count = names;
	return good;
}

void joint_block_free(JointBlock* block)
{
	loops_free(&block->loops);
	format_free(&block->numbers);
	number_free(&block->axis);
	for (int k = 0; k < 2; ++k)
	{
		number_free(&block->ends[k].index);
		number_free(&block->anchors[k][0]);
		number_free(&block->anchors[k][1]);
	}
}
