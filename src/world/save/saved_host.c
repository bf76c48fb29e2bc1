// SPDX-License-Identifier: MIT
// saved_host.c -- copies the data of a world on the host to saves and back, as plain memory of this process. The arrays
// and the members are those of snapshots.
#include "world/save/saved_host.h"
#include "platform/error.h"
#include "step/tree_maintenance.h"
#include "world/device/idle.h"
#include "world/memory.h"
#include "world/snapshot/chunks.h"
#include "world/snapshot/host_arrays.h"
#include "world/snapshot/host_columns.h"
#include <string.h>

#define PATHS 4 // number of the slots of paths in slots_of

typedef struct // members of a kinematic body that steps and targets change
{
	scree_pose stands, from;
	int64_t went;
	int target;
	bool still;
} SavedKinematic;

typedef struct // number of items of an array, and of items for which memory is reserved
{
	int items, room;
} ArrayCount;

#define ADD_ONE(part, table, array, capacity, count, kept) +1
enum
{
	HOST_ARRAY_COUNT = 0 HOST_ARRAYS(ADD_ONE)
};

static void count_arrays(const scree_world* world, ArrayCount counts[HOST_ARRAY_COUNT])
{
	int k = 0;
#define ARRAY(part, table, array, capacity, count, kept) counts[k++] = (ArrayCount){count, kept};
	HOST_ARRAYS(ARRAY)
#undef ARRAY
}

static const uint8_t* take(const uint8_t** at, void* to, size_t bytes)
{
	if (bytes > 0 && to)
		memcpy(to, *at, bytes);
	*at += bytes;
	return *at - bytes;
}

static void put_arrays(ChunkWriter* writer, const scree_world* world, ArrayPart wanted)
{
#define ARRAY(part, table, array, capacity, count, kept) \
	if (part == wanted)                                  \
		bytes_write(writer, array, sizeof *(array) * (size_t)(count));
	HOST_ARRAYS(ARRAY)
#undef ARRAY
}

static void take_arrays(const uint8_t** at, scree_world* world, ArrayPart wanted,
                        const ArrayCount counts[HOST_ARRAY_COUNT])
{
	int k = 0;
#define ARRAY(part, table, array, capacity, count, kept)            \
	if (part == wanted)                                             \
		take(at, array, sizeof *(array) * (size_t)counts[k].items); \
	++k;
	HOST_ARRAYS(ARRAY)
#undef ARRAY
}

static void put_structure(ChunkWriter* writer, scree_world* world)
{
	bytes_write(writer, &world->attribute_table_size, sizeof world->attribute_table_size);
	bytes_write(writer, world->attribute_table, sizeof(int) * (size_t)world->attribute_table_size);
	for (int k = 0; k < SLOT_KINDS; ++k)
	{
		const Slots* slots = slots_at(world, k);
		bytes_write(writer, &slots->used, sizeof slots->used);
		bytes_write(writer, slots->generation, sizeof(uint32_t) * (size_t)slots->used);
	}
	for (int k = 0; k < world->paths.used; ++k)
		if (slots_in_use(&world->paths, k))
		{
			const HostPath* path = world->host_paths + k;
			bytes_write(writer, &path->segments, sizeof path->segments);
			bytes_write(writer, path->samples, sizeof(PathSample) * ((size_t)path->segments + 1));
		}
	put_arrays(writer, world, ARRAY_STRUCTURE);
	bytes_write(writer, &world->reports.departed_capacity, sizeof world->reports.departed_capacity);
	bytes_write(writer, world->reports.departed, sizeof(CollidableName) * (size_t)world->reports.departed_capacity);
}

static int member_count(const scree_world* world)
{
	int used = world->collidables.used;
	return used < world->pipeline.member_capacity ? used : world->pipeline.member_capacity;
}

static void put_step(ChunkWriter* writer, scree_world* world)
{
	bytes_write(writer, world, sizeof *world);
	put_arrays(writer, world, ARRAY_STEP);
	for (int k = 0; k < world->kinematic_count; ++k)
	{
		const HostBody* host = world->host_bodies + world->kinematics[k];
		SavedKinematic saved = {host->stands, host->from, host->went, host->target, host->still};
		bytes_write(writer, &saved, sizeof saved);
	}
	bytes_write(writer, world->pipeline.member, (size_t)member_count(world));
	for (int t = 0; t < 2; ++t)
		bytes_write(writer, world->pipeline.trees[t].left, sizeof(int) * (size_t)world->pipeline.trees[t].left_count);
}

