// SPDX-License-Identifier: MIT
// experiment_support.c -- ends an experiment when memory is short.
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
