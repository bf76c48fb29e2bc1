// SPDX-License-Identifier: MIT
// test_cuda.c -- checks that rays and rows of batches in memory of CUDA get the same results as in memory of the host. The tests are
// skipped without CUDA.
#include "batch/batch.h"
#include "support/make_bodies.h"
#include "tools/common/clock.h"
#include "tools/common/random_numbers.h"
#include <dlfcn.h>
#include <math.h>
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

static const char* load_cuda(void)
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

typedef struct
{
	unsigned long long at; // address on the device
	size_t bytes;
	int file; // file descriptor
} CudaMemory;

static CudaMemory allocate(size_t bytes)
{
	void* context;
	Allocation wish = {.type = 1, .handles = 1, .location = {1, 0}};
	Access access = {{1, 0}, 3};
	size_t unit;
	unsigned long long allocation;
	CudaMemory memory = {.file = -1};
	CUDA(cuDevicePrimaryCtxRetain(&context, 0));
	CUDA(cuCtxSetCurrent(context));
	CUDA(cuMemGetAllocationGranularity(&unit, &wish, 0));
	memory.bytes = (bytes + unit - 1) / unit * unit;
	CUDA(cuMemCreate(&allocation, memory.bytes, &wish, 0));
	CUDA(cuMemExportToShareableHandle(&memory.file, allocation, 1, 0));
	CUDA(cuMemAddressReserve(&memory.at, memory.bytes, 0, 0, 0));
	CUDA(cuMemMap(memory.at, memory.bytes, 0, allocation, 0));
	CUDA(cuMemSetAccess(memory.at, memory.bytes, &access, 1));
	return memory;
}

// Returns a world on a device that shares memory with CUDA, or null after a message that gives the reason.
static scree_world* open_sharing(void)
{
	const char* missing = load_cuda();
	if (missing)
	{
		print_message("skipped: %s\n", missing);
		return NULL;
	}
	scree_world_def def = scree_world_def_default();
	def.device = "opencl:NVIDIA";
	scree_world* world = create_world(&def);
	if (scree_world_get_sharing(world) == SCREE_SHARING_MEMORY)
		return world;
	print_message("skipped: the driver shares no memory\n");
	scree_world_destroy(world);
	return NULL;
}

