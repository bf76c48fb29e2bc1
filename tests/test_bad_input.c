// SPDX-License-Identifier: MIT
// test_bad_input.c -- checks that every function of worlds, attributes and bodies refuses bad arguments with a message
// that names argument and value, and changes nothing.
#include "support/bad_input.h"
#include <float.h>
#include <math.h>
#include <string.h>

static const float bad[] = {NAN, INFINITY, -INFINITY};

// members that both scree_world_def and scree_tuning have
#define BAD_TUNINGS(BAD, name)                                                                               \
	BAD(contact_hertz = 0.0f, name "contact_hertz is 0, must be from 0.001");                                \
	BAD(contact_damping_ratio = -1.0f, name "contact_damping_ratio is -1");                                  \
	BAD(contact_push_speed = NAN, name "contact_push_speed is nan");                                         \
	BAD(restitution_threshold = -0.5f, name "restitution_threshold is -0.5, must be finite and at least 0"); \
	BAD(max_speed = 0.0f, name "max_speed is 0")

static void world_definitions(void** state)
{
	(void)state;
	scree_world_def def = scree_world_def_default();
	scree_world* made = world;
	INVALID(scree_world_create, (&def, NULL), "world is null");
	INVALID(scree_world_create, (NULL, &made), "def is null");
	assert_null(made);
#define DEF(change, sentence)        \
	def = scree_world_def_default(); \
	def.change;                      \
	INVALID(scree_world_create, (&def, &made), sentence)
	DEF(size = 0, "def.size is 0: the definition was not made by scree_world_def_default");
	DEF(gravity.x = NAN, "def.gravity.x is nan, must be finite");
	DEF(gravity.y = INFINITY, "def.gravity.y is inf, must be finite");
	DEF(device = NULL, "def.device is null");
	DEF(device = "gpu", "def.device is \"gpu\", must be \"auto\", \"cpu\", \"opencl\" or \"opencl:NAME\"");
	DEF(device = "opencl:", "def.device is \"opencl:\"");
	DEF(threads = -1, "def.threads is -1, must be from 0 to 64");
	DEF(threads = 65, "def.threads is 65");
	DEF(lanes = 3, "def.lanes is 3, must be 0, 1, 4, 8 or 16");
	BAD_TUNINGS(DEF, "def.");
	DEF(hit_speed = -1.0f, "def.hit_speed is -1");
	DEF(hit_impulse = NAN, "def.hit_impulse is nan");
	DEF(body_capacity = -5, "def.body_capacity is -5");
	DEF(contact_capacity = INT32_MAX, "def.contact_capacity is 2147483647");
	DEF(device_timeout = -1.0f, "def.device_timeout is -1, must be from 0 to INFINITY");
	DEF(contact_limit = -1, "def.contact_limit is -1, must be from 0 to 134217728");
#undef DEF
	def = scree_world_def_default();
	def.device = "opencl:no device has such a name";
	assert_int_equal(scree_world_create(&def, &made), SCREE_ERROR_NO_DEVICE);
	assert_null(made);
}

static void world_functions(void** state)
{
	(void)state;
	INVALID(scree_world_step, (NULL, 0.01f, 4), "world is null");
	INVALID(scree_world_step, (world, 0.0f, 0), "substeps is 0");
	INVALID(scree_world_step, (world, 9e-10f, 4), "dt is 9e-10, must be 0 or from 1e-09 to 1");
	INVALID(scree_world_step, (world, INFINITY, 4), "dt is inf");
	INVALID(scree_world_step, (world, -0.1f, 4), "dt is -0.1");
	INVALID(scree_world_step, (world, 1.5f, 4), "dt is 1.5");
	INVALID(scree_world_step, (world, 1e-40f, 4), "dt is");
	INVALID(scree_world_step, (world, NAN, 4), "dt is nan");
	INVALID(scree_world_step, (world, 0.01f, 0), "substeps is 0, must be from 1 to 64");
	INVALID(scree_world_step, (world, 0.01f, 65), "substeps is 65");
	for (int k = 0; k < 3; ++k)
	{
		INVALID(scree_world_set_gravity, (world, (scree_vec){bad[k], 0}), "gravity.x");
		INVALID(scree_world_set_gravity, (world, (scree_vec){0, bad[k]}), "gravity.y");
	}
	INVALID(scree_world_set_gravity, (NULL, (scree_vec){0, 0}), "world is null");
	INVALID(scree_world_get_gravity, (world, NULL), "gravity is null");
	scree_tuning tuning;
	INVALID(scree_world_get_tuning, (world, NULL), "tuning is null");
	INVALID(scree_world_set_tuning, (world, NULL), "tuning is null");
#define TUNING(change, sentence)                \
	OK(scree_world_get_tuning(world, &tuning)); \
	tuning.change;                              \
	INVALID(scree_world_set_tuning, (world, &tuning), sentence)
	TUNING(size = 0, "tuning.size is 0: the definition was not made by scree_world_get_tuning");
	BAD_TUNINGS(TUNING, "tuning.");
#undef TUNING
	INVALID(scree_world_wait, (NULL), "world is null");
}

