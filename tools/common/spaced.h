// SPDX-License-Identifier: MIT
// spaced.h -- writes names as words for figures and panels.
#ifndef SPACED_H
#define SPACED_H
#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

// Copies at most size - 1 characters of a name, with a space for each underscore: "to_device" becomes "to device".
void spaced(const char* name, char* text, size_t size);

#ifdef __cplusplus
}
#endif
#endif
