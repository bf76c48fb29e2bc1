// SPDX-License-Identifier: MIT
// test_pair_reasons.c -- checks each reason why two bodies do not collide, in each stage that tests for it, with equal
// bits on all devices.
//
// A ball meets a thin upright wall in four cases: it lies in the wall; it is thrown at the wall; a force pushes it
// through the wall within one step, so that no contact exists before; or it is a sensor that flies through the wall.
// The table has the expected result for each reason in each of the four cases.
#include "platform/processor.h"
#include "support/make_joints.h"
#include <math.h>
#include <string.h>

#define RADIUS 0.1f // radius of the ball, m

typedef enum
{
	NONE,
	JOINT,
	FILTER_JOINT,
	EXCLUSION,
	MASKS,
	GROUP,
	DISABLED,
	SENSOR,
	NO_BODY,
	BEHIND,
	IGNORED_MATERIALS,
	REFUSED,
} Reason;

// touches: true if ball and wall collide when the ball lies in the wall; sweeps: when it is thrown at the wall; stops:
// when a force pushes it. sees: true if the ball reports the wall when it is a sensor
static const struct
{
	const char* name;
	bool touches, sweeps, stops, sees;
} table[] = {
    [NONE] = {"none", true, true, true, true},
    [JOINT] = {"a joint", false, false, false, true},
    [FILTER_JOINT] = {"a filter joint", false, false, false, true},
    [EXCLUSION] = {"an exclusion", false, false, false, true},
    [MASKS] = {"categories and masks", false, false, false, false},
    [GROUP] = {"a group", false, false, false, false},
    [DISABLED] = {"the wall is disabled", false, false, false, false},
    [SENSOR] = {"the wall is a sensor", false, false, false, false},
    [NO_BODY] = {"the wall has no body", false, false, false, true},
    [BEHIND] = {"the wall is one-way, and the ball comes from behind", false, false, false, true},
    [IGNORED_MATERIALS] = {"their materials ignore each other", false, false, false, true},
    [REFUSED] = {"the user was asked and refused", false, false, false, true},
};
#define REASONS ((int)(sizeof table / sizeof table[0]))

static int lanes = 1, threads = 1;

typedef struct
{
	scree_world* world;
	scree_body ball, wall;
} Pair;

static void add_wall(Pair* pair, Reason reason, scree_body_type type)
{
	scree_attribute_def surface = scree_attribute_def_default();
	surface.shape = box_shape(0.01f, 2.0f);
	surface.density = 1000.0f;
	surface.material = 1;
	if (reason == BEHIND)
		surface.one_way = (scree_vec){1.0f, 0.0f};
	scree_attribute attribute = add_attribute(pair->world, &surface);
	if (reason == NO_BODY)
	{
		scree_collidable_def def = scree_collidable_def_default();
		def.attribute = attribute;
		OK(scree_collidable_create(pair->world, &def, NULL));
		return;
	}
	scree_body_def def = scree_body_def_default();
	def.type = type;
	def.attribute = attribute;
	def.disabled = reason == DISABLED;
	def.sensor = reason == SENSOR ? SCREE_SENSOR_MOVING : 0;
	if (reason == GROUP)
		def.filter.group = -1;
	if (reason == MASKS)
		def.filter.category = 2;
	pair->wall = create_body(pair->world, &def);
}

static void add_ball(Pair* pair, Reason reason, float x, bool sensor)
{
	scree_attribute_def surface = scree_attribute_def_default();
	surface.shape = circle_shape(RADIUS);
	surface.material = 2;
	scree_body_def def = scree_body_def_default();
	def.attribute = add_attribute(pair->world, &surface);
	def.pose.position.x = x;
	def.sensor = sensor ? SCREE_SENSOR_MOVING | SCREE_SENSOR_STATIC : 0;
	def.reports = reason == REFUSED ? SCREE_REPORT_APPROVAL : 0;
	if (reason == GROUP)
		def.filter.group = -1;
	if (reason == MASKS)
		def.filter.mask = ~2ull;
	pair->ball = create_body(pair->world, &def);
}

