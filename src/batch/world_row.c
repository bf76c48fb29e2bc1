// SPDX-License-Identifier: MIT
// world_row.c -- lays out rows, seals and checks them.
#include "batch/world_row.h"
#include "dialect/hash_word.h"
#include "step/bay_layout.h"
#include <stddef.h>
#include <string.h>

#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
#error "rows copy numbers as they are in memory, which must be little-endian"
#endif

// Changes whenever the meaning of a row changes. Types and lists of pools are part of row_version.
#define ROW_VERSION 3

int row_kind(PoolId pool)
{
	static const Per pers[] = {PER_BODY, PER_COLLIDABLE, PER_CONTACT, PER_JOINT};
	switch (pool)
	{
	case POOL_contact_place: // the constraints of a row have no places
	case POOL_joint_place:
	case POOL_joint_spot: // follows from the device
	case POOL_joint_event:
	case POOL_hub: // follow from the layout
	case POOL_hub_keys:
	case POOL_hub_colors:
	case POOL_claim0: // zero between steps
	case POOL_claim1:
	case POOL_reported_pose: // belong to the user of a world
	case POOL_reported_sleep:
		return -1;
	default:
		break;
	}
	for (int kind = 0; kind < ROW_VISITS && pool_info[pool].role <= STANDING; ++kind)
		if (pool_info[pool].per == pers[kind])
			return kind;
	return -1;
}

uint64_t row_version(void)
{
	Word64 h = hash_word(ROW_VERSION, (Word)sizeof(RowHead));
	for (int pool = 0; pool < POOL_COUNT; ++pool)
	{
		if (row_kind((PoolId)pool) < 0)
			continue;
		for (const char* letter = pool_info[pool].name; *letter; ++letter)
			h = hash_word(h, (Word)*letter);
		h = hash_word(h, (Word)pool_info[pool].bytes);
	}
	return h;
}

_Static_assert(sizeof(RowHead) % ROW_ALIGN == 0, "the items of the first pool follow the head");

int row_slots(const CollidablePair* pair, int slots)
{
	while (slots > 0 && pair[slots - 1].x < 0)
		--slots;
	return slots;
}

void row_count(const Template* from, int contacts, int count[ROW_KINDS])
{
	count[ROW_BODIES] = from->bodies;
	count[ROW_COLLIDABLES] = from->collidables;
	count[ROW_CONTACTS] = contacts;
	count[ROW_JOINTS] = from->joints;
	count[ROW_VISITS] = visits_of(&from->visits);
}

static size_t aligned(size_t bytes) { return (bytes + ROW_ALIGN - 1) / ROW_ALIGN * ROW_ALIGN; }

size_t row_layout(const int count[ROW_KINDS], size_t at[POOL_COUNT])
{
	size_t end = sizeof(RowHead);
	for (int pool = 0; pool < POOL_COUNT; ++pool)
	{
		int kind = pool == POOL_bay_visit ? ROW_VISITS : row_kind((PoolId)pool);
		if (at)
			at[pool] = end;
		if (kind >= 0)
			end += aligned(pool_info[pool].bytes * (size_t)count[kind]);
	}
	return end + own_bytes(count[ROW_BODIES], count[ROW_COLLIDABLES], count[ROW_JOINTS]);
}

size_t row_own(const int count[ROW_KINDS])
{
	return row_layout(count, NULL) - own_bytes(count[ROW_BODIES], count[ROW_COLLIDABLES], count[ROW_JOINTS]);
}

// Returns a checksum of bytes, whose number is a multiple of 8. Four sums do not wait for each other.
static uint64_t checksum(const char* bytes, size_t size)
{
	uint64_t sum[4] = {1, 2, 3, 4}, word;
	for (size_t k = 0; k < size / sizeof word; ++k)
	{
		memcpy(&word, bytes + k * sizeof word, sizeof word);
		sum[k % 4] = (sum[k % 4] ^ word) * 0x9e3779b97f4a7c15u;
		sum[k % 4] ^= sum[k % 4] >> 32;
	}
	return hash_mix(sum[0] + hash_mix(sum[1] + hash_mix(sum[2] + hash_mix(sum[3] + size))));
}

