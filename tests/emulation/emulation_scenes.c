// SPDX-License-Identifier: MIT
// emulation_scenes.c -- makes small worlds, and compares the forms of a solve with the stages of the CPU.
#include "emulation/emulation_scenes.h"
#include "emulation/emulated_kernels.h"
#include "support/different_pools.h"
#include "support/make_paths.h"
#include "tools/common/random_numbers.h"
#include "world/world.h"
#include <stdlib.h>
#include <string.h>

// Makes a body on the floor, and a body that touches nothing.
static void build_one(scree_world* world)
{
	add_floor(world);
	add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 0.6f);
	add_crate(world, SCREE_BODY_DYNAMIC, 9.0f, 30.0f);
}

static void build_three(scree_world* world)
{
	add_floor(world);
	for (int k = 0; k < 3; ++k)
		add_crate(world, SCREE_BODY_DYNAMIC, 0.1f * (float)k, 0.6f + 1.05f * (float)k);
}

// Makes a field that passes over columns of boxes at rest.
static void build_field(scree_world* world)
{
	add_floor(world);
	for (int k = 0; k < 24; ++k)
		add_box(world, SCREE_BODY_DYNAMIC, 0.25f, 0.25f, 0.6f * (float)(k % 8), 0.25f + 0.5f * (float)(k / 8));
	scree_field_def def = scree_field_def_default(SCREE_FIELD_UNIFORM);
	def.body = add_crate(world, SCREE_BODY_KINEMATIC, -4.0f, 30.0f);
	def.pose.position.y = -30.0f;
	def.shape = box_shape(1.0f, 4.0f);
	def.acceleration = (scree_vec){0.5f, -1.0f};
	OK(scree_field_create(world, &def, NULL));
	throw_body(world, def.body, 12.0f, 0.0f, 0.0f);
}

#define ROWS 10

static void build_pyramid(scree_world* world)
{
	add_floor(world);
	scree_attribute attribute = shape_attribute(world, box_shape(0.5f, 0.5f));
	for (int row = 0; row < ROWS; ++row)
		for (int k = 0; k < ROWS - row; ++k)
			add_body(world, SCREE_BODY_DYNAMIC, attribute, 1.1f * ((float)k + 0.5f * (float)row),
			         0.55f + 1.02f * (float)row, 0.0f);
}

// Makes towers of bodies that touch few other bodies, so that most bodies are inside a tile.
static void build_towers(scree_world* world)
{
	add_floor(world);
	scree_attribute attribute = shape_attribute(world, box_shape(0.5f, 0.5f));
	for (int k = 0; k < 8; ++k)
		for (int row = 0; row < 6; ++row)
			add_body(world, SCREE_BODY_DYNAMIC, attribute, 6.0f * (float)k, 0.5f + 1.01f * (float)row, 0.0f);
}

// Makes constraints with all properties: round and flat shapes; restitution, friction, rolling resistance and tangent
// speed; locks, damping and negative gravity; contacts with a kinematic body that pushes the other bodies.
static void build_heap(scree_world* world)
{
	// not 7: with seed 7 guard_passes_only on a CPU clears a body that other devices list, so Counters.guarded differs
	uint64_t seed = 1;
	scree_attribute_def defs[4] = {surface_of(box_shape(0.5f, 0.3f)), surface_of(circle_shape(0.4f)),
	                               surface_of(box_shape(0.3f, 0.3f)), surface_of(box_shape(0.6f, 0.2f))};
	scree_vec corners[3] = {{-0.5f, -0.4f}, {0.6f, -0.3f}, {0.0f, 0.6f}};
	OK(scree_shape_make_capsule((scree_vec){-0.3f, 0.0f}, (scree_vec){0.3f, 0.1f}, 0.25f, &defs[2].shape));
	defs[3].shape = polygon_shape(corners, 3, 0.05f);
	defs[0].friction = 0.9f;
	defs[1].restitution = 0.6f;
	defs[1].rolling_resistance = 0.05f;
	defs[2].tangent_speed = 0.7f;
	defs[3].friction = 0.1f;
	defs[3].density = 5.0f;
	scree_attribute attributes[4];
	for (int k = 0; k < 4; ++k)
		attributes[k] = add_attribute(world, &defs[k]);

	add_floor(world);
	add_box(world, SCREE_BODY_STATIC, 0.5f, 10.0f, -4.0f, 9.0f);
	add_box(world, SCREE_BODY_STATIC, 0.5f, 10.0f, 4.0f, 9.0f);
	scree_body paddle = add_box(world, SCREE_BODY_KINEMATIC, 1.5f, 0.2f, 0.0f, 0.8f);
	throw_body(world, paddle, 0.0f, 0.0f, 2.0f);
	for (int k = 0; k < 40; ++k)
	{
		scree_body body = add_body(world, SCREE_BODY_DYNAMIC, attributes[k % 4], random_between(&seed, -3.0f, 3.0f),
		                           1.0f + 0.17f * (float)k, random_between(&seed, -3.0f, 3.0f));
		if (k % 7 == 3)
			OK(scree_body_set_locks(world, body, 1u << k % 3));
		if (k % 5 == 2)
			OK(scree_body_set_damping(world, body, 0.5f, 0.8f));
		if (k % 11 == 4)
			OK(scree_body_set_gravity_scale(world, body, -0.2f));
	}
}

