// SPDX-License-Identifier: MIT
// relay.c -- launches a whole solve as one kernel, a relay (relay.cl).
#include "opencl/forms/relay.h"
#include "opencl/buffer.h"
#include "opencl/launch.h"
#include "opencl/queue.h"
#include "opencl/readback.h"
#include "platform/error.h"

// limits of a spin-wait, in reads of about 0.5 us: 2 s for a solve, 30 ms for the probe; number of rounds of the probe
#define SPINS        RELAY_MAX_SPINS
#define PROBE_SPINS  (1 << 16)
#define PROBE_ROUNDS 16

// Maximum number of work-items per constraint. Only one of them computes; the others are idle. A warp takes as long as
// the slowest of its constraints, so warps with fewer constraints are faster. H200, solve of scene washer, 4,600
// constraints: 0.335, 0.315, 0.294, 0.287, 0.288, 0.290 ms with 1, 2, 4, 8, 16, 32 work-items per constraint.
#define MAX_SPREAD 8

// kernel arguments that follow the step: RELAY_* for relay, HUBS_* for relay_hubs; both kernels have the first two
enum
{
	RELAY_MAILBOXES = ARGUMENT_STEP + 1,
	RELAY_STREAM,
	RELAY_COUNT,
	RELAY_SUBSTEPS,
	HUBS_SUBSTEPS = RELAY_COUNT,
	HUBS_PARTS = HUBS_SUBSTEPS + 5,
	HUBS_GROUPS
};

scree_status mailboxes_reserve(OpenCl* d, const Solve* solve)
{
	return scratch_reserve(d, &d->relay.mailboxes, (size_t)solve->bodies * MAILBOX_WORDS * sizeof(cl_ulong));
}

static const struct
{
	const char* name;
	size_t group;
} relay_kernels[RELAY_KERNELS] = {
    [RELAY_COLORS] = {"relay", RELAY_GROUP},
    [RELAY_PLAIN] = {"relay_plain", RELAY_GROUP},
    [RELAY_HINGES] = {"relay_hinges", RELAY_GROUP},
    [RELAY_JOINTS] = {"relay_joints", RELAY_GROUP},
    [RELAY_HUBS] = {"relay_hubs", HUB_GROUP},
    [RELAY_HUBS_HINGES] = {"relay_hubs_hinges", HUB_GROUP},
    [RELAY_HUBS_JOINTS] = {"relay_hubs_joints", HUB_GROUP},
};

bool solve_plain(const OpenCl* d)
{
	const Step* step = &d->constants.step;
	return !step->joints && !step->heavy && !STEP_RARE(*step) && !step->bounces && !step->round;
}

bool solve_hinges(const OpenCl* d)
{
	const Step* step = &d->constants.step;
	return !step->springs && !step->couplings && !step->paths;
}

// Return the kernel for the features of the world: relay_kernel if it has no hubs, hubs_kernel if it has hubs.
static Kernel* relay_kernel(OpenCl* d)
{
	int plain = solve_plain(d) ? RELAY_PLAIN : RELAY_COLORS, joints = solve_hinges(d) ? RELAY_HINGES : RELAY_JOINTS;
	return &d->relay.kernels[d->constants.step.joints ? joints : plain];
}

static Kernel* hubs_kernel(OpenCl* d)
{
	int joints = solve_hinges(d) ? RELAY_HUBS_HINGES : RELAY_HUBS_JOINTS;
	return &d->relay.kernels[d->constants.step.joints ? joints : RELAY_HUBS];
}

// Returns the number of work-groups that solve hubs; the others solve colors. If only one is resident, it solves both.
static size_t hub_groups(OpenCl* d, const Solve* solve)
{
	size_t most = hubs_kernel(d)->groups > 1 ? (size_t)hubs_kernel(d)->groups / 2 : 1,
	       hubs = (size_t)solve->counters->hubs;
	return hubs < most ? hubs : most;
}

static size_t other_most(OpenCl* d, const Solve* solve)
{
	return (size_t)hubs_kernel(d)->groups - hub_groups(d, solve);
}

