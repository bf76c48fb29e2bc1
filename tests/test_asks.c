// SPDX-License-Identifier: MIT
// test_asks.c -- checks contact approval: contacts are approved, refused or not answered, and no body passes another
// while their contact is pending.
#include "support/make_bodies.h"
#include <math.h>
#include <string.h>

static scree_body put(scree_world* world, scree_body_type type, float x, float y, float vx, float vy, uint32_t reports)
{
	scree_body_def def = crate_def(world, type, x, y);
	def.velocity.linear = (scree_vec){vx, vy};
	def.reports = reports;
	return create_body(world, &def);
}

// Takes steps. answer: true approves all contacts that become pending, false refuses them. Returns the number of these
// contacts.
static int step_answering(scree_world* world, int steps, bool answer)
{
	int asked = 0;
	for (int k = 0; k < steps; ++k)
	{
		run_steps(world, 1);
		scree_events events = events_of(world);
		bool answers[64];
		assert_true(events.approval_count <= 64);
		for (int i = 0; i < events.approval_count; ++i)
			answers[i] = answer;
		OK(scree_world_approve_contacts(world, answers, events.approval_count));
		asked += events.approval_count;
	}
	return asked;
}

// A box falls on a floor with contact approval. If its contact is approved, the box lies on the floor and the touch
// begins once. If it is refused, the box falls through the floor and keeps its speed.
static void yes_and_no(void** state)
{
	(void)state;
	for (int answer = 0; answer < 2; ++answer)
	{
		scree_world* world = open_test_world(-10.0f);
		put(world, SCREE_BODY_STATIC, 0.0f, 0.0f, 0.0f, 0.0f, SCREE_REPORT_APPROVAL);
		scree_body box = put(world, SCREE_BODY_DYNAMIC, 0.2f, 2.0f, 0.0f, 0.0f, SCREE_REPORT_TOUCHES);
		int began = 0, ended = 0, asked = 0;
		for (int k = 0; k < 120; ++k)
		{
			asked += step_answering(world, 1, answer);
			scree_events events = events_of(world);
			began += events.touches_began_count;
			ended += events.touches_ended_count;
			if (events.approval_count)
			{
				assert_true(events.approvals[0].body_a.index == box.index && events.approvals[0].count > 0);
				assert_int_equal(contacts_of(world), 0);
			}
		}
		assert_int_equal(asked, 1);
		assert_int_equal(began, answer);
		assert_int_equal(ended, 0);
		if (answer)
			NEAR(pose_of(world, box).position.y, 1.0, 0.01);
		else
			NEAR(velocity_of(world, box).linear.y, -20.0, 0.02);
		scree_world_destroy(world);
	}
}

// A contact without an answer counts as refused until its two bodies have parted. When they meet again, the contact is
// pending again. An approval also lasts until the bodies part.
static void asked_again(void** state)
{
	(void)state;
	scree_world* world = open_test_world(0.0f);
	put(world, SCREE_BODY_STATIC, 0.0f, 0.0f, 0.0f, 0.0f, 0);
	scree_body box = put(world, SCREE_BODY_DYNAMIC, 0.0f, 1.5f, 0.0f, -3.0f, SCREE_REPORT_APPROVAL);
	int asked = 0;
	for (int k = 0; k < 60; ++k)
	{
		run_steps(world, 1);
		asked += events_of(world).approval_count;
	}
	assert_int_equal(asked, 1);
	assert_true(pose_of(world, box).position.y < -1.2f);
	OK(scree_body_set_linear_velocity(world, box, (scree_vec){0.0f, 3.0f}));
	assert_int_equal(step_answering(world, 60, true), 1);
	assert_true(pose_of(world, box).position.y < -0.9f);
	OK(scree_body_set_linear_velocity(world, box, (scree_vec){0.0f, -1.0f}));
	step_answering(world, 10, true);
	OK(scree_body_set_linear_velocity(world, box, (scree_vec){0.0f, 1.0f}));
	assert_int_equal(step_answering(world, 60, true), 1);
	scree_world_destroy(world);
}