#define SUMMED offsetof(RowHead, fingerprint) // first byte of the checksum

void row_seal(char* row, RowHead* head)
{
	head->magic = ROW_MAGIC;
	head->bytes = row_layout(head->count, NULL);
	memcpy(row, head, sizeof *head);
	head->checksum = checksum(row + SUMMED, (size_t)head->bytes - SUMMED);
	memcpy(row, head, sizeof *head);
}

scree_status row_open(const char* row, size_t bytes, uint64_t version, const char* function, int number, RowHead* head)
{
	if (bytes < sizeof *head)
		return fail(SCREE_ERROR_INVALID, "%s: state %d has %zu bytes, fewer than its head of %zu", function, number,
		            bytes, sizeof *head);
	memcpy(head, row, sizeof *head);
	if (head->magic != ROW_MAGIC)
		return fail(SCREE_ERROR_INVALID, "%s: state %d does not come from scree_batch_save", function, number);
	if (head->version != version)
		return fail(SCREE_ERROR_INVALID, "%s: state %d comes from another version of the library", function, number);
	for (int kind = 0; kind < ROW_KINDS; ++kind)
		if (head->count[kind] < 0 ||
		    head->count[kind] > (kind == ROW_VISITS ? MOST_BAY_ITEMS * visit_words(MOST_BAY_ITEMS) : MOST_BAY_ITEMS))
			return fail(SCREE_ERROR_INVALID, "%s: state %d is damaged: it has %d %s", function, number,
			            head->count[kind],
			            kind == ROW_BODIES        ? "bodies"
			            : kind == ROW_COLLIDABLES ? "collidables"
			            : kind == ROW_CONTACTS    ? "contacts"
			            : kind == ROW_JOINTS      ? "joints"
			                                      : "words of visits");
	if (head->bytes != row_layout(head->count, NULL))
		return fail(SCREE_ERROR_INVALID, "%s: state %d is damaged: its head says %llu bytes, but its items need %zu",
		            function, number, (unsigned long long)head->bytes, row_layout(head->count, NULL));
	if (head->bytes > bytes)
		return fail(SCREE_ERROR_INVALID, "%s: state %d needs %llu bytes, but state_bytes is %zu", function, number,
		            (unsigned long long)head->bytes, bytes);
	if (head->checksum != checksum(row + SUMMED, (size_t)head->bytes - SUMMED))
		return fail(SCREE_ERROR_INVALID, "%s: state %d is damaged: its bytes do not have its checksum", function,
		            number);
	return SCREE_OK;
}

void row_fill(PoolId pool, char* items, int count)
{
	bool free = pool == POOL_pair || pool == POOL_contact_color || pool == POOL_joint_color;
	memset(items, free ? -1 : 0, pool_info[pool].bytes * (size_t)count);
}

void row_tidy(PoolId pool, char* items, const CollidablePair* pair, int count)
{
	for (int k = 0; k < count; ++k)
		if (pair[k].x < 0)
			row_fill(pool, items + pool_info[pool].bytes * (size_t)k, 1);
}

void row_tidy_dead(char* row, const int count[ROW_KINDS])
{
	size_t at[POOL_COUNT];
	const AttributeIndex none = 0;
	row_layout(count, at);
	for (size_t k = 0; k < (size_t)count[ROW_COLLIDABLES]; ++k)
	{
		int kind; // a row may have any alignment
		memcpy(&kind, row + at[POOL_collidable_kind] + k * sizeof kind, sizeof kind);
		if (kind != KIND_DEAD)
			continue;
		memcpy(row + at[POOL_collidable_attribute] + k * sizeof none, &none, sizeof none);
		memcpy(row + at[POOL_world_shape] + k * sizeof(WorldShape) + offsetof(WorldShape, attribute), &none,
		       sizeof none);
	}
}

void row_shift(PoolId pool, char* items, int count, int by)
{
	if (pool == POOL_collidable_attribute)
		for (int k = 0; k < count; ++k)
			((AttributeIndex*)(void*)items)[k] += by;
	if (pool == POOL_world_shape)
		for (int k = 0; k < count; ++k)
			((WorldShape*)(void*)items)[k].attribute += by;
}