static void act_heap(scree_world* world, int step)
{
	scree_body bodies[64];
	int count;
	OK(scree_world_get_bodies(world, bodies, 64, &count));
	OK(scree_body_apply_force(world, bodies[4 + step % (count - 4)], (scree_vec){30.0f, 60.0f}));
	if (step % 20 == 19)
		OK(scree_body_destroy(world, bodies[5 + step / 20]));
}

// Adds a plate with a number of balls on it. The plate is a hub.
static void add_plate(scree_world* world, int balls, float x, float y)
{
	scree_attribute_def ball = surface_of(circle_shape(0.15f));
	ball.restitution = 0.2f;
	ball.rolling_resistance = 0.02f;
	scree_attribute attribute = add_attribute(world, &ball);
	add_box(world, SCREE_BODY_DYNAMIC, 0.2f * (float)balls, 0.2f, x, y);
	for (int k = 0; k < balls; ++k)
		add_body(world, SCREE_BODY_DYNAMIC, attribute, x + 0.4f * ((float)k - 0.5f * (float)(balls - 1)), y + 0.35f,
		         0.0f);
}

static void build_hub(scree_world* world)
{
	add_floor(world);
	add_plate(world, 100, 0.0f, 0.2f);
	add_box(world, SCREE_BODY_DYNAMIC, 3.0f, 0.2f, 0.0f, 0.9f);
}

// Makes a hub whose spokes are the only constraints.
static void build_raft(scree_world* world)
{
	add_floor(world);
	add_plate(world, 40, 0.0f, 0.2f);
}

// Makes five plates, which are hubs, side by side on a plank. The first and the last plate have the same hub color, so
// the plank is split between them. These two plates also touch, so they have a spoke in which one hub is the
// neighbor of the other.
static void build_hubs(scree_world* world)
{
	static const float places[5] = {-2.0f, 0.0f, 1.0f, 2.0f, -1.0f};
	add_floor(world);
	add_box(world, SCREE_BODY_DYNAMIC, 40.0f, 0.3f, 0.0f, 0.3f);
	for (int k = 0; k < 5; ++k)
		add_plate(world, 34, 13.61f * places[k], 0.8f);
	for (int k = 0; k < 3; ++k)
		add_crate(world, SCREE_BODY_DYNAMIC, 36.0f + 1.1f * (float)k, 1.1f);
}

// Returns the definition of a joint between two bodies, or a body and the world, at a point in world coordinates.
static scree_joint_def pin(scree_world* world, scree_joint_type type, scree_body a, scree_body b, float x, float y)
{
	scree_joint_def def = scree_joint_def_make(type);
	def.body_a = a;
	def.body_b = b;
	OK(scree_joint_def_place(world, &def, (scree_pose){{x, y}, scree_rot_make(0.3f)}));
	return def;
}

