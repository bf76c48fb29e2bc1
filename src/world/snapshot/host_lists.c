// SPDX-License-Identifier: MIT
// host_lists.c -- writes and reads the arrays of a world on the host: objects, slots and lists.
#include "world/snapshot/host_lists.h"
#include "platform/error.h"
#include "world/memory.h"
#include "world/objects/attributes.h"
#include "world/snapshot/host_arrays.h"
#include "world/snapshot/host_columns.h"
#include "world/world.h"
#include <stdio.h>
#include <string.h>

#define SAMPLE_ROWS "samples.used" // name of a chunk

const SlotsOf slots_of[SLOT_KINDS] = {
    {"slots.body", offsetof(scree_world, bodies), 1},
    {"slots.collidable", offsetof(scree_world, collidables), 0},
    {"slots.attribute", offsetof(scree_world, attribute_slots), 0},
    {"slots.joint", offsetof(scree_world, joints), 0},
    {"slots.path", offsetof(scree_world, paths), 0},
    {"slots.field", offsetof(scree_world, fields.slots), 0},
    {"slots.exclusion", offsetof(scree_world, exclusions.slots), 0},
};

static const Column generation_column[] = {{"generation", 0, sizeof(uint32_t), 1, COLUMN_EACH}};
static const Column int_column[] = {{"each", 0, sizeof(int), 1, COLUMN_EACH}};
static const Column word64_column[] = {{"each", 0, sizeof(uint64_t), 1, COLUMN_EACH}};

#define WORD(offset)                    \
	{                                   \
		NULL, offset, 4, 1, COLUMN_ZERO \
	}
#define WORDS4(offset) WORD(offset), WORD(offset + 4), WORD(offset + 8), WORD(offset + 12)
static const Column report_columns[] = {{NULL, 0, 4, 1, COLUMN_EACH},
                                        WORD(4),
                                        WORD(8),
                                        WORD(12),
                                        WORDS4(16),
                                        WORDS4(32),
                                        WORDS4(48),
                                        WORDS4(64),
                                        WORDS4(80)};
static const Column material_columns[] = {WORDS4(0)};
static const Column sample_columns[] = {WORDS4(0), WORDS4(16)};
_Static_assert(sizeof(ContactReport) == 96 && sizeof(MaterialPair) == 16 && sizeof(PathSample) == 32, "columns");

// Writes which rows of the pool of samples are in use, a byte for each, so that the pool is not larger than the file allows.
static void write_sample_rows(ChunkWriter* writer, const scree_world* world)
{
	int rows = world->edits.sample_rows;
	uint8_t* used = rows > 0 ? chunk_add(writer, SAMPLE_ROWS, 1, rows, rows) : NULL;
	if (!used)
		return;
	memset(used, 0, (size_t)rows);
	for (int k = 0; k < world->paths.used; ++k)
		if (slots_in_use(&world->paths, k))
			memset(used + world->host_paths[k].first, 1, (size_t)world->host_paths[k].segments + 1);
}

static scree_status check_sample_rows(const ChunkIndex* index, const scree_world* world)
{
	const Chunk* chunk = chunk_find(index, SAMPLE_ROWS);
	int rows = world->edits.sample_rows;
	if (rows == 0 || (chunk && chunk->bytes == 1 && chunk->count == rows && !chunk->equal))
		return SCREE_OK;
	return snapshot_refuse(index, "chunk %s does not store its %d values", SAMPLE_ROWS, rows);
}

static void write_samples(ChunkWriter* writer, scree_world* world)
{
	char prefix[CHUNK_NAME];
	write_sample_rows(writer, world);
	for (int k = 0; k < world->paths.used; ++k)
		if (slots_in_use(&world->paths, k))
		{
			snprintf(prefix, sizeof prefix, "samples%d", k);
			columns_write(writer, LIST_TABLE(prefix, sample_columns), world->host_paths[k].samples, sizeof(PathSample),
			              world->host_paths[k].segments + 1);
		}
}

