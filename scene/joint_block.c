// SPDX-License-Identifier: MIT
// joint_block.c -- a block of joints of a scene: joints of one type, repeated over nested loops.
#include "scene/joint_block.h"
#include "scene/block.h"
#include "scene/path_block.h"
#include <float.h>
#include <string.h>

static const char* const joint_keys[] = {"type",
                                         "a",
                                         "b",
                                         "at",
                                         "to",
                                         "axis",
                                         "frame_a",
                                         "frame_b",
                                         "along",
                                         "across",
                                         "angle",
                                         "hertz",
                                         "damping_ratio",
                                         "ratio",
                                         "side_a",
                                         "side_b",
                                         "path",
                                         "near",
                                         "collide_connected",
                                         "breaks",
                                         "disabled",
                                         "elliptic",
                                         "force_threshold",
                                         "torque_threshold",
                                         "repeat",
                                         "description",
                                         NULL};
static const char* const end_keys[] = {"body", "index", NULL};
static const char* const frame_keys[] = {"position", "angle", NULL};
static const char* const side_keys[] = {"measure", "position", "angle", NULL};
static const char* const coordinate_keys[] = {"locked", "target", "limits", "spring", "motor", "lock", NULL};

static const Range any_ratio = {-1e6, 1e6, false, false};
static const Range any_force = {0, FLT_MAX, false, false};

typedef struct // a number and its place in scree_joint_def or scree_joint_coordinate
{
	const char* key;
	size_t offset;
	const Range* range;
} Member;

#define COORDINATE(key, member, range)                           \
	{                                                            \
		(key), offsetof(scree_joint_coordinate, member), (range) \
	}
static const Member joint_members[] = {{"hertz", offsetof(scree_joint_def, hertz), &not_negative},
                                       {"damping_ratio", offsetof(scree_joint_def, damping_ratio), &not_negative},
                                       {"force_threshold", offsetof(scree_joint_def, force_threshold), &any_force},
                                       {"torque_threshold", offsetof(scree_joint_def, torque_threshold), &any_force},
                                       {NULL, 0, NULL}};
static const Member ratio_members[] = {{"ratio", offsetof(scree_joint_def, ratio), &any_ratio}, {NULL, 0, NULL}};
static const Member near_members[] = {{"near", offsetof(scree_joint_def, initial_along), &any_coordinate},
                                      {NULL, 0, NULL}};
static const Member target_members[] = {COORDINATE("target", target, &any_coordinate), {NULL, 0, NULL}};
static const Member spring_members[] = {
    COORDINATE("hertz", spring_hertz, &not_negative), COORDINATE("damping_ratio", spring_damping_ratio, &not_negative),
    COORDINATE("max", spring_max, &any_force),        COORDINATE("push", spring_push, &any_force),
    COORDINATE("pull", spring_pull, &any_force),      {NULL, 0, NULL}};
static const Member motor_members[] = {
    COORDINATE("speed", motor_speed, &any_coordinate), COORDINATE("max", motor_max, &any_force), {NULL, 0, NULL}};
static const Member lock_members[] = {COORDINATE("hertz", lock_hertz, &not_negative),
                                      COORDINATE("damping_ratio", lock_damping_ratio, &not_negative),
                                      {NULL, 0, NULL}};

// Reads a number into the definition, or into the list of those that differ between items.
static bool read_float(Reader* reader, const Location* location, const json_t* value, Range range, size_t offset,
                       JointBlock* block)
{
	JointNumber* added = &block->numbers[block->number_count++];
	added->offset = offset;
	if (!reader_number(reader, location, value, range, &added->number))
		return false;
	if (!added->number.code)
	{
		*(float*)((char*)&block->def + offset) = (float)added->number.constant;
		--block->number_count;
	}
	return true;
}

// Reads those members that an object has. start: offset of the struct that they belong to.
static bool read_members(Reader* reader, const Location* location, const json_t* object, const Member* members,
                         size_t start, JointBlock* block)
{
	for (const Member* m = members; m->key; ++m)
	{
		const json_t* value = json_object_get(object, m->key);
		if (value && !read_float(reader, KEY(location, m->key), value, *m->range, start + m->offset, block))
			return false;
	}
	return true;
}

// Reads an object of a coordinate that has only numbers, and whether it is there.
static bool read_group(Reader* reader, const Location* location, const json_t* object, const char* key,
                       const Member* members, size_t start, JointBlock* block, bool* there)
{
	const json_t* value = json_object_get(object, key);
	const char* keys[6] = {NULL};
	if (!value)
		return true;
	for (int k = 0; members[k].key; ++k)
		keys[k] = members[k].key;
	*there = true;
	return reader_object(reader, KEY(location, key), value, keys) &&
	       read_members(reader, KEY(location, key), value, members, start, block);
}

