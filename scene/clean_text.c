// SPDX-License-Identifier: MIT
// clean_text.c -- texts of scene files in UTF-8: replaces control characters before they are printed, and cuts between characters.
#include "scene/clean_text.h"
#include <string.h>

int character_bytes(const char* text)
{
	const unsigned char* c = (const unsigned char*)text;
	int bytes = *c < 0x80                 ? 1
	            : *c >= 0xc2 && *c < 0xe0 ? 2
	            : *c >= 0xe0 && *c < 0xf0 ? 3
	            : *c >= 0xf0 && *c < 0xf5 ? 4
	                                      : 0;
	for (int k = 1; k < bytes; ++k) // the final 0 ends it
		if ((c[k] & 0xc0) != 0x80)
			return 0;
	// longer forms of shorter characters, surrogates of UTF-16, and numbers above 0x10ffff
	bool none = (*c == 0xe0 && c[1] < 0xa0) || (*c == 0xed && c[1] >= 0xa0) || (*c == 0xf0 && c[1] < 0x90) ||
	            (*c == 0xf4 && c[1] >= 0x90);
	return none ? 0 : bytes;
}

static bool is_control(const unsigned char* c) { return *c < ' ' || *c == 127 || (*c == 0xc2 && c[1] <= 0x9f); }

void clean_text(char* text)
{
	for (char* c = text; *c;)
	{
		int bytes = character_bytes(c), step = bytes > 0 ? bytes : 1;
		if (bytes == 0 || is_control((const unsigned char*)c))
			memset(c, '?', (size_t)step);
		c += step;
	}
}

void copy_text(char* to, size_t size, const char* from)
{
	size_t used = 0;
	while (from[used])
	{
		int bytes = character_bytes(from + used);
		size_t next = used + (bytes > 0 ? (size_t)bytes : 1);
		if (next >= size)
			break;
		used = next;
	}
	memcpy(to, from, used);
	to[used] = 0;
}
