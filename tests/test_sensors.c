// SPDX-License-Identifier: MIT
// test_sensors.c -- checks visits to sensors, also within a step: each visit begins once and ends once, and all devices
// agree.
#include "support/exact_shapes.h"
#include "support/make_bodies.h"
#include "support/variants.h"
#include "tools/common/byte_hash.h"
#include "tools/common/random_numbers.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

static scree_collidable add_sensor(scree_world* world, scree_shape shape, uint32_t sees, scree_pose pose)
{
	scree_collidable_def def = scree_collidable_def_default();
	def.attribute = shape_attribute(world, shape);
	def.pose = pose;
	def.sensor = sees;
	return create_collidable(world, &def);
}

static int visits_of(scree_world* world, scree_collidable sensor)
{
	int count;
	OK(scree_collidable_get_visits(world, sensor, NULL, 0, &count));
	return count;
}

// ---------------------------------------------------------------------------------------------------------------
// within a step
// ---------------------------------------------------------------------------------------------------------------

// Circles fly at 60 m/s, 1 m per step, from all sides through a sensor of 0.2 m. The sensor reports each circle, with
// the exact times of begin and end.
static void bullets_are_seen(void** state)
{
	(void)state;
	uint64_t seed = 1;
	int seen = 0;
	for (int k = 0; k < 1000; ++k)
	{
		scree_world* world = open_world(0.0f);
		bool rides = k % 2; // true: the sensor is on a kinematic body, which also moves
		scree_collidable sensor = add_sensor(world, box_shape(0.1f, 0.1f), SCREE_SENSOR_MOVING, upright_at(0.0f, 0.0f));
		scree_vec drift = {0.0f, 0.0f};
		if (rides)
		{
			OK(scree_collidable_destroy(world, sensor));
			scree_body_def def = scree_body_def_default();
			def.type = SCREE_BODY_KINEMATIC;
			def.attribute = shape_attribute(world, box_shape(0.1f, 0.1f));
			def.sensor = SCREE_SENSOR_MOVING;
			drift = def.velocity.linear =
			    (scree_vec){random_between(&seed, -20.0f, 20.0f), random_between(&seed, -20.0f, 20.0f)};
			OK(scree_body_create(world, &def, NULL));
		}
		float angle = random_between(&seed, -3.1f, 3.1f), phase = random_between(&seed, 0.0f, 1.0f), radius = 0.05f;
		scree_rot direction = scree_rot_make(angle);
		scree_vec velocity = {60.0f * direction.c + drift.x, 60.0f * direction.s + drift.y};
		float back = 3.0f + phase;
		add_thrown(world, circle_shape(radius), -back * direction.c, -back * direction.s, velocity.x, velocity.y);
		double begin = -1.0, end = -1.0;
		int began = 0, ended = 0;
		for (int step = 0; step < 8; ++step)
		{
			run_steps(world, 1);
			scree_events events = events_of(world);
			began += events.visits_began_count;
			ended += events.visits_ended_count;
			if (events.visits_began_count)
				begin = step + (double)events.visits_began[0].time;
			if (events.visits_ended_count)
				end = step + (double)events.visits_ended[0].time;
		}
		// exact times by bisection, with the velocity relative to the sensor
		scree_shape box = box_shape(0.1f, 0.1f), ball = circle_shape(radius);
		Exact a = exact_at(&box, 0.0, 0.0, 1.0, 0.0);
		Exact b = exact_at(&ball, (double)(-back * direction.c), (double)(-back * direction.s), 1.0, 0.0);
		double least, path = 8.0;
		double expected = path * exact_meeting(&a, &b, path * (double)direction.c, path * (double)direction.s, &least);
		Exact far = exact_moved(b, path * (double)direction.c, path * (double)direction.s);
		double left =
		    path * (1.0 - exact_meeting(&a, &far, -path * (double)direction.c, -path * (double)direction.s, &least));
		seen += began == 1 && ended == 1;
		NEAR(begin, expected, 2e-3);
		NEAR(end, left, 2e-3);
		scree_world_destroy(world);
	}
	assert_int_equal(seen, 1000);
}

