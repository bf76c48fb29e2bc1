// SPDX-License-Identifier: MIT
// test_snapshot_files.c -- checks that snapshots of other versions are read, and that snapshots that are damaged, foreign or
// not consistent are refused and change nothing, also when memory runs out.
#include "support/allocations.h"
#include "support/second_device.h"
#include "support/snapshots.h"
#include "world/snapshot/chunks.h"
#include "world/snapshot/host_columns.h"
#include <math.h>

// Unknown chunks are skipped, and a missing chunk has default values.
static void other_versions_are_read(void** state)
{
	(void)state;
	scree_world* world = open_pile("cpu", true);
	scree_body_def def = crate_def(world, SCREE_BODY_DYNAMIC, 3.0f, 30.0f);
	def.user = 5;
	scree_body body = create_body(world, &def);
	run_steps(world, 5);
	uint64_t hash = hash_of(world);
	static const uint8_t values[48] = {7, 7, 7};
	Saved saved = save(world), more = copy_chunks(saved, NULL, "future.thing", 16, 3, values),
	      less = copy_chunks(saved, "body.user", NULL, 0, 0, NULL);
	run_steps(world, 5);
	OK(scree_world_restore(world, more.bytes, more.size));
	assert_true(hash_of(world) == hash);
	OK(scree_body_get_def(world, body, &def));
	assert_true(def.user == 5);
	OK(scree_world_restore(world, less.bytes, less.size));
	assert_true(hash_of(world) == hash);
	OK(scree_body_get_def(world, body, &def));
	assert_true(def.user == 0);
	scree_world_destroy(world);
	free(saved.bytes);
	free(more.bytes);
	free(less.bytes);
}

// Members of definitions that have no effect may have any value, and are kept.
static void members_without_effect_are_kept(void** state)
{
	(void)state;
	scree_world* world = open_pile("cpu", true);
	scree_joint_def def = scree_joint_def_make(SCREE_JOINT_REVOLUTE);
	scree_body_def crate = crate_def(world, SCREE_BODY_DYNAMIC, 3.0f, 30.0f);
	def.body_b = create_body(world, &crate);
	def.sides[1].measure = (scree_measure)77;
	def.sides[0].base.position.x = NAN;
	def.ratio = INFINITY;
	scree_joint joint;
	OK(scree_joint_create(world, &def, &joint));
	Saved saved = save(world);
	OK(scree_world_restore(world, saved.bytes, saved.size));
	OK(scree_joint_get_def(world, joint, &def));
	assert_int_equal(def.sides[1].measure, 77);
	scree_world_destroy(world);
	free(saved.bytes);
}

static void damaged_snapshots_change_nothing(void** state)
{
	(void)state;
	scree_world* world = open_pile("cpu", true);
	run_steps(world, 20);
	Saved saved = save(world);
	uint8_t* bytes = saved.bytes;
	for (size_t size = 0; size < saved.size; size += 1 + saved.size / 97)
		refuse_snapshot(world, bytes, size, size < 19 ? "are not a snapshot" : "damaged");
	for (size_t at = 8; at < saved.size; at += 1 + saved.size / 97)
	{
		uint8_t old = bytes[at];
		bytes[at] = (uint8_t)(old ^ 0x41);
		refuse_snapshot(world, bytes, saved.size, "snapshot");
		bytes[at] = old;
	}
	bytes[8] = 77;
	refuse_snapshot(world, bytes, saved.size, "has format 77");
	refuse_snapshot(world, "not a snapshot, but 31 letters.", 31, "are not a snapshot");
	assert_int_equal(scree_world_restore(world, NULL, 100), SCREE_ERROR_INVALID);
	scree_world_destroy(world);
	free(saved.bytes);
	assert_int_equal(scree_memory(), 0);
}

// Words of a snapshot are replaced by hostile values, with the right digest: the snapshot is refused, or the world that it
// describes can be used.
static void hostile_snapshots_do_no_harm(void** state)
{
	(void)state;
	static const uint32_t values[] = {0xffffffffu, 0x7fffffffu, 0x80000000u, 65u, 1u << 24, 0u};
	scree_world* world = open_pile("cpu", true);
	run_steps(world, 10);
	Saved saved = save(world);
	int refused = 0, restored = 0;
	for (size_t at = 16; at + 16 < saved.size; at += quick() ? 401 : 97)
	{
		uint8_t* bytes = saved.bytes;
		uint32_t old, value = values[at % 6];
		memcpy(&old, bytes + at, 4);
		memcpy(bytes + at, &value, 4);
		uint64_t digest = chunks_digest(bytes, saved.size - 8);
		memcpy(bytes + saved.size - 8, &digest, 8);
		scree_world* made;
		scree_world_def def = scree_world_def_default();
		def.device = "cpu";
		def.threads = def.lanes = 1;
		if (scree_world_create_from(&def, bytes, saved.size, &made) == SCREE_OK)
		{
			++restored;
			for (int k = 0; k < 3 && scree_world_step(made, STEP, SUBSTEPS) == SCREE_OK; ++k)
				;
			scree_world_destroy(made);
		}
		else
			++refused;
		memcpy(bytes + at, &old, 4);
	}
	print_message("%d refused, %d restored\n", refused, restored);
	assert_true(refused > 10 && restored > 10);
	scree_world_destroy(world);
	free(saved.bytes);
	assert_int_equal(scree_memory(), 0);
}

