// SPDX-License-Identifier: MIT
// test_sleep.c -- checks that islands at rest fall asleep, keep their bits, stay readable, and wake by contacts.
//
// Formula: an island sleeps after 0.5 s = 30 steps in which no point of it moved more than 0.05 m/s / 60 per step, in
// the next step that searches islands; from then on its state has the same bits until something wakes it.
#include "support/make_sleepers.h"
#include <math.h>
#include <string.h>

// Returns whether a body of the stack moved more in the last step than a body at rest may.
static bool moved(scree_world* world, const scree_body* bodies, scree_pose poses[STACK])
{
	bool found = false;
	for (int k = 0; k < STACK; ++k)
	{
		scree_pose now = pose_of(world, bodies[k]);
		double x = now.position.x - poses[k].position.x, y = now.position.y - poses[k].position.y;
		double turn = now.rotation.s * poses[k].rotation.c - now.rotation.c * poses[k].rotation.s;
		found |= fabs(x) + fabs(y) + fabs(turn) * sqrt(0.5) > 0.05 * STEP;
		poses[k] = now;
	}
	return found;
}

static void a_stack_falls_asleep(void** state)
{
	(void)state;
	scree_world* world = open_sleepers(-10.0f);
	scree_body bodies[STACK];
	scree_pose poses[STACK];
	add_stack(world, 0.0f, bodies);
	for (int k = 0; k < STACK; ++k)
		poses[k] = pose_of(world, bodies[k]);
	int step = 0, last = 0;
	for (; is_awake(world, bodies[0]) && step < 200; ++step)
	{
		expect_awake(world, bodies, STACK, true); // all of them, or none
		run_steps(world, 1);
		last = moved(world, bodies, poses) ? step + 1 : last;
	}
	expect_awake(world, bodies, STACK, false);
	assert_in_range(step - last, REST_STEPS, MOST_STEPS);
	assert_true(last <= 10);
	assert_int_equal(counters_of(world).asleep_bodies, STACK);
	for (int k = 0; k < STACK; ++k)
		expect_velocity(world, bodies[k], 0, 0, 0);

	// nothing changes for 10 s
	uint64_t hash = hash_of(world);
	for (int k = 0; k < STACK; ++k)
		poses[k] = pose_of(world, bodies[k]);
	run_steps(world, 600);
	assert_true(hash_of(world) == hash);
	for (int k = 0; k < STACK; ++k)
		expect_pose(world, bodies[k], poses[k]);
	close_sleepers(world);
}

// Reads all contacts of a world, at most 32.
static int contacts_in(scree_world* world, scree_contact contacts[32])
{
	int count;
	OK(scree_world_get_contacts(world, contacts, 32, &count));
	return count;
}

static void sleepers_stay_readable(void** state)
{
	(void)state;
	scree_world* world = open_sleepers(-10.0f);
	scree_body bodies[STACK];
	scree_contact contacts[32], later[32], own[8];
	add_stack(world, 0.0f, bodies);
	run_to_sleep(world, bodies, STACK);
	run_steps(world, 50);
	assert_int_equal(contacts_in(world, contacts), STACK);
	assert_int_equal(counters_of(world).touching, STACK);

	// the contact below crate k carries the crates from k on: an impulse of m g h per substep
	for (int k = 0; k < STACK; ++k)
	{
		int count;
		OK(scree_body_get_contacts(world, bodies[k], own, 8, &count));
		assert_int_equal(count, k == STACK - 1 ? 1 : 2);
		double carried = 0.0;
		for (int i = 0; i < STACK; ++i)
			if (scree_body_equals(contacts[i].body_a, bodies[k])
			        ? contacts[i].normal.y < 0.0f
			        : scree_body_equals(contacts[i].body_b, bodies[k]) && contacts[i].normal.y > 0.0f)
				carried += contacts[i].points[0].normal_impulse + contacts[i].points[1].normal_impulse;
		NEAR(carried, (STACK - k) * G * H, 0.02 * STACK * G * H);
	}
	run_steps(world, 100);
	assert_int_equal(contacts_in(world, later), STACK);
	assert_memory_equal(contacts, later, STACK * sizeof contacts[0]);

	scree_body_state states[STACK + 1];
	scree_body_def def;
	int count;
	OK(scree_world_get_states(world, NULL, states, STACK + 1, &count));
	for (int k = 0; k < count; ++k)
		assert_int_equal(states[k].asleep, k > 0);
	OK(scree_body_get_def(world, bodies[1], &def));
	assert_true(def.asleep && !def.stays_awake && def.sleep_threshold == 0.0f);

	// a ray from above hits the top of the upper crate
	scree_query_result hit;
	OK(scree_world_cast_ray(world, (scree_vec){0.0f, 10.0f}, (scree_vec){0.0f, -20.0f}, &hit));
	assert_true(hit.hit && hit.collidable.index == collidable_of(world, bodies[STACK - 1]).index);
	NEAR(hit.point.y, STACK, 0.02);
	expect_awake(world, bodies, STACK, false);
	close_sleepers(world);
}

