// SPDX-License-Identifier: MIT
// copy_rows.c -- copies rows of worlds between ranks.
//
// Each rank makes a sorted list of the sources that it needs, each once. Ranks exchange these lists, then the rows. Lists that
// are sorted by global numbers are also sorted by ranks, so no other table says which row comes from where.
#include "outcome.h"
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

#define MOST_ROW ((size_t)1 << 30) // bytes; the size of a datatype of MPI is an int

typedef struct
{
	int ranks, rank;
	int64_t* firsts; // for each rank and one more: global number of its first world
	int*
	    counts; // four arrays with an entry for each rank: rows that come, where they begin; rows that go, where they begin
	int64_t* needed; // global numbers of the rows that come, ascending, each once
	int64_t* asked;  // global numbers of the rows that go, those for rank 0 first
	int coming, going;
	char *came, *goes; // rows
} Exchange;

#define COMING(x)       ((x)->counts)
#define COMING_BEGIN(x) ((x)->counts + (x)->ranks)
#define GOING(x)        ((x)->counts + 2 * (x)->ranks)
#define GOING_BEGIN(x)  ((x)->counts + 3 * (x)->ranks)

// Returns zeroed memory for at least one entry. On failure notes it and returns null.
static void* allocate(Outcome* o, size_t count, size_t bytes)
{
	void* made = count < SIZE_MAX / bytes ? calloc(count + 1, bytes) : NULL;
	if (!made)
		outcome_fail(o, SCREE_ERROR_OUT_OF_MEMORY, "no memory for %zu entries of %zu bytes", count, bytes);
	return made;
}

static bool check(Outcome* o, int count, const int64_t* sources, size_t row_bytes, const void* from, const void* to)
{
	if (count < 0 || count > MOST_WORLDS)
		return outcome_fail(o, SCREE_ERROR_INVALID, "count is %d, must be from 0 to %d", count, MOST_WORLDS);
	if (row_bytes < 1 || row_bytes > MOST_ROW)
		return outcome_fail(o, SCREE_ERROR_INVALID, "row_bytes is %zu, must be from 1 to %zu", row_bytes, MOST_ROW);
	if (count > 0 && (!sources || !from || !to))
		return outcome_fail(o, SCREE_ERROR_INVALID, "%s is null", !sources ? "sources" : !from ? "from" : "to");
	return true;
}

// Shares the counts of all ranks, and checks that their rows are of one size.
static bool share_counts(Outcome* o, MPI_Comm comm, Exchange* x, int count, size_t row_bytes)
{
	int64_t own = count, bytes = (int64_t)row_bytes, least_most[2] = {-bytes, bytes}, found[2] = {0, 0};
	if (!outcome_mpi(o, "MPI_Allreduce", MPI_Allreduce(least_most, found, 2, MPI_INT64_T, MPI_MAX, comm)) ||
	    !outcome_mpi(o, "MPI_Allgather", MPI_Allgather(&own, 1, MPI_INT64_T, x->firsts + 1, 1, MPI_INT64_T, comm)))
		return false;
	for (int r = 0; r < x->ranks; ++r)
		x->firsts[r + 1] += x->firsts[r];
	if (-found[0] != found[1])
		return outcome_fail(o, SCREE_ERROR_INVALID, "row_bytes is %" PRId64 " on one rank and %" PRId64 " on another",
		                    -found[0], found[1]);
	return true;
}

static int compare_numbers(const void* a, const void* b)
{
	int64_t x = *(const int64_t*)a, y = *(const int64_t*)b;
	return (x > y) - (x < y);
}

// Lists the sources of this rank, and counts those of each rank.
static bool list_needed(Outcome* o, Exchange* x, const int64_t* sources, int count)
{
	int64_t all = x->firsts[x->ranks];
	for (int k = 0; k < count; ++k)
		if (sources[k] < 0 || sources[k] >= all)
			return outcome_fail(o, SCREE_ERROR_INVALID, "sources[%d] is %" PRId64 ", must be from 0 to %" PRId64, k,
			                    sources[k], all - 1);
	x->needed = allocate(o, (size_t)count, sizeof *x->needed);
	if (!x->needed)
		return false;
	if (count > 0)
		memcpy(x->needed, sources, (size_t)count * sizeof *sources);
	qsort(x->needed, (size_t)count, sizeof *x->needed, compare_numbers);
	for (int k = 0, owner = 0; k < count; ++k)
	{
		if (k > 0 && x->needed[k] == x->needed[x->coming - 1])
			continue;
		while (x->needed[k] >= x->firsts[owner + 1])
			++owner;
		x->needed[x->coming++] = x->needed[k];
		++COMING(x)[owner];
	}
	return true;
}

