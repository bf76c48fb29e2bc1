// SPDX-License-Identifier: MIT
// stage_lists.h -- lists of the runs of the stages. Each function adds runs to Pipeline.list.
#ifndef STAGE_LISTS_H
#define STAGE_LISTS_H
#include "step/pipeline_state.h"

#define STAGE_RUNS_MOST (4 * MAX_ROUNDS + 8 * CONSTRAINT_KINDS + 128) // runs in the longest list before the solve

// Computes world boxes from the bodies, and the trees from the boxes. It executes the list if a tree must be sorted.
scree_status list_transform(Pipeline* pipeline, const Step* step);
void list_broad_phase(Pipeline* pipeline, const Step* step, int bodies);
void list_narrow_phase(Pipeline* pipeline, const Step* step, int bodies);
// Runs coloring rounds from one to another, then lays out the constraints if all have colors.
void list_color(Pipeline* pipeline, int bodies, int from, int to);

// Sorts the leaves of a tree by its boxes, if a counter is not 0: those of the step (0), or for queries (TREE_QUERIES).
void list_leaf_order(RunList* list, const Tree* tree, int t, int boxes, int count);

// Finds the bodies that are pressed against others that cannot move. may_wait: the layout may be out of date.
void list_presses(Pipeline* pipeline, int bodies, bool may_wait);
// Computes the forces of fields from poses and velocities at the start of the step.
void list_fields(Pipeline* pipeline, const StepRequest* request, int bound);

#endif
