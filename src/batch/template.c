// SPDX-License-Identifier: MIT
// template.c -- reads a world as the template of worlds of a batch, into host memory.
#include "batch/template.h"
#include "batch/own_chains.h"
#include "constraints/constraint_kinds.h"
#include "platform/error.h"
#include "step/bay_layout.h"
#include "world/chain/chains.h"
#include "world/device/lasting.h"
#include "world/failure.h"
#include "world/objects/hidden_hash.h"
#include "world/tuning_members.h"
#include "world/upload/upload.h"
#include <stdio.h>
#include <string.h>

static const size_t offsets[POOL_COUNT] = {
#define X(type, name, per, role) offsetof(Pools, name),
#include "pools/pools.def"
#undef X
};

static char** memory_of(Template* made, PoolId pool) { return (char**)((char*)&made->image + offsets[pool]); }

void* template_item(const Template* from, PoolId pool, int first)
{
	char* memory;
	memcpy(&memory, (const char*)&from->image + offsets[pool], sizeof memory);
	return memory + (size_t)first * pool_info[pool].bytes;
}

typedef struct // subject of a message
{
	char text[32];
} Subject;

static Subject subject_of(int number)
{
	Subject subject = {"the world"};
	if (number != ALONE)
		snprintf(subject.text, sizeof subject.text, "template %d", number);
	return subject;
}

static scree_status check_template(const scree_world* world, const char* function, int number)
{
	const Pipeline* p = &world->pipeline;
	if (p->sleeps && !world->def.sleep)
		return fail(SCREE_ERROR_INVALID,
		            "%s: sleep of %s was turned off since its last step; it must take a step first", function,
		            subject_of(number).text);
	if (!visits_are_plain(world)) // they end in the next step
		return fail(
		    SCREE_ERROR_INVALID,
		    "%s: %s has visits to a collidable that is no longer a sensor, which worlds of a batch cannot have yet",
		    function, subject_of(number).text);
	if (p->asks)
		return fail(SCREE_ERROR_INVALID,
		            "%s: %s has, or had, contacts that need approval (SCREE_REPORT_APPROVAL), which worlds of a batch "
		            "cannot have, because the program would have to answer for each world after each step",
		            function, subject_of(number).text);
	if (world->bodies.used > MOST_BAY_ITEMS || world->collidables.used > MOST_BAY_ITEMS ||
	    p->counters.contacts > MOST_BAY_ITEMS || world->joints.used > MOST_BAY_ITEMS)
		return fail(SCREE_ERROR_INVALID,
		            "%s: %s has %d bodies, %d collidables, %d contacts and %d joints, but must have at most %d of each",
		            function, subject_of(number).text, world->bodies.used, world->collidables.used,
		            p->counters.contacts, world->joints.used, MOST_BAY_ITEMS);
	return SCREE_OK;
}

static bool is_read(PoolId pool)
{
	switch (pool_info[pool].per)
	{
	case PER_ATTRIBUTE:
	case PER_MATERIAL_PAIR:
	case PER_COLLIDABLE:
	case PER_BODY:
	case PER_EXCLUDED:
	case PER_PATH_SAMPLE:
#define CONSTRAINT_KIND(kind, Kind, KIND) \
	case PER_##KIND:                      \
	case PER_##KIND##_BLOCK:
#include "pools/kinds.def"
#undef CONSTRAINT_KIND
		return pool_info[pool].role <= STANDING;
	default:
		return false;
	}
}

static scree_status read_pools(scree_world* world, const char* function, Template* made)
{
	for (int pool = 0; pool < POOL_COUNT; ++pool)
	{
		if (!is_read((PoolId)pool))
			continue;
		int count = lasting_items(world, pool_info[pool].per);
		char* memory = scree_allocate((size_t)(count + 1) * pool_info[pool].bytes);
		if (!memory)
			return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for %d items of a template", function, count);
		*memory_of(made, (PoolId)pool) = memory;
		made->count[pool] = count;
		if (count > 0)
			TRY(world_note(world, world->backend->f->read(world->backend, (PoolId)pool, 0, count, memory)));
	}
	return SCREE_OK;
}

