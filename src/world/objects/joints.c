// SPDX-License-Identifier: MIT
// joints.c -- keeps the slots of joints and their lists by body, and uploads joints.
#include "world/objects/joints.h"
#include "platform/error.h"
#include "step/reserve.h"
#include "world/edits.h"
#include "world/memory.h"
#include "world/objects/mass.h"
#include "world/pool_values.h"
#include <float.h>
#include <math.h>
#include <stdlib.h>

scree_status joints_reserve(scree_world* world, const char* function, int more)
{
	if (world->joints.alive + more > MAX_ITEMS)
		return fail(SCREE_ERROR_INVALID, "%s: %d more joints beside %d: a world holds at most %d", function, more,
		            world->joints.alive, MAX_ITEMS);
	if (!slots_reserve(&world->joints, more))
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for %d more joints", function, more);
	TRY(edits_reserve(world, function, 0, 0, (JOINT_COMMANDS + 2) * more));
	// the list of pending joints contains a joint at most once
	TRY(GROW(function, world->edits.joints, world->edits.joint_capacity, world->joints.capacity));
	return GROW(function, world->host_joints, world->host_joint_capacity, world->joints.capacity);
}

// Records a command that wakes a body whose joints changed.
static void wake_body(scree_world* world, int body)
{
	if (world->def.sleep && world->host_bodies[body].type == SCREE_BODY_DYNAMIC)
		edits_command(world, COMMAND_JOINTS, body, make_float4(0.0f, 0.0f, 0.0f, 0.0f), 0);
}

void joint_changed(scree_world* world, int index, bool restarts)
{
	wake_body(world, world->host_joints[index].bodies[0]);
	wake_body(world, world->host_joints[index].bodies[1]);
	world->host_joints[index].restarts |= restarts;
	world->chains_stale |= restarts;
	joint_resend(world, index);
}

void joint_resend(scree_world* world, int index)
{
	HostJoint* host = world->host_joints + index;
	if (!host->waiting)
		world->edits.joints[world->edits.joint_count++] = index;
	host->waiting = true;
}

static void link_end(scree_world* world, int index, int side)
{
	HostJoint* host = world->host_joints + index;
	int end = 2 * index + side + 1, body = host->bodies[side];
	host->next[side] = host->previous[side] = 0;
	if (body == 0)
		return;
	HostBody* at = world->host_bodies + body;
	host->next[side] = at->first_joint;
	if (at->first_joint > 0)
		world->host_joints[joint_of_end(at->first_joint)].previous[(at->first_joint - 1) % 2] = end;
	at->first_joint = end;
}

static void unlink_end(scree_world* world, int index, int side)
{
	HostJoint* host = world->host_joints + index;
	int next = host->next[side], previous = host->previous[side];
	if (host->bodies[side] == 0)
		return;
	if (previous > 0)
		world->host_joints[joint_of_end(previous)].next[(previous - 1) % 2] = next;
	else
		world->host_bodies[host->bodies[side]].first_joint = next;
	if (next > 0)
		world->host_joints[joint_of_end(next)].previous[(next - 1) % 2] = previous;
}

void joint_anchors(scree_world* world, int index)
{
	const HostJoint* host = world->host_joints + index;
	mass_anchor(world, host->bodies[0], host->def.frame_a.position);
	mass_anchor(world, host->bodies[1], host->def.frame_b.position);
}

int joint_put(scree_world* world, const scree_joint_def* def, int body_a, int body_b)
{
	int index = slots_allocate(&world->joints);
	HostJoint* host = world->host_joints + index;
	*host = (HostJoint){.def = *def,
	                    .bodies = {body_a, body_b},
	                    .path = def->type == SCREE_JOINT_PATH ? (int)def->path.index - 1 : -1,
	                    .born = world->pipeline.steps,
	                    .spot = -1,
	                    .created = true,
	                    .waiting = host->waiting};
	if (host->path >= 0)
		++world->host_paths[host->path].uses;
	link_end(world, index, 0);
	link_end(world, index, 1);
	joint_anchors(world, index);
	joint_changed(world, index, true);
	return index;
}

void joint_remove(scree_world* world, int index)
{
	unlink_end(world, index, 0);
	unlink_end(world, index, 1);
	HostJoint* host = world->host_joints + index;
	if (host->path >= 0)
		--world->host_paths[host->path].uses;
	host->spot = -1;
	slots_free(&world->joints, index);
	joint_changed(world, index, true);
}

int body_joint_count(const scree_world* world, int body)
{
	int count = 0;
	for (int end = world->host_bodies[body].first_joint; end > 0; end = joint_next(world, end))
		++count;
	return count;
}

void body_joints_changed(scree_world* world, int body)
{
	for (int end = world->host_bodies[body].first_joint; end > 0; end = joint_next(world, end))
		joint_changed(world, joint_of_end(end), true);
}

