// SPDX-License-Identifier: MIT
// collidable.c -- collidables: made, destroyed, and what the user asks and sets of one.
#include "step/tree.h"
#include "world/definition.h"
#include "world/world.h"
#include <string.h>

int kind_of_type(scree_body_type type)
{
	return type == SCREE_BODY_STATIC ? KIND_STATIC : type == SCREE_BODY_KINEMATIC ? KIND_KINEMATIC : KIND_DYNAMIC;
}

int collidable_kind(const scree_world* world, int index)
{
	if (!slots_in_use(&world->collidables, index))
		return KIND_DEAD;
	return kind_on_body(world, world->host_collidables[index].body);
}

int kind_on_body(const scree_world* world, int body)
{
	if (body < 0)
		return KIND_FREE;
	return world->host_bodies[body].disabled ? KIND_DEAD : kind_of_type(world->host_bodies[body].type);
}

scree_filter scree_filter_default(void) { return (scree_filter){.category = 1, .mask = UINT64_MAX}; }

void scree_collidable_def_default_sized(scree_collidable_def* def, size_t size)
{
	const scree_collidable_def made = {
	    .size = (uint32_t)size, .pose.rotation.c = 1.0f, .filter = scree_filter_default()};
	write_result(def, size, &made, sizeof made);
}

// ---------------------------------------------------------------------------------------------------------------
// slots and lists
// ---------------------------------------------------------------------------------------------------------------

scree_status collidables_reserve(scree_world* world, const char* function, int more)
{
	if (world->collidables.alive + more > MAX_ITEMS)
		return fail(SCREE_ERROR_INVALID, "%s: %d more collidables beside %d: a world holds at most %d", function, more,
		            world->collidables.alive, MAX_ITEMS);
	if (!slots_reserve(&world->collidables, more))
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for %d more collidables", function, more);
	return GROW(function, world->host_collidables, world->host_collidable_capacity, world->collidables.capacity);
}

scree_status collidables_take(scree_world* world, int* slots, int count)
{
	int used = world->collidables.used;
	for (int k = 0; k < count; ++k)
	{
		int kind = slots[k];
		slots[k] = slots_take(&world->collidables);
		scree_status status =
		    kind == KIND_DEAD ? SCREE_OK : tree_insert(&world->pipeline, tree_of_kind(kind), slots[k]);
		if (status == SCREE_OK)
			continue;

		for (; k >= 0; --k)
		{
			tree_withdraw(&world->pipeline, slots[k]);
			slots_put_back(&world->collidables, slots[k], used);
		}
		return status;
	}
	return SCREE_OK;
}

// The device hears what comes after a collidable (-1 for none), unless its row is on its way.
static void list_changed(scree_world* world, int previous)
{
	if (previous < 0 || world->host_collidables[previous].waiting.row > 0)
		return;
	int next = world->host_collidables[previous].next;
	edits_command(world, COMMAND_NEXT, previous, make_float4(0.0f, 0.0f, 0.0f, 0.0f), next + 1);
}

void collidable_put(scree_world* world, int index, const HostCollidable* made)
{
	HostCollidable* host = world->host_collidables + index;
	Waiting waiting = host->waiting;
	*host = *made;
	host->waiting = waiting;
	++world->host_attributes[host->attribute].collidables;
	host->born = world->pipeline.steps;
	host->next = host->previous = -1;
	if (host->body >= 0)
	{
		HostBody* body = world->host_bodies + host->body;
		host->previous = body->last_collidable;
		if (host->previous >= 0)
			world->host_collidables[host->previous].next = index;
		else
			body->first_collidable = index;
		body->last_collidable = index;
		++body->collidables;
		list_changed(world, host->previous);
	}
	edits_collidable(world, index);
}

void collidable_remove(scree_world* world, int index)
{
	HostCollidable* host = world->host_collidables + index;
	if (host->body >= 0)
	{
		HostBody* body = world->host_bodies + host->body;
		if (host->previous >= 0)
			world->host_collidables[host->previous].next = host->next;
		else
			body->first_collidable = host->next;
		if (host->next >= 0)
			world->host_collidables[host->next].previous = host->previous;
		else
			body->last_collidable = host->previous;
		--body->collidables;
		list_changed(world, host->previous);
	}
	int kind = collidable_kind(world, index);
	if (kind != KIND_DEAD)
		tree_leave(&world->pipeline, tree_of_kind(kind), index);
	--world->host_attributes[host->attribute].collidables;
	slots_free(&world->collidables, index);
	edits_collidable(world, index);
}

