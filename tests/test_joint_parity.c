// SPDX-License-Identifier: MIT
// test_joint_parity.c -- checks that worlds with joints have equal bits on every device, with every number of lanes and
// threads, and after moves between devices.
#include "emulation/emulation_scenes.h"
#include "support/make_joints.h"
#include "support/scenarios.h"

static void build_scene(scree_world* world, const void* context) { ((const FormScene*)context)->build(world); }

static void act_scene(scree_world* world, int step, const void* context)
{
	const FormScene* scene = context;
	if (scene->act)
		scene->act(world, step);
}

// A wheel with three times as many joints as there are colors falls on the floor. act_wheel destroys some of the arms
// and adds others.
#define ARMS 200

static void add_arm(scree_world* world, scree_body wheel, int k)
{
	scree_rot q = scree_rot_make(6.28318531f * (float)k / (float)ARMS);
	float reach = 3.0f + 0.5f * (float)(k % 4);
	scree_body arm = add_box(world, SCREE_BODY_DYNAMIC, 0.04f, 0.04f, reach * q.c, 5.0f + reach * q.s);
	scree_joint_def def = joint_def_at(world, k % 3 ? SCREE_JOINT_WELD : SCREE_JOINT_WHEEL, k % 2 ? wheel : arm,
	                                   k % 2 ? arm : wheel, 2.0f * q.c, 5.0f + 2.0f * q.s, 0.1f * (float)k);
	add_joint(world, &def);
}

static void build_wheel(scree_world* world, const void* context)
{
	(void)context;
	add_floor(world);
	scree_body wheel = add_box(world, SCREE_BODY_DYNAMIC, 1.0f, 1.0f, 0.0f, 5.0f);
	for (int k = 0; k < ARMS; ++k)
		add_arm(world, wheel, k);
}

static void act_wheel(scree_world* world, int step, const void* context)
{
	(void)context;
	scree_body bodies[ARMS + 2];
	int count;
	OK(scree_world_get_bodies(world, bodies, ARMS + 2, &count));
	if (step % 6 == 2)
		OK(scree_bodies_destroy(world, bodies + 2 + step, 5));
	if (step % 6 == 4)
		for (int k = 0; k < 5; ++k)
			add_arm(world, bodies[1], 7 * step + k);
}

// Builds rows of bodies that fall in a heap. Joints of all types, with limits, springs and motors, join the bodies.
// Some joints break.
static void build_chains(scree_world* world, const void* context)
{
	(void)context;
	add_floor(world);
	for (int row = 0; row < 12; ++row)
	{
		scree_body before = NOBODY;
		for (int k = 0; k < 12; ++k)
		{
			float x = 0.7f * (float)k + 0.1f * (float)row, y = 0.4f + 0.5f * (float)row;
			scree_body body = add_box(world, SCREE_BODY_DYNAMIC, 0.3f, 0.15f, x, y);
			scree_joint_def def =
			    joint_def_at(world, (scree_joint_type)(1 + row % 9), before, body, x - 0.35f, y, 0.2f * (float)k);
			for (int c = 0; c < 3; ++c)
			{
				scree_joint_coordinate* at = &def.coordinates[c];
				at->limited = (k + c) % 3 == 0;
				at->lower = -0.2f;
				at->upper = 0.25f;
				at->spring = (k + c) % 4 == 1;
				at->spring_hertz = 3.0f;
				at->spring_damping_ratio = 0.3f;
				at->motor = (k + c) % 5 == 2 && !at->locked;
				at->motor_speed = 1.0f;
				at->motor_max = 3.0f;
			}
			def.can_break = k % 6 == 5;
			def.force_threshold = k % 2 ? 30.0f : 3.4e38f;
			if (k > 0 || row % 2)
				add_joint(world, &def);
			before = body;
		}
	}
}

