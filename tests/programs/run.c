// SPDX-License-Identifier: MIT
// run.c -- the calls of a program on two worlds side by side: equal statuses, equal answers, equal hashes, or it differs.
#include "programs/program.h"
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

// numbers that a program may give out
#define MOST_NAMES 8192

struct Names
{
	scree_body bodies[MOST_NAMES];
	scree_collidable collidables[MOST_NAMES];
	scree_attribute attributes[MOST_NAMES];
};

typedef struct // what a call left
{
	scree_status status;
	uint64_t word; // of what it read
	char error[256];
} Left;

// ---------------------------------------------------------------------------------------------------------------
// arguments
// ---------------------------------------------------------------------------------------------------------------

typedef struct // a call on one of the worlds
{
	const Call* call;
	scree_world* world;
	struct Names* names;
	const Place* place;
	const char* home; // where the world was made
	Left* left;
} Turn;

static float real(const Turn* t, const char* name) { return call_value(t->call, name); }

static int whole(const Turn* t, const char* name)
{
	float x = real(t, name);
	return x > -1e6f && x < 1e6f ? (int)x : 0;
}

static scree_vec vec(const Turn* t, const char* x, const char* y) { return (scree_vec){real(t, x), real(t, y)}; }

static scree_body body_of(const Turn* t, int k)
{
	return k >= 0 && k < MOST_NAMES ? t->names->bodies[k] : (scree_body){0, 0};
}

static scree_attribute attribute_of(const Turn* t)
{
	int k = whole(t, "attribute");
	return k >= 0 && k < MOST_NAMES ? t->names->attributes[k] : (scree_attribute){0, 0};
}

static scree_pose pose_of(const Turn* t) { return (scree_pose){vec(t, "x", "y"), scree_make_rot(real(t, "angle"))}; }

static scree_filter filter_of(const Turn* t)
{
	int mask = whole(t, "mask");
	return (scree_filter){(uint64_t)whole(t, "category"), (uint64_t)(int64_t)mask, whole(t, "group")};
}

// A number's collidable, or that one of a body's list.
static scree_collidable collidable_of(const Turn* t)
{
	int k = whole(t, "collidable"), count = 0, which = whole(t, "which");
	if (k >= 0)
		return k < MOST_NAMES ? t->names->collidables[k] : (scree_collidable){0, 0};
	scree_collidable list[64];
	scree_body body = body_of(t, whole(t, "body"));
	if (scree_get_collidables(t->world, body, list, 64, &count) != SCREE_OK || count == 0)
		return (scree_collidable){0, 0};
	count = count < 64 ? count : 64;
	return list[((which % count) + count) % count];
}

// ---------------------------------------------------------------------------------------------------------------
// attributes
// ---------------------------------------------------------------------------------------------------------------

static scree_status make_polygon(const Turn* t, scree_shape* shape)
{
	scree_vec corners[16];
	int count = whole(t, "corners");
	count = count < 0 ? 0 : count > 16 ? 16 : count;
	for (int k = 0; k < count; ++k)
	{
		scree_rot q = scree_make_rot(real(t, "angle") + 6.28318531f * (float)k / (float)count);
		corners[k] = (scree_vec){0.5f * real(t, "width") * q.c, 0.5f * real(t, "height") * q.s};
	}
	return scree_make_polygon(corners, count, real(t, "radius"), shape);
}

static scree_status make_hull(const Turn* t, scree_shape* shape)
{
	scree_vec points[64];
	int count = whole(t, "points");
	count = count < 0 ? 0 : count > 64 ? 64 : count;
	uint32_t x = (uint32_t)whole(t, "seed") + 1u;
	for (int k = 0; k < count; ++k)
	{
		float two[2];
		for (int i = 0; i < 2; ++i)
		{
			x = x * 1664525u + 1013904223u; // Donald Knuth, H. W. Lewis
			two[i] = real(t, "size") * ((float)(x >> 16) / 65536.0f - 0.5f);
		}
		points[k] = (scree_vec){two[0], two[1]};
	}
	return scree_make_hull(points, count, real(t, "radius"), shape);
}

