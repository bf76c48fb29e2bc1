// SPDX-License-Identifier: MIT
// file_bytes.h -- reads and writes whole files, with error messages of the command line.
#ifndef FILE_BYTES_H
#define FILE_BYTES_H
#include "options.h"
#include "tools/common/whole_file.h"

// Reads a file. The caller frees its bytes. On failure it prints an error message. Returns an exit code.
int file_read(const Options* options, const char* path, FileBytes* file);

// Writes a file. On failure it prints an error message. Returns an exit code.
int file_write(const Options* options, const char* path, const void* bytes, size_t size);

#endif