// The handle of a pool's item 0 must not be null, which the generation sees to; that indices begin at 1 makes handles
// of bodies and collidables that were mistaken for one another easier to notice.
scree_collidable collidable_handle(const scree_world* world, int index)
{
	return (scree_collidable){(uint32_t)index + 1, world->collidables.generation[index]};
}

static bool is_valid(const scree_world* world, scree_collidable collidable)
{
	return collidable.index >= 1 && collidable.index <= (uint32_t)world->collidables.used &&
	       collidable.generation & 1 && world->collidables.generation[collidable.index - 1] == collidable.generation;
}

scree_status check_collidable(const scree_world* world, Where at, scree_collidable collidable, int* index)
{
	if (scree_collidable_is_null(collidable))
		return refuse(SCREE_ERROR_STALE, at, "", "is null");
	if (!is_valid(world, collidable))
		return refuse(SCREE_ERROR_STALE, at, "",
		              "(index %u, generation %u) was destroyed, or is none of this world's collidables",
		              collidable.index, collidable.generation);
	*index = (int)collidable.index - 1;
	return SCREE_OK;
}

bool scree_collidable_is_valid(const scree_world* world, scree_collidable collidable)
{
	return world && is_valid(world, collidable);
}

// ---------------------------------------------------------------------------------------------------------------
// create and destroy
// ---------------------------------------------------------------------------------------------------------------

// Masses of the bodies that these collidables belong to, each once.
static void update_masses(scree_world* world, const int* bodies, int count)
{
	for (int k = 0; k < count; ++k)
	{
		if (bodies[k] >= 0)
			world->host_bodies[bodies[k]].marked = true;
	}
	for (int k = 0; k < count; ++k)
	{
		if (bodies[k] < 0 || !world->host_bodies[bodies[k]].marked)
			continue;
		world->host_bodies[bodies[k]].marked = false;
		if (world->host_bodies[bodies[k]].type == SCREE_BODY_DYNAMIC)
			mass_set(world, bodies[k], mass_of_body(world, bodies[k]));
	}
}

static scree_status check_def(const scree_world* world, Where at, const scree_collidable_def* defs, int k,
                              HostCollidable* made)
{
	scree_collidable_def local;
	TRY(check_definition(at, defs, k, &collidable_definition));
	const scree_collidable_def* def = definition_at(defs, k, &collidable_definition, &local);
	*made = (HostCollidable){.body = -1, .pose = def->pose, .filter = def->filter, .user = def->user};
	TRY(check_attribute(world, at, ".attribute", def->attribute, &made->attribute));
	if (!scree_body_is_null(def->body))
		TRY(check_body(world, at, ".body", def->body, &made->body));
	return check_pose(at, ".pose", &made->pose);
}

static scree_status create(scree_world* world, const char* function, const char* argument,
                           const scree_collidable_def* defs, int count, scree_collidable* collidables, bool alone)
{
	TRY(world_check(world, function));
	TRY(check_batch(function, argument, defs, count));
	HostCollidable made;
	for (int k = 0; k < count; ++k)
		TRY(check_def(world, (Where){function, argument, alone ? ALONE : k}, defs, k, &made));
	TRY(collidables_reserve(world, function, count));
	TRY(edits_reserve(world, function, 0, count, count));
	int* slots = world_scratch(world, 2 * (size_t)count * sizeof *slots);
	if (!slots)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for %d collidables", function, count);

	int* bodies = slots + count;
	for (int k = 0; k < count; ++k)
	{
		check_def(world, (Where){function, argument, k}, defs, k, &made);
		bodies[k] = made.body;
		slots[k] = kind_on_body(world, made.body);
	}
	TRY(collidables_take(world, slots, count));
	for (int k = 0; k < count; ++k)
	{
		check_def(world, (Where){function, argument, k}, defs, k, &made);
		collidable_put(world, slots[k], &made);
		if (collidables)
			collidables[k] = collidable_handle(world, slots[k]);
	}
	update_masses(world, bodies, count);
	return SCREE_OK;
}

scree_status scree_collidables_create(scree_world* world, const scree_collidable_def* defs, int count,
                                      scree_collidable* collidables)
{
	return create(world, "scree_collidables_create", "defs", defs, count, collidables, false);
}

scree_status scree_collidable_create(scree_world* world, const scree_collidable_def* def, scree_collidable* collidable)
{
	return create(world, "scree_collidable_create", "def", def, 1, collidable, true);
}

