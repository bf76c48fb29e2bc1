// SPDX-License-Identifier: MIT
// random_numbers.h -- random numbers that are the same for every compiler and machine.
//
// This work is based on:
// Guy Steele, Doug Lea, Christine Flood, Fast Splittable Pseudorandom Number Generators, 2014 (splitmix64).
// Donald Knuth, MMIX, 1999 (the multiplier of knuth_between).
//
// The values decide which programs and worlds tests and experiments make, so a change of them changes all of these.
#ifndef RANDOM_NUMBERS_H
#define RANDOM_NUMBERS_H
#include <stdint.h>

// Each call changes the seed, which may begin with any value.
uint64_t random_word(uint64_t* seed);
int random_below(uint64_t* seed, int count);                 // from 0 to count - 1
float random_between(uint64_t* seed, float low, float high); // in steps of 2^-24 of the range
double random_real(uint64_t* seed, double low, double high); // in steps of 2^-53 of the range

// Another generator, for the benchmarks of queries only: hits and hashes in docs/queries.md are those of its rays.
float knuth_between(uint64_t* seed, float low, float high);

#endif
