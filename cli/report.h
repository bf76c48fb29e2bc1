// SPDX-License-Identifier: MIT
// report.h -- errors of the library on the command line.
#ifndef REPORT_H
#define REPORT_H
#include "options.h"

// Prints scree_error() if the status is not SCREE_OK. Returns the exit code of the status.
int report(scree_status status);

#endif
