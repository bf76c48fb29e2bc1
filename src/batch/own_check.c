// SPDX-License-Identifier: MIT
// own_check.c -- checks the own values of a row, which may come from anywhere.
#include "batch/own_check.h"
#include "world/check.h"
#include "world/objects/mass.h"
#include "world/snapshot/item_check.h"
#include <math.h>
#include <string.h>

int own_attributes(const Template* from)
{
	const OwnRules* rules = &from->own_rules;
	int claimed = 0;
	for (int k = 0; k < rules->attributes; ++k)
		claimed += rules->claimed[k];
	int needed = claimed + from->collidables + 1; // an attribute gets the lowest free index
	return rules->attributes > needed ? rules->attributes : needed;
}

static bool is_within(float x, float least, float most) { return x >= least && x <= most; }

static bool is_mass(const scree_mass* mass)
{
	return is_within(mass->mass, LEAST_MASS, MOST_MASS) &&
	       (mass->inertia == 0.0f || is_within(mass->inertia, LEAST_INERTIA, MOST_MASS)) &&
	       fabsf(mass->center.x) <= SCREE_MAX_COORDINATE && fabsf(mass->center.y) <= SCREE_MAX_COORDINATE;
}

static scree_status check_bodies(const ChunkIndex* index, const Template* from, Own own, Own template)
{
	for (int k = 0; k < own.bodies; ++k)
	{
		const OwnBody *body = own.body + k, *before = template.body + k;
		bool same = memcmp(&body->mass, &before->mass, sizeof body->mass) == 0;
		bool used = k > 0 && slots_in_use(&from->world->bodies, k);
		bool moves = used && from->world->host_bodies[k].type == SCREE_BODY_DYNAMIC;
		CHECK_ITEM(same || (moves && is_mass(&body->mass)), "own mass", k);
		CHECK_ITEM(same || from->pipeline.heavy || !mass_is_heavy(from->world, k, body->mass), "own mass", k);
		CHECK_ITEM(body->disabled == before->disabled ||
		               (used && from->world->host_bodies[k].fields == 0 && in_range(body->disabled, 0, 2)),
		           "own body", k);
	}
	return SCREE_OK;
}

// Returns whether an attribute of the user, if the collidable has one, has its surface.
static bool fits_claim(const Template* from, const OwnCollidable* own)
{
	const OwnRules* rules = &from->own_rules;
	if (own->attribute >= rules->attributes || !rules->claimed[own->attribute])
		return true;
	const scree_attribute_def* def = from->world->attributes + own->attribute;
	return own->friction == def->friction && own->restitution == def->restitution &&
	       own->rolling_resistance == def->rolling_resistance && own->tangent_speed == def->tangent_speed;
}

static scree_status check_collidables(const ChunkIndex* index, const Template* from, Own own)
{
	const int* core = from->own_rules.core;
	int most = own_attributes(from);
	for (int k = 0; k < own.collidables; ++k)
	{
		const OwnCollidable* c = own.collidable + k;
		if (core[k] < 0)
			continue;
		CHECK_ITEM(is_within(c->friction, 0.0f, MOST_SURFACE), "own surface", k);
		CHECK_ITEM(is_within(c->restitution, 0.0f, MOST_RESTITUTION), "own surface", k);
		CHECK_ITEM(is_within(c->rolling_resistance, 0.0f, MOST_SURFACE), "own surface", k);
		CHECK_ITEM(fabsf(c->tangent_speed) <= SCREE_MAX_COORDINATE, "own surface", k);
		CHECK_ITEM(in_range(c->attribute, 0, most) && fits_claim(from, c), "own attribute", k);
		int first = 0;
		while (core[first] < 0 || own.collidable[first].attribute != c->attribute)
			++first;
		CHECK_ITEM(core[first] == core[k] && memcmp(own.collidable + first, c, sizeof *c) == 0, "own attribute", k);
	}
	return SCREE_OK;
}

scree_status own_check(const ChunkIndex* index, const Template* from, Own own)
{
	Own template = own_of(from, from->own);
	TRY(check_bodies(index, from, own, template));
	TRY(check_collidables(index, from, own));
	for (int k = 0; k < own.joints; ++k)
		CHECK_ITEM(own.joint[k] == template.joint[k] ||
		               (slots_in_use(&from->world->joints, k) && in_range(own.joint[k], 0, 4)),
		           "own joint", k);
	return SCREE_OK;
}
