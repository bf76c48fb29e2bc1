// SPDX-License-Identifier: MIT
// channel_set.h -- declares a list of channels that the user bound, resolved for each template of a batch.
#ifndef CHANNEL_SET_H
#define CHANNEL_SET_H
#include "batch/channel_objects.h"
#include "batch/template.h"
#include "world/check.h"

#define BOUND_ROWS 16 // number of rows whose bounds are adjacent in ChannelSet.least and .most

typedef struct
{
	int count, columns;                      // numbers of channels and of columns
	int groups;                              // number of groups: those of bodies first, then those of joints, then rays
	int touch_group, joint_group, ray_group; // first group of touches, of joints, and of rays
	float* memory;                           // a row for each world, of the user or of the batch
	bool owned;                              // the memory is of the batch
	Backend* pins;                           // device that pins it; null: it is ordinary memory
	bool shared;              // rows are in memory of the device that another program uses too; `memory` is null
	Channel* channels;        // for each template, those of all groups
	int* group;               // first channel of each group, then `count`
	int parameters;           // number of inputs that are parameters
	Channel* parameter;       // for each template, those
	bool pulls, owns, masses; // some parameter is gravity; some is another one; some is a mass
	bool parts;               // some column of a parameter has a rule beside its range
	ColumnRule* rules;        // for each column
	float *least, *most;      // bounds of the values of several rows
	double unit;              // unit of length, m; 0 for metres
	bool poses;               // some input is a pose, whose rotation is normalized
	bool aims, acts;          // some input is a target; some input is a force or torque
} ChannelSet;

// Resolves channels for all templates. The definitions are checked (channel_check). On failure channels_close must follow.
scree_status channels_open(ChannelSet* set, const char* function, bool inputs, const scree_channel* channels, int count,
                           const Template* templates, int template_count);
void channels_close(ChannelSet* set);

#endif
