// SPDX-License-Identifier: MIT
// test_hostile_snapshots.c -- checks that snapshots with values that fuzzing has found to be harmful are refused.
//
// Each value once led to an access beyond an array, to an overflow or to an endless loop. tests/fuzz searches for others.
#include "support/make_worlds.h"
#include "support/second_device.h"
#include "support/snapshots.h"
#include "world/snapshot/chunks.h"
#include "world/world.h"
#include <limits.h>
#include <stdio.h>

typedef struct
{
	const char* chunk;
	int item;  // index of the changed value; -1: the last one
	int count; // number of values if the snapshot lacks the chunk
	int bytes; // bytes of a value
	int64_t value;
	const char* words; // text that the message contains
} HostileValue;

// Returns a copy of a snapshot in which a value of a chunk is replaced. The chunk stores all of its values.
static Saved replace(Saved saved, const HostileValue* v)
{
	ChunkIndex index;
	OK(chunks_open(&index, "test", saved.bytes, saved.size));
	const Chunk* chunk = chunk_find(&index, v->chunk);
	int count = chunk ? chunk->count : v->count;
	assert_true(count > 0 && (!chunk || chunk->bytes == v->bytes));
	size_t bytes = (size_t)v->bytes;
	uint8_t* values = calloc((size_t)count, bytes);
	assert_non_null(values);
	for (int k = 0; chunk && k < count; ++k)
		memcpy(values + (size_t)k * bytes, chunk->first + (chunk->equal ? 0 : (size_t)k * bytes), bytes);
	int64_t value = v->value;
	memcpy(values + (size_t)(v->item < 0 ? count - 1 : v->item) * bytes, &value, bytes);
	Saved copy = copy_chunks(saved, v->chunk, v->chunk, v->bytes, count, values);
	chunks_close(&index);
	free(values);
	return copy;
}

static void refuse_each(scree_world* world, const HostileValue* values, size_t count)
{
	Saved saved = save(world);
	for (size_t k = 0; k < count; ++k)
	{
		Saved hostile = replace(saved, values + k);
		refuse_snapshot(world, hostile.bytes, hostile.size, values[k].words);
		free(hostile.bytes);
	}
	free(saved.bytes);
}

// Returns the slot of a contact that has points.
static int touching_contact(scree_world* world)
{
	Word* flags = NULL;
	int contacts = world->pipeline.counters.contacts;
	flags = malloc((size_t)contacts * sizeof *flags);
	assert_non_null(flags);
	OK(world->backend->f->read(world->backend, POOL_contact_flags, 0, contacts, flags));
	int found = -1;
	for (int k = 0; k < contacts && found < 0; ++k)
		if (flags[k] & CONTACT_TOUCHING && flags[k] & CONTACT_COUNT)
			found = k;
	free(flags);
	assert_true(found >= 0);
	return found;
}

static void contacts(void** state)
{
	(void)state;
	scree_world* world = open_pile("cpu", true);
	run_steps(world, 20);
	int contact = touching_contact(world), padded = (world->bodies.used + MAX_LANES - 1) / MAX_LANES * MAX_LANES;
	const HostileValue values[] = {
	    // a place of a constraint whose contact is gone
	    {"pool.pair+0", contact, 0, 4, -1, "pair"},
	    // a contact that sleeps and has a color would keep a place beyond the rows of a smaller layout
	    {"pool.contact_flags+0", contact, 0, 4, (int64_t)(CONTACT_ASLEEP | CONTACT_TOUCHING | 1), "contact_color"},
	    // no color would be free
	    {"pool.color_mask+0", 2, 0, 4, 0xffffffff, "color_mask"},
	    {"pool.touching+0", 2, 0, 4, 100, "touching"},
	    // the lists of events have no memory
	    {"pool.filter+20", 1, world->collidables.used, 4, SCREE_REPORT_APPROVAL, "filter"},
	    // kernels also process the padding behind the bodies
	    {"pool.sleep+0", -1, padded, 4, 1 << 20, "sleep"},
	};
	refuse_each(world, values, sizeof values / sizeof *values);
	scree_world_destroy(world);
}

// A collidable without a body is in no list.
static void free_collidable(void** state)
{
	(void)state;
	scree_world* world = open_pile("cpu", true);
	scree_body_def body_def = scree_body_def_default();
	scree_collidable_def def = scree_collidable_def_default();
	scree_attribute_def shape = scree_attribute_def_default();
	OK(scree_shape_make_circle((scree_vec){0, 0}, 0.5f, &shape.shape));
	OK(scree_attribute_create(world, &shape, &def.attribute));
	body_def.attribute = def.attribute;
	OK(scree_body_create(world, &body_def, &def.body));
	OK(scree_collidable_create(world, &def, NULL)); // the second one of its body, so that the snapshot has both columns
	def.body = SCREE_NULL_BODY;
	OK(scree_collidable_create(world, &def, NULL));
	run_steps(world, 1);
	const HostileValue values[] = {
	    {"collidable.next", -1, 0, 4, INT_MAX, "collidable"},
	    {"collidable.next", -1, 0, 4, 0, "collidable"},
	    {"collidable.previous", -1, 0, 4, 0, "collidable"},
	};
	refuse_each(world, values, sizeof values / sizeof *values);
	scree_world_destroy(world);
}

