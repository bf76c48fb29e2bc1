// SPDX-License-Identifier: MIT
// template.h -- reads a world as the template of worlds of a batch, into host memory.
#ifndef BATCH_TEMPLATE_H
#define BATCH_TEMPLATE_H
#include "batch/own_values.h"
#include "batch/template_targets.h"
#include "batch/visit_bits.h"
#include "world/chain/chain_search.h"
#include "world/world.h"

typedef struct
{
	scree_world* world;    // a clone of the world on the CPU, for its handles and definitions
	Pools image;           // the lasting items of the world, and free slots; indices are those within the world
	int count[POOL_COUNT]; // number of items of each pool
	int bodies, collidables, contacts, joints, attributes; // numbers of slots in use
	int touching;                                          // number of contacts with a color
	int first_attribute, first_sample, first_field; // indices of its first items of these kinds in the pools of a batch
	int material_table;  // number of its table of pairs of materials; 0, an empty one, if it has none
	Pipeline pipeline;   // flags, counters and constants of the last step; owns no memory
	StepRequest request; // settings of a step; without arrays
	uint64_t hidden;     // hidden_hash_rest of the world
	char* own;           // own values of the world (own_values.h)
	OwnRules own_rules;
	ChainSearch chains; // chains and branches
	char* chain_memory;
	bool restarts;   // the first step of a world finds other chains than its last one
	int* kinematics; // indices of the kinematic bodies
	VisitBits visits;
	TemplateTargets targets; // pending targets
	uint64_t fingerprint;    // fingerprint_of; 0 before a batch or an insertion sets it
} Template;

// Reads a world. function, number: name of the caller, and index of the world among its templates, for messages; ALONE:
// the world is no template, and is not cloned.
scree_status template_read(scree_world* world, const char* function, int number, Template* made);

// Returns whether worlds of two templates may share a block: those of the same tuning.
bool template_fits(const Template* a, const Template* b);

// Returns the state that the world of a template has in a bay.
BayState template_state(const Template* from);

// Returns the numbers of items of a world of the template, in a bay without a row. number: index of the template.
Bay template_bay(const Template* from, int number);
void template_close(Template* made);

// Numbers the attributes of the image from `first` on, its path samples from `sample` on, and its fields from `field` on.
// table: its material_table.
void template_shift(Template* made, int first, int sample, int field, int table);

// Returns the address of item `first` of a pool of the image.
void* template_item(const Template* from, PoolId pool, int first);

// Returns a view of the own values of a world of the template, and their size in bytes.
static inline Own own_of(const Template* from, char* values)
{
	return own_view(values, from->bodies, from->collidables, from->joints);
}

static inline size_t own_size(const Template* from) { return own_bytes(from->bodies, from->collidables, from->joints); }

#endif
