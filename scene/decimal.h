// SPDX-License-Identifier: MIT
// decimal.h -- reads and writes numbers with a decimal point, also in a program whose locale has a comma for it.
#ifndef DECIMAL_H
#define DECIMAL_H
#include "platform/exact_floats.h"
#include <stdbool.h>

#define DECIMAL_SIZE 80 // characters of a number

// Writes a number with this many significant digits.
void decimal_write(double number, int digits, char text[DECIMAL_SIZE]);

// Reads a text of less than DECIMAL_SIZE - 16 characters. Returns false if the text is not a number.
bool decimal_read(const char* text, double* number);

#endif
