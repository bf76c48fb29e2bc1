// SPDX-License-Identifier: MIT
// mpi_worlds.c -- steps a batch over the ranks of MPI, and prints results that must not depend on the number of ranks.
//
// The last rank then makes calls that fail; all ranks must return the same status with the same sentence.
#include <inttypes.h>
#include <scree/scree_math.h>
#include <scree/scree_mpi.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define WORLDS 11 // divided by neither 2, 3 nor 4
#define STEPS  40
#define SEED   7

#define CHECK(x)                                                                                                \
	do                                                                                                          \
	{                                                                                                           \
		if (!(x))                                                                                               \
		{                                                                                                       \
			fprintf(stderr, "mpi_worlds: line %d: %s is false; last error: %s\n", __LINE__, #x, scree_error()); \
			MPI_Abort(MPI_COMM_WORLD, 1);                                                                       \
		}                                                                                                       \
	} while (0)
#define OK(x) CHECK((x) == SCREE_OK)

static int ranks, rank;

// Makes a world with a floor and a tower of boxes, which falls to one side.
static scree_world* make_tower(int boxes)
{
	scree_world_def def = scree_world_def_default();
	scree_world* world;
	scree_body body;
	def.threads = 1;
	def.sleep = false;
	OK(scree_world_create(&def, &world));
	OK(scree_body_create_box(world, SCREE_BODY_STATIC, scree_pose_make(0.0f, -0.5f, 0.0f), 20.0f, 0.5f, 0, &body));
	for (int k = 0; k < boxes; ++k)
		OK(scree_body_create_box(world, SCREE_BODY_DYNAMIC, scree_pose_make(0.3f * (float)k, 0.6f + (float)k, 0.0f),
		                         0.5f, 0.5f, 0, &body));
	return world;
}

static uint32_t draw(int64_t world, int step)
{
	return scree_random_make(SEED, (uint64_t)world, (uint32_t)step, 0).words[0];
}

static scree_batch* make_batch(int64_t first, int count)
{
	int template_of[WORLDS];
	scree_world* templates[2] = {make_tower(3), make_tower(5)};
	scree_batch_def def = scree_batch_def_default();
	scree_batch* batch;
	for (int k = 0; k < count; ++k)
		template_of[k] = (int)(draw(first + k, -1) % 2);
	def.worlds = count;
	def.templates = templates;
	def.template_count = 2;
	def.template_of = template_of;
	def.threads = 1;
	OK(scree_batch_create(&def, &batch));
	scree_world_destroy(templates[0]);
	scree_world_destroy(templates[1]);
	return batch;
}

// Steps the worlds of this rank, resets some by their global numbers, and prints the sum of all hashes.
static void check_steps(scree_batch* batch, int64_t first, int count)
{
	uint8_t mask[WORLDS];
	uint64_t sum;
	for (int step = 0; step < STEPS; ++step)
	{
		for (int k = 0; k < count; ++k)
			mask[k] = draw(first + k, step) % 16 == 0;
		OK(scree_batch_reset(batch, mask));
		OK(scree_batch_step(batch, 1.0f / 60.0f, 4, 1));
		if (step % 10 != 9)
			continue;
		OK(scree_mpi_hash(batch, MPI_COMM_WORLD, &sum));
		if (rank == 0)
			printf("step %d: sum %016" PRIx64 "\n", step, sum);
	}
}

// Copies rows of 24 bytes, which begin with the hashes of the worlds, from sources that are drawn. Some worlds are the source of
// many, some of none. Each rank checks its rows with the hashes of all ranks.
static void check_rows(scree_batch* batch, int64_t first, int count)
{
	uint64_t from[WORLDS][3], to[WORLDS][3], hashes[WORLDS], all[WORLDS];
	int64_t sources[WORLDS];
	int counts[64], begins[64];
	OK(scree_batch_get_hashes(batch, hashes));
	CHECK(MPI_Allgather(&count, 1, MPI_INT, counts, 1, MPI_INT, MPI_COMM_WORLD) == MPI_SUCCESS);
	for (int r = 0, sum = 0; r < ranks; sum += counts[r++])
		begins[r] = sum;
	CHECK(MPI_Allgatherv(hashes, count, MPI_UINT64_T, all, counts, begins, MPI_UINT64_T, MPI_COMM_WORLD) ==
	      MPI_SUCCESS);
	for (int k = 0; k < count; ++k)
	{
		uint64_t row[] = {hashes[k], (uint64_t)(first + k), ~hashes[k]};
		memcpy(from[k], row, sizeof row);
		sources[k] = (int64_t)(draw(first + k, STEPS) % WORLDS) / 2;
	}
	OK(scree_mpi_copy_rows(MPI_COMM_WORLD, count, sources, sizeof from[0], from, to));
	for (int k = 0; k < count; ++k)
		CHECK(to[k][0] == all[sources[k]] && to[k][1] == (uint64_t)sources[k] && to[k][2] == ~all[sources[k]]);
	uint64_t sum = 0, total = 0;
	for (int k = 0; k < count; ++k)
		sum += to[k][0] * (uint64_t)(first + k + 1);
	CHECK(MPI_Allreduce(&sum, &total, 1, MPI_UINT64_T, MPI_SUM, MPI_COMM_WORLD) == MPI_SUCCESS);
	if (rank == 0)
		printf("rows: %016" PRIx64 "\n", total);
	// nobody has a row
	OK(scree_mpi_copy_rows(MPI_COMM_WORLD, 0, NULL, 8, NULL, NULL));
}

// Copies the states of worlds of the same template from sources that are drawn, and steps on. Sources and hashes are known to
// all ranks.
static void check_worlds(scree_batch* batch, int64_t first, int count)
{
	int64_t sources[WORLDS];
	uint64_t own[WORLDS] = {0}, before[WORLDS], after[WORLDS], sum;
	OK(scree_batch_get_hashes(batch, own + first));
	CHECK(MPI_Allreduce(own, before, WORLDS, MPI_UINT64_T, MPI_SUM, MPI_COMM_WORLD) == MPI_SUCCESS);
	for (int k = 0; k < count; ++k)
	{
		const int64_t world = first + k;
		sources[k] = draw(world, STEPS + 1) % WORLDS;
		while (draw(sources[k], -1) % 2 != draw(world, -1) % 2)
			sources[k] = (sources[k] + 1) % WORLDS;
	}
	OK(scree_mpi_copy_worlds(batch, MPI_COMM_WORLD, sources));
	OK(scree_batch_get_hashes(batch, after));
	for (int k = 0; k < count; ++k)
		CHECK(after[k] == before[sources[k]]);
	OK(scree_batch_step(batch, 1.0f / 60.0f, 4, 5));
	OK(scree_mpi_hash(batch, MPI_COMM_WORLD, &sum));
	if (rank == 0)
		printf("worlds: sum %016" PRIx64 "\n", sum);
}

// Checks that a call failed with this status, and with a sentence that contains `text` and names the last rank.
static void refused(scree_status found, scree_status expected, const char* text)
{
	char place[32];
	snprintf(place, sizeof place, " (on rank %d)", ranks - 1);
	CHECK(found == expected);
	CHECK(strstr(scree_error(), text) && strstr(scree_error(), place));
}

// The last rank has arguments that are refused. Sizes of rows cannot differ on one rank alone.
static void check_failures(scree_batch* batch)
{
	bool last = rank == ranks - 1;
	uint64_t sum, row = 0, made = 0;
	int64_t source = last ? -1 : 0, good = 0;
	refused(scree_mpi_hash(batch, MPI_COMM_WORLD, last ? NULL : &sum), SCREE_ERROR_INVALID,
	        "scree_mpi_hash: sum is null");
	refused(scree_mpi_hash(last ? NULL : batch, MPI_COMM_WORLD, &sum), SCREE_ERROR_INVALID,
	        "scree_mpi_hash: scree_batch_get_hashes: batch is null");
	refused(scree_mpi_copy_rows(MPI_COMM_WORLD, 1, &source, 8, &row, &made), SCREE_ERROR_INVALID,
	        "scree_mpi_copy_rows: sources[0] is -1, must be from 0 to");
	refused(scree_mpi_copy_rows(MPI_COMM_WORLD, 1, last ? NULL : &good, 8, &row, &made), SCREE_ERROR_INVALID,
	        "sources is null");
	refused(scree_mpi_copy_rows(MPI_COMM_WORLD, last ? -1 : 1, &good, 8, &row, &made), SCREE_ERROR_INVALID,
	        "count is -1, must be from 0 to 16777216");
	refused(scree_mpi_copy_rows(MPI_COMM_WORLD, 1, &good, last ? 0 : 8, &row, &made), SCREE_ERROR_INVALID,
	        "row_bytes is 0, must be from 1 to");
	int64_t sources[WORLDS], begin, more;
	int worlds;
	OK(scree_mpi_share(MPI_COMM_WORLD, WORLDS, &begin, &worlds));
	for (int k = 0; k < worlds; ++k)
		sources[k] = begin + k;
	more = sources[worlds - 1];
	sources[worlds - 1] = last ? WORLDS : more;
	refused(scree_mpi_copy_worlds(batch, MPI_COMM_WORLD, sources), SCREE_ERROR_INVALID, "is 11, must be from 0 to 10");
	sources[worlds - 1] = more;
	refused(scree_mpi_copy_worlds(last ? NULL : batch, MPI_COMM_WORLD, sources), SCREE_ERROR_INVALID, "batch is null");
	refused(scree_mpi_copy_worlds(batch, MPI_COMM_WORLD, last ? NULL : sources), SCREE_ERROR_INVALID,
	        "sources is null");
	OK(scree_mpi_copy_worlds(batch, MPI_COMM_WORLD, sources)); // no world needs a row
	// the last world of the last rank gets a state of the other template
	int64_t other = 0;
	while (draw(other, -1) % 2 == draw(WORLDS - 1, -1) % 2)
		++other;
	sources[worlds - 1] = last ? other : more;
	refused(scree_mpi_copy_worlds(batch, MPI_COMM_WORLD, sources), SCREE_ERROR_INVALID,
	        "scree_mpi_copy_worlds: scree_batch_load: ");
	if (ranks > 1)
	{
		CHECK(scree_mpi_copy_rows(MPI_COMM_WORLD, 1, &good, last ? 4 : 8, &row, &made) == SCREE_ERROR_INVALID);
		CHECK(strstr(scree_error(), "row_bytes is 4 on one rank and 8 on another"));
	}
	CHECK(scree_mpi_hash(batch, MPI_COMM_NULL, &sum) == SCREE_ERROR_INVALID &&
	      strstr(scree_error(), "comm is MPI_COMM_NULL"));
	// the batch and the communicator are as before
	OK(scree_mpi_hash(batch, MPI_COMM_WORLD, &sum));
	if (rank == 0)
		printf("after failures: sum %016" PRIx64 "\n", sum);
}

static void check_shares(void)
{
	int64_t first, end = 0;
	int count;
	for (int64_t worlds = ranks; worlds < 5 * ranks; ++worlds)
	{
		OK(scree_mpi_share(MPI_COMM_WORLD, worlds, &first, &count));
		CHECK(count == worlds / ranks || count == worlds / ranks + 1);
		CHECK(first == worlds / ranks * rank + (rank < worlds % ranks ? rank : worlds % ranks));
		CHECK(rank < ranks - 1 || first + count == worlds);
	}
	OK(scree_mpi_share(MPI_COMM_WORLD, (int64_t)16777216 * ranks, &first, &count));
	CHECK(count == 16777216);
	CHECK(scree_mpi_share(MPI_COMM_WORLD, (int64_t)16777216 * ranks + 1, &first, &count) == SCREE_ERROR_INVALID);
	CHECK(scree_mpi_share(MPI_COMM_WORLD, ranks - 1, &first, &count) == SCREE_ERROR_INVALID && first == 0 &&
	      count == 0);
	CHECK(strstr(scree_error(), "the number of ranks"));
	CHECK(scree_mpi_share(MPI_COMM_WORLD, WORLDS, NULL, &count) == SCREE_ERROR_INVALID &&
	      strstr(scree_error(), "first is null"));
	CHECK(scree_mpi_share(MPI_COMM_WORLD, WORLDS, &end, NULL) == SCREE_ERROR_INVALID &&
	      strstr(scree_error(), "count is null"));
}

int main(int argument_count, char** arguments)
{
	int64_t first;
	int count;
	CHECK(scree_mpi_share(MPI_COMM_WORLD, WORLDS, &first, &count) == SCREE_ERROR_INVALID &&
	      strstr(scree_error(), "MPI_Init has not been called"));
	CHECK(MPI_Init(&argument_count, &arguments) == MPI_SUCCESS);
	CHECK(MPI_Comm_size(MPI_COMM_WORLD, &ranks) == MPI_SUCCESS && MPI_Comm_rank(MPI_COMM_WORLD, &rank) == MPI_SUCCESS);
	check_shares();
	OK(scree_mpi_share(MPI_COMM_WORLD, WORLDS, &first, &count));
	scree_batch* batch = make_batch(first, count);
	check_steps(batch, first, count);
	check_rows(batch, first, count);
	check_worlds(batch, first, count);
	check_failures(batch);
	scree_batch_destroy(batch);
	MPI_Finalize();
	return 0;
}