// Lack of memory changes nothing, whenever it occurs.
static void memory_runs_out(void** state)
{
	(void)state;
	count_allocations();
	scree_world *world = open_pile("cpu", true), *other = open_pile("cpu", true);
	run_steps(world, 20);
	uint64_t hash = hash_of(world), before = hash_of(other);
	for (int k = 0;; ++k)
	{
		const void* bytes;
		size_t size;
		allocations_left = k;
		scree_status status = scree_world_snapshot(world, &bytes, &size);
		if (status == SCREE_OK)
			break;
		end_of_shortage(status);
		assert_true(hash_of(world) == hash);
	}
	allocations_left = -1;
	Saved saved = save(world);
	int failures = 0;
	for (;; ++failures)
	{
		allocations_left = failures;
		scree_status status = scree_world_restore(other, saved.bytes, saved.size);
		if (status == SCREE_OK)
			break;
		end_of_shortage(status);
		assert_true(hash_of(other) == before);
	}
	allocations_left = -1;
	assert_true(failures > 20 && hash_of(other) == hash);
	scree_world_destroy(world);
	scree_world_destroy(other);
	free(saved.bytes);
	assert_int_equal(scree_memory(), 0);
}

// ---------------------------------------------------------------------------------------------------------------
// columns
// ---------------------------------------------------------------------------------------------------------------

typedef struct
{
	HostTable table;
	struct
	{
		size_t offset, bytes;
	} others[4]; // members that a snapshot does not contain
} Cover;

#define OTHER(type, member)                                \
	{                                                      \
		offsetof(type, member), sizeof(((type*)0)->member) \
	}

// Each byte of a struct that a snapshot contains is in a column, in the list of others, or is padding: fewer than eight
// bytes before a member.
static void columns_cover_structs(void** state)
{
	(void)state;
	static const Cover covers[] = {
	    {HOST_BODY, {OTHER(HostBody, waiting), OTHER(HostBody, marked)}},
	    {HOST_COLLIDABLE, {OTHER(HostCollidable, waiting), OTHER(HostCollidable, marked)}},
	    {HOST_ATTRIBUTE_DEF, {OTHER(scree_attribute_def, size)}},
	    {HOST_ATTRIBUTE, {OTHER(HostAttribute, name), OTHER(HostAttribute, waiting)}},
	    {HOST_JOINT, {OTHER(HostJoint, def.size), {offsetof(HostJoint, seeks), 5}}},
	    {HOST_PATH, {OTHER(HostPath, samples), OTHER(HostPath, waiting)}},
	    {HOST_FIELD, {OTHER(HostField, def.size)}},
	    {HOST_EXCLUSION, {{0, 0}}},
	    {HOST_TARGET, {{0, 0}}},
	    {HOST_VISIT, {{0, 0}}},
	    {HOST_DEPARTED, {{0, 0}}},
	};
	for (size_t k = 0; k < sizeof covers / sizeof *covers; ++k)
	{
		const HostColumns* columns = host_columns + covers[k].table;
		char covered[512] = {0};
		assert_true(columns->bytes <= sizeof covered);
		for (int c = 0; c < columns->table.count; ++c)
		{
			const Column* column = columns->table.columns + c;
			memset(covered + column->offset, 1, (size_t)column->bytes * (size_t)column->count);
		}
		for (int o = 0; o < 4; ++o)
			memset(covered + covers[k].others[o].offset, 1, covers[k].others[o].bytes);
		for (size_t at = 0, gap = 0; at < columns->bytes; ++at)
		{
			gap = covered[at] ? 0 : gap + 1;
			size_t next = at + 1;
			if (gap > 7 || (gap > 0 && next % 4 == 0 && next % 8 != 0 && gap >= 4))
				fail_msg("%s: byte %zu of the struct is in no column", columns->table.prefix, at);
		}
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(other_versions_are_read),
	    cmocka_unit_test(members_without_effect_are_kept),
	    cmocka_unit_test(damaged_snapshots_change_nothing),
	    cmocka_unit_test(hostile_snapshots_do_no_harm),
	    cmocka_unit_test(memory_runs_out),
	    cmocka_unit_test(columns_cover_structs),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