// Changes joints, except in the steps around steps 9 and 25, before which some worlds move to another device and back.
// After a move the chains have other places in memory, although no edit has changed them.
static void act_chains(scree_world* world, int step, const void* context)
{
	(void)context;
	if ((step >= 5 && step < 12) || (step >= 22 && step < 30))
		return;
	scree_joint joints[150];
	scree_joint_state states[150];
	scree_joint_event events[150];
	int count, some;
	OK(scree_world_get_joints(world, joints, 150, &count));
	OK(scree_joints_get_states(world, joints, states, count));
	OK(scree_world_get_joint_events(world, events, 150, &some));
	// the changes below use values that are read here, so these values must also be equal on all devices
	int k = (step * 7) % count;
	OK(scree_joint_set_motor_speed(world, joints[k], SCREE_ANGLE, -states[k].values[SCREE_ANGLE]));
	scree_joint_coordinate at;
	OK(scree_joint_get_coordinate(world, joints[(k + some) % count], SCREE_ANGLE, &at));
	at.spring = !at.spring;
	at.motor = !at.motor && !at.locked;
	OK(scree_joint_set_coordinate(world, joints[(k + some) % count], SCREE_ANGLE, &at));
}

// Builds heavy carts that fall on light wheels, and ropes with heavy ends: five short ropes and two long ropes. The
// chains of the carts have two joints. They are the shortest chains, so they have the last places in memory, side by
// side.
static void build_carts(scree_world* world, const void* context)
{
	(void)context;
	add_floor(world);
	scree_attribute_def light = surface_of(circle_shape(0.15f)), heavy = surface_of(box_shape(0.5f, 0.15f));
	light.density = 0.5f;
	heavy.density = 20.0f;
	scree_attribute wheel = add_attribute(world, &light), load = add_attribute(world, &heavy);
	for (int k = 0; k < 21; ++k)
	{
		float x = 1.6f * (float)(k % 7), y = 0.5f + 0.9f * (float)(k / 7);
		scree_body cart = add_body(world, SCREE_BODY_DYNAMIC, load, x, y, 0.02f * (float)(k % 5));
		for (int side = -1; side <= 1; side += 2)
			join(world, SCREE_JOINT_REVOLUTE, cart,
			     add_body(world, SCREE_BODY_DYNAMIC, wheel, x + 0.4f * (float)side, y - 0.25f, 0.0f),
			     x + 0.4f * (float)side, y - 0.25f);
	}
	for (int k = 0; k < 7; ++k)
	{
		int links = k < 5 ? 2 : 11;
		scree_body before = NOBODY;
		for (int n = 0; n <= links; ++n)
		{
			float x = 12.0f + 0.5f * (float)n, y = 1.0f + 0.7f * (float)k;
			scree_body link = n < links ? add_box(world, SCREE_BODY_DYNAMIC, 0.2f, 0.05f, x, y)
			                            : add_body(world, SCREE_BODY_DYNAMIC, load, x + 0.4f, y, 0.0f);
			join(world, SCREE_JOINT_REVOLUTE, before, link, x - 0.25f, y);
			before = link;
		}
	}
}

