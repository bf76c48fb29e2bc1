// SPDX-License-Identifier: MIT
// header_text.c -- reads the public header as text, for tests that compare lists with it.
#include "support/header_text.h"
#include "support/checks.h"
#include <stdio.h>
#include <stdlib.h>

char* read_header(void)
{
	char path[4096];
	snprintf(path, sizeof path, "%s/include/scree/scree.h", getenv("SCREE_SOURCE"));
	FILE* file = fopen(path, "rb");
	assert_non_null(file);
	char* text = calloc(1, 1 << 20);
	assert_true(fread(text, 1, (1 << 20) - 1, file) > 100000);
	fclose(file);
	return text;
}
