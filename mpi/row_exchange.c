// SPDX-License-Identifier: MIT
// row_exchange.c -- exchanges rows between ranks: each rank gets the rows of the worlds that it needs, each once.
//
// Each rank makes a sorted list of the sources that it needs. Ranks exchange these lists, then the rows. Lists that are sorted
// by global numbers are also sorted by ranks, so no other table says which row comes from where. After each part that may fail on
// one rank, the ranks agree whether they go on.
#include "row_exchange.h"
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

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

// Shares the numbers of worlds of all ranks, and the size of rows.
static bool share_counts(Outcome* o, MPI_Comm comm, Exchange* x, const ExchangeNeeds* needs)
{
	int64_t own = needs->worlds, bytes = (int64_t)needs->row_bytes, least_most[2] = {-bytes, bytes}, found[2] = {0, 0};
	if (!outcome_mpi(o, "MPI_Allreduce", MPI_Allreduce(least_most, found, 2, MPI_INT64_T, MPI_MAX, comm)) ||
	    !outcome_mpi(o, "MPI_Allgather", MPI_Allgather(&own, 1, MPI_INT64_T, x->firsts + 1, 1, MPI_INT64_T, comm)))
		return false;
	for (int r = 0; r < x->ranks; ++r)
		x->firsts[r + 1] += x->firsts[r];
	x->row_bytes = (size_t)found[1];
	if (needs->equal_rows && -found[0] != found[1])
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
static bool list_needed(Outcome* o, Exchange* x, const ExchangeNeeds* needs)
{
	const int64_t all = x->firsts[x->ranks], first = x->firsts[x->rank];
	int count = 0;
	x->needed = allocate(o, (size_t)needs->worlds, sizeof *x->needed);
	if (!x->needed)
		return false;
	for (int k = 0; k < needs->worlds; ++k)
	{
		const int64_t source = needs->sources[k];
		if (source < 0 || source >= all)
			return outcome_fail(o, SCREE_ERROR_INVALID, "sources[%d] is %" PRId64 ", must be from 0 to %" PRId64, k,
			                    source, all - 1);
		if (!needs->leaves_own || source != first + k)
			x->needed[count++] = source;
	}
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
	add_up(COMING(x), COMING_BEGIN(x), x->ranks); // at most one row for each world
	x->going = add_up(GOING(x), GOING_BEGIN(x), x->ranks);
	return x->going >= 0 ||
	       outcome_fail(o, SCREE_ERROR_OUT_OF_MEMORY, "more than %d rows are needed from one rank", INT32_MAX);
}

static void allocate_rows(Outcome* o, Exchange* x)
{
	x->sent = allocate(o, (size_t)x->going, sizeof *x->sent);
	x->goes = allocate(o, (size_t)x->going, x->row_bytes);
	x->came = allocate(o, (size_t)x->coming, x->row_bytes);
}

bool exchange_begin(Outcome* o, MPI_Comm comm, Exchange* x, const ExchangeNeeds* needs)
{
	if (o->status == SCREE_OK && outcome_mpi(o, "MPI_Comm_size", MPI_Comm_size(comm, &x->ranks)) &&
	    outcome_mpi(o, "MPI_Comm_rank", MPI_Comm_rank(comm, &x->rank)))
	{
		x->firsts = allocate(o, (size_t)x->ranks, sizeof *x->firsts);
		x->counts = allocate(o, 4 * (size_t)x->ranks, sizeof *x->counts);
	}
	if (!outcome_agree(o, comm))
		return false;
	if (share_counts(o, comm, x, needs))
		list_needed(o, x, needs);
	if (!outcome_agree(o, comm))
		return false;
	if (exchange_counts(o, comm, x))
		allocate_rows(o, x);
	return outcome_agree(o, comm) && outcome_mpi(o, "MPI_Alltoallv",
	                                             MPI_Alltoallv(x->needed, COMING(x), COMING_BEGIN(x), MPI_INT64_T,
	                                                           x->sent, GOING(x), GOING_BEGIN(x), MPI_INT64_T, comm));
}

bool exchange_rows(Outcome* o, MPI_Comm comm, Exchange* x)
{
	MPI_Datatype row;
	if (!outcome_agree(o, comm) ||
	    !outcome_mpi(o, "MPI_Type_contiguous", MPI_Type_contiguous((int)x->row_bytes, MPI_BYTE, &row)))
		return false;
	if (outcome_mpi(o, "MPI_Type_commit", MPI_Type_commit(&row)))
		outcome_mpi(
		    o, "MPI_Alltoallv",
		    MPI_Alltoallv(x->goes, GOING(x), GOING_BEGIN(x), row, x->came, COMING(x), COMING_BEGIN(x), row, comm));
	outcome_mpi(o, "MPI_Type_free", MPI_Type_free(&row));
	return o->status == SCREE_OK;
}

const char* exchange_row(const Exchange* x, int64_t source)
{
	const int64_t* found = bsearch(&source, x->needed, (size_t)x->coming, sizeof *x->needed, compare_numbers);
	return x->came + (size_t)(found - x->needed) * x->row_bytes;
}

int exchange_sent(const Exchange* x, int k) { return (int)(x->sent[k] - x->firsts[x->rank]); }

void exchange_end(Exchange* x)
{
	free(x->firsts);
	free(x->counts);
	free(x->needed);
	free(x->sent);
	free(x->came);
	free(x->goes);
}