static void counts(void** state)
{
	(void)state;
	scree_world* world = open_pile("cpu", true);
	run_steps(world, 20);
	const HostileValue values[] = {
	    {"counters.alive", 0, 1, 4, INT_MIN, "value 0 of chunk counters.alive is out of range"},
	    {"counters.alive", 0, 1, 4, 1, "contacts"},
	    {"counters.released", 0, 1, 4, 3, "contacts"},
	    {"pipeline.sparse", 0, 1, 4, INT_MAX, "pipeline.sparse is out of range"},
	    {"pipeline.rounds", 0, 1, 4, -1, "pipeline.rounds is out of range"},
	    {"pipeline.steps", 0, 1, 8, INT64_MAX, "pipeline.steps is out of range"},
	    {"pipeline.jumps", 0, 1, 1, 2, "pipeline.jumps is out of range"},
	    {"world.bodies.used", 0, 1, 4, INT_MAX, "world.bodies.used"},
	    {"world.bodies.used", 0, 1, 4, 1 << 24, "chunk slots.body.generation"},
	    {"world.collidables.used", 0, 1, 4, -1, "world.collidables.used"},
	    {"counters.contacts", 0, 1, 4, 1 << 27, "chunk pool.pair+0"},
	    // pools that are sized by a counter, whose values are all 0
	    {"counters.joined", 0, 1, 4, 1 << 25, "chunk pool.joined+0 does not store its 33554432 values"},
	    {"pipeline.excluded", 0, 1, 4, 1 << 24, "chunk pool.excluded+0 does not store its 16777216 values"},
	    {"world.edits.sample_rows", 0, 1, 4, 1 << 24, "chunk samples.used does not store its 16777216 values"},
	};
	refuse_each(world, values, sizeof values / sizeof *values);
	scree_world_destroy(world);
}

// Heads of chunks that state more values than the file has, or than memory could hold.
static void heads(void** state)
{
	(void)state;
	scree_world* world = open_pile("cpu", true);
	Saved saved = save(world);
	static const struct
	{
		uint16_t bytes;
		uint32_t count;
		const char* words;
	} all[] = {{65535, 65537, "a chunk ends behind"},
	           {4, 0x40000000, "a chunk ends behind"},
	           {1, 0xffffffff, "a chunk ends behind"},
	           {0, 0x80000000, "a chunk ends behind"}};
	uint8_t* bytes = saved.bytes;
	size_t at = 10 + (size_t)bytes[9]; // the first chunk
	uint8_t* head = bytes + at + 1 + bytes[at];
	for (size_t k = 0; k < sizeof all / sizeof *all; ++k)
	{
		memcpy(head + 1, &all[k].bytes, 2);
		memcpy(head + 3, &all[k].count, 4);
		uint64_t digest = chunks_digest(bytes, saved.size - 8);
		memcpy(bytes + saved.size - 8, &digest, 8);
		refuse_snapshot(world, bytes, saved.size, all[k].words);
	}
	free(saved.bytes);
	saved = save(world);
	int count = 1;
	Saved twice = copy_chunks(saved, NULL, "world.bodies.used", 4, 1, &count);
	refuse_snapshot(world, twice.bytes, twice.size, "two chunks world.bodies.used");
	free(twice.bytes);
	free(saved.bytes);
	scree_world_destroy(world);
}

// Names of chunks that collide in the index would take a time that grows with the square of their number.
static void colliding_names(void** state)
{
	(void)state;
	scree_world* world = open_pile("cpu", true);
	ChunkWriter writer = {0};
	OK(chunks_begin(&writer, "test"));
	for (uint32_t any = 0, found = 0; found < 2000; ++any)
	{
		char name[8];
		uint32_t hash = 2166136261u; // FNV-1a, as in chunks.c
		snprintf(name, sizeof name, "%06x", (unsigned)any);
		for (int k = 0; k < 6; ++k)
			hash = (hash ^ (uint8_t)name[k]) * 16777619u;
		if ((hash & 4095) != 7) // the table has 4,096 entries
			continue;
		assert_non_null(chunk_add(&writer, name, 1, 0, 0));
		++found;
	}
	OK(chunks_end(&writer, "test"));
	refuse_snapshot(world, writer.bytes, writer.used, "collides with 1024 others");
	scree_release(writer.bytes);
	scree_world_destroy(world);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test_teardown(contacts, memory_is_released),
	    cmocka_unit_test_teardown(free_collidable, memory_is_released),
	    cmocka_unit_test_teardown(counts, memory_is_released),
	    cmocka_unit_test_teardown(heads, memory_is_released),
	    cmocka_unit_test_teardown(colliding_names, memory_is_released),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
