// SPDX-License-Identifier: MIT
// handles.c -- converts slots to handles and back.
#include "world/objects/handles.h"
#include "world/world.h"

// Returns whether a handle refers to the current item of its slot.
static bool holds(const Slots* slots, uint32_t slot, uint32_t generation)
{
	return slot < (uint32_t)slots->used && generation & 1 && slots->generation[slot] == generation;
}

static scree_status refuse_stale(ArgumentPlace at, const char* member, uint32_t index, uint32_t generation)
{
	if (index == 0 && generation == 0)
		return refuse(SCREE_ERROR_STALE, at, member, "is null");
	return refuse(SCREE_ERROR_STALE, at, member, "(index %u, generation %u) was destroyed, or belongs to another world",
	              index, generation);
}

scree_body body_handle(const scree_world* world, int index)
{
	return (scree_body){(uint32_t)index, world->bodies.generation[index]};
}

scree_body owner_handle(const scree_world* world, int collidable)
{
	int body = world->host_collidables[collidable].body;
	return body < 0 ? SCREE_NULL_BODY : body_handle(world, body);
}

bool body_is_valid(const scree_world* world, scree_body body)
{
	return holds(&world->bodies, body.index, body.generation);
}

scree_status check_body(const scree_world* world, ArgumentPlace at, const char* member, scree_body body, int* index)
{
	if (!body_is_valid(world, body))
		return refuse_stale(at, member, body.index, body.generation);
	*index = (int)body.index;
	return SCREE_OK;
}

scree_status check_body_once(const scree_world* world, ArgumentPlace at, const char* member, scree_body body)
{
	const Slots* slots = &world->bodies;
	bool had = body.index > 0 && body.index < (uint32_t)slots->used && body.generation & 1 &&
	           body.generation <= slots->generation[body.index];
	return had ? SCREE_OK : refuse_stale(at, member, body.index, body.generation);
}

static Names names_of(const Slots* slots)
{
	return (Names){slots->generation, slots->used, slots->changes, slots->changed, SLOT_LOGGED};
}

Names collidable_names(const scree_world* world) { return names_of(&world->collidables); }
Names body_names(const scree_world* world) { return names_of(&world->bodies); }

// The index in a handle of a collidable is its slot plus 1, so the index 0 of a null handle is no slot.
scree_collidable collidable_handle(const scree_world* world, int index)
{
	return (scree_collidable){(uint32_t)index + 1, world->collidables.generation[index]};
}

bool collidable_is_valid(const scree_world* world, scree_collidable collidable)
{
	return holds(&world->collidables, collidable.index - 1, collidable.generation);
}

scree_status check_collidable(const scree_world* world, ArgumentPlace at, scree_collidable collidable, int* index)
{
	if (!collidable_is_valid(world, collidable))
		return refuse_stale(at, "", collidable.index, collidable.generation);
	*index = (int)collidable.index - 1;
	return SCREE_OK;
}

// Returns the generation in an attribute's handle: a hash of its values, combined with the number of earlier attributes
// in the slot. So handles of another world are refused if the values differ, and handles of earlier attributes always.
static uint32_t generation_of(const scree_world* world, int index)
{
	uint32_t before = world->attribute_slots.generation[index] >> 1;
	uint32_t generation = world->host_attributes[index].name ^ before * 0x9e3779b9u;
	return generation ? generation : 1;
}

scree_attribute attribute_handle(const scree_world* world, int index)
{
	return (scree_attribute){(uint32_t)index, generation_of(world, index)};
}

bool attribute_is_valid(const scree_world* world, scree_attribute attribute)
{
	return attribute.index < (uint32_t)world->attribute_slots.used &&
	       slots_in_use(&world->attribute_slots, (int)attribute.index) &&
	       generation_of(world, (int)attribute.index) == attribute.generation;
}

scree_status check_attribute(const scree_world* world, ArgumentPlace at, const char* member, scree_attribute attribute,
                             int* index)
{
	if (scree_attribute_is_null(attribute))
		return refuse(SCREE_ERROR_STALE, at, member, "is null");
	if (!attribute_is_valid(world, attribute))
		return refuse(SCREE_ERROR_STALE, at, member, "(index %u) is not an attribute of this world", attribute.index);
	*index = (int)attribute.index;
	return SCREE_OK;
}

scree_joint joint_handle(const scree_world* world, int index)
{
	return (scree_joint){(uint32_t)index + 1, world->joints.generation[index]};
}

bool joint_is_valid(const scree_world* world, scree_joint joint)
{
	return holds(&world->joints, joint.index - 1, joint.generation);
}

scree_status check_joint(const scree_world* world, ArgumentPlace at, scree_joint joint, int* index)
{
	if (!joint_is_valid(world, joint))
		return refuse_stale(at, "", joint.index, joint.generation);
	*index = (int)joint.index - 1;
	return SCREE_OK;
}

scree_field field_handle(const scree_world* world, int index)
{
	return (scree_field){(uint32_t)index + 1, world->fields.slots.generation[index]};
}

bool field_is_valid(const scree_world* world, scree_field field)
{
	return holds(&world->fields.slots, field.index - 1, field.generation);
}

scree_status check_field(const scree_world* world, ArgumentPlace at, scree_field field, int* index)
{
	if (!field_is_valid(world, field))
		return refuse_stale(at, "", field.index, field.generation);
	*index = (int)field.index - 1;
	return SCREE_OK;
}

scree_path path_handle(const scree_world* world, int index)
{
	return (scree_path){(uint32_t)index + 1, world->paths.generation[index]};
}

bool path_is_valid(const scree_world* world, scree_path path)
{
	return holds(&world->paths, path.index - 1, path.generation);
}

scree_status check_path(const scree_world* world, ArgumentPlace at, const char* member, scree_path path, int* index)
{
	if (!path_is_valid(world, path))
		return refuse_stale(at, member, path.index, path.generation);
	*index = (int)path.index - 1;
	return SCREE_OK;
}
