// SPDX-License-Identifier: MIT
// test_world.c -- checks handles, batches and commands, on the CPU and on OpenCL if it is available.
#include "support/make_bodies.h"
#include "world/upload/upload.h"
#include "world/world.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

// ---------------------------------------------------------------------------------------------------------------
// handles and batches
// ---------------------------------------------------------------------------------------------------------------

static void handles_name_one_life(void** state)
{
	(void)state;
	scree_world* world = open_test_world(-10.0f);
	scree_body a = add_crate(world, SCREE_BODY_DYNAMIC, 0, 0), b = add_crate(world, SCREE_BODY_DYNAMIC, 2, 0);
	scree_body c = add_crate(world, SCREE_BODY_DYNAMIC, 4, 0);
	assert_int_equal(a.index, 1);
	assert_int_equal(c.index, 3);
	assert_true(scree_body_is_valid(world, a));
	assert_false(scree_body_is_valid(world, (scree_body){0, 0}));
	assert_false(scree_body_is_valid(world, (scree_body){0, 1}));
	assert_false(scree_body_is_valid(world, (scree_body){4, 1}));

	// a new body takes the lowest free slot, with another generation
	OK(scree_body_destroy(world, b));
	OK(scree_body_destroy(world, a));
	assert_false(scree_body_is_valid(world, a));
	scree_body d = add_crate(world, SCREE_BODY_DYNAMIC, 0, 0);
	assert_int_equal(d.index, a.index);
	assert_int_not_equal(d.generation, a.generation);
	assert_int_equal(scree_body_apply_torque(world, a, 1.0f), SCREE_ERROR_STALE);
	assert_int_equal(scree_body_destroy(world, a), SCREE_ERROR_STALE);

	scree_counters counters = counters_of(world);
	assert_int_equal(counters.bodies, 2);
	assert_int_equal(counters.dynamic_bodies, 2);
	assert_int_equal(counters.collidables, 2);
	assert_int_equal(counters.attributes, 1);
	scree_world_destroy(world);
}

static void equal_attributes_are_one(void** state)
{
	(void)state;
	scree_world* world = open_test_world(-10.0f);
	scree_attribute first = box_attribute(world, 0.5f, 0.25f), again = box_attribute(world, 0.5f, 0.25f);
	assert_memory_equal(&first, &again, sizeof first);
	for (int k = 0; k < 1000; ++k)
		box_attribute(world, 1.0f + 0.01f * (float)k, 0.25f);
	again = box_attribute(world, 0.5f, 0.25f);
	assert_memory_equal(&first, &again, sizeof first);
	scree_counters counters = counters_of(world);
	assert_int_equal(counters.attributes, 1001);

	// a negative zero counts as zero, so the attribute is the same
	scree_attribute_def def;
	OK(scree_attribute_get_def(world, first, &def));
	def.restitution = -0.0f;
	again = add_attribute(world, &def);
	assert_memory_equal(&first, &again, sizeof first);
	assert_false(world->pipeline.has_rolling);
	def.restitution = 0.5f;
	again = add_attribute(world, &def);
	assert_memory_not_equal(&first, &again, sizeof first);
	assert_true(world->pipeline.has_rolling);
	scree_world_destroy(world);
}

