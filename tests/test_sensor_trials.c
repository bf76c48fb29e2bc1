// SPDX-License-Identifier: MIT
// test_sensor_trials.c -- checks visits to sensors against samples of the paths of bodies, and against a list of all
// open visits.
#include "support/exact_shapes.h"
#include "support/make_joints.h"
#include "support/random_queries.h"
#include "tools/common/random_numbers.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

// ---------------------------------------------------------------------------------------------------------------
// paths of bodies
// ---------------------------------------------------------------------------------------------------------------

typedef struct // a collidable, and the poses of its body in a step
{
	scree_shape shape;
	scree_pose own;
	scree_body body; // null: the collidable has no body
	scree_vec center;
	scree_pose start, end; // poses of the body
} Rider;

static scree_pose rider_pose(scree_world* world, const Rider* r)
{
	scree_pose pose = {.rotation.c = 1.0f};
	if (!scree_body_is_null(r->body))
		pose = pose_of(world, r->body);
	return pose;
}

// Returns the shape at a time of the step, from 0 to 1, in double precision. The center of mass moves in a straight
// line; the body turns by the smaller angle at constant speed.
static Exact rider_at(const Rider* r, double time)
{
	double c0 = (double)r->start.rotation.c, s0 = (double)r->start.rotation.s;
	double c1 = (double)r->end.rotation.c, s1 = (double)r->end.rotation.s;
	double turn = time * atan2(c0 * s1 - s0 * c1, c0 * c1 + s0 * s1), c = c0 * cos(turn) - s0 * sin(turn),
	       s = s0 * cos(turn) + c0 * sin(turn);
	double mx = (double)r->center.x, my = (double)r->center.y;
	double x0 = (double)r->start.position.x + c0 * mx - s0 * my, y0 = (double)r->start.position.y + s0 * mx + c0 * my;
	double x1 = (double)r->end.position.x + c1 * mx - s1 * my, y1 = (double)r->end.position.y + s1 * mx + c1 * my;
	double ox = (double)r->own.position.x - mx, oy = (double)r->own.position.y - my;
	double oc = (double)r->own.rotation.c, os = (double)r->own.rotation.s;
	return exact_at(&r->shape, x0 + time * (x1 - x0) + c * ox - s * oy, y0 + time * (y1 - y0) + s * ox + c * oy,
	                c * oc - s * os, s * oc + c * os);
}

static double apart_at(const Rider* a, const Rider* b, double time)
{
	Exact at = rider_at(a, time), bt = rider_at(b, time);
	return exact_distance(&at, &bt);
}

// Adds a collidable at a random pose. Its body moves and turns at random; if `rests` is set, the body is static, or the
// collidable has no body.
static Rider add_rider(scree_world* world, uint64_t* seed, uint32_t sensor, float size, float speed, float spin,
                       scree_vec origin, bool rests, scree_collidable* collidable)
{
	Rider r = {.shape = random_shape(seed, 0.5f * size), .body = SCREE_NULL_BODY};
	scree_collidable_def def = scree_collidable_def_default();
	def.attribute = shape_attribute(world, r.shape);
	def.sensor = sensor;
	r.own = def.pose = random_pose(seed, (scree_vec){0.0f, 0.0f}, 0.3f * size);
	int type = random_below(seed, 4);
	if (rests && type == 3)
	{
		def.pose.position.x += origin.x;
		def.pose.position.y += origin.y;
		r.own = def.pose;
	}
	else
	{
		scree_body_def body = scree_body_def_default();
		body.type = rests ? SCREE_BODY_STATIC : type ? SCREE_BODY_DYNAMIC : SCREE_BODY_KINEMATIC;
		body.pose = random_pose(seed, (scree_vec){0.0f, 0.0f}, 1.5f * size);
		body.pose.position.x += origin.x;
		body.pose.position.y += origin.y;
		body.velocity.linear = (scree_vec){random_between(seed, -speed, speed), random_between(seed, -speed, speed)};
		body.velocity.angular = random_between(seed, -spin, spin);
		r.body = create_body(world, &body);
		def.body = r.body;
	}
	OK(scree_collidable_create(world, &def, collidable));
	if (!scree_body_is_null(r.body))
	{
		scree_mass mass = mass_of(world, r.body);
		r.center = mass.center;
	}
	return r;
}

