// SPDX-License-Identifier: MIT
// support.c -- helpers for tests of whole worlds: short functions that build one, and runs compared step by step.
#include "support.h"
#include "platform/processor.h"
#include "world/world.h"
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

bool quick(void)
{
	const char* value = getenv("SCREE_QUICK");
	return value && strcmp(value, "1") == 0;
}

void skip_if_quick(void)
{
	if (!quick())
		return;
	print_message("skipped: long, and run by the release build\n");
	skip();
}

void check_ok(scree_status status, const char* call, const char* file, int line)
{
	if (status == SCREE_OK)
		return;
	print_error("%s\n%s: %s\n", call, scree_status_name(status), scree_error());
	_fail(file, line);
}

void check_near(double value, double expected, double tolerance, const char* what, const char* file, int line)
{
	if (fabs(value - expected) <= tolerance)
		return;
	print_error("%s is %.9g, must be %.9g within %.3g\n", what, value, expected, tolerance);
	_fail(file, line);
}

int allocations_left;

static void* counting_allocate(size_t bytes, size_t alignment, void* context)
{
	(void)context;
	if (allocations_left == 0)
		return NULL;
	allocations_left -= allocations_left > 0;
	return aligned_alloc(alignment, bytes);
}

static void plain_release(void* memory, void* context)
{
	(void)context;
	free(memory);
}

void count_allocations(void)
{
	const scree_hooks hooks = {.allocate = counting_allocate, .release = plain_release};
	allocations_left = -1;
	OK(scree_hooks_set(&hooks));
}

void end_of_shortage(scree_status status)
{
	assert_int_equal(status, SCREE_ERROR_OUT_OF_MEMORY);
	assert_non_null(strstr(scree_error(), "memory"));
	allocations_left = -1;
}

int warnings;
char warning[256];

static void note_warning(scree_log_level level, const char* sentence, void* context)
{
	(void)context;
	if (level != SCREE_LOG_WARNING)
		return;
	++warnings;
	snprintf(warning, sizeof warning, "%s", sentence);
}

int set_warnings(void** state)
{
	(void)state;
	const scree_hooks hooks = {.log = note_warning};
	warnings = 0;
	return scree_hooks_set(&hooks);
}

int reset_warnings(void** state)
{
	(void)state;
	return scree_hooks_set(NULL);
}

uint64_t random_word(uint64_t* seed) // xorshift64*, George Marsaglia and Sebastiano Vigna; seed is not 0
{
	*seed ^= *seed >> 12;
	*seed ^= *seed << 25;
	*seed ^= *seed >> 27;
	return *seed * 0x2545f4914f6cdd1du;
}

float random_between(uint64_t* seed, float low, float high)
{
	// 24 bits are a float exactly
	return low + (high - low) * ((float)(random_word(seed) >> 40) / 16777216.0f);
}

int random_below(uint64_t* seed, int count) { return (int)(random_word(seed) % (uint64_t)count); }

uint64_t hash_more(uint64_t hash, const void* bytes, size_t count)
{
	for (size_t k = 0; k < count; ++k)
		hash = (hash ^ ((const unsigned char*)bytes)[k]) * 0x100000001b3u;
	return hash;
}

// ---------------------------------------------------------------------------------------------------------------
// worlds on the CPU
// ---------------------------------------------------------------------------------------------------------------

scree_world* open_world(float gravity_y)
{
	scree_world_def def = scree_world_def_default();
	def.device = "cpu";
	def.threads = 1;
	def.gravity.y = gravity_y;
	scree_world* world;
	OK(scree_world_create(&def, &world));
	return world;
}

void run_steps(scree_world* world, int steps)
{
	for (int k = 0; k < steps; ++k)
		OK(scree_world_step(world, STEP, SUBSTEPS));
}

scree_attribute_def surface_of(scree_shape shape)
{
	scree_attribute_def def = scree_attribute_def_default();
	def.shape = shape;
	return def;
}

scree_attribute add_attribute(scree_world* world, const scree_attribute_def* def)
{
	scree_attribute attribute;
	OK(scree_attribute_create(world, def, &attribute));
	return attribute;
}

scree_shape box_shape(float half_width, float half_height)
{
	scree_shape shape;
	OK(scree_shape_make_box(half_width, half_height, &shape));
	return shape;
}

scree_shape circle_shape(float radius)
{
	scree_shape shape;
	OK(scree_shape_make_circle((scree_vec){0.0f, 0.0f}, radius, &shape));
	return shape;
}

