// SPDX-License-Identifier: MIT
// processor.h -- cores, memory, clock and vector instructions of the processor, and its floating-point mode.
#ifndef PROCESSOR_H
#define PROCESSOR_H
#include <stdbool.h>
#include <stdint.h>

int processor_cores(void);       // cores that this process may use, at least 1
uint64_t processor_memory(void); // physical memory, bytes; 0 if unknown

double processor_milliseconds(void); // time of a monotonic clock, ms

// Checks whether this build has stages for a lane count (1, 4, 8 or 16), and whether the processor can also run them.
bool processor_lanes_compiled(int lanes);
bool processor_has_lanes(int lanes);
int processor_widest_lanes(void);
const char* processor_instructions(int lanes); // name of the instruction set for a lane count: "AVX2"

// Mode of equal bits: rounding to nearest, denormals, no traps. Other libraries may have set another one, and a thread
// inherits that of its creator. So a call enters the mode and restores the old one; threads of threads.h enter it once.
typedef uint64_t FloatMode;
FloatMode float_mode_enter(void);
void float_mode_leave(FloatMode found);

#endif
