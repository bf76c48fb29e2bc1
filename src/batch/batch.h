// SPDX-License-Identifier: MIT
// batch.h -- declares a batch: many worlds in blocks.
#ifndef BATCH_H
#define BATCH_H
#include "batch/world_block.h"
#include "platform/threads.h"

struct scree_batch
{
	int worlds, template_count, block_count;
	Template* templates;
	int* template_of; // for each world: index of its template
	int* next_of;     // and that after its next reset; null if templates stay
	WorldOrder order;
	scree_vec* gravity; // m/s^2, for each world; null: that of the templates
	Block* blocks;
	ChannelSet sets[CHANNEL_LISTS];
	Threads* threads;    // workers, each of which steps one block at a time; null if there is one block
	scree_status broken; // sticky error, SCREE_OK while healthy
	bool backwards;      // the next step begins with the last block
	bool warned;         // a warning of a crowded world was logged
	bool timings;        // as in scree_batch_def
	double milliseconds; // duration of the last call that took steps; with timings
};

// Number of blocks for the worlds of each tuning; 0 (default): as the device and the number of worlds suggest. Tests set it.
extern int batch_parts_setting;

// Makes a batch. The arguments are checked. An OpenCL device without a verdict is tested with `test`. On failure *batch is null.
scree_status batch_create(const scree_batch_def* def, const char* function, TestWorlds* test, scree_batch** batch);
void batch_destroy(scree_batch* batch);

// Makes memory for the gravity of each world, at first that of its template.
scree_status batch_own_gravity(scree_batch* batch, const char* function);

typedef scree_status BlockWork(Block* block, const void* context);

// Does work for each block, with all workers. Returns the failure of the first block that failed, after all blocks.
scree_status batch_each(scree_batch* batch, BlockWork* work, const void* context);

#endif