scree_body add_body(scree_world* world, scree_body_type type, scree_attribute attribute, float x, float y,
                    float radians)
{
	scree_body_def def = scree_body_def_default();
	def.type = type;
	def.pose.position = (scree_vec){x, y};
	def.pose.rotation = scree_rot_make(radians);
	def.attribute = attribute;
	scree_body body;
	OK(scree_body_create(world, &def, &body));
	return body;
}

scree_body add_box(scree_world* world, scree_body_type type, float half_width, float half_height, float x, float y)
{
	scree_attribute_def def = surface_of(box_shape(half_width, half_height));
	return add_body(world, type, add_attribute(world, &def), x, y, 0.0f);
}

scree_body add_floor(scree_world* world) { return add_box(world, SCREE_BODY_STATIC, 100.0f, 1.0f, 0.0f, -1.0f); }

scree_vec position_of(scree_world* world, scree_body body)
{
	scree_pose pose;
	OK(scree_body_get_pose(world, body, &pose));
	return pose.position;
}

float angle_of(scree_world* world, scree_body body)
{
	scree_pose pose;
	OK(scree_body_get_pose(world, body, &pose));
	return scree_rot_get_angle(pose.rotation);
}

scree_velocity velocity_of(scree_world* world, scree_body body)
{
	scree_velocity velocity;
	OK(scree_body_get_velocity(world, body, &velocity));
	return velocity;
}

uint64_t hash_of(scree_world* world)
{
	uint64_t hash;
	OK(scree_world_get_hash(world, &hash));
	return hash;
}

scree_counters counters_of(scree_world* world)
{
	scree_counters counters;
	OK(scree_world_get_counters(world, &counters));
	return counters;
}

float deepest_of(scree_world* world, int steps)
{
	float deepest = 0.0f;
	for (int k = 0; k < steps; ++k)
	{
		run_steps(world, 1);
		float depth = counters_of(world).penetration;
		deepest = depth > deepest ? depth : deepest;
	}
	return deepest;
}

Momentum momentum_of(scree_world* world, const scree_body* bodies, int count)
{
	Momentum sum = {0};
	for (int k = 0; k < count; ++k)
	{
		scree_mass mass;
		OK(scree_body_get_mass(world, bodies[k], &mass));
		scree_pose pose;
		OK(scree_body_get_pose(world, bodies[k], &pose));
		scree_rot q = pose.rotation;
		double x = pose.position.x + q.c * mass.center.x - q.s * mass.center.y;
		double y = pose.position.y + q.s * mass.center.x + q.c * mass.center.y;
		scree_velocity v = velocity_of(world, bodies[k]);
		double vx = v.linear.x, vy = v.linear.y, w = v.angular;
		sum.x += mass.mass * vx;
		sum.y += mass.mass * vy;
		sum.spin += mass.mass * (x * vy - y * vx) + mass.inertia * w;
		sum.size += mass.mass * hypot(vx, vy);
		sum.energy += 0.5 * mass.mass * (vx * vx + vy * vy) + 0.5 * mass.inertia * w * w;
	}
	return sum;
}

int read_contacts(scree_world* world, scree_contact** contacts)
{
	int count;
	OK(scree_world_get_contacts(world, NULL, 0, &count));
	*contacts = calloc((size_t)count + 1, sizeof **contacts);
	assert_non_null(*contacts);
	OK(scree_world_get_contacts(world, *contacts, count, &count));
	return count;
}

void check_finite(scree_world* world)
{
	int count;
	OK(scree_world_get_bodies(world, NULL, 0, &count));
	scree_body* bodies = calloc((size_t)count + 1, sizeof *bodies);
	scree_pose* poses = calloc((size_t)count + 1, sizeof *poses);
	scree_velocity* velocities = calloc((size_t)count + 1, sizeof *velocities);
	OK(scree_world_get_bodies(world, bodies, count, &count));
	OK(scree_bodies_get_poses(world, bodies, poses, count));
	OK(scree_bodies_get_velocities(world, bodies, velocities, count));
	for (int k = 0; k < count; ++k)
	{
		scree_pose p = poses[k];
		scree_velocity v = velocities[k];
		if (!isfinite(p.position.x + p.position.y + p.rotation.c + p.rotation.s) ||
		    !isfinite(v.linear.x + v.linear.y + v.angular))
			fail_msg("body %u is not finite", bodies[k].index);
		double length = (double)p.rotation.c * p.rotation.c + (double)p.rotation.s * p.rotation.s;
		NEAR(length, 1.0, 1e-6);
	}
	free(bodies);
	free(poses);
	free(velocities);
}

// ---------------------------------------------------------------------------------------------------------------
// the same run on many devices
// ---------------------------------------------------------------------------------------------------------------

