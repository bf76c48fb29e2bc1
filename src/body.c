// SPDX-License-Identifier: MIT
// body.c -- bodies: made and destroyed.
#include "world.h"
#include <string.h>

scree_body_def scree_default_body_def(void)
{
	return (scree_body_def){.type = SCREE_DYNAMIC,
	                        .pose.rotation.c = 1.0f,
	                        .gravity_scale = 1.0f,
	                        .filter = scree_default_filter(),
	                        .cookie = COOKIE_BODY};
}

scree_body body_handle(const scree_world* world, int index)
{
	return (scree_body){(uint32_t)index, world->bodies.generation[index]};
}

static bool is_valid(const scree_world* world, scree_body body)
{
	return body.index < (uint32_t)world->bodies.used && body.generation & 1 &&
	       world->bodies.generation[body.index] == body.generation;
}

bool scree_body_is_valid(const scree_world* world, scree_body body) { return world && is_valid(world, body); }

scree_status check_body(const scree_world* world, Where at, const char* member, scree_body body, int* index)
{
	if (body.index == 0 && body.generation == 0)
		return refuse(SCREE_STALE, at, member, "is null");
	if (!is_valid(world, body))
		return refuse(SCREE_STALE, at, member,
		              "(index %u, generation %u) was destroyed, or is none of this world's bodies", body.index,
		              body.generation);
	*index = (int)body.index;
	return SCREE_OK;
}

static bool has_attribute(const scree_body_def* def)
{
	return def->attribute.index != 0 || def->attribute.generation != 0;
}

// Checks a definition and makes of it what the host and the device keep.
static scree_status check_def(const scree_world* world, Where at, const scree_body_def* def, HostBody* host,
                              BodyRow* row, HostCollidable* collidable)
{
	*host = (HostBody){.type = def->type,
	                   .locks = def->locks,
	                   .gravity_scale = def->gravity_scale,
	                   .linear_damping = def->linear_damping,
	                   .angular_damping = def->angular_damping,
	                   .first_collidable = -1,
	                   .last_collidable = -1,
	                   .user = def->user};
	*row = (BodyRow){.pose = def->pose, .velocity = body_velocity_allowed(host, def->velocity), .locks = def->locks};
	*collidable = (HostCollidable){.pose.rotation.c = 1.0f, .filter = def->filter};

	TRY(check_cookie(at, def->cookie, COOKIE_BODY, "scree_default_body_def"));
	TRY(check_type(at, ".type", def->type));
	TRY(check_pose(at, ".pose", &row->pose));
	TRY(check_velocity(at, ".velocity", def->velocity));
	TRY(check_real(at, ".gravity_scale", def->gravity_scale, -FLT_MAX, FLT_MAX));
	TRY(check_real(at, ".linear_damping", def->linear_damping, 0.0f, FLT_MAX));
	TRY(check_real(at, ".angular_damping", def->angular_damping, 0.0f, FLT_MAX));
	TRY(check_locks(at, ".locks", def->locks));
	if (has_attribute(def))
		TRY(check_attribute(world, at, ".attribute", def->attribute, &collidable->attribute));
	return SCREE_OK;
}

static scree_status reserve(scree_world* world, const char* function, int count, int collidables)
{
	if (world->bodies.alive + count > MAX_ITEMS)
		return fail(SCREE_INVALID, "%s: %d more bodies beside %d: a world holds at most %d", function, count,
		            world->bodies.alive, MAX_ITEMS);
	if (!slots_reserve(&world->bodies, count))
		return fail(SCREE_OUT_OF_MEMORY, "%s: no memory for %d more bodies", function, count);
	TRY(GROW(function, world->host_bodies, world->host_body_capacity, world->bodies.capacity));
	TRY(collidables_reserve(world, function, collidables));
	return pending_reserve(world, function, count, collidables, 0);
}

