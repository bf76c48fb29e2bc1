// SPDX-License-Identifier: MIT
// outcome.h -- results of collective calls: a failure of one rank becomes that of all ranks.
#ifndef OUTCOME_H
#define OUTCOME_H
#include "scree/scree_mpi.h"

#define MOST_WORLDS    16777216          // maximum number of worlds of a batch
#define MOST_ROW       ((size_t)1 << 30) // bytes of a row; a datatype of MPI has a size below 2^31
#define SENTENCE_BYTES 512

typedef struct
{
	const char* function; // name of the public function
	scree_status status;
	char sentence[SENTENCE_BYTES]; // empty if the status is SCREE_OK
} Outcome;

// Begins a public call: checks that MPI is running, and that the communicator is not null.
Outcome outcome_begin(const char* function, MPI_Comm comm);

// Notes a failure with a sentence. Does nothing if one is noted already. Returns false.
bool outcome_fail(Outcome* o, scree_status status, const char* format, ...) __attribute__((format(printf, 3, 4)));

// Notes the failure of a call of Scree with its sentence. Returns whether the call succeeded.
bool outcome_scree(Outcome* o, scree_status status);

// Notes the failure of a call of MPI. call: its name. Returns whether the call succeeded.
bool outcome_mpi(Outcome* o, const char* call, int code);

// Makes the failure of the lowest rank that has one that of all ranks. Collective. Returns whether no rank failed.
bool outcome_agree(Outcome* o, MPI_Comm comm);

// Ends a public call. Returns its status.
scree_status outcome_end(const Outcome* o);

#endif
