// SPDX-License-Identifier: MIT
// test_bays.c -- checks the arithmetic of bays: the bay of an item follows exactly from its index.
//
// Formula: bay_of(i, size, 1 / size) = floor(i / size), for each size up to MOST_BAY_ITEMS and each index below MAX_ITEMS.
#include "pools/bays.h"
#include "step/bay_layout.h"
#include "support/checks.h"

static void quotients_are_exact(void** state)
{
	(void)state;
	for (int size = 1; size <= MOST_BAY_ITEMS; ++size)
	{
		float part = 1.0f / (float)size;
		int step = size < 64 ? 1 : 37; // neighbors of each multiple, or of every 37th one
		for (int k = 0; k < MAX_ITEMS / size; k += step)
			for (int i = k * size - 1; i <= k * size + 1; ++i)
				if (i >= 0 && bay_of(i, size, part) != i / size)
					fail_msg("index %d, %d items a bay: bay %d", i, size, bay_of(i, size, part));
		assert_int_equal(bay_of(MAX_ITEMS - 1, size, part), (MAX_ITEMS - 1) / size);
	}
}

static void spare_bays_begin_at_groups(void** state)
{
	(void)state;
	for (int worlds = 1; worlds < 70; ++worlds)
		for (int size = 1; size < 70; ++size)
		{
			int spare = bay_spare(worlds, size);
			assert_true(spare >= worlds * size && spare < worlds * size + GROUP_ITEMS && spare % GROUP_ITEMS == 0);
			assert_int_equal(bay_item(worlds, worlds - 1, size - 1, size), worlds * size - 1);
			assert_int_equal(bay_item(worlds, worlds + 1, 0, size), spare + size);
		}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(quotients_are_exact),
	    cmocka_unit_test(spare_bays_begin_at_groups),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
