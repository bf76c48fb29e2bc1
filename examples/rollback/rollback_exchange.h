// SPDX-License-Identifier: MIT
// rollback_exchange.h -- the state of a peer, and its packets.
#ifndef ROLLBACK_EXCHANGE_H
#define ROLLBACK_EXCHANGE_H
#include "bad_network.h"
#include "rollback_options.h"
#include "rollback_packet.h"

#define HEADER_BYTES 28 // headers of UDP and IP, for each packet

typedef struct // everything of a peer
{
	const RollbackOptions* options;
	uint64_t game_number;
	UdpLink* link;
	BadNetwork network;
	Session session;
	uint64_t script;               // seed of the inputs
	GameInput held;                // input that the script holds
	int held_frames;               // frames for which it still does
	double start;                  // s, real time: zero of peer_time
	double begun, next;            // s, peer_time: start of the game, next frame
	double last_packet, done;      // s, real time: the last packet that arrived, the end of the game for this peer
	double lead, ahead, ahead_sum; // frames: seeming lead, true lead, sum over all frames
	bool met;                      // a packet has arrived
	PeerPhase phase, other_phase;
	int number, last_number; // numbers of the last packets sent and received
	int known, taken;        // numbers of inputs and hashes that the other peer has
	int logged;              // frame of the next line of the log
	double received, overtaken, damaged, ticks;
} Peer;

// Returns the time in s of the game, of which options->speed pass in a second.
double peer_time(const Peer* peer);

// Sends a packet with all that the other peer may lack.
void peer_send(Peer* peer);

// Sends packets that are due, sleeps until the next frame or packet, takes all packets that have arrived, and compares hashes.
void peer_exchange(Peer* peer);

#endif
