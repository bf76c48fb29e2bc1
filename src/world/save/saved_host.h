// SPDX-License-Identifier: MIT
// saved_host.h -- copies the data of a world on the host to saves and back, as plain memory of this process.
#ifndef SAVED_HOST_H
#define SAVED_HOST_H
#include "world/world.h"

// Copy the structure, or the data that steps change, into `writer`, which has memory of earlier copies.
scree_status saved_structure_write(scree_world* world, const char* function, ChunkWriter* writer);
scree_status saved_step_write(scree_world* world, const char* function, ChunkWriter* writer);

typedef struct // a load in progress
{
	const char* function;
	scree_world* world;
	const ChunkWriter *structure, *step;
	bool same;            // the structure of the world is that of the save
	PathSample** samples; // samples of the paths of the save
	int paths;            // number of entries of `samples`
	int* table;           // hash table of the attributes of the save
	int table_size;
	const uint8_t* arrays; // arrays of the structure of the save
} HostLoad;

// Reserves all memory. Changes nothing else; on failure too, saved_host_close must follow.
scree_status saved_host_reserve(HostLoad* load);
// Copies the data back. Cannot fail.
void saved_host_read(HostLoad* load);
void saved_host_close(HostLoad* load);

#endif
