// SPDX-License-Identifier: MIT
// copy_worlds.c -- copies states of worlds between ranks, as rows of scree_batch_save.
#include "row_exchange.h"
#include <stdlib.h>
#include <string.h>

#define LOADED_BYTES ((size_t)1 << 26) // memory for rows that are loaded in one call

// Writes the rows of the worlds that other worlds need.
static bool save(Outcome* o, scree_batch* batch, Exchange* x)
{
	int32_t* worlds = malloc(((size_t)x->going + 1) * sizeof *worlds);
	if (!worlds)
		return outcome_fail(o, SCREE_ERROR_OUT_OF_MEMORY, "no memory for the indices of %d worlds", x->going);
	for (int k = 0; k < x->going; ++k)
		worlds[k] = exchange_sent(x, k);
	bool good = x->going == 0 || outcome_scree(o, scree_batch_save(batch, worlds, x->going, x->goes, x->row_bytes));
	free(worlds);
	return good;
}

// Loads the rows that came, some at a time, because many worlds may get one row.
static void load(Outcome* o, scree_batch* batch, const Exchange* x, const int64_t* sources, int count)
{
	const int64_t first = x->firsts[x->rank];
	const int most = LOADED_BYTES / x->row_bytes < (size_t)count ? (int)(LOADED_BYTES / x->row_bytes) + 1 : count;
	int32_t* worlds = malloc(((size_t)most + 1) * sizeof *worlds);
	char* rows = malloc((size_t)most * x->row_bytes + 1);
	int ready = 0;
	if (!worlds || !rows)
		outcome_fail(o, SCREE_ERROR_OUT_OF_MEMORY, "no memory for %d rows of %zu bytes", most, x->row_bytes);
	for (int k = 0; k < count && o->status == SCREE_OK; ++k)
	{
		if (sources[k] != first + k)
		{
			memcpy(rows + (size_t)ready * x->row_bytes, exchange_row(x, sources[k]), x->row_bytes);
			worlds[ready++] = k;
		}
		if (ready == most || (ready > 0 && k == count - 1))
		{
			outcome_scree(o, scree_batch_load(batch, worlds, ready, rows, x->row_bytes));
			ready = 0;
		}
	}
	free(worlds);
	free(rows);
}

static void copy(Outcome* o, MPI_Comm comm, Exchange* x, scree_batch* batch, const int64_t* sources)
{
	const ExchangeNeeds needs = {scree_batch_get_worlds(batch), sources, scree_batch_get_state_bytes(batch),
	                             .leaves_own = true};
	if (!batch || !sources)
		outcome_fail(o, SCREE_ERROR_INVALID, "%s is null", batch ? "sources" : "batch");
	else if (needs.row_bytes > MOST_ROW)
		outcome_fail(o, SCREE_ERROR_INVALID, "the state of a world has %zu bytes, may have %zu", needs.row_bytes,
		             MOST_ROW);
	if (!exchange_begin(o, comm, x, &needs))
		return;
	save(o, batch, x);
	if (exchange_rows(o, comm, x))
		load(o, batch, x, sources, needs.worlds);
	outcome_agree(o, comm);
}

scree_status scree_mpi_copy_worlds(scree_batch* batch, MPI_Comm comm, const int64_t* sources)
{
	Outcome o = outcome_begin("scree_mpi_copy_worlds", comm);
	Exchange x = {0};
	if (o.status == SCREE_OK)
		copy(&o, comm, &x, batch, sources);
	exchange_end(&x);
	return outcome_end(&o);
}
