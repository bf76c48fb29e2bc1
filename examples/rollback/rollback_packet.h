// SPDX-License-Identifier: MIT
// rollback_packet.h -- writes and reads the packets that peers send each other.
//
// Each packet repeats all inputs and hashes that the other peer has not acknowledged, so that a lost packet needs no answer.
#ifndef ROLLBACK_PACKET_H
#define ROLLBACK_PACKET_H
#include "rollback_session.h"
#include <stddef.h>

#define PACKET_BYTES 1200 // largest packet; networks carry it in one piece

typedef enum
{
	PEER_PLAYS,
	PEER_IS_DONE, // all inputs and hashes of both peers have arrived at the sender
	PEER_LEFT,    // the sender has given up
} PeerPhase;

typedef struct
{
	uint64_t game; // number that both peers derive from the settings of the game
	int sender;    // player
	PeerPhase phase;
	int number;       // packets of the sender so far, to find those that were overtaken
	int frame;        // number of frames that the sender has simulated
	int lead;         // 256ths of a frame by which the sender seems to be ahead
	int known, taken; // numbers of inputs and hashes that the sender has: acknowledgments
	int first_input, input_count;
	int first_hash, hash_count;
	GameInput inputs[WINDOW];
	uint64_t hashes[WINDOW];
} Packet;

// Writes a packet, and returns its number of bytes. bytes: room for PACKET_BYTES.
size_t packet_write(const Packet* packet, uint8_t* bytes);

// Reads a packet. Returns false if the bytes are no packet of this game, or a damaged one.
bool packet_read(Packet* packet, uint64_t game, const uint8_t* bytes, size_t size);

#endif
