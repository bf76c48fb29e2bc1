// SPDX-License-Identifier: MIT
// clean_text.h -- replaces control characters in texts of scene files, before they are printed.
#ifndef CLEAN_TEXT_H
#define CLEAN_TEXT_H
#include "platform/exact_floats.h"

// Replaces each control character of a text in UTF-8 by question marks. A terminal would execute them: a title could move
// the cursor, change the window or hide other output.
void clean_text(char* text);

#endif
