// SPDX-License-Identifier: MIT
// write_bodies.h -- writes the attributes, bodies and collidables of a world as those of a scene file.
#ifndef WRITE_BODIES_H
#define WRITE_BODIES_H
#include "scene/contents.h"

bool write_attributes(Contents* contents, Writer* writer);
bool write_bodies(Contents* contents, Writer* writer);
bool write_free_collidables(Contents* contents, Writer* writer);

// Begins a member of the scene that is an object or a list, with one entry per line.
void write_begin(Writer* writer, const char* key, const char* bracket);
// Begins a line for its next entry.
void write_next(Writer* writer);
void write_end(Writer* writer, const char* bracket);

#endif
