// SPDX-License-Identifier: MIT
// sensors.c -- checks that sensors of all shapes report each body that overlaps them at any time of a step, and no
// other.
#include "experiment_support.h"
#include "scenery.h"
#include "shape_difference.h"
#include <math.h>

#define VISITORS 100
#define SLACK    1e-4 // m: tolerance of the distance from the surface of a sensor, which is at rest
#define DEPTH    1e-3 // m: a visit within a step needs at least this overlap (docs/manual/events.md)

typedef struct
{
	scree_body bodies[VISITORS];
	scree_shape shapes[VISITORS];
	scree_pose begin[VISITORS], end[VISITORS];
	int asked, wrong;
	char first[96];
} Visitors;

static void wrong(Visitors* all, const char* what, int sensor, int visitor, double by)
{
	if (all->wrong++ == 0)
		snprintf(all->first, sizeof all->first, "%s: sensor %d; visitor %d of %d corners; %.3g m", what, sensor,
		         visitor, all->shapes[visitor].count, by);
}

static void make_visitors(const Scenery* s, uint64_t* seed, Visitors* all)
{
	for (int k = 0; k < VISITORS && !s->validation->broken; ++k)
	{
		scree_attribute_def surface = scree_attribute_def_default();
		scree_body_def body = scree_body_def_default();
		surface.shape = all->shapes[k] = scenery_shape(seed, k % SCENERY_KINDS);
		scree_probe probe = scenery_probe(s, seed, &surface.shape);
		scenery_ok(s, scree_attribute_create(s->world, &surface, &body.attribute));
		body.type = SCREE_BODY_KINEMATIC;
		body.pose = all->begin[k] = probe.pose;
		double length = hypot((double)probe.translation.x, (double)probe.translation.y);
		float speed = (float)(60.0 * fmin(1.0, 6.0 / fmax(length, 1e-9)));
		body.velocity.linear = (scree_vec){speed * probe.translation.x, speed * probe.translation.y};
		scenery_ok(s, scree_body_create(s->world, &body, &all->bodies[k]));
	}
}

// Returns the list's entry for a body that visits a sensor; null if there is none.
static const scree_visit* find(const scree_visit* visits, int count, scree_collidable sensor, scree_body body)
{
	for (int k = 0; k < count; ++k)
		if (scree_collidable_equals(visits[k].sensor, sensor) && scree_body_equals(visits[k].body_visitor, body))
			return &visits[k];
	return NULL;
}

static void check(const Scenery* s, Visitors* all, int sensor, int k, const scree_visit* began,
                  const scree_visit* stays)
{
	double x = (double)all->end[k].position.x - (double)all->begin[k].position.x;
	double y = (double)all->end[k].position.y - (double)all->begin[k].position.y;
	double slack = SLACK + 2.0 * s->rounding, margin;
	scree_probe probe = {.pose = all->begin[k], .translation = {(float)x, (float)y}};
	if (!began && !stays && scenery_is_away(s, sensor, all->shapes[k].reach, &probe))
		return;
	Difference d = difference_of(&s->shapes[sensor], s->poses[sensor], &all->shapes[k], all->begin[k]);
	double meeting = difference_meeting(&d, x, y, &margin), end = difference_distance(&d, x, y);
	if (!began && meeting <= 1.0 && margin > DEPTH + slack && difference_least(&d, x, y, 1.0) < -DEPTH - slack)
		wrong(all, "missed", sensor, k, margin);
	if (began && meeting > 1.0 && difference_least(&d, x, y, 1.0) > slack)
		wrong(all, "seen from afar", sensor, k, difference_least(&d, x, y, 1.0));
	if (began && meeting > 0.0 && fabs(difference_distance(&d, began->time * x, began->time * y)) > 2.0 * DEPTH + slack)
		wrong(all, "at another time", sensor, k, difference_distance(&d, began->time * x, began->time * y));
	if (stays ? end > slack : end < -slack)
		wrong(all, stays ? "stays" : "left", sensor, k, end);
}

static void step_once(Validation* v, uint64_t* seed, double place, Visitors* all)
{
	Scenery s = scenery_open(v, seed, place);
	for (int k = 0; k < SCENERY_SHAPES && !v->broken; ++k)
		scenery_ok(&s, scree_collidable_set_sensor(s.world, s.handles[k], SCREE_SENSOR_MOVING));
	make_visitors(&s, seed, all);
	scenery_ok(&s, scree_world_step(s.world, 1.0f / 60.0f, 4));
	scree_events events = {0};
	scenery_ok(&s, scree_world_get_events(s.world, &events));
	for (int k = 0; k < VISITORS && !v->broken; ++k)
		scenery_ok(&s, scree_body_get_pose(s.world, all->bodies[k], &all->end[k]));
	for (int sensor = 0; sensor < SCENERY_SHAPES && !v->broken; ++sensor)
	{
		scree_visit visits[VISITORS];
		int count = 0;
		scenery_ok(&s, scree_collidable_get_visits(s.world, s.handles[sensor], visits, VISITORS, &count));
		for (int k = 0; k < VISITORS && !v->broken; ++k)
			check(&s, all, sensor, k,
			      find(events.visits_began, events.visits_began_count, s.handles[sensor], all->bodies[k]),
			      find(visits, count, s.handles[sensor], all->bodies[k]));
	}
	all->asked += VISITORS;
	scenery_close(&s);
}

void sensors_experiment(Validation* v)
{
	if (!scenery_is_of(v))
		return;
	for (int far = 0; far < 2; ++far)
	{
		static Visitors all;
		uint64_t seed = 7;
		all = (Visitors){0};
		begin(v, far ? "visitors 90 km away" : "visitors");
		for (int world = 0; world < (v->quick ? 10 : 10000) && !v->broken; ++world)
			step_once(v, &seed, far ? 90000.0 : 0.0, &all);
		row(v, "visitors", all.asked, "", SHOWN, 0.0);
		where(v, "%s", all.first);
		row(v, "wrong", all.wrong, "", AT_MOST, 0.0);
	}
}