static scree_status make_shape(const Turn* t, scree_shape* shape)
{
	switch (t->call->kind)
	{
	case CALL_box:
		return scree_make_box(0.5f * real(t, "width"), 0.5f * real(t, "height"), shape);
	case CALL_circle:
		return scree_make_circle(vec(t, "x", "y"), real(t, "radius"), shape);
	case CALL_capsule:
		return scree_make_capsule(vec(t, "x", "y"), vec(t, "x2", "y2"), real(t, "radius"), shape);
	case CALL_segment:
		return scree_make_segment(vec(t, "x", "y"), vec(t, "x2", "y2"), shape);
	case CALL_polygon:
		return make_polygon(t, shape);
	default:
		return make_hull(t, shape);
	}
}

static scree_status run_attribute(const Turn* t)
{
	scree_attribute_def def = scree_default_attribute_def();
	scree_attribute made = {0, 0};
	scree_status status = make_shape(t, &def.shape);
	def.density = real(t, "density");
	def.friction = real(t, "friction");
	def.restitution = real(t, "restitution");
	def.rolling_resistance = real(t, "rolling");
	def.tangent_speed = real(t, "tangent");
	if (status == SCREE_OK)
		status = scree_create_attribute(t->world, &def, &made);
	int k = whole(t, "attribute");
	if (status == SCREE_OK && k >= 0 && k < MOST_NAMES)
		t->names->attributes[k] = made;
	return status;
}

// ---------------------------------------------------------------------------------------------------------------
// bodies and collidables
// ---------------------------------------------------------------------------------------------------------------

static scree_status run_body(const Turn* t)
{
	scree_body_def def = scree_default_body_def();
	def.type = (scree_body_type)whole(t, "type");
	def.pose = pose_of(t);
	def.velocity = (scree_velocity){vec(t, "vx", "vy"), real(t, "w")};
	def.gravity_scale = real(t, "gravity");
	def.linear_damping = real(t, "linear");
	def.angular_damping = real(t, "angular");
	def.locks = (uint32_t)whole(t, "locks");
	def.filter = filter_of(t);
	if (real(t, "attribute") >= 0.0f)
		def.attribute = attribute_of(t);
	scree_body made = {0, 0};
	scree_status status = scree_create_body(t->world, &def, &made);
	int k = whole(t, "body");
	if (status == SCREE_OK && k >= 0 && k < MOST_NAMES)
		t->names->bodies[k] = made;
	return status;
}

#define MOST_BATCH 256
static int batch_count(const Turn* t)
{
	int count = whole(t, "count"), first = whole(t, "body");
	count = count < MOST_BATCH ? count : MOST_BATCH;
	return first < 0 || first + count > MOST_NAMES ? 0 : count;
}

static scree_status run_bodies(const Turn* t)
{
	scree_body_def defs[MOST_BATCH];
	int count = batch_count(t), columns = whole(t, "columns"), first = whole(t, "body");
	columns = columns > 0 ? columns : 1;
	for (int k = 0; k < count; ++k)
	{
		defs[k] = scree_default_body_def();
		defs[k].type = (scree_body_type)whole(t, "type");
		defs[k].attribute = attribute_of(t);
		defs[k].pose.position.x = real(t, "x") + (float)(k % columns) * real(t, "dx");
		defs[k].pose.position.y = real(t, "y") + (float)(k / columns) * real(t, "dy");
		defs[k].velocity = (scree_velocity){vec(t, "vx", "vy"), real(t, "w")};
	}
	return scree_create_bodies(t->world, defs, count, t->names->bodies + (count > 0 ? first : 0));
}

static scree_status run_destroy(const Turn* t)
{
	int first = whole(t, "body");
	if (whole(t, "count") == 0)
		return scree_destroy_body(t->world, body_of(t, first));
	int count = batch_count(t);
	return scree_destroy_bodies(t->world, t->names->bodies + (count > 0 ? first : 0), count);
}

