// SPDX-License-Identifier: MIT
// edit_order.c -- sorts rows by slot, and finds sequences of rows with neighboring slots.
#include "world/upload/edit_order.h"
#include "platform/error.h"
#include "world/memory.h"
#include "world/objects/collidables.h"
#include <string.h>

#define DIGIT_BITS 8
#define DIGITS     (1 << DIGIT_BITS)

typedef struct // `index`: slot of a row, the sort key; `row`: position of the row
{
	uint32_t index, row;
} Place;

// Sorts `places` by index (radix sort), with `other` as a second buffer. Returns the buffer that has the sorted places.
// bits: bitwise OR of all indices.
static Place* sort_places(Place* places, Place* other, int count, uint32_t bits)
{
	for (int shift = 0; bits >> shift != 0; shift += DIGIT_BITS)
	{
		int begins[DIGITS] = {0}, sum = 0;
		for (int k = 0; k < count; ++k)
			++begins[places[k].index >> shift & (DIGITS - 1)];
		for (int digit = 0; digit < DIGITS; ++digit)
		{
			int size = begins[digit];
			begins[digit] = sum;
			sum += size;
		}
		for (int k = 0; k < count; ++k)
			other[begins[places[k].index >> shift & (DIGITS - 1)]++] = places[k];
		Place* sorted = other;
		other = places;
		places = sorted;
	}
	return places;
}

// Returns the slot of row k, which is the first member of the row. bytes: size of a row.
static uint32_t row_index(const void* rows, size_t bytes, int k)
{
	uint32_t index;
	memcpy(&index, (const char*)rows + (size_t)k * bytes, sizeof index);
	return index;
}

// Returns the bytes of memory that sort_rows needs: 0 if the rows are already sorted, as in a new world.
static size_t sort_bytes(const void* rows, int count, size_t bytes)
{
	int k = 1;
	while (k < count && row_index(rows, bytes, k - 1) < row_index(rows, bytes, k))
		++k;
	return k < count ? (size_t)count * (2 * sizeof(Place) + bytes) : 0;
}

static void sort_rows(void* rows, int count, size_t bytes, char* memory)
{
	if (sort_bytes(rows, count, bytes) == 0)
		return;
	Place *places = (Place*)memory, *other = places + count;
	char *to = rows, *from = (char*)(other + count);
	uint32_t bits = 0;
	for (int k = 0; k < count; ++k)
	{
		places[k] = (Place){row_index(rows, bytes, k), (uint32_t)k};
		bits |= places[k].index;
	}
	memcpy(from, rows, (size_t)count * bytes);
	places = sort_places(places, other, count, bits);
	for (int k = 0; k < count; ++k)
		memcpy(to + (size_t)k * bytes, from + places[k].row * bytes, bytes);
}

scree_status edits_sort(scree_world* world)
{
	Edits* p = &world->edits;
	size_t bodies = sort_bytes(p->bodies, p->body_count, sizeof *p->bodies),
	       collidables = sort_bytes(p->collidables, p->collidable_count, sizeof *p->collidables);
	size_t bytes = 1 + (bodies > collidables ? bodies : collidables);
	char* memory = world_scratch(world, bytes);
	if (!memory)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "no memory to upload %zu bytes of changes", bytes);
	sort_rows(p->bodies, p->body_count, sizeof *p->bodies, memory);
	for (int k = 0; k < p->body_count; ++k)
		world->host_bodies[p->bodies[k].index].waiting.row = k + 1;
	sort_rows(p->collidables, p->collidable_count, sizeof *p->collidables, memory);
	for (int k = 0; k < p->collidable_count; ++k)
		world->host_collidables[p->collidables[k].index].waiting.row = k + 1;
	return SCREE_OK;
}

int body_run(const Edits* p, int k)
{
	int end = k + 1;
	while (end < p->body_count && p->bodies[end].index == p->bodies[end - 1].index + 1)
		++end;
	return end;
}

bool edit_is_dead(const scree_world* world, int k)
{
	return collidable_kind(world, world->edits.collidables[k].index) == KIND_DEAD;
}

int collidable_run(const scree_world* world, int k)
{
	const Edits* p = &world->edits;
	int end = k + 1;
	while (end < p->collidable_count && p->collidables[end].index == p->collidables[end - 1].index + 1 &&
	       edit_is_dead(world, end) == edit_is_dead(world, k))
		++end;
	return end;
}