static void visits_and_touches_last(void** state)
{
	(void)state;
	scree_world* world = open_sleepers(-10.0f);
	scree_body body = add_reporter(world, box_shape(0.5f, 0.5f), SCREE_REPORT_TOUCHES, 0.0f, 0.5f);
	scree_collidable_def def = scree_collidable_def_default();
	def.attribute = box_attribute(world, 2.0f, 2.0f);
	def.sensor = SCREE_SENSOR_MOVING;
	scree_collidable sensor = create_collidable(world, &def);
	run_steps(world, 1);
	assert_int_equal(events_of(world).visits_began_count, 1);
	assert_int_equal(events_of(world).touches_began_count, 1);
	for (int k = 0; k < 200; ++k)
	{
		run_steps(world, 1);
		scree_events events = events_of(world);
		assert_int_equal(events.visits_ended_count + events.touches_ended_count, 0);
		assert_int_equal(events.visits_began_count + events.touches_began_count, 0);
	}
	assert_false(is_awake(world, body));
	scree_visit visit;
	int count;
	OK(scree_collidable_get_visits(world, sensor, &visit, 1, &count));
	assert_int_equal(count, 1);
	assert_int_equal(visit.visitor.index, collidable_of(world, body).index);

	// the end of both is listed when the body leaves
	OK(scree_body_set_pose(world, body, upright_at(0.0f, 50.0f)));
	run_steps(world, 1);
	assert_int_equal(events_of(world).visits_ended_count, 1);
	assert_int_equal(events_of(world).touches_ended_count, 1);
	close_sleepers(world);
}

static void a_touch_wakes_the_island_in_its_step(void** state)
{
	(void)state;
	scree_world* world = open_sleepers(-10.0f);
	scree_body hit[STACK], other[STACK];
	add_stack(world, 0.0f, hit);
	add_stack(world, 10.0f, other);
	run_to_sleep(world, hit, STACK);
	run_to_sleep(world, other, STACK);
	scree_pose poses[STACK];
	for (int k = 0; k < STACK; ++k)
		poses[k] = pose_of(world, other[k]);
	scree_body ball = add_disc(world, 0.5f, 0.0f, STACK + 2.0f);
	int step = 0;
	while (contacts_with(world, ball) == 0)
	{
		expect_awake(world, hit, STACK, false);
		assert_true(++step < 60);
		run_steps(world, 1);
	}
	expect_awake(world, hit, STACK, true);
	scree_contact contacts[32];
	int count = contacts_in(world, contacts), solved = 0;
	for (int k = 0; k < count; ++k)
		solved += contacts[k].color >= 0;
	assert_int_equal(count, 2 * STACK + 1);
	assert_int_equal(solved, STACK + 1); // contacts of sleepers have no color
	double deepest = deepest_of(world, 20);
	assert_true(deepest < 0.02);
	for (int k = 0; k < STACK; ++k)
		expect_pose(world, other[k], poses[k]);
	expect_awake(world, other, STACK, false);
	close_sleepers(world);
}

// A plank that falls flat on two stacks wakes both in the same step. All three then fall asleep together.
static void one_body_wakes_two_islands(void** state)
{
	(void)state;
	scree_world* world = open_sleepers(-10.0f);
	scree_body bodies[2 * STACK + 1];
	add_stack(world, -5.0f, bodies);
	add_stack(world, 5.0f, bodies + STACK);
	run_to_sleep(world, bodies, 2 * STACK);
	scree_body plank = bodies[2 * STACK] = add_box(world, SCREE_BODY_DYNAMIC, 6.0f, 0.25f, 0.0f, STACK + 1.0f);
	while (contacts_with(world, plank) == 0)
	{
		expect_awake(world, bodies, 2 * STACK, false);
		run_steps(world, 1);
	}
	assert_int_equal(contacts_with(world, plank), 2);
	expect_awake(world, bodies, 2 * STACK + 1, true);
	run_to_sleep(world, bodies, 2 * STACK + 1);

	// the plank has joined the two stacks to one island
	OK(scree_body_set_awake(world, bodies[0], true));
	expect_awake(world, bodies, 2 * STACK + 1, true);
	close_sleepers(world);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(a_stack_falls_asleep),       cmocka_unit_test(sleepers_stay_readable),
	    cmocka_unit_test(visits_and_touches_last),    cmocka_unit_test(a_touch_wakes_the_island_in_its_step),
	    cmocka_unit_test(one_body_wakes_two_islands),
	};
	return RUN_SLEEPERS(tests);
}
