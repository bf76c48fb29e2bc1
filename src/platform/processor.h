// SPDX-License-Identifier: MIT
// processor.h -- what there is to know about the processor, and the rounding mode of its floats.
#ifndef PROCESSOR_H
#define PROCESSOR_H
#include <stdbool.h>
#include <stdint.h>

int processor_cores(void);       // that this process may use, at least 1
uint64_t processor_memory(void); // physical, bytes; 0 when unknown

double processor_milliseconds(void); // of a clock that only goes forward

// Whether the processor runs the stages compiled for so many lanes.
bool processor_has_lanes(int lanes);
int processor_widest_lanes(void);
const char* processor_instructions(int lanes); // "AVX2", the set that these lanes use

// Scree's bits are those of rounding to nearest with denormals kept and no traps. Other libraries of the process may have
// set this thread's mode, and a thread starts with its maker's: every worker enters the mode before it computes, and
// gives back what it found.
typedef uint64_t FloatMode;
FloatMode float_mode_enter(void);
void float_mode_leave(FloatMode found);

#endif
