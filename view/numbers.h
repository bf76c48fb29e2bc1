// SPDX-License-Identifier: MIT
// numbers.h -- writes the numbers of a body as lines of text, for the panel.
#ifndef NUMBERS_H
#define NUMBERS_H
#include "view/inspect.h"

#define NUMBER_LINES 20
#define NUMBER_TEXT  96

#ifdef __cplusplus
extern "C" {
#endif

typedef struct
{
	char list[NUMBER_LINES][NUMBER_TEXT];
	int count;
} Numbers;

// Writes the few most important numbers, for the collidable under the cursor.
void numbers_write_short(const Inspected* inspected, Numbers* numbers);

// Writes the name and all numbers. For a destroyed body writes only one line, which reports the destruction.
void numbers_write(const Inspected* inspected, Numbers* numbers);

#ifdef __cplusplus
}
#endif
#endif