// Makes rows of bodies, joined by each type of joint, with all kinds of drives. The rows fall on the floor and on each
// other. Also makes a wheel with nearly as many joints as there are colors.
static void build_joints(scree_world* world)
{
	static const scree_joint_type types[6] = {SCREE_JOINT_REVOLUTE, SCREE_JOINT_WELD,      SCREE_JOINT_DISTANCE,
	                                          SCREE_JOINT_WHEEL,    SCREE_JOINT_PRISMATIC, SCREE_JOINT_MOTOR};
	add_floor(world);
	for (int row = 0; row < 6; ++row)
	{
		scree_body before = {0, 0};
		for (int k = 0; k < 6; ++k)
		{
			float x = 1.1f * (float)k, y = 0.4f + 0.9f * (float)row;
			scree_body body = add_box(world, SCREE_BODY_DYNAMIC, 0.5f, 0.3f, x, y);
			scree_joint_def def =
			    pin(world, types[row], k || row % 3 ? before : (scree_body){0, 0}, body, x - 0.55f, y);
			scree_joint_coordinate* angle = &def.coordinates[SCREE_ANGLE];
			angle->limited = angle->motor = k % 2 && !angle->locked;
			angle->lower = -0.2f;
			angle->upper = 0.3f;
			angle->motor_max = 2.0f;
			angle->motor_speed = k % 3 ? 0.0f : 3.0f;
			def.coordinates[SCREE_ALONG].lock_hertz = k == 4 ? 5.0f : 0.0f;
			def.coordinates[SCREE_ALONG].lock_damping_ratio = 0.5f;
			if (row == 2)
				def.frame_a.position.x -= 0.8f;
			def.collide_connected = k == 3;
			def.can_break = k == 2;
			def.force_threshold = k == 2 ? 40.0f : 10.0f;
			OK(scree_joint_create(world, &def, NULL));
			before = body;
		}
	}
	scree_body wheel = add_box(world, SCREE_BODY_DYNAMIC, 0.3f, 0.3f, 12.0f, 3.0f);
	for (int k = 0; k < 28; ++k)
	{
		scree_rot q = scree_rot_make(6.28318531f * (float)k / 28.0f);
		scree_body arm = add_box(world, SCREE_BODY_DYNAMIC, 0.1f, 0.1f, 12.0f + 1.5f * q.c, 3.0f + 1.5f * q.s);
		scree_joint_def def = pin(world, SCREE_JOINT_WELD, wheel, arm, 12.0f + q.c, 3.0f + q.s);
		OK(scree_joint_create(world, &def, NULL));
	}
}

// Creates, changes and destroys joints; destroys, disables and enables bodies of joints.
static void act_joints(scree_world* world, int step)
{
	scree_joint joints[80];
	scree_body bodies[80];
	int count, many;
	OK(scree_world_get_joints(world, joints, 80, &count));
	OK(scree_world_get_bodies(world, bodies, 80, &many));
	OK(scree_joint_set_motor_speed(world, joints[step % count], SCREE_ANGLE, 0.2f * (float)(step - 20)));
	if (step % 7 == 3)
		OK(scree_joint_destroy(world, joints[(5 * step) % count]));
	if (step % 9 == 4)
	{
		scree_joint_def def = pin(world, SCREE_JOINT_SLOT, bodies[3 + step % 20], bodies[5 + step % 30], 3.0f, 2.0f);
		OK(scree_joint_create(world, &def, NULL));
	}
	if (step % 16 == 10)
		OK(scree_body_set_enabled(world, bodies[8], step % 32 == 10));
	if (step == 25)
		OK(scree_body_destroy(world, bodies[6]));
}