static int add_way(Way ways[MAX_WAYS], int count, const char* device, int threads, int lanes, const char* persistent,
                   const char* solver)
{
	if (count == MAX_WAYS)
		return count;
	Way* way = ways + count;
	*way = (Way){.threads = threads, .lanes = lanes, .persistent = persistent, .solver = solver};
	snprintf(way->device, sizeof way->device, "%.127s", device);
	if (threads > 0)
		snprintf(way->name, sizeof way->name, "%d thread%s, %d lane%s", threads, threads > 1 ? "s" : "", lanes,
		         lanes > 1 ? "s" : "");
	else
		snprintf(way->name, sizeof way->name, "%.127s, solver: %s", device, solver ? solver : "launches");
	return count + 1;
}

static int add_moving_way(Way ways[MAX_WAYS], int count, const char* device)
{
	if (count == MAX_WAYS)
		return count;
	Way* way = ways + count;
	*way = (Way){.device = "cpu", .threads = 2};
	snprintf(way->other, sizeof way->other, "%.127s", device);
	snprintf(way->name, sizeof way->name, "between cpu and %.127s", device);
	return count + 1;
}

int list_ways(Way ways[MAX_WAYS])
{
	int count = 0;
	for (int threads = 1; threads <= 2; ++threads)
		for (int lanes = 1; lanes <= 16; lanes *= 2)
			if (lanes != 2 && processor_has_lanes(lanes) && !(quick() && threads == 1 && lanes > 1))
				count = add_way(ways, count, "cpu", threads, lanes, NULL, NULL);

	scree_device devices[MAX_WAYS];
	int found;
	OK(scree_devices_get(devices, MAX_WAYS, &found));
	for (int k = 0; k < found && k < MAX_WAYS; ++k)
	{
		if (strcmp(devices[k].name, "cpu") == 0 || !devices[k].equal_bits)
			continue;
		count = add_way(ways, count, devices[k].name, 0, 0, "0", NULL);
		count = add_way(ways, count, devices[k].name, 0, 0, "1", "relay");
		count = add_way(ways, count, devices[k].name, 0, 0, "1", "tiles");
		count = add_moving_way(ways, count, devices[k].name);
	}
	return count;
}

void print_ways(const Way* ways, int count)
{
	for (int k = 0; k < count; ++k)
		print_message("way %d: %s\n", k, ways[k].name);
	if (scree_opencl_hint()[0])
		print_message("no OpenCL: %s\n", scree_opencl_hint());
}

scree_world* open_on(const Way* way, const scree_world_def* given)
{
	scree_world_def def = *given;
	def.device = way->device;
	def.threads = way->threads;
	def.lanes = way->lanes;
	if (way->persistent)
		setenv("SCREE_PERSISTENT", way->persistent, 1);
	if (way->solver)
		setenv("SCREE_SOLVER", way->solver, 1);
	scree_world* world;
	scree_status status = scree_world_create(&def, &world);
	unsetenv("SCREE_PERSISTENT");
	unsetenv("SCREE_SOLVER");
	if (status != SCREE_OK)
		fail_msg("%s: %s", way->name, scree_error());
	return world;
}

static scree_world* open_story(const Story* story, const Way* way)
{
	scree_world* world = open_on(way, &story->def);
	story->build(world, story->context);
	return world;
}

static void tell_step(const Story* story, scree_world* world, int step, const Way* way)
{
	if (story->act)
		story->act(world, step, story->context);
	// the changes that the story has just made are still pending
	if (way->other[0] && step % 40 == 9)
		OK(scree_world_move(world, way->other));
	if (way->other[0] && step % 40 == 25)
		OK(scree_world_move(world, way->device));
	OK(scree_world_step(world, story->dt, story->substeps));
}

void tell(const Story* story, const Way* way, uint64_t* hashes, scree_counters* last)
{
	scree_world* world = open_story(story, way);
	for (int k = 0; k < story->steps; ++k)
	{
		tell_step(story, world, k, way);
		hashes[k] = hash_of(world);
	}
	if (last)
		*last = counters_of(world);
	check_finite(world);
	scree_world_destroy(world);
}

