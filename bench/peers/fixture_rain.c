// SPDX-License-Identifier: MIT
// fixture_rain.c -- builds two scenes. In rain, ragdolls fall on five floors and are replaced after some steps. In
// humans, ragdolls come to rest on a floor.
#include "fixtures.h"
#include "ragdoll.h"
#include "validate/scree_world.h"
#include <stdlib.h>

#define ROWS       5
#define ROW_HEIGHT 45.0f // m: distance from floor to floor
#define DROP       40.0f // m: initial height of ragdolls above their floor
#define GROUP      5     // number of ragdolls that are created at the same time above each floor, in one column
#define LIFE       320   // number of steps after which a ragdoll is destroyed
#define TILE       0.5f  // m: side of the square tiles of the floors
#define COLUMN     6.25f // m: width of a column

enum
{
	COLUMNS
};

static float span_of(const FixtureBuild* build) { return COLUMN * (float)build->values[COLUMNS]; }

static void build_rain(FixtureBuild* build)
{
	scree_body_def def = fixture_body(SCREE_BODY_STATIC, 0.0f, 0.0f);
	scree_body ground = fixture_add(build, &def);
	scree_attribute_def tile = fixture_box(build, 0.5f * TILE, 0.5f * TILE);
	float span = span_of(build);
	int tiles = (int)(span / TILE);
	for (int row = 0; row < ROWS; ++row)
	{
		for (int k = 0; k <= tiles; ++k)
			fixture_attach(build, ground, &tile, (scree_vec){TILE * (float)k - 0.5f * span, ROW_HEIGHT * (float)row},
			               scree_filter_default());
	}
}

// Destroys all bodies with this user data: the ragdolls of one column.
static void destroy_column(FixtureBuild* build, uint64_t user)
{
	int count, chosen = 0;
	scree_body* bodies = list_bodies(build->world, &count);
	build->good = build->good && bodies;
	for (int k = 0; k < count && build->good; ++k)
	{
		uint64_t word;
		build->good = report_status(scree_body_get_user(build->world, bodies[k], &word));
		if (word == user)
			bodies[chosen++] = bodies[k];
	}
	build->good = build->good && report_status(scree_bodies_destroy(build->world, bodies, chosen));
	free(bodies);
}

static void change_rain(FixtureBuild* build, int64_t step)
{
	int columns = (int)build->values[COLUMNS], every = LIFE / columns;
	if (step % every != 0)
		return;
	int column = (int)(step / every % columns);
	uint64_t user = (uint64_t)column + 1;
	if (step / every >= columns)
		destroy_column(build, user);
	for (int row = 0; row < ROWS; ++row)
	{
		for (int k = 0; k < GROUP; ++k)
			ragdoll_add(build,
			            (scree_vec){COLUMN * ((float)column + 0.5f) - 0.5f * span_of(build) + 0.5f * (float)k,
			                        DROP + ROW_HEIGHT * (float)row},
			            k + 1, user);
	}
}

const Fixture rain_fixture = {"rain", 1000, {{"columns", 40}}, build_rain, change_rain};

enum
{
	COUNT
};

static void build_ragdolls(FixtureBuild* build)
{
	int count = (int)build->values[COUNT];
	scree_attribute_def floor = fixture_box(build, 2.0f * (float)count + 10.0f, 0.5f);
	fixture_put(build, fixture_body(SCREE_BODY_STATIC, 2.0f * (float)count, -0.5f), &floor);
	for (int k = 0; k < count; ++k)
		ragdoll_add(build, (scree_vec){4.0f * (float)k, 0.5f}, k + 1, 0);
}

const Fixture ragdolls_fixture = {"humans", 3600, {{"count", 10}}, build_ragdolls, NULL};
