// SPDX-License-Identifier: MIT
// form.c -- executes a solve in the fastest form: launches by color, a relay (relay.cl) or tiles (tiles.cl).
#include "opencl/forms/form.h"
#include "opencl/execute.h"
#include "opencl/forms/bay_solve.h"
#include "opencl/forms/relay.h"
#include "opencl/forms/tiles.h"
#include "opencl/launch.h"
#include "opencl/queue.h"
#include "platform/error.h"

#define RELAY_CONSTRAINTS 1000000 // maximum number of constraints for which a relay is faster than the other forms

// Maximum number of work-groups per compute unit for the kernel continuous. Up to this number each item has a
// work-group of its own, because items that share a work-group delay each other.
#define CONTINUOUS_GROUPS 12

// indices of the arguments of the kernel solve_end that follow the step
enum
{
	END_BODIES = ARGUMENT_STEP + 1,
	END_SUBSTEPS,
	END_PASSES,
	END_BOUND
};

// Reserves memory for a solve by relay or tiles. If this fails, the solve uses launches by color, without this memory.
static scree_status form_reserve(OpenCl* d, const Solve* solve, SolveForm form)
{
	return form == FORM_BAYS    ? bay_solve_reserve(d, solve)
	       : form == FORM_RELAY ? relay_reserve(d, solve)
	                            : tiles_reserve(d, solve);
}

static SolveForm solve_form(OpenCl* d, const Step* step, const Solve* solve)
{
	// joints without a color are solved by separate runs, which relay and tiles do not have
	bool uncolored = solve->chains > 0 || solve->branches > 0 || solve->counters->overflow > 0;
	if (d->relay.groups == 0 || d->form == FORM_LAUNCHES || uncolored)
		return FORM_LAUNCHES;
	if (step->bays.worlds > 0) // relay and tiles do not read the values of each world of a batch
		return bay_solve_fits(d, step, solve) ? FORM_BAYS : FORM_LAUNCHES;
	bool few = solve_constraints(solve) <= RELAY_CONSTRAINTS;
	if (d->form == FORM_RELAY || (d->form == FORM_ANY && few))
		return FORM_RELAY;
	// a hub has spokes in many tiles, and a body without collidables is in no tile
	bool tiles = d->tiles.runs && solve->counters->hubs == 0 && !solve->unlocked &&
	             (d->form == FORM_TILES || tiles_pay(d, solve));
	return tiles ? FORM_TILES : FORM_LAUNCHES;
}

// Integrates bodies without constraints, finalizes all bodies, tests fast bodies for continuous collision, and
// finalizes joints if their rare rows are in use.
static scree_status solve_end(OpenCl* d, const Solve* solve)
{
	cl_kernel kernel = d->solve_end.kernel;
	cl_int passes = schedule_passes(solve->substeps, solve->bounces);
	Run continuous = {.kernel_id = KERNEL_continuous, .end = solve->collidables, .count = COUNT(continuous_items)};
	TRY(kernel_step(d, &d->solve_end));
	TRY(CALL(d->failure, SetKernelArg, kernel, END_BODIES, sizeof(cl_int), &solve->bodies));
	TRY(CALL(d->failure, SetKernelArg, kernel, END_SUBSTEPS, sizeof(cl_int), &solve->substeps));
	TRY(CALL(d->failure, SetKernelArg, kernel, END_PASSES, sizeof(cl_int), &passes));
	TRY(CALL(d->failure, SetKernelArg, kernel, END_BOUND, sizeof(cl_int), &solve->bound));
	size_t group = d->solve_end.group;
	d->timing.stage = STAGE_finalize;
	TRY(launch(d, kernel, groups_of(solve->bodies, group) * group, group));
	TRY(kernel_run_within(d, &continuous, 1, CONTINUOUS_GROUPS));
	int joints = solve->places > 0 ? solve->places : solve->counters->layout[CONSTRAINT_JOINT].begin[COLORS + 1];
	Run joint = {.kernel_id = KERNEL_joint_finalize, .end = joints, .count = solve->bound};
	return solve->rare[CONSTRAINT_JOINT] && joints > 0 ? kernel_run(d, &joint) : SCREE_OK;
}

static scree_status run_now(Backend* b, const Step* step, RunList* list)
{
	scree_status status = opencl_run(b, step, list->runs, list->count);
	list->count = 0;
	return status;
}

bool opencl_form(Backend* b, SolveForm form)
{
	OpenCl* d = b->state;
	// a CPU has the forms of GPUs only for tests, and takes minutes to compile them
	bool others = d->relay.groups > 0 && !(d->device.type & CL_DEVICE_TYPE_CPU);
	if ((!others && form != FORM_ANY) || (form == FORM_TILES && !d->tiles.runs))
		return false;
	d->form = others ? form : FORM_LAUNCHES;
	d->tiles.stale = true;
	return true;
}

bool opencl_finds_layout(Backend* b, const Step* step, const Solve* solve)
{
	// the solve must not lack memory later, because other forms need the layout on the host
	OpenCl* d = b->state;
	return solve_form(d, step, solve) == FORM_BAYS && !solve->taut && bay_solve_reserve(d, solve) == SCREE_OK;
}

scree_status opencl_solve(Backend* b, const Step* step, const Solve* solve, RunList* list)
{
	OpenCl* d = b->state;
	step_set(d, step);
	SolveForm form = solve_form(d, step, solve);
	scree_status reserved = form == FORM_LAUNCHES ? SCREE_OK : form_reserve(d, solve, form);
	if (reserved != SCREE_OK)
	{
		if (reserved != SCREE_ERROR_OUT_OF_MEMORY)
			return reserved;
		log_sentence(SCREE_LOG_WARNING, "%s: %s; the solver is slower without.", b->name, scree_error());
		d->form = form = FORM_LAUNCHES;
	}
	if (form == FORM_LAUNCHES)
	{
		solve_list(solve, list);
		return run_now(b, step, list);
	}
	d->timing.stage = STAGE_solve;
	if (solve->taut)
	{
		runs_add(list, KERNEL_solve_begin, 0, solve_bodies(solve), solve->visited, 0);
		solve_taut(solve, list);
		TRY(run_now(b, step, list));
	}
	TRY(form == FORM_BAYS ? bay_solve_run(d, solve) : form == FORM_RELAY ? relay_run(d, solve) : tiles_run(d, solve));
	if (solve->taut)
	{
		solve_slack(solve, list);
		TRY(run_now(b, step, list));
	}
	TRY(solve_end(d, solve));
	return CALL(d->failure, Flush, d->queue);
}