void body_joints_seek(scree_world* world, int body)
{
	if (world->paths.alive == 0)
		return;
	for (int end = world->host_bodies[body].first_joint; end > 0; end = joint_next(world, end))
	{
		HostJoint* host = world->host_joints + joint_of_end(end);
		if (host->path < 0)
			continue;
		host->seeks = true;
		joint_changed(world, joint_of_end(end), false);
	}
}

void body_joints_remove(scree_world* world, int body)
{
	while (world->host_bodies[body].first_joint > 0)
		joint_remove(world, joint_of_end(world->host_bodies[body].first_joint));
}

// Returns the modes of a coordinate as JOINT_* bits. A locked coordinate has neither limits nor spring nor motor.
static int coordinate_modes(const scree_joint_coordinate* from, int k)
{
	if (from->locked)
		return JOINT_LOCKED(k) | (from->lock_hertz > 0.0f ? JOINT_SOFT(k) : 0);
	return (from->limited ? JOINT_LIMITED(k) : 0) | (from->spring && from->spring_hertz > 0.0f ? JOINT_SPRING(k) : 0) |
	       (from->motor ? JOINT_MOTOR(k) : 0);
}

static JointLock lock_row(const scree_joint_coordinate* from)
{
	return (JointLock){.target = from->target, .hertz = from->lock_hertz, .ratio = from->lock_damping_ratio};
}

static JointDriveData drive_row(const scree_joint_coordinate* from)
{
	return (JointDriveData){.lower = from->lower,
	                        .upper = from->upper,
	                        .spring_hertz = from->spring_hertz,
	                        .spring_ratio = from->spring_damping_ratio,
	                        .spring_least = -fminf(from->spring_max, from->spring_pull),
	                        .spring_most = fminf(from->spring_max, from->spring_push),
	                        .speed = from->motor_speed,
	                        .motor_most = from->motor_max};
}

static bool moves(const HostBody* body) { return body->type == SCREE_BODY_DYNAMIC; }

#define LINEAR_DRIVES \
	(JOINT_SPRING(JOINT_ALONG) | JOINT_MOTOR(JOINT_ALONG) | JOINT_SPRING(JOINT_ACROSS) | JOINT_MOTOR(JOINT_ACROSS))

// Limits the coordinate along an open path, and its target if locked, to the range from 0 to the length of the path, m.
static scree_joint_coordinate along_open(const scree_joint_coordinate* from, float length)
{
	scree_joint_coordinate along = *from;
	along.limited = true;
	along.lower = from->limited ? fminf(fmaxf(from->lower, 0.0f), length) : 0.0f;
	along.upper = from->limited ? fminf(fmaxf(from->upper, 0.0f), length) : length;
	if (from->locked)
		along.target = fminf(fmaxf(from->target, 0.0f), length);
	return along;
}

static int joint_modes(const scree_joint_def* def)
{
	int modes = def->type == SCREE_JOINT_DISTANCE ? JOINT_RADIAL : def->type == SCREE_JOINT_PATH ? JOINT_RAILED : 0;
	for (int k = 0; k < JOINT_COORDINATES; ++k)
		modes |= coordinate_modes(def->coordinates + k, k);
	if (!joint_couples(def->type))
		return def->elliptic && modes & LINEAR_DRIVES ? modes | JOINT_ELLIPTIC : modes;
	for (int side = 0; side < 2; ++side)
	{
		scree_measure measure = def->sides[side].measure;
		modes |= measure == SCREE_MEASURE_TRANSLATION ? JOINT_SLIDES(side) : 0;
		modes |= measure == SCREE_MEASURE_DISTANCE ? JOINT_HOISTS(side) : 0;
	}
	return modes | JOINT_COUPLED;
}

// Returns side k of a coupling. For other joints returns a default: their sides are not checked, and may not be finite.
static scree_joint_side side_of(const scree_joint_def* def, int k)
{
	return joint_couples(def->type) ? def->sides[k] : (scree_joint_side){.base.rotation.c = 1.0f};
}

