// SPDX-License-Identifier: MIT
// row_world.c -- moves states between rows and ordinary worlds.
//
// A world gets the structure of its template from a clone, then the items of the row; its constraints are laid out as
// in a step, so that no later bit differs.
#include "batch/row_world.h"
#include "batch/own_host.h"
#include "step/constants.h"
#include "step/event_readback.h"
#include "step/relayout.h"
#include "step/reserve.h"
#include "step/tree_maintenance.h"
#include "world/failure.h"
#include "world/objects/joints.h"
#include "world/objects/reports.h"
#include "world/structure.h"
#include "world/upload/upload.h"
#include <string.h>

scree_status row_of_world(const Template* read, uint64_t targets, uint64_t target_hash, const char* function,
                          char** row, size_t* bytes)
{
	const Pipeline* p = &read->pipeline;
	size_t at[POOL_COUNT];
	RowHead head = {.version = row_version(),
	                .fingerprint = read->fingerprint,
	                .dt = p->step.dt,
	                .state = template_state(read),
	                .gravity = read->request.gravity,
	                .targets = targets,
	                .target_hash = target_hash};
	row_count(read, row_slots(read->image.pair, read->contacts), head.count);
	*bytes = row_layout(head.count, at);
	*row = scree_allocate(*bytes);
	if (!*row)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for a state of %zu bytes", function, *bytes);
	for (int pool = 0; pool < POOL_COUNT; ++pool)
	{
		int kind = row_kind((PoolId)pool);
		if (kind < 0)
			continue;
		char* items = *row + at[pool];
		memcpy(items, template_item(read, (PoolId)pool, 0), pool_info[pool].bytes * (size_t)head.count[kind]);
		if (kind == ROW_CONTACTS)
			row_tidy((PoolId)pool, items, read->image.pair, head.count[kind]);
	}
	memcpy(*row + at[POOL_bay_visit], read->visits.bits, sizeof(Word) * (size_t)visits_of(&read->visits));
	memcpy(*row + row_own(head.count), read->own, own_size(read));
	row_tidy_dead(*row, head.count);
	row_seal(*row, &head);
	return SCREE_OK;
}

// Writes the items of a row, which is aligned. No constraint has a place afterwards.
static scree_status write_items(scree_world* world, const RowHead* head, const char* row)
{
	Backend* b = world->backend;
	size_t at[POOL_COUNT];
	row_layout(head->count, at);
	TRY(pipeline_reserve(&world->pipeline, PER_CONTACT, head->count[ROW_CONTACTS] + 1));
	for (int pool = 0; pool < POOL_COUNT; ++pool)
	{
		int kind = row_kind((PoolId)pool);
		if (kind >= 0 && head->count[kind] > 0)
			TRY(b->f->write(b, (PoolId)pool, 0, head->count[kind], row + at[pool]));
	}
	static const struct
	{
		PoolId pool;
		int kind;
	} places[] = {{POOL_contact_place, ROW_CONTACTS}, {POOL_joint_place, ROW_JOINTS}};
	int none[256];
	memset(none, -1, sizeof none);
	for (size_t k = 0; k < sizeof places / sizeof *places; ++k)
		for (int first = 0, count = head->count[places[k].kind], part; first < count; first += part)
		{
			part = count - first < 256 ? count - first : 256;
			TRY(b->f->write(b, places[k].pool, first, part, none));
		}
	return b->f->clear(b, POOL_start_pose, 0, b->capacity[PER_BODY]); // bodies jump to the poses of the row
}

// Sets the counters before the layout. Values that a step only hands to the user are 0.
static void set_counters(const RowHead* head, const CollidablePair* pair, Counters* c)
{
	const BayState* state = &head->state;
	*c = (Counters){.contacts = head->count[ROW_CONTACTS],
	                .joints = head->count[ROW_JOINTS],
	                .joined = c->joined,
	                .press = {state->press[0], state->press[1]},
	                .ways = state->ways,
	                .presses = state->presses ? INT32_MAX : 0,
	                .taut = state->taut,
	                .penetration = state->penetration,
	                .joint_gap = state->joint_gap,
	                .nonfinite = state->nonfinite,
	                .drowsy = state->drowsy,
	                .joined_islands = state->joined_islands,
	                .woken = state->woken ? INT32_MAX : 0};
	for (int k = 0; k < c->contacts; ++k)
		c->alive += pair[k].x >= 0;
}

// Sets what the next step must do once. joints: 1 if contacts may have to restart because joints changed.
static void set_duties(Pipeline* p, const RowHead* head)
{
	Step* step = &p->step;
	step->dt = head->dt;
	step->h = head->state.substep;
	step->inv_h = step->h > 0.0f ? 1.0f / step->h : 0.0f;
	step_joints(step, p);
	step->has_rolling = p->has_rolling;
	p->taut = head->state.taut_seen;
	p->surfaces_changed = head->state.surfaces != 0;
	p->dirty = p->counters.joints + p->excluded > 0;
	p->split = p->reverted = p->rested = false;
	p->edited = true;
	p->sparse = p->quiet = 0;
	p->settles = head->state.settles;
	p->listed = false; // the next step makes all groups active
	for (int t = 0; t < 2; ++t)
		tree_touch(p, t);
}

