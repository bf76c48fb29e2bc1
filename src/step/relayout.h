// SPDX-License-Identifier: MIT
// relayout.h -- lays out the constraints of a world whose slots the host has written.
#ifndef RELAYOUT_H
#define RELAYOUT_H
#include "step/pipeline_state.h"

// Gives each constraint with a color its place, and its rows their values. No constraint has a place; kept values are
// at the slots. Pipeline.counters has the numbers of slots; the other counters of constraints are set here. spokes:
// some contact is a spoke.
scree_status pipeline_lay_out(Pipeline* pipeline, int bodies, bool spokes);

#endif
