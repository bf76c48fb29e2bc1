// SPDX-License-Identifier: MIT
// relayout.h -- lays out constraints between steps: of a world whose slots the host has written, or of a batch.
#ifndef RELAYOUT_H
#define RELAYOUT_H
#include "step/pipeline_state.h"

// Gives each constraint with a color its place, and its rows their values. No constraint has a place; kept values are
// at the slots. Pipeline.counters has the numbers of slots; the other counters of constraints are set here. spokes:
// some contact is a spoke.
scree_status pipeline_lay_out(Pipeline* pipeline, int bodies, bool spokes);

// Lays out the constraints of the live bays of a batch again, between steps. No constraint has a place behind the layout
// afterwards, and no bit of a world changes.
scree_status pipeline_lay_out_bays(Pipeline* pipeline);

#endif
