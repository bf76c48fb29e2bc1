// SPDX-License-Identifier: MIT
// byte_hash.c -- computes a hash of bytes, FNV-1a.
#include "tools/common/byte_hash.h"

uint64_t hash_bytes(uint64_t hash, const void* bytes, size_t count)
{
	const unsigned char* byte = bytes;
	for (size_t k = 0; k < count; ++k)
		hash = (hash ^ byte[k]) * 0x100000001b3u;
	return hash;
}