static void world_readers(void** state)
{
	(void)state;
	int listed;
	scree_body_state body_state;
	INVALID(scree_world_get_states, (NULL, NULL, &body_state, 1, &listed), "world is null");
	INVALID(scree_world_get_states, (world, NULL, NULL, 1, &listed), "states is null");
	INVALID(scree_world_get_states, (world, NULL, &body_state, -1, &listed), "capacity is -1");
	INVALID(scree_world_get_states, (world, NULL, &body_state, 1, NULL), "count is null");
	INVALID(scree_world_get_hash, (NULL, &before), "world is null");
	INVALID(scree_world_get_hash, (world, NULL), "hash is null");
	INVALID(scree_world_get_counters, (world, NULL), "counters is null");
	INVALID(scree_world_get_timings, (world, NULL), "timings is null");
	scree_traffic traffic;
	double bandwidth;
	INVALID(scree_world_get_traffic, (NULL, &traffic), "world is null");
	INVALID(scree_world_get_traffic, (world, NULL), "traffic is null");
	INVALID(scree_world_measure_bandwidth, (NULL, &bandwidth), "world is null");
	INVALID(scree_world_measure_bandwidth, (world, NULL), "bandwidth is null");
}

static void device_functions(void** state)
{
	(void)state;
	int count;
	INVALID(scree_devices_get, (NULL, 3, &count), "devices is null");
	INVALID(scree_devices_get, (NULL, -1, &count), "capacity is -1");
	INVALID(scree_devices_get, (NULL, 0, NULL), "count is null");
	OK(scree_devices_get(NULL, 0, &count));
	assert_true(count >= 1);
}

static void shape_functions(void** state)
{
	(void)state;
	scree_shape shape;
	scree_vec corners[3] = {{0, 0}, {1, 0}, {0, 1}}, zero = {0, 0}, unit = {1, 0};
	INVALID(scree_shape_make_box, (1, 1, NULL), "shape is null");
	INVALID(scree_shape_make_box, (0, 1, &shape), "half_width is 0");
	INVALID(scree_shape_make_box, (1, -1, &shape), "half_height is -1");
	INVALID(scree_shape_make_box, (1, 0.0005f, &shape), "half_height is");
	INVALID(scree_shape_make_circle, (zero, 0, &shape), "radius is 0");
	INVALID(scree_shape_make_circle, ((scree_vec){1e6f, 0}, 1, &shape), "center.x is 1000000");
	INVALID(scree_shape_make_capsule, (zero, zero, 1, &shape), "b is (0, 0)");
	INVALID(scree_shape_make_capsule, (zero, unit, -1, &shape), "radius is -1");
	INVALID(scree_shape_make_segment, (unit, unit, &shape), "b is (1, 0)");
	INVALID(scree_shape_make_polygon, (NULL, 3, 0, &shape), "corners is null");
	INVALID(scree_shape_make_polygon, (corners, 3, 0, NULL), "shape is null");
	INVALID(scree_shape_make_polygon, (corners, 2, 0, &shape), "count is 2, must be from 3 to 8");
	INVALID(scree_shape_make_polygon, (corners, 9, 0, &shape), "count is 9");
	INVALID(scree_shape_make_polygon, (corners, 3, -1, &shape), "radius is -1");
	INVALID(scree_shape_make_hull, (corners, 65, 0, &shape), "count is 65, must be from 3 to 64");
	for (int k = 0; k < 3; ++k)
	{
		INVALID(scree_shape_make_box, (bad[k], 1, &shape), "half_width");
		INVALID(scree_shape_make_circle, ((scree_vec){0, bad[k]}, 1, &shape), "center.y");
		INVALID(scree_shape_make_capsule, (unit, (scree_vec){0, bad[k]}, 1, &shape), "b.y");
		INVALID(scree_shape_make_segment, ((scree_vec){bad[k], 0}, unit, &shape), "a.x");
		INVALID(scree_shape_make_polygon, (corners, 3, bad[k], &shape), "radius");
		corners[1].y = bad[k];
		INVALID(scree_shape_make_polygon, (corners, 3, 0, &shape), "corners[1].y");
		INVALID(scree_shape_make_hull, (corners, 3, 0, &shape), "points[1].y");
		corners[1].y = 0;
	}
	shape = box_shape(1, 1);
	scree_pose pose = {{0, 0}, {1, 0}};
	INVALID(scree_shape_transform, (NULL, pose, &shape), "shape is null");
	INVALID(scree_shape_transform, (&shape, pose, NULL), "transformed is null");
	pose.rotation.c = 0.9f;
	INVALID(scree_shape_transform, (&shape, pose, &shape), "pose.rotation is (0.9, 0)");
	pose.rotation.c = 1;
	shape.kind = 17;
	INVALID(scree_shape_transform, (&shape, pose, &shape), "shape.kind is 17");
	shape.kind = SCREE_SHAPE_CIRCLE;
	INVALID(scree_shape_transform, (&shape, pose, &shape), "shape.count is 4");
}

