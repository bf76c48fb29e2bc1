// SPDX-License-Identifier: MIT
// checks.h -- includes cmocka, and declares checks of statuses and numbers.
#ifndef CHECKS_H
#define CHECKS_H
#include "platform/error.h" // included before cmocka, because cmocka defines a macro named fail
#include "scree/scree.h"
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

// Returns true in the presets that run a smaller set of tests.
bool quick(void);
// Skips a long test in quick builds, which search for memory faults and data races. Release builds run the test.
void skip_if_quick(void);

// Fails the test with the message of scree_error unless the call returns SCREE_OK.
#define OK(call) check_ok((call), #call, __FILE__, __LINE__)
void check_ok(scree_status status, const char* call, const char* file, int line);

// Fails unless `value` differs from `expected` by at most `tolerance`; NaN fails.
#define NEAR(value, expected, tolerance) check_near((value), (expected), (tolerance), #value, __FILE__, __LINE__)
void check_near(double value, double expected, double tolerance, const char* what, const char* file, int line);

// Tear-down: checks that all memory of the library is released.
int memory_is_released(void** state);

#endif
