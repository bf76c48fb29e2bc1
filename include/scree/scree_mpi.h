// SPDX-License-Identifier: MIT
// scree_mpi.h -- the library scree_mpi: batches of worlds that are divided among the ranks of MPI.
//
// docs/manual/mpi.md has an introduction. Link scree_mpi, scree and MPI: the target scree::mpi of CMake, or mpicc with
// `pkg-config --libs scree_mpi`.
//
// Each rank has a batch of its own. The worlds of all ranks have global numbers: those of rank 0, in the order of its batch, then
// those of rank 1, and so on. A result that depends only on global numbers is the same for any number of ranks.
//
// Functions fail as those of scree.h do: scree_error() has a sentence, and the hook of scree_fail_hook_set is called. A call that is
// collective is made by all ranks of the communicator, as for collective calls of MPI. If it fails on one rank, it returns the status of
// the lowest rank that failed on all of them, with the sentence of that rank, so that all ranks go on alike. A failure of MPI itself
// is handled by the error handler of the communicator, which ends the program unless it was changed; otherwise the call returns
// SCREE_ERROR_DEVICE_FAILED, and other ranks may wait for ever, because MPI does not say in which state they are.
#ifndef SCREE_MPI_H
#define SCREE_MPI_H
#include "scree/scree.h"
#include <mpi.h>

#ifdef __cplusplus
extern "C" {
#endif

// Divides worlds among the ranks of a communicator: sets *first to the global number of the first world of this rank, and *count
// to the number of its worlds. These are contiguous, in the order of the ranks, and no rank has more than one world more than
// another. worlds: number of all worlds, at least the number of ranks, at most 16,777,216 for each rank. Not collective.
SCREE_API scree_status scree_mpi_share(MPI_Comm comm, int64_t worlds, int64_t* first, int* count);

// Sets *sum to the sum of the hashes of all worlds of all ranks, modulo 2^64; on all ranks. Collective. On failure *sum is 0.
SCREE_API scree_status scree_mpi_hash(scree_batch* batch, MPI_Comm comm, uint64_t* sum);

// Copies rows of worlds between ranks, for instance their parameters: row k of `to` becomes the row of `from` of the world with the
// global number sources[k], 0 to the number of all worlds minus 1. Collective. count: number of the worlds of this rank, and of the
// rows of both arrays, which must not overlap; 0 to 16,777,216. row_bytes: bytes of a row, from 1 to 1 GiB, equal on all ranks. On
// failure the content of `to` is undefined. A row is sent once to each rank that needs it.
SCREE_API scree_status scree_mpi_copy_rows(MPI_Comm comm, int count, const int64_t* sources, size_t row_bytes,
                                           const void* from, void* to);

// Copies states of worlds between ranks, and within them: world k of this rank gets the state of the world with the global number
// sources[k], as it was before the call, with its hash. sources: a number for each world of the batch, 0 to the number of all worlds minus
// 1; a world may be the source of many, and its own. Collective. The template of each world must fit the one of its source, as for
// scree_batch_load. On failure some worlds may have their new state, if sources and memory were not the reason.
SCREE_API scree_status scree_mpi_copy_worlds(scree_batch* batch, MPI_Comm comm, const int64_t* sources);

#ifdef __cplusplus
}
#endif
#endif