static scree_status end(const ChunkWriter* writer, const char* function)
{
	return writer->used == SIZE_MAX ? fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for a save", function) : SCREE_OK;
}

scree_status saved_structure_write(scree_world* world, const char* function, ChunkWriter* writer)
{
	writer->used = 0;
	put_structure(writer, world);
	return end(writer, function);
}

scree_status saved_step_write(scree_world* world, const char* function, ChunkWriter* writer)
{
	writer->used = 0;
	put_step(writer, world);
	return end(writer, function);
}

static const scree_world* world_then(const HostLoad* load) { return (const scree_world*)load->step->bytes; }

static scree_status no_memory(const HostLoad* load)
{
	return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory to load a save", load->function);
}

static scree_status reserve_samples(HostLoad* load, const uint8_t** at, const uint32_t* generation, int used)
{
	load->samples = scree_allocate(sizeof *load->samples * ((size_t)used + 1));
	if (!load->samples)
		return no_memory(load);
	load->paths = used;
	for (int k = 0; k < used; ++k)
	{
		int segments;
		if (!(generation[k] & 1))
			continue;
		take(at, &segments, sizeof segments);
		load->samples[k] = scree_allocate(sizeof(PathSample) * ((size_t)segments + 1));
		if (!load->samples[k])
			return no_memory(load);
		take(at, load->samples[k], sizeof(PathSample) * ((size_t)segments + 1));
	}
	return SCREE_OK;
}

// Reserves memory for the slots and the structure, and reads the samples of paths.
static scree_status reserve_structure(HostLoad* load)
{
	scree_world* world = load->world;
	const uint8_t* at = load->structure->bytes;
	const uint8_t* generation = NULL;
	int used, paths = 0;
	take(&at, &load->table_size, sizeof load->table_size);
	load->table = scree_allocate(sizeof(int) * (size_t)load->table_size + 1);
	if (!load->table)
		return no_memory(load);
	take(&at, load->table, sizeof(int) * (size_t)load->table_size);
	for (int k = 0; k < SLOT_KINDS; ++k)
	{
		take(&at, &used, sizeof used);
		const uint8_t* first = take(&at, NULL, sizeof(uint32_t) * (size_t)used);
		Slots* slots = slots_at(world, k);
		if (used > slots->used && !slots_reserve(slots, used - slots->used + slots->free_count))
			return no_memory(load);
		generation = k == PATHS ? first : generation;
		paths = k == PATHS ? used : paths;
	}
	TRY(reserve_samples(load, &at, (const uint32_t*)(const void*)generation, paths));
	load->arrays = at;
	return SCREE_OK;
}

scree_status saved_host_reserve(HostLoad* load)
{
	scree_world* world = load->world;
	const char* function = load->function;
	ArrayCount then[HOST_ARRAY_COUNT], now[HOST_ARRAY_COUNT];
	if (!load->same)
		TRY(reserve_structure(load)); // first, because arrays have an item for each slot
	count_arrays(world_then(load), then);
	count_arrays(world, now);
	int k = 0;
#define ARRAY(part, table, array, capacity, count, kept)                                           \
	TRY(GROW(function, array, capacity, then[k].room > now[k].room ? then[k].room : now[k].room)); \
	++k;
	HOST_ARRAYS(ARRAY)
#undef ARRAY
	int departed = world->reports.departed_capacity;
	TRY(GROW(function, world->reports.departed, world->reports.departed_capacity,
	         world_then(load)->reports.departed_capacity));
	for (k = departed; k < world->reports.departed_capacity; ++k)
		world->reports.departed[k].step = -1;
	TRY(GROW(function, world->edits.joints, world->edits.joint_capacity, world->joints.capacity));
	return tree_reserve(&world->pipeline, world_then(load)->collidables.used);
}

static void read_slots(Slots* slots, int first, const uint8_t** at)
{
	int used, before = slots->used;
	take(at, &used, sizeof used);
	take(at, slots->generation, sizeof(uint32_t) * (size_t)used);
	for (int k = used; k < before; ++k)
		slots->generation[k] = 0;
	size_t words = (size_t)slots->capacity;
	for (int level = 0; level < SLOT_LEVELS; ++level)
	{
		words = (words + 63) / 64;
		if (words > 0)
			memset(slots->free[level], 0, words * sizeof *slots->free[level]);
	}
	slots->free_count = slots->alive = 0;
	slots_restore(slots, first, used);
}