// Builds five light discs, each with six arms of two heavy parts. The joints of the arms are welds, or hinges with
// limits and motors; some break. Two discs are welded together, one disc is free, and the arms of the last disc are
// joined to each other. A chain of twelve bodies hangs from the last disc.
static void build_branches(scree_world* world, const void* context)
{
	(void)context;
	add_floor(world);
	scree_body before = NOBODY;
	for (int w = 0; w < 5; ++w)
	{
		float x = 3.0f * (float)w, y = 4.0f;
		scree_attribute_def light = surface_of(circle_shape(0.15f));
		light.density = 0.3f;
		scree_body hub = add_body(world, SCREE_BODY_DYNAMIC, add_attribute(world, &light), x, y, 0.0f), ends[6];
		if (w != 3)
			join(world, SCREE_JOINT_WELD, w == 2 ? before : NOBODY, hub, x - (w == 2 ? 1.5f : 0.0f), y);
		before = hub;
		for (int k = 0; k < 6; ++k)
		{
			scree_rot q = scree_rot_make(6.28318531f * (float)k / 6.0f + 0.1f * (float)w);
			scree_body above = hub;
			for (int n = 0; n < 2; ++n)
			{
				float near = 0.15f + 0.8f * (float)n, middle = near + 0.4f;
				scree_body part = add_box(world, SCREE_BODY_DYNAMIC, 0.1f, 0.1f, x + middle * q.c, y + middle * q.s);
				scree_joint_def def =
				    joint_def_at(world, (w + k) % 3 ? SCREE_JOINT_REVOLUTE : SCREE_JOINT_WELD, k % 2 ? part : above,
				                 k % 2 ? above : part, x + near * q.c, y + near * q.s, 0.1f * (float)k);
				scree_joint_coordinate* angle = &def.coordinates[SCREE_ANGLE];
				angle->motor = w % 2 == 0 && !angle->locked;
				angle->motor_speed = 0.2f * (float)(k % 3);
				angle->motor_max = 0.5f + (float)k;
				angle->limited = k % 2 == 0 && !angle->locked;
				angle->lower = -0.1f;
				angle->upper = 0.3f;
				def.can_break = k == 5 && n == 1;
				def.force_threshold = def.can_break ? 3.0f : 3.4e38f;
				add_joint(world, &def);
				above = part;
			}
			ends[k] = above;
			if (w == 4 && k > 0)
				join(world, SCREE_JOINT_REVOLUTE, ends[k - 1], ends[k], x, y);
		}
	}
	for (int k = 0; k < 12; ++k)
	{
		scree_body part = add_box(world, SCREE_BODY_DYNAMIC, 0.15f, 0.05f, 12.3f + 0.3f * (float)k, 4.0f);
		join(world, SCREE_JOINT_REVOLUTE, before, part, 12.15f + 0.3f * (float)k, 4.0f);
		before = part;
	}
}

// Nets hang close to the floor, each from one corner. A heavy ball hangs at the opposite corner, so bodies are taut in
// some steps. act_nets destroys joints until the balls fall.
#define NET 8

static void build_nets(scree_world* world, const void* context)
{
	(void)context;
	add_floor(world);
	scree_attribute_def ball = surface_of(circle_shape(0.4f));
	ball.density = 400.0f;
	for (int n = 0; n < 3; ++n)
	{
		scree_body bodies[NET * NET];
		for (int k = 0; k < NET * NET; ++k)
		{
			float x = 6.0f * (float)n + 0.5f * (float)(k / NET), y = 5.0f - 0.5f * (float)(k % NET);
			bool loaded = k == NET * NET - 1;
			bodies[k] = loaded ? add_body(world, SCREE_BODY_DYNAMIC, add_attribute(world, &ball), x, y, 0.0f)
			                   : add_box(world, k ? SCREE_BODY_DYNAMIC : SCREE_BODY_STATIC, 0.1f, 0.1f, x, y);
			if (k % NET > 0)
				join(world, k % 5 ? SCREE_JOINT_REVOLUTE : SCREE_JOINT_WELD, bodies[k - 1], bodies[k], x, y + 0.25f);
			if (k / NET > 0)
				join(world, SCREE_JOINT_REVOLUTE, bodies[k - NET], bodies[k], x - 0.25f, y);
		}
	}
}

static void act_nets(scree_world* world, int step, const void* context)
{
	(void)context;
	scree_joint joints[6 * NET * NET];
	int count;
	OK(scree_world_get_joints(world, joints, 6 * NET * NET, &count));
	if (step > 20 && step % 4 == 0)
		OK(scree_joint_destroy(world, joints[(step * 7) % count]));
}

