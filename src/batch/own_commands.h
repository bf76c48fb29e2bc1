// SPDX-License-Identifier: MIT
// own_commands.h -- makes and sends the commands for worlds of a block whose own values change.
#ifndef OWN_COMMANDS_H
#define OWN_COMMANDS_H
#include "batch/block_state.h"
#include "batch/own_chains.h"
#include "batch/own_host.h"

typedef struct // host data of a template with the own values of one world; null before a world of the template needs it
{
	scree_world* world;
	uint8_t* joints; // per joint: IN_CHAIN, RESTARTS and RECHAINED bits
} Patched;

#define IN_CHAIN  1
#define RESTARTS  2
#define RECHAINED 4 // entered or left a chain

typedef struct BlockOwn
{
	size_t bytes;       // size of the own values of a world
	char* values;       // by row
	char* now;          // room for those of a world that changes
	uint8_t* search;    // by row: 1 if the next step of the world searches for its chains
	int searches;       // number of these rows
	uint8_t* tables;    // by row: 1 if the world has a table of attributes of its own
	int first_table;    // first attribute of the table of row 0
	int attributes;     // number of attributes of a table
	Patched* patched;   // by template
	OwnChains** chains; // by row; null: those of the template
	ChainList list;
	Command* commands; // those of each world are adjacent
	int* groups;       // first command of each world
	int count, worlds, capacity, group_capacity;
} BlockOwn;

typedef struct // a world that changes
{
	Block* block;
	int row, bay;
	const Template* from;
	Patched* patched;
	Own before, now;
} Change;

static inline scree_status own_no_memory(const Block* block)
{
	return fail(SCREE_ERROR_OUT_OF_MEMORY, "no memory for the masses and surfaces of %d worlds", block->worlds);
}

// Returns the index in the pools of the first attribute of the table of a world.
static inline int own_table(const BlockOwn* own, int row) { return own->first_table + row * own->attributes; }

// Returns the index in the pools of the attribute that is attribute 0 of a world.
static inline int own_origin(const Block* block, int row)
{
	return block->own && block->own->tables[row] ? own_table(block->own, row)
	                                             : block_template(block, row)->first_attribute;
}

// Gives the host data of a template the own values of the world that changes.
scree_status own_patch(Change* c);

// Makes room for the commands of one more world. Sends those of other worlds if they are many.
scree_status own_reserve(Change* c);

// Notes the flags and bounds of a step that the mass of a body needs. Returns its continuous_command in the world alone.
Command own_note_mass(Change* c, int k);

// Add the commands for the mass of body k; for the table of attributes of the world, with `changes` if surfaces of contacts
// must be computed again; for body k, which was enabled or disabled, and its collidables, with a mark for its joints.
void own_add_mass(Change* c, int k);
void own_add_surfaces(Change* c, bool changes);
void own_add_enabled(Change* c, int k);

// Marks a joint that was enabled or disabled, unless that has no effect, because a body is disabled.
void own_mark_joint(Change* c, int k);

// Adds commands for marked joints, which restart.
void own_add_joints(Change* c);

// Sends the commands to the device.
scree_status own_send(Block* block);

#endif
