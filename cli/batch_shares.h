// SPDX-License-Identifier: MIT
// batch_shares.h -- runs many copies of a scene in one batch, or in several that threads step at the same time, and measures the steps.
#ifndef BATCH_SHARES_H
#define BATCH_SHARES_H
#include "batch_drive.h"
#include "cli/common/open_scene.h"
#include "platform/threads.h"

typedef struct // a batch and the thread that steps it
{
	BatchDrive drive;
	scree_batch* batch;
	scree_status status;
	char sentence[SCENE_SENTENCE]; // reason, if the status is not SCREE_OK
} BatchShare;

typedef struct
{
	const Options* options;
	const Scene* scene;
	scree_world* alone; // template of the batches; not owned
	int worlds, steps;  // number of worlds of all batches; steps of a run
	int share_count;
	BatchShare* shares;
	Threads* threads;               // null: one batch, which the caller steps
	uint64_t* hashes;               // [worlds]: at the end of the run
	scree_batch_counters* counters; // [worlds]
	double* times;                  // s: measured steps of the run
	int count, begin, end;          // their number; steps that are taken next
	int columns;                    // columns of the outputs
	double create;                  // s: time to create the batches
} BatchShares;

// Opens the memory of runs, which batch_shares_close releases, also on failure. Returns an exit code.
int batch_shares_open(BatchShares* run);
void batch_shares_close(BatchShares* run);

// Creates the batches, takes all steps, reads hashes and counters, and destroys the batches. Returns an exit code.
int batch_shares_measure(BatchShares* run);

#endif
