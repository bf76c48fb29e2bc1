// SPDX-License-Identifier: MIT
// known_hashes.h -- the hashes of an earlier bench, with which those of a new one must agree.
#ifndef KNOWN_HASHES_H
#define KNOWN_HASHES_H
#include "options.h"

typedef struct
{
	char scene[64], settings[256];
	int steps;
	uint64_t hash;
} KnownRow;

typedef struct
{
	KnownRow* rows;
	int count;
} Known;

// Reads the columns scene, settings, steps and hash of a CSV file of bench. A null path reads nothing. Prints a
// sentence on failure. Returns an exit code.
int known_open(const char* path, Known* known);
void known_close(Known* known);

// Finds the hash of a scene with these settings after this many steps. Returns false if there is none.
bool known_find(const Known* known, const char* scene, const char* settings, int steps, uint64_t* hash);

#endif