void host_write(ChunkWriter* writer, scree_world* world)
{
	const ColumnTable* world_table = &host_columns[HOST_WORLD].table;
	int departed = world->reports.departed_capacity;
	columns_write(writer, world_table, world, sizeof *world, 1);
	columns_write(writer, &host_columns[HOST_PIPELINE].table, &world->pipeline, sizeof world->pipeline, 1);
	columns_write(writer, &host_columns[HOST_COUNTERS].table, &world->pipeline.counters, sizeof(Counters), 1);
	for (int k = 0; k < SLOT_KINDS; ++k)
		columns_write(writer, LIST_TABLE(slots_of[k].prefix, generation_column), slots_at(world, k)->generation,
		              sizeof(uint32_t), slots_at(world, k)->used);
#define ARRAY(part, table, array, capacity, count, kept) columns_write(writer, table, array, sizeof *(array), count);
	HOST_ARRAYS(ARRAY)
#undef ARRAY
	columns_write(writer, &host_columns[HOST_DEPARTED].table, world->reports.departed, sizeof(CollidableName),
	              departed);
	write_samples(writer, world);
}

static scree_status check_count(const ChunkIndex* index, const char* name, int count, int most)
{
	return count >= 0 && count <= most ? SCREE_OK
	                                   : snapshot_refuse(index, "%s is %d, must be from 0 to %d", name, count, most);
}

// Checks the numbers of items, before memory is allocated for them.
static scree_status check_counts(const ChunkIndex* index, const scree_world* world)
{
	const Pipeline* pipeline = &world->pipeline;
	const Counters* c = &pipeline->counters;
	const struct
	{
		const char* name;
		int count, most;
	} counts[] = {
	    {"world.bodies.used", world->bodies.used, MAX_ITEMS},
	    {"world.collidables.used", world->collidables.used, MAX_ITEMS},
	    {"world.attribute_slots.used", world->attribute_slots.used, MAX_ITEMS},
	    {"world.joints.used", world->joints.used, MAX_ITEMS},
	    {"world.paths.used", world->paths.used, MAX_ITEMS},
	    {"world.fields.slots.used", world->fields.slots.used, MAX_ITEMS},
	    {"world.exclusions.slots.used", world->exclusions.slots.used, MAX_ITEMS},
	    {"world.target_count", world->target_count, world->bodies.used},
	    {"world.kinematic_count", world->kinematic_count, world->bodies.used},
	    {"world.edits.attribute_rows", world->edits.attribute_rows, world->attribute_slots.used},
	    {"world.sample_end", world->sample_end, MAX_ITEMS},
	    {"world.edits.sample_rows", world->edits.sample_rows, MAX_ITEMS},
	    {"pipeline.material_pairs", pipeline->material_pairs, MATERIAL_PLACE(MATERIALS - 1, MATERIALS - 1) + 1},
	    {"pipeline.excluded", pipeline->excluded, MAX_ITEMS},
	    {"counters.contacts", c->contacts, MAX_CONTACTS},
	    {"counters.joints", c->joints, world->joints.used},
	    {"counters.joint_events", c->joint_events, world->joints.used},
	    {"counters.joined", c->joined, 2 * MAX_ITEMS},
	};
	for (size_t k = 0; k < sizeof counts / sizeof *counts; ++k)
		TRY(check_count(index, counts[k].name, counts[k].count, counts[k].most));
	if (world->bodies.used == 0)
		return snapshot_refuse(index, "it lacks body 0, the ground");
	return SCREE_OK;
}

// Returns the number of values of a chunk, 0 if it is missing. Lists without a counter have as many items as their chunk.
static int count_of(const ChunkIndex* index, const char* name)
{
	const Chunk* chunk = chunk_find(index, name);
	return chunk ? chunk->count : 0;
}

