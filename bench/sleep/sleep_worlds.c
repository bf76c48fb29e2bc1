// SPDX-License-Identifier: MIT
// sleep_worlds.c -- builds the worlds of scree_sleep: pyramids on shelves, falling balls, one large pyramid.
//
// Awake pyramids stand on the lowest shelves and sleeping ones above them, so awake bodies have the same coordinates,
// and thus the same rounding, with and without sleepers.
#include "sleep_worlds.h"
#include "validate/engine_scree.h"
#include "validate/scree_world.h"
#include <stdio.h>

#define FIELD_ROWS  10
#define BOXES       55    // boxes of a pyramid of FIELD_ROWS rows
#define CONTACTS    150   // contacts of such a pyramid, and spare ones
#define SHELF       300   // pyramids on a shelf
#define WIDTH       12.0f // m: distance of pyramids
#define HEIGHT      16.0f // m: distance of shelves
#define LAYER       1000  // balls side by side
#define BALL_SPACE  3.0f  // m: distance of balls
#define BALL_HEIGHT -20.0f
#define SLEEP_LIMIT 3000 // steps within which a pyramid must fall asleep; 100 rows need about 1,000

static int awake_bodies(const SleepSetting* setting)
{
	int sleepers = setting->sleepers > 0 ? setting->sleepers : STANDARD_SLEEPERS;
	int hundredth = sleepers < 99 ? 1 : sleepers / 99;
	return setting->awake > 0 ? setting->awake : hundredth;
}

static int pyramids_of(int bodies) { return (bodies + BOXES - 1) / BOXES; }
static int shelves_of(int pyramids) { return (pyramids + SHELF - 1) / SHELF; }

static int awake_pyramids(const SleepRun* run)
{
	return run->item->awake == SOME_PYRAMIDS ? pyramids_of(awake_bodies(run->setting)) : 0;
}

static int balls(const SleepRun* run)
{
	return run->item->awake == ONE_BALL ? 1 : run->item->awake == SOME_BALLS ? awake_bodies(run->setting) : 0;
}

int sleeping_pyramids(const SleepRun* run)
{
	bool none = run->item->sleepers == 0 || (run->compared && run->item->beside == BESIDE_AWAKE);
	return none ? 0 : pyramids_of(run->setting->sleepers > 0 ? run->setting->sleepers : run->item->sleepers);
}

static scree_vec place(int number)
{
	return (scree_vec){((float)(number % SHELF) - 0.5f * (SHELF - 1)) * WIDTH, (float)(number / SHELF) * HEIGHT};
}

scree_vec sleeping_place(const SleepRun* run, int number)
{
	return place(shelves_of(awake_pyramids(run)) * SHELF + number);
}

bool sleep_world_open(SleepRun* run)
{
	scree_world_def def = scree_world_def_default();
	int pyramids = sleeping_pyramids(run) + awake_pyramids(run),
	    large = run->setting->rows * (run->setting->rows + 1) / 2;
	engine_set_device(&def, &run->setting->place);
	def.sleep = !(run->compared && run->item->beside == BESIDE_NO_SLEEP);
	if (run->item->beside == BESIDE_LATER)
	{
		def.body_capacity = large + 64;
		def.contact_capacity = 3 * large + 64;
	}
	else
	{
		def.body_capacity = BOXES * pyramids + shelves_of(pyramids) + balls(run) + 64;
		def.contact_capacity = CONTACTS * pyramids + 64;
	}
	return report_status(scree_world_create(&def, &run->world));
}

void sleep_world_close(SleepRun* run)
{
	scree_world_destroy(run->world);
	run->world = NULL;
}

static bool add_attribute(SleepRun* run, const scree_shape* shape, scree_attribute* attribute)
{
	scree_attribute_def def = scree_attribute_def_default();
	def.shape = *shape;
	return report_status(scree_attribute_create(run->world, &def, attribute));
}