static void batches_survive_churn(void** state)
{
	(void)state;
	enum
	{
		COUNT_OF = 500
	};
	scree_world* world = open_test_world(0.0f);
	scree_body_def defs[COUNT_OF];
	scree_body bodies[COUNT_OF], listed[COUNT_OF];
	scree_pose poses[COUNT_OF];
	for (int k = 0; k < COUNT_OF; ++k)
		defs[k] = crate_def(world, SCREE_BODY_DYNAMIC, 3.0f * (float)k, (float)(k % 7));
	OK(scree_bodies_create(world, defs, COUNT_OF, bodies));
	run_steps(world, 1);

	// every third body is destroyed and created elsewhere, six times; in every second round, a step follows the
	// destruction
	for (int round = 0; round < 6; ++round)
	{
		for (int k = 0; k < COUNT_OF; k += 3)
			OK(scree_body_destroy(world, bodies[k]));
		if (round % 2)
			run_steps(world, 1);
		for (int k = 0; k < COUNT_OF; k += 3)
		{
			defs[k].pose.position.y = (float)(100 + round);
			OK(scree_body_create(world, defs + k, bodies + k));
		}
	}
	int count;
	OK(scree_world_get_bodies(world, listed, COUNT_OF, &count));
	assert_int_equal(count, COUNT_OF);
	for (int k = 1; k < COUNT_OF; ++k)
		assert_true(listed[k - 1].index < listed[k].index);
	OK(scree_bodies_get_poses(world, bodies, poses, COUNT_OF));
	for (int k = 0; k < COUNT_OF; ++k)
	{
		NEAR(poses[k].position.x, 3.0 * k, 1e-6);
		NEAR(poses[k].position.y, k % 3 ? k % 7 : 105, 1e-6);
	}

	// one bad handle in a batch: the call changes nothing
	uint64_t hash = hash_of(world);
	scree_body kept = bodies[77];
	bodies[77] = bodies[3];
	assert_int_equal(scree_bodies_destroy(world, bodies, COUNT_OF), SCREE_ERROR_STALE);
	assert_int_equal(hash_of(world), hash);
	bodies[77] = kept;
	OK(scree_bodies_destroy(world, bodies, COUNT_OF));
	OK(scree_world_get_bodies(world, NULL, 0, &count));
	assert_int_equal(count, 0);
	run_steps(world, 2);
	scree_counters counters = counters_of(world);
	assert_int_equal(counters.contacts, 0);
	assert_int_equal(counters.collidables, 0);
	scree_world_destroy(world);
}

static const BackendFunctions* true_functions;
static int writes;

static scree_status counted_write(Backend* b, PoolId pool, int first, int count, const void* items)
{
	++writes;
	return true_functions->write(b, pool, first, count, items);
}

static void rows_travel_together(void** state)
{
	(void)state;
	enum
	{
		COUNT_OF = 20000
	};
	scree_world* world = open_test_world(0.0f);
	true_functions = world->backend->f;
	BackendFunctions counted = *true_functions;
	counted.write = counted_write;
	world->backend->f = &counted;
	scree_body_def* defs = malloc(COUNT_OF * sizeof *defs);
	scree_body* bodies = malloc(COUNT_OF * sizeof *bodies);
	for (int k = 0; k < COUNT_OF; ++k)
		defs[k] = crate_def(world, k % 2 ? SCREE_BODY_DYNAMIC : SCREE_BODY_STATIC, 2.0f * (float)(k % 200),
		                    2.0f * (float)(k / 200));

	writes = 0;
	OK(scree_bodies_create(world, defs, COUNT_OF, bodies));
	OK(world_upload(world));
	assert_true(writes <= 25);

	writes = 0;
	for (int k = 0; k < COUNT_OF; ++k)
		OK(scree_body_create(world, defs + k, NULL));
	OK(world_upload(world));
	assert_true(writes <= 25);

	// destroys every fifth body: scattered rows are uploaded as commands
	writes = 0;
	for (int k = 0; k < COUNT_OF; k += 5)
		OK(scree_body_destroy(world, bodies[k]));
	OK(world_upload(world));
	assert_true(writes <= 2);
	writes = 0;
	OK(world_upload(world));
	assert_int_equal(writes, 0);
	world->backend->f = true_functions;
	free(defs);
	free(bodies);
	scree_world_destroy(world);
}

// ---------------------------------------------------------------------------------------------------------------
// commands
// ---------------------------------------------------------------------------------------------------------------