static scree_status run_collidable(const Turn* t)
{
	scree_collidable_def def = scree_default_collidable_def();
	scree_collidable made = {0, 0};
	def.attribute = attribute_of(t);
	if (real(t, "body") >= 0.0f)
		def.body = body_of(t, whole(t, "body"));
	def.pose = pose_of(t);
	def.filter = filter_of(t);
	scree_status status = scree_create_collidable(t->world, &def, &made);
	int k = whole(t, "collidable");
	if (status == SCREE_OK && k >= 0 && k < MOST_NAMES)
		t->names->collidables[k] = made;
	return status;
}

static scree_status run_place(const Turn* t)
{
	int k = whole(t, "collidable");
	scree_collidable collidable = k >= 0 && k < MOST_NAMES ? t->names->collidables[k] : (scree_collidable){0, 0};
	scree_pose pose = pose_of(t);
	return scree_set_collidable_poses(t->world, &collidable, &pose, 1);
}

// ---------------------------------------------------------------------------------------------------------------
// motion and settings
// ---------------------------------------------------------------------------------------------------------------

typedef struct // the same value for each of a batch
{
	scree_body bodies[MOST_BATCH];
	scree_vec vectors[MOST_BATCH], points[MOST_BATCH];
	float numbers[MOST_BATCH];
	scree_velocity velocities[MOST_BATCH];
	scree_pose poses[MOST_BATCH];
} Batch;

static scree_status run_batch(const Turn* t)
{
	static Batch b;
	CallKind kind = t->call->kind;
	int count = batch_count(t), first = whole(t, "body");
	bool at = kind == CALL_force_at || kind == CALL_impulse_at;
	bool number = kind == CALL_torque || kind == CALL_angular_impulse;
	for (int k = 0; k < count; ++k)
	{
		b.bodies[k] = body_of(t, first + k);
		b.numbers[k] = real(t, "x");
		b.vectors[k] = number ? (scree_vec){0} : vec(t, "x", "y");
		b.points[k] = at ? vec(t, "at_x", "at_y") : (scree_vec){0};
		if (kind == CALL_velocity)
			b.velocities[k] = (scree_velocity){vec(t, "x", "y"), real(t, "w")};
		if (kind == CALL_pose)
			b.poses[k] = pose_of(t);
	}
	switch (kind)
	{
	case CALL_force:
		return scree_apply_forces(t->world, b.bodies, b.vectors, count);
	case CALL_force_at:
		return scree_apply_forces_at(t->world, b.bodies, b.vectors, b.points, count);
	case CALL_torque:
		return scree_apply_torques(t->world, b.bodies, b.numbers, count);
	case CALL_impulse:
		return scree_apply_impulses(t->world, b.bodies, b.vectors, count);
	case CALL_impulse_at:
		return scree_apply_impulses_at(t->world, b.bodies, b.vectors, b.points, count);
	case CALL_angular_impulse:
		return scree_apply_angular_impulses(t->world, b.bodies, b.numbers, count);
	case CALL_velocity:
		return scree_set_velocities(t->world, b.bodies, b.velocities, count);
	default:
		return scree_set_poses(t->world, b.bodies, b.poses, count);
	}
}

static scree_status run_motion(const Turn* t)
{
	scree_body body = body_of(t, whole(t, "body"));
	if (whole(t, "count") != 0)
		return run_batch(t);
	switch (t->call->kind)
	{
	case CALL_force:
		return scree_body_apply_force(t->world, body, vec(t, "x", "y"));
	case CALL_force_at:
		return scree_body_apply_force_at(t->world, body, vec(t, "x", "y"), vec(t, "at_x", "at_y"));
	case CALL_torque:
		return scree_body_apply_torque(t->world, body, real(t, "x"));
	case CALL_impulse:
		return scree_body_apply_impulse(t->world, body, vec(t, "x", "y"));
	case CALL_impulse_at:
		return scree_body_apply_impulse_at(t->world, body, vec(t, "x", "y"), vec(t, "at_x", "at_y"));
	case CALL_angular_impulse:
		return scree_body_apply_angular_impulse(t->world, body, real(t, "x"));
	case CALL_velocity:
		return scree_body_set_velocity(t->world, body, (scree_velocity){vec(t, "x", "y"), real(t, "w")});
	default:
		return scree_body_set_pose(t->world, body, pose_of(t));
	}
}

