// SPDX-License-Identifier: MIT
// channel_types.h -- declares channels: columns of the rows of a batch, which set or read values of each world.
#ifndef CHANNEL_TYPES_H
#define CHANNEL_TYPES_H
#include "dialect/dialect.h"

// Lists of channels, in the order of scree_channels.
#define CHANNELS_STEP    0 // inputs of each step
#define CHANNELS_RESET   1 // inputs of a reset
#define CHANNELS_OUTPUTS 2
#define CHANNEL_LISTS    3

// Bits of the first part of the argument of kernels of channels.
#define CHANNEL_LIST   3 // mask: number of the list
#define CHANNEL_COPIES 4 // items are those of the last copies (pool bay_copy)
#define CHANNEL_AGAIN  8 // only forces and torques act, in the second and later steps of a call
#define CHANNEL_AIMS \
	16 // only targets act: bodies get the velocity to reach them; with CHANNEL_ARRIVES they stop instead
#define CHANNEL_ARRIVES 32 // only targets act: bodies are placed after the step

// Second part of the argument: first group, and number of groups.
#define CHANNEL_FIRST                4096 // groups of a list are at most as many as columns (MOST_COLUMNS)
#define CHANNEL_GROUPS(first, count) ((first) + CHANNEL_FIRST * (count))

// Bits of Channel.which for touches.
#define TOUCH_BODY       1 // `item` is a body, whose collidables all count
#define TOUCH_OTHER_BODY 2 // `other` is a body

typedef enum
{
#define INPUT(name, columns, of)  CHANNEL_SET_##name,
#define OUTPUT(name, columns, of) CHANNEL_GET_##name,
#include "pools/channel_kinds.def"
#undef INPUT
#undef OUTPUT
	CHANNEL_KINDS
} ChannelKind;

typedef struct // 80 bytes: a channel of a template
{
	int kind;   // ChannelKind; CHANNEL_KINDS if the template lacks the object: inputs have no effect, outputs are 0
	int item;   // index of the body, collidable or joint within the world
	int other;  // index of the second body or collidable; -1 for none
	int column; // first column
	int which;  // coordinate of a joint; or TOUCH_* bits
	int locks;  // locks of a body: 1: x; 2: y; 4: rotation
	float lower, upper; // m or rad: range of the target of a joint
	int bits;           // COMMAND_JOINED or 0, for inputs of a body
	int missing;        // number of columns that are 0 if the template lacks the object of an output
	int unused[2];
	Float4 place;          // m: point in the frame of the body (x, y); or start and path of a ray
	Word64 category, mask; // filter of a ray
} Channel;

typedef struct // 32 bytes: a list of channels, whose groups contain the channels of one object
{
	int first;    // first channel of template 0 in the pool channel; those of template t are t * channels further
	int channels; // number of channels
	int groups, first_group;
	int columns; // number of columns of a row
	int column;  // first column of row 0 in the pool column
	int bounds; // place in the pool column: least values of all columns, then largest ones; for inputs in shared memory
	int wrong;  // channel_check: number of values from the first one out of range to the last one; 0: there is none
} ChannelList;

#endif
