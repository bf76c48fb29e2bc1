// SPDX-License-Identifier: MIT
// pool_memory.c -- stores the pools in host memory, and makes the copies that measure the bandwidth of this memory.
#include "cpu/cpu.h"
#include "platform/error.h"
#include <string.h>

static const size_t pool_offsets[POOL_COUNT] = {
#define X(type, name, per, role) offsetof(Pools, name),
#include "pools/pools.def"
#undef X
};

// Returns the number of items to allocate: a multiple of MAX_LANES, because wide kernels process whole blocks.
static size_t padded(int capacity) { return ((size_t)capacity + MAX_LANES - 1) / MAX_LANES * MAX_LANES; }

static char* pool_memory(const Cpu* cpu, PoolId pool)
{
	char* memory;
	memcpy(&memory, (const char*)&cpu->pools + pool_offsets[pool], sizeof(memory));
	return memory;
}

scree_status cpu_resize(Backend* b, Per per, int capacity)
{
	Cpu* cpu = b->state;
	if (capacity == b->capacity[per])
		return SCREE_OK;
	size_t items = padded(capacity), old_items = padded(b->capacity[per]);
	uint64_t added = 0; // unsigned: the difference wraps around when pools shrink, and the sum is still right
	for (int pool = 0; pool < POOL_COUNT; ++pool)
	{
		if (pool_info[pool].per != per)
			continue;
		size_t bytes = pool_info[pool].bytes;
		char* memory = scree_reallocate(pool_memory(cpu, pool), old_items * bytes, items * bytes);
		if (!memory && capacity > b->capacity[per])
			return fail(SCREE_ERROR_OUT_OF_MEMORY, "no memory for %d items of pool %s (%zu bytes each)", capacity,
			            pool_info[pool].name, bytes);
		// on failure of this call, or of the next pool, a pool may have more space than capacity, which is allowed
		if (memory)
			memcpy((char*)&cpu->pools + pool_offsets[pool], &memory, sizeof(memory));
		added += ((uint64_t)items - old_items) * bytes; // 64 bits, because size_t would wrap at 4 GB in WebAssembly
	}
	b->capacity[per] = capacity;
	b->bytes += added;
	return SCREE_OK;
}

scree_status cpu_write(Backend* b, PoolId pool, int first, int count, const void* items)
{
	size_t bytes = pool_info[pool].bytes;
	ASSERT(first >= 0 && count >= 0 && first <= b->capacity[pool_info[pool].per] - count);
	if (count > 0)
		memcpy(pool_memory(b->state, pool) + (size_t)first * bytes, items, (size_t)count * bytes);
	return SCREE_OK;
}

scree_status cpu_read(Backend* b, PoolId pool, int first, int count, void* items)
{
	size_t bytes = pool_info[pool].bytes;
	ASSERT(first >= 0 && count >= 0 && first <= b->capacity[pool_info[pool].per] - count);
	if (count > 0)
		memcpy(items, pool_memory(b->state, pool) + (size_t)first * bytes, (size_t)count * bytes);
	return SCREE_OK;
}

scree_status cpu_clear(Backend* b, PoolId pool, int first, int count)
{
	size_t bytes = pool_info[pool].bytes;
	ASSERT(first >= 0 && count >= 0 && first <= b->capacity[pool_info[pool].per] - count);
	if (count > 0)
		memset(pool_memory(b->state, pool) + (size_t)first * bytes, 0, (size_t)count * bytes);
	return SCREE_OK;
}

scree_status cpu_keep(Backend* b, PoolId pool, int first, int count, int at, bool back)
{
	size_t bytes = pool_info[pool].bytes;
	if (count == 0) // the pools may have no memory
		return SCREE_OK;
	char* here = pool_memory(b->state, pool) + (size_t)first * bytes;
	char* there = pool_memory(b->state, POOL_saved) + (size_t)at * pool_info[POOL_saved].bytes;
	memcpy(back ? here : there, back ? there : here, (size_t)count * bytes);
	return SCREE_OK;
}

scree_status cpu_read_begin(Backend* b, PoolId pool, int first, int count)
{
	Cpu* cpu = b->state;
	cpu->async_count = (size_t)count * pool_info[pool].bytes;
	ASSERT(cpu->async_count <= READ_ASYNC_BYTES);
	return cpu_read(b, pool, first, count, cpu->async_bytes);
}

scree_status cpu_read_end(Backend* b, void* items)
{
	const Cpu* cpu = b->state;
	memcpy(items, cpu->async_bytes, cpu->async_count);
	return SCREE_OK;
}

void* cpu_address(Backend* b, PoolId pool) { return pool_memory(b->state, pool); }

void cpu_free_pools(Cpu* cpu)
{
	for (int pool = 0; pool < POOL_COUNT; ++pool)
		scree_release(pool_memory(cpu, pool));
}

void cpu_copy_release(Backend* b)
{
	Cpu* cpu = b->state;
	scree_release(cpu->copy_from);
	scree_release(cpu->copy_to);
	cpu->copy_from = cpu->copy_to = NULL;
}

scree_status cpu_copy_reserve(Backend* b, size_t bytes)
{
	Cpu* cpu = b->state;
	cpu_copy_release(b);
	cpu->copy_from = scree_allocate(bytes);
	cpu->copy_to = scree_allocate(bytes);
	cpu->copy_bytes = bytes;
	if (cpu->copy_from && cpu->copy_to)
		return SCREE_OK;
	return fail(SCREE_ERROR_OUT_OF_MEMORY, "no memory for two blocks of %zu bytes", bytes);
}

static void copy_share(void* context, int block, int blocks)
{
	const Cpu* cpu = context;
	size_t begin = cpu->copy_bytes / (size_t)blocks * (size_t)block;
	size_t end = block + 1 == blocks ? cpu->copy_bytes : cpu->copy_bytes / (size_t)blocks * (size_t)(block + 1);
	for (int k = 0; k < cpu->copy_times; ++k)
		memcpy(cpu->copy_to + begin, cpu->copy_from + begin, end - begin);
}

scree_status cpu_copy(Backend* b, int times)
{
	Cpu* cpu = b->state;
	cpu->copy_times = times;
	threads_run_once(cpu->threads, copy_share, cpu);
	return SCREE_OK;
}