// A body flies through a sensor and bounces off a wall. The sensor does not stop the body, and a sensor behind the wall
// reports no visit.
static void behind_a_wall(void** state)
{
	(void)state;
	scree_world* world = open_world(0.0f);
	add_box(world, SCREE_BODY_STATIC, 0.1f, 5.0f, 0.0f, 0.0f);
	scree_collidable behind = add_sensor(world, box_shape(0.2f, 2.0f), SCREE_SENSOR_MOVING, upright_at(0.5f, 0.0f));
	scree_collidable before = add_sensor(world, box_shape(0.2f, 2.0f), SCREE_SENSOR_MOVING, upright_at(-1.5f, 0.0f));
	add_thrown(world, circle_shape(0.1f), -5.3f, 0.0f, 90.0f, 0.0f);
	int began = 0, ended = 0;
	for (int k = 0; k < 30; ++k)
	{
		run_steps(world, 1);
		scree_events events = events_of(world);
		for (int i = 0; i < events.visits_began_count; ++i)
			assert_true(scree_collidable_equals(events.visits_began[i].sensor, before));
		began += events.visits_began_count;
		ended += events.visits_ended_count;
	}
	assert_true(began >= 1 && ended == began && visits_of(world, behind) == 0);
	scree_world_destroy(world);
}

// A thin bar that turns by 90 degrees in a step visits a sensor beside it.
static void turning_bars(void** state)
{
	(void)state;
	scree_world* world = open_world(0.0f);
	scree_body bar = add_shape(world, SCREE_BODY_DYNAMIC, box_shape(2.0f, 0.02f), 0.0f, 0.0f, 0.0f);
	add_sensor(world, box_shape(0.05f, 0.05f), SCREE_SENSOR_MOVING, upright_at(1.2f, 1.2f));
	OK(scree_body_set_angular_velocity(world, bar, 94.0f)); // 1.57 rad in a step
	run_steps(world, 1);
	scree_events events = events_of(world);
	assert_true(events.visits_began_count == 1 && events.visits_ended_count == 1);
	assert_true(events.visits_began[0].time > 0.3f && events.visits_ended[0].time < 0.7f);
	assert_true(events.visits_began[0].time < events.visits_ended[0].time);
	scree_world_destroy(world);
}

// ---------------------------------------------------------------------------------------------------------------
// selection of visitors
// ---------------------------------------------------------------------------------------------------------------

static void kinds_and_filters(void** state)
{
	(void)state;
	scree_world* world = open_world(0.0f);
	scree_collidable moving = add_sensor(world, box_shape(1.0f, 1.0f), SCREE_SENSOR_MOVING, upright_at(0.0f, 0.0f));
	scree_collidable still = add_sensor(world, box_shape(1.0f, 1.0f), SCREE_SENSOR_STATIC, upright_at(0.0f, 0.0f));
	scree_collidable all = add_sensor(world, box_shape(1.0f, 1.0f), 7, upright_at(0.0f, 0.0f));
	add_box(world, SCREE_BODY_STATIC, 0.1f, 0.1f, 0.5f, 0.5f);
	add_box(world, SCREE_BODY_KINEMATIC, 0.1f, 0.1f, -0.5f, 0.5f);
	scree_body crate = add_box(world, SCREE_BODY_DYNAMIC, 0.1f, 0.1f, -0.5f, -0.5f);
	scree_collidable_def def = scree_collidable_def_default();
	def.attribute = shape_attribute(world, box_shape(0.1f, 0.1f));
	OK(scree_collidable_create(world, &def, NULL)); // a collidable without a body
	// a sensor on the crate; it does not report the crate
	def.body = crate;
	def.sensor = 7;
	scree_collidable own = create_collidable(world, &def);
	run_steps(world, 1);
	assert_int_equal(visits_of(world, moving), 2);
	assert_int_equal(visits_of(world, still), 2);
	assert_int_equal(visits_of(world, all), 4 + 3); // 4 collidables and 3 sensors
	assert_int_equal(visits_of(world, own), 3);     // three large sensors; `own` overlaps nothing else
	scree_filter filter = scree_filter_default();
	filter.mask = 2;
	OK(scree_collidable_set_filter(world, all, filter));
	run_steps(world, 1);
	assert_int_equal(visits_of(world, all), 0);
	assert_int_equal(events_of(world).visits_ended_count, 7 + 1); // 7 visits to `all`; 1 visit of `all` to `own`
	// queries find sensors only with SCREE_QUERY_SENSORS
	scree_query_result found;
	scree_query_def query = scree_query_def_default();
	scree_ray ray = {.origin = {-3.0f, 0.9f}, .translation = {6.0f, 0.0f}};
	OK(scree_world_cast_rays(world, &query, &ray, 1, &found));
	assert_true(!found.hit);
	query.kinds = SCREE_QUERY_SENSORS;
	OK(scree_world_cast_rays(world, &query, &ray, 1, &found));
	assert_true(found.hit && scree_collidable_equals(found.collidable, moving));
	scree_world_destroy(world);
}