static void attribute_functions(void** state)
{
	(void)state;
	scree_attribute made;
	scree_attribute_def def = scree_attribute_def_default();
	INVALID(scree_attribute_create, (NULL, &def, &made), "world is null");
	INVALID(scree_attribute_create, (world, NULL, &made), "def is null");
	INVALID(scree_attribute_create, (world, &def, NULL), "attribute is null");
#define DEF(change, sentence)            \
	def = scree_attribute_def_default(); \
	def.change;                          \
	INVALID(scree_attribute_create, (world, &def, &made), sentence)
	DEF(size = 1, "def.size is 1: the definition was not made by scree_attribute_def_default");
	DEF(density = -1, "is -1, must be from");
	DEF(density = 1e-30f, "def.density");
	DEF(density = INFINITY, "def.density");
	DEF(friction = -0.1f, "def.friction is -0.1");
	DEF(restitution = 101.0f, "def.restitution is 101, must be from 0 to 100");
	DEF(rolling_resistance = NAN, "def.rolling_resistance is nan");
	DEF(tangent_speed = -INFINITY, "def.tangent_speed is -inf");
	DEF(material = 256, "def.material is 256, must be from 0 to 255");
	DEF(material = -1, "def.material is -1");
	DEF(one_way.x = NAN, "def.one_way.x is nan");
	DEF(one_way.y = 1e-9f, "def.one_way is (0, 1e-09), too short for a direction: at least 0.001");
	DEF(shape.kind = -1, "def.shape.kind is -1");
	DEF(shape.count = 9, "def.shape.count is 9, must be from 3 to 8");
	DEF(shape.radius = -1, "def.shape.radius is -1");
	DEF(shape.vertices[2].x = NAN, "def.shape.vertices[2].x is nan");
	DEF(shape.vertices[2].x = -2, "def.shape.vertices[");
#undef DEF
	STALE(scree_attribute_get_def, (world, (scree_attribute){0, 0}, &def), "attribute is null");
	STALE(scree_attribute_get_def, (world, foreign, &def), "attribute (index 0) is not an attribute of this world");
	INVALID(scree_attribute_get_def, (world, crate, NULL), "def is null");
	INVALID(scree_attribute_destroy, (NULL, crate), "world is null");
	INVALID(scree_attribute_destroy, (world, crate), "attribute (index 0) is still used by 4 collidables");
	STALE(scree_attribute_destroy, (world, (scree_attribute){0, 0}), "attribute is null");
	STALE(scree_attribute_destroy, (world, foreign), "attribute (index 0) is not an attribute of this world");
	STALE(scree_attribute_destroy, (world, (scree_attribute){77, 1}), "attribute (index 77) is not an attribute");
	assert_true(scree_attribute_is_valid(world, crate));
	assert_false(scree_attribute_is_valid(world, foreign));
	assert_false(scree_attribute_is_valid(NULL, crate));
}