static scree_status destroy(scree_world* world, const char* function, const char* argument,
                            const scree_collidable* collidables, int count, bool alone)
{
	TRY(world_check(world, function));
	TRY(check_batch(function, argument, collidables, count));
	TRY(edits_reserve(world, function, 0, count, count));
	int* bodies = world_scratch(world, (size_t)count * sizeof *bodies);
	if (!bodies)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for %d collidables", function, count);

	scree_status status = SCREE_OK;
	int marked = 0;
	for (int index = 0; marked < count && status == SCREE_OK;)
	{
		Where at = {function, argument, alone ? ALONE : marked};
		status = check_collidable(world, at, collidables[marked], &index);
		if (status == SCREE_OK && world->host_collidables[index].marked)
			status = refuse(SCREE_ERROR_STALE, at, "", "is in the batch a second time");
		if (status == SCREE_OK)
		{
			world->host_collidables[index].marked = true;
			bodies[marked++] = world->host_collidables[index].body;
		}
	}
	for (int k = 0; k < marked; ++k)
		world->host_collidables[collidables[k].index - 1].marked = false;
	TRY(status);

	for (int k = 0; k < count; ++k)
		collidable_remove(world, (int)collidables[k].index - 1);
	update_masses(world, bodies, count);
	return SCREE_OK;
}

scree_status scree_collidables_destroy(scree_world* world, const scree_collidable* collidables, int count)
{
	return destroy(world, "scree_collidables_destroy", "collidables", collidables, count, false);
}

scree_status scree_collidable_destroy(scree_world* world, scree_collidable collidable)
{
	return destroy(world, "scree_collidable_destroy", "collidable", &collidable, 1, true);
}

scree_status scree_body_get_collidables(const scree_world* world, scree_body body, scree_collidable* collidables,
                                        int capacity, int* count)
{
	const char* function = "scree_body_get_collidables";
	TRY(check_pointer(function, "world", world));
	TRY(check_list(function, "collidables", collidables, capacity, count));
	int listed = 0, index = 0;
	if (scree_body_is_null(body))
	{
		for (int k = 0; k < world->collidables.used; ++k)
		{
			if (!slots_in_use(&world->collidables, k) || world->host_collidables[k].body >= 0)
				continue;
			if (listed < capacity)
				collidables[listed] = collidable_handle(world, k);
			++listed;
		}
	}
	else
	{
		TRY(check_body(world, (Where){function, "body", ALONE}, "", body, &index));
		for (int k = world->host_bodies[index].first_collidable; k >= 0; k = world->host_collidables[k].next)
		{
			if (listed < capacity)
				collidables[listed] = collidable_handle(world, k);
			++listed;
		}
	}
	*count = listed;
	return SCREE_OK;
}

// ---------------------------------------------------------------------------------------------------------------
// what the user asks and sets
// ---------------------------------------------------------------------------------------------------------------

static scree_status lookup(const scree_world* world, const char* function, scree_collidable collidable,
                           const char* argument, const void* out, HostCollidable** host)
{
	int index = 0;
	TRY(check_pointer(function, "world", world));
	TRY(check_collidable(world, (Where){function, "collidable", ALONE}, collidable, &index));
	*host = world->host_collidables + index;
	return check_pointer(function, argument, out);
}

scree_status scree_collidable_get_body(const scree_world* world, scree_collidable collidable, scree_body* body)
{
	HostCollidable* host;
	TRY(lookup(world, "scree_collidable_get_body", collidable, "body", body, &host));
	*body = host->body < 0 ? (scree_body){0} : body_handle(world, host->body);
	return SCREE_OK;
}

scree_status scree_collidable_get_attribute(const scree_world* world, scree_collidable collidable,
                                            scree_attribute* attribute)
{
	HostCollidable* host;
	TRY(lookup(world, "scree_collidable_get_attribute", collidable, "attribute", attribute, &host));
	*attribute = attribute_handle(world, host->attribute);
	return SCREE_OK;
}

