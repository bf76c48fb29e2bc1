// SPDX-License-Identifier: MIT
// tiles.h -- launches the solve of a large world as passes over tiles of bodies (tiles.cl).
#ifndef OPENCL_TILES_H
#define OPENCL_TILES_H
#include "opencl/opencl_state.h"

scree_status tiles_open(OpenCl* d); // sets TileState.runs; not called if the program has no tiles
void tiles_close(OpenCl* d);
scree_status tiles_bind(OpenCl* d, Per per); // sets arguments like kernel_bind, for all kernels of the tiles
// Returns whether to solve with tiles: they are valid, or likely to pay, or not tried for BORDER_AGE solves.
bool tiles_pay(OpenCl* d, const Solve* solve);
scree_status tiles_reserve(OpenCl* d, const Solve* solve);
scree_status tiles_run(OpenCl* d, const Solve* solve);

#endif