static void body_functions(void** state)
{
	(void)state;
	scree_body_def defs[3] = {scree_body_def_default(), scree_body_def_default(), scree_body_def_default()};
	scree_body made[3];
	INVALID(scree_bodies_create, (NULL, defs, 3, made), "world is null");
	INVALID(scree_bodies_create, (world, NULL, 3, made), "defs is null");
	INVALID(scree_bodies_create, (world, defs, -1, made), "count is -1");
	INVALID(scree_bodies_create, (world, defs, INT32_MAX, made), "count is 2147483647");
#define DEF(status, change, sentence)                                                 \
	defs[2] = scree_body_def_default();                                               \
	defs[2].change;                                                                   \
	REFUSED(scree_bodies_create, (world, defs, 3, made), status, "defs[2]" sentence); \
	REFUSED(scree_body_create, (world, &defs[2], made), status, "def" sentence)
	DEF(SCREE_ERROR_INVALID, size = 0, ".size is 0: the definition was not made by scree_body_def_default");
	DEF(SCREE_ERROR_INVALID, type = 3, ".type is 3");
	DEF(SCREE_ERROR_INVALID, linear_damping = -1, ".linear_damping is -1, must be finite and at least 0");
	DEF(SCREE_ERROR_INVALID, angular_damping = NAN, ".angular_damping is nan");
	DEF(SCREE_ERROR_INVALID, gravity_scale = INFINITY, ".gravity_scale is inf, must be finite");
	DEF(SCREE_ERROR_INVALID, pose.position.x = 1e6f, ".pose.position.x is 1000000, must be from -100000 to 100000");
	DEF(SCREE_ERROR_INVALID, pose.position.y = NAN, ".pose.position.y is nan");
	DEF(SCREE_ERROR_INVALID, pose.rotation.c = 0, ".pose.rotation is (0, 0)");
	DEF(SCREE_ERROR_INVALID, pose.rotation.s = NAN, ".pose.rotation is (1, nan)");
	DEF(SCREE_ERROR_INVALID, velocity.linear.x = NAN, ".velocity.linear.x is nan");
	DEF(SCREE_ERROR_INVALID, velocity.linear.y = -1e30f, ".velocity.linear.y is");
	DEF(SCREE_ERROR_INVALID, velocity.angular = INFINITY, ".velocity.angular is inf");
	DEF(SCREE_ERROR_INVALID, locks = 8, ".locks is 8");
	DEF(SCREE_ERROR_INVALID, reports = 8,
	    ".reports is 8, must be bits of SCREE_REPORT_TOUCHES, SCREE_REPORT_HITS and SCREE_REPORT_APPROVAL");
	DEF(SCREE_ERROR_STALE, attribute = foreign, ".attribute (index 0) is not an attribute of this world");
#undef DEF
	OK(scree_bodies_create(world, NULL, 0, NULL));

	scree_body handles[3] = {body, second, stale};
	INVALID(scree_bodies_destroy, (NULL, handles, 3), "world is null");
	INVALID(scree_bodies_destroy, (world, NULL, 1), "bodies is null");
	STALE(scree_bodies_destroy, (world, handles, 3), "bodies[2] (index 4, generation 1) was destroyed");
	handles[2] = body;
	STALE(scree_bodies_destroy, (world, handles, 3), "bodies[2] is twice in the batch");
	STALE(scree_body_destroy, (world, stale), "body (index 4");
	STALE(scree_body_destroy, (world, SCREE_NULL_BODY), "body is null");
	STALE(scree_body_destroy, (world, (scree_body){0, 1}), "body (index 0");
	STALE(scree_body_destroy, (world, (scree_body){1000000, 1}), "body (index 1000000");
	int count;
	INVALID(scree_world_get_bodies, (world, NULL, 1, &count), "bodies is null");
	INVALID(scree_world_get_bodies, (world, NULL, 0, NULL), "count is null");
	INVALID(scree_world_get_bodies, (world, handles, -2, &count), "capacity is -2");
	assert_false(scree_body_is_valid(NULL, body));
}

