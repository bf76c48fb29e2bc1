// SPDX-License-Identifier: MIT
// test_events.c -- checks touches and hits: their contents, that each touch that begins also ends once, and that all
// devices list the same events.
#include "support/make_joints.h"
#include "support/variants.h"
#include "tools/common/byte_hash.h"
#include "tools/common/random_numbers.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define ALL (SCREE_REPORT_TOUCHES | SCREE_REPORT_HITS)

static int moved_of(scree_world* world, scree_body* first)
{
	scree_moved_bodies list;
	OK(scree_world_get_moved_bodies(world, &list));
	for (int k = 1; k < list.count; ++k)
		assert_true(list.bodies[k - 1].body.index < list.bodies[k].body.index);
	*first = list.count > 0 ? list.bodies[0].body : SCREE_NULL_BODY;
	for (int k = 0; k < list.count; ++k)
	{
		scree_pose pose = pose_of(world, list.bodies[k].body);
		scree_velocity velocity = velocity_of(world, list.bodies[k].body);
		assert_memory_equal(&pose, &list.bodies[k].pose, sizeof pose);
		assert_memory_equal(&velocity, &list.bodies[k].velocity, sizeof velocity);
	}
	return list.count;
}

// ---------------------------------------------------------------------------------------------------------------
// the contents of events
// ---------------------------------------------------------------------------------------------------------------

// A ball falls, and is at rest ten seconds later. Then it is moved away. There are one begin and one end of a touch,
// and one hit.
static void a_ball_lands(void** state)
{
	(void)state;
	scree_world* world = open_world(-10.0f);
	add_floor(world);
	scree_body ball = add_reporter(world, circle_shape(0.5f), ALL, 3.0f, 2.0f);
	scree_collidable own = collidable_of(world, ball);
	OK(scree_collidable_set_user(world, own, 77));
	int began = 0, ended = 0, hits = 0;
	for (int k = 0; k < 600; ++k)
	{
		float speed = velocity_of(world, ball).linear.y;
		run_steps(world, 1);
		scree_events events = events_of(world);
		ended += events.touches_ended_count;
		for (int i = 0; i < events.touches_began_count; ++i, ++began)
		{
			const scree_contact* c = events.touches_began + i;
			assert_true(scree_collidable_equals(c->a, own) && c->user_a == 77 && c->body_a.index == ball.index);
			assert_true(!c->destroyed_a && !c->destroyed_b && c->count == 1);
			NEAR(c->normal.y, -1.0, 1e-4);
			NEAR(c->points[0].point.x, 3.0, 1e-3);
			NEAR(c->details[0].approach_speed, -speed, 0.3);
		}
		for (int i = 0; i < events.hit_count; ++i, ++hits)
		{
			const scree_hit* hit = events.hits + i;
			assert_true(scree_collidable_equals(hit->a, own) && hit->user_a == 77);
			NEAR(hit->approach_speed, sqrt(2.0 * 10.0 * 1.5), 0.2);
			NEAR(hit->point.y, 0.0, 0.1);
		}
	}
	assert_true(began == 1 && ended == 0 && hits == 1);
	OK(scree_body_set_pose(world, ball, (scree_pose){{3.0f, 9.0f}, {1.0f, 0.0f}}));
	assert_int_equal(events_of(world).touches_ended_count, 0);
	run_steps(world, 1);
	scree_events events = events_of(world);
	assert_true(events.touches_ended_count == 1 && scree_collidable_equals(events.touches_ended[0].a, own));
	assert_true(!events.touches_ended[0].destroyed_a && events.touches_ended[0].user_a == 77);
	run_steps(world, 1);
	assert_int_equal(events_of(world).touches_ended_count, 0);
	scree_world_destroy(world);
}