typedef struct
{
	int met, missed, invented, late;
	double error; // largest error of the time of an event, as a fraction of a step
} Score;

#define SAMPLES 2048
#define BRIEF   (8.0 / SAMPLES) // fraction of a step; overlaps shorter than this may be missed

// Takes one step with a sensor and a visitor, and compares the visits with samples of both paths. Adds the differences
// to score.
static void judge(scree_world* world, Rider* a, Rider* b, scree_collidable sensor, double tolerance, Score* score)
{
	int count;
	OK(scree_collidable_get_visits(world, sensor, NULL, 0, &count));
	bool was = count > 0;
	a->start = rider_pose(world, a);
	b->start = rider_pose(world, b);
	run_steps(world, 1);
	a->end = rider_pose(world, a);
	b->end = rider_pose(world, b);
	scree_events events = events_of(world);
	OK(scree_collidable_get_visits(world, sensor, NULL, 0, &count));
	double least = INFINITY, first = -1.0, last = -1.0, deep_first = -1.0, deep_last = -1.0;
	for (int k = 0; k <= SAMPLES; ++k)
	{
		double time = (double)k / SAMPLES, apart = apart_at(a, b, time);
		least = fmin(least, apart);
		if (apart <= tolerance)
		{
			first = first < 0.0 ? time : first;
			last = time;
		}
		if (apart <= -tolerance)
		{
			deep_first = deep_first < 0.0 ? time : deep_first;
			deep_last = time;
		}
	}
	double end = apart_at(a, b, 1.0);
	if (fabs(end) > 1e-5 + tolerance)
		assert_int_equal(count, end < 0.0);
	if (was)
		return; // a visit that began in an earlier step: only the number of visits after this step is checked
	score->met += deep_first >= 0.0;
	if (least > tolerance && events.visits_began_count)
		++score->invented;
	if (deep_first >= 0.0 && deep_last - deep_first > BRIEF && !events.visits_began_count)
		++score->missed;
	if (!events.visits_began_count || deep_first < 0.0)
		return;
	double begin = (double)events.visits_began[0].time, slack = 1.5 / SAMPLES;
	double outside = fmax(first - slack - begin, begin - deep_first - slack);
	if (end > tolerance)
	{
		assert_int_equal(events.visits_ended_count, 1);
		double left = (double)events.visits_ended[0].time;
		assert_true(left >= begin);
		outside = fmax(outside, fmax(deep_last - slack - left, left - last - slack));
	}
	score->error = fmax(score->error, outside);
	score->late += outside > 0.0;
}

// Tries random shapes on bodies of all types, with centers of mass away from their origins. size: m; speed: maximum
// speed along x and along y, m/s; spin: maximum spin, rad/s; tolerance: maximum error of distances, m. Returns the
// sum of all differences and the largest error of a time.
static Score try_ways(int trials, float size, float speed, float spin, scree_vec origin, double tolerance)
{
	Score score = {0};
	uint64_t seed = 77;
	for (int k = 0; k < trials; ++k)
	{
		scree_world* world = open_world(0.0f);
		scree_collidable sensor, visitor;
		bool rests = random_below(&seed, 2);
		Rider a = add_rider(world, &seed, SCREE_SENSOR_MOVING, size, speed, spin, origin, rests, &sensor);
		Rider b = add_rider(world, &seed, 0, size, speed, spin, origin, false, &visitor);
		for (int step = 0; step < 3; ++step)
			judge(world, &a, &b, sensor, tolerance, &score);
		scree_world_destroy(world);
	}
	return score;
}

static void visits_match_samples(void** state)
{
	(void)state;
	// 90 km from the origin, neighboring floats are 8 mm apart
	int trials = quick() ? 20 : 100;
	const scree_vec here = {0.0f, 0.0f}, there = {90000.0f, -80000.0f};
	Score scores[] = {
	    try_ways(trials, 1.0f, 30.0f, 5.0f, here, 1e-3),     try_ways(trials, 1.0f, 100.0f, 180.0f, here, 1e-3),
	    try_ways(trials, 1.0f, 0.0f, 180.0f, here, 1e-3),    try_ways(trials, 0.2f, 10.0f, 100.0f, here, 5e-4),
	    try_ways(trials, 500.0f, 400.0f, 30.0f, here, 5e-3), try_ways(trials, 10.0f, 300.0f, 60.0f, there, 3e-2),
	    try_ways(trials, 0.2f, 1.0f, 3.0f, here, 2e-5),
	};
	for (size_t k = 0; k < sizeof scores / sizeof *scores; ++k)
		if (scores[k].met < trials / 20 || scores[k].missed || scores[k].invented || scores[k].late)
			fail_msg("run %zu: of %d visits %d missed, %d at other times, by %g of a step; %d that were none", k,
			         scores[k].met, scores[k].missed, scores[k].late, scores[k].error, scores[k].invented);
}

