// SPDX-License-Identifier: MIT
// test_stages.c -- checks kernels of single stages on items made by hand. The reference is the simplest method.
//
// In these kernels items depend on each other, so they run on every backend. test_formulas.c has the kernels with
// independent items, and test_colors.c the colors.
#include "stages/geometry/box.h"
#include "support/each_backend.h"
#include "tools/common/random_numbers.h"
#include <stdlib.h>
#include <string.h>

// ---------------------------------------------------------------------------------------------------------------
// trees
// ---------------------------------------------------------------------------------------------------------------

// Computes the Hilbert codes of 256 by 256 points. The first point is the corner; spacing: distance of neighboring
// points, in cells. The tree spans 65,536 by 65,536 cells. Checks that each point occurs once, and that successive
// codes belong to neighboring points and differ by 1 if `dense` is set, by more otherwise. Returns the lowest code.
static Word check_curve(Backend* b, float corner_x, float corner_y, float spacing, bool dense)
{
	const int side = 256, count = side * side;
	Tree tree = {.leaves = count, .top = 1, .begin = {0, count}, .count = {count, 1}};
	Float4* boxes = calloc((size_t)count + ARITY, sizeof *boxes);
	int* leaves = calloc((size_t)count, sizeof *leaves);
	Word64* keys = calloc((size_t)count, sizeof *keys);
	char* seen = calloc((size_t)count, 1);
	for (int k = 0; k < count; ++k)
	{
		float x = corner_x + spacing * (float)(k % side), y = corner_y + spacing * (float)(k / side);
		box_pack(boxes, k, make_float4(x, y, x, y));
		leaves[k] = k;
	}
	box_pack(boxes, count, make_float4(0.0f, 0.0f, 65535.0f, 65535.0f));
	put_items(b, POOL_tree, 1, &tree);
	put_items(b, POOL_node_box, count + ARITY, boxes);
	put_items(b, POOL_leaf, count, leaves);
	run_one(b, &(Step){0}, KERNEL_tree_root, 1, NO_COUNT, 0);
	run_one(b, &(Step){0}, KERNEL_tree_code, count, NO_COUNT, 0);
	run_sort(b, count, 32, 64);
	run_one(b, &(Step){0}, KERNEL_tree_order, count, NO_COUNT, 0);
	get_items(b, POOL_key, count, keys);
	get_items(b, POOL_leaf, count, leaves);
	for (int k = 0; k < count; ++k)
	{
		int leaf = leaves[k];
		assert_int_equal(leaf, keys[k] & 0xffffffffu);
		assert_false(seen[leaf]++);
		if (k == 0)
			continue;
		int x = abs(leaf % side - leaves[k - 1] % side), y = abs(leaf / side - leaves[k - 1] / side);
		assert_int_equal(x + y, 1);
		Word64 between = (keys[k] >> 32) - (keys[k - 1] >> 32);
		assert_true(dense ? between == 1 : between > 1);
	}
	Word first = (Word)(keys[0] >> 32);
	free(boxes);
	free(leaves);
	free(keys);
	free(seen);
	return first;
}

static void curve_visits_neighbors(void** state)
{
	(void)state;
	for (int k = 0; k < backend_count; ++k)
	{
		check_curve(backends[k], 0.0f, 0.0f, 257.0f, false); // every 257th cell of the whole square
		check_curve(backends[k], 0.0f, 0.0f, 1.0f, true);
		check_curve(backends[k], 512.0f, 33536.0f, 1.0f, true);
		check_curve(backends[k], 65024.0f, 65024.0f, 1.0f, true);
		// start of the third quarter of the curve: its codes have the highest bit set, which makes a signed integer
		// negative
		assert_int_equal(check_curve(backends[k], 32768.0f, 32768.0f, 1.0f, true), 0x80000000u);
	}
}

// ---------------------------------------------------------------------------------------------------------------
// slots of new contacts
// ---------------------------------------------------------------------------------------------------------------

