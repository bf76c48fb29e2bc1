// SPDX-License-Identifier: MIT
// decimal.c -- reads and writes numbers with a decimal point, also in a program whose locale has a comma for it.
#include "scene/decimal.h"
#include <locale.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// Replaces the first `from` of a text by `to`, if the text has one; there is room for `to`.
static void replace(char* text, const char* from, const char* to)
{
	char* at = *from ? strstr(text, from) : NULL;
	if (!at || strcmp(from, to) == 0)
		return;
	memmove(at + strlen(to), at + strlen(from), strlen(at + strlen(from)) + 1);
	memcpy(at, to, strlen(to));
}

void decimal_write(double number, int digits, char text[DECIMAL_SIZE])
{
	snprintf(text, DECIMAL_SIZE, "%.*g", digits, number);
	replace(text, localeconv()->decimal_point, ".");
}

bool decimal_read(const char* text, double* number)
{
	char local[DECIMAL_SIZE], *end;
	snprintf(local, sizeof local, "%s", text);
	replace(local, ".", localeconv()->decimal_point);
	*number = strtod(local, &end);
	return end > local && *end == 0;
}
