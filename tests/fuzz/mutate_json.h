// SPDX-License-Identifier: MIT
// mutate_json.h -- changes a scene file at random, and keeps it JSON with keys of the format.
#ifndef MUTATE_JSON_H
#define MUTATE_JSON_H
#include <stddef.h>
#include <stdint.h>

// Changes a text in place, to at most `most` bytes, and returns its new size: values, members and elements are replaced,
// added, removed or copied. Returns 0 if the text is no JSON, or has no room.
size_t mutate_json(uint8_t* text, size_t size, size_t most, uint64_t seed);

#endif
