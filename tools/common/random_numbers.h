// SPDX-License-Identifier: MIT
// random_numbers.h -- computes random numbers that are the same with every compiler and on every machine.
//
// This work is based on:
// Guy Steele, Doug Lea, Christine Flood, Fast Splittable Pseudorandom Number Generators, 2014 (splitmix64).
// Donald Knuth, MMIX, 1999 (the multiplier of knuth_between).
//
// Tests and experiments make programs and worlds from these numbers. A change of the numbers would change all of them.
#ifndef RANDOM_NUMBERS_H
#define RANDOM_NUMBERS_H
#include <stdint.h>

// These return a random number and change the seed, which may begin with any value.
uint64_t random_word(uint64_t* seed);
int random_below(uint64_t* seed, int count);                 // from 0 to count - 1
float random_between(uint64_t* seed, float low, float high); // low + (high - low) n / 2^24, with a whole number n
double random_real(uint64_t* seed, double low, double high); // low + (high - low) n / 2^53, with a whole number n

// Returns a number of another generator, only for benchmarks of queries: hits and hashes in docs/measurements/queries.md depend
// on this generator.
float knuth_between(uint64_t* seed, float low, float high);

#endif
