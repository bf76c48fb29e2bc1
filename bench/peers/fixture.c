// SPDX-License-Identifier: MIT
// fixture.c -- sets parameters of fixtures, the scenes made by code, and adds their bodies and joints.
#include "fixture.h"
#include "validate/scree_world.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

bool fixture_set(const Fixture* fixture, double values[FIXTURE_PARAMETERS], const char* name, const char* value)
{
	for (int k = 0; k < FIXTURE_PARAMETERS && fixture->parameters[k].name; ++k)
	{
		if (strcmp(fixture->parameters[k].name, name) != 0)
			continue;
		char* end;
		values[k] = strtod(value, &end);
		if (end != value && *end == 0 && values[k] >= 0.0 && values[k] <= 1e6)
			return true;
		fprintf(stderr, "scree_peers: --set %s=%s: must be a number from 0 to 1e6\n", name, value);
		return false;
	}
	fprintf(stderr, "scree_peers: --set %s: %s has no parameter of this name\n", name, fixture->name);
	return false;
}

static void check(FixtureBuild* build, scree_status status) { build->good = build->good && report_status(status); }

scree_attribute_def fixture_box(FixtureBuild* build, float half_width, float half_height)
{
	scree_attribute_def surface = scree_attribute_def_default();
	check(build, scree_shape_make_box(half_width, half_height, &surface.shape));
	return surface;
}

scree_attribute_def fixture_circle(FixtureBuild* build, float radius)
{
	scree_attribute_def surface = scree_attribute_def_default();
	check(build, scree_shape_make_circle((scree_vec){0.0f, 0.0f}, radius, &surface.shape));
	return surface;
}

scree_attribute_def fixture_capsule(FixtureBuild* build, scree_vec a, scree_vec b, float radius)
{
	scree_attribute_def surface = scree_attribute_def_default();
	check(build, scree_shape_make_capsule(a, b, radius, &surface.shape));
	return surface;
}

scree_attribute_def fixture_polygon(FixtureBuild* build, const scree_vec* corners, int count, float radius)
{
	scree_attribute_def surface = scree_attribute_def_default();
	check(build, scree_shape_make_polygon(corners, count, radius, &surface.shape));
	return surface;
}

scree_body_def fixture_body(scree_body_type type, float x, float y)
{
	scree_body_def def = scree_body_def_default();
	def.type = type;
	def.pose.position = (scree_vec){x, y};
	return def;
}

scree_body fixture_add(FixtureBuild* build, const scree_body_def* def)
{
	scree_body body = SCREE_NULL_BODY;
	if (build->good)
		check(build, scree_body_create(build->world, def, &body));
	return body;
}

scree_body fixture_put(FixtureBuild* build, scree_body_def def, const scree_attribute_def* surface)
{
	if (build->good)
		check(build, scree_attribute_create(build->world, surface, &def.attribute));
	return fixture_add(build, &def);
}

void fixture_attach(FixtureBuild* build, scree_body body, const scree_attribute_def* surface, scree_vec at,
                    scree_filter filter)
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

void fixture_join(FixtureBuild* build, const scree_joint_def* def)
{
	if (build->good)
		check(build, scree_joint_create(build->world, def, NULL));
}

scree_joint_def fixture_joint(scree_joint_type type, scree_body a, scree_vec at_a, scree_body b, scree_vec at_b)
{
	scree_joint_def def = scree_joint_def_make(type);
	def.body_a = a;
	def.body_b = b;
	def.frame_a.position = at_a;
	def.frame_b.position = at_b;
	return def;
}

void fixture_pin(FixtureBuild* build, scree_body a, scree_vec at_a, scree_body b, scree_vec at_b)
{
	scree_joint_def def = fixture_joint(SCREE_JOINT_REVOLUTE, a, at_a, b, at_b);
	fixture_join(build, &def);
}
