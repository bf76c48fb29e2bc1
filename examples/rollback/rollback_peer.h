// SPDX-License-Identifier: MIT
// rollback_peer.h -- plays a game as one of two peers: network, pace and session together.
#ifndef ROLLBACK_PEER_H
#define ROLLBACK_PEER_H
#include "rollback_options.h"
#include "rollback_report.h"
#include "udp_link.h"

// Plays the whole game as peer 0 or 1, and fills the report. link: an open socket with the address of the other peer. Prints a message
// and returns false if a device is missing, if the other peer leaves or falls silent, or if a hash differs.
bool peer_run(const RollbackOptions* options, int player, UdpLink* link, Report* report);

#endif
