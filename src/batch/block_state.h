// SPDX-License-Identifier: MIT
// block_state.h -- declares a block: worlds of a batch that share pools.
#ifndef BLOCK_STATE_H
#define BLOCK_STATE_H
#include "batch/channel_set.h"
#include "batch/world_order.h"

// Bits of Block.plan: the world is paused afterwards; it is put back to its template, and runs.
#define PLAN_PAUSE 1
#define PLAN_RESET 2

typedef struct // duties of the next step of a block, done once, for a world that begins to run
{
	float h;                             // s: substep of the last step of the world
	bool dirty, surfaces, presses, taut; // for Pipeline.dirty, surfaces_changed, counters.presses, taut
	bool lengths;                        // for Pipeline.lengths_vary: h is that of the block, whose worlds differ in it
	bool
	    uncounted; // touches of the outputs were not counted since these were bound, or since the world got another state
} Pending;

typedef struct
{
	Backend* backend;
	Pipeline pipeline;
	StepRequest request;
	const WorldOrder* order; // all worlds of the batch
	int first, worlds;       // range of places of this order; the row of a world is its number in this range
	int* kinematics;         // indices of the kinematic bodies, if they are few; for `request`
	const Template* templates;
	int template_count;
	int* template_of;         // for each world of the batch: index of its template
	const int* next_of;       // and that after its next reset; null if templates stay
	int* spare_of;            // for each template: its spare bay, -1 if no world of the block may have it
	int touching;             // maximum number of contacts with a color of a template
	int empty;                // spare bay of a world without items
	int stage, stages;        // spare bays through which states of worlds come and go: the first one, and their number
	Int2* copies;             // room for one copy per world
	int* rows;                // row of the world of each copy
	int* bay_of;              // by row: bay of the world; below `worlds` for a world that runs, else spare
	int* row_of;              // by bay, below `worlds`: row of its world, -1 for none
	Pending* paused;          // by row
	uint64_t* targets;        // by row: set of pending targets (template_targets.h); null if no template has any
	Command* target_commands; // room for the commands of `target_capacity` targets
	int target_capacity;
	uint8_t* plan;                 // by row: bits of PLAN_*, for block_arrange
	int* unused;                   // spare bays for paused worlds that contain none
	int unused_count, paused_most; // number of these; number of spare bays for paused worlds
	int crowded,
	    first_crowded;      // worlds paused in the last call of block_step since they were crowded: number, first row
	const ChannelSet* sets; // lists of channels of the batch, CHANNEL_LISTS of them; null before any was bound
	ChannelList lists[CHANNEL_LISTS];
	bool angles;              // outputs of joints are written in lanes
	const Channel* outputs;   // channels of the outputs that the pools have
	float* converted;         // room for rows of a list that are converted or gathered
	scree_vec* gravity;       // m/s^2, for each world of the batch; null: that of the templates
	BayGravity* gravity_rows; // room for one row per world, once worlds have had different gravity
	bool visits_due;          // true: the worlds have made a step since visits to their sensors were found
	int pulled_first;         // rows whose gravity may have changed since the last step: the first one,
	int pulled_end;           // and one past the last
	float gravity_dt;         // s: length of the step for which the rows were computed
	int gravity_substeps;     // and its number of substeps
	struct BlockOwn* own;     // own values of the worlds; null: all have those of their templates
	bool restarts;            // Template.restarts of some template
	bool chains_stale;        // the chains of some world have changed since they were written
} Block;

// Returns the number of the world of a row in the batch, its row, and the index of its template.
static inline int block_world(const Block* block, int row) { return order_world(block->order, block->first + row); }
static inline int block_row(const Block* block, int world) { return order_place(block->order, world) - block->first; }
static inline int block_number(const Block* block, int row) { return block->template_of[block_world(block, row)]; }

static inline const Template* block_template(const Block* block, int row)
{
	return block->templates + block_number(block, row);
}

// Adds a copy of a world to the list of the block. row: row of the world, -1 if the copy is no world of the batch.
static inline void block_add_copy(Block* block, int* count, int from, int to, int row)
{
	block->copies[*count] = make_int2(from, to);
	block->rows[(*count)++] = row;
}

static inline bool block_runs(const Block* block, int row) { return block->bay_of[row] < block->worlds; }

#endif