static void keep_apart(const Pair* pair, Reason reason)
{
	if (reason == JOINT || reason == FILTER_JOINT)
	{
		// a joint without locks applies no forces
		scree_joint_def def = scree_joint_def_make(reason == JOINT ? SCREE_JOINT_FREE : SCREE_JOINT_FILTER);
		def.body_a = pair->ball;
		def.body_b = pair->wall;
		OK(scree_joint_create(pair->world, &def, NULL));
	}
	if (reason == EXCLUSION)
		OK(scree_body_set_excluded(pair->world, pair->wall, pair->ball, true));
	if (reason == IGNORED_MATERIALS)
	{
		scree_material_pair materials = scree_material_pair_default();
		materials.ignored = true;
		OK(scree_world_set_material_pair(pair->world, 1, 2, &materials));
	}
}

// Creates a world with a wall at 0 and a ball at x. For the reason REFUSED the ball begins close to the wall, and their
// contact is refused.
static Pair begin(Reason reason, scree_body_type type, float x, bool sensor)
{
	scree_world_def def = scree_world_def_default();
	def.device = test_device;
	def.lanes = strcmp(test_device, "cpu") == 0 ? lanes : 0;
	def.threads = threads;
	def.gravity = (scree_vec){0.0f, 0.0f};
	Pair pair;
	pair.world = create_world(&def);
	add_wall(&pair, reason, type);
	if (reason == REFUSED && x < -RADIUS - 0.015f)
		x = -RADIUS - 0.015f;
	add_ball(&pair, reason, x, sensor);
	keep_apart(&pair, reason);
	if (reason != REFUSED || sensor)
		return pair;
	run_steps(pair.world, 1);
	const bool no = false;
	scree_events events = events_of(pair.world);
	assert_int_equal(events.approval_count, 1);
	OK(scree_world_approve_contacts(pair.world, &no, 1));
	return pair;
}

static uint64_t end(Pair pair)
{
	uint64_t hash = hash_of(pair.world);
	scree_world_destroy(pair.world);
	return hash;
}

static void expect(bool value, bool expected, const char* stage, Reason reason, scree_body_type type)
{
	if (value != expected)
		fail_msg("%s, %s: %d on a %s wall, must be %d", table[reason].name, stage, value,
		         type == SCREE_BODY_STATIC ? "static" : "dynamic", expected);
}

static uint64_t contact(Reason reason, scree_body_type type)
{
	Pair pair = begin(reason, type, -0.05f, false);
	run_steps(pair.world, 1);
	expect(contacts_with(pair.world, pair.ball) > 0, table[reason].touches, "contact", reason, type);
	return end(pair);
}

static uint64_t sweep(Reason reason, scree_body_type type)
{
	Pair pair = begin(reason, type, -0.3f, false);
	OK(scree_body_set_linear_velocity(pair.world, pair.ball, (scree_vec){100.0f, 0.0f}));
	run_steps(pair.world, 1);
	expect(pose_of(pair.world, pair.ball).position.x < 0.0f, table[reason].sweeps, "sweep", reason, type);
	expect(velocity_of(pair.world, pair.ball).linear.x < 100.0f, table[reason].sweeps, "speed", reason, type);
	return end(pair);
}

// The force moves the ball by 10 a h^2 = 0.6 m in four substeps of h = 1/240 s. The ball starts at rest, so there is no
// speculative contact before the step.
static uint64_t continuous(Reason reason, scree_body_type type)
{
	Pair pair = begin(reason, type, -0.3f, false);
	float mass = 3.14159f * RADIUS * RADIUS;
	OK(scree_body_apply_force(pair.world, pair.ball, (scree_vec){3456.0f * mass, 0.0f}));
	run_steps(pair.world, 1);
	expect(pose_of(pair.world, pair.ball).position.x < 0.0f, table[reason].stops, "continuous collision", reason, type);
	expect(counters_of(pair.world).stopped_bodies > 0, table[reason].stops, "stopped bodies", reason, type);
	return end(pair);
}

