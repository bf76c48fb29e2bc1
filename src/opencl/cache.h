// SPDX-License-Identifier: MIT
// cache.h -- built programs kept on disk from one process to the next.
//
// They lie in $SCREE_CACHE (nowhere when that is empty), else $XDG_CACHE_HOME/scree, else ~/.cache/scree. The cache is
// never needed: what cannot be read or written is built again.
#ifndef OPENCL_CACHE_H
#define OPENCL_CACHE_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct // 128 bits that tell apart, not secure
{
	uint64_t a, b;
} Digest;

Digest digest_begin(void);
void digest_add(Digest* digest, const void* bytes, size_t count);

// The bytes kept under a key, from scree_allocate, or null. A damaged file counts as none.
unsigned char* cache_read(Digest key, size_t* count);
void cache_write(Digest key, const unsigned char* bytes, size_t count);

#endif