// Adds a static box whose upper side is at a height, m.
static bool add_shelf(SleepRun* run, float half_width, float height)
{
	scree_shape shape;
	scree_body_def def = scree_body_def_default();
	def.type = SCREE_BODY_STATIC;
	def.pose.position.y = height - 0.5f;
	return report_status(scree_shape_make_box(half_width, 0.5f, &shape)) &&
	       add_attribute(run, &shape, &def.attribute) && report_status(scree_body_create(run->world, &def, NULL));
}

// Adds a pyramid of boxes 1 m wide, row by row. body: definition of the boxes, with their attribute.
static bool add_pyramid(SleepRun* run, scree_vec base, int rows, scree_body_def body)
{
	scree_body_def defs[MAX_ROWS];
	scree_body bodies[MAX_ROWS];
	for (int row = 0; row < rows; ++row)
	{
		int count = rows - row;
		for (int k = 0; k < count; ++k)
		{
			defs[k] = body;
			// boxes of a row are 1 cm apart
			defs[k].pose.position =
			    (scree_vec){base.x + 1.01f * ((float)k - 0.5f * (float)(count - 1)), base.y + 0.5f + (float)row};
		}
		if (!report_status(scree_bodies_create(run->world, defs, count, bodies)))
			return false;
		if (row == 0)
			run->woken = bodies[count / 2];
		run->hit = bodies[0];
	}
	return true;
}

// Adds balls that fall without touching anything.
static bool add_balls(SleepRun* run, int count)
{
	scree_shape shape;
	scree_body_def def = scree_body_def_default();
	def.stays_awake = true;
	bool good = report_status(scree_shape_make_circle((scree_vec){0.0f, 0.0f}, 0.3f, &shape)) &&
	            add_attribute(run, &shape, &def.attribute);
	for (int k = 0; k < count && good; ++k)
	{
		def.pose.position = (scree_vec){BALL_SPACE * ((float)(k % LAYER) - 0.5f * LAYER),
		                                BALL_HEIGHT - BALL_SPACE * (float)(k / LAYER)};
		good = report_status(scree_body_create(run->world, &def, NULL));
	}
	return good;
}

static bool add_box_attribute(SleepRun* run)
{
	scree_shape shape;
	return report_status(scree_shape_make_box(0.5f, 0.5f, &shape)) && add_attribute(run, &shape, &run->box);
}

bool build_field(SleepRun* run)
{
	scree_body_def sleeper = scree_body_def_default(), riser = scree_body_def_default();
	if (!add_box_attribute(run))
		return false;
	sleeper.attribute = riser.attribute = run->box;
	sleeper.asleep = true;
	riser.stays_awake = true;
	int asleep = sleeping_pyramids(run), awake = awake_pyramids(run), shelves = shelves_of(awake) + shelves_of(asleep);
	bool good = true;
	for (int k = 0; k < shelves && good; ++k)
		good = add_shelf(run, 0.5f * WIDTH * SHELF, HEIGHT * (float)k);
	for (int k = 0; k < asleep && good; ++k)
		good = add_pyramid(run, sleeping_place(run, k), FIELD_ROWS, sleeper);
	for (int k = 0; k < awake && good; ++k)
		good = add_pyramid(run, place(k), FIELD_ROWS, riser);
	run->asleep = BOXES * asleep;
	return good && add_balls(run, balls(run));
}

bool build_pyramid(SleepRun* run)
{
	scree_body_def box = scree_body_def_default();
	int rows = run->setting->rows;
	box.asleep = run->item->created_asleep;
	if (!add_shelf(run, 2.0f * MAX_ROWS, 0.0f) || !add_box_attribute(run))
		return false;
	box.attribute = run->box;
	if (!add_pyramid(run, (scree_vec){0.0f, 0.0f}, rows, box))
		return false;
	scree_counters counters = {0};
	for (int step = 0; counters.asleep_bodies < rows * (rows + 1) / 2; ++step)
	{
		if (step == SLEEP_LIMIT)
		{
			fprintf(stderr, "scree_sleep: %s: a pyramid of %d rows is awake after %d steps\n", run->item->name, rows,
			        step);
			return false;
		}
		if (!sleep_run_step(run) || !report_status(scree_world_get_counters(run->world, &counters)))
			return false;
	}
	return true;
}
