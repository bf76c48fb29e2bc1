// SPDX-License-Identifier: MIT
// cache.h -- stores compiled programs on disk; a program that cannot be read or written is compiled again. The folder
// is the first that is set: $SCREE_CACHE (empty: no cache), $XDG_CACHE_HOME/scree, ~/.cache/scree (on Windows
// %LOCALAPPDATA%/scree).
#ifndef OPENCL_CACHE_H
#define OPENCL_CACHE_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct // 128 bits; not secure against attacks
{
	uint64_t a, b;
} Digest;

Digest digest_begin(void);
void digest_add(Digest* digest, const void* bytes, size_t count);

// Returns the bytes stored for a key, allocated with scree_allocate, or null. A damaged file counts as missing.
unsigned char* cache_read(Digest key, size_t* count);
void cache_write(Digest key, const unsigned char* bytes, size_t count);

#endif
