// SPDX-License-Identifier: MIT
// clock.h -- reads a clock, for all programs except the library.
#ifndef CLOCK_H
#define CLOCK_H

// Returns the seconds of a clock that is never set back.
double seconds_now(void);

#endif
