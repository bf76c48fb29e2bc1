// SPDX-License-Identifier: MIT
// csv.h -- splits rows of CSV files into cells, and writes texts as cells.
#ifndef CSV_H
#define CSV_H
#include "options.h"

#define CSV_LINE  2048 // bytes of the longest line
#define CSV_CELLS 64   // cells of the longest row

// Splits a line at its commas and returns the number of cells. The remaining entries of cells are empty texts.
int csv_cut(char* line, char* cells[CSV_CELLS]);

// Replaces commas, as in a driver's name, by blanks.
void csv_cell(char* text);

// Writes the settings of --set as a cell: "columns=2 rows=3".
void settings_text(const Options* options, char* text, size_t size);

#endif
