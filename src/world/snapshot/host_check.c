// SPDX-License-Identifier: MIT
// host_check.c -- checks the data of a restored world on the host.
#include "world/snapshot/host_check.h"
#include "platform/error.h"
#include "world/objects/joint_ends.h"
#include "world/objects/joints.h"
#include "world/world.h"

static bool alive(const Slots* slots, int k) { return k >= 0 && k < slots->used && slots_in_use(slots, k); }

// Returns whether k is a body in use or, with `ground`, body 0.
static bool is_body(const scree_world* world, int k, bool ground)
{
	return (ground && k == 0) || alive(&world->bodies, k);
}

static scree_status check_shape(const ChunkIndex* index, const scree_shape* shape, const char* kind, int k)
{
	CHECK_ITEM(shape->count >= 0 && shape->count <= SCREE_MAX_VERTICES, kind, k);
	CHECK_ITEM((unsigned)shape->kind <= SCREE_SHAPE_POLYGON, kind, k);
	return SCREE_OK;
}

// Checks the list of the collidables of a body.
static scree_status check_collidables(const ChunkIndex* index, const scree_world* world, int body)
{
	const HostBody* host = world->host_bodies + body;
	int previous = -1, count = 0;
	for (int k = host->first_collidable; k >= 0; previous = k, k = world->host_collidables[k].next, ++count)
	{
		CHECK_ITEM(alive(&world->collidables, k) && count < host->collidables, "body", body);
		const HostCollidable* c = world->host_collidables + k;
		CHECK_ITEM(c->body == body && c->previous == previous, "collidable", k);
		CHECK_ITEM(c->next >= -1 && c->next < world->collidables.used, "collidable", k);
	}
	CHECK_ITEM(host->last_collidable == previous && count == host->collidables, "body", body);
	return SCREE_OK;
}

static scree_status check_bodies(const ChunkIndex* index, const scree_world* world)
{
	int dynamic = 0, disabled = 0, kinematic = 0, targets = 0;
	for (int k = 0; k < world->bodies.used; ++k)
	{
		const HostBody* host = world->host_bodies + k;
		CHECK_ITEM((unsigned)host->type <= SCREE_BODY_DYNAMIC, "body", k);
		CHECK_ITEM(host->first_collidable >= -1 && host->first_collidable < world->collidables.used, "body", k);
		CHECK_ITEM(host->kinematic >= 0 && host->kinematic <= world->kinematic_count, "body", k);
		CHECK_ITEM(host->target >= 0 && host->target <= world->target_count, "body", k);
		if (!is_body(world, k, true))
			continue;
		if (k > 0)
			TRY(check_collidables(index, world, k));
		CHECK_ITEM(!host->kinematic || world->kinematics[host->kinematic - 1] == k, "body", k);
		CHECK_ITEM(!host->target || world->targets[host->target - 1].body == k, "body", k);
		dynamic += k > 0 && host->type == SCREE_BODY_DYNAMIC;
		disabled += host->disabled;
		kinematic += host->kinematic > 0;
		targets += host->target > 0;
	}
	CHECK_ITEM(dynamic == world->dynamic_bodies && disabled == world->disabled_bodies, "world", 0);
	CHECK_ITEM(kinematic == world->kinematic_count && targets == world->target_count, "world", 0);
	for (int k = 0; k < world->kinematic_count; ++k)
		CHECK_ITEM(is_body(world, world->kinematics[k], false), "kinematic", k);
	for (int k = 0; k < world->target_count; ++k)
		CHECK_ITEM(is_body(world, world->targets[k].body, false), "target", k);
	return SCREE_OK;
}

static scree_status check_each_collidable(const ChunkIndex* index, const scree_world* world, int* users)
{
	int on_bodies = 0, listed = 0, sensors = 0, reporters = 0;
	for (int k = 0; k < world->collidables.used; ++k)
	{
		const HostCollidable* host = world->host_collidables + k;
		CHECK_ITEM(host->attribute >= 0 && host->attribute < world->attribute_slots.used, "collidable", k);
		if (!slots_in_use(&world->collidables, k))
			continue;
		CHECK_ITEM(alive(&world->attribute_slots, host->attribute), "collidable", k);
		CHECK_ITEM(host->body == -1 || is_body(world, host->body, false), "collidable", k);
		CHECK_ITEM(host->body >= 0 || (host->next == -1 && host->previous == -1), "collidable", k);
		++users[host->attribute];
		on_bodies += host->body > 0;
		sensors += host->sensor != 0;
		reporters += host->reports != 0;
	}
	for (int k = 1; k < world->bodies.used; ++k)
		listed += slots_in_use(&world->bodies, k) ? world->host_bodies[k].collidables : 0;
	CHECK_ITEM(on_bodies == listed && sensors == world->sensors.alive && reporters == world->reports.reporters, "world",
	           0);
	for (int k = 0; k < world->attribute_slots.used; ++k)
	{
		const HostAttribute* host = world->host_attributes + k;
		TRY(check_shape(index, &world->attributes[k].shape, "attribute", k));
		CHECK_ITEM(world->attributes[k].material >= 0 && world->attributes[k].material < MATERIALS, "attribute", k);
		if (!slots_in_use(&world->attribute_slots, k))
			continue;
		CHECK_ITEM(world->attributes[k].shape.count > 0, "attribute", k);
		CHECK_ITEM(host->collidables == users[k] && host->claims >= 0, "attribute", k);
		CHECK_ITEM(host->claims > 0 || host->collidables > 0, "attribute", k);
	}
	return SCREE_OK;
}