// Pairs are sorted by key. They take the free slots, the lowest slot first, and then new slots behind the last slot.
static void slots_are_lowest_first(void** state)
{
	(void)state;
	const Int2 alive = {90, 91}, free_slot = {-1, -1};
	const Int2 before[7] = {alive, free_slot, alive, free_slot, free_slot, alive, alive};
	const Int2 fresh[5] = {{7, 9}, {0, 3}, {2, 8}, {0, 2}, {7, 8}}; // not sorted by key
	const Int2 after[9] = {alive, {0, 2}, alive, {0, 3}, {2, 8}, alive, alive, {7, 8}, {7, 9}};
	Attribute attribute = {.friction = 0.25f};
	int zeros[100] = {0}, bodies[100];
	Word64 keys[5];
	for (int k = 0; k < 100; ++k)
		bodies[k] = k;
	for (int k = 0; k < 5; ++k)
		keys[k] = (Word64)fresh[k].x << 7 | (Word64)fresh[k].y;
	for (int k = 0; k < backend_count; ++k)
	{
		Backend* b = backends[k];
		for (int room = 8; room <= 10; ++room)
		{
			Counters counters = {.contacts = 7, .alive = 4, .pairs = 5};
			Step step = {.pair_capacity = 5, .contact_capacity = room, .contact_limit = 9, .key_bits = 7};
			Int2 pairs[9];
			put_items(b, POOL_counters, 1, &counters);
			put_items(b, POOL_attribute, 1, &attribute);
			put_items(b, POOL_collidable_attribute, 100, zeros);
			put_items(b, POOL_collidable_body, 100, bodies);
			put_items(b, POOL_pair, 7, before);
			put_items(b, POOL_key, 5, keys);
			run_one(b, &step, KERNEL_contact_admit, 1, NO_COUNT, 0);
			run_one(b, &step, PRIMITIVE_SORT, 5, COUNT(sort_pairs), RUN_PAIR(0, 14));
			run_one(b, &step, KERNEL_contact_mark_free, room, COUNT(search), 0);
			run_one(b, &step, PRIMITIVE_SCAN, room, COUNT(search), 0);
			run_one(b, &step, KERNEL_contact_list_free, room, COUNT(search), 0);
			run_one(b, &step, KERNEL_contact_reserve, 1, NO_COUNT, 0);
			run_one(b, &step, KERNEL_contact_create, room, COUNT(created), 0);
			get_items(b, POOL_counters, 1, &counters);
			get_items(b, POOL_pair, 9, pairs);

			// Nine slots are needed. With room for ten, one slot stays free; with less room, no contact is created.
			bool enough = room == 10;
			assert_int_equal(counters.stalled, !enough);
			assert_int_equal(counters.needed, 9);
			assert_int_equal(counters.created, enough ? 5 : 0);
			assert_int_equal(counters.contacts, enough ? 9 : 7);
			assert_int_equal(counters.alive, enough ? 9 : 4);
			assert_int_equal(counters.live, enough ? 9 : 0);
			assert_memory_equal(pairs, enough ? after : before, enough ? sizeof after : sizeof before);
		}
	}
}

// ---------------------------------------------------------------------------------------------------------------
// contacts are packed
// ---------------------------------------------------------------------------------------------------------------

#define SLOTS 10000

// Returns whether each step writes the whole pool, so that contact_pack need not move its items.
static bool is_scratch(int pool)
{
	return pool == POOL_scan || pool == POOL_free_slot || pool == POOL_began || pool == POOL_uncolored;
}

// Returns the test value for byte k of the item in a slot of a pool.
static unsigned char byte_of(int pool, int slot, size_t k)
{
	return (unsigned char)(slot * 31 + pool * 7 + (int)k * 13 + slot / 256);
}

static bool is_kept(int pool) { return pool_info[pool].per == PER_CONTACT && !is_scratch(pool); }

typedef struct
{
	Int2* pairs;      // {-1, -1}: free slot
	int* constraints; // constraint of each slot, -1 for none
	int* from;        // slot of each contact before it is packed
	int alive;
} Slots;

// Makes slots of which a third is in use. Contacts whose slots are not below the number of contacts move to free slots
// below this number, in order.
static Slots make_slots(void)
{
	Slots s = {calloc(SLOTS + 1, sizeof *s.pairs), calloc(SLOTS, sizeof *s.constraints), calloc(SLOTS, sizeof *s.from),
	           0};
	uint64_t seed = 11;
	int next = 0;
	for (int k = 0; k < SLOTS; ++k)
	{
		bool used = random_below(&seed, 3) == 0;
		s.pairs[k] = used ? make_int2(k, k + 1) : make_int2(-1, -1);
		s.constraints[k] = used && k % 2 ? k : -1;
		s.alive += used;
	}
	for (int k = s.alive; k < SLOTS; ++k)
		if (s.pairs[k].x >= 0)
		{
			while (s.pairs[next].x >= 0)
				++next;
			s.from[next++] = k;
		}
	for (int k = 0; k < s.alive; ++k)
		s.from[k] = s.pairs[k].x >= 0 ? k : s.from[k];
	return s;
}