// v = F dt / m; a force acts for one step.
static void forces_follow_newton(void** state)
{
	(void)state;
	scree_world* world = open_test_world(0.0f);
	scree_body a = add_crate(world, SCREE_BODY_DYNAMIC, 0, 0), b = add_crate(world, SCREE_BODY_DYNAMIC, 10, 0);
	scree_mass mass = mass_of(world, a);
	NEAR(mass.mass, 1.0, 1e-6);
	NEAR(mass.inertia, 1.0 / 6.0, 1e-6);

	OK(scree_body_apply_force(world, a, (scree_vec){6.0f, 0.0f}));
	OK(scree_body_apply_force(world, a, (scree_vec){0.0f, 12.0f}));
	OK(scree_body_apply_torque(world, a, 3.0f));
	OK(scree_body_apply_force_at(world, b, (scree_vec){0.0f, 6.0f}, (scree_vec){10.5f, 0.0f}));
	run_steps(world, 2);
	scree_velocity v = velocity_of(world, a);
	NEAR(v.linear.x, 6.0 / 60.0, 1e-6);
	NEAR(v.linear.y, 12.0 / 60.0, 1e-6);
	NEAR(v.angular, 3.0 * 6.0 / 60.0, 1e-5);
	v = velocity_of(world, b);
	NEAR(v.linear.y, 6.0 / 60.0, 1e-6);
	NEAR(v.angular, 0.5 * 6.0 * 6.0 / 60.0, 1e-5);

	// impulses change velocities at once, without a step
	scree_body c = add_crate(world, SCREE_BODY_DYNAMIC, 20, 0);
	OK(scree_body_apply_impulse_at(world, c, (scree_vec){2.0f, 0.0f}, (scree_vec){20.0f, 0.5f}));
	OK(scree_body_apply_impulse(world, c, (scree_vec){1.0f, 1.0f}));
	OK(scree_body_apply_angular_impulse(world, c, 1.0f));
	v = velocity_of(world, c);
	NEAR(v.linear.x, 3.0, 1e-6);
	NEAR(v.linear.y, 1.0, 1e-6);
	NEAR(v.angular, -2.0 * 0.5 * 6.0 + 6.0, 1e-5);
	scree_world_destroy(world);
}

// A body in free fall for n substeps of h: y = -g h^2 n (n + 1) / 2.
static void bodies_fall(void** state)
{
	(void)state;
	scree_world* world = open_test_world(-10.0f);
	scree_body loose = add_crate(world, SCREE_BODY_DYNAMIC, 0, 0), half = add_crate(world, SCREE_BODY_DYNAMIC, 5, 0);
	scree_body locked = add_crate(world, SCREE_BODY_DYNAMIC, 10, 0), fixed = add_crate(world, SCREE_BODY_STATIC, 15, 0);
	scree_body driven = add_crate(world, SCREE_BODY_KINEMATIC, 20, 0);
	OK(scree_body_set_gravity_scale(world, half, 0.5f));
	OK(scree_body_set_locks(world, locked, SCREE_LOCK_Y | SCREE_LOCK_ROTATION));
	scree_velocity v = {{1.0f, 2.0f}, 3.0f};
	scree_body moved[3] = {locked, fixed, driven};
	OK(scree_bodies_set_velocities(world, moved, (scree_velocity[]){v, v, v}, 3));
	run_steps(world, 60);
	double h = STEP / 4.0, fall = -10.0 * h * h * 240.0 * 241.0 / 2.0;
	NEAR(pose_of(world, loose).position.y, fall, 1e-3);
	NEAR(pose_of(world, half).position.y, 0.5 * fall, 1e-3);
	NEAR(pose_of(world, locked).position.x, 11.0, 1e-4);
	assert_true(pose_of(world, locked).position.y == 0.0f && pose_of(world, locked).rotation.s == 0.0f);
	assert_true(pose_of(world, fixed).position.x == 15.0f && pose_of(world, fixed).position.y == 0.0f);
	NEAR(pose_of(world, driven).position.x, 21.0, 1e-4);
	NEAR(pose_of(world, driven).position.y, 2.0, 1e-4);
	NEAR(scree_rot_get_angle(pose_of(world, driven).rotation), 3.0, 1e-3);

	// types change between steps
	OK(scree_body_set_type(world, loose, SCREE_BODY_STATIC));
	OK(scree_body_set_type(world, driven, SCREE_BODY_DYNAMIC));
	v = velocity_of(world, loose);
	assert_true(v.linear.x == 0.0f && v.linear.y == 0.0f && v.angular == 0.0f);
	float y = pose_of(world, loose).position.y, before = pose_of(world, driven).position.y;
	run_steps(world, 60);
	assert_true(pose_of(world, loose).position.y == y);
	NEAR(pose_of(world, driven).position.y, before + 2.0 + fall, 2e-3);
	scree_world_destroy(world);
}