// number of items of a pool that are in use
static int items_in_use(const scree_world* world, Per per)
{
	const Counters* c = &world->pipeline.counters;
	switch (per)
	{
	case PER_ATTRIBUTE:
		return world->attribute_slots.used;
	case PER_COLLIDABLE:
		return world->collidables.used;
	case PER_BODY:
		return world->bodies.used;
	case PER_CONTACT:
		return c->contacts;
	case PER_CONTACT_PLACE:
		return c->layout[CONSTRAINT_CONTACT].begin[COLORS + 1];
	case PER_CONTACT_BLOCK:
		return c->layout[CONSTRAINT_CONTACT].begin[COLORS + 1] / MAX_LANES;
	case PER_JOINT:
		return c->joints;
	case PER_JOINT_PLACE:
		return c->layout[CONSTRAINT_JOINT].begin[COLORS + 1];
	case PER_JOINT_BLOCK:
		return c->layout[CONSTRAINT_JOINT].begin[COLORS + 1] / MAX_LANES;
	default:
		return 0; // scratch, and trees, which devices may build as they like
	}
}

void print_different_pools(scree_world* a, scree_world* b)
{
	for (int pool = 0; pool < POOL_COUNT; ++pool)
	{
		int count = items_in_use(a, pool_info[pool].per), other = items_in_use(b, pool_info[pool].per);
		if (count != other)
		{
			print_message("pool %s: %d items, and %d\n", pool_info[pool].name, count, other);
			continue;
		}
		size_t bytes = pool_info[pool].bytes;
		char* items_a = calloc((size_t)count + 1, bytes);
		char* items_b = calloc((size_t)count + 1, bytes);
		OK(a->backend->f->read(a->backend, (PoolId)pool, 0, count, items_a));
		OK(b->backend->f->read(b->backend, (PoolId)pool, 0, count, items_b));
		int different = 0, first = -1;
		for (int k = 0; k < count; ++k)
		{
			if (memcmp(items_a + (size_t)k * bytes, items_b + (size_t)k * bytes, bytes) == 0)
				continue;
			first = different++ == 0 ? k : first;
		}
		if (different > 0)
		{
			print_message("pool %s: %d of %d items differ, the first is %d:", pool_info[pool].name, different, count,
			              first);
			for (size_t word = 0; word + 4 <= bytes && word < 64; word += 4)
			{
				uint32_t x, y;
				memcpy(&x, items_a + (size_t)first * bytes + word, 4);
				memcpy(&y, items_b + (size_t)first * bytes + word, 4);
				print_message(x == y ? " %08x" : " %08x|%08x", x, y);
			}
			print_message("\n");
		}
		free(items_a);
		free(items_b);
	}
}

// Runs two stories side by side up to the first step that differs, and fails.
static void fail_different(const Story* story_a, const Way* way_a, const Story* story_b, const Way* way_b)
{
	scree_world* a = open_story(story_a, way_a);
	scree_world* b = open_story(story_b, way_b);
	for (int k = 0; k < story_a->steps; ++k)
	{
		tell_step(story_a, a, k, way_a);
		tell_step(story_b, b, k, way_b);
		if (hash_of(a) == hash_of(b))
			continue;
		print_message("%s, step %d: %s | %s\n", story_a->name, k, way_a->name, way_b->name);
		print_different_pools(a, b);
		fail_msg("%s: %s and %s differ from step %d on", story_a->name, way_a->name, way_b->name, k);
	}
	fail_msg("%s: %s and %s differed, and do not when told again", story_a->name, way_a->name, way_b->name);
}

bool way_has_turn(const Way* ways, int count, int k, int turn)
{
	int first = 0;
	while (first < count && ways[first].threads > 0 && !ways[first].other[0])
		++first;
	return !quick() || k < first || k - first == turn % (count - first);
}

uint64_t check_parity(const Story* story, const Way* ways, int count, scree_counters* last)
{
	static int turn;
	size_t bytes = (size_t)story->steps * sizeof(uint64_t);
	uint64_t* expected = malloc(bytes);
	uint64_t* hashes = malloc(bytes);
	for (int k = 0; k < count; ++k)
	{
		if (!way_has_turn(ways, count, k, turn))
			continue;
		tell(story, ways + k, k == 0 ? expected : hashes, k == 0 ? last : NULL);
		if (k > 0 && memcmp(hashes, expected, bytes) != 0)
			fail_different(story, ways, story, ways + k);
	}
	++turn;
	uint64_t hash = expected[story->steps - 1];
	free(expected);
	free(hashes);
	return hash;
}

void check_same(const Story* a, const Story* b, const Way* way)
{
	size_t bytes = (size_t)a->steps * sizeof(uint64_t);
	uint64_t* expected = malloc(bytes);
	uint64_t* hashes = malloc(bytes);
	tell(a, way, expected, NULL);
	tell(b, way, hashes, NULL);
	if (memcmp(hashes, expected, bytes) != 0)
		fail_different(a, way, b, way);
	free(expected);
	free(hashes);
}
