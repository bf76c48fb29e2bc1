// SPDX-License-Identifier: MIT
// recording_file.h -- checks whether a file is a recording.
#ifndef RECORDING_FILE_H
#define RECORDING_FILE_H
#include <stdbool.h>

// Returns true if the name of a file ends in .rec, or if the file begins as a recording does (docs/design/recording.md).
bool recording_file(const char* path);

#endif