// A crate that lies in a sensor for two minutes begins one visit. Each time that the crate is disabled, enabled,
// destroyed or created again, the sensor reports one event.
static void one_end_for_each_beginning(void** state)
{
	(void)state;
	scree_world* world = open_world(-10.0f);
	add_floor(world);
	scree_collidable sensor = add_sensor(world, box_shape(2.0f, 1.0f), SCREE_SENSOR_MOVING, upright_at(0.0f, 0.5f));
	scree_body crate = add_shape(world, SCREE_BODY_DYNAMIC, box_shape(0.5f, 0.5f), 0.0f, 4.0f, 0.0f);
	int began = 0, ended = 0;
	for (int k = 0; k < (quick() ? 300 : 7200); ++k)
	{
		run_steps(world, 1);
		began += events_of(world).visits_began_count;
		ended += events_of(world).visits_ended_count;
	}
	assert_true(began == 1 && ended == 0 && visits_of(world, sensor) == 1);
	OK(scree_body_set_enabled(world, crate, false));
	run_steps(world, 1);
	assert_true(events_of(world).visits_ended_count == 1 && !events_of(world).visits_ended[0].destroyed_visitor);
	OK(scree_body_set_enabled(world, crate, true));
	run_steps(world, 1);
	assert_int_equal(events_of(world).visits_began_count, 1);

	// a new crate in the same slot: the old visit ends, and a new one begins
	scree_visit visit;
	int count;
	OK(scree_collidable_get_visits(world, sensor, &visit, 1, &count));
	scree_pose pose = pose_of(world, crate);
	OK(scree_body_destroy(world, crate));
	crate = add_shape(world, SCREE_BODY_DYNAMIC, box_shape(0.5f, 0.5f), pose.position.x, pose.position.y, 0.0f);
	run_steps(world, 1);
	scree_events events = events_of(world);
	assert_true(events.visits_ended_count == 1 && events.visits_began_count == 1);
	assert_true(events.visits_ended[0].destroyed_visitor && !events.visits_began[0].destroyed_visitor);
	assert_true(scree_collidable_equals(events.visits_ended[0].visitor, visit.visitor));
	assert_true(scree_body_equals(events.visits_began[0].body_visitor, crate));

	// the crate becomes a sensor, then solid again; then the first sensor is destroyed
	scree_collidable own = events.visits_began[0].visitor;
	OK(scree_collidable_set_sensor(world, own, SCREE_SENSOR_STATIC));
	run_steps(world, 1);
	assert_true(events_of(world).visits_ended_count == 1 &&
	            events_of(world).visits_began_count == 1); // the floor visits the crate, which is now a sensor
	run_steps(world, 5);
	assert_true(position_of(world, crate).y < 0.49f); // the crate falls through the floor
	OK(scree_collidable_set_sensor(world, own, 0));
	run_steps(world, 1);
	assert_true(events_of(world).visits_ended_count == 1 && events_of(world).visits_began_count == 1);
	OK(scree_collidable_destroy(world, sensor));
	run_steps(world, 1);
	assert_true(events_of(world).visits_ended_count == 1 && events_of(world).visits_ended[0].destroyed_sensor);
	run_steps(world, 1);
	assert_true(events_of(world).visits_ended_count == 0 && events_of(world).visits_began_count == 0);
	scree_world_destroy(world);
}