// ---------------------------------------------------------------------------------------------------------------
// ledger of visits
// ---------------------------------------------------------------------------------------------------------------

#define MOST 4096

typedef struct
{
	scree_collidable sensor, visitor;
} Entry;

typedef struct
{
	Entry open[MOST];
	int count;
} Ledger;

static int entry_of(const Ledger* l, const scree_visit* v)
{
	for (int k = 0; k < l->count; ++k)
		if (scree_collidable_equals(l->open[k].sensor, v->sensor) &&
		    scree_collidable_equals(l->open[k].visitor, v->visitor))
			return k;
	return -1;
}

static void ledger_end(Ledger* l, const scree_visit* v)
{
	int k = entry_of(l, v);
	if (k < 0)
		fail_msg("a visit of %u.%u to %u.%u ended that had not begun", v->visitor.index, v->visitor.generation,
		         v->sensor.index, v->sensor.generation);
	l->open[k] = l->open[--l->count];
}

// Applies the events of a step to the list of open visits, in this order: ends of visits from earlier steps, begins,
// ends of visits that began in this step.
static void ledger_step(Ledger* l, const scree_events* e)
{
	bool done[MOST] = {false};
	for (int k = 0; k < e->visits_ended_count; ++k)
		if (entry_of(l, e->visits_ended + k) >= 0)
		{
			ledger_end(l, e->visits_ended + k);
			done[k] = true;
		}
	for (int k = 0; k < e->visits_began_count; ++k)
	{
		const scree_visit* v = e->visits_began + k;
		if (entry_of(l, v) >= 0)
			fail_msg("a visit of %u.%u to %u.%u began twice", v->visitor.index, v->visitor.generation, v->sensor.index,
			         v->sensor.generation);
		l->open[l->count++] = (Entry){v->sensor, v->visitor};
	}
	for (int k = 0; k < e->visits_ended_count; ++k)
		if (!done[k])
			ledger_end(l, e->visits_ended + k);
}

#define CROWD 40

static scree_body add_compound(scree_world* world, uint64_t* seed)
{
	scree_body_def def = scree_body_def_default();
	def.type = random_below(seed, 5) ? SCREE_BODY_DYNAMIC : (scree_body_type)random_below(seed, 2);
	def.pose = random_pose(seed, (scree_vec){0.0f, 0.0f}, 3.0f);
	def.velocity.linear = (scree_vec){random_between(seed, -30.0f, 30.0f), random_between(seed, -30.0f, 30.0f)};
	def.velocity.angular = random_between(seed, -20.0f, 20.0f);
	scree_body body = create_body(world, &def);
	for (int k = 1 + random_below(seed, 3); k > 0; --k)
	{
		scree_attribute_def surface = surface_of(random_shape(seed, 0.5f * 1.0f));
		scree_collidable_def part = scree_collidable_def_default();
		part.attribute = add_attribute(world, &surface);
		part.body = random_below(seed, 12) ? body : SCREE_NULL_BODY;
		part.pose = random_pose(seed, (scree_vec){0.0f, 0.0f}, 0.5f);
		part.sensor = random_below(seed, 2) ? (uint32_t)random_below(seed, 8) : 0;
		OK(scree_collidable_create(world, &part, NULL));
	}
	return body;
}

static int random_part(scree_world* world, uint64_t* seed, scree_body body, scree_collidable* part)
{
	scree_collidable parts[64];
	int count;
	OK(scree_body_get_collidables(world, body, parts, 64, &count));
	count = count < 64 ? count : 64;
	if (count > 0)
		*part = parts[random_below(seed, count)];
	return count;
}

