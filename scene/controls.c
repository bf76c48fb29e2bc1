// SPDX-License-Identifier: MIT
// controls.c -- what bodies of a scene do while the user holds keys down in the viewer.
#include "scene/controls.h"
#include "scene/block.h"
#include <stdlib.h>
#include <string.h>

static const char* const control_keys[] = {"key", "body", "index", "force", "torque", "turns", "description", NULL};
static const Range any_push = {-1e15, 1e15, false, false};

static bool read_bodies(Reader* reader, const Location* location, const json_t* value, const Scene* scene,
                        Control* control)
{
	const char* name;
	const json_t* index = json_object_get(value, "index");
	if (!reader_string(reader, KEY(location, "body"), json_object_get(value, "body"), &name))
		return false;
	control->block = block_find(scene, name);
	if (control->block < 0)
		return reader_fail(reader, KEY(location, "body"), "\"%.60s\" is not the name of bodies", name);
	if (scene->blocks[control->block].type != SCREE_BODY_DYNAMIC)
		return reader_fail(reader, KEY(location, "body"), "%.60s is not dynamic: forces do not move it", name);
	int64_t count = scene->blocks[control->block].count;
	double first = 0;
	if (index && !reader_constant(reader, KEY(location, "index"), index,
	                              (Range){0, count > 0 ? (double)count - 1 : 0, true, false}, &first))
		return false;
	control->first = (int)first;
	control->count = index && count > 0 ? 1 : (int)count;
	return true;
}

static bool read_control(Reader* reader, const Location* location, const json_t* value, const Scene* scene,
                         Control* control)
{
	double torque = 0;
	if (!reader_object(reader, location, value, control_keys) ||
	    !scene_key_read(reader, KEY(location, "key"), json_object_get(value, "key"), &control->key) ||
	    !read_bodies(reader, location, value, scene, control))
		return false;
	const json_t *force = json_object_get(value, "force"), *turning = json_object_get(value, "torque");
	if (!force && !turning)
		return reader_fail(reader, location, "needs force or torque");
	if ((force && !reader_vec(reader, KEY(location, "force"), force, any_push, &control->force)) ||
	    (turning && !reader_constant(reader, KEY(location, "torque"), turning, any_push, &torque)))
		return false;
	control->torque = (float)torque;
	return reader_boolean(reader, KEY(location, "turns"), json_object_get(value, "turns"), &control->turns);
}

bool controls_read(Reader* reader, const json_t* root, Scene* scene)
{
	const json_t* list = json_object_get(root, "keys");
	const Location* location = KEY(NULL, "keys");
	if (list && !json_is_array(list))
		return reader_fail_value(reader, location, list, "must be a list, [ ... ]");
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