// v = v0 / (1 + c h)^n
static void damping_slows(void** state)
{
	(void)state;
	scree_world* world = open_test_world(0.0f);
	scree_body body = add_crate(world, SCREE_BODY_DYNAMIC, 0, 0);
	OK(scree_body_set_damping(world, body, 0.5f, 2.0f));
	throw_body(world, body, 8.0f, 0.0f, 4.0f);
	run_steps(world, 60);
	double h = STEP / 4.0;
	NEAR(velocity_of(world, body).linear.x, 8.0 / pow(1.0 + 0.5 * h, 240.0), 1e-3);
	NEAR(velocity_of(world, body).angular, 4.0 / pow(1.0 + 2.0 * h, 240.0), 1e-3);
	scree_world_destroy(world);
}

// Makes a body and checks its mass. Without collidables the mass is 1 kg and the inertia 0. With two boxes of 1
// kg, whose centers are 2 m apart, the inertia is I = 2 (1 / 6 + 1) kg m^2.
static scree_body make_pair(scree_world* world, scree_collidable parts[2])
{
	scree_body_def def = scree_body_def_default();
	def.pose = (scree_pose){{3.0f, 4.0f}, scree_rot_make(0.5f)};
	scree_body body = create_body(world, &def);
	scree_mass mass = mass_of(world, body);
	assert_true(mass.mass == 1.0f && mass.inertia == 0.0f && mass.center.x == 0.0f);

	scree_collidable_def part = scree_collidable_def_default();
	part.attribute = box_attribute(world, 0.5f, 0.5f);
	part.body = body;
	parts[0] = create_collidable(world, &part);
	part.pose.position.x = 2.0f;
	parts[1] = create_collidable(world, &part);
	mass = mass_of(world, body);
	NEAR(mass.mass, 2.0, 1e-6);
	NEAR(mass.inertia, 2.0 * (1.0 / 6.0 + 1.0), 1e-5);
	NEAR(mass.center.x, 1.0, 1e-6);
	return body;
}

static void bodies_turn_about_their_center(void** state)
{
	(void)state;
	scree_world* world = open_test_world(0.0f);
	scree_collidable parts[2];
	scree_body body = make_pair(world, parts);
	scree_pose pose = pose_of(world, body);
	NEAR(pose.position.x, 3.0, 1e-6);
	NEAR(pose.position.y, 4.0, 1e-6);

	// the body turns around its center of mass, so its origin moves
	throw_body(world, body, 0.0f, 0.0f, 1.0f);
	run_steps(world, 30);
	scree_rot q = scree_rot_make(0.5f), turned = scree_rot_make(1.0f);
	pose = pose_of(world, body);
	NEAR(pose.position.x, 3.0 + q.c - turned.c, 1e-3);
	NEAR(pose.position.y, 4.0 + q.s - turned.s, 1e-3);

	// scree_body_set_pose sets the pose of the origin, not of the center of mass
	OK(scree_body_set_pose(world, body, (scree_pose){{-7.0f, 0.0f}, {0.0f, 1.0f}}));
	pose = pose_of(world, body);
	NEAR(pose.position.x, -7.0, 1e-6);
	NEAR(pose.rotation.s, 1.0, 1e-6);

	// one part is destroyed: the origin stays in place, and the other part keeps its motion
	OK(scree_collidable_destroy(world, parts[1]));
	NEAR(pose_of(world, body).position.x, -7.0, 1e-6);
	NEAR(velocity_of(world, body).linear.x, 1.0, 1e-5);
	scree_world_destroy(world);
}

