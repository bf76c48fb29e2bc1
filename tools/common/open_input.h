// SPDX-License-Identifier: MIT
// open_input.h -- opens files to read.
#ifndef OPEN_INPUT_H
#define OPEN_INPUT_H
#include <stdio.h>

// Opens a text file to read. Returns null and sets errno on failure, also if the path is that of a folder, which fopen
// opens on some systems.
FILE* open_input(const char* path);

#endif