// Reads the active fields, which the last upload has written.
static scree_status read_fields(scree_world* world, const char* function, Template* made)
{
	int count = world->fields.acting;
	if (count == 0)
		return SCREE_OK;
	made->image.field = scree_allocate(sizeof(Field) * (size_t)count);
	if (!made->image.field)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for %d fields of a template", function, count);
	made->count[POOL_field] = count;
	return world_note(world, world->backend->f->read(world->backend, POOL_field, 0, count, made->image.field));
}

// Moves the kept values of constraints from their rows to their slots. A joint that was destroyed since the last step
// still has its constraint, which the next step ends.
static void leave_places(Template* made)
{
#define CONSTRAINT_KIND(kind, Kind, KIND)                                         \
	for (int k = 0; k < made->count[POOL_##kind##_place]; ++k)                    \
	{                                                                             \
		if (made->image.kind##_color[k] >= 0 && made->image.kind##_place[k] >= 0) \
			kind##_keep(&made->image, k, made->image.kind##_place[k]);            \
		made->image.kind##_place[k] = -1;                                         \
	}
#include "pools/kinds.def"
#undef CONSTRAINT_KIND
}

// Gives the shapes of collidables in the world their present attributes, as an input does (bay_share): an attribute that has been
// replaced since the last step may not exist in a batch.
static void place_attributes(Template* made)
{
	for (int k = 0; k < made->collidables; ++k)
		made->image.world_shape[k].attribute = made->image.collidable_attribute[k];
}

static void read_settings(const scree_world* world, Template* made)
{
	made->request = (StepRequest){.gravity = world->def.gravity,
	                              .tuning = tuning_of(&world->def),
	                              .bodies = world->bodies.used,
	                              .collidables = world->collidables.used,
	                              .kinematic = world->kinematic_count,
	                              .contact_limit = world->def.contact_limit,
	                              .sleep = world->def.sleep,
	                              .sleep_threshold = world->def.sleep_threshold,
	                              .details = world->def.contact_details,
	                              .reports = world->reports.reporters > 0,
	                              .hit_speed = world->def.hit_speed,
	                              .hit_impulse = world->def.hit_impulse};
}

// Notes whether the first step of a world ends or begins chains, because the user changed masses since the last step.
static scree_status find_restarts(Template* made, const char* function)
{
	uint8_t* chained = scree_allocate((size_t)made->joints + 1);
	if (!chained)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for %d joints of a template", function, made->joints);
	own_chains_mark(&made->chains, chained, 1);
	Own own = own_of(made, made->own);
	for (int k = 0; k < made->joints; ++k)
		made->restarts |= (chained[k] != 0) != ((own.joint[k] & OWN_JOINT_CHAINED) != 0);
	scree_release(chained);
	return SCREE_OK;
}

// Marks the collidables whose contacts restarted after the last step of the template, and those that were destroyed since, so that
// touches of a reset count as alone.
static void mark_restarts(const scree_world* world, Template* made)
{
	for (int k = 0; k < made->count[POOL_collidable_flags]; ++k)
		if (!slots_in_use(&world->collidables, k) || world->host_collidables[k].born >= world->pipeline.steps)
			made->image.collidable_flags[k] |= COLLIDABLE_RESTARTED;
}

scree_status template_read(scree_world* world, const char* function, int number, Template* made)
{
	*made = (Template){.bodies = 0};
	TRY(world_upload(world)); // without new chains, which the next step finds, so that the world stays as it is
	TRY(check_template(world, function, number));
	scree_world_def def = scree_world_def_default();
	def.device = "cpu";
	def.threads = 1;
	if (number != ALONE)
		TRY(scree_world_clone(world, &def, &made->world));
	made->bodies = world->bodies.used;
	made->collidables = world->collidables.used;
	made->attributes = world->edits.attribute_rows;
	made->pipeline = world->pipeline;
	for (int k = 0; k < world->bodies.used;
	     ++k) // worlds of a batch may enable a body that the template has always had disabled
		made->pipeline.statics |= slots_in_use(&world->bodies, k) && world->host_bodies[k].type == SCREE_BODY_STATIC;
	Counters* c = &made->pipeline.counters;
	TRY(world_note(world, world->backend->f->read(world->backend, POOL_counters, 0, 1, c)));
	made->contacts = c->contacts;
	made->joints = c->joints;
	TRY(targets_read(world, function, number, &made->targets));
	made->hidden = hidden_hash_rest(world);
	read_settings(world, made);
	TRY(own_read(world, function, made->joints, &made->own, &made->own_rules));
	size_t kinematics = (size_t)world->kinematic_count;
	made->kinematics = scree_allocate(sizeof(int) * (kinematics + 1));
	if (!made->kinematics)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for a template", function);
	if (kinematics > 0)
		memcpy(made->kinematics, world->kinematics, sizeof(int) * kinematics);
	TRY(visits_read(world, function, &made->visits));
	TRY(read_pools(world, function, made));
	for (int k = 0; k < made->contacts; ++k)
		made->touching += made->image.contact_color[k] >= 0;
	mark_restarts(world, made);
	TRY(read_fields(world, function, made));
	leave_places(made);
	place_attributes(made);
	TRY(chains_find(world, &made->chains, &made->chain_memory));
	return find_restarts(made, function);
}

bool template_fits(const Template* a, const Template* b)
{
	return tuning_equal(&a->request.tuning, &b->request.tuning) && a->pipeline.heavy == b->pipeline.heavy;
}

BayState template_state(const Template* from)
{
	const Counters* c = &from->pipeline.counters;
	return (BayState){.press = {c->press[0], c->press[1]},
	                  .ways = c->ways,
	                  .presses = c->presses > 0,
	                  .taut = c->taut,
	                  .taut_seen = from->pipeline.taut,
	                  .joints_dirty = c->joints_dirty && from->contacts > 0,
	                  .penetration = c->penetration,
	                  .joint_gap = c->joint_gap,
	                  .surfaces = from->pipeline.surfaces_changed,
	                  .nonfinite = c->nonfinite,
	                  .substep = from->pipeline.step.h,
	                  .steps = (int)from->pipeline.steps,
	                  .drowsy = c->drowsy,
	                  .joined_islands = c->joined_islands,
	                  .settles = from->pipeline.settles,
	                  .woken = c->woken != 0};
}

Bay template_bay(const Template* from, int number)
{
	return (Bay){.bodies = from->bodies,
	             .collidables = from->collidables,
	             .attribute = from->first_attribute,
	             .world = -1,
	             .number = number,
	             .path_sample = from->first_sample,
	             .joints = from->joints,
	             .sleep_threshold = from->request.sleep ? from->request.sleep_threshold : -1.0f,
	             .field = from->first_field,
	             .fields = from->count[POOL_field]};
}

void template_shift(Template* made, int first, int sample, int field, int table)
{
	made->first_attribute = first;
	made->first_sample = sample;
	made->first_field = field;
	made->material_table = table;
	for (int k = 0; k < made->attributes; ++k)
		made->image.rule[k].material += table * MATERIALS;
	for (int k = 0; k < made->collidables; ++k)
	{
		made->image.collidable_attribute[k] += first;
		made->image.world_shape[k].attribute += first;
	}
}

void template_close(Template* made)
{
	for (int pool = 0; pool < POOL_COUNT; ++pool)
		scree_release(*memory_of(made, (PoolId)pool));
	scree_world_destroy(made->world);
	scree_release(made->chain_memory);
	scree_release(made->kinematics);
	visits_close(&made->visits);
	scree_release(made->targets.items);
	scree_release(made->own);
	own_rules_close(&made->own_rules);
	*made = (Template){.bodies = 0};
}