// Adds up counts into the places at which the ranks begin. Returns the sum, or -1 if it is too large for an int.
static int add_up(const int* counts, int* begins, int ranks)
{
	int64_t sum = 0;
	for (int r = 0; r < ranks; ++r)
	{
		begins[r] = (int)sum;
		sum += counts[r];
		if (sum > INT32_MAX)
			return -1;
	}
	return (int)sum;
}

// Exchanges the numbers of the rows that ranks need from each other.
static bool exchange_counts(Outcome* o, MPI_Comm comm, Exchange* x)
{
	if (!outcome_mpi(o, "MPI_Alltoall", MPI_Alltoall(COMING(x), 1, MPI_INT, GOING(x), 1, MPI_INT, comm)))
		return false;
	add_up(COMING(x), COMING_BEGIN(x), x->ranks); // at most `count` rows
	x->going = add_up(GOING(x), GOING_BEGIN(x), x->ranks);
	return x->going >= 0 ||
	       outcome_fail(o, SCREE_ERROR_OUT_OF_MEMORY, "more than %d rows are needed from one rank", INT32_MAX);
}

// Returns whether the memory of all rows is there.
static bool allocate_rows(Outcome* o, Exchange* x, size_t row_bytes)
{
	x->asked = allocate(o, (size_t)x->going, sizeof *x->asked);
	x->goes = allocate(o, (size_t)x->going, row_bytes);
	x->came = allocate(o, (size_t)x->coming, row_bytes);
	return o->status == SCREE_OK;
}

static bool exchange_rows(Outcome* o, MPI_Comm comm, Exchange* x, size_t row_bytes, const char* from)
{
	MPI_Datatype row;
	if (!outcome_mpi(o, "MPI_Alltoallv",
	                 MPI_Alltoallv(x->needed, COMING(x), COMING_BEGIN(x), MPI_INT64_T, x->asked, GOING(x),
	                               GOING_BEGIN(x), MPI_INT64_T, comm)))
		return false;
	for (int k = 0; k < x->going; ++k)
		memcpy(x->goes + (size_t)k * row_bytes, from + (size_t)(x->asked[k] - x->firsts[x->rank]) * row_bytes,
		       row_bytes);
	if (!outcome_mpi(o, "MPI_Type_contiguous", MPI_Type_contiguous((int)row_bytes, MPI_BYTE, &row)))
		return false;
	if (outcome_mpi(o, "MPI_Type_commit", MPI_Type_commit(&row)))
		outcome_mpi(
		    o, "MPI_Alltoallv",
		    MPI_Alltoallv(x->goes, GOING(x), GOING_BEGIN(x), row, x->came, COMING(x), COMING_BEGIN(x), row, comm));
	outcome_mpi(o, "MPI_Type_free", MPI_Type_free(&row));
	return o->status == SCREE_OK;
}

static void place_rows(const Exchange* x, const int64_t* sources, int count, size_t row_bytes, char* to)
{
	for (int k = 0; k < count; ++k)
	{
		const int64_t* found = bsearch(sources + k, x->needed, (size_t)x->coming, sizeof *x->needed, compare_numbers);
		memcpy(to + (size_t)k * row_bytes, x->came + (size_t)(found - x->needed) * row_bytes, row_bytes);
	}
}

// After each part that may fail on one rank, the ranks agree whether they go on.
static void copy(Outcome* o, MPI_Comm comm, Exchange* x, int count, const int64_t* sources, size_t row_bytes,
                 const void* from, void* to)
{
	if (check(o, count, sources, row_bytes, from, to) &&
	    outcome_mpi(o, "MPI_Comm_size", MPI_Comm_size(comm, &x->ranks)) &&
	    outcome_mpi(o, "MPI_Comm_rank", MPI_Comm_rank(comm, &x->rank)))
	{
		x->firsts = allocate(o, (size_t)x->ranks, sizeof *x->firsts);
		x->counts = allocate(o, 4 * (size_t)x->ranks, sizeof *x->counts);
	}
	if (!outcome_agree(o, comm))
		return;
	if (share_counts(o, comm, x, count, row_bytes))
		list_needed(o, x, sources, count);
	if (!outcome_agree(o, comm))
		return;
	if (exchange_counts(o, comm, x))
		allocate_rows(o, x, row_bytes);
	if (!outcome_agree(o, comm))
		return;
	if (exchange_rows(o, comm, x, row_bytes, from))
		place_rows(x, sources, count, row_bytes, to);
}

scree_status scree_mpi_copy_rows(MPI_Comm comm, int count, const int64_t* sources, size_t row_bytes, const void* from,
                                 void* to)
{
	Outcome o = outcome_begin("scree_mpi_copy_rows", comm);
	Exchange x = {0};
	if (o.status == SCREE_OK)
		copy(&o, comm, &x, count, sources, row_bytes, from, to);
	free(x.firsts);
	free(x.counts);
	free(x.needed);
	free(x.asked);
	free(x.came);
	free(x.goes);
	return outcome_end(&o);
}
