// SPDX-License-Identifier: MIT
// known.h -- hashes that an earlier bench left, which must come out again.
#ifndef KNOWN_H
#define KNOWN_H
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

// Reads the columns scene, settings, steps and hash of a CSV file, such as bench prints. Null: no file, nothing is
// known. Returns an exit code, after printing what is wrong.
int known_open(const char* path, Known* known);
void known_close(Known* known);

// The hash of a scene with these settings after so many steps. Returns false when it is not known.
bool known_find(const Known* known, const char* scene, const char* settings, int steps, uint64_t* hash);

#endif