// Gear trains with racks and winches, ropes over pulleys, and tackles, with all kinds of drives. Ratios and bases
// change. Bodies are moved and disabled, and change their type.
#define WHEELS 9
#define ROPES  12

// Gives a coupling a lock, limits or a spring, in some cases also a motor, and thresholds. The number k selects these.
static void vary(scree_joint_def* def, int k)
{
	scree_joint_coordinate* along = def->coordinates;
	def->hertz = k % 5 == 4 ? 10.0f : 60.0f;
	along->lock_hertz = k % 7 == 6 ? 3.0f : 0.0f;
	along->locked = k % 4 < 2;
	along->limited = k % 4 == 2;
	along->lower = along->target - 0.4f;
	along->upper = along->target + 0.2f;
	along->spring = k % 4 == 3;
	along->spring_hertz = 2.0f;
	along->spring_damping_ratio = 0.2f;
	along->motor = k % 8 == 7;
	along->motor_speed = 1.0f;
	along->motor_max = 20.0f;
	def->can_break = k % 6 == 5;
	def->force_threshold = k % 6 == 5 ? 1.5f : 3.4e38f;
	def->torque_threshold = k % 3 == 2 ? 2.0f : 3.4e38f;
}

// Changes one body, `moved`: disables it if step % 6 is `first`, and in every eighth step makes it kinematic or static.
// If step % 6 is 4, enables all bodies. Two steps after each change of type, makes all bodies except the first dynamic.
static void disturb(scree_world* world, const scree_body* bodies, int count, scree_body moved, int step, int first)
{
	if (step % 6 == first)
		OK(scree_body_set_enabled(world, moved, false));
	if (step % 6 == 4)
		for (int n = 0; n < count; ++n)
			OK(scree_body_set_enabled(world, bodies[n], true));
	if (step % 8 == 3)
		OK(scree_body_set_type(world, moved, step % 16 == 3 ? SCREE_BODY_KINEMATIC : SCREE_BODY_STATIC));
	if (step % 8 == 5)
		for (int n = 1; n < count; ++n)
			OK(scree_body_set_type(world, bodies[n], SCREE_BODY_DYNAMIC));
}

static void build_couplings(scree_world* world, const void* context)
{
	(void)context;
	add_floor(world);
	scree_body last = NOBODY;
	for (int k = 0; k < WHEELS; ++k)
	{
		float x = 2.0f * (float)k, radius = k % 2 ? 0.4f : 0.7f;
		scree_body wheel = add_shape(world, SCREE_BODY_DYNAMIC, circle_shape(radius), x, 6.0f, 0.3f * (float)k);
		join(world, SCREE_JOINT_REVOLUTE, NOBODY, wheel, x, 6.0f);
		scree_joint_def gear = scree_joint_def_make(SCREE_JOINT_GEAR);
		gear.body_a = last;
		gear.body_b = wheel;
		gear.ratio = k % 2 ? -1.75f : 0.5f;
		OK(scree_joint_def_couple(world, &gear));
		vary(&gear, k + 3);
		add_joint(world, &gear);
		scree_body load = add_box(world, SCREE_BODY_DYNAMIC, 0.3f, 0.2f, x + 0.2f, 3.0f);
		scree_joint_def winch = scree_joint_def_make(SCREE_JOINT_GEAR);
		winch.body_a = k % 3 ? wheel : load;
		winch.body_b = k % 3 ? load : wheel;
		winch.ratio = k % 3 ? radius : 1.0f / radius;
		winch.sides[k % 3 ? 1 : 0].measure = k % 2 ? SCREE_MEASURE_DISTANCE : SCREE_MEASURE_TRANSLATION;
		winch.sides[k % 3 ? 1 : 0].base = (scree_pose){{x, 6.0f}, scree_rot_make(1.2f)};
		couple(world, &winch);
		last = wheel;
	}
	scree_joint_def drive = scree_joint_def_make(SCREE_JOINT_MOTOR);
	drive.body_b = last;
	drive.coordinates[SCREE_ANGLE].motor_speed = 12.0f;
	drive.coordinates[SCREE_ANGLE].motor_max = 300.0f;
	add_joint(world, &drive);
	for (int k = 0; k < ROPES; ++k)
	{
		float x = -2.0f - 2.0f * (float)k;
		scree_joint_def rope = scree_joint_def_make(SCREE_JOINT_PULLEY);
		rope.body_a = add_box(world, SCREE_BODY_DYNAMIC, 0.3f, 0.2f, x - 0.4f, 2.0f);
		rope.body_b = add_box(world, SCREE_BODY_DYNAMIC, 0.2f, 0.2f, x + 0.4f, 1.0f);
		rope.frame_a.position = (scree_vec){0.2f, 0.2f};
		rope.sides[0].base.position = (scree_vec){x - 0.6f, 6.0f};
		rope.sides[1].base.position = (scree_vec){x + 0.6f, 6.0f};
		rope.ratio = 1.0f + (float)(k % 3);
		OK(scree_joint_def_couple(world, &rope));
		vary(&rope, k);
		add_joint(world, &rope);
	}
}

