// SPDX-License-Identifier: MIT
// spaced.c -- writes names as words for figures and panels.
#include "tools/common/spaced.h"
#include <stdio.h>

void spaced(const char* name, char* text, size_t size)
{
	snprintf(text, size, "%s", name);
	for (; *text; ++text)
		*text = *text == '_' ? ' ' : *text;
}