static void read_structure(HostLoad* load, const ArrayCount counts[HOST_ARRAY_COUNT])
{
	scree_world* world = load->world;
	const uint8_t* at = load->structure->bytes + sizeof(int) * (1 + (size_t)load->table_size);
	scree_release(world->attribute_table);
	world->attribute_table = load->table;
	world->attribute_table_size = load->table_size;
	load->table = NULL;
	for (int k = 0; k < world->paths.used; ++k)
		if (slots_in_use(&world->paths, k))
		{
			scree_release(world->host_paths[k].samples);
			world->host_paths[k].samples = NULL;
		}
	for (int k = 0; k < SLOT_KINDS; ++k)
		read_slots(slots_at(world, k), slots_of[k].first, &at);
	at = load->arrays;
	take_arrays(&at, world, ARRAY_STRUCTURE, counts);
	for (int k = 0; k < load->paths; ++k)
	{
		world->host_paths[k].samples = load->samples[k];
		load->samples[k] = NULL;
	}
	int departed;
	take(&at, &departed, sizeof departed);
	take(&at, world->reports.departed, sizeof(CollidableName) * (size_t)departed);
	for (int k = departed; k < world->reports.departed_capacity; ++k)
		world->reports.departed[k].step = -1;
}

// Copies the members of a struct that snapshots contain.
static void copy_columns(HostTable table, void* to, const void* from)
{
	const ColumnTable* columns = &host_columns[table].table;
	for (int k = 0; k < columns->count; ++k)
	{
		const Column* column = columns->columns + k;
		memcpy((char*)to + column->offset, (const char*)from + column->offset,
		       (size_t)column->bytes * (size_t)column->count);
	}
}

static void read_tree(TreeState* tree, const TreeState* then, const uint8_t** at)
{
	bool fits = then->left_count <= tree->left_capacity;
	tree->tree.leaves = then->tree.leaves;
	tree->room = then->room;
	tree->appended = then->appended;
	tree->placed = 0;
	tree->added_count = 0;
	tree->left_count = fits ? then->left_count : 0;
	tree->shrunk = then->shrunk || !fits;
	take(at, fits ? tree->left : NULL, sizeof(int) * (size_t)then->left_count);
}

static void read_pipeline(Pipeline* pipeline, const Pipeline* then)
{
	copy_columns(HOST_PIPELINE, pipeline, then);
	pipeline->counters = then->counters;
	pipeline->kinematics = then->kinematics;
	pipeline->listed = then->listed;
	pipeline->last_dt = then->last_dt;
	pipeline->edited = then->edited;
	pipeline->chains = then->chains;
	pipeline->chain_ranges = then->chain_ranges;
	pipeline->carried = then->carried;
	pipeline->branches = then->branches;
	pipeline->branch_nodes = then->branch_nodes;
}

void saved_host_read(HostLoad* load)
{
	scree_world* world = load->world;
	const scree_world* then = world_then(load);
	const uint8_t* at = load->step->bytes + sizeof *then;
	ArrayCount counts[HOST_ARRAY_COUNT];
	count_arrays(then, counts);
	int departed = world->reports.departed_capacity;
	bool fields = world->fields.acting > 0;
	if (!load->same)
		read_structure(load, counts);
	copy_columns(HOST_WORLD, world, then);
	world->reports.departed_capacity = departed; // a column, but the array may be larger now
	read_pipeline(&world->pipeline, &then->pipeline);
	take_arrays(&at, world, ARRAY_STEP, counts);
	for (int k = 0; k < world->kinematic_count; ++k)
	{
		SavedKinematic saved;
		HostBody* host = world->host_bodies + world->kinematics[k];
		take(&at, &saved, sizeof saved);
		host->stands = saved.stands;
		host->from = saved.from;
		host->went = saved.went;
		host->target = saved.target;
		host->still = saved.still;
	}
	if (world->pipeline.member)
		memset(world->pipeline.member, 0, (size_t)world->pipeline.member_capacity);
	take(&at, world->pipeline.member, (size_t)member_count(then));
	for (int t = 0; t < 2; ++t)
		read_tree(world->pipeline.trees + t, then->pipeline.trees + t, &at);
	world->reports.fetched = true;
	world->chains_stale = true;
	world->fields.stale |= !load->same && (fields || world->fields.slots.used > 0);
	world->sensors.stale = true;
	idle_forget(world);
}

void saved_host_close(HostLoad* load)
{
	for (int k = 0; k < load->paths; ++k)
		scree_release(load->samples[k]);
	scree_release(load->samples);
	scree_release(load->table);
}
