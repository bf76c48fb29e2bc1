// SPDX-License-Identifier: MIT
// text.h -- a JSON text in memory that grows: objects, lists, strings, and numbers that read back to the same bits.
#ifndef TEXT_H
#define TEXT_H
#include "platform/exact_floats.h"
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct // all zeros: an empty text
{
	char* bytes; // ends with 0
	size_t used, capacity;
	bool short_of_memory; // true: a part is missing
} Text;

// Adds characters as they are.
void text_add(Text* text, const char* characters);

// Adds a comma and a space, unless the text ends with the beginning of an object or a list.
void text_comma(Text* text);

// Adds a comma if needed, the key of a member, and a colon.
void text_key(Text* text, const char* key);

// Adds a string in quotes.
void text_string(Text* text, const char* string);

// Adds a whole number.
void text_whole(Text* text, int64_t number);

// Adds a float with as few digits as give its bits. most: largest number that a reader accepts; a rounded number is not above it.
void text_float(Text* text, float number, double most);

// Adds a list of two floats, each at most `most`.
void text_pair(Text* text, float x, float y, double most);

void text_free(Text* text);

#endif