// A body in a sensor is placed outside of the sensor and flies in again within the step. The old visit ends at time 0,
// and a new one begins.
static void placed_elsewhere(void** state)
{
	(void)state;
	scree_world* world = open_world(0.0f);
	scree_collidable sensor = add_sensor(world, box_shape(0.5f, 0.5f), SCREE_SENSOR_MOVING, upright_at(0.0f, 0.0f));
	scree_body ball = add_shape(world, SCREE_BODY_DYNAMIC, circle_shape(0.1f), 0.0f, 0.0f, 0.0f);
	run_steps(world, 1);
	assert_int_equal(visits_of(world, sensor), 1);
	OK(scree_body_set_pose(world, ball, upright_at(-1.1f, 0.0f)));
	OK(scree_body_set_linear_velocity(world, ball, (scree_vec){60.0f, 0.0f}));
	run_steps(world, 1);
	scree_events events = events_of(world);
	assert_true(events.visits_ended_count == 1 && events.visits_began_count == 1 && visits_of(world, sensor) == 1);
	NEAR(events.visits_ended[0].time, 0.0, 0.0);
	NEAR(events.visits_began[0].time, 0.5, 1e-3);
	run_steps(world, 1);
	events = events_of(world);
	assert_true(events.visits_ended_count == 1 && events.visits_began_count == 0);
	NEAR(events.visits_ended[0].time, 0.7, 1e-3);
	scree_world_destroy(world);
}

// The visits of a slow body, 1 mm per step, have times as exact as those of fast bodies.
static void slow_visits(void** state)
{
	(void)state;
	scree_world* world = open_world(0.0f);
	add_sensor(world, box_shape(0.5f, 0.5f), SCREE_SENSOR_MOVING, upright_at(0.0f, 0.0f));
	add_thrown(world, circle_shape(0.125f), -0.62825f, 0.0f, 0.06f, 0.0f); // 3.25 mm in front of the sensor
	for (int k = 0; k < 4; ++k)
	{
		run_steps(world, 1);
		scree_events events = events_of(world);
		assert_int_equal(events.visits_began_count, k == 3);
		if (k == 3)
			NEAR(events.visits_began[0].time, 0.25, 1e-3);
	}
	scree_world_destroy(world);
}

// A sensor reports 300 bodies at one point. A sensor 90 km from the origin reports the end of a visit.
static void crowds_and_distance(void** state)
{
	(void)state;
	scree_world* world = open_world(0.0f);
	for (int k = 0; k < 300; ++k)
		add_crate(world, SCREE_BODY_KINEMATIC, 0.0f, 0.0f);
	scree_collidable here = add_sensor(world, circle_shape(0.2f), SCREE_SENSOR_MOVING, upright_at(0.3f, 0.0f));
	scree_collidable there =
	    add_sensor(world, circle_shape(1.0f), SCREE_SENSOR_MOVING, upright_at(90000.0f, -80000.0f));
	add_thrown(world, circle_shape(0.5f), 89997.0f, -80000.0f, 200.0f, 0.0f);
	run_steps(world, 1);
	assert_int_equal(visits_of(world, here), 300);
	int ended = 0;
	for (int k = 0; k < 5; ++k)
	{
		run_steps(world, 1);
		ended += events_of(world).visits_ended_count;
	}
	assert_true(ended == 1 && visits_of(world, there) == 0);
	scree_world_destroy(world);
}

// ---------------------------------------------------------------------------------------------------------------
// comparison with all pairs, on all devices
// ---------------------------------------------------------------------------------------------------------------

#define HEAP 80

typedef struct // results of a simulation
{
	uint64_t hash; // hash of all events
	int began, open, deep;
} VisitLog;