// Checks that two functions refuse bad arguments: plural(world, bodies, values, count), which sets a value of many
// bodies, and single(world, body, value), which sets that of one body.
#define BATCH(plural, single, type, good, wrong, values, value, component)       \
	do                                                                           \
	{                                                                            \
		scree_body handles[2] = {body, stale};                                   \
		type array[2] = {good, good};                                            \
		INVALID(plural, (NULL, handles, array, 2), "world is null");             \
		INVALID(plural, (world, NULL, array, 2), "bodies is null");              \
		INVALID(plural, (world, handles, NULL, 2), values " is null");           \
		INVALID(plural, (world, handles, array, -1), "count is -1");             \
		STALE(plural, (world, handles, array, 2), "bodies[1] (index 4");         \
		STALE(single, (world, stale, good), "body (index 4");                    \
		STALE(single, (world, SCREE_NULL_BODY, good), "body is null");           \
		INVALID(single, (NULL, body, good), "world is null");                    \
		handles[1] = second;                                                     \
		for (int k = 0; k < 3; ++k)                                              \
		{                                                                        \
			float x = bad[k];                                                    \
			array[1] = wrong;                                                    \
			INVALID(plural, (world, handles, array, 2), values "[1]" component); \
			INVALID(single, (world, body, wrong), value component);              \
		}                                                                        \
	} while (0)

static const scree_vec good_vec = {1, 2};
static const scree_velocity good_velocity = {{1, 2}, 3};

static scree_vec bad_vec(float x) { return (scree_vec){0, x}; }
static scree_velocity bad_velocity(float x) { return (scree_velocity){{0, 0}, x}; }
static scree_pose bad_pose(float x) { return (scree_pose){{x, 0}, {1, 0}}; }

static void batch_functions(void** state)
{
	(void)state;
	BATCH(scree_bodies_apply_forces, scree_body_apply_force, scree_vec, good_vec, bad_vec(x), "forces", "force",
	      ".y is ");
	BATCH(scree_bodies_apply_impulses, scree_body_apply_impulse, scree_vec, good_vec, bad_vec(x), "impulses", "impulse",
	      ".y is ");
	BATCH(scree_bodies_apply_torques, scree_body_apply_torque, float, 1.0f, x, "torques", "torque", " is ");
	BATCH(scree_bodies_apply_angular_impulses, scree_body_apply_angular_impulse, float, 1.0f, x, "impulses", "impulse",
	      " is ");
	BATCH(scree_bodies_set_velocities, scree_body_set_velocity, scree_velocity, good_velocity, bad_velocity(x),
	      "velocities", "velocity", ".angular is ");
	BATCH(scree_bodies_set_linear_velocities, scree_body_set_linear_velocity, scree_vec, good_vec, bad_vec(x),
	      "velocities", "velocity", ".y is ");
	BATCH(scree_bodies_set_angular_velocities, scree_body_set_angular_velocity, float, 1.0f, x, "velocities",
	      "velocity", " is ");
	BATCH(scree_bodies_set_poses, scree_body_set_pose, scree_pose, good_pose, bad_pose(x), "poses", "pose",
	      ".position.x is ");

	scree_body handles[2] = {body, second};
	scree_vec good[2] = {good_vec, good_vec}, wrong[2] = {good_vec, {NAN, 0}}, far = {0, 1e7f};
	INVALID(scree_bodies_apply_forces_at, (world, handles, good, NULL, 2), "points is null");
	INVALID(scree_bodies_apply_forces_at, (world, handles, good, wrong, 2), "points[1].x is nan");
	INVALID(scree_bodies_apply_forces_at, (world, handles, wrong, good, 2), "forces[1].x is nan");
	INVALID(scree_bodies_apply_impulses_at, (world, handles, NULL, good, 2), "impulses is null");
	INVALID(scree_bodies_apply_impulses_at, (world, handles, good, wrong, 2), "points[1].x is nan");
	INVALID(scree_body_apply_force_at, (world, body, good_vec, far), "point.y is 1e+07");
	INVALID(scree_body_apply_impulse_at, (world, body, good_vec, far), "point.y is 1e+07");
	INVALID(scree_body_set_pose, (world, body, (scree_pose){{0, 0}, {2, 0}}), "pose.rotation is (2, 0)");
	INVALID(scree_body_set_velocity, (world, body, (scree_velocity){{1e9f, 0}, 0}), "velocity.linear.x is 1e+09");

	INVALID(scree_body_set_linear_velocity, (world, body, (scree_vec){0, -2e5f}),
	        "velocity.y is -200000, must be from -100000 to 100000");
	INVALID(scree_body_set_angular_velocity, (world, body, 2e5f), "velocity is 200000, must be from -100000 to 100000");

	scree_pose pose[2];
	scree_velocity velocity[2];
	INVALID(scree_bodies_get_poses, (world, handles, NULL, 2), "poses is null");
	INVALID(scree_bodies_get_poses, (world, NULL, pose, 2), "bodies is null");
	INVALID(scree_bodies_get_velocities, (world, handles, velocity, -2), "count is -2");
	INVALID(scree_body_get_pose, (world, body, NULL), "pose is null");
	INVALID(scree_body_get_velocity, (world, body, NULL), "velocity is null");
	handles[1] = stale;
	STALE(scree_bodies_get_poses, (world, handles, pose, 2), "bodies[1] (index 4");
	STALE(scree_bodies_get_velocities, (world, handles, velocity, 2), "bodies[1] (index 4");
	STALE(scree_body_get_pose, (world, stale, pose), "body (index 4");
	STALE(scree_body_get_velocity, (world, SCREE_NULL_BODY, velocity), "body is null");
}

