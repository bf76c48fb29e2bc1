// SPDX-License-Identifier: MIT
// body.c -- creates, destroys and lists bodies.
#include "platform/processor.h"
#include "world/definition.h"
#include "world/edits.h"
#include "world/failure.h"
#include "world/memory.h"
#include "world/objects/bodies.h"
#include "world/objects/collidables.h"
#include "world/objects/exclusions.h"
#include "world/objects/fields.h"
#include "world/objects/handles.h"
#include "world/objects/joints.h"
#include "world/objects/kinematics.h"
#include "world/objects/mass.h"
#include "world/objects/own_shapes.h"
#include "world/objects/sleep.h"
#include "world/objects/targets.h"
#include "world/record/api_calls.h"
#include "world/upload/whole_sleep.h"
#include "world/world.h"

void scree_body_def_default_sized(scree_body_def* def, size_t size)
{
	const scree_body_def made = {.size = (uint32_t)size,
	                             .type = SCREE_BODY_DYNAMIC,
	                             .pose.rotation.c = 1.0f,
#define X(name, least, most, value) .name = value,
#include "pools/body_values.def"
	                             .filter = scree_filter_default()};
	write_result(def, size, &made, sizeof made);
}

static const scree_body_def* def_at(const scree_body_def* defs, int k, scree_body_def* local)
{
	return definition_at(defs, k, &body_definition, local);
}

bool scree_body_is_valid(const scree_world* world, scree_body body) { return world && body_is_valid(world, body); }

static bool has_attribute(const scree_body_def* def) { return !scree_attribute_is_null(def->attribute); }

static scree_status check_def(const scree_world* world, ArgumentPlace at, const scree_body_def* def, bool shaped)
{
	int attribute = 0;
	scree_pose pose = def->pose;
	TRY(check_type(at, ".type", def->type));
	TRY(check_pose(at, ".pose", &pose));
	TRY(check_velocity(at, ".velocity", def->velocity));
#define X(name, least, most, value) TRY(check_##name(at, "." #name, def->name));
#include "pools/body_values.def"
	TRY(check_locks(at, ".locks", def->locks));
	TRY(check_reports(at, ".reports", def->reports));
	TRY(check_sensor(at, ".sensor", def->sensor));
	TRY(check_real(at, ".sleep_threshold", def->sleep_threshold, 0.0f, 1e6f));
	if (shaped && has_attribute(def))
		return refuse(SCREE_ERROR_INVALID, at, ".attribute", "is (%u, %u), must be null: the call has a shape",
		              def->attribute.index, def->attribute.generation);
	return has_attribute(def) ? check_attribute(world, at, ".attribute", def->attribute, &attribute) : SCREE_OK;
}

#define BODY_SOON 8 // distance, in bodies, at which host data is prefetched: slots may be anywhere in memory

static void fetch_rows(const void* rows, int index, size_t bytes)
{
	const char* row = (const char*)rows + (size_t)index * bytes;
	fetch_soon(row);
	fetch_soon(row + bytes - 1);
}

static void fetch_body(const scree_world* world, scree_body body)
{
	if (body.index >= (uint32_t)world->bodies.used)
		return;
	fetch_soon(world->bodies.generation + body.index);
	fetch_rows(world->host_bodies, (int)body.index, sizeof *world->host_bodies);
}

static void fetch_collidable(const scree_world* world, int collidable)
{
	if (collidable < 0)
		return;
	fetch_soon(world->collidables.generation + collidable);
	fetch_rows(world->host_collidables, collidable, sizeof *world->host_collidables);
}

// Writes a body from a checked definition. index: slot of the body; slot: slot of its collidable, -1 for none; attribute: slot of
// the collidable's attribute.
static void put(scree_world* world, ArgumentPlace at, const scree_body_def* def, int index, int slot, int attribute)
{
	bool moves = def->type == SCREE_BODY_DYNAMIC;
	bool asleep = def->asleep && moves && !def->disabled && !def->stays_awake && world->def.sleep;
	world->pipeline.settles |= asleep;
	world->dynamic_bodies += moves;
	world->disabled_bodies += def->disabled;
	HostBody* host = world->host_bodies + index;
	*host = (HostBody){.type = def->type,
#define X(name, least, most, value) .values.name = def->name,
#define KEPT(type, name)            .name = def->name,
#include "pools/body_values.def"
	                   .first_collidable = -1,
	                   .stands = def->pose,
	                   .still = def->velocity.linear.x == 0.0f && def->velocity.linear.y == 0.0f &&
	                            def->velocity.angular == 0.0f,
	                   .went = -1,
	                   .last_collidable = -1,
	                   .waiting = host->waiting};
	if (def->type == SCREE_BODY_KINEMATIC)
		kinematic_put(world, index);
	if (slot >= 0)
	{
		HostCollidable made = {.attribute = attribute,
		                       .body = index,
		                       .pose.rotation.c = 1.0f,
		                       .filter = def->filter,
		                       .reports = def->reports,
		                       .sensor = def->sensor,
		                       .user = def->user};
		collidable_put(world, slot, &made);
	}
	host->mass = mass_of_body(world, index);
	scree_pose pose = def->pose;
	check_pose(at, ".pose", &pose); // normalizes the rotation
	edits_body(world, (BodyRow){.index = index,
	                            .pose = pose,
	                            .center = host->mass.center,
	                            .velocity = body_velocity_allowed(host, def->velocity),
	                            .inv_mass = mass_inverse(host),
	                            .inv_inertia = mass_inverse_inertia(host),
	                            .values = moves ? host->values : (BodyValues){0},
	                            .locks = def->locks,
	                            .sleep_threshold = body_sleep_threshold(host),
	                            .asleep = asleep,
	                            .disabled = def->disabled});
}

