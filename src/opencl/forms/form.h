// SPDX-License-Identifier: MIT
// form.h -- executes a solve in the fastest form: launches by color, a relay (relay.cl) or tiles (tiles.cl).
#ifndef OPENCL_FORM_H
#define OPENCL_FORM_H
#include "opencl/opencl_state.h"

bool opencl_form(Backend* b, SolveForm form);
bool opencl_finds_layout(Backend* b, const Step* step, const Solve* solve);
scree_status opencl_solve(Backend* b, const Step* step, const Solve* solve, RunList* list);

#endif