static uint64_t sensor(Reason reason, scree_body_type type)
{
	Pair pair = begin(reason, type, -0.3f, true);
	OK(scree_body_set_linear_velocity(pair.world, pair.ball, (scree_vec){100.0f, 0.0f}));
	run_steps(pair.world, 1);
	scree_events events = events_of(pair.world);
	int seen = 0; // number of visits that the ball reports
	for (int k = 0; k < events.visits_began_count; ++k)
		seen += events.visits_began[k].body_sensor.index == pair.ball.index;
	expect(seen == 1, table[reason].sees, "sensor", reason, type);
	return end(pair);
}

static uint64_t all_cells(void)
{
	uint64_t hash = 0;
	for (int k = 0; k < 2 * REASONS; ++k)
	{
		Reason reason = (Reason)(k / 2);
		scree_body_type type = k % 2 ? SCREE_BODY_DYNAMIC : SCREE_BODY_STATIC;
		hash = hash * 31 + contact(reason, type);
		hash = hash * 31 + sweep(reason, type);
		hash = hash * 31 + continuous(reason, type);
		hash = hash * 31 + sensor(reason, type);
	}
	return hash;
}

static void all_reasons_in_all_stages(void** state)
{
	(void)state;
	const int widest = processor_widest_lanes(), layouts[][2] = {{1, 1}, {widest, 1}, {widest, 2}};
	static uint64_t expected;
	if (strcmp(test_device, "cpu") != 0)
	{
		assert_int_equal(all_cells(), expected);
		return;
	}
	for (int k = 0; k < 3; ++k)
	{
		lanes = layouts[k][0];
		threads = layouts[k][1];
		uint64_t hash = all_cells();
		expected = k == 0 ? hash : expected;
		assert_int_equal(hash, expected);
	}
}

// A bar hangs on a hinge and overlaps its static frame. The bar turns in exactly the same way if the frame has no
// shape, and if bar and frame are excluded.
static void a_door_turns_in_its_frame(void** state)
{
	(void)state;
	float turned[3];
	for (int k = 0; k < 3; ++k)
	{
		scree_world* world = open_test_world(0.0f);
		scree_body_def def = scree_body_def_default();
		scree_body bar, frame;
		def.attribute = box_attribute(world, 0.5f, 2.0f);
		def.pose.position.y = -2.0f;
		def.velocity = (scree_velocity){{50.0f, 0.0f}, 25.0f};
		bar = create_body(world, &def);
		def = scree_body_def_default();
		def.type = SCREE_BODY_STATIC;
		if (k > 0)
			def.attribute = box_attribute(world, 4.0f, 0.5f);
		frame = create_body(world, &def);
		scree_joint_def hinge = scree_joint_def_make(SCREE_JOINT_REVOLUTE);
		hinge.body_a = bar;
		hinge.body_b = frame;
		hinge.frame_a.position.y = 2.0f;
		scree_joint joint = add_joint(world, &hinge);
		if (k == 2)
			OK(scree_body_set_excluded(world, bar, frame, true));
		int held = 0;
		for (int n = 0; n < 30; ++n)
		{
			run_steps(world, 1);
			held += counters_of(world).stopped_bodies;
		}
		scree_joint_state now = joint_state_of(world, joint);
		turned[k] = fabsf(now.values[2]);
		assert_int_equal(held, 0);
		scree_world_destroy(world);
	}
	NEAR(turned[0], 12.5, 0.5);
	assert_true(turned[1] == turned[0] && turned[2] == turned[0]);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(all_reasons_in_all_stages),
	    cmocka_unit_test(a_door_turns_in_its_frame),
	};
	return RUN_ON_DEVICES(tests);
}
