// SPDX-License-Identifier: MIT
// fixture.c -- scenes made by code: the list of them, and what builds their bodies and joints.
#include "fixture.h"
#include "fixtures.h"
#include "scree_world.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const Rig* const rigs[] = {&joint_grid_rig, &rain_rig, &spinner_rig, &drum_rig, &ropes_rig,
                                  &bridges_rig,    &beam_rig, &humans_rig,  &car_rig};

const Rig* rig_find(const char* name)
{
	for (size_t k = 0; k < sizeof rigs / sizeof rigs[0]; ++k)
	{
		if (strcmp(rigs[k]->name, name) == 0)
			return rigs[k];
	}
	return NULL;
}

bool rig_set(const Rig* rig, double values[RIG_PARAMETERS], const char* name, const char* value)
{
	for (int k = 0; k < RIG_PARAMETERS && rig->parameters[k].name; ++k)
	{
		if (strcmp(rig->parameters[k].name, name) != 0)
			continue;
		char* end;
		values[k] = strtod(value, &end);
		if (end != value && *end == 0 && values[k] >= 0.0 && values[k] <= 1e6)
			return true;
		fprintf(stderr, "scree_peers: --set %s=%s: must be a number from 0 to 1e6\n", name, value);
		return false;
	}
	fprintf(stderr, "scree_peers: --set %s: %s has no parameter of this name\n", name, rig->name);
	return false;
}

static void check(RigBuild* build, scree_status status) { build->good = build->good && report(status); }

scree_attribute_def rig_box(RigBuild* build, float half_width, float half_height)
{
	scree_attribute_def surface = scree_attribute_def_default();
	check(build, scree_shape_make_box(half_width, half_height, &surface.shape));
	return surface;
}

scree_attribute_def rig_circle(RigBuild* build, float radius)
{
	scree_attribute_def surface = scree_attribute_def_default();
	check(build, scree_shape_make_circle((scree_vec){0.0f, 0.0f}, radius, &surface.shape));
	return surface;
}

scree_attribute_def rig_capsule(RigBuild* build, scree_vec a, scree_vec b, float radius)
{
	scree_attribute_def surface = scree_attribute_def_default();
	check(build, scree_shape_make_capsule(a, b, radius, &surface.shape));
	return surface;
}

scree_attribute_def rig_polygon(RigBuild* build, const scree_vec* corners, int count, float radius)
{
	scree_attribute_def surface = scree_attribute_def_default();
	check(build, scree_shape_make_polygon(corners, count, radius, &surface.shape));
	return surface;
}

scree_body_def rig_body(scree_body_type type, float x, float y)
{
	scree_body_def def = scree_body_def_default();
	def.type = type;
	def.pose.position = (scree_vec){x, y};
	return def;
}

scree_body rig_add(RigBuild* build, const scree_body_def* def)
{
	scree_body body = SCREE_NULL_BODY;
	if (build->good)
		check(build, scree_body_create(build->world, def, &body));
	return body;
}

scree_body rig_put(RigBuild* build, scree_body_def def, const scree_attribute_def* surface)
{
	if (build->good)
		check(build, scree_attribute_create(build->world, surface, &def.attribute));
	return rig_add(build, &def);
}

void rig_attach(RigBuild* build, scree_body body, const scree_attribute_def* surface, scree_vec at, scree_filter filter)
{
	scree_collidable_def def = scree_collidable_def_default();
	def.body = body;
	def.pose.position = at;
	def.filter = filter;
	if (build->good)
		check(build, scree_attribute_create(build->world, surface, &def.attribute));
	if (build->good)
		check(build, scree_collidable_create(build->world, &def, NULL));
}

void rig_join(RigBuild* build, const scree_joint_def* def)
{
	if (build->good)
		check(build, scree_joint_create(build->world, def, NULL));
}

scree_joint_def rig_joint(scree_joint_type type, scree_body a, scree_vec at_a, scree_body b, scree_vec at_b)
{
	scree_joint_def def = scree_joint_def_make(type);
	def.body_a = a;
	def.body_b = b;
	def.frame_a.position = at_a;
	def.frame_b.position = at_b;
	return def;
}

void rig_pin(RigBuild* build, scree_body a, scree_vec at_a, scree_body b, scree_vec at_b)
{
	scree_joint_def def = rig_joint(SCREE_JOINT_REVOLUTE, a, at_a, b, at_b);
	rig_join(build, &def);
}