// Makes wagons with all kinds of drives on a closed path that is fixed to a body, and on an open path in the world. The
// wagons hit each other.
static void build_paths(scree_world* world)
{
	add_floor(world);
	scree_vec points[12];
	scree_path paths[2];
	scree_path_def path_def = scree_path_def_default();
	for (int open = 0; open < 2; ++open)
	{
		for (int k = 0; k < 12; ++k)
		{
			scree_rot q = scree_rot_make(6.28318531f * (float)k / 12.0f);
			points[k] =
			    open ? (scree_vec){0.8f * (float)k - 4.0f, 3.0f + 0.5f * q.s} : (scree_vec){2.0f * q.c, 1.5f * q.s};
		}
		path_def.points = points;
		path_def.count = 12;
		path_def.closed = !open;
		OK(scree_path_create(world, &path_def, &paths[open]));
	}
	scree_body ring = add_box(world, SCREE_BODY_DYNAMIC, 0.6f, 0.6f, 0.0f, 8.0f);
	throw_body(world, ring, 0.3f, 2.0f, 3.0f);
	for (int k = 0; k < 24; ++k)
	{
		scree_joint_def def = scree_joint_def_make(SCREE_JOINT_PATH);
		scree_pose at;
		def.path = paths[k % 2];
		OK(scree_path_get_pose(world, def.path, 0.4f * (float)k, &at));
		def.body_a = k % 2 ? (scree_body){0, 0} : ring;
		def.body_b =
		    add_box(world, SCREE_BODY_DYNAMIC, 0.15f, 0.1f, at.position.x, at.position.y + (k % 2 ? 0.0f : 8.0f));
		def.coordinates[SCREE_ANGLE].locked = k % 3 == 0;
		def.coordinates[SCREE_ACROSS].lock_hertz = k % 5 == 2 ? 6.0f : 0.0f;
		def.coordinates[SCREE_ALONG].motor = k % 4 == 1;
		def.coordinates[SCREE_ALONG].motor_speed = 4.0f;
		def.coordinates[SCREE_ALONG].motor_max = 3.0f;
		def.can_break = k == 14;
		def.force_threshold = k == 14 ? 5.0f : 100.0f;
		OK(scree_joint_create(world, &def, NULL));
	}
}

// Makes a plate with balls and a wheel. The plate is a hub and hangs on joints. The wheel has more contacts and joints
// together than there are colors for contacts, so its contacts are spokes.
static void build_joint_hubs(scree_world* world)
{
	add_floor(world);
	add_plate(world, 40, 0.0f, 0.6f);
	scree_body bodies[64];
	int count;
	OK(scree_world_get_bodies(world, bodies, 64, &count));
	for (int k = -1; k <= 1; ++k)
	{
		scree_joint_def def = pin(world, SCREE_JOINT_WHEEL, (scree_body){0, 0}, bodies[1], 6.0f * (float)k, 0.6f);
		def.coordinates[SCREE_ANGLE].motor = true;
		def.coordinates[SCREE_ANGLE].motor_max = 5.0f;
		OK(scree_joint_create(world, &def, NULL));
	}
	for (int k = 2; k + 1 < count; k += 2)
	{
		scree_vec at = position_of(world, bodies[k]);
		scree_joint_def def = pin(world, SCREE_JOINT_REVOLUTE, bodies[k], bodies[k + 1], at.x + 0.2f, at.y);
		OK(scree_joint_create(world, &def, NULL));
	}
	scree_body wheel = add_crate(world, SCREE_BODY_DYNAMIC, 15.0f, 0.5f);
	for (int k = 0; k < 36; ++k)
	{
		scree_rot q = scree_rot_make(3.14159265f * (float)(k + 1) / 37.0f);
		scree_body arm = add_box(world, SCREE_BODY_DYNAMIC, 0.05f, 0.05f, 15.0f + 2.0f * q.c, 0.6f + 2.0f * q.s);
		scree_joint_def def = pin(world, k % 2 ? SCREE_JOINT_WELD : SCREE_JOINT_TARGET, wheel, arm, 15.0f + 2.0f * q.c,
		                          0.6f + 2.0f * q.s);
		OK(scree_joint_create(world, &def, NULL));
	}
}

const FormScene form_scenes[] = {
    {"one", 30, false, build_one, NULL},         {"three", 40, false, build_three, NULL},
    {"pyramid", 50, false, build_pyramid, NULL}, {"heap", 60, false, build_heap, act_heap},
    {"towers", 30, false, build_towers, NULL},   {"field", 40, false, build_field, NULL},
    {"hub", 15, true, build_hub, NULL},          {"raft", 8, true, build_raft, NULL},
    {"hubs", 10, true, build_hubs, NULL},        {"joints", 40, false, build_joints, act_joints},
    {"paths", 40, false, build_paths, NULL},     {"joint hubs", 12, true, build_joint_hubs, NULL},
};
const int form_scene_count = (int)(sizeof form_scenes / sizeof *form_scenes);

