// SPDX-License-Identifier: MIT
// stage_lists.h -- lists the runs of the stages. Each function adds runs to Pipeline.list or to the given list.
#ifndef STAGE_LISTS_H
#define STAGE_LISTS_H
#include "step/pipeline_state.h"

#define STAGE_RUNS_MOST (4 * MAX_ROUNDS + 8 * CONSTRAINT_KINDS + 128) // maximum number of runs listed before the solve

// Lists the runs that compute boxes and trees. If the host decides to sort a tree, also executes the list.
scree_status list_transform(Pipeline* pipeline, const Step* step, int bodies);
void list_broad_phase(Pipeline* pipeline, const Step* step, int bodies);
void list_narrow_phase(Pipeline* pipeline, const Step* step, int bodies);
// Lists the runs that wake islands and, in some steps, search for islands and put them to sleep.
void list_sleep(Pipeline* pipeline, const Step* step, const StepRequest* request);
// Lists the coloring rounds `from` to `to` - 1, and the layout, which the device skips if constraints have no color.
// rest: true if one worker then colors the constraints that are left (color_greedy).
void list_color(Pipeline* pipeline, int bodies, int from, int to, bool rest);

// Lists the runs that lay out the constraints by color, if some began or ended. colored: index in Counters.uncolored of
// the number of those without a color.
void list_layout(Pipeline* pipeline, int bodies, int colored);

// Lists the runs that compute all boxes of a tree, also those of the room for leaves that are appended. leaf, node:
// kernels; how: their argument, the tree in bit 0; count: NO_COUNT, or a counter; if it is 0, the runs do nothing.
void list_tree(RunList* list, const TreeState* state, int leaf, int node, int how, int count);
// Lists the run that notes the leaves of tree 0 that were appended since the last step or query.
void list_new_leaves(RunList* list, TreeState* state);
// Lists the runs that compute the boxes of the nodes of tree 0 in stale_nodes. kernel: tree_node or query_node.
void list_stale_nodes(RunList* list, const Tree* tree, int kernel);

// Lists the runs that sort the leaves of a tree. boxes: 0 to sort by the boxes of the step, TREE_QUERIES to sort by the
// boxes for queries. count: NO_COUNT, or a counter; if it is 0, the runs do nothing.
void list_leaf_order(RunList* list, const Tree* tree, int t, int boxes, int count);

// Lists the run that begins the step of the values of each world, in a batch.
void list_bays(Pipeline* pipeline);

// Lists the runs that find bodies pressed against bodies that cannot move. may_wait: true if the layout may be old.
void list_presses(Pipeline* pipeline, const Step* step, int bodies, bool may_wait);
// Lists the runs that compute the forces of fields at the start of the step. bound: as for solve_start.
void list_fields(Pipeline* pipeline, const Step* step, const StepRequest* request, int bound);

// Lists the run that makes all groups of contacts active, after contacts were packed.
void list_packed_groups(Pipeline* pipeline);

#endif
