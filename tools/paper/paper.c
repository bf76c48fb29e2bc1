// SPDX-License-Identifier: MIT
// paper.c -- creates the paper's pipeline, takes steps and reads the state.
#include "tools/paper/paper.h"
#include "platform/processor.h"
#include "tools/common/byte_hash.h"
#include "tools/common/clock.h"
#include "tools/paper/import.h"
#include "tools/paper/paper_cpu.h"
#include "tools/paper/paper_opencl.h"
#include "tools/paper/resolve.h"
#include "world/check.h"
#include <stdio.h>
#include <string.h>

// initial number of contacts in the pool
#define FIRST_CONTACTS 256

static scree_status open_device(Paper* paper, const char* device, bool allow_unequal_bits)
{
	if (strcmp(device, "cpu") == 0)
	{
		snprintf(paper->device, sizeof paper->device, "cpu");
		return SCREE_OK;
	}
	if (strcmp(device, "opencl") != 0 && strncmp(device, "opencl:", 7) != 0)
		return fail(SCREE_ERROR_INVALID, "paper_create: device is \"%s\", must be cpu, opencl or opencl:NAME", device);
#ifdef SCREE_NO_OPENCL
	(void)allow_unequal_bits;
	return fail(SCREE_ERROR_NO_DEVICE, "%s", scree_opencl_hint());
#else
	return paper_opencl_open(paper, device[6] ? device + 7 : NULL, allow_unequal_bits);
#endif
}

scree_status paper_create(scree_world* world, const char* device, bool allow_unequal_bits, Paper** paper)
{
	TRY(check_pointer("paper_create", "paper", paper));
	*paper = NULL;
	TRY(check_pointer("paper_create", "world", world));
	TRY(check_pointer("paper_create", "device", device));
	Paper* made = scree_allocate(sizeof *made);
	if (!made)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "paper_create: no memory");
	scree_status status = paper_import(made, world);
	if (status == SCREE_OK)
		status = paper_reserve(made, FIRST_CONTACTS);
	if (status == SCREE_OK)
		status = open_device(made, device, allow_unequal_bits);
	if (status != SCREE_OK)
	{
		paper_destroy(made);
		return status;
	}
	made->counters.bodies = made->pools.step.bodies;
	made->counters.collidables = made->pools.step.collidables;
	*paper = made;
	return SCREE_OK;
}

void paper_destroy(Paper* paper)
{
	if (!paper)
		return;
#ifndef SCREE_NO_OPENCL
	paper_opencl_close(paper);
#endif
	for (int i = 0; i < PAPER_POOL_COUNT; ++i)
		scree_release(paper_memory(paper, (PaperPoolId)i).memory);
	scree_release(paper->scratch);
	scree_release(paper);
}

static scree_status run(Paper* paper)
{
#ifndef SCREE_NO_OPENCL
	if (paper->opencl)
		return paper_opencl_run(paper);
#endif
	return paper_cpu_run(paper);
}

scree_status paper_step(Paper* paper, float dt)
{
	TRY(check_pointer("paper_step", "paper", paper));
	if (!(dt > 0.0f && dt <= 1.0f))
		return fail(SCREE_ERROR_INVALID, "paper_step: dt is %g, must be above 0 and at most 1", (double)dt);
	double begin = seconds_now();
	paper->pools.step.dt = dt;
	paper->timings = (PaperTimings){0};

	// integrate, transform and detect on the device; then resolve, always on the host
	FloatMode found = float_mode_enter();
	scree_status status = run(paper);
	double resolve_begin = seconds_now();
	if (status == SCREE_OK)
		status = paper_resolve(paper);
	float_mode_leave(found);
	if (status != SCREE_OK)
		return status;

	double end = seconds_now();
	paper->timings.resolve = 1e3 * (end - resolve_begin);
	paper->timings.step = 1e3 * (end - begin);
	paper->counters.contacts = *paper->pools.contact_count;
	++paper->counters.steps;
	return SCREE_OK;
}

scree_status paper_apply(Paper* paper, int body, scree_vec force, float torque)
{
	TRY(check_pointer("paper_apply", "paper", paper));
	if (body < 0 || body >= paper->pools.step.bodies)
		return fail(SCREE_ERROR_INVALID, "paper_apply: body is %d, must be from 0 to %d", body,
		            paper->pools.step.bodies - 1);
	ArgumentPlace at = {"paper_apply", "force", ALONE};
	TRY(check_vec(at, "", force, FLT_MAX));
	at.argument = "torque";
	TRY(check_real(at, "", torque, -FLT_MAX, FLT_MAX));
	Motion* motion = &paper->pools.body[body].motion;
	motion->fx += force.x;
	motion->fy += force.y;
	motion->torque += torque;
	return SCREE_OK;
}

static scree_status check_read(const char* function, const Paper* paper, const char* argument, const void* array,
                               int count)
{
	TRY(check_pointer(function, "paper", paper));
	TRY(check_batch(function, argument, array, count));
	if (count <= paper->pools.step.bodies)
		return SCREE_OK;
	return fail(SCREE_ERROR_INVALID, "%s: count is %d, but there are %d bodies", function, count,
	            paper->pools.step.bodies);
}

scree_status paper_poses(const Paper* paper, scree_pose* poses, int count)
{
	TRY(check_read("paper_poses", paper, "poses", poses, count));
	for (int i = 0; i < count; ++i)
	{
		// converts the pose of the center of mass to that of the body's origin
		const PaperBody* body = &paper->pools.body[i];
		float c = body->pose.z, s = body->pose.w, x = body->local_center.x, y = body->local_center.y;
		poses[i] = (scree_pose){{body->pose.x - (c * x - s * y), body->pose.y - (s * x + c * y)}, {c, s}};
	}
	return SCREE_OK;
}

scree_status paper_velocities(const Paper* paper, scree_velocity* velocities, int count)
{
	TRY(check_read("paper_velocities", paper, "velocities", velocities, count));
	for (int i = 0; i < count; ++i)
	{
		const PaperBody* body = &paper->pools.body[i];
		velocities[i] = (scree_velocity){{body->vx, body->vy}, body->w};
	}
	return SCREE_OK;
}

PaperCounters paper_counters(const Paper* paper) { return paper->counters; }
PaperTimings paper_timings(const Paper* paper) { return paper->timings; }
const char* paper_device(const Paper* paper) { return paper->device; }

uint64_t paper_hash(const Paper* paper)
{
	PaperMemory bodies = paper_memory(paper, PAPER_POOL_body);
	uint64_t hash = hash_bytes(HASH_BEGIN, bodies.memory, bodies.bytes);
	size_t contacts = (size_t)paper->counters.contacts * sizeof(PaperContact);
	return hash_bytes(hash, paper->pools.contact, contacts);
}
