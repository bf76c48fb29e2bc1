// SPDX-License-Identifier: MIT
// copy_rows.c -- copies rows of a program between ranks.
#include "row_exchange.h"
#include <string.h>

static bool check(Outcome* o, const ExchangeNeeds* needs, const void* from, const void* to)
{
	if (needs->worlds < 0 || needs->worlds > MOST_WORLDS)
		return outcome_fail(o, SCREE_ERROR_INVALID, "count is %d, must be from 0 to %d", needs->worlds, MOST_WORLDS);
	if (needs->row_bytes < 1 || needs->row_bytes > MOST_ROW)
		return outcome_fail(o, SCREE_ERROR_INVALID, "row_bytes is %zu, must be from 1 to %zu", needs->row_bytes,
		                    MOST_ROW);
	if (needs->worlds > 0 && (!needs->sources || !from || !to))
		return outcome_fail(o, SCREE_ERROR_INVALID, "%s is null", !needs->sources ? "sources" : !from ? "from" : "to");
	return true;
}

static void copy(Outcome* o, MPI_Comm comm, Exchange* x, const ExchangeNeeds* needs, const char* from, char* to)
{
	check(o, needs, from, to);
	if (!exchange_begin(o, comm, x, needs))
		return;
	for (int k = 0; k < x->going; ++k)
		memcpy(x->goes + (size_t)k * x->row_bytes, from + (size_t)exchange_sent(x, k) * x->row_bytes, x->row_bytes);
	if (!exchange_rows(o, comm, x))
		return;
	for (int k = 0; k < needs->worlds; ++k)
		memcpy(to + (size_t)k * x->row_bytes, exchange_row(x, needs->sources[k]), x->row_bytes);
}

scree_status scree_mpi_copy_rows(MPI_Comm comm, int count, const int64_t* sources, size_t row_bytes, const void* from,
                                 void* to)
{
	Outcome o = outcome_begin("scree_mpi_copy_rows", comm);
	Exchange x = {0};
	const ExchangeNeeds needs = {count, sources, row_bytes, .equal_rows = true};
	if (o.status == SCREE_OK)
		copy(&o, comm, &x, &needs, from, to);
	exchange_end(&x);
	return outcome_end(&o);
}