static scree_status reserve(scree_world* world, const char* function, int count, int kinematics, int collidables)
{
	if (world->bodies.alive + count > MAX_ITEMS)
		return fail(SCREE_ERROR_INVALID, "%s: %d more bodies beside %d: a world holds at most %d", function, count,
		            world->bodies.alive, MAX_ITEMS);
	if (!slots_reserve(&world->bodies, count))
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for %d more bodies", function, count);
	TRY(GROW(function, world->host_bodies, world->host_body_capacity, world->bodies.capacity));
	TRY(kinematics_reserve(world, function, kinematics));
	TRY(collidables_reserve(world, function, collidables));
	return edits_reserve(world, function, count, collidables, 0);
}

typedef struct // arguments of a call that creates bodies
{
	const char* function;
	const char *argument, *shape_argument; // names of the arguments
	const scree_body_def* defs;
	const scree_attribute_def* shapes; // null: bodies have the attributes of their definitions
	int count;
	scree_body* bodies; // may be null
	bool alone;         // true: the arguments are not arrays
} Creation;

static bool has_collidable(const Creation* c, const scree_body_def* def) { return c->shapes || has_attribute(def); }

static scree_status check_creation(const scree_world* world, const Creation* c, int* collidables, int* kinematics)
{
	scree_body_def local;
	TRY(check_batch(c->function, c->argument, c->defs, c->count));
	for (int k = 0; k < c->count; ++k)
	{
		ArgumentPlace at = {c->function, c->argument, c->alone ? ALONE : k};
		TRY(check_definition(at, c->defs, k, &body_definition));
		const scree_body_def* def = def_at(c->defs, k, &local);
		TRY(check_def(world, at, def, c->shapes != NULL));
		*collidables += has_collidable(c, def);
		*kinematics += def->type == SCREE_BODY_KINEMATIC;
	}
	return c->shapes ? own_shapes_check(c->function, c->shape_argument, c->shapes, c->count, c->alone) : SCREE_OK;
}

// Finds the attributes of all collidables, or makes them.
static scree_status make_attributes(scree_world* world, const Creation* c, int* attributes)
{
	if (c->shapes)
		return own_shapes_make(world, c->function, c->shapes, c->count, attributes);
	scree_body_def local;
	for (int k = 0, next = 0; k < c->count; ++k)
	{
		const scree_body_def* def = def_at(c->defs, k, &local);
		if (has_attribute(def))
			attributes[next++] = (int)def->attribute.index;
	}
	return SCREE_OK;
}

static scree_status create(scree_world* world, Creation c)
{
	TRY(world_check(world, c.function));
	scree_body_def local;
	int collidables = 0, kinematics = 0;
	TRY(check_creation(world, &c, &collidables, &kinematics));
	TRY(reserve(world, c.function, c.count, kinematics, collidables));
	int* slots = world_scratch(world, (2 * (size_t)collidables + (size_t)c.count) * sizeof *slots);
	if (!slots)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for %d bodies and %d collidables", c.function, c.count,
		            collidables);
	int *attributes = slots + collidables, *indices = attributes + collidables;
	for (int k = 0, next = 0; k < c.count; ++k)
	{
		const scree_body_def* def = def_at(c.defs, k, &local);
		if (has_collidable(&c, def))
			slots[next++] = def->disabled ? KIND_DEAD : kind_of_type(def->type);
	}
	TRY(make_attributes(world, &c, attributes));
	scree_status status = collidables_allocate(world, slots, collidables);
	if (status != SCREE_OK && c.shapes)
		own_shapes_settle(world, attributes, c.count);
	TRY(status);
	for (int k = 0; k < c.count; ++k)
		indices[k] = slots_allocate(&world->bodies);

	for (int k = 0, next = 0; k < c.count; ++k)
	{
		if (k + BODY_SOON < c.count)
			fetch_rows(world->host_bodies, indices[k + BODY_SOON], sizeof *world->host_bodies);
		if (next + BODY_SOON < collidables)
			fetch_collidable(world, slots[next + BODY_SOON]);
		const scree_body_def* def = def_at(c.defs, k, &local);
		bool has = has_collidable(&c, def);
		put(world, (ArgumentPlace){c.function, c.argument, k}, def, indices[k], has ? slots[next] : -1,
		    has ? attributes[next] : -1);
		next += has;
		if (c.bodies)
			c.bodies[k] = body_handle(world, indices[k]);
	}
	return SCREE_OK;
}

