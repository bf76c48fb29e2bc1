// SPDX-License-Identifier: MIT
// channel_objects.h -- checks a channel, finds its object in a template, and returns the rules of its columns.
#ifndef CHANNEL_OBJECTS_H
#define CHANNEL_OBJECTS_H
#include "pools/channel_types.h"
#include "world/check.h"

#define MOST_RAYS    1024 // maximum number of rays of a channel
#define MOST_COLUMNS 4096 // maximum number of columns of a list

typedef struct // the rule for the values of a column
{
	float least, most;
	int8_t power; // power of length
	int8_t part;  // PART_*, or -1 if the range is the whole rule
} ColumnRule;

#define PART_POSE    0 // first column of a pose
#define PART_INERTIA 1 // 0, or at least LEAST_INERTIA
#define PART_SWITCH  2 // 0 or 1

typedef struct
{
	const char* function;
	int channel, number; // indices of the channel, and of the template
} ChannelPlace;

// Returns the number of columns of a channel; the number of parts that kernels process; whether it is one of a joint.
int channel_columns(const scree_channel* channel);
int channel_parts(const scree_channel* channel);
bool channel_of_joint(scree_channel_kind kind);

// Returns whether a kind of input is a parameter, which the host applies (block_own.h).
bool channel_is_parameter(int kind);

// Checks a channel without its objects.
scree_status channel_check(ChannelPlace at, const scree_channel* channel, bool inputs);

// Sets *made to a part of a channel in a template. If the template lacks an object, sets the kind to CHANNEL_KINDS. Fails if
// the kind of channel does not suit the object.
scree_status channel_find(Channel* made, ChannelPlace at, const scree_channel* channel, int ray,
                          const scree_world* world);

// Sets the rules of all columns of a channel whose objects the template has.
void channel_rules(ColumnRule* rules, const scree_channel* channel, const scree_world* world);

#endif
