// SPDX-License-Identifier: MIT
// text.c -- a JSON text in memory that grows: objects, lists, strings, and numbers that read back to the same bits.
#include "scene/text.h"
#include "scene/decimal.h"
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void add_bytes(Text* text, const char* bytes, size_t count)
{
	if (text->used + count + 1 > text->capacity)
	{
		size_t capacity = 2 * (text->used + count + 1) + 4096;
		char* larger = realloc(text->bytes, capacity);
		if (!larger)
		{
			text->short_of_memory = true;
			return;
		}
		text->bytes = larger;
		text->capacity = capacity;
	}
	memcpy(text->bytes + text->used, bytes, count);
	text->used += count;
	text->bytes[text->used] = 0;
}

void text_add(Text* text, const char* characters) { add_bytes(text, characters, strlen(characters)); }

void text_comma(Text* text)
{
	char last = text->used > 0 ? text->bytes[text->used - 1] : '{';
	if (last != '{' && last != '[' && last != '\t')
		text_add(text, ", ");
}

void text_key(Text* text, const char* key)
{
	text_comma(text);
	text_string(text, key);
	text_add(text, ": ");
}

void text_string(Text* text, const char* string)
{
	text_add(text, "\"");
	for (const char* c = string; *c; ++c)
	{
		char escaped[8];
		if (*c == '"' || *c == '\\')
			snprintf(escaped, sizeof escaped, "\\%c", *c);
		else if ((unsigned char)*c < ' ')
			snprintf(escaped, sizeof escaped, "\\u%04x", (unsigned)*c);
		else
			snprintf(escaped, sizeof escaped, "%c", *c);
		text_add(text, escaped);
	}
	text_add(text, "\"");
}

void text_whole(Text* text, int64_t number)
{
	char digits[24];
	snprintf(digits, sizeof digits, "%" PRId64, number);
	text_add(text, digits);
}

void text_float(Text* text, float number, double most)
{
	char digits[DECIMAL_SIZE];
	double read = 0.0;
	int count = 6;
	do
	{
		decimal_write((double)number, count, digits);
		decimal_read(digits, &read);
	} while (++count <= 9 && (float)read != number);
	if (fabs(read) > most)
		decimal_write((double)number, 17, digits);
	// without a point, the sign of a zero would be lost, because -0 is read as a whole number
	text_add(text, strcmp(digits, "-0") == 0 ? "-0.0" : digits);
}

void text_pair(Text* text, float x, float y, double most)
{
	text_add(text, "[");
	text_float(text, x, most);
	text_add(text, ", ");
	text_float(text, y, most);
	text_add(text, "]");
}

void text_free(Text* text)
{
	free(text->bytes);
	*text = (Text){0};
}