// Returns the number of work-items per constraint: a power of two up to MAX_SPREAD, as large as `places` allows.
static int spread_of(int constraints, size_t places)
{
	int spread = 1;
	while (spread < MAX_SPREAD && 2 * (size_t)spread * (size_t)constraints <= places)
		spread *= 2;
	return spread;
}

static size_t other_groups(OpenCl* d, const Solve* solve)
{
	size_t most = other_most(d, solve), group = hubs_kernel(d)->group;
	int constraints = solve_constraints(solve), spread = spread_of(constraints, most * group);
	size_t groups = groups_of(constraints * spread, group);
	return groups < most ? groups : most;
}

// Returns whether all constraints of a solve without hubs stay in registers.
static bool relay_holds(OpenCl* d, const Solve* solve)
{
	const Kernel* relay = relay_kernel(d);
	return solve_constraints(solve) <= relay->groups * (int)relay->group;
}

scree_status relay_reserve(OpenCl* d, const Solve* solve)
{
	TRY(mailboxes_reserve(d, solve));
	int constraints = solve_constraints(solve), hubs = solve->counters->hubs;
	bool registers = relay_holds(d, solve);
	if (hubs > 0)
	{
		TRY(scratch_reserve(d, &d->relay.parts, 2 * sizeof(cl_ulong) * (size_t)(constraints + hubs)));
		registers = (size_t)constraints <= other_groups(d, solve) * hubs_kernel(d)->group;
	}
	return scratch_reserve(d, &d->relay.stream,
	                       registers ? 1 : (size_t)constraints * STREAM_FLOAT4S * sizeof(cl_float4));
}

// Tests whether all work-items are resident at once and make progress independently, and writes the result to *runs.
static scree_status probe(OpenCl* d, cl_kernel kernel, cl_mem mailboxes, cl_mem fault, bool* runs)
{
	cl_int rounds = PROBE_ROUNDS, spins = PROBE_SPINS, found = 0;
	TRY(CALL(d->failure, SetKernelArg, kernel, 0, sizeof mailboxes, &mailboxes));
	TRY(CALL(d->failure, SetKernelArg, kernel, 1, sizeof fault, &fault));
	TRY(CALL(d->failure, SetKernelArg, kernel, 2, sizeof rounds, &rounds));
	TRY(CALL(d->failure, SetKernelArg, kernel, 3, sizeof spins, &spins));
	TRY(launch(d, kernel, (size_t)d->relay.groups * d->relay.kernels[RELAY_COLORS].group,
	           d->relay.kernels[RELAY_COLORS].group));
	TRY(read_now(d, fault, 0, sizeof found, &found));
	*runs = found == 0;
	if (found)
		log_sentence(SCREE_LOG_INFO, "%s: %s; the solver does without the relay.", d->device.about.name,
		             found == FAULT_TIMEOUT ? "work-items are not resident at once" : "words arrive in pieces");
	return SCREE_OK;
}

// Computes a lower bound of the number of work-groups that are resident at once. A CPU runs work-items one by one, so
// it gets one work-group of one work-item.
static scree_status count_groups(const OpenCl* d, Kernel* kernel)
{
	size_t most;
	TRY(kernel_group_most(d, kernel->kernel, &most));
	bool cpu = d->device.type & CL_DEVICE_TYPE_CPU;
	kernel->group = cpu ? 1 : kernel->group;
	kernel->groups = cpu ? 1 : d->device.about.compute_units * (int)(most / kernel->group);
	return SCREE_OK;
}

scree_status relay_create(OpenCl* d)
{
	for (int k = 0; k < RELAY_KERNELS; ++k)
		TRY(kernel_create(d, relay_kernels[k].name, relay_kernels[k].group, &d->relay.kernels[k]));
	return SCREE_OK;
}

scree_status relay_bind(OpenCl* d, Per per)
{
	for (int k = 0; k < RELAY_KERNELS; ++k)
		TRY(kernel_bind(d, per, &d->relay.kernels[k]));
	return SCREE_OK;
}