// Events contain the handle of a destroyed collidable and mark it as destroyed, although a new collidable has taken its
// slot.
static void the_destroyed_are_named(void** state)
{
	(void)state;
	scree_world* world = open_world(-10.0f);
	add_floor(world);
	scree_body ball = add_reporter(world, circle_shape(0.5f), ALL, 3.0f, 0.5f);
	scree_collidable own = collidable_of(world, ball);
	OK(scree_collidable_set_user(world, own, 5));
	int began = 0;
	for (int k = 0; k < 5 && began == 0; ++k)
	{
		run_steps(world, 1);
		began = events_of(world).touches_began_count;
	}
	assert_int_equal(began, 1);

	// the events of the step before the destruction
	OK(scree_body_destroy(world, ball));
	scree_body other = add_reporter(world, circle_shape(0.4f), ALL, 3.0f, 0.4f);
	scree_collidable heir = collidable_of(world, other);
	assert_true(heir.index == own.index && !scree_collidable_equals(heir, own));
	scree_events events = events_of(world);
	assert_true(events.touches_began_count == 1 && events.touches_began[0].destroyed_a);
	assert_true(scree_collidable_equals(events.touches_began[0].a, own) && events.touches_began[0].user_a == 5);
	assert_true(scree_body_equals(events.touches_began[0].body_a, ball) && !events.touches_began[0].destroyed_b);

	// five more steps: in the first, the touch of the destroyed ball ends, and the touch of the new body begins; after
	// this step the new body is destroyed, so its touch ends in the second
	int heirs = 0;
	for (int k = 0; k < 5; ++k)
	{
		run_steps(world, 1);
		if (k == 0)
			OK(scree_body_destroy(world, other));
		events = events_of(world);
		assert_int_equal(events.touches_ended_count, k == 0 || (k == 1 && heirs == 1));
		for (int i = 0; i < events.touches_began_count; ++i, ++heirs)
			assert_true(scree_collidable_equals(events.touches_began[i].a, heir) &&
			            events.touches_began[i].destroyed_a);
		if (events.touches_ended_count == 1)
			assert_true(events.touches_ended[0].destroyed_a &&
			            scree_collidable_equals(events.touches_ended[0].a, k == 0 ? own : heir));
	}
	scree_world_destroy(world);
}

// Events contain the handle of a destroyed collidable even if its shape was changed just before the destruction, which
// restarted its contacts.
static void the_changed_and_destroyed_are_named(void** state)
{
	(void)state;
	scree_world* world = open_world(-10.0f);
	add_floor(world);
	scree_body ball = add_reporter(world, circle_shape(0.5f), ALL, 3.0f, 0.5f);
	scree_collidable own = collidable_of(world, ball);
	run_steps(world, 5);
	OK(scree_collidable_set_attribute(world, own, shape_attribute(world, circle_shape(0.6f))));
	OK(scree_body_destroy(world, ball));
	run_steps(world, 1);
	scree_events events = events_of(world);
	assert_true(events.touches_ended_count == 1 && events.touches_ended[0].destroyed_a == 1);
	assert_true(scree_collidable_equals(events.touches_ended[0].a, own));
	scree_world_destroy(world);
}

// Bodies move in the same way with and without reports.
static void events_change_no_motion(void** state)
{
	(void)state;
	enum
	{
		BODIES = 40,
		STEPS = 200
	};
	scree_pose poses[2][BODIES];
	scree_velocity velocities[2][BODIES];
	for (int reports = 0; reports < 2; ++reports)
	{
		scree_world* world = open_world(-10.0f);
		scree_body bodies[BODIES];
		uint64_t seed = 3;
		add_floor(world);
		for (int k = 0; k < BODIES; ++k)
			bodies[k] = add_reporter(world, k % 2 ? circle_shape(0.4f) : box_shape(0.5f, 0.3f), reports ? ALL : 0,
			                         random_between(&seed, -2.0f, 2.0f), 1.0f + (float)k);
		run_steps(world, STEPS);
		OK(scree_bodies_get_poses(world, bodies, poses[reports], BODIES));
		OK(scree_bodies_get_velocities(world, bodies, velocities[reports], BODIES));
		scree_world_destroy(world);
	}
	assert_memory_equal(poses[0], poses[1], sizeof poses[0]);
	assert_memory_equal(velocities[0], velocities[1], sizeof velocities[0]);
}

