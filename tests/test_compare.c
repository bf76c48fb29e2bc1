// SPDX-License-Identifier: MIT
// test_compare.c -- checks the comparison of two snapshots: columns, items and values that differ.
#include "support/recordings.h"
#include "support/second_device.h"

#define MOST 200

static int compare(Saved a, Saved b, scree_difference differences[MOST])
{
	int count, again;
	OK(scree_snapshots_compare(a.bytes, a.size, b.bytes, b.size, NULL, 0, &count));
	assert_true(count <= MOST);
	OK(scree_snapshots_compare(a.bytes, a.size, b.bytes, b.size, differences, MOST, &again));
	assert_int_equal(again, count);
	return count;
}

static const scree_difference* column(const scree_difference* differences, int count, const char* name)
{
	for (int k = 0; k < count; ++k)
		if (strcmp(differences[k].column, name) == 0)
			return differences + k;
	fail_msg("column %s does not differ", name);
	return NULL;
}

// Worlds with equal hashes have equal snapshots, on any device.
static void equal_worlds_have_no_differences(void** state)
{
	(void)state;
	scree_world *a = open_pile("cpu", true), *b = open_pile(second_device[0] ? second_device : "cpu", false);
	scree_difference differences[MOST];
	run_steps(a, 20);
	run_steps(b, 20);
	Saved first = save(a), second = save(b);
	assert_int_equal(compare(first, second, differences), 0);
	scree_world_destroy(a);
	scree_world_destroy(b);
	free(first.bytes);
	free(second.bytes);
}

// One changed value is found in its column, with its item and both values; so is an index whose default is -1.
static void differences_are_found(void** state)
{
	(void)state;
	scree_world* world = open_world(0.0f);
	scree_difference differences[MOST];
	scree_body crates[3];
	for (int k = 0; k < 3; ++k)
		crates[k] = add_crate(world, SCREE_BODY_DYNAMIC, 3.0f * (float)k, 1.0f);
	Saved before = save(world);
	OK(scree_body_set_user(world, crates[1], 0x1234567890u));
	OK(scree_body_set_pose(world, crates[2], (scree_pose){{6.0f, 2.5f}, {1.0f, 0.0f}}));
	Saved after = save(world);
	int count = compare(before, after, differences);
	const scree_difference* user = column(differences, count, "body.user");
	assert_true(user->items == 1 && user->item == (int)crates[1].index && user->bytes == 8 && user->offset == 0);
	assert_true(user->value_a == 0 && user->value_b == 0x1234567890u && user->count_a == 4 && user->count_b == 4);
	assert_string_equal(user->word, "");
	const scree_difference* y = column(differences, count, "pool.pose+4");
	assert_true(y->items == 1 && y->item == (int)crates[2].index && y->bytes == 4);
	assert_true(y->value_a == 0x3f800000u && y->value_b == 0x40200000u); // 1 and 2.5
	assert_string_equal(y->word, "y");

	// a snapshot with more items differs in them
	add_crate(world, SCREE_BODY_DYNAMIC, 20.0f, 1.0f);
	Saved more = save(world);
	count = compare(after, more, differences);
	const scree_difference* type = column(differences, count, "body.type");
	assert_true(type->count_a == 4 && type->count_b == 5 && type->items == 1 && type->item == 4);
	assert_true(type->value_a == 0 && type->value_b == SCREE_BODY_DYNAMIC);
	scree_difference few[2];
	int all;
	OK(scree_snapshots_compare(after.bytes, after.size, more.bytes, more.size, few, 2, &all));
	assert_int_equal(all, count);
	assert_memory_equal(few, differences, sizeof few);
	scree_world_destroy(world);
	free(before.bytes);
	free(after.bytes);
	free(more.bytes);
}

static void bad_snapshots_are_refused(void** state)
{
	(void)state;
	scree_world* world = open_world(0.0f);
	Saved saved = save(world);
	int count = -7;
	const char* bytes = saved.bytes;
	assert_int_equal(scree_snapshots_compare(bytes, saved.size, "no snapshot at all", 18, NULL, 0, &count),
	                 SCREE_ERROR_INVALID);
	assert_non_null(strstr(scree_error(), "scree_snapshots_compare: "));
	assert_int_equal(scree_snapshots_compare(bytes, saved.size - 1, bytes, saved.size, NULL, 0, &count),
	                 SCREE_ERROR_INVALID);
	assert_int_equal(scree_snapshots_compare(NULL, 5, bytes, saved.size, NULL, 0, &count), SCREE_ERROR_INVALID);
	assert_int_equal(scree_snapshots_compare(bytes, saved.size, NULL, 5, NULL, 0, &count), SCREE_ERROR_INVALID);
	assert_int_equal(scree_snapshots_compare(bytes, saved.size, bytes, saved.size, NULL, 2, &count),
	                 SCREE_ERROR_INVALID);
	assert_int_equal(scree_snapshots_compare(bytes, saved.size, bytes, saved.size, NULL, 0, NULL), SCREE_ERROR_INVALID);
	assert_int_equal(count, -7);
	scree_world_destroy(world);
	free(saved.bytes);
	assert_int_equal(scree_memory(), 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(equal_worlds_have_no_differences),
	    cmocka_unit_test(differences_are_found),
	    cmocka_unit_test(bad_snapshots_are_refused),
	};
	return cmocka_run_group_tests(tests, find_second_device, NULL);
}
