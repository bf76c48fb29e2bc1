// SPDX-License-Identifier: MIT
// test_cuda.c -- checks that rays in memory of CUDA get the same results as rays in memory of the host. The test is
// skipped without CUDA.
#include "support/make_bodies.h"
#include "tools/common/random_numbers.h"
#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// Types of the CUDA driver (NVIDIA, CUDA Driver API, Virtual Memory Management). They are declared here because the
// header of the driver may be missing.
typedef struct
{
	int type, id; // type: 1 for a device; id: number of the device
} Location;
typedef struct
{
	int type, handles; // type: 1 for pinned memory; handles: 1 if memory can be exported as file descriptors
	Location location;
	void* windows;
	unsigned char flags[8];
} Allocation;
typedef struct
{
	Location location;
	int flags; // flags: 3 for access to read and write
} Access;

#define FUNCTIONS(X)                                                                                    \
	X(cuInit, unsigned)                                                                                 \
	X(cuDevicePrimaryCtxRetain, void**, int)                                                            \
	X(cuCtxSetCurrent, void*)                                                                           \
	X(cuMemGetAllocationGranularity, size_t*, const Allocation*, int)                                   \
	X(cuMemCreate, unsigned long long*, size_t, const Allocation*, unsigned long long)                  \
	X(cuMemExportToShareableHandle, void*, unsigned long long, int, unsigned long long)                 \
	X(cuMemAddressReserve, unsigned long long*, size_t, size_t, unsigned long long, unsigned long long) \
	X(cuMemMap, unsigned long long, size_t, size_t, unsigned long long, unsigned long long)             \
	X(cuMemSetAccess, unsigned long long, size_t, const Access*, size_t)                                \
	X(cuMemcpyHtoD_v2, unsigned long long, const void*, size_t)                                         \
	X(cuMemcpyDtoH_v2, void*, unsigned long long, size_t)
#define X(name, ...) static int (*name)(__VA_ARGS__);
FUNCTIONS(X)
#undef X

static const char* load(void)
{
	void* library = dlopen("libcuda.so.1", RTLD_NOW);
	if (!library)
		return "there is no libcuda.so.1";
#define X(name, ...)                                           \
	if (!(name = (int (*)(__VA_ARGS__))dlsym(library, #name))) \
		return "libcuda.so.1 has no " #name;
	FUNCTIONS(X)
#undef X
	return cuInit(0) ? "cuInit fails" : NULL;
}

#define CUDA(call) assert_int_equal(call, 0)
#define RAYS       100000

static void rays_of_cuda(void** state)
{
	(void)state;
	const char* missing = load();
	if (missing)
	{
		print_message("skipped: %s\n", missing);
		skip();
	}
	scree_world_def def = scree_world_def_default();
	def.device = "opencl:NVIDIA";
	scree_world* world = create_world(&def);
	if (scree_world_get_sharing(world) != SCREE_SHARING_MEMORY)
	{
		print_message("skipped: the driver shares no memory\n");
		scree_world_destroy(world);
		skip();
	}
	add_floor(world);
	for (int k = 0; k < 500; ++k)
		add_crate(world, SCREE_BODY_DYNAMIC, 1.3f * (float)(k % 50), 0.6f + 1.1f * (float)(k / 50));
	run_steps(world, 30);

	void* context;
	Allocation wish = {.type = 1, .handles = 1, .location = {1, 0}};
	Access access = {{1, 0}, 3};
	size_t unit, bytes = 2 * RAYS * sizeof(scree_ray);
	unsigned long long allocation, at;
	int file = -1;
	CUDA(cuDevicePrimaryCtxRetain(&context, 0));
	CUDA(cuCtxSetCurrent(context));
	CUDA(cuMemGetAllocationGranularity(&unit, &wish, 0));
	size_t whole = (bytes + unit - 1) / unit * unit;
	CUDA(cuMemCreate(&allocation, whole, &wish, 0));
	CUDA(cuMemExportToShareableHandle(&file, allocation, 1, 0));
	CUDA(cuMemAddressReserve(&at, whole, 0, 0, 0));
	CUDA(cuMemMap(at, whole, 0, allocation, 0));
	CUDA(cuMemSetAccess(at, whole, &access, 1));
	OK(scree_world_share_queries(world, file, whole));

	scree_ray* rays = calloc(RAYS, sizeof *rays);
	scree_query_result *found = calloc(RAYS, sizeof *found), *shared = calloc(RAYS, sizeof *shared);
	uint64_t seed = 5;
	int hits = 0;
	for (int k = 0; k < RAYS; ++k)
		rays[k] = (scree_ray){.origin = {random_between(&seed, -5.0f, 70.0f), random_between(&seed, 0.0f, 15.0f)},
		                      .translation = {random_between(&seed, -9.0f, 9.0f), random_between(&seed, -9.0f, 9.0f)}};
	OK(scree_world_cast_rays(world, NULL, rays, RAYS, found));
	CUDA(cuMemcpyHtoD_v2(at, rays, RAYS * sizeof *rays));
	OK(scree_world_cast_shared_rays(world, NULL, 0, RAYS, RAYS * sizeof *rays));
	CUDA(cuMemcpyDtoH_v2(shared, at + RAYS * sizeof *rays, RAYS * sizeof *shared));
	for (int k = 0; k < RAYS; ++k)
		hits += found[k].hit;
	assert_true(hits > RAYS / 4);
	assert_memory_equal(shared, found, RAYS * sizeof *found);
	print_message("%d of %d rays of CUDA hit\n", hits, RAYS);

	// the search for rays with random bits ends, and does not change the world
	uint64_t hash = hash_of(world);
	for (int k = 0; k < RAYS; ++k)
		for (size_t i = 0; i < sizeof *rays / 4; ++i)
			((uint32_t*)(void*)(rays + k))[i] =
			    (uint32_t)random_below(&seed, 1 << 16) << 16 ^ (uint32_t)random_below(&seed, 1 << 16);
	CUDA(cuMemcpyHtoD_v2(at, rays, RAYS * sizeof *rays));
	OK(scree_world_cast_shared_rays(world, NULL, 0, RAYS, 0));
	assert_true(hash == hash_of(world));
	scree_world_destroy(world);
	free(rays);
	free(found);
	free(shared);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(rays_of_cuda)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