scree_status scree_collidable_set_attribute(scree_world* world, scree_collidable collidable, scree_attribute attribute)
{
	const char* function = "scree_collidable_set_attribute";
	TRY(world_check(world, function));
	int index = 0, now = 0;
	TRY(check_collidable(world, (Where){function, "collidable", ALONE}, collidable, &index));
	TRY(check_attribute(world, (Where){function, "attribute", ALONE}, "", attribute, &now));
	HostCollidable* host = world->host_collidables + index;
	const scree_attribute_def *old = world->attributes + host->attribute, *def = world->attributes + now;
	if (host->attribute == now)
		return SCREE_OK;
	TRY(edits_reserve(world, function, 0, 1, 1));

	// shapes of attributes are canonical: equal values, equal bytes
	bool same = memcmp(&old->shape, &def->shape, sizeof old->shape) == 0, heavier = old->density != def->density;
	int kind = collidable_kind(world, index);
	if (!same && kind != KIND_DEAD)
		TRY(tree_insert(&world->pipeline, tree_of_kind(kind), index));
	--world->host_attributes[host->attribute].collidables;
	++world->host_attributes[now].collidables;
	host->attribute = now;
	if (same)
	{
		edits_command(world, COMMAND_ATTRIBUTE, index, make_float4(0.0f, 0.0f, 0.0f, 0.0f), now);
		world->pipeline.mixed = true;
	}
	else
	{
		host->born = world->pipeline.steps;
		edits_collidable(world, index);
	}
	if ((!same || heavier) && host->body >= 0)
		update_masses(world, &host->body, 1);
	return SCREE_OK;
}

scree_status scree_collidable_get_local_pose(const scree_world* world, scree_collidable collidable, scree_pose* pose)
{
	HostCollidable* host;
	TRY(lookup(world, "scree_collidable_get_local_pose", collidable, "pose", pose, &host));
	*pose = host->pose;
	return SCREE_OK;
}

scree_status scree_collidable_get_filter(const scree_world* world, scree_collidable collidable, scree_filter* filter)
{
	HostCollidable* host;
	TRY(lookup(world, "scree_collidable_get_filter", collidable, "filter", filter, &host));
	*filter = host->filter;
	return SCREE_OK;
}

scree_status scree_collidable_get_user(const scree_world* world, scree_collidable collidable, uint64_t* user)
{
	HostCollidable* host;
	TRY(lookup(world, "scree_collidable_get_user", collidable, "user", user, &host));
	*user = host->user;
	return SCREE_OK;
}

scree_status scree_collidable_set_user(scree_world* world, scree_collidable collidable, uint64_t user)
{
	HostCollidable* host;
	TRY(lookup(world, "scree_collidable_set_user", collidable, "user", &user, &host));
	host->user = user;
	return SCREE_OK;
}

scree_status scree_collidable_set_filter(scree_world* world, scree_collidable collidable, scree_filter filter)
{
	const char* function = "scree_collidable_set_filter";
	TRY(world_check(world, function));
	int index = 0;
	TRY(check_collidable(world, (Where){function, "collidable", ALONE}, collidable, &index));
	TRY(edits_reserve(world, function, 0, 1, 0));
	// its leaf is there already; the tree has to hear that the box changes
	int kind = collidable_kind(world, index);
	if (kind != KIND_DEAD)
		TRY(tree_insert(&world->pipeline, tree_of_kind(kind), index));
	world->host_collidables[index].filter = filter;
	edits_collidable(world, index);
	return SCREE_OK;
}

scree_status scree_collidables_set_poses(scree_world* world, const scree_collidable* collidables,
                                         const scree_pose* poses, int count)
{
	const char* function = "scree_collidables_set_poses";
	TRY(world_check(world, function));
	TRY(check_batch(function, "collidables", collidables, count));
	TRY(check_batch(function, "poses", poses, count));
	for (int k = 0; k < count; ++k)
	{
		int index = 0;
		scree_pose pose = poses[k];
		TRY(check_collidable(world, (Where){function, "collidables", k}, collidables[k], &index));
		if (world->host_collidables[index].body >= 0)
			return refuse(SCREE_ERROR_INVALID, (Where){function, "collidables", k}, "", "belongs to a body: move that");
		TRY(check_pose((Where){function, "poses", k}, "", &pose));
	}
	TRY(edits_reserve(world, function, 0, 0, count));
	for (int k = 0; k < count; ++k)
	{
		int index = (int)collidables[k].index - 1;
		scree_pose pose = poses[k];
		check_pose((Where){function, "poses", k}, "", &pose);
		world->host_collidables[index].pose = pose;
		Float4 value = make_float4(pose.position.x, pose.position.y, pose.rotation.c, pose.rotation.s);
		edits_command(world, COMMAND_PLACE, index, value, 0);
	}
	return SCREE_OK;
}