// The last test of the list, because it makes a body kinematic: for other tests, the world of set_up must have no
// kinematic body.
static void target_functions(void** state)
{
	(void)state;
	scree_pose poses[2] = {good_pose, good_pose}, wrong = good_pose;
	scree_body handles[2] = {body, second};
	INVALID(scree_body_set_target, (NULL, body, good_pose), "world is null");
	INVALID(scree_body_set_target, (world, body, good_pose), "body is dynamic: only a kinematic body has a target");
	INVALID(scree_body_set_target, (world, fixed, good_pose), "body is static: only a kinematic body has a target");
	STALE(scree_body_set_target, (world, stale, good_pose), "body (index 4");
	STALE(scree_body_set_target, (world, SCREE_NULL_BODY, good_pose), "body is null");
	INVALID(scree_bodies_set_targets, (world, NULL, poses, 2), "bodies is null");
	INVALID(scree_bodies_set_targets, (world, handles, NULL, 2), "poses is null");
	INVALID(scree_bodies_set_targets, (world, handles, poses, -1), "count is -1");
	INVALID(scree_bodies_set_targets, (world, handles, poses, 2), "bodies[0] is dynamic");

	OK(scree_body_set_type(world, second, SCREE_BODY_KINEMATIC));
	before = hash_of(world);
	handles[0] = second;
	handles[1] = body;
	INVALID(scree_bodies_set_targets, (world, handles, poses, 2), "bodies[1] is dynamic");
	for (int k = 0; k < 3; ++k)
	{
		INVALID(scree_body_set_target, (world, second, bad_pose(bad[k])), "pose.position.x is ");
		handles[1] = second;
		poses[1] = bad_pose(bad[k]);
		INVALID(scree_bodies_set_targets, (world, handles, poses, 2), "poses[1].position.x is ");
	}
	wrong.rotation.c = 2;
	INVALID(scree_body_set_target, (world, second, wrong), "pose.rotation is (2, 1)");
}