// A body hits a static, kinematic or dynamic body at 5 to 400 m/s. It does not pass that body while the contact is
// pending. After an approval it is stopped; after a refusal it continues at the same speed.
static void fast(void** state)
{
	(void)state;
	static const float speeds[] = {5.0f, 60.0f, 200.0f, 399.0f};
	int starts = strcmp(test_device, "cpu") == 0 ? 5 : 1; // PoCL takes 0.3 s to open a world
	for (int k = 0; k < 4 * 3 * 2 * starts; ++k)
	{
		bool answer = k % 2;
		scree_body_type type = (scree_body_type)(k / 2 % 3);
		float speed = speeds[k / 6 % 4], start = -3.0f - 0.37f * (float)(k / 24);
		scree_world* world = open_test_world(0.0f);
		scree_body wall = put(world, type, 0.0f, 0.0f, 0.0f, 0.0f, k % 3 ? SCREE_REPORT_APPROVAL : 0);
		scree_body bullet = put(world, SCREE_BODY_DYNAMIC, start, 0.0f, speed, 0.0f, k % 3 ? 0 : SCREE_REPORT_APPROVAL);
		int asked = 0;
		for (int n = 0; n < 200 && !asked; ++n)
		{
			asked = step_answering(world, 1, answer);
			if (asked)
			{
				NEAR(pose_of(world, bullet).position.x, -1.0, 0.021);
				assert_true(velocity_of(world, bullet).linear.x == speed);
			}
		}
		assert_int_equal(asked, 1);
		assert_int_equal(step_answering(world, 60, answer), 0);
		float apart = pose_of(world, bullet).position.x - pose_of(world, wall).position.x;
		if (answer)
			assert_true(apart < -0.98f);
		else
		{
			assert_true(apart > 1.0f && velocity_of(world, bullet).linear.x == speed);
			assert_true(velocity_of(world, wall).linear.x == 0.0f);
		}
		scree_world_destroy(world);
	}
}

// Bodies that already touch when SCREE_REPORT_APPROVAL is set keep touching until they part; their contact does not
// become pending. When this flag is cleared, the bodies of a refused contact collide again.
static void marked_in_mid_run(void** state)
{
	(void)state;
	scree_world* world = open_test_world(-10.0f);
	add_floor(world);
	scree_body low = put(world, SCREE_BODY_DYNAMIC, 0.0f, 0.5f, 0.0f, 0.0f, 0);
	run_steps(world, 30);
	OK(scree_collidable_set_reports(world, collidable_of(world, low), SCREE_REPORT_APPROVAL));
	assert_int_equal(step_answering(world, 60, false), 0);
	NEAR(pose_of(world, low).position.y, 0.5, 0.01);
	scree_body high = put(world, SCREE_BODY_DYNAMIC, 0.1f, 1.6f, 0.0f, 0.0f, 0);
	assert_int_equal(step_answering(world, 60, false), 1);
	NEAR(pose_of(world, high).position.y, 0.5, 0.01);
	OK(scree_collidable_set_reports(world, collidable_of(world, low), 0));
	run_steps(world, 120);
	assert_true(fabsf(pose_of(world, low).position.x - pose_of(world, high).position.x) > 0.9f ||
	            fabsf(pose_of(world, low).position.y - pose_of(world, high).position.y) > 0.9f);
	scree_world_destroy(world);
}

// Checks changes while a contact is pending. First the body of an approved contact is destroyed, and another body takes
// its slot, so a new contact is pending. Then the world moves to another device. The first contact begins in a step of
// 0 s.
static void between(void** state)
{
	(void)state;
	scree_world* world = open_test_world(0.0f);
	put(world, SCREE_BODY_STATIC, 0.0f, 0.0f, 0.0f, 0.0f, SCREE_REPORT_APPROVAL);
	scree_body box = put(world, SCREE_BODY_DYNAMIC, 0.0f, 1.005f, 0.0f, 0.0f, 0);
	bool yes[2] = {true, true};
	OK(scree_world_step(world, 0.0f, 4));
	assert_int_equal(events_of(world).approval_count, 1);
	uint64_t before = hash_of(world);
	OK(scree_world_approve_contacts(world, yes, 1));
	assert_true(hash_of(world) != before);
	OK(scree_body_destroy(world, box));
	scree_body again = put(world, SCREE_BODY_DYNAMIC, 0.0f, 1.005f, 0.0f, -1.0f, 0);
	assert_int_equal(again.index, box.index);
	run_steps(world, 1);
	assert_int_equal(events_of(world).approval_count, 1); // the approval was for the destroyed body
	OK(scree_world_approve_contacts(world, yes, 1));
	OK(scree_world_move(world, "cpu"));
	run_steps(world, 30);
	assert_true(pose_of(world, again).position.y > 0.98f);
	assert_int_equal(events_of(world).approval_count, 0);
	assert_int_equal(scree_world_approve_contacts(world, yes, 2), SCREE_ERROR_INVALID);
	assert_non_null(strstr(scree_error(), "count is 2, and 0 contacts wait for approval"));
	assert_int_equal(scree_world_approve_contacts(world, NULL, 1), SCREE_ERROR_INVALID);
	scree_world_destroy(world);
}