static void mass_follows_collidables(void** state)
{
	(void)state;
	scree_world* world = open_test_world(0.0f);
	scree_collidable parts[3];
	scree_body body = make_pair(world, parts);
	OK(scree_body_set_pose(world, body, (scree_pose){{-7.0f, 0.0f}, {0.0f, 1.0f}}));
	OK(scree_collidable_destroy(world, parts[1]));
	scree_mass mass = mass_of(world, body);
	NEAR(mass.mass, 1.0, 1e-6);
	NEAR(mass.center.x, 0.0, 1e-6);

	// a mass set by the user lasts until the collidables change
	OK(scree_body_set_mass(world, body, (scree_mass){5.0f, 2.0f, {0.0f, 1.0f}}));
	OK(scree_body_apply_impulse(world, body, (scree_vec){5.0f, 0.0f}));
	NEAR(pose_of(world, body).position.x, -7.0, 1e-6);
	scree_collidable_def part = scree_collidable_def_default();
	part.attribute = box_attribute(world, 0.5f, 0.5f);
	part.body = body;
	parts[2] = create_collidable(world, &part);
	mass = mass_of(world, body);
	NEAR(mass.mass, 2.0, 1e-6);

	scree_collidable listed[3];
	int count;
	OK(scree_body_get_collidables(world, body, listed, 3, &count));
	assert_int_equal(count, 2);
	assert_memory_equal(&listed[0], &parts[0], sizeof *parts);
	assert_memory_equal(&listed[1], &parts[2], sizeof *parts);
	scree_world_destroy(world);
}

static void changes_keep_their_order(void** state)
{
	(void)state;
	scree_world* world = open_test_world(0.0f);
	scree_body a = add_crate(world, SCREE_BODY_DYNAMIC, 0, 0), b = add_crate(world, SCREE_BODY_DYNAMIC, 5, 0);
	scree_body order[4] = {a, b, a, b};
	scree_velocity velocities[4] = {{{1, 0}, 0}, {{2, 0}, 0}, {{3, 0}, 0}, {{4, 0}, 0}};
	OK(scree_bodies_set_velocities(world, order, velocities, 4));
	OK(scree_body_apply_impulse(world, a, (scree_vec){0.5f, 0.0f}));
	OK(scree_body_set_mass(world, a, (scree_mass){2.0f, 1.0f, {0.0f, 0.0f}}));
	OK(scree_body_apply_impulse(world, a, (scree_vec){0.5f, 0.0f}));
	NEAR(velocity_of(world, a).linear.x, 3.75, 1e-6);
	NEAR(velocity_of(world, b).linear.x, 4.0, 1e-6);

	// changes to a destroyed body do not affect the next body in its slot
	throw_body(world, b, 9.0f, 9.0f, 9.0f);
	OK(scree_body_destroy(world, b));
	scree_body c = add_crate(world, SCREE_BODY_DYNAMIC, 5, 0);
	assert_int_equal(c.index, b.index);
	assert_true(velocity_of(world, c).linear.x == 0.0f && velocity_of(world, c).angular == 0.0f);
	scree_world_destroy(world);
}

typedef enum // action after each call
{
	NOTHING,
	FLUSH, // uploads all edits
	READ,
} After;

typedef struct
{
	scree_world* world;
	After after;
	scree_body bodies[60], compound;
	scree_collidable parts[3]; // collidables of the body `compound`
} Caller;

static void after_call(const Caller* c, scree_status status)
{
	OK(status);
	if (c->after == FLUSH)
		OK(world_upload(c->world));
	if (c->after == READ)
		hash_of(c->world);
}