static void act_couplings(scree_world* world, int step, const void* context)
{
	(void)context;
	scree_joint joints[64];
	scree_joint_state states[64];
	scree_body bodies[64];
	int count, some;
	OK(scree_world_get_joints(world, joints, 64, &count));
	OK(scree_world_get_bodies(world, bodies, 64, &some));
	OK(scree_joints_get_states(world, joints, states, count));

	// the changes below use values that are read here, so these values must also be equal on all devices
	int k = step * 7 % count;
	scree_joint_def def;
	OK(scree_joint_get_def(world, joints[k], &def));
	if (def.type == SCREE_JOINT_GEAR || def.type == SCREE_JOINT_PULLEY)
	{
		OK(scree_joint_set_ratio(world, joints[k], def.ratio + 0.01f * states[k].speeds[0]));
		def.sides[1].base.position.x += 0.001f * states[k].values[1];
		OK(scree_joint_set_bases(world, joints[k], def.sides[0].base, def.sides[1].base));
	}
	scree_body moved = bodies[1 + step * 5 % (some - 1)];
	disturb(world, bodies, some, moved, step, 1);
	if (step % 10 == 9)
	{
		scree_pose pose = pose_of(world, moved);
		pose.rotation = scree_rot_make((float)step);
		pose.position.y += 0.1f;
		OK(scree_body_set_pose(world, moved, pose));
	}
}

// Beads and wagons on paths in the world and on a turning wheel, with all kinds of drives. Paths are created and
// destroyed. Bodies are placed and disabled, and change their type. If `context` is not null, the wagons form a train,
// which is a chain, and the wheel has more beads than there are colors, so that a device solves them by launches.
#define FEW_BEADS  20
#define MANY_BEADS 80

static scree_path add_wave(scree_world* world, float x, float y, float reach, bool closed)
{
	scree_vec points[24];
	scree_path path;
	scree_path_def def = scree_path_def_default();
	for (int k = 0; k < 24; ++k)
	{
		scree_rot q = scree_rot_make(6.28318531f * (float)k / 24.0f), wave = scree_rot_make(1.3f * (float)k);
		float radius = reach + 0.2f * reach * wave.s;
		points[k] = closed ? (scree_vec){x + radius * q.c, y + radius * q.s}
		                   : (scree_vec){x + 0.5f * (float)k, y + reach * wave.s};
	}
	def.points = points;
	def.count = 24;
	def.closed = closed;
	OK(scree_path_create(world, &def, &path));
	return path;
}