// Each bullet hits one wall once, with an impulse equal to the momentum of the bullet.
static void bullets_hit(void** state)
{
	(void)state;
	enum
	{
		BULLETS = 200
	};
	scree_world* world = open_world(0.0f);
	int hits = 0;
	for (int k = 0; k < BULLETS; ++k)
	{
		add_box(world, SCREE_BODY_STATIC, 0.3f, 1.0f, 20.0f + 0.37f * (float)k, 4.0f * (float)k);
		scree_body bullet = add_reporter(world, circle_shape(0.1f), SCREE_REPORT_HITS, 0.0f, 4.0f * (float)k);
		throw_body(world, bullet, 60.0f + 0.5f * (float)k, 0.0f, 0.0f);
	}
	for (int k = 0; k < 120; ++k)
	{
		run_steps(world, 1);
		scree_events events = events_of(world);
		assert_true(events.touches_began_count == 0 && events.touches_ended_count == 0);
		for (int i = 0; i < events.hit_count; ++i, ++hits)
		{
			const scree_hit* hit = events.hits + i;
			scree_mass mass = mass_of(world, hit->body_a);
			NEAR(hit->impulse, mass.mass * hit->approach_speed, 0.01 * mass.mass * hit->approach_speed);
			assert_true(hit->approach_speed > 59.0f);
			NEAR(fabs(hit->normal.x), 1.0, 1e-3);
		}
	}
	assert_int_equal(hits, BULLETS);
	scree_world_destroy(world);
}

// Reports may be switched on and off while two collidables touch.
static void reports_change(void** state)
{
	(void)state;
	scree_world* world = open_world(-10.0f);
	add_floor(world);
	scree_body ball = add_reporter(world, circle_shape(0.5f), 0, 0.0f, 0.5f);
	scree_collidable own = collidable_of(world, ball);
	uint32_t reports;
	run_steps(world, 30);
	assert_int_equal(events_of(world).touches_began_count, 0);
	OK(scree_collidable_set_reports(world, own, SCREE_REPORT_TOUCHES));
	OK(scree_collidable_get_reports(world, own, &reports));
	assert_int_equal(reports, SCREE_REPORT_TOUCHES);
	run_steps(world, 1);
	assert_int_equal(events_of(world).touches_began_count, 1);

	// reports are off, but the end of a touch that has been reported is still reported
	OK(scree_collidable_set_reports(world, own, 0));
	run_steps(world, 30);
	assert_int_equal(events_of(world).touches_ended_count, 0);
	OK(scree_body_set_pose(world, ball, (scree_pose){{0.0f, 9.0f}, {1.0f, 0.0f}}));
	run_steps(world, 1);
	assert_int_equal(events_of(world).touches_ended_count, 1);
	scree_world_destroy(world);
}

// ---------------------------------------------------------------------------------------------------------------
// every touch that begins ends, and all devices agree
// ---------------------------------------------------------------------------------------------------------------

#define MOST_OPEN 4096

typedef struct // touches that have begun and not ended, and a hash of all events
{
	scree_collidable a[MOST_OPEN], b[MOST_OPEN];
	int count, began, hits;
	uint64_t stream;
} Ledger;

static void mix(Ledger* ledger, const void* bytes, size_t size)
{
	ledger->stream = hash_bytes(ledger->stream, bytes, size);
}

static int find(const Ledger* ledger, const scree_contact* c)
{
	for (int k = 0; k < ledger->count; ++k)
		if (scree_collidable_equals(ledger->a[k], c->a) && scree_collidable_equals(ledger->b[k], c->b))
			return k;
	return -1;
}

static void note(Ledger* ledger, const scree_events* events)
{
	for (int k = 0; k < events->touches_ended_count; ++k)
	{
		const scree_contact* c = events->touches_ended + k;
		int at = find(ledger, c);
		assert_true(at >= 0);
		ledger->a[at] = ledger->a[--ledger->count];
		ledger->b[at] = ledger->b[ledger->count];
		mix(ledger, &c->a, sizeof c->a);
		mix(ledger, &c->b, sizeof c->b);
	}
	for (int k = 0; k < events->touches_began_count; ++k)
	{
		const scree_contact* c = events->touches_began + k;
		assert_true(find(ledger, c) < 0 && ledger->count < MOST_OPEN);
		ledger->a[ledger->count] = c->a;
		ledger->b[ledger->count++] = c->b;
		mix(ledger, &c->a, sizeof c->a);
		mix(ledger, &c->b, sizeof c->b);
		mix(ledger, c->points, sizeof c->points);
		mix(ledger, c->details, sizeof c->details);
	}
	for (int k = 0; k < events->hit_count; ++k)
	{
		const scree_hit* hit = events->hits + k;
		mix(ledger, &hit->a, sizeof hit->a);
		mix(ledger, &hit->impulse, sizeof hit->impulse);
		mix(ledger, &hit->point, sizeof hit->point);
	}
	ledger->began += events->touches_began_count;
	ledger->hits += events->hit_count;
}