static void create_bodies(Caller* c)
{
	for (int k = 0; k < 60; ++k)
	{
		scree_body_def def =
		    crate_def(c->world, SCREE_BODY_DYNAMIC, 1.3f * (float)(k % 10), 1.0f + 1.1f * (float)(k / 10));
		def.pose.rotation = scree_rot_make(0.1f * (float)k);
		def.velocity.linear.x = (float)(k % 3);
		after_call(c, scree_body_create(c->world, &def, &c->bodies[k]));
	}
	scree_body_def empty = scree_body_def_default();
	empty.pose = (scree_pose){{-3.0f, 2.0f}, scree_rot_make(1.0f)};
	empty.velocity.angular = 2.0f;
	after_call(c, scree_body_create(c->world, &empty, &c->compound));
	for (int k = 0; k < 3; ++k)
	{
		scree_collidable_def part = scree_collidable_def_default();
		part.attribute = box_attribute(c->world, 0.2f, 0.4f);
		part.body = c->compound;
		part.pose = (scree_pose){{0.3f * (float)k, 0.1f}, scree_rot_make(0.3f * (float)k)};
		after_call(c, scree_collidable_create(c->world, &part, &c->parts[k]));
	}
}

static void change_bodies(Caller* c, int round)
{
	scree_body* body = &c->bodies[7 * round % 60];
	after_call(c, scree_body_apply_force_at(c->world, *body, (scree_vec){10.0f, 20.0f}, (scree_vec){1.0f, 1.0f}));
	after_call(c, scree_body_set_locks(c->world, c->bodies[5], round % 8));
	after_call(c, scree_body_set_type(c->world, c->bodies[11], round % 3));
	after_call(c, scree_body_set_damping(c->world, c->bodies[3], 0.1f * (float)round, 0.2f));
	after_call(c, scree_body_apply_impulse(c->world, c->compound, (scree_vec){0.3f, 0.7f}));
	if (round % 4 == 0)
	{
		after_call(c, scree_body_destroy(c->world, *body));
		scree_body_def def = crate_def(c->world, SCREE_BODY_DYNAMIC, -5.0f, 3.0f);
		after_call(c, scree_body_create(c->world, &def, body));
		after_call(c, scree_body_set_velocity(c->world, *body, (scree_velocity){{1.0f, 0.0f}, 5.0f}));
	}
	if (round == 10)
		after_call(c, scree_collidable_destroy(c->world, c->parts[1]));
	after_call(c, scree_collidable_set_filter(c->world, c->parts[2], (scree_filter){1, UINT64_MAX, round % 3 - 1}));
}

// Three worlds get the same calls. The first uploads all edits before its steps, the second uploads each edit
// immediately, and the hash of the third is read after each call. The final hashes must be equal.
static void reading_changes_nothing(void** state)
{
	(void)state;
	uint64_t hashes[3];
	for (After after = NOTHING; after <= READ; ++after)
	{
		Caller caller = {.world = open_test_world(-10.0f), .after = after};
		add_floor(caller.world);
		create_bodies(&caller);
		for (int round = 0; round < 20; ++round)
		{
			change_bodies(&caller, round);
			run_steps(caller.world, 1);
		}
		hashes[after] = hash_of(caller.world);
		scree_world_destroy(caller.world);
	}
	assert_int_equal(hashes[NOTHING], hashes[FLUSH]);
	assert_int_equal(hashes[NOTHING], hashes[READ]);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(handles_name_one_life),
	    cmocka_unit_test(equal_attributes_are_one),
	    cmocka_unit_test(batches_survive_churn),
	    cmocka_unit_test(rows_travel_together),
	    cmocka_unit_test(forces_follow_newton),
	    cmocka_unit_test(bodies_fall),
	    cmocka_unit_test(damping_slows),
	    cmocka_unit_test(bodies_turn_about_their_center),
	    cmocka_unit_test(mass_follows_collidables),
	    cmocka_unit_test(changes_keep_their_order),
	    cmocka_unit_test(reading_changes_nothing),
	};
	return RUN_ON_DEVICES(tests);
}