JointEdit joint_edit(const scree_world* world, int index)
{
	const HostJoint* host = world->host_joints + index;
	const scree_joint_def* def = &host->def;
	scree_joint_def own;
	scree_joint_side side_a = side_of(def, 0), side_b = side_of(def, 1);
	JointEdit edit = {.slot = index,
	                  .spot = host->spot == SPOT_UNKNOWN ? -1 : host->spot,
	                  .flags = (host->restarts ? JOINT_RESTARTS : 0) | (host->rechained ? JOINT_RECHAINED : 0) |
	                           (host->created ? JOINT_NEW : 0) | (host->seeks ? JOINT_SEEKS : 0)};
	if (!slots_in_use(&world->joints, index))
		return edit;
	const HostPath* path = host->path >= 0 ? world->host_paths + host->path : NULL;
	if (path && path->samples[path->segments].length == 0.0f)
	{
		own = host->def;
		own.coordinates[SCREE_ALONG] = along_open(own.coordinates, path->samples[path->segments].along);
		def = &own;
	}
	const HostBody *a = world->host_bodies + host->bodies[0], *b = world->host_bodies + host->bodies[1];
	int modes = joint_modes(def), acts = JOINT_EXTRAS | JOINT_LOCKED(0) | JOINT_LOCKED(1) | JOINT_LOCKED(2);
	edit.flags |= JOINT_THERE;
	edit.flags |= (moves(a) || moves(b)) && !a->disabled && !b->disabled && !def->disabled ? JOINT_ACTIVE : 0;
	edit.flags |= def->collide_connected || def->disabled ? JOINT_COLLIDES : 0;
	edit.flags |= def->can_break ? JOINT_CAN_BREAK : 0;
	edit.flags |= modes & acts ? JOINT_ACTS : 0;
	edit.data = (JointData){.body_a = host->bodies[0],
	                        .body_b = host->bodies[1],
	                        .modes = (float)modes,
	                        .gear_ratio = joint_couples(def->type) ? def->ratio : 1.0f,
	                        .frame = {pose_row(def->frame_a), pose_row(def->frame_b)},
	                        .base = {pose_row(side_a.base), pose_row(side_b.base)},
	                        .near = {path ? def->initial_along : side_a.initial_angle, side_b.initial_angle},
	                        .path_first = path ? (float)path->first : 0.0f,
	                        .path_segments = path ? (float)path->segments : 0.0f,
	                        .hertz = def->hertz,
	                        .ratio = def->damping_ratio,
	                        .most_force = def->force_threshold,
	                        .most_torque = def->torque_threshold};
	for (int k = 0; k < JOINT_COORDINATES; ++k)
	{
		edit.data.lock[k] = lock_row(def->coordinates + k);
		edit.data.drive[k] = drive_row(def->coordinates + k);
	}
	FLUSH_MEMBERS(&edit.data, modes, path_segments);
	return edit;
}

static bool has_drives(const JointEdit* edit)
{
	return (int)edit->data.modes & (JOINT_EXTRAS | JOINT_SPRINGS | JOINT_COUPLED | JOINT_RAILED) ||
	       edit->data.most_force < FLT_MAX || edit->data.most_torque < FLT_MAX;
}

static bool is_unlocked(const scree_world* world, int index)
{
	const int* bodies = world->host_joints[index].bodies;
	for (int side = 0; side < 2; ++side)
		if (bodies[side] > 0 && world->host_bodies[bodies[side]].collidables == 0)
			return true;
	return false;
}

// Returns whether at least one side of a joint is the world or a body that is not dynamic.
static bool is_tether(const scree_world* world, int index)
{
	const int* bodies = world->host_joints[index].bodies;
	for (int side = 0; side < 2; ++side)
		if (bodies[side] <= 0 || world->host_bodies[bodies[side]].type != SCREE_BODY_DYNAMIC)
			return true;
	return false;
}

static int compare_slots(const void* a, const void* b) { return *(const int*)a - *(const int*)b; }

scree_status upload_joints(scree_world* world, void* memory)
{
	Edits* p = &world->edits;
	Pipeline* pipeline = &world->pipeline;
	Backend* b = world->backend;
	JointEdit* rows = memory;
	if (p->joint_count == 0)
		return SCREE_OK;
	qsort(p->joints, (size_t)p->joint_count, sizeof *p->joints, compare_slots);
	for (int k = 0; k < p->joint_count; ++k)
	{
		rows[k] = joint_edit(world, p->joints[k]);
		if (!slots_in_use(&world->joints, p->joints[k])) // a destroyed joint, whose row is empty
			continue;
		pipeline->has_drives |= has_drives(rows + k);
		pipeline->springs |= ((int)rows[k].data.modes & JOINT_SPRINGS) != 0;
		pipeline->couplings |= ((int)rows[k].data.modes & JOINT_COUPLED) != 0;
		pipeline->paths |= ((int)rows[k].data.modes & JOINT_RAILED) != 0;
		pipeline->can_break |= (rows[k].flags & JOINT_CAN_BREAK) != 0;
		pipeline->unlocked |= is_unlocked(world, p->joints[k]);
		pipeline->tethers |= is_tether(world, p->joints[k]);
	}
	TRY(b->f->write(b, POOL_joint_edit, 0, p->joint_count, rows));
	Step step = {0};
	Counters* c = &pipeline->counters;
	Run run = {.kernel_id = KERNEL_joint_apply, .end = p->joint_count, .count = NO_COUNT, .argument = c->joints};
	TRY(b->f->run(b, &step, &run, 1));
	int used = p->joints[p->joint_count - 1] + 1;
	c->joints = used > c->joints ? used : c->joints;
	pipeline->dirty = true;
	return SCREE_OK;
}
