// SPDX-License-Identifier: MIT
// experiment_support.c -- memory for experiments.
#include "experiment_support.h"
#include <stdio.h>
#include <stdlib.h>

void* require_memory(void* memory)
{
	if (memory)
		return memory;
	fprintf(stderr, "scree validate: out of memory\n");
	exit(1);
}
