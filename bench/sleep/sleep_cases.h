// SPDX-License-Identifier: MIT
// sleep_cases.h -- lists the cases of scree_sleep.
#ifndef SLEEP_CASES_H
#define SLEEP_CASES_H
#include "sleep_run.h"

extern const SleepCase sleep_cases[];
extern const int sleep_case_count;

// Returns the case of this name, or null.
const SleepCase* sleep_case_find(const char* name);

#endif
