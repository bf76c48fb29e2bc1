// SPDX-License-Identifier: MIT
// byte_hash.c -- computes a hash of bytes, FNV-1a.
#include "tools/common/byte_hash.h"
#include <string.h>

uint64_t hash_bytes(uint64_t hash, const void* bytes, size_t count)
{
	const unsigned char* byte = bytes;
	for (size_t k = 0; k < count; ++k)
		hash = (hash ^ byte[k]) * 0x100000001b3u;
	return hash;
}

uint64_t hash_words(uint64_t hash, const void* words, size_t count)
{
	for (size_t k = 0; k < count; k += 4)
	{
		uint32_t word;
		memcpy(&word, (const char*)words + k, sizeof word);
		unsigned char bytes[] = {word & 255, word >> 8 & 255, word >> 16 & 255, word >> 24};
		hash = hash_bytes(hash, bytes, sizeof bytes);
	}
	return hash;
}
