// SPDX-License-Identifier: MIT
// scree_mpi.c -- divides worlds among ranks, and adds the hashes of all worlds.
#include "outcome.h"
#include <inttypes.h>
#include <stdlib.h>

static void divide(Outcome* o, MPI_Comm comm, int64_t worlds, int64_t* first, int* count)
{
	int ranks = 0, rank = 0;
	if (!first || !count)
	{
		outcome_fail(o, SCREE_ERROR_INVALID, "%s is null", first ? "count" : "first");
		return;
	}
	*first = *count = 0;
	if (o->status != SCREE_OK || !outcome_mpi(o, "MPI_Comm_size", MPI_Comm_size(comm, &ranks)) ||
	    !outcome_mpi(o, "MPI_Comm_rank", MPI_Comm_rank(comm, &rank)))
		return;
	int64_t most = (int64_t)MOST_WORLDS * ranks;
	if (worlds < ranks || worlds > most)
	{
		outcome_fail(o, SCREE_ERROR_INVALID, "worlds is %" PRId64 ", must be from %d, the number of ranks, to %" PRId64,
		             worlds, ranks, most);
		return;
	}
	int64_t each = worlds / ranks, more = worlds % ranks; // the first `more` ranks have one world more
	*first = each * rank + (rank < more ? rank : more);
	*count = (int)(each + (rank < more));
}

scree_status scree_mpi_share(MPI_Comm comm, int64_t worlds, int64_t* first, int* count)
{
	Outcome o = outcome_begin("scree_mpi_share", comm);
	divide(&o, comm, worlds, first, count);
	return outcome_end(&o);
}

// Returns the sum of the hashes of the worlds of this rank.
static uint64_t sum_hashes(Outcome* o, scree_batch* batch)
{
	int worlds = scree_batch_get_worlds(batch);
	uint64_t sum = 0, *hashes = malloc(((size_t)worlds + 1) * sizeof *hashes);
	if (!hashes)
		outcome_fail(o, SCREE_ERROR_OUT_OF_MEMORY, "no memory for the hashes of %d worlds", worlds);
	else if (outcome_scree(o, scree_batch_get_hashes(batch, hashes)))
		for (int k = 0; k < worlds; ++k)
			sum += hashes[k];
	free(hashes);
	return sum;
}

scree_status scree_mpi_hash(scree_batch* batch, MPI_Comm comm, uint64_t* sum)
{
	Outcome o = outcome_begin("scree_mpi_hash", comm);
	uint64_t own = 0, all = 0;
	if (o.status != SCREE_OK)
		return outcome_end(&o); // the other ranks cannot be reached
	if (!sum)
		outcome_fail(&o, SCREE_ERROR_INVALID, "sum is null");
	else
		own = sum_hashes(&o, batch);
	if (outcome_agree(&o, comm))
		outcome_mpi(&o, "MPI_Allreduce", MPI_Allreduce(&own, &all, 1, MPI_UINT64_T, MPI_SUM, comm));
	if (sum)
		*sum = o.status == SCREE_OK ? all : 0;
	return outcome_end(&o);
}