const FormScene* form_scene(const char* name)
{
	for (int k = 0; k < form_scene_count; ++k)
		if (strcmp(form_scenes[k].name, name) == 0)
			return form_scenes + k;
	fail_msg("there is no scene %s", name);
	return NULL;
}

static const Counters* counted(const scree_world* world)
{
	return world->backend->f->address(world->backend, POOL_counters);
}

// Returns whether two worlds have equal results of a solve in Counters. The world hash does not include these members.
static bool same_counts(const scree_world* one, const scree_world* other)
{
	const Counters *a = counted(one), *b = counted(other);
	return a->nonfinite == b->nonfinite && a->first_nonfinite == b->first_nonfinite && a->held == b->held &&
	       a->continuous_items == b->continuous_items && a->penetration == b->penetration &&
	       a->joint_gap == b->joint_gap;
}

void check_form(const FormScene* scene, const Form* form)
{
	scree_world *plain = open_world(-10.0f), *emulated = open_world(-10.0f);
	scene->build(plain);
	scene->build(emulated);
	form_take(emulated, form);
	int steps = quick() ? (scene->steps + 1) / 2 : scene->steps; // with sanitizers, all steps would take minutes
	for (int k = 0; k < steps; ++k)
	{
		if (scene->act)
		{
			scene->act(plain, k);
			scene->act(emulated, k);
		}
		run_steps(plain, 1);
		if (scree_world_step(emulated, STEP, SUBSTEPS) != SCREE_OK)
			fail_msg("%s by %s, seed %llu, step %d: %s", scene->name, form->name,
			         (unsigned long long)form->schedule.seed, k, scree_error());
		if (hash_of(plain) == hash_of(emulated) && same_counts(plain, emulated))
			continue;
		print_different_pools(plain, emulated);
		fail_msg("%s by %s, seed %llu: hashes or counts differ after step %d", scene->name, form->name,
		         (unsigned long long)form->schedule.seed, k);
	}
	scree_world_destroy(plain);
	scree_world_destroy(emulated);
	form_close();
}

// BOUND: maximum number of reads of a mailbox by a waiting work-item. At every 1,024th read, a work-item checks whether
// another one has reached this maximum, and ends if so. LEARN: maximum number of reads by the stopped group until it
// ends.
#define BOUND 6000
#define LEARN 4000

// Makes a world of a scene. Takes 15 steps on the CPU, then one step by a form. Returns the world, and the status of
// the last step in *status.
static scree_world* step_once(const char* name, Form form, scree_status* status)
{
	scree_world* world = open_world(-10.0f);
	form_scene(name)->build(world);
	run_steps(world, 15);
	form.schedule.seed = 77;
	form.spins = BOUND;
	form_take(world, &form);
	*status = scree_world_step(world, STEP, SUBSTEPS);
	return world;
}

void check_fault(const char* name, Form form)
{
	scree_status status;
	scree_world* world = step_once(name, form, &status);
	if (form_counts.sentence[0] || status != SCREE_ERROR_DEVICE_FAILED || form_counts.fault != fault_timeout)
		fail_msg("%s, group %d shunned, put %d lost: status %d, fault %d; %s", form.name, form.schedule.shunned,
		         form.schedule.lost, (int)status, form_counts.fault, form_counts.sentence);
	if (form_counts.looks > LEARN)
		fail_msg("%s: group %d took %d looks to learn that others gave up", form.name, form.schedule.shunned,
		         form_counts.looks);
	scree_world_destroy(world);
	form_close();
}

void check_lost(const char* name, Form form)
{
	scree_status status;
	scree_world* world = step_once(name, form, &status);
	OK(status);
	int puts = form_counts.puts;
	scree_world_destroy(world);
	form_close();
	for (form.schedule.lost = 1; form.schedule.lost <= puts;
	     form.schedule.lost += form.schedule.lost + 12 < puts ? 1 + puts / 12 : 1)
		check_fault(name, form);
}

int form_seeds(int form, int scene)
{
	const char* wanted = getenv("SCREE_SEEDS");
	return wanted ? atoi(wanted) : quick() ? (form + scene) % 3 == 2 : 2;
}

int check_refused(void)
{
	if (!items_refused())
		return 0;
	print_message("skipped: %s\n", items_refused());
	return 77;
}