static scree_status run_setting(const Turn* t)
{
	scree_body body = body_of(t, whole(t, "body"));
	switch (t->call->kind)
	{
	case CALL_type:
		return scree_body_set_type(t->world, body, (scree_body_type)whole(t, "type"));
	case CALL_damping:
		return scree_body_set_damping(t->world, body, real(t, "linear"), real(t, "angular"));
	case CALL_gravity_scale:
		return scree_body_set_gravity_scale(t->world, body, real(t, "scale"));
	case CALL_locks:
		return scree_body_set_locks(t->world, body, (uint32_t)whole(t, "locks"));
	default:
		return scree_body_set_mass(t->world, body, (scree_mass){real(t, "mass"), real(t, "inertia"), vec(t, "x", "y")});
	}
}

// ---------------------------------------------------------------------------------------------------------------
// the world
// ---------------------------------------------------------------------------------------------------------------

static uint64_t mixed(uint64_t word, const void* bytes, size_t count)
{
	const unsigned char* p = bytes;
	for (size_t k = 0; k < count; ++k)
		word = (word ^ p[k]) * 0x100000001b3u; // Fowler, Noll, Vo
	return word;
}

#define MOST_READ 512
static scree_status run_read(const Turn* t)
{
	static scree_contact contacts[MOST_READ];
	static scree_shown shown[MOST_READ];
	uint64_t word = 0xcbf29ce484222325u;
	int counts[3] = {0};
	scree_status status = scree_get_contacts(t->world, contacts, MOST_READ, &counts[0]);
	for (int k = 0; k < counts[0] && k < MOST_READ && status == SCREE_OK; ++k)
	{
		contacts[k].points[1] = contacts[k].count > 1 ? contacts[k].points[1] : (scree_contact_point){.feature = 0};
		word = mixed(word, &contacts[k], sizeof contacts[k]);
	}
	if (status == SCREE_OK)
		status = scree_get_overlaps(t->world, contacts, 0, &counts[1]);
	if (status == SCREE_OK)
		status = scree_get_shown(t->world, shown, MOST_READ, &counts[2]);
	if (status == SCREE_OK)
		word = mixed(word, shown, (size_t)(counts[2] < MOST_READ ? counts[2] : MOST_READ) * sizeof shown[0]);
	word = mixed(word, counts, sizeof counts);
	scree_counters c;
	if (status == SCREE_OK)
		status = scree_get_counters(t->world, &c);
	if (status == SCREE_OK)
	{
		int more[] = {c.bodies, c.dynamic_bodies, c.collidables,  c.contacts, c.touching,
		              c.colors, c.overflow,       c.new_contacts, c.nonfinite};
		word = mixed(mixed(word, more, sizeof more), &c.penetration, sizeof c.penetration);
	}
	scree_pose pose = {0};
	scree_velocity velocity = {0};
	scree_body body = body_of(t, whole(t, "body"));
	if (status == SCREE_OK && scree_body_is_valid(t->world, body))
	{
		status = scree_body_get_pose(t->world, body, &pose);
		if (status == SCREE_OK)
			status = scree_body_get_velocity(t->world, body, &velocity);
		word = mixed(mixed(word, &pose, sizeof pose), &velocity, sizeof velocity);
	}
	t->left->word = word;
	return status;
}

static scree_status run_clear(const Turn* t)
{
	static scree_body bodies[MOST_NAMES];
	static scree_collidable collidables[MOST_NAMES];
	int count;
	scree_status status = scree_get_bodies(t->world, bodies, MOST_NAMES, &count);
	if (status == SCREE_OK)
		status = scree_destroy_bodies(t->world, bodies, count < MOST_NAMES ? count : MOST_NAMES);
	if (status == SCREE_OK)
		status = scree_get_collidables(t->world, (scree_body){0, 0}, collidables, MOST_NAMES, &count);
	if (status == SCREE_OK)
		status = scree_destroy_collidables(t->world, collidables, count < MOST_NAMES ? count : MOST_NAMES);
	memset(t->names, 0, sizeof *t->names);
	return status;
}

