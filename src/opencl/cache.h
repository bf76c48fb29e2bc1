// SPDX-License-Identifier: MIT
// cache.h -- compiled programs on disk.
//
// The folder is $SCREE_CACHE (no cache if it is empty), else $XDG_CACHE_HOME/scree, else ~/.cache/scree. The cache is
// optional: a program that cannot be read or written is compiled again.
#ifndef OPENCL_CACHE_H
#define OPENCL_CACHE_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct // 128 bits; not cryptographic
{
	uint64_t a, b;
} Digest;

Digest digest_begin(void);
void digest_add(Digest* digest, const void* bytes, size_t count);

// Returns the bytes of a key, from scree_allocate, or null. A damaged file counts as missing.
unsigned char* cache_read(Digest key, size_t* count);
void cache_write(Digest key, const unsigned char* bytes, size_t count);

#endif
