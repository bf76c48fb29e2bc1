// SPDX-License-Identifier: MIT
// processor.h -- returns cores, memory, time and vector instructions of the processor, and sets its floating-point
// mode.
#ifndef PROCESSOR_H
#define PROCESSOR_H
#include <stdbool.h>
#include <stdint.h>

int processor_cores(void);       // number of cores that this process may use, at least 1
uint64_t processor_memory(void); // physical memory, bytes; 0 if unknown

double processor_milliseconds(void); // time by a monotonic clock, ms

// processor_lanes_compiled returns whether this build has kernels for a number of lanes (1, 4, 8 or 16).
// processor_has_lanes returns whether the processor can also run them.
bool processor_lanes_compiled(int lanes);
bool processor_has_lanes(int lanes);
int processor_widest_lanes(void);
const char* processor_instructions(int lanes); // name of the instruction set for a number of lanes: "AVX2"

// The floating-point mode that equal bits require: rounding to nearest, denormals, no traps. Other libraries may have
// set another mode, and a thread inherits the mode of its creator. Therefore a call of the library enters this mode,
// and restores the old mode at its end; threads of threads.h enter it once.
typedef uint64_t FloatMode;
FloatMode float_mode_enter(void);
void float_mode_leave(FloatMode found);

#endif
