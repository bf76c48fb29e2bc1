// SPDX-License-Identifier: MIT
// runs.h -- works through lists of runs.
#ifndef OPENCL_RUNS_H
#define OPENCL_RUNS_H
#include "opencl/state.h"

scree_status opencl_run(Backend* b, const Step* step, const Run* runs, int count);

#endif
