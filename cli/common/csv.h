// SPDX-License-Identifier: MIT
// csv.h -- splits rows of CSV files into cells, and writes texts as cells.
#ifndef CSV_H
#define CSV_H
#include "options.h"

#define CSV_LINE  2048 // maximum number of bytes of a line
#define CSV_CELLS 64   // maximum number of cells of a row

// Splits a line at its commas, in place, and returns the number of cells. The remaining entries of cells become empty
// texts.
int csv_cut(char* line, char* cells[CSV_CELLS]);

// Replaces commas, such as those in the name of a driver, by blanks.
void csv_cell(char* text);

// Writes the settings given with --set to `text`, as a cell of a CSV file: "columns=2 rows=3".
void settings_text(const Options* options, char* text, size_t size);

#endif
