// SPDX-License-Identifier: MIT
// csv.h -- rows of CSV files: cut into cells, and texts that fit into one.
#ifndef CSV_H
#define CSV_H
#include "options.h"

#define CSV_LINE  2048 // bytes of the longest line
#define CSV_CELLS 64   // of the longest row

// Cuts a line at its commas and returns how many cells there are; those behind the last are empty.
int csv_cut(char* line, char* cells[CSV_CELLS]);

// A comma, as in a driver's name, must not make a column: it becomes a blank.
void csv_cell(char* text);

// What --set gave, "columns=2 rows=3", as a cell.
void settings_text(const Options* options, char* text, size_t size);

#endif
