// SPDX-License-Identifier: MIT
// block_state.h -- declares a block: worlds of a batch that share pools.
#ifndef BLOCK_STATE_H
#define BLOCK_STATE_H
#include "batch/channel_set.h"

typedef struct
{
	Backend* backend;
	Pipeline pipeline;
	StepRequest request;
	int first, worlds; // range of worlds of the batch
	int* kinematics;   // indices of the kinematic bodies, if they are few; for `request`
	const Template* templates;
	const int* template_of; // for each world of the batch: index of its template
	int* spare_of;          // for each template: its spare bay, -1 if no world of the block has it
	Int2* copies;           // room for one copy per world
	const ChannelSet* sets; // lists of channels of the batch, CHANNEL_LISTS of them; null before any was bound
	ChannelList lists[CHANNEL_LISTS];
	float* rows; // room for rows of a list that are converted or gathered
} Block;

#endif
