// SPDX-License-Identifier: MIT
// byte_hash.h -- computes a hash of bytes, FNV-1a (Glenn Fowler, Landon Curt Noll, Kiem-Phong Vo, 1991).
#ifndef BYTE_HASH_H
#define BYTE_HASH_H
#include <stddef.h>
#include <stdint.h>

#define HASH_BEGIN 0xcbf29ce484222325u

// Returns the hash of all bytes so far. hash: value returned for the bytes before these, or HASH_BEGIN.
uint64_t hash_bytes(uint64_t hash, const void* bytes, size_t count);

// Returns the hash of numbers of 32 bits, the same for both orders of their bytes. count: number of bytes, a
// multiple of 4.
uint64_t hash_words(uint64_t hash, const void* words, size_t count);

#endif
