// SPDX-License-Identifier: MIT
// known_hashes.h -- reads the hashes of an earlier bench, with which the hashes of a new bench must agree.
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

// Reads the columns scene, settings, steps and hash of a CSV file of bench. If path is null, there are no known hashes.
// On failure the function prints an error message. Returns an exit code.
int known_open(const char* path, Known* known);
void known_close(Known* known);

// Returns false and prints an error message if the file `path` has another hash of a scene with these settings after this
// number of steps.
bool known_agrees(const Known* known, const char* path, const char* scene, const char* settings, int steps,
                  uint64_t hash);

#endif