// Gives the host the values of joints that inputs of a batch changed.
static void take_joints(scree_world* world, const JointData* rows)
{
	for (int k = 0; k < world->joints.used; ++k)
	{
		JointData now = joint_edit(world, k).data;
		for (int c = 0; c < JOINT_COORDINATES && slots_in_use(&world->joints, k); ++c)
		{
			scree_joint_coordinate* to = world->host_joints[k].def.coordinates + c;
			const JointDriveData* drive = rows[k].drive + c;
			to->target = rows[k].lock[c].target != now.lock[c].target ? rows[k].lock[c].target : to->target;
			to->motor_speed = drive->speed != now.drive[c].speed ? drive->speed : to->motor_speed;
			to->motor_max = drive->motor_most != now.drive[c].motor_most ? drive->motor_most : to->motor_max;
		}
	}
}

// Gives the host the poses of kinematic bodies, which have their center of mass at the origin.
static void take_kinematics(scree_world* world, const Float4* poses, const BodyState* states)
{
	for (int k = 0; k < world->kinematic_count; ++k)
	{
		int body = world->kinematics[k];
		HostBody* host = world->host_bodies + body;
		Float4 pose = poses[body];
		host->stands = (scree_pose){{pose.x, pose.y}, {pose.z, pose.w}};
		host->still = states[body].vx == 0.0f && states[body].vy == 0.0f && states[body].w == 0.0f;
		host->went = -1;
	}
}

static void age(int64_t* step, int64_t steps) { *step = *step < steps ? *step : steps - 1; }

// Takes the number of steps of a row. flags: pool of the row. If the number is not that of the template, no object was created since the
// last step.
static void take_steps(scree_world* world, int64_t steps, const int* flags)
{
	bool other = steps != world->pipeline.steps;
	world->pipeline.steps = steps;
	for (int k = 0; k < world->collidables.used; ++k)
	{
		HostCollidable* host = world->host_collidables + k;
		bool restarted = flags[k] & COLLIDABLE_RESTARTED;
		if (other || !restarted)
			age(&host->made, steps);
		age(&host->born, steps);
		if (restarted)
			host->born = steps;
	}
	for (int k = 0; k < world->joints.used && other; ++k)
		age(&world->host_joints[k].born, steps);
}

static void take_host(scree_world* world, const RowHead* head, const char* row)
{
	size_t at[POOL_COUNT];
	row_layout(head->count, at);
	take_joints(world, (const JointData*)(const void*)(row + at[POOL_joint_data]));
	take_kinematics(world, (const Float4*)(const void*)(row + at[POOL_pose]),
	                (const BodyState*)(const void*)(row + at[POOL_body]));
	take_steps(world, (int64_t)head->state.steps, (const int*)(const void*)(row + at[POOL_collidable_flags]));
	reports_forget(world);
	structure_changed(world);
}

static scree_status take_items(scree_world* world, const Template* from, const RowHead* head, const char* row)
{
	Pipeline* p = &world->pipeline;
	Backend* b = world->backend;
	size_t at[POOL_COUNT];
	row_layout(head->count, at);
	const int* color = (const int*)(const void*)(row + at[POOL_contact_color]);
	bool spokes = false;
	for (int k = 0; k < head->count[ROW_CONTACTS]; ++k)
		spokes |= color[k] == COLORS;
	TRY(events_reserve(p, &from->request)); // the template may have had no step since its collidables report touches
	TRY(write_items(world, head, row));
	set_counters(head, (const CollidablePair*)(const void*)(row + at[POOL_pair]), &p->counters);
	TRY(pipeline_lay_out(p, from->bodies, spokes));
	p->counters.belts = p->belts; // the belt of a contact may have changed just before the row was saved
	// the pairs that never touch are those of the template, but joints may have broken since
	p->counters.joints_dirty = p->counters.joints + p->excluded > 0 ? INT32_MAX : 0;
	TRY(b->f->write(b, POOL_counters, 0, 1, &p->counters));
	p->statics |= from->pipeline.statics; // a static body that is disabled now may have been enabled by inputs
	set_duties(p, head);
	take_host(world, head, row);
	Counters counters; // this read also stores the counters in the backend, and reports failed writes
	TRY(b->f->read(b, POOL_counters, 0, 1, &counters));
	return visits_give(world, &from->visits, row + at[POOL_bay_visit]);
}

// Gives a copy of the template the own values of a row, and uploads them, so that the host has all that follows from them.
static scree_status take_own(scree_world* world, const char* function, const Template* from, const RowHead* head,
                             const char* row)
{
	size_t bytes = own_size(from);
	if (memcmp(row + row_own(head->count), from->own, bytes) == 0)
		return SCREE_OK;
	char* values = scree_allocate(bytes);
	if (!values)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for the masses and surfaces of a world", function);
	memcpy(values, row + row_own(head->count), bytes);
	scree_status status = own_apply(world, function, own_of(from, from->own), own_of(from, values));
	if (status == SCREE_OK)
		status = world_upload_to_step(world);
	if (status == SCREE_OK)
		status = world_note(world, own_chains_before(world, own_of(from, values)));
	scree_release(values);
	return status;
}

scree_status world_take_row(scree_world* world, const char* function, const Template* from, const char* row)
{
	RowHead head;
	memcpy(&head, row, sizeof head);
	targets_keep(&from->targets, head.targets, world);
	TRY(take_own(world, function, from, &head, row));
	return world_note(world, take_items(world, from, &head, row));
}