static scree_body add_random(scree_world* world, uint64_t* seed, bool sensors)
{
	scree_shape shapes[4];
	float r = random_between(seed, 0.1f, 0.5f);
	shapes[0] = circle_shape(r);
	shapes[1] = box_shape(r, 0.5f * r);
	shapes[2] = capsule_shape(r, 0.3f * r);
	scree_vec corners[3] = {{-r, -r}, {r, -r}, {0.0f, r}};
	OK(scree_shape_make_polygon(corners, 3, 0.1f * r, shapes + 3));
	scree_attribute_def surface = surface_of(shapes[random_below(seed, 4)]);
	scree_body_def def = scree_body_def_default();
	def.attribute = add_attribute(world, &surface);
	def.type = random_below(seed, 8) ? SCREE_BODY_DYNAMIC : (scree_body_type)random_below(seed, 2);
	def.pose = (scree_pose){{random_between(seed, -4.0f, 4.0f), random_between(seed, 0.2f, 6.0f)},
	                        scree_rot_make(random_between(seed, -3.0f, 3.0f))};
	def.velocity.linear = (scree_vec){random_between(seed, -9.0f, 9.0f), random_between(seed, -9.0f, 9.0f)};
	uint32_t sees = random_below(seed, 4) ? 0 : 1 + (uint32_t)random_below(seed, 7);
	def.sensor = sensors ? sees : 0;
	return create_body(world, &def);
}

static Exact exact_of(scree_world* world, scree_collidable collidable)
{
	scree_body body;
	scree_attribute attribute;
	scree_attribute_def surface;
	OK(scree_collidable_get_body(world, collidable, &body));
	OK(scree_collidable_get_attribute(world, collidable, &attribute));
	OK(scree_attribute_get_def(world, attribute, &surface));
	scree_pose pose = pose_of(world, body);
	return exact_at(&surface.shape, (double)pose.position.x, (double)pose.position.y, (double)pose.rotation.c,
	                (double)pose.rotation.s);
}

// Compares the visits that each sensor reports with the exact overlaps of all pairs of collidables. Each body has one
// collidable.
static void check_visits(scree_world* world, const scree_body* bodies)
{
	for (int k = 0; k < HEAP; ++k)
	{
		scree_collidable sensor, other;
		scree_visit visits[HEAP];
		uint32_t sees, its;
		int count, one;
		OK(scree_body_get_collidables(world, bodies[k], &sensor, 1, &one));
		OK(scree_collidable_get_sensor(world, sensor, &sees));
		if (!sees || !scree_body_is_enabled(world, bodies[k]))
			continue;
		OK(scree_collidable_get_visits(world, sensor, visits, HEAP, &count));
		Exact a = exact_of(world, sensor);
		for (int i = 0; i < HEAP; ++i)
		{
			if (i == k || !scree_body_is_enabled(world, bodies[i]))
				continue;
			scree_body_type type;
			OK(scree_body_get_collidables(world, bodies[i], &other, 1, &one));
			OK(scree_collidable_get_sensor(world, other, &its));
			OK(scree_body_get_type(world, bodies[i], &type));
			bool wanted = its                         ? sees & SCREE_SENSOR_SENSORS
			              : type == SCREE_BODY_STATIC ? sees & SCREE_SENSOR_STATIC
			                                          : sees & SCREE_SENSOR_MOVING;
			Exact b = exact_of(world, other);
			double apart = exact_distance(&a, &b);
			bool found = false;
			for (int n = 0; n < count; ++n)
				found |= scree_collidable_equals(visits[n].visitor, other);
			if (fabs(apart) > 1e-5 && found != (wanted && apart < 0.0))
				fail_msg("sensor %d and body %d are %g m apart, wanted %d, found %d", k, i, apart, wanted, found);
		}
	}
}

