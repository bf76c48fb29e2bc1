// SPDX-License-Identifier: MIT
// execute.h -- executes lists of runs.
#ifndef EXECUTE_H
#define EXECUTE_H
#include "opencl/opencl_state.h"

scree_status opencl_run(Backend* b, const Step* step, const Run* runs, int count);

#endif