// Checks that each open touch is in the list of contacts. Also checks that a contact is an open touch if it has an
// impulse and at least one of its collidables reports touches.
static void compare(scree_world* world, const Ledger* ledger)
{
	static scree_contact contacts[MOST_OPEN];
	int count, open = 0;
	OK(scree_world_get_contacts(world, contacts, MOST_OPEN, &count));
	for (int k = 0; k < count; ++k)
	{
		bool is_open = find(ledger, contacts + k) >= 0;
		open += is_open;
		uint32_t a, b;
		OK(scree_collidable_get_reports(world, contacts[k].a, &a));
		OK(scree_collidable_get_reports(world, contacts[k].b, &b));
		if (((a | b) & SCREE_REPORT_TOUCHES) &&
		    contacts[k].details[0].total_impulse + contacts[k].details[1].total_impulse > 0.0f)
			assert_true(is_open);
	}
	assert_int_equal(open, ledger->count);
}

static scree_body add_random(scree_world* world, uint64_t* seed)
{
	float x = random_between(seed, -8.0f, 8.0f), y = random_between(seed, 1.0f, 12.0f);
	scree_shape shape = random_below(seed, 2) ? circle_shape(random_between(seed, 0.2f, 0.6f))
	                                          : box_shape(random_between(seed, 0.2f, 0.6f), 0.3f);
	return add_reporter(world, shape, ALL, x, y);
}

#define HEAP 60

// Makes a random change of one body of a heap: replaces, moves, disables, enables or joins the body, or changes its
// filter, reports or type.
static void churn(scree_world* world, scree_body bodies[HEAP], int step, uint64_t* seed)
{
	int k = random_below(seed, HEAP);
	scree_collidable own = collidable_of(world, bodies[k]);
	switch (random_below(seed, 8))
	{
	case 0:
	case 1:
		OK(scree_body_destroy(world, bodies[k]));
		bodies[k] = add_random(world, seed);
		break;
	case 2:
		OK(scree_body_set_pose(world, bodies[k],
		                       (scree_pose){{random_between(seed, -8.0f, 8.0f), 9.0f}, {1.0f, 0.0f}}));
		break;
	case 3:
		OK(scree_body_set_enabled(world, bodies[k], random_below(seed, 2)));
		break;
	case 4:
		OK(scree_collidable_set_filter(
		    world, own, (scree_filter){.category = 1, .mask = UINT64_MAX, .group = -random_below(seed, 2)}));
		break;
	case 5:
		OK(scree_collidable_set_reports(world, own, (uint32_t)random_below(seed, 4)));
		break;
	case 6:
		OK(scree_body_set_type(world, bodies[k], step % 3 ? SCREE_BODY_DYNAMIC : SCREE_BODY_STATIC));
		break;
	default:
	{
		scree_joint_def def = scree_joint_def_make(SCREE_JOINT_FILTER);
		def.body_a = bodies[k];
		def.body_b = bodies[(k + 1) % HEAP];
		OK(scree_joint_create(world, &def, NULL));
	}
	}
}

