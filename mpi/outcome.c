// SPDX-License-Identifier: MIT
// outcome.c -- results of collective calls: a failure of one rank becomes that of all ranks.
#include "outcome.h"
#include <stdarg.h>
#include <stdio.h>

Outcome outcome_begin(const char* function, MPI_Comm comm)
{
	Outcome o = {function, SCREE_OK, ""};
	int begun = 0, ended = 0;
	scree_call_begin();
	if (outcome_mpi(&o, "MPI_Initialized", MPI_Initialized(&begun)) && !begun)
		outcome_fail(&o, SCREE_ERROR_INVALID, "MPI_Init has not been called");
	if (begun && outcome_mpi(&o, "MPI_Finalized", MPI_Finalized(&ended)) && ended)
		outcome_fail(&o, SCREE_ERROR_INVALID, "MPI_Finalize has been called");
	if (comm == MPI_COMM_NULL)
		outcome_fail(&o, SCREE_ERROR_INVALID, "comm is MPI_COMM_NULL");
	return o;
}

bool outcome_fail(Outcome* o, scree_status status, const char* format, ...)
{
	if (o->status != SCREE_OK)
		return false;
	o->status = status;
	int length = snprintf(o->sentence, sizeof o->sentence, "%s: ", o->function);
	va_list values;
	va_start(values, format);
	vsnprintf(o->sentence + length, sizeof o->sentence - (size_t)length, format, values);
	va_end(values);
	return false;
}

bool outcome_scree(Outcome* o, scree_status status)
{
	return status == SCREE_OK || outcome_fail(o, status, "%s", scree_error());
}

bool outcome_mpi(Outcome* o, const char* call, int code)
{
	char text[MPI_MAX_ERROR_STRING] = "";
	int length = 0;
	if (code == MPI_SUCCESS)
		return true;
	if (MPI_Error_string(code, text, &length) != MPI_SUCCESS)
		snprintf(text, sizeof text, "error %d", code);
	return outcome_fail(o, SCREE_ERROR_DEVICE_FAILED, "%s failed: %.200s", call, text);
}

bool outcome_agree(Outcome* o, MPI_Comm comm)
{
	int ranks = 0, rank = 0, lowest = 0, status = 0;
	char sentence[SENTENCE_BYTES];
	if (!outcome_mpi(o, "MPI_Comm_size", MPI_Comm_size(comm, &ranks)) ||
	    !outcome_mpi(o, "MPI_Comm_rank", MPI_Comm_rank(comm, &rank)))
		return false;
	int failed = o->status == SCREE_OK ? ranks : rank;
	if (!outcome_mpi(o, "MPI_Allreduce", MPI_Allreduce(&failed, &lowest, 1, MPI_INT, MPI_MIN, comm)))
		return false;
	if (lowest == ranks)
		return true;
	status = (int)o->status;
	snprintf(sentence, sizeof sentence, "%.400s (on rank %d)", o->sentence, lowest);
	if (!outcome_mpi(o, "MPI_Bcast", MPI_Bcast(&status, 1, MPI_INT, lowest, comm)) ||
	    !outcome_mpi(o, "MPI_Bcast", MPI_Bcast(sentence, SENTENCE_BYTES, MPI_CHAR, lowest, comm)))
		return false;
	o->status = (scree_status)status;
	snprintf(o->sentence, sizeof o->sentence, "%s", sentence);
	return false;
}

scree_status outcome_end(const Outcome* o)
{
	return scree_call_end(o->function, o->status, o->status == SCREE_OK ? NULL : o->sentence);
}
