// SPDX-License-Identifier: MIT
// library_error.h -- prints error messages of the library on the command line.
#ifndef LIBRARY_ERROR_H
#define LIBRARY_ERROR_H
#include "options.h"

// Prints scree_error() if the status is not SCREE_OK. Returns the exit code of the status.
int report(scree_status status);
// Likewise for a call that reads the content of a file, whose path is printed before the sentence.
int report_file(const char* path, scree_status status);

#endif