static Ledger record_heap(const Variant* variant, int steps)
{
	Ledger ledger = {.stream = HASH_BEGIN};
	scree_world_def def = scree_world_def_default();
	def.contact_details = true;
	scree_world* world = open_variant(variant, &def);
	scree_body bodies[HEAP];
	uint64_t seed = 11;
	add_floor(world);
	for (int k = 0; k < HEAP; ++k)
		bodies[k] = add_random(world, &seed);
	for (int k = 0; k < steps; ++k)
	{
		OK(scree_world_step(world, k % 50 == 49 ? 0.0f : STEP, SUBSTEPS));
		bool early = random_below(&seed, 2);
		if (early)
		{
			scree_events events = events_of(world);
			note(&ledger, &events);
			if (k % 10 == 0)
				compare(world, &ledger);
		}
		for (int i = random_below(&seed, 4); i > 0; --i)
			churn(world, bodies, k, &seed);
		if (variant->other[0] && k % 7 == 3)
			OK(scree_world_move(world, k % 2 ? variant->other : variant->device));
		// in random steps the events are read only now, after the changes; they contain the same, except the marks of
		// destroyed collidables
		if (!early)
		{
			velocity_of(world, bodies[0]);
			scree_events events = events_of(world);
			note(&ledger, &events);
		}
	}
	OK(scree_bodies_destroy(world, bodies, HEAP));
	run_steps(world, 1);
	scree_events events = events_of(world);
	note(&ledger, &events);
	assert_int_equal(ledger.count, 0);
	assert_true(ledger.began > steps / 3 && ledger.hits > steps / 20);
	scree_world_destroy(world);
	return ledger;
}

// The list of moved bodies contains each body that was moved by a step or by the user, and each new body, also one in a
// reused slot. It contains each of them once.
static void moved_bodies_are_listed(void** state)
{
	(void)state;
	Variant variants[MAX_VARIANTS];
	int count = list_variants(variants);
	for (int k = 0; k < count; ++k)
	{
		scree_body first, bodies[3];
		scree_world* world = open_default_variant(variants + k);
		scree_body ground = add_floor(world);
		bodies[0] = add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 5.0f);
		bodies[1] = add_crate(world, SCREE_BODY_STATIC, 9.0f, 5.0f);
		bodies[2] = add_crate(world, SCREE_BODY_KINEMATIC, -9.0f, 5.0f);
		OK(scree_body_set_user(world, bodies[2], 8));
		assert_int_equal(moved_of(world, &first), 4);
		assert_true(scree_body_equals(first, ground));
		assert_int_equal(moved_of(world, &first), 0);
		run_steps(world, 2);
		if (variants[k].other[0])
			OK(scree_world_move(world, variants[k].other));
		assert_int_equal(moved_of(world, &first), 1);
		assert_true(scree_body_equals(first, bodies[0]));
		OK(scree_body_set_pose(world, bodies[1], (scree_pose){{9.0f, 6.0f}, {1.0f, 0.0f}}));
		assert_int_equal(moved_of(world, &first), 1);
		assert_true(scree_body_equals(first, bodies[1]));
		OK(scree_body_destroy(world, bodies[2]));
		bodies[2] = add_crate(world, SCREE_BODY_KINEMATIC, -9.0f, 5.0f);
		assert_int_equal(moved_of(world, &first), 1);
		assert_true(scree_body_equals(first, bodies[2]));
		assert_int_equal(moved_of(world, &first), 0);
		scree_world_destroy(world);
	}
}

// The user word of a body's definition is also given to the collidable of the body, and appears in events and contacts.
// Later the user words of body and collidable can be set separately.
static void a_body_gives_its_word(void** state)
{
	(void)state;
	scree_world* world = open_world(-10.0f);
	scree_body_def def = scree_body_def_default();
	def.attribute = shape_attribute(world, circle_shape(0.5f));
	def.pose.position.y = 0.5f;
	def.reports = ALL;
	def.user = 0x123456789abcdef0u;
	uint64_t user;
	scree_contact contact;
	int count;
	add_floor(world);
	scree_body ball = create_body(world, &def);
	run_steps(world, 1);
	assert_int_equal(events_of(world).touches_began_count, 1);
	assert_true(events_of(world).touches_began[0].user_a == def.user && events_of(world).touches_began[0].user_b == 0);
	OK(scree_body_get_contacts(world, ball, &contact, 1, &count));
	assert_true(count == 1 && contact.user_a == def.user);
	OK(scree_body_set_user(world, ball, 3));
	OK(scree_collidable_get_user(world, collidable_of(world, ball), &user));
	assert_true(user == def.user);
	OK(scree_collidable_set_user(world, collidable_of(world, ball), 4));
	OK(scree_body_get_user(world, ball, &user));
	assert_true(user == 3);
	scree_world_destroy(world);
}

