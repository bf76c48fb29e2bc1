// SPDX-License-Identifier: MIT
// processor.h -- returns cores, memory, time and vector instructions of the processor; sets its floating-point mode.
#ifndef PROCESSOR_H
#define PROCESSOR_H
#include "platform/exact_floats.h"
#include <stdbool.h>
#include <stdint.h>

int processor_cores(void);       // number of cores that this process may use, at least 1
uint64_t processor_memory(void); // physical memory, bytes; 0 if unknown

double processor_milliseconds(void);       // time by a monotonic clock, ms
void processor_sleep(double milliseconds); // suspends the thread for about this time

bool processor_lanes_compiled(int lanes); // true: this build has kernels for a number of lanes: 1, 4, 8 or 16
bool processor_has_lanes(int lanes);      // true: this build has these kernels, and the processor can run them
int processor_widest_lanes(void);
const char* processor_instructions(int lanes); // name of the instruction set for a number of lanes, such as "AVX2"

// The floating-point mode that equal bits require: rounding to nearest, denormals, no traps. Other libraries may set
// another mode, and a thread inherits the mode of its creator. So each public function that has a status or calls a
// driver enters this mode, and restores the old mode at its end; threads of threads.h enter it once.
typedef uint64_t FloatMode;
FloatMode float_mode_enter(void);
void float_mode_leave(FloatMode found);
void float_mode_end(const FloatMode* found);

// Enters the mode until the end of the block. WebAssembly has one mode.
#ifdef __wasm__
#define FLOAT_MODE_HERE
#else
#define FLOAT_MODE_HERE \
	__attribute__((cleanup(float_mode_end), unused)) const FloatMode float_mode_here = float_mode_enter()
#endif

// Sets the mode in which denormals are flushed to 0, if the processor has it; for tests. float_mode_leave ends it.
void float_mode_flush(void);

#endif
