// SPDX-License-Identifier: MIT
// controls.c -- applies forces to bodies of a scene while the user holds keys down in the viewer.
#include "scene/controls.h"
#include "scene/block.h"
#include "scene/format.h"
#include <stdlib.h>

static bool read_bodies(Reader* reader, const Location* location, const json_t* value, const Scene* scene,
                        Control* control)
{
	const Location* at = KEY(location, "body");
	const json_t* index = json_object_get(value, "index");
	if (!block_read_name(reader, at, json_object_get(value, "body"), scene, &control->block))
		return false;
	const Block* block = &scene->blocks[control->block];
	if (block->def.type != SCREE_BODY_DYNAMIC)
		return reader_fail(reader, at, "%.60s is not dynamic: forces do not move it", block->name);
	double first = 0;
	if (index && !reader_constant(reader, KEY(location, "index"), index,
	                              (Range){0, block->count > 0 ? (double)block->count - 1 : 0, true, false}, &first))
		return false;
	control->first = (int)first;
	control->count = index && block->count > 0 ? 1 : (int)block->count;
	return true;
}

static bool read_control(Reader* reader, const Location* location, const json_t* value, const Scene* scene,
                         Control* control)
{
	format_default(OBJECT_control, control);
	return format_check(reader, location, value, OBJECT_control) &&
	       read_bodies(reader, location, value, scene, control) &&
	       format_read(reader, location, value, OBJECT_control, control, 0, NULL) &&
	       (json_object_get(value, "force") || json_object_get(value, "torque") ||
	        reader_fail(reader, location, "needs force or torque"));
}

bool controls_read(Reader* reader, const json_t* root, Scene* scene)
{
	const json_t* list = json_object_get(root, "keys");
	const Location* location = KEY(NULL, "keys");
	if (!reader_list(reader, location, list))
		return false;
	scene->controls = calloc(json_array_size(list) + 1, sizeof *scene->controls);
	if (!scene->controls)
		return reader_fail(reader, location, "out of memory");
	for (int k = 0; k < (int)json_array_size(list); ++k)
	{
		Control* control = &scene->controls[scene->control_count++];
		if (!read_control(reader, ELEMENT(location, k), json_array_get(list, (size_t)k), scene, control))
			return false;
	}
	return true;
}

uint32_t controls_keys(const Scene* scene)
{
	uint32_t keys = 0;
	for (int k = 0; k < scene->control_count; ++k)
		keys |= 1u << scene->controls[k].key;
	return keys;
}

static scree_status push(scree_world* world, const Control* control, scree_body body)
{
	scree_vec force = control->force;
	scree_pose pose;
	scree_status status = control->turns ? scree_body_get_pose(world, body, &pose) : SCREE_OK;
	if (status == SCREE_OK && control->turns)
		force = (scree_vec){pose.rotation.c * force.x - pose.rotation.s * force.y,
		                    pose.rotation.s * force.x + pose.rotation.c * force.y};
	if (status == SCREE_OK)
		status = scree_body_apply_force(world, body, force);
	return status == SCREE_OK ? scree_body_apply_torque(world, body, control->torque) : status;
}

scree_status controls_apply(const Scene* scene, scree_world* world, uint32_t down)
{
	if (down == 0 || scene->control_count == 0)
		return SCREE_OK;
	int count = scene->body_count;
	scree_body* bodies = malloc(((size_t)count + 1) * sizeof *bodies);
	scree_status status = bodies ? scree_world_get_bodies(world, bodies, count, &count) : SCREE_ERROR_OUT_OF_MEMORY;
	for (int k = 0; k < scene->control_count && status == SCREE_OK; ++k)
	{
		const Control* control = &scene->controls[k];
		int first = block_first(scene, control->block) + control->first;
		for (int n = 0; n < control->count && (down >> control->key & 1) && status == SCREE_OK; ++n)
			if (first + n < count && scree_body_is_enabled(world, bodies[first + n]))
				status = push(world, control, bodies[first + n]);
	}
	free(bodies);
	return status;
}