// Adds a bead with a joint on a path that is fixed in body a. The number k selects lock, limits, springs, motors and
// thresholds.
static void add_bead(scree_world* world, scree_path path, scree_body a, scree_pose place, int k)
{
	float length;
	scree_pose at;
	OK(scree_path_get_length(world, path, &length));
	OK(scree_path_get_pose(world, path, length * (float)(k % 37) / 37.0f, &at));
	scree_vec r = at.position;
	scree_rot q = place.rotation;
	scree_body bead = add_box(world, SCREE_BODY_DYNAMIC, 0.1f, 0.05f, place.position.x + q.c * r.x - q.s * r.y,
	                          place.position.y + q.s * r.x + q.c * r.y);
	scree_joint_def def = scree_joint_def_make(SCREE_JOINT_PATH);
	def.body_a = a;
	def.body_b = bead;
	def.path = path;
	def.initial_along = (float)(k % 5 - 2);
	if (k % 6 == 1)
		OK(scree_joint_def_mount(world, &def, length * (float)(k % 11) / 5.0f));
	scree_joint_coordinate *along = def.coordinates, *across = along + 1, *angle = along + 2;
	angle->locked = k % 3 == 0;
	angle->spring = k % 3 == 1;
	angle->spring_hertz = 2.0f;
	angle->limited = k % 7 == 2;
	angle->lower = -0.5f;
	angle->upper = 0.25f;
	angle->motor = k % 5 == 3 && !angle->locked;
	angle->motor_max = 0.5f;
	across->lock_hertz = k % 8 == 5 ? 4.0f : 0.0f;
	across->locked = k % 9 != 4;
	across->spring = !across->locked;
	across->spring_hertz = 3.0f;
	across->target = k % 10 == 7 ? 0.2f : 0.0f;
	along->motor = k % 4 == 1 && k % 13 != 12;
	along->motor_speed = 3.0f;
	along->motor_max = 2.0f;
	along->limited = k % 4 == 2;
	along->upper = 5.0f;
	along->spring = k % 5 == 4;
	along->spring_hertz = 0.5f;
	along->locked = k % 13 == 12;
	along->target = 2.0f;
	def.can_break = k % 6 == 5;
	def.force_threshold = k % 2 ? 30.0f : 3.4e38f;
	def.torque_threshold = k % 5 == 2 ? 1.0f : 3.4e38f;
	add_joint(world, &def);
}

static void build_paths(scree_world* world, const void* context)
{
	add_floor(world);
	scree_path paths[] = {add_wave(world, 0.0f, 0.0f, 1.5f, true), add_wave(world, -8.0f, 3.0f, 1.0f, false),
	                      add_wave(world, 9.0f, 4.0f, 3.0f, true)};
	scree_body wheel = add_box(world, SCREE_BODY_DYNAMIC, 1.5f, 1.5f, 0.0f, 8.0f);
	throw_body(world, wheel, 0.5f, 1.0f, 2.0f);
	scree_pose place = {{0.0f, 8.0f}, {1.0f, 0.0f}}, world_place = {{0.0f, 0.0f}, {1.0f, 0.0f}};
	for (int k = 0; k < (context ? MANY_BEADS : FEW_BEADS); ++k)
	{
		add_bead(world, paths[0], wheel, place, k);
		add_bead(world, paths[1 + k % 2], NOBODY, world_place, k);
	}
	scree_body last = NOBODY;
	for (int k = 0; k < 12 && context; ++k)
	{
		scree_pose at;
		OK(scree_path_get_pose(world, paths[2], 0.4f * (float)k, &at));
		scree_body wagon = add_box(world, SCREE_BODY_DYNAMIC, 0.15f, 0.1f, at.position.x, at.position.y);
		OK(scree_body_set_pose(world, wagon, at));
		scree_joint_def def = scree_joint_def_make(SCREE_JOINT_PATH);
		def.body_b = wagon;
		def.path = paths[2];
		def.coordinates[SCREE_ANGLE].locked = true;
		add_joint(world, &def);
		if (k > 0)
		{
			def = scree_joint_def_make(SCREE_JOINT_DISTANCE);
			def.body_a = last;
			def.body_b = wagon;
			def.coordinates[SCREE_ALONG].target = 0.4f;
			add_joint(world, &def);
		}
		last = wagon;
	}
}