static void answer_one(scree_world* world, bool yes)
{
	assert_int_equal(events_of(world).approval_count, 1);
	OK(scree_world_approve_contacts(world, &yes, 1));
}

// Each step of 0 s reports a contact that is pending. After the contact is approved or refused, a step of 0 s does not
// change this answer.
static void steps_of_no_time(void** state)
{
	(void)state;
	for (int k = 0; k < 8; ++k)
	{
		bool answers = k & 1, yes = k & 2, early = k & 4;
		scree_world* world = open_test_world(-10.0f);
		put(world, SCREE_BODY_STATIC, 0.0f, 0.0f, 0.0f, 0.0f, SCREE_REPORT_APPROVAL);
		scree_body box = put(world, SCREE_BODY_DYNAMIC, 0.0f, 1.3f, 0.0f, 0.0f, 0);
		do
			run_steps(world, 1);
		while (events_of(world).approval_count == 0);
		uint64_t open = hash_of(world);
		for (int n = 0; n < 3 && !early; ++n)
			update_contacts(world);
		assert_int_equal(events_of(world).approval_count, 1);
		if (answers)
		{
			answer_one(world, yes);
			assert_true(hash_of(world) != open);
		}
		update_contacts(world);
		assert_int_equal(events_of(world).approval_count, !answers);
		assert_int_equal(contacts_of(world), answers && yes);
		run_steps(world, 60);
		assert_true((pose_of(world, box).position.y > 0.98f) == (answers && yes));
		scree_world_destroy(world);
	}
}

// After a step that fails, no contact is listed as pending. The next step lists the contact that was pending, and no
// body has passed another.
static void a_step_that_fails(void** state)
{
	(void)state;
	scree_world_def def = scree_world_def_default();
	def.device = test_device;
	def.threads = 2;
	def.contact_limit = 100;
	scree_world* world = create_world(&def);
	put(world, SCREE_BODY_STATIC, 0.0f, 0.0f, 0.0f, 0.0f, SCREE_REPORT_APPROVAL);
	scree_body box = put(world, SCREE_BODY_DYNAMIC, 0.0f, 1.3f, 0.0f, 0.0f, 0), crowd[40];
	do
		run_steps(world, 1);
	while (events_of(world).approval_count == 0);
	for (int k = 0; k < 40; ++k)
		crowd[k] = put(world, SCREE_BODY_DYNAMIC, 20.0f, 20.0f, 0.0f, 0.0f, 0);
	assert_int_equal(scree_world_step(world, STEP, 4), SCREE_ERROR_CONTACT_LIMIT);
	assert_int_equal(events_of(world).approval_count, 0);
	OK(scree_bodies_destroy(world, crowd, 40));
	run_steps(world, 1);
	assert_true(pose_of(world, box).position.y > 0.97f);
	answer_one(world, true);
	run_steps(world, 60);
	NEAR(pose_of(world, box).position.y, 1.0, 0.01);
	scree_world_destroy(world);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(yes_and_no),        cmocka_unit_test(asked_again), cmocka_unit_test(fast),
	    cmocka_unit_test(marked_in_mid_run), cmocka_unit_test(between),     cmocka_unit_test(steps_of_no_time),
	    cmocka_unit_test(a_step_that_fails),
	};
	return RUN_ON_DEVICES(tests);
}
