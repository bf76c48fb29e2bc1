// SPDX-License-Identifier: MIT
// row_exchange.h -- exchanges rows between ranks: each rank gets the rows of the worlds that it needs, each once.
#ifndef ROW_EXCHANGE_H
#define ROW_EXCHANGE_H
#include "outcome.h"

typedef struct
{
	int ranks, rank;
	size_t row_bytes; // size of a row on all ranks
	int64_t* firsts;  // for each rank and one more: global number of its first world
	int*
	    counts; // four arrays with an entry for each rank: rows that come, where they begin; rows that go, where they begin
	int64_t* needed; // global numbers of the rows that come, ascending, each once
	int64_t* sent;   // global numbers of the rows that go, those for rank 0 first
	int coming, going;
	char *came, *goes; // rows
} Exchange;

typedef struct // needs of a rank
{
	int worlds;             // number of the worlds of this rank
	const int64_t* sources; // for each of them: global number of the world whose row it gets
	size_t row_bytes;
	bool equal_rows; // true: rows of all ranks have one size; false: all get the size of the largest
	bool leaves_own; // true: a world that is its own source needs no row
} ExchangeNeeds;

// Shares what all ranks need. Afterwards the caller writes the rows of x->sent to x->goes. Collective. Returns whether no rank
// failed. The caller ends the exchange also on failure.
bool exchange_begin(Outcome* o, MPI_Comm comm, Exchange* x, const ExchangeNeeds* needs);

// Sends the rows, unless the outcome of a rank is a failure. Collective. Returns whether no rank failed.
bool exchange_rows(Outcome* o, MPI_Comm comm, Exchange* x);

// Returns the row that came from the world with a global number.
const char* exchange_row(const Exchange* x, int64_t source);

// Returns the index within this rank of row k of those that go.
int exchange_sent(const Exchange* x, int k);

void exchange_end(Exchange* x);

#endif