static void put_contacts(Backend* b, const Slots* s, unsigned char* bytes)
{
	Counters counters = {.contacts = SLOTS, .alive = s->alive + 5, .released = 5};
	for (int pool = 0; pool < POOL_COUNT; ++pool)
	{
		size_t size = pool_info[pool].bytes;
		if (!is_kept(pool))
			continue;
		for (size_t k = 0; k < SLOTS * size; ++k)
			bytes[k] = byte_of(pool, (int)(k / size), k % size);
		put_items(b, (PoolId)pool, SLOTS, bytes);
	}
	put_items(b, POOL_counters, 1, &counters);
	put_items(b, POOL_pair, SLOTS, s->pairs);
	put_items(b, POOL_contact_place, SLOTS, s->constraints);
	put_items(b, POOL_contact_place_slot, SLOTS, s->constraints);
}

// Checks that contact_pack has moved the items of all kept pools with their contacts.
static void check_pools(Backend* b, const Slots* s, unsigned char* bytes)
{
	for (int pool = 0; pool < POOL_COUNT; ++pool)
	{
		size_t size = pool_info[pool].bytes;
		if (!is_kept(pool) || pool == POOL_pair || pool == POOL_contact_place)
			continue;
		get_items(b, (PoolId)pool, SLOTS, bytes);
		for (size_t k = 0; k < (size_t)s->alive * size; ++k)
			if (bytes[k] != byte_of(pool, s->from[k / size], k % size))
				fail_msg("pool %s: slot %d does not hold what slot %d had: contact_pack forgets it",
				         pool_info[pool].name, (int)(k / size), s->from[k / size]);
	}
}

// Checks that contacts and their constraints refer to each other after contact_pack.
static void check_links(Backend* b, const Slots* s, unsigned char* bytes)
{
	int* back = calloc(SLOTS, sizeof *back);
	Int2* moved = (Int2*)bytes;
	get_items(b, POOL_pair, SLOTS, moved);
	for (int k = 0; k < SLOTS; ++k)
		assert_int_equal(moved[k].x, k < s->alive ? s->pairs[s->from[k]].x : -1);
	get_items(b, POOL_contact_place, s->alive, bytes);
	get_items(b, POOL_contact_place_slot, SLOTS, back);
	for (int k = 0; k < s->alive; ++k)
	{
		int constraint = ((const int*)bytes)[k];
		assert_int_equal(constraint, s->constraints[s->from[k]]);
		assert_true(constraint < 0 || back[constraint] == k);
	}
	free(back);
}

static void contacts_move_together(void** state)
{
	(void)state;
	Slots s = make_slots();
	unsigned char* bytes = calloc(SLOTS, 256);
	for (int n = 0; n < backend_count; ++n)
	{
		Backend* b = backends[n];
		Counters counters;
		put_contacts(b, &s, bytes);
		run_one(b, &(Step){0}, KERNEL_contact_mark_free, SLOTS + 1, NO_COUNT, 0);
		run_one(b, &(Step){0}, PRIMITIVE_SCAN, SLOTS + 1, NO_COUNT, 0);
		run_one(b, &(Step){0}, KERNEL_contact_list_free, SLOTS, NO_COUNT, 0);
		run_one(b, &(Step){0}, KERNEL_contact_pack, SLOTS, NO_COUNT, 0);
		run_one(b, &(Step){0}, KERNEL_contact_pack_end, 1, NO_COUNT, 0);
		get_items(b, POOL_counters, 1, &counters);
		assert_int_equal(counters.contacts, s.alive);
		check_pools(b, &s, bytes);
		check_links(b, &s, bytes);
	}
	free(s.pairs);
	free(s.constraints);
	free(s.from);
	free(bytes);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(curve_visits_neighbors),
	    cmocka_unit_test(slots_are_lowest_first),
	    cmocka_unit_test(contacts_move_together),
	};
	return cmocka_run_group_tests(tests, open_stage_backends, close_backends);
}
