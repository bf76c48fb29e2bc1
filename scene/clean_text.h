// SPDX-License-Identifier: MIT
// clean_text.h -- texts of scene files in UTF-8: replaces control characters before they are printed, and cuts between characters.
#ifndef CLEAN_TEXT_H
#define CLEAN_TEXT_H
#include "platform/exact_floats.h"
#include <stdbool.h>
#include <stddef.h>

// Returns the number of bytes of the character at the beginning of a text, 1 to 4; 0 if the bytes are no character of UTF-8
// (RFC 3629). JSON consists of characters, so the reader refuses a file with other bytes.
int character_bytes(const char* text);

// Replaces each control character of a text, and each byte that is no part of a character, by question marks. A terminal would
// execute control characters: a title could move the cursor, change the window or hide other output.
void clean_text(char* text);

// Copies the characters of a text that fit into `size` bytes with a final 0; size: at least 1.
void copy_text(char* to, size_t size, const char* from);

#endif