static scree_status run_move(const Turn* t)
{
	if (!t->place->other[0])
		return SCREE_OK;
	return scree_move_world(t->world, whole(t, "back") ? t->home : t->place->other);
}

static scree_status run_call(const Turn* t)
{
	switch (t->call->kind)
	{
	case CALL_box:
	case CALL_circle:
	case CALL_capsule:
	case CALL_segment:
	case CALL_polygon:
	case CALL_hull:
		return run_attribute(t);
	case CALL_body:
		return run_body(t);
	case CALL_bodies:
		return run_bodies(t);
	case CALL_destroy:
		return run_destroy(t);
	case CALL_type:
	case CALL_damping:
	case CALL_gravity_scale:
	case CALL_locks:
	case CALL_mass:
		return run_setting(t);
	case CALL_collidable:
		return run_collidable(t);
	case CALL_remove:
		return scree_destroy_collidable(t->world, collidable_of(t));
	case CALL_filter:
		return scree_collidable_set_filter(t->world, collidable_of(t), filter_of(t));
	case CALL_place:
		return run_place(t);
	case CALL_gravity:
		return scree_set_gravity(t->world, vec(t, "x", "y"));
	case CALL_step:
		return scree_step(t->world, real(t, "dt"), whole(t, "substeps"));
	case CALL_move:
		return run_move(t);
	case CALL_read:
		return run_read(t);
	case CALL_clear:
		return run_clear(t);
	case CALL_world:
	case CALL_KINDS:
		return SCREE_OK;
	default:
		return run_motion(t);
	}
}

static scree_status create_world(const Place* place, const Call* call, scree_world** world)
{
	Turn t = {.call = call};
	scree_world_def def = scree_default_world_def();
	def.device = place->device;
	def.threads = place->threads;
	def.lanes = place->lanes;
	def.gravity = vec(&t, "gravity_x", "gravity_y");
	def.contact_hertz = real(&t, "hertz");
	def.contact_damping_ratio = real(&t, "ratio");
	def.contact_push_speed = real(&t, "push");
	def.restitution_threshold = real(&t, "threshold");
	def.max_speed = real(&t, "max_speed");
	def.body_capacity = whole(&t, "bodies");
	def.contact_capacity = whole(&t, "contacts");
	return scree_create_world(&def, world);
}

// ---------------------------------------------------------------------------------------------------------------
// side by side
// ---------------------------------------------------------------------------------------------------------------

void pair_open(Pair* pair, const Place places[2])
{
	*pair = (Pair){.places = {places[0], places[1]}};
	for (int k = 0; k < 2; ++k)
		pair->names[k] = calloc(1, sizeof *pair->names[k]);
	if (!pair->names[0] || !pair->names[1])
		abort();
}

void pair_forget(Pair* pair)
{
	for (int k = 0; k < 2; ++k)
	{
		scree_destroy_world(pair->worlds[k]);
		pair->worlds[k] = NULL;
	}
}

void pair_close(Pair* pair)
{
	pair_forget(pair);
	for (int k = 0; k < 2; ++k)
		free(pair->names[k]);
}

// hashes: whether that of the world is part of what a step leaves
static Left take_turn(Pair* pair, int k, const Call* call, bool hashes)
{
	Left left = {0};
	Turn turn = {call, pair->worlds[k], pair->names[k], &pair->places[k], pair->homes[k], &left};
	left.status = run_call(&turn);
	if (left.status != SCREE_OK)
		snprintf(left.error, sizeof left.error, "%s", scree_error());
	if (left.status == SCREE_OK && call->kind == CALL_step && hashes)
		left.status = scree_world_hash(pair->worlds[k], &left.word);
	return left;
}

