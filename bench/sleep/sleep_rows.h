// SPDX-License-Identifier: MIT
// sleep_rows.h -- measures a case of scree_sleep and prints its rows.
#ifndef SLEEP_ROWS_H
#define SLEEP_ROWS_H
#include "sleep_run.h"

#define MAX_REPEATS 101

// Prints the heading of the CSV.
void sleep_rows_heading(void);

// Measures a case and prints a row for each of its worlds, as CSV or as a list of names and values. Sets *valid to
// false, after printing a message, if a row is not valid. Returns false if the case could not be measured.
bool sleep_rows_measure(const SleepCase* item, const SleepSetting* setting, bool csv, bool* valid);

#endif