static void change(scree_world* world, uint64_t* seed, scree_body* bodies)
{
	int k = random_below(seed, CROWD);
	scree_collidable part;
	int parts = random_part(world, seed, random_below(seed, 6) ? bodies[k] : SCREE_NULL_BODY, &part);
	scree_filter filter = scree_filter_default();
	scree_attribute_def surface = surface_of(random_shape(seed, 0.5f * 1.0f));
	scree_joint_def joint = scree_joint_def_make(SCREE_JOINT_REVOLUTE);
	scree_body_type type;
	switch (random_below(seed, 11))
	{
	case 0:
		OK(scree_body_destroy(world, bodies[k]));
		bodies[k] = add_compound(world, seed);
		break;
	case 1:
		OK(scree_body_set_enabled(world, bodies[k], random_below(seed, 2)));
		break;
	case 2:
		if (parts)
			OK(scree_collidable_set_sensor(world, part, (uint32_t)random_below(seed, 8)));
		break;
	case 3:
		OK(scree_body_set_type(world, bodies[k], (scree_body_type)random_below(seed, 3)));
		break;
	case 4:
		OK(scree_body_set_pose(world, bodies[k], random_pose(seed, (scree_vec){0.0f, 0.0f}, 3.0f)));
		break;
	case 5:
		filter.mask = random_below(seed, 2) ? UINT64_MAX : 2;
		filter.group = random_below(seed, 3) - 1;
		if (parts)
			OK(scree_collidable_set_filter(world, part, filter));
		break;
	case 6:
		if (parts)
			OK(scree_collidable_set_attribute(world, part, add_attribute(world, &surface)));
		break;
	case 7:
		if (parts > 1)
			OK(scree_collidable_destroy(world, part));
		break;
	case 8:
		joint.body_a = bodies[k];
		joint.body_b = bodies[(k + 1) % CROWD];
		add_joint(world, &joint);
		break;
	case 9:
		OK(scree_body_get_type(world, bodies[k], &type));
		if (type == SCREE_BODY_DYNAMIC)
			OK(scree_body_set_mass(world, bodies[k], (scree_mass){1.0f, 0.1f, {0.3f, 0.0f}}));
		break;
	default:
		OK(scree_body_set_velocity(world, bodies[k],
		                           (scree_velocity){{random_between(seed, -300.0f, 300.0f), 20.0f}, 100.0f}));
	}
}

// Checks that the open visits of the list equal those that the sensors report.
static void check_open(scree_world* world, const Ledger* l)
{
	int total = 0;
	for (int k = 0; k < l->count; ++k)
	{
		int count;
		bool first = true;
		for (int i = 0; i < k; ++i)
			first &= !scree_collidable_equals(l->open[i].sensor, l->open[k].sensor);
		if (!first)
			continue;
		scree_visit visits[MOST];
		OK(scree_collidable_get_visits(world, l->open[k].sensor, visits, MOST, &count));
		for (int i = 0; i < count; ++i)
			assert_true(entry_of(l, visits + i) >= 0);
		total += count;
	}
	assert_int_equal(total, l->count);
}

static void every_visit_is_in_the_ledger(void** state)
{
	(void)state;
	for (int run = 0; run < (quick() ? 2 : 8); ++run)
	{
		static Ledger ledger;
		ledger.count = 0;
		scree_world* world = open_world(run % 2 ? -10.0f : 0.0f);
		uint64_t seed = 100 + (uint64_t)run;
		scree_body bodies[CROWD];
		add_floor(world);
		for (int k = 0; k < CROWD; ++k)
			bodies[k] = add_compound(world, &seed);
		for (int step = 0; step < (quick() ? 80 : 300); ++step)
		{
			run_steps(world, 1);
			scree_events events;
			if (random_below(&seed, 3) == 0)
				change(world, &seed, bodies); // these changes must not change the events of the last step
			events = events_of(world);
			ledger_step(&ledger, &events);
			for (int n = random_below(&seed, 5); n > 0; --n)
				change(world, &seed, bodies);
			if (step % 7 == 0)
			{
				OK(scree_world_step(world, 0.0f, 1));
				events = events_of(world);
				ledger_step(&ledger, &events);
				check_open(world, &ledger);
			}
		}
		scree_world_destroy(world);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(visits_match_samples),
	    cmocka_unit_test(every_visit_is_in_the_ledger),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