// Refuses a group without the member whose default switches it off.
static bool check_group(Reader* reader, const Location* location, const json_t* object, const char* key,
                        const char* member)
{
	const json_t* group = json_object_get(object, key);
	if (!group || json_object_get(group, member))
		return true;
	return reader_fail(reader, KEY(location, key), "%s is missing, and without it a %s does nothing", member, key);
}

static bool read_limits(Reader* reader, const Location* location, const json_t* value, size_t start, JointBlock* block)
{
	if (!json_is_array(value) || json_array_size(value) != 2)
		return reader_fail_value(reader, location, value, "must be a list of 2 numbers");
	return read_float(reader, ELEMENT(location, 0), json_array_get(value, 0), any_coordinate,
	                  start + offsetof(scree_joint_coordinate, lower), block) &&
	       read_float(reader, ELEMENT(location, 1), json_array_get(value, 1), any_coordinate,
	                  start + offsetof(scree_joint_coordinate, upper), block);
}

static bool read_coordinate(Reader* reader, const Location* location, const json_t* value, scree_coordinate which,
                            JointBlock* block)
{
	static const char* const of_free[] = {"limits", "spring", "motor", NULL};
	scree_joint_coordinate* c = &block->def.coordinates[which];
	size_t start = offsetof(scree_joint_def, coordinates) + (size_t)which * sizeof *c;
	if (!value)
		return true;
	if (!reader_object(reader, location, value, coordinate_keys))
		return false;
	const json_t* locked = json_object_get(value, "locked");
	if (locked && !reader_boolean(reader, KEY(location, "locked"), locked, &c->locked))
		return false;
	for (const char* const* key = of_free; c->locked && *key; ++key)
	{
		if (json_object_get(value, *key))
			return reader_fail(reader, location, "a locked coordinate has no %s; \"locked\": false frees it", *key);
	}
	if (!c->locked && json_object_get(value, "lock"))
		return reader_fail(reader, location, "lock is the stiffness of a locked coordinate, and this one is free");
	const json_t* limits = json_object_get(value, "limits");
	c->limited = limits != NULL;
	bool there;
	return (!limits || read_limits(reader, KEY(location, "limits"), limits, start, block)) &&
	       read_members(reader, location, value, target_members, start, block) &&
	       read_group(reader, location, value, "spring", spring_members, start, block, &c->spring) &&
	       (c->spring_hertz > 0.0f || check_group(reader, location, value, "spring", "hertz")) &&
	       read_group(reader, location, value, "motor", motor_members, start, block, &c->motor) &&
	       check_group(reader, location, value, "motor", "max") &&
	       read_group(reader, location, value, "lock", lock_members, start, block, &there);
}

static bool read_type(Reader* reader, const Location* location, const json_t* value, scree_joint_type* type)
{
	char names[160] = "";
	for (int k = SCREE_JOINT_FREE; k <= SCREE_JOINT_PATH; ++k)
	{
		const char* name = scree_joint_type_name((scree_joint_type)k);
		*type = (scree_joint_type)k;
		if (json_is_string(value) && strcmp(json_string_value(value), name) == 0)
			return true;
		snprintf(names + strlen(names), sizeof names - strlen(names), "%s%s", k ? ", " : "must be one of ", name);
	}
	return reader_fail_value(reader, location, value, names);
}

bool joint_end_read(Reader* reader, const Location* location, const json_t* value, const Scene* scene, JointEnd* end)
{
	const char* name;
	end->block = -1;
	if (json_is_null(value))
		return true;
	if (!reader_object(reader, location, value, end_keys) ||
	    !reader_string(reader, KEY(location, "body"), json_object_get(value, "body"), &name))
		return false;
	end->block = block_find(scene, name);
	if (end->block < 0)
		return reader_fail(reader, KEY(location, "body"), "\"%.60s\" is not the name of an entry of bodies", name);
	const Block* bodies = &scene->blocks[end->block];
	if (bodies->churn.replaced > 0)
		return reader_fail(reader, KEY(location, "body"),
		                   "the bodies \"%s\" are replaced, which ends their joints and fields", name);
	if (!json_object_get(value, "index") && bodies->count != 1)
		return reader_fail(reader, location, "index is missing: there are %.9g bodies \"%s\"", (double)bodies->count,
		                   name);
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
	return reader_pair(reader, location, value, "at", any_coordinate, block->anchors[0]) &&
	       reader_pair(reader, location, value, apart ? "to" : "at", any_coordinate, block->anchors[1]) &&
	       reader_member(reader, location, value, "axis", any_angle, 0, &block->axis);
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
		if (!reader_object(reader, at, frame, frame_keys) ||
		    !reader_pair(reader, at, frame, "position", any_coordinate, block->positions[k]) ||
		    !reader_member(reader, at, frame, "angle", any_angle, 0, &block->angles[k]))
			return false;
	}
	return !anchor || read_anchors(reader, location, value, block);
}