static void setting_functions(void** state)
{
	(void)state;
	scree_body_def def;
	float x, y;
	uint32_t locks;
	uint64_t user;
	scree_body_type type;
	scree_mass mass = {1, 1, {0, 0}};
	INVALID(scree_body_set_type, (world, body, 7), "type is 7");
	INVALID(scree_body_set_locks, (world, body, 9), "locks is 9");
	INVALID(scree_body_set_damping, (world, body, -1, 0), "linear is -1");
	for (int k = 0; k < 3; ++k)
	{
		INVALID(scree_body_set_damping, (world, body, 0, bad[k]), "angular is");
		INVALID(scree_body_set_gravity_scale, (world, body, bad[k]), "scale is");
		INVALID(scree_body_set_mass, (world, body, (scree_mass){bad[k], 1, {0, 0}}), "mass.mass is");
		INVALID(scree_body_set_mass, (world, body, (scree_mass){1, bad[k], {0, 0}}), "mass.inertia");
		INVALID(scree_body_set_mass, (world, body, (scree_mass){1, 1, {0, bad[k]}}), "mass.center.y is");
	}
	INVALID(scree_body_set_mass, (world, body, (scree_mass){0, 1, {0, 0}}), "mass.mass is 0");
	INVALID(scree_body_set_mass, (world, body, (scree_mass){1, -1, {0, 0}}), "mass.inertia");
	INVALID(scree_body_set_mass, (world, fixed, mass), "body is not dynamic");

	const bool enabled[2] = {false, false};
	scree_body handles[2] = {body, stale};
	STALE(scree_bodies_set_enabled, (world, handles, enabled, 2), "bodies[1] (index 4");
	INVALID(scree_bodies_set_enabled, (world, NULL, enabled, 2), "bodies is null");
	INVALID(scree_bodies_set_enabled, (world, handles, NULL, 2), "enabled is null");
	INVALID(scree_bodies_set_enabled, (world, handles, enabled, -1), "count is -1");
	INVALID(scree_bodies_set_enabled, (NULL, handles, enabled, 2), "world is null");
	INVALID(scree_body_set_enabled, (NULL, body, false), "world is null");
	STALE(scree_body_set_enabled, (world, stale, false), "body (index 4");
	STALE(scree_body_set_enabled, (world, SCREE_NULL_BODY, false), "body is null");
	assert_true(scree_body_is_enabled(world, body));
	assert_false(scree_body_is_enabled(world, stale));
	assert_false(scree_body_is_enabled(NULL, body));

	STALE(scree_body_set_type, (world, stale, SCREE_BODY_STATIC), "body (index 4");
	STALE(scree_body_set_locks, (world, stale, 0), "body (index 4");
	STALE(scree_body_set_damping, (world, stale, 0, 0), "body (index 4");
	STALE(scree_body_set_gravity_scale, (world, stale, 0), "body (index 4");
	STALE(scree_body_set_mass, (world, stale, mass), "body (index 4");
	STALE(scree_body_set_user, (world, stale, 1), "body (index 4");
	STALE(scree_body_get_type, (world, stale, &type), "body (index 4");
	STALE(scree_body_get_locks, (world, stale, &locks), "body (index 4");
	STALE(scree_body_get_damping, (world, stale, &x, &y), "body (index 4");
	STALE(scree_body_get_gravity_scale, (world, stale, &x), "body (index 4");
	STALE(scree_body_get_def, (world, stale, &def), "body (index 4");
	STALE(scree_body_get_mass, (world, stale, &mass), "body (index 4");
	STALE(scree_body_get_own_mass, (world, stale, &mass), "body (index 4");
	STALE(scree_body_get_user, (world, stale, &user), "body (index 4");
	INVALID(scree_body_get_type, (world, body, NULL), "type is null");
	INVALID(scree_body_get_locks, (world, body, NULL), "locks is null");
	INVALID(scree_body_get_damping, (world, body, NULL, &y), "linear is null");
	INVALID(scree_body_get_damping, (world, body, &x, NULL), "angular is null");
	INVALID(scree_body_get_gravity_scale, (world, body, NULL), "scale is null");
	INVALID(scree_body_get_def, (world, body, NULL), "def is null");
	INVALID(scree_body_get_mass, (world, body, NULL), "mass is null");
	INVALID(scree_body_get_own_mass, (world, body, NULL), "mass is null");
	INVALID(scree_body_get_user, (NULL, body, &user), "world is null");
	INVALID(scree_body_set_user, (NULL, body, 1), "world is null");
	INVALID(scree_body_set_type, (NULL, body, SCREE_BODY_STATIC), "world is null");
}

// A rotation with a length slightly different from 1 is accepted and normalized.
static void nearly_normal_rotations_are_taken(void** state)
{
	(void)state;
	scree_pose pose;
	scree_body_def def = scree_body_def_default();
	def.pose.rotation = (scree_rot){0.8f * 1.0004f, 0.6f * 1.0004f};
	scree_body made = create_body(other, &def);
	pose = pose_of(other, made);
	assert_true(fabsf(pose.rotation.c - 0.8f) < 1e-6f && fabsf(pose.rotation.s - 0.6f) < 1e-6f);

	// a pose that was read is accepted unchanged when it is set
	OK(scree_body_set_pose(other, made, pose));
	scree_pose again = pose_of(other, made);
	assert_memory_equal(&pose, &again, sizeof pose);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(world_definitions), cmocka_unit_test(world_functions),
	    cmocka_unit_test(world_readers),     cmocka_unit_test(device_functions),
	    cmocka_unit_test(shape_functions),   cmocka_unit_test(attribute_functions),
	    cmocka_unit_test(body_functions),    cmocka_unit_test(batch_functions),
	    cmocka_unit_test(setting_functions), cmocka_unit_test(nearly_normal_rotations_are_taken),
	    cmocka_unit_test(target_functions),
	};
	return cmocka_run_group_tests(tests, set_up_bad_input, tear_down_bad_input);
}
