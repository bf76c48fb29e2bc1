// SPDX-License-Identifier: MIT
// world_row.h -- declares rows: the state of one world of a batch as bytes, without addresses.
//
// A row has a head and, for each pool of bodies, collidables, contacts and joints that outlives a step, the items of
// the world; then its own values (own_values.h). Indices are those within the world, and kept values of constraints are at their slots, as in a spare bay.
// Contact slots behind the last one in use are left out, so a row fits bays with any number of slots. Numbers are
// little-endian.
#ifndef WORLD_ROW_H
#define WORLD_ROW_H
#include "batch/template.h"

enum // kinds of items of a row
{
	ROW_BODIES,
	ROW_COLLIDABLES,
	ROW_CONTACTS,
	ROW_JOINTS,
	ROW_VISITS, // words of the bits of visits, as in VisitBits
	ROW_KINDS
};

typedef struct // 176 bytes: the head of a row
{
	uint64_t magic;       // ROW_MAGIC
	uint64_t version;     // row_version
	uint64_t checksum;    // checksum of the bytes after this member
	uint64_t fingerprint; // Template.fingerprint
	uint64_t bytes;       // size of the row
	int count[ROW_KINDS]; // numbers of items
	float dt;             // s: the last step with dt above 0; 0 if there was none
	BayState state;
	scree_vec gravity;    // m/s^2
	uint64_t targets;     // set of pending targets of its template (template_targets.h)
	uint64_t target_hash; // targets_hash of this set
} RowHead;

#define ROW_MAGIC 0x776f726565726373u // "screerow"
#define ROW_ALIGN 16 // bytes: size and place of the items of each pool are multiples of this, as their vectors need

// Returns the kind of the items of a pool of a row, -1 for a pool that rows do not contain: positions in lists and
// layouts, values that are zero between steps, and what the user has read. The pool bay_visit has words of its own, in
// another order.
int row_kind(PoolId pool);

// Returns the version of rows, which depends on the pools and the types of their items.
uint64_t row_version(void);

// Returns the number of contact slots up to the last one in use.
int row_slots(const CollidablePair* pair, int slots);

// Sets the numbers of items of a row.
void row_count(const Template* from, int contacts, int count[ROW_KINDS]);

// Returns the size of a row with these numbers of items. Sets at[pool], if `at` is not null, to the first byte of a
// pool.
size_t row_layout(const int count[ROW_KINDS], size_t at[POOL_COUNT]);

// Returns the first byte of the own values of a row, which follow the pools.
size_t row_own(const int count[ROW_KINDS]);

// Completes a row, whose head has all members but magic, checksum and bytes, and whose pools are written.
void row_seal(char* row, RowHead* head);

// Reads the head of a row that has at most `bytes` bytes, and checks it. version: row_version. function, number: for
// messages, the name of the caller and the index of the row.
scree_status row_open(const char* row, size_t bytes, uint64_t version, const char* function, int number, RowHead* head);

// Clears what is left over from earlier contacts in the free slots among the items of a pool. pair: pool of this name.
void row_tidy(PoolId pool, char* items, const CollidablePair* pair, int count);

// Clears the attributes of dead collidables of a row, which may be left over from earlier own values.
void row_tidy_dead(char* row, const int count[ROW_KINDS]);

// Sets items that belong to no world, as in a new spare bay.
void row_fill(PoolId pool, char* items, int count);

// Adds `by` to the attributes of the items of a pool of collidables.
void row_shift(PoolId pool, char* items, int count, int by);

#endif
