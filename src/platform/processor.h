// SPDX-License-Identifier: MIT
// processor.h -- cores, memory, clock and vector instructions of the processor, and its floating-point mode.
#ifndef PROCESSOR_H
#define PROCESSOR_H
#include <stdbool.h>
#include <stdint.h>

int processor_cores(void);       // that this process may use, at least 1
uint64_t processor_memory(void); // physical, bytes; 0 when unknown

double processor_milliseconds(void); // ms of a monotonic clock

// Whether this build has stages with so many lanes, 1, 4, 8 or 16, and whether the processor runs them.
bool processor_lanes_compiled(int lanes);
bool processor_has_lanes(int lanes);
int processor_widest_lanes(void);
const char* processor_instructions(int lanes); // "AVX2", the set that these lanes use

// Scree needs rounding to nearest, denormals and no traps for equal bits. Other libraries of the process may have set another
// mode, and a thread inherits the mode of its creator. So a call enters the mode before it computes, and restores the old one
// afterwards; the threads of threads.h enter it once.
typedef uint64_t FloatMode;
FloatMode float_mode_enter(void);
void float_mode_leave(FloatMode found);

#endif
