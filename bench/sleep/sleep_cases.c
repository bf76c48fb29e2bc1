// SPDX-License-Identifier: MIT
// sleep_cases.c -- lists the cases of scree_sleep, with the calls of a user that they make before each timed step.
#include "sleep_cases.h"
#include "sleep_worlds.h"
#include "validate/scree_world.h"
#include <string.h>

#define VISITORS 55 // boxes of the pyramid that the sensor covers

// Creates a body below the shelves, and destroys one that was created SPAWNED steps before.
static bool spawn(SleepRun* run, int number)
{
	scree_body_def def = scree_body_def_default();
	scree_body* slot = &run->spawned[number % SPAWNED];
	def.attribute = run->box;
	def.stays_awake = true;
	def.pose.position = (scree_vec){3.0f * (float)(number % SPAWNED), -200.0f - (float)(number % 1000)};
	return (number < SPAWNED || report_status(scree_body_destroy(run->world, *slot))) &&
	       report_status(scree_body_create(run->world, &def, slot));
}

// Casts a ray downwards to the top of a sleeping pyramid, 10 m above its base.
static bool cast_ray(SleepRun* run, int number)
{
	// a prime number of pyramids between two rays, so that they are far apart
	scree_vec base = sleeping_place(run, (int)((int64_t)number * 7919 % sleeping_pyramids(run)));
	scree_query_result result;
	if (!report_status(
	        scree_world_cast_ray(run->world, (scree_vec){base.x, base.y + 14.0f}, (scree_vec){0.0f, -8.0f}, &result)))
		return false;
	run->found += result.hit && result.fraction > 0.49f && result.fraction < 0.51f;
	++run->expected;
	return true;
}

// Builds the field with a sensor around the first sleeping pyramid.
static bool build_sensor(SleepRun* run)
{
	scree_attribute_def surface = scree_attribute_def_default();
	scree_collidable_def def = scree_collidable_def_default();
	scree_vec base = sleeping_place(run, 0);
	def.sensor = SCREE_SENSOR_MOVING;
	def.pose.position = (scree_vec){base.x, base.y + 5.0f};
	return report_status(scree_shape_make_box(5.9f, 4.9f, &surface.shape)) &&
	       report_status(scree_attribute_create(run->world, &surface, &def.attribute)) &&
	       report_status(scree_collidable_create(run->world, &def, &run->sensor)) && build_field(run);
}

static bool read_sensor(SleepRun* run, int number)
{
	scree_visit visits[VISITORS];
	int count = 0;
	if (!report_status(scree_collidable_get_visits(run->world, run->sensor, visits, VISITORS, &count)))
		return false;
	run->found += count;
	run->expected += number > 0 ? VISITORS : 0; // visits begin in the first step
	return true;
}

static bool hit(SleepRun* run, int number)
{
	return number > 0 || report_status(scree_body_apply_impulse(run->world, run->hit, (scree_vec){3.0f, 0.0f}));
}

static bool wake_body(SleepRun* run, int number)
{
	return number > 0 || report_status(scree_body_set_awake(run->world, run->woken, true));
}

static bool wake_world(SleepRun* run, int number)
{
	return number > 0 || report_status(scree_world_set_awake(run->world, true));
}

const SleepCase sleep_cases[] = {
    {"part", "1 % of a million boxes awake, in pyramids", BESIDE_AWAKE, SOME_PYRAMIDS, STANDARD_SLEEPERS, false, false,
     build_field, NULL},
    {"balls", "1 % of a million bodies awake: falling balls", BESIDE_AWAKE, SOME_BALLS, STANDARD_SLEEPERS, false, false,
     build_field, NULL},
    {"ball", "one falling ball, ten million boxes asleep", BESIDE_NOTHING, ONE_BALL, LARGE_SLEEPERS, true, false,
     build_field, NULL},
    {"all", "everything asleep", BESIDE_NOTHING, NO_BODY, STANDARD_SLEEPERS, false, false, build_field, NULL},
    {"awake", "everything awake in a world that may sleep", BESIDE_NO_SLEEP, SOME_PYRAMIDS, 0, false, false,
     build_field, NULL},
    {"spawn", "a body created and another destroyed in each step", BESIDE_NOTHING, NO_BODY, STANDARD_SLEEPERS, false,
     false, build_field, spawn},
    {"ray", "one falling ball, and a ray in each step", BESIDE_NOTHING, ONE_BALL, STANDARD_SLEEPERS, false, false,
     build_field, cast_ray},
    {"sensor", "one falling ball, and visits read in each step", BESIDE_NOTHING, ONE_BALL, STANDARD_SLEEPERS, false,
     false, build_sensor, read_sensor},
    {"wake-created", "a pyramid that was created asleep is hit", BESIDE_LATER, NO_BODY, 0, false, true, build_pyramid,
     hit},
    {"wake-hit", "a pyramid that fell asleep is hit", BESIDE_LATER, NO_BODY, 0, false, false, build_pyramid, hit},
    {"wake-body", "a body of a pyramid that fell asleep is woken", BESIDE_LATER, NO_BODY, 0, false, false,
     build_pyramid, wake_body},
    {"wake-world", "a world with a pyramid that fell asleep is woken", BESIDE_LATER, NO_BODY, 0, false, false,
     build_pyramid, wake_world},
};
const int sleep_case_count = sizeof sleep_cases / sizeof sleep_cases[0];

const SleepCase* sleep_case_find(const char* name)
{
	for (int k = 0; k < sleep_case_count; ++k)
	{
		if (strcmp(sleep_cases[k].name, name) == 0)
			return &sleep_cases[k];
	}
	return NULL;
}