static bool read_side(Reader* reader, const Location* location, const json_t* value, int side, JointBlock* block)
{
	static const char* const names[] = {"angle", "translation", "distance"};
	const json_t* measure = json_object_get(value, "measure");
	if (!value)
		return true;
	if (!reader_object(reader, location, value, side_keys))
		return false;
	bool known = measure == NULL;
	for (int k = 0; !known && k < 3; ++k)
	{
		known = json_is_string(measure) && strcmp(json_string_value(measure), names[k]) == 0;
		block->def.sides[side].measure = (scree_measure)k;
	}
	if (!known)
		return reader_fail_value(reader, KEY(location, "measure"), measure,
		                         "must be one of angle, translation, distance");
	return (!json_object_get(value, "position") ||
	        reader_pair(reader, location, value, "position", any_coordinate, block->base_positions[side])) &&
	       reader_member(reader, location, value, "angle", any_angle, 0, &block->base_angles[side]);
}

// Reads what only gears and pulleys have.
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
		if (!read_side(reader, KEY(location, keys[k]), json_object_get(value, keys[k]), k, block))
			return false;
	}
	block->measured |= block->coupled && !json_object_get(json_object_get(value, "along"), "target");
	return read_members(reader, location, value, ratio_members, 0, block);
}

// Reads what only joints on paths have.
static bool read_on(Reader* reader, const Location* location, const json_t* value, const Scene* scene,
                    JointBlock* block)
{
	static const char* const keys[] = {"path", "near"};
	const char* name;
	block->on = -1;
	for (int k = 0; block->def.type != SCREE_JOINT_PATH && k < 2; ++k)
		if (json_object_get(value, keys[k]))
			return reader_fail(reader, KEY(location, keys[k]), "only a path joint has it");
	if (block->def.type != SCREE_JOINT_PATH)
		return true;
	if (!reader_string(reader, KEY(location, "path"), json_object_get(value, "path"), &name))
		return false;
	block->on = paths_find(scene, name);
	if (block->on < 0)
		return reader_fail(reader, KEY(location, "path"), "\"%.60s\" is not among the paths", name);
	return read_members(reader, location, value, near_members, 0, block);
}

static bool read_joint(Reader* reader, const Location* location, const json_t* value, const Scene* scene,
                       JointBlock* block)
{
	static const char* const coordinates[] = {"along", "across", "angle"};
	scree_joint_type type;
	if (!read_type(reader, KEY(location, "type"), json_object_get(value, "type"), &type))
		return false;
	block->def = scree_joint_def_make(type);
	for (int k = 0; k < 3; ++k)
	{
		if (!read_coordinate(reader, KEY(location, coordinates[k]), json_object_get(value, coordinates[k]),
		                     (scree_coordinate)k, block))
			return false;
	}
	return read_ends(reader, location, value, scene, block) && read_place(reader, location, value, block) &&
	       read_coupling(reader, location, value, block) && read_on(reader, location, value, scene, block) &&
	       read_members(reader, location, value, joint_members, 0, block) &&
	       reader_boolean(reader, KEY(location, "collide_connected"), json_object_get(value, "collide_connected"),
	                      &block->def.collide_connected) &&
	       reader_boolean(reader, KEY(location, "breaks"), json_object_get(value, "breaks"), &block->def.can_break) &&
	       reader_boolean(reader, KEY(location, "disabled"), json_object_get(value, "disabled"),
	                      &block->def.disabled) &&
	       reader_boolean(reader, KEY(location, "elliptic"), json_object_get(value, "elliptic"), &block->def.elliptic);
}

bool joint_block_read(Reader* reader, const Location* location, const json_t* value, const Scene* scene,
                      JointBlock* block)
{
	int names = reader->scope.count;
	location_text(location, block->path, sizeof block->path);
	bool good = reader_object(reader, location, value, joint_keys) &&
	            loops_read(reader, location, value, &block->loops) && read_joint(reader, location, value, scene, block);
	reader->scope.count = names;
	return good;
}

void joint_block_free(JointBlock* block)
{
	loops_free(&block->loops);
	for (int k = 0; k < block->number_count; ++k)
		number_free(&block->numbers[k].number);
	number_free(&block->axis);
	for (int k = 0; k < 2; ++k)
	{
		number_free(&block->ends[k].index);
		number_free(&block->angles[k]);
		number_free(&block->base_angles[k]);
		for (int axis = 0; axis < 2; ++axis)
		{
			number_free(&block->anchors[k][axis]);
			number_free(&block->positions[k][axis]);
			number_free(&block->base_positions[k][axis]);
		}
	}
}