static void rays_of_cuda(void** state)
{
	(void)state;
	scree_world* world = open_sharing();
	if (!world)
		skip();
	add_floor(world);
	for (int k = 0; k < 500; ++k)
		add_crate(world, SCREE_BODY_DYNAMIC, 1.3f * (float)(k % 50), 0.6f + 1.1f * (float)(k / 50));
	run_steps(world, 30);

	CudaMemory memory = allocate(2 * RAYS * sizeof(scree_ray));
	unsigned long long at = memory.at;
	OK(scree_world_share_queries(world, memory.file, memory.bytes));

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

#define WORLDS  65536
#define CRATES  5
#define COLUMNS (7 * CRATES)
#define STEPS   40  // steps whose outputs are compared
#define TIMED   300 // steps whose duration is measured

typedef struct
{
	scree_batch* batch;
	float *inputs, *outputs;
} Side;

static void open_side(Side* side, scree_world* world, const scree_body bodies[CRATES], int channels)
{
	scree_batch_def def = scree_batch_def_default();
	scree_channel in = scree_channel_make(SCREE_INPUT_FORCE), out[2 * CRATES];
	def.worlds = WORLDS;
	def.device = "opencl:NVIDIA";
	def.templates = &world;
	def.template_count = 1;
	OK(scree_batch_create(&def, &side->batch));
	in.body = bodies[0];
	for (int k = 0; k < 2 * CRATES; ++k)
	{
		out[k] = scree_channel_make(k % 2 == 0 ? SCREE_OUTPUT_POSE : SCREE_OUTPUT_VELOCITY);
		out[k].body = bodies[k / 2];
	}
	OK(scree_batch_bind(side->batch, SCREE_STEP_INPUTS, &in, 1, NULL));
	OK(scree_batch_bind(side->batch, SCREE_OUTPUTS, out, channels, NULL));
	side->inputs = scree_batch_get_rows(side->batch, SCREE_STEP_INPUTS);
	side->outputs = scree_batch_get_rows(side->batch, SCREE_OUTPUTS);
}

static void step_side(Side* side, int steps)
{
	for (int k = 0; k < steps; ++k)
		OK(scree_batch_step(side->batch, 1.0f / 60.0f, 4, 1));
}

// Returns the duration of a step, ms: that of many steps, after whose last one the hashes are read, because a step without outputs
// ends before the device has finished it.
static double time_side(Side* side, uint64_t* hashes)
{
	OK(scree_batch_get_hashes(side->batch, hashes));
	double begin = seconds_now();
	step_side(side, TIMED);
	OK(scree_batch_get_hashes(side->batch, hashes));
	return 1e3 * (seconds_now() - begin) / TIMED;
}

// Compares batches whose worlds are in one block or in two.
static void compare_rows(int parts)
{
	scree_world* world = open_world_on("cpu", 1, (float)-G);
	scree_body bodies[CRATES];
	add_floor(world);
	for (int k = 0; k < CRATES; ++k)
		bodies[k] = add_crate(world, SCREE_BODY_DYNAMIC, 0.1f * (float)k, 0.6f + 1.1f * (float)k);
	Side host, cuda, bare; // bare: without outputs, inputs in memory of CUDA
	batch_parts_setting = parts;
	open_side(&host, world, bodies, 2 * CRATES);
	open_side(&cuda, world, bodies, 2 * CRATES);
	open_side(&bare, world, bodies, 0);
	batch_parts_setting = 0;
	size_t input_bytes = 2 * WORLDS * sizeof(float), output_bytes = COLUMNS * WORLDS * sizeof(float);
	CudaMemory inputs = allocate(input_bytes), outputs = allocate(output_bytes);
	OK(scree_batch_share_rows(cuda.batch, SCREE_STEP_INPUTS, inputs.file, inputs.bytes));
	OK(scree_batch_share_rows(cuda.batch, SCREE_OUTPUTS, outputs.file, outputs.bytes));
	OK(scree_batch_share_rows(bare.batch, SCREE_STEP_INPUTS, inputs.file, inputs.bytes));
	float* found = malloc(output_bytes);
	uint64_t seed = 7, *hashes = malloc(3 * WORLDS * sizeof *hashes);
	for (int step = 0; step < STEPS; ++step)
	{
		for (int k = 0; k < 2 * WORLDS; ++k)
			host.inputs[k] = random_between(&seed, -30.0f, 30.0f);
		CUDA(cuMemcpyHtoD_v2(inputs.at, host.inputs, input_bytes));
		step_side(&host, 1);
		step_side(&cuda, 1);
		step_side(&bare, 1);
		CUDA(cuMemcpyDtoH_v2(found, outputs.at, output_bytes));
		assert_memory_equal(found, host.outputs, output_bytes);
	}
	double times[] = {time_side(&host, hashes), time_side(&cuda, hashes + WORLDS),
	                  time_side(&bare, hashes + 2 * WORLDS)};
	assert_memory_equal(hashes, hashes + WORLDS, WORLDS * sizeof *hashes);
	assert_memory_equal(hashes, hashes + 2 * WORLDS, WORLDS * sizeof *hashes);
	print_message("%d worlds in %d blocks: a step takes %.3f ms without outputs, %.3f ms with %d columns of CUDA, %.3f "
	              "of the host\n",
	              WORLDS, parts, times[2], times[1], COLUMNS, times[0]);

	// a value that is refused is named as on the host
	char sentence[256];
	host.inputs[2 * 12345 + 1] = (float)NAN;
	CUDA(cuMemcpyHtoD_v2(inputs.at, host.inputs, input_bytes));
	assert_int_equal(scree_batch_step(host.batch, 1.0f / 60.0f, 4, 1), SCREE_ERROR_INVALID);
	snprintf(sentence, sizeof sentence, "%s", scree_error());
	assert_int_equal(scree_batch_step(cuda.batch, 1.0f / 60.0f, 4, 1), SCREE_ERROR_INVALID);
	assert_string_equal(scree_error(), sentence);
	scree_batch_destroy(host.batch);
	scree_batch_destroy(cuda.batch);
	scree_batch_destroy(bare.batch);
	scree_world_destroy(world);
	free(found);
	free(hashes);
}

static void rows_of_cuda(void** state)
{
	(void)state;
	scree_world* sharing = open_sharing();
	if (!sharing)
		skip();
	scree_world_destroy(sharing);
	compare_rows(1);
	compare_rows(2);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(rays_of_cuda), cmocka_unit_test(rows_of_cuda)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