scree_status relay_open(OpenCl* d)
{
	// the probe of the persistent kernel (GPUs only) found that its work-groups are not resident at once
	if (d->persistent.kernel.kernel && d->persistent.groups == 0)
		return SCREE_OK;
	for (int k = 0; k < RELAY_KERNELS; ++k)
		TRY(count_groups(d, &d->relay.kernels[k]));
	d->relay.groups = d->relay.kernels[RELAY_COLORS].groups;

	cl_int error;
	cl_mem mailboxes = NULL, fault = NULL;
	bool runs = false;
	cl_kernel kernel;
	CREATE(d->failure, kernel, error, Kernel, d->program, "relay_probe");
	scree_status status = context_check(d->failure, "clCreateKernel", error);
	if (!status)
		status = buffer_create(d, 2 * sizeof(cl_ulong) * (size_t)d->relay.groups * d->relay.kernels[RELAY_COLORS].group,
		                       &mailboxes);
	if (!status)
		status = buffer_create(d, sizeof(cl_int), &fault);
	if (!status)
		status = probe(d, kernel, mailboxes, fault, &runs);
	if (!runs)
		d->relay.groups = 0;
	RELEASE(d->failure, MemObject, mailboxes);
	RELEASE(d->failure, MemObject, fault);
	RELEASE(d->failure, Kernel, kernel);
	return status;
}

void relay_close(OpenCl* d)
{
	for (int k = 0; k < RELAY_KERNELS; ++k)
		RELEASE(d->failure, Kernel, d->relay.kernels[k].kernel);
	scratch_release(d, &d->relay.mailboxes);
	scratch_release(d, &d->relay.stream);
	scratch_release(d, &d->relay.parts);
}

// Sets the arguments that both kernels have. substeps: index of the argument `substeps` and the first of five.
static scree_status relay_arguments(OpenCl* d, const Solve* solve, cl_kernel kernel, cl_uint substeps, cl_int spread)
{
	cl_int spins = SPINS;
	TRY(CALL(d->failure, SetKernelArg, kernel, RELAY_MAILBOXES, sizeof(cl_mem), &d->relay.mailboxes.buffer));
	TRY(CALL(d->failure, SetKernelArg, kernel, RELAY_STREAM, sizeof(cl_mem), &d->relay.stream.buffer));
	cl_int passes = schedule_passes(solve->substeps, solve->bounces);
	const cl_int* values[] = {&solve->substeps, &passes, &solve->bound, &spins, &spread};
	for (cl_uint k = 0; k < 5; ++k)
		TRY(CALL(d->failure, SetKernelArg, kernel, substeps + k, sizeof(cl_int), values[k]));
	return SCREE_OK;
}

static scree_status relay_hubs_run(OpenCl* d, const Solve* solve)
{
	cl_kernel kernel = hubs_kernel(d)->kernel;
	cl_int groups = (cl_int)hub_groups(d, solve),
	       spread = spread_of(solve_constraints(solve), other_most(d, solve) * hubs_kernel(d)->group);
	TRY(kernel_step(d, hubs_kernel(d)));
	TRY(relay_arguments(d, solve, kernel, HUBS_SUBSTEPS, spread));
	TRY(CALL(d->failure, SetKernelArg, kernel, HUBS_PARTS, sizeof(cl_mem), &d->relay.parts.buffer));
	TRY(CALL(d->failure, SetKernelArg, kernel, HUBS_GROUPS, sizeof groups, &groups));
	size_t all = hubs_kernel(d)->groups > 1 ? (size_t)groups + other_groups(d, solve) : 1;
	return launch(d, kernel, all * hubs_kernel(d)->group, hubs_kernel(d)->group);
}

scree_status relay_run(OpenCl* d, const Solve* solve)
{
	if (solve->counters->hubs > 0)
		return relay_hubs_run(d, solve);
	Kernel* relay = relay_kernel(d);
	size_t most = (size_t)relay->groups;
	cl_int constraints = solve_constraints(solve), spread = spread_of(constraints, most * relay->group);
	TRY(kernel_step(d, relay));
	TRY(relay_arguments(d, solve, relay->kernel, RELAY_SUBSTEPS, spread));
	TRY(CALL(d->failure, SetKernelArg, relay->kernel, RELAY_COUNT, sizeof constraints, &constraints));
	size_t groups = groups_of(constraints * spread, relay->group);
	return launch(d, relay->kernel, (groups < most ? groups : most) * relay->group, relay->group);
}
