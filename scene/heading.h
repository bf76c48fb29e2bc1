// SPDX-License-Identifier: MIT
// heading.h -- reads the title and the parameters of a scene file without loading the scene.
#ifndef HEADING_H
#define HEADING_H
#include "platform/exact_floats.h"
#include <stdbool.h>
#include <stddef.h>

// Reads the title of a file, and its parameters with their defaults ("rows=100 columns=20"). On failure it returns
// false and writes an error message.
bool scene_heading(const char* path, char* title, size_t title_size, char* parameters, size_t parameters_size,
                   char* sentence);

// Writes the description of a parameter, with its limits. On failure it returns false and writes an error message.
bool scene_parameter_help(const char* path, const char* name, char* help, size_t size, char* sentence);

#endif