static scree_status create(scree_world* world, const char* function, const char* argument, const scree_body_def* defs,
                           int count, scree_body* bodies, bool alone)
{
	TRY(world_check(world, function));
	TRY(check_batch(function, argument, defs, count));
	HostBody host;
	BodyRow row;
	HostCollidable made;
	int collidables = 0;
	for (int k = 0; k < count; ++k)
	{
		TRY(check_def(world, (Where){function, argument, alone ? ALONE : k}, defs + k, &host, &row, &made));
		collidables += has_attribute(defs + k);
	}
	TRY(reserve(world, function, count, collidables));
	int* slots = world_scratch(world, (size_t)collidables * sizeof *slots);
	if (!slots)
		return fail(SCREE_OUT_OF_MEMORY, "%s: no memory for %d collidables", function, collidables);
	for (int k = 0, next = 0; k < count; ++k)
	{
		if (has_attribute(defs + k))
			slots[next++] = kind_of_type(defs[k].type);
	}
	TRY(collidables_take(world, slots, collidables));

	for (int k = 0, next = 0; k < count; ++k)
	{
		check_def(world, (Where){function, argument, k}, defs + k, &host, &row, &made);
		int index = slots_take(&world->bodies);
		host.waiting = world->host_bodies[index].waiting;
		world->host_bodies[index] = host;
		if (has_attribute(defs + k))
		{
			made.body = index;
			collidable_put(world, slots[next++], &made);
		}

		HostBody* kept = world->host_bodies + index;
		kept->mass = mass_of_body(world, index);
		bool moves = host.type == SCREE_DYNAMIC;
		world->dynamic_bodies += moves;
		row.index = index;
		row.center = kept->mass.center;
		row.inv_mass = mass_inverse(kept);
		row.inv_inertia = mass_inverse_inertia(kept);
		row.gravity_scale = moves ? host.gravity_scale : 0.0f;
		row.linear_damping = moves ? host.linear_damping : 0.0f;
		row.angular_damping = moves ? host.angular_damping : 0.0f;
		pending_body(world, row);
		if (bodies)
			bodies[k] = body_handle(world, index);
	}
	return SCREE_OK;
}

scree_status scree_create_bodies(scree_world* world, const scree_body_def* defs, int count, scree_body* bodies)
{
	return create(world, "scree_create_bodies", "defs", defs, count, bodies, false);
}

scree_status scree_create_body(scree_world* world, const scree_body_def* def, scree_body* body)
{
	return create(world, "scree_create_body", "def", def, 1, body, true);
}

static scree_status destroy(scree_world* world, const char* function, const char* argument, const scree_body* bodies,
                            int count, bool alone)
{
	TRY(world_check(world, function));
	TRY(check_batch(function, argument, bodies, count));

	// marks tell a body that is named twice
	scree_status status = SCREE_OK;
	int marked = 0, collidables = 0;
	for (int index = 0; marked < count && status == SCREE_OK;)
	{
		Where at = {function, argument, alone ? ALONE : marked};
		status = check_body(world, at, "", bodies[marked], &index);
		if (status == SCREE_OK && world->host_bodies[index].marked)
			status = refuse(SCREE_STALE, at, "", "is in the batch a second time");
		if (status == SCREE_OK)
		{
			world->host_bodies[index].marked = true;
			collidables += world->host_bodies[index].collidables;
			++marked;
		}
	}
	for (int k = 0; k < marked; ++k)
		world->host_bodies[bodies[k].index].marked = false;
	TRY(status);

	TRY(pending_reserve(world, function, count, collidables, 0));
	for (int k = 0; k < count; ++k)
	{
		int index = (int)bodies[k].index;
		HostBody* host = world->host_bodies + index;
		while (host->first_collidable >= 0)
			collidable_remove(world, host->first_collidable);
		world->dynamic_bodies -= host->type == SCREE_DYNAMIC;
		slots_free(&world->bodies, index);
		pending_body(world, (BodyRow){.index = index, .pose.rotation.c = 1.0f});
	}
	return SCREE_OK;
}

scree_status scree_destroy_bodies(scree_world* world, const scree_body* bodies, int count)
{
	return destroy(world, "scree_destroy_bodies", "bodies", bodies, count, false);
}

scree_status scree_destroy_body(scree_world* world, scree_body body)
{
	return destroy(world, "scree_destroy_body", "body", &body, 1, true);
}

scree_status scree_get_bodies(const scree_world* world, scree_body* bodies, int capacity, int* count)
{
	const char* function = "scree_get_bodies";
	TRY(check_pointer(function, "world", world));
	TRY(check_list(function, "bodies", bodies, capacity, count));
	int listed = 0;
	for (int k = 0; k < world->bodies.used; ++k)
	{
		if (!slots_in_use(&world->bodies, k))
			continue;
		if (listed < capacity)
			bodies[listed] = body_handle(world, k);
		++listed;
	}
	*count = listed;
	return SCREE_OK;
}
