// SPDX-License-Identifier: MIT
// clock.h -- the clock of all programs that are not the library itself.
#ifndef CLOCK_H
#define CLOCK_H

// Seconds on a clock that only moves forward.
double seconds_now(void);

#endif
