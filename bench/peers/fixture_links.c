// SPDX-License-Identifier: MIT
// fixture_links.c -- builds scenes with joints without motors: a net, ropes with a load, bridges, a welded beam.
#include "fixtures.h"
#include <stdlib.h>

#define PI 3.14159265f

// filter of bodies that do not touch each other
static const scree_filter apart = {.category = 2, .mask = 1, .group = 0};

enum
{
	SIZE
};

static void build_grid(FixtureBuild* build)
{
	int size = (int)build->values[SIZE];
	scree_attribute_def circle = fixture_circle(build, 0.4f);
	scree_body* bodies = malloc((size_t)size * (size_t)size * sizeof(scree_body));
	build->good = build->good && bodies;
	for (int k = 0; k < size * size && build->good; ++k)
	{
		int column = k / size, row = k % size;
		bool fixed = row == 0 && abs(column - size / 2) <= 3;
		scree_body_def def = fixture_body(fixed ? SCREE_BODY_STATIC : SCREE_BODY_DYNAMIC, (float)column, -(float)row);
		def.filter = apart;
		bodies[k] = fixture_put(build, def, &circle);
		if (row > 0)
			fixture_pin(build, bodies[k - 1], (scree_vec){0.0f, -0.5f}, bodies[k], (scree_vec){0.0f, 0.5f});
		if (column > 0)
			fixture_pin(build, bodies[k - size], (scree_vec){0.5f, 0.0f}, bodies[k], (scree_vec){-0.5f, 0.0f});
	}
	free(bodies);
}

const Fixture joint_grid_fixture = {"joint_grid", 500, {{"size", 100}}, build_grid, NULL};

enum
{
	COUNT,
	LINKS,
	LOAD,
	LEVEL
};

#define LINK 0.25f // m: half the length of a link; its mass is 1 kg

// Adds a rope that begins at the fixed point (x, 0), hangs down or lies level, and has a load at its other end.
static void add_rope(FixtureBuild* build, float x)
{
	int links = (int)build->values[LINKS];
	bool level = build->values[LEVEL] != 0.0;
	scree_vec along = level ? (scree_vec){1.0f, 0.0f} : (scree_vec){0.0f, -1.0f};
	scree_attribute_def link = fixture_box(build, LINK, 0.05f), load = fixture_circle(build, 0.5f);
	link.density = 1.0f / (4.0f * LINK * 0.05f);
	load.density = (float)build->values[LOAD] / (PI * 0.25f);
	scree_body last = SCREE_NULL_BODY;
	scree_vec end = {x, 0.0f};
	for (int k = 0; k <= links; ++k)
	{
		float reach = k < links ? LINK * (float)(2 * k + 1) : LINK * (float)(2 * links);
		scree_body_def def = fixture_body(SCREE_BODY_DYNAMIC, x + reach * along.x, reach * along.y);
		def.filter = apart;
		if (!level)
			def.pose.rotation = (scree_rot){0.0f, -1.0f};
		scree_body body = fixture_put(build, def, k < links ? &link : &load);
		fixture_pin(build, last, end, body, (scree_vec){k < links ? -LINK : 0.0f, 0.0f});
		last = body;
		end = (scree_vec){LINK, 0.0f};
	}
}

static void build_ropes(FixtureBuild* build)
{
	for (int k = 0; k < (int)build->values[COUNT]; ++k)
		add_rope(build, 2.0f * (float)k);
}

const Fixture ropes_fixture = {
    "ropes", 500, {{"count", 100}, {"links", 40}, {"load", 100}, {"level", 0}}, build_ropes, NULL};

enum
{
	BRIDGES,
	PLANKS,
	LOADS,
	MASS
};

// Adds a bridge of planks, each 1 m long, between two points of the world, and boxes on the planks. The parameter
// `mass` is that of a box in units of a plank's mass.
static void add_bridge(FixtureBuild* build, float y)
{
	int planks = (int)build->values[PLANKS], loads = (int)build->values[LOADS];
	float width = (float)planks;
	scree_attribute_def plank = fixture_box(build, 0.5f, 0.125f), load = fixture_box(build, 0.5f, 0.5f);
	load.density = 0.25f * (float)build->values[MASS];
	scree_body last = SCREE_NULL_BODY;
	scree_vec end = {-0.5f * width, y};
	for (int k = 0; k < planks; ++k)
	{
		scree_body body =
		    fixture_put(build, fixture_body(SCREE_BODY_DYNAMIC, (float)k + 0.5f - 0.5f * width, y), &plank);
		fixture_pin(build, last, end, body, (scree_vec){-0.5f, 0.0f});
		last = body;
		end = (scree_vec){0.5f, 0.0f};
	}
	fixture_pin(build, last, end, SCREE_NULL_BODY, (scree_vec){0.5f * width, y});
	for (int k = 0; k < loads; ++k)
		fixture_put(build,
		            fixture_body(SCREE_BODY_DYNAMIC, width * (((float)k + 0.5f) / (float)loads - 0.5f), y + 0.625f),
		            &load);
}

static void build_bridges(FixtureBuild* build)
{
	for (int k = 0; k < (int)build->values[BRIDGES]; ++k)
		add_bridge(build, -200.0f * (float)k);
}

const Fixture bridges_fixture = {
    "bridges", 500, {{"count", 20}, {"planks", 100}, {"loads", 10}, {"mass", 4}}, build_bridges, NULL};

// Adds a level beam of boxes of 1 m by 0.5 m. Each box is welded to the box before it, the first to the world.
static void build_beam(FixtureBuild* build)
{
	scree_attribute_def box = fixture_box(build, 0.5f, 0.25f);
	scree_body last = SCREE_NULL_BODY;
	for (int k = 0; k < (int)build->values[SIZE]; ++k)
	{
		scree_body_def def = fixture_body(SCREE_BODY_DYNAMIC, (float)k + 0.5f, 0.0f);
		def.filter = apart;
		scree_body body = fixture_put(build, def, &box);
		scree_joint_def joint = fixture_joint(SCREE_JOINT_WELD, last, (scree_vec){k > 0 ? 0.5f : 0.0f, 0.0f}, body,
		                                      (scree_vec){-0.5f, 0.0f});
		fixture_join(build, &joint);
		last = body;
	}
}

const Fixture beam_fixture = {"beam", 600, {{"size", 10}}, build_beam, NULL};