// Checks the lists of joints or of exclusions by body. Their ends are numbered as in joint_ends.h.
#define CHECK_LISTS(name, rows, slots, first, kind)                                                       \
	static scree_status name(const ChunkIndex* index, const scree_world* world)                           \
	{                                                                                                     \
		int ends = 0;                                                                                     \
		for (int k = 0; k < slots.used; ++k) /* the world keeps no list of its ends */                    \
			if (slots_in_use(&slots, k))                                                                  \
				ends -= (rows[k].bodies[0] > 0) + (rows[k].bodies[1] > 0);                                \
		for (int body = 1; body < world->bodies.used; ++body)                                             \
		{                                                                                                 \
			int previous = 0;                                                                             \
			for (int end = is_body(world, body, false) ? world->host_bodies[body].first : 0; end != 0;    \
			     previous = end, end = rows[(end - 1) / 2].next[(end - 1) % 2], ++ends)                   \
			{                                                                                             \
				CHECK_ITEM(end > 0 && alive(&slots, (end - 1) / 2) && ends < 0, "body", body);            \
				CHECK_ITEM(rows[(end - 1) / 2].bodies[(end - 1) % 2] == body, kind, (end - 1) / 2);       \
				CHECK_ITEM(rows[(end - 1) / 2].previous[(end - 1) % 2] == previous, kind, (end - 1) / 2); \
			}                                                                                             \
		}                                                                                                 \
		CHECK_ITEM(ends == 0, "world", 0);                                                                \
		return SCREE_OK;                                                                                  \
	}
CHECK_LISTS(check_joint_lists, world->host_joints, world->joints, first_joint, "joint")
CHECK_LISTS(check_exclusion_lists, world->exclusions.rows, world->exclusions.slots, first_exclusion, "exclusion")

static scree_status check_joints(const ChunkIndex* index, const scree_world* world, int* users)
{
	for (int k = 0; k < world->joints.used; ++k)
	{
		const HostJoint* host = world->host_joints + k;
		CHECK_ITEM((host->spot >= -1 && host->spot < world->pipeline.chain_places) || host->spot == SPOT_UNKNOWN,
		           "joint", k);
		if (!slots_in_use(&world->joints, k))
			continue;
		const scree_joint_def* def = &host->def;
		CHECK_ITEM((unsigned)def->type < JOINT_TYPES, "joint", k);
		for (int side = 0; side < 2; ++side)
		{
			// the user may have set any sides for a joint that couples nothing
			CHECK_ITEM(!joint_couples(def->type) || (unsigned)def->sides[side].measure <= SCREE_MEASURE_DISTANCE,
			           "joint", k);
			CHECK_ITEM(is_body(world, host->bodies[side], true), "joint", k);
		}
		CHECK_ITEM(host->bodies[0] != host->bodies[1], "joint", k);
		CHECK_ITEM(host->path == -1 || alive(&world->paths, host->path), "joint", k);
		CHECK_ITEM((host->path >= 0) == (def->type == SCREE_JOINT_PATH), "joint", k);
		if (host->path >= 0)
			++users[host->path];
	}
	for (int k = 0; k < world->exclusions.slots.used; ++k)
		for (int side = 0; side < 2 && slots_in_use(&world->exclusions.slots, k); ++side)
			CHECK_ITEM(is_body(world, world->exclusions.rows[k].bodies[side], true), "exclusion", k);
	return SCREE_OK;
}

// Checks the list of paths by the position of their samples.
static scree_status check_paths(const ChunkIndex* index, const scree_world* world, const int* users)
{
	int count = 0, end = 0, previous = 0, samples = 0;
	for (int path = world->first_path; path != 0; previous = path, path = world->host_paths[path - 1].next, ++count)
	{
		CHECK_ITEM(path > 0 && alive(&world->paths, path - 1) && count < world->paths.alive, "path", path - 1);
		const HostPath* host = world->host_paths + path - 1;
		CHECK_ITEM(host->previous == previous && host->first >= end && host->first <= MAX_ITEMS, "path", path - 1);
		CHECK_ITEM(host->uses == users[path - 1], "path", path - 1);
		end = host->first + host->segments + 1;
		samples += host->segments + 1;
	}
	CHECK_ITEM(count == world->paths.alive && world->last_path == previous && world->sample_end == end, "world", 0);
	CHECK_ITEM(samples == world->samples_used && end <= world->edits.sample_rows, "world", 0);
	return SCREE_OK;
}