scree_status api_bodies_create(scree_world* world, const scree_body_def* defs, int count, scree_body* bodies)
{
	FLOAT_MODE_HERE;
	return create(world, (Creation){"scree_bodies_create", "defs", NULL, defs, NULL, count, bodies, false});
}

scree_status api_body_create(scree_world* world, const scree_body_def* def, scree_body* body)
{
	FLOAT_MODE_HERE;
	return create(world, (Creation){"scree_body_create", "def", NULL, def, NULL, 1, body, true});
}

scree_status api_bodies_create_with_shapes(scree_world* world, const scree_body_def* defs,
                                           const scree_attribute_def* shapes, int count, scree_body* bodies)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_bodies_create_with_shapes";
	TRY(check_batch(function, "shapes", shapes, count));
	return create(world, (Creation){function, "defs", "shapes", defs, shapes, count, bodies, false});
}

scree_status api_body_create_with_shape(scree_world* world, const scree_body_def* def, const scree_attribute_def* shape,
                                        scree_body* body)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_body_create_with_shape";
	TRY(check_pointer(function, "shape", shape));
	return create(world, (Creation){function, "def", "shape", def, shape, 1, body, true});
}

static scree_status destroy(scree_world* world, const char* function, const char* argument, const scree_body* bodies,
                            int count, bool alone)
{
	TRY(world_check(world, function));
	TRY(check_batch(function, argument, bodies, count));
	scree_status status = SCREE_OK;
	int marked = 0, collidables = 0, joints = 0;
	for (int index = 0; marked < count && status == SCREE_OK;)
	{
		if (marked + BODY_SOON < count)
			fetch_body(world, bodies[marked + BODY_SOON]);
		ArgumentPlace at = {function, argument, alone ? ALONE : marked};
		status = check_body(world, at, "", bodies[marked], &index);
		if (status == SCREE_OK && world->host_bodies[index].marked)
			status = refuse(SCREE_ERROR_STALE, at, "", "is twice in the batch");
		if (status == SCREE_OK)
		{
			HostBody* host = world->host_bodies + index;
			host->marked = true;
			collidables += host->collidables;
			joints += body_joint_count(world, index);
			++marked;
		}
	}
	if (status == SCREE_OK)
		status = edits_reserve(world, function, count, collidables, JOINT_COMMANDS * joints);
	for (int k = 0; k < count && status == SCREE_OK; ++k)
		if (world->host_bodies[bodies[k].index].fields > 0)
			status = world_set_awake(world, true);
	for (int k = 0; k < marked && status != SCREE_OK; ++k)
		world->host_bodies[bodies[k].index].marked = false;
	TRY(status);

	for (int k = 0; k < count; ++k)
	{
		if (k + 2 * BODY_SOON < count)
			fetch_body(world, bodies[k + 2 * BODY_SOON]);
		if (k + BODY_SOON < count)
			fetch_collidable(world, world->host_bodies[bodies[k + BODY_SOON].index].first_collidable);
		int index = (int)bodies[k].index;
		HostBody* host = world->host_bodies + index;
		host->marked = false;
		mass_forget(world, index);
		while (host->first_collidable >= 0)
			collidable_remove(world, host->first_collidable);
		world->dynamic_bodies -= host->type == SCREE_BODY_DYNAMIC;
		kinematic_drop(world, index);
		world->disabled_bodies -= host->disabled;
		host->disabled = false;
		target_drop(world, index);
		body_joints_remove(world, index);
		fields_body_gone(world, index);
		body_exclusions_remove(world, index);
		slots_free(&world->bodies, index);
		edits_body(world, (BodyRow){.index = index, .pose.rotation.c = 1.0f});
	}
	return SCREE_OK;
}

scree_status api_bodies_destroy(scree_world* world, const scree_body* bodies, int count)
{
	FLOAT_MODE_HERE;
	return destroy(world, "scree_bodies_destroy", "bodies", bodies, count, false);
}

scree_status api_body_destroy(scree_world* world, scree_body body)
{
	FLOAT_MODE_HERE;
	return destroy(world, "scree_body_destroy", "body", &body, 1, true);
}

scree_status api_world_get_bodies(const scree_world* world, scree_body* bodies, int capacity, int* count)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_world_get_bodies";
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