// The list of moved bodies contains no body that kept its pose. The test sets another center of mass, another type,
// locks, and a pose with the same numbers but zeros of the other sign; it also takes steps at rest. A disabled body is
// listed if its pose is set.
static void bodies_at_rest_are_not_listed(void** state)
{
	(void)state;
	Variant variants[MAX_VARIANTS];
	int count = list_variants(variants);
	for (int k = 0; k < count; ++k)
	{
		scree_world_def def = scree_world_def_default();
		def.gravity.y = 0.0f;
		scree_world* world = open_variant(variants + k, &def);
		scree_body first, body = add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 4.0f);
		moved_of(world, &first);
		OK(scree_body_set_mass(world, body, (scree_mass){2.0f, 1.0f, {0.25f, 0.0f}}));
		assert_int_equal(moved_of(world, &first), 0);
		OK(scree_body_set_type(world, body, SCREE_BODY_STATIC));
		OK(scree_body_set_type(world, body, SCREE_BODY_DYNAMIC));
		OK(scree_body_set_locks(world, body, SCREE_LOCK_X));
		assert_int_equal(moved_of(world, &first), 0);
		OK(scree_body_set_pose(world, body, (scree_pose){{-0.0f, 4.0f}, {1.0f, -0.0f}}));
		run_steps(world, 2);
		if (variants[k].other[0])
			OK(scree_world_move(world, variants[k].other));
		assert_int_equal(moved_of(world, &first), 0);
		OK(scree_body_set_locks(world, body, 0));
		throw_body(world, body, 3.0f, 0.0f, 1.0f);
		OK(scree_body_set_enabled(world, body, false));
		assert_int_equal(moved_of(world, &first), 0);
		OK(scree_body_set_pose(world, body, (scree_pose){{1.0f, 4.0f}, {1.0f, 0.0f}}));
		assert_int_equal(moved_of(world, &first), 1);
		scree_world_destroy(world);
	}
}

// A joint whose force exceeds its threshold is listed in the events of the step.
static void joints_are_listed(void** state)
{
	(void)state;
	scree_world* world = open_world(-10.0f);
	scree_body load = add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 0.0f);
	scree_joint_def def = scree_joint_def_make(SCREE_JOINT_REVOLUTE);
	def.body_b = load;
	def.force_threshold = 5.0f; // half of the weight that the joint carries
	def.user = 77;
	scree_joint joint = add_joint(world, &def);
	run_steps(world, 3);
	scree_events events = events_of(world);
	assert_int_equal(events.joint_count, 1);
	assert_true(scree_joint_equals(events.joints[0].joint, joint) && events.joints[0].user == 77);
	NEAR(events.joints[0].force, 10.0, 0.1);
	OK(scree_joint_set_thresholds(world, joint, 50.0f, 50.0f, false));
	run_steps(world, 1);
	assert_int_equal(events_of(world).joint_count, 0);
	scree_world_destroy(world);
}

static void all_devices_agree(void** state)
{
	(void)state;
	Variant variants[MAX_VARIANTS];
	int count = list_variants(variants), steps = quick() ? 60 : 300;
	Ledger first = record_heap(variants, steps);
	for (int k = 1; k < count; ++k)
	{
		Ledger other = record_heap(variants + k, steps);
		assert_int_equal(other.began, first.began);
		assert_int_equal(other.hits, first.hits);
		assert_true(other.stream == first.stream);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(the_changed_and_destroyed_are_named),
	    cmocka_unit_test(events_change_no_motion),
	    cmocka_unit_test(a_ball_lands),
	    cmocka_unit_test(a_body_gives_its_word),
	    cmocka_unit_test(the_destroyed_are_named),
	    cmocka_unit_test(bullets_hit),
	    cmocka_unit_test(reports_change),
	    cmocka_unit_test(moved_bodies_are_listed),
	    cmocka_unit_test(bodies_at_rest_are_not_listed),
	    cmocka_unit_test(joints_are_listed),
	    cmocka_unit_test(all_devices_agree),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