static scree_status check_fields(const ChunkIndex* index, const scree_world* world, int* users)
{
	const Fields* f = &world->fields;
	for (int k = 0; k < f->slots.used; ++k)
	{
		const scree_field_def* def = &f->host[k].def;
		TRY(check_shape(index, &def->shape, "field", k));
		if (!slots_in_use(&f->slots, k))
			continue;
		CHECK_ITEM((unsigned)def->type <= SCREE_FIELD_BUOYANCY, "field", k);
		CHECK_ITEM((unsigned)def->falloff <= SCREE_FALLOFF_INVERSE_SQUARE, "field", k);
		CHECK_ITEM(f->host[k].body == -1 || is_body(world, f->host[k].body, false), "field", k);
		if (f->host[k].body >= 0)
			++users[f->host[k].body];
	}
	for (int k = 1; k < world->bodies.used; ++k)
		CHECK_ITEM(!slots_in_use(&world->bodies, k) || world->host_bodies[k].fields == users[k], "body", k);
	return SCREE_OK;
}

// Checks visits and events, which refer to collidables below `end`.
static scree_status check_visits(const ChunkIndex* index, const Visit* visits, int count, int end)
{
	for (int k = 0; k < count; ++k)
	{
		CHECK_ITEM(visits[k].sensor >= 0 && visits[k].sensor < end, "visit", k);
		CHECK_ITEM(visits[k].visitor >= 0 && visits[k].visitor < end, "visit", k);
	}
	return SCREE_OK;
}

static scree_status check_reports(const ChunkIndex* index, const ContactReport* rows, int count, int end)
{
	for (int k = 0; k < count; ++k)
	{
		CHECK_ITEM(rows[k].pair.x >= 0 && rows[k].pair.x < end, "event", k);
		CHECK_ITEM(rows[k].pair.y >= 0 && rows[k].pair.y < end, "event", k);
	}
	return SCREE_OK;
}

static scree_status check_events(const ChunkIndex* index, const scree_world* world)
{
	const Reports* r = &world->reports;
	const Sensors* s = &world->sensors;
	// events have names of destroyed collidables, so they refer to those that existed in the last step
	int used = world->collidables.used, named = r->departed_capacity / 2, end = named < used ? named : used;
	TRY(check_visits(index, s->visits, s->visit_count, used));
	TRY(check_visits(index, s->began, s->began_count, end));
	TRY(check_visits(index, s->ended, s->ended_count, end));
	TRY(check_reports(index, r->began, r->counts[EVENT_TOUCH_BEGAN], end));
	TRY(check_reports(index, r->hits, r->counts[EVENT_HIT], end));
	TRY(check_reports(index, r->asked, r->counts[EVENT_APPROVALS], end));
	for (int k = 0; k < r->counts[EVENT_TOUCH_ENDED]; ++k)
		CHECK_ITEM(r->ended[k] >> 32 < (Word64)end && (r->ended[k] & 0xffffffffu) < (Word64)end, "event", k);
	for (int k = named; k < used && named > 0; ++k)
		CHECK_ITEM(!slots_in_use(&world->collidables, k) || world->host_collidables[k].made >= world->pipeline.steps,
		           "collidable", k);
	return SCREE_OK;
}

static scree_status check_all(const ChunkIndex* index, const scree_world* world, int* users)
{
	int* of_attributes = users;
	int* of_paths = of_attributes + world->attribute_slots.used;
	int* of_bodies = of_paths + world->paths.used;
	CHECK_ITEM(!slots_in_use(&world->bodies, 0), "body", 0);
	TRY(check_bodies(index, world));
	TRY(check_each_collidable(index, world, of_attributes));
	TRY(check_joints(index, world, of_paths));
	TRY(check_joint_lists(index, world));
	TRY(check_exclusion_lists(index, world));
	TRY(check_paths(index, world, of_paths));
	TRY(check_fields(index, world, of_bodies));
	CHECK_ITEM(world->mass_sums.body >= 0 && world->mass_sums.body < world->bodies.used, "world", 0);
	CHECK_ITEM(!world->mass_sums.body ||
	               (world->mass_sums.last >= -1 && world->mass_sums.last < world->collidables.used),
	           "world", 0);
	return check_events(index, world);
}

scree_status host_check(const ChunkIndex* index, const scree_world* world)
{
	float unit = world->def.length_unit;
#ifdef SCREE_SMALL // a build for WebAssembly works in metres
	CHECK_ITEM(unit == 0.0f, "world", 0);
#else
	CHECK_ITEM(unit == 0.0f || (unit >= LEAST_LENGTH_UNIT && unit <= MOST_LENGTH_UNIT), "world", 0);
#endif
	size_t count = (size_t)world->attribute_slots.used + (size_t)world->paths.used + (size_t)world->bodies.used;
	int* users = scree_allocate(count * sizeof *users);
	if (!users)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory to check a snapshot", index->function);
	scree_status status = check_all(index, world, users);
	scree_release(users);
	return status;
}
