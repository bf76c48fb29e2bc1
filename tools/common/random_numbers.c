// SPDX-License-Identifier: MIT
// random_numbers.c -- computes random numbers that are the same with every compiler and on every machine.
#include "tools/common/random_numbers.h"

uint64_t random_word(uint64_t* seed)
{
	uint64_t x = *seed += 0x9e3779b97f4a7c15u;
	x = (x ^ x >> 30) * 0xbf58476d1ce4e5b9u;
	x = (x ^ x >> 27) * 0x94d049bb133111ebu;
	return x ^ x >> 31;
}

int random_below(uint64_t* seed, int count) { return (int)(random_word(seed) % (uint64_t)count); }

// Maps the upper 24 bits of a word, which a float represents exactly, to the range from low to high.
static float between(uint64_t word, float low, float high)
{
	return low + (high - low) * ((float)(word >> 40) / 16777216.0f);
}

float random_between(uint64_t* seed, float low, float high) { return between(random_word(seed), low, high); }

double random_real(uint64_t* seed, double low, double high)
{
	return low + (high - low) * (double)(random_word(seed) >> 11) * 0x1p-53;
}

float knuth_between(uint64_t* seed, float low, float high)
{
	*seed = *seed * 6364136223846793005u + 1442695040888963407u;
	return between(*seed, low, high);
}