static bool left_differs(const Left* a, const Left* b, Outcome* outcome)
{
	bool refused = a->status == SCREE_INVALID || a->status == SCREE_STALE || a->status == SCREE_OK;
	if (a->status == b->status && a->word == b->word && refused)
		return false;
	outcome->differs = true;
	if (a->status != b->status || !refused)
		snprintf(outcome->sentence, sizeof outcome->sentence, "%s (%.100s) and %s (%.100s)",
		         scree_status_name(a->status), a->error, scree_status_name(b->status), b->error);
	else
		snprintf(outcome->sentence, sizeof outcome->sentence, "%016" PRIx64 " and %016" PRIx64, a->word, b->word);
	return true;
}

void program_add_empty(Program* program)
{
	static const CallKind kinds[] = {CALL_move, CALL_clear, CALL_step, CALL_step, CALL_gravity};
	const Call made = program->calls[0];
	for (size_t k = 0; k < sizeof kinds / sizeof kinds[0]; ++k)
	{
		Call call = call_make(kinds[k]);
		if (call.kind == CALL_move)
			call_set(&call, "back", 1.0f);
		if (call.kind == CALL_gravity)
		{
			call_set(&call, "x", call_value(&made, "gravity_x"));
			call_set(&call, "y", call_value(&made, "gravity_y"));
		}
		program_add(program, call);
	}
}

// Whether that works, and leaves both with the same bits.
static bool pair_empty(Pair* pair)
{
	Program program = {0};
	Outcome outcome = {0};
	bool same = true;
	program_add(&program, pair->made);
	program_add_empty(&program);
	for (int i = 1; i < program.count && same; ++i)
	{
		Left left[2];
		for (int k = 0; k < 2; ++k)
			left[k] = take_turn(pair, k, &program.calls[i], true);
		same = left[0].status == SCREE_OK && !left_differs(&left[0], &left[1], &outcome);
	}
	program_close(&program);
	return same;
}

static bool pair_ready(Pair* pair, const Call* made, Outcome* outcome)
{
	bool same = pair->worlds[0] && memcmp(&pair->made, made, sizeof *made) == 0;
	if (same && !pair->anew && pair_empty(pair))
		return true;
	pair_forget(pair);
	pair->made = *made;
	Left left[2] = {{0}, {0}};
	for (int k = 0; k < 2; ++k)
	{
		memset(pair->names[k], 0, sizeof *pair->names[k]);
		left[k].status = create_world(&pair->places[k], made, &pair->worlds[k]);
		if (left[k].status != SCREE_OK)
			snprintf(left[k].error, sizeof left[k].error, "%s", scree_error());
		// by its whole name, which costs nothing while the world is there
		snprintf(pair->homes[k], sizeof pair->homes[k], "%s", scree_world_device(pair->worlds[k]));
	}
	if (left[0].status == SCREE_OK && left[1].status == SCREE_OK)
		return true;
	left_differs(&left[0], &left[1], outcome);
	pair_forget(pair);
	return false;
}

Outcome pair_run(Pair* pair, const Program* program, FILE* details)
{
	Outcome outcome = {0};
	if (!pair_ready(pair, &program->calls[0], &outcome))
		return outcome;
	for (int i = 1; i < program->count; ++i)
	{
		const Call* call = &program->calls[i];
		Left left[2];
		outcome.call = i;
		outcome.steps += call->kind == CALL_step;
		bool hashes = pair->every < 2 || outcome.steps % pair->every == 0 || i + 1 == program->count;
		for (int k = 0; k < 2; ++k)
			left[k] = take_turn(pair, k, call, hashes);
		bool differs = left_differs(&left[0], &left[1], &outcome);
		if (!differs && call->kind == CALL_step && left[0].status == SCREE_OK && hashes)
		{
			outcome.frozen += state_frozen(pair->worlds[0]);
			if (!pair->infinite)
				differs = outcome.differs = !state_finite(pair->worlds[0], outcome.sentence);
		}
		if (!differs)
			continue;
		if (details && left[0].status == SCREE_OK && left[1].status == SCREE_OK)
			different_print(pair->worlds[0], pair->worlds[1], details);
		return outcome;
	}
	return outcome;
}
