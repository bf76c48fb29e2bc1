// SPDX-License-Identifier: MIT
// clean_text.c -- replaces control characters in texts of scene files, before they are printed.
#include "scene/clean_text.h"

void clean_text(char* text)
{
	for (unsigned char* c = (unsigned char*)text; *c; ++c)
	{
		// U+0080 to U+009F are two bytes
		if (*c == 0xc2 && c[1] >= 0x80 && c[1] <= 0x9f)
			*c = c[1] = '?';
		else if (*c < ' ' || *c == 127)
			*c = '?';
	}
}