static void act_paths(scree_world* world, int step, const void* context)
{
	(void)context;
	scree_joint joints[400];
	scree_joint_state states[400];
	scree_body bodies[400];
	int count, some;
	OK(scree_world_get_joints(world, joints, 400, &count));
	OK(scree_world_get_bodies(world, bodies, 400, &some));
	OK(scree_joints_get_states(world, joints, states, count));

	// the changes below use values that are read here, so these values must also be equal on all devices
	int k = step * 17 % count;
	OK(scree_joint_set_motor_speed(world, joints[k], SCREE_ALONG, 1.0f - states[k].values[SCREE_ALONG]));
	scree_body moved = bodies[2 + step * 29 % (some - 2)];
	scree_pose pose = pose_of(world, moved);
	if (step % 5 == 1)
	{
		pose.position.x += step % 10 == 1 ? 0.3f : 3.0f;
		pose.rotation = scree_rot_make((float)step);
		OK(scree_body_set_pose(world, moved, pose));
	}
	disturb(world, bodies, some, moved, step, 2);
	if (step % 7 == 3)
		OK(scree_joint_set_frames(world, joints[k], (scree_pose){{0.1f, 0.2f}, {1.0f, 0.0f}},
		                          (scree_pose){{0.05f, 0.0f}, {1.0f, 0.0f}}));
	if (step % 9 == 4)
	{
		scree_path path = add_wave(world, 12.0f, 5.0f, 1.0f + 0.1f * (float)step, step % 2);
		for (int n = 0; n < 3; ++n)
			add_bead(world, path, NOBODY, (scree_pose){{0.0f, 0.0f}, {1.0f, 0.0f}}, step + n);
	}
	if (step % 9 == 8)
	{
		scree_path paths[32], last;
		int all, listed;
		OK(scree_world_get_paths(world, paths, 32, &all));
		last = paths[all - 1];
		OK(scree_world_get_joints(world, joints, 400, &listed));
		for (int n = 0; n < listed && all > 3; ++n)
		{
			scree_joint_def def;
			OK(scree_joint_get_def(world, joints[n], &def));
			if (scree_path_equals(def.path, last))
				OK(scree_joint_destroy(world, joints[n]));
		}
		if (all > 3)
			OK(scree_path_destroy(world, last));
	}
}

static void joints_are_equal(void** state)
{
	(void)state;
	const bool many = true;
	const FormScene *pins = form_scene("joints"), *wagons = form_scene("paths"), *hubs = form_scene("joint hubs");
	const Scenario scenarios[] = {
	    scenario_of("joints", 45, build_scene, act_scene, pins),
	    scenario_of("wagons", 45, build_scene, act_scene, wagons),
	    scenario_of("joint hubs", 30, build_scene, act_scene, hubs),
	    scenario_of("wheel", 30, build_wheel, act_wheel, NULL),
	    scenario_of("chains", 60, build_chains, act_chains, NULL),
	    scenario_of("carts", 60, build_carts, act_chains, NULL),
	    scenario_of("branches", 60, build_branches, act_chains, NULL),
	    scenario_of("nets", 60, build_nets, act_nets, NULL),
	    scenario_of("couplings", 48, build_couplings, act_couplings, NULL),
	    scenario_of("paths", 48, build_paths, act_paths, NULL),
	    scenario_of("path hubs", 30, build_paths, act_paths, &many),
	};
	print_variants();
	for (size_t k = 0; k < sizeof scenarios / sizeof *scenarios; ++k)
	{
		Scenario scenario = scenarios[k];
		scenario.substeps = scenario.build == build_chains ? 2 : SUBSTEPS;
		check_parity(&scenario, NULL);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(joints_are_equal)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