static scree_status read_slots(const ChunkIndex* index, scree_world* world, int k)
{
	Slots* slots = slots_at(world, k);
	int used = slots->used;
	slots->used = 0;
	TRY(columns_check(index, LIST_TABLE(slots_of[k].prefix, generation_column), used));
	if (!slots_reserve(slots, used))
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for %d slots", index->function, used);
	columns_read(index, LIST_TABLE(slots_of[k].prefix, generation_column), slots->generation, sizeof(uint32_t), used);
	slots_restore(slots, slots_of[k].first, used);
	return SCREE_OK;
}

static scree_status read_samples(const ChunkIndex* index, scree_world* world)
{
	char prefix[CHUNK_NAME];
	for (int k = 0; k < world->paths.used; ++k)
	{
		HostPath* path = world->host_paths + k;
		if (!slots_in_use(&world->paths, k))
			continue;
		snprintf(prefix, sizeof prefix, "samples%d+0", k);
		if (path->segments < 1 || path->segments >= MAX_ITEMS || path->segments + 1 != count_of(index, prefix))
			return snapshot_refuse(index, "path %d has %d segments, and %d samples", k, path->segments,
			                       count_of(index, prefix));
		snprintf(prefix, sizeof prefix, "samples%d", k);
		TRY(columns_check(index, LIST_TABLE(prefix, sample_columns), path->segments + 1));
		path->samples = scree_allocate(((size_t)path->segments + 1) * sizeof *path->samples);
		if (!path->samples)
			return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for %d samples", index->function, path->segments + 1);
		columns_read(index, LIST_TABLE(prefix, sample_columns), path->samples, sizeof *path->samples,
		             path->segments + 1);
	}
	return SCREE_OK;
}

static scree_status read_struct(const ChunkIndex* index, HostTable table, void* item)
{
	TRY(columns_check(index, &host_columns[table].table, 1));
	columns_read(index, &host_columns[table].table, item, host_columns[table].bytes, 1);
	return SCREE_OK;
}

static scree_status read_array(const ChunkIndex* index, const ColumnTable* table, void** array, int* capacity,
                               size_t stride, int count, int kept)
{
	TRY(check_count(index, table->prefix, count, INT32_MAX));
	TRY(columns_check(index, table, count));
	TRY(grow(index->function, array, capacity, stride, kept));
	columns_read(index, table, *array, stride, count);
	return SCREE_OK;
}

scree_status host_read(const ChunkIndex* index, scree_world* world)
{
	const char* function = index->function;
	TRY(read_struct(index, HOST_WORLD, world));
	TRY(read_struct(index, HOST_PIPELINE, &world->pipeline));
	TRY(read_struct(index, HOST_COUNTERS, &world->pipeline.counters));
	TRY(check_counts(index, world));
	TRY(check_sample_rows(index, world));
	for (int k = 0; k < SLOT_KINDS; ++k)
		TRY(read_slots(index, world, k));
#define ARRAY(part, table, array, capacity, count, kept) \
	TRY(read_array(index, table, (void**)&(array), &(capacity), sizeof *(array), count, kept));
	HOST_ARRAYS(ARRAY)
#undef ARRAY
	int departed = world->reports.departed_capacity;
	world->reports.departed_capacity = 0;
	TRY(check_count(index, "world.reports.departed_capacity", departed, 4 * world->collidables.used + 4096));
	TRY(columns_check(index, &host_columns[HOST_DEPARTED].table, departed));
	TRY(GROW(function, world->reports.departed, world->reports.departed_capacity, departed));
	columns_read(index, &host_columns[HOST_DEPARTED].table, world->reports.departed, sizeof(CollidableName), departed);
	for (int k = departed; k < world->reports.departed_capacity; ++k)
		world->reports.departed[k].step = -1;
	// a step may send all joints again, without a check of memory
	TRY(GROW(function, world->edits.joints, world->edits.joint_capacity, world->joints.capacity));
	return read_samples(index, world);
}
