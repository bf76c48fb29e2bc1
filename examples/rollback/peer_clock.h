// SPDX-License-Identifier: MIT
// peer_clock.h -- reads a clock that is never set back.
#ifndef PEER_CLOCK_H
#define PEER_CLOCK_H

// Returns seconds since some time in the past.
double clock_real(void);

#endif