static VisitLog record_heap(const Variant* variant, int steps, bool checks)
{
	VisitLog log = {.hash = HASH_BEGIN};
	scree_world* world = open_default_variant(variant);
	uint64_t seed = 21;
	scree_body bodies[HEAP];
	add_floor(world);
	for (int k = 0; k < HEAP; ++k)
		bodies[k] = add_random(world, &seed, true);
	for (int step = 0; step < steps; ++step)
	{
		OK(scree_world_step(world, step % 40 == 39 ? 0.0f : STEP, SUBSTEPS));
		scree_events events = events_of(world);
		log.hash = hash_bytes(log.hash, events.visits_began, (size_t)events.visits_began_count * sizeof(scree_visit));
		log.hash = hash_bytes(log.hash, events.visits_ended, (size_t)events.visits_ended_count * sizeof(scree_visit));
		log.began += events.visits_began_count;
		log.open += events.visits_began_count - events.visits_ended_count;
		if (checks && step % 10 == 0)
			check_visits(world, bodies);
		int k = random_below(&seed, HEAP);
		scree_collidable own = collidable_of(world, bodies[k]);
		switch (random_below(&seed, 7))
		{
		case 0:
			OK(scree_body_destroy(world, bodies[k]));
			bodies[k] = add_random(world, &seed, true);
			break;
		case 1:
			OK(scree_body_set_enabled(world, bodies[k], random_below(&seed, 2)));
			break;
		case 2:
			OK(scree_collidable_set_sensor(world, own, (uint32_t)random_below(&seed, 8)));
			break;
		case 3:
			OK(scree_body_set_type(world, bodies[k], (scree_body_type)random_below(&seed, 3)));
			break;
		case 4:
			OK(scree_body_set_pose(world, bodies[k], upright_at(random_between(&seed, -4.0f, 4.0f), 3.0f)));
			break;
		case 5:
			OK(scree_body_set_linear_velocity(world, bodies[k],
			                                  (scree_vec){random_between(&seed, -80.0f, 80.0f), 20.0f}));
			break;
		default:
			if (variant->other[0])
				OK(scree_world_move(world, step % 2 ? variant->other : variant->device));
		}
	}
	log.hash ^= hash_of(world);
	OK(scree_bodies_destroy(world, bodies, HEAP));
	run_steps(world, 1);
	log.open -= events_of(world).visits_ended_count;
	assert_int_equal(log.open, 0);
	scree_world_destroy(world);
	return log;
}

static void all_devices_agree(void** state)
{
	(void)state;
	Variant variants[MAX_VARIANTS];
	int count = list_variants(variants), steps = quick() ? 60 : 300;
	VisitLog first = record_heap(variants, steps, true);
	assert_true(first.began > steps / 2);
	for (int k = 1; k < count; ++k)
	{
		VisitLog other = record_heap(variants + k, steps, false);
		if (other.hash != first.hash || other.began != first.began)
			fail_msg("other visits on %s", variants[k].name);
	}
}

// Two worlds differ only in a sensor that covers the whole world: the final positions of their bodies have equal bits.
static void sensors_change_no_motion(void** state)
{
	(void)state;
	scree_vec last[2][HEAP];
	for (int turn = 0; turn < 2; ++turn)
	{
		scree_world* world = open_world(-10.0f);
		uint64_t seed = 5;
		scree_body bodies[HEAP];
		add_floor(world);
		for (int k = 0; k < HEAP; ++k)
			bodies[k] = add_random(world, &seed, false);
		if (turn)
			add_sensor(world, box_shape(20.0f, 20.0f), 7, upright_at(0.0f, 0.0f));
		run_steps(world, 200);
		for (int k = 0; k < HEAP; ++k)
			last[turn][k] = position_of(world, bodies[k]);
		scree_world_destroy(world);
	}
	assert_memory_equal(last[0], last[1], sizeof last[0]);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(bullets_are_seen),
	    cmocka_unit_test(behind_a_wall),
	    cmocka_unit_test(turning_bars),
	    cmocka_unit_test(kinds_and_filters),
	    cmocka_unit_test(one_end_for_each_beginning),
	    cmocka_unit_test(placed_elsewhere),
	    cmocka_unit_test(slow_visits),
	    cmocka_unit_test(crowds_and_distance),
	    cmocka_unit_test(sensors_change_no_motion),
	    cmocka_unit_test(all_devices_agree),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
