// SPDX-License-Identifier: MIT
// bay_solve.h -- launches the solve of a batch as one kernel (bay_solve.cl).
#ifndef BAY_SOLVE_H
#define BAY_SOLVE_H
#include "opencl/opencl_state.h"

scree_status bay_solve_open(OpenCl* d);
void bay_solve_close(OpenCl* d);
scree_status bay_solve_bind(OpenCl* d, Per per);

// Returns whether this form can execute a solve: the pools have bays, which fit into the local memory of a work-group.
bool bay_solve_fits(const OpenCl* d, const Step* step, const Solve* solve);

// Reserves memory for a solve; then executes it, apart from the end of the step (solve_end).
scree_status bay_solve_reserve(OpenCl* d, const Solve* solve);
scree_status bay_solve_run(OpenCl* d, const Solve* solve);

#endif
