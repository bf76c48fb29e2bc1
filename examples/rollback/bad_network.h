// SPDX-License-Identifier: MIT
// bad_network.h -- delays, loses and reorders packets before they are sent, as a slow network does.
#ifndef BAD_NETWORK_H
#define BAD_NETWORK_H
#include "udp_link.h"
#include <stdint.h>

#define MOST_WAITING \
	512 // packets on their way: more than the longest delay and jitter hold, 2.5 s at 60 packets a second
#define MOST_BYTES 1200

typedef struct
{
	double due; // s
	size_t size;
	uint8_t bytes[MOST_BYTES];
} WaitingPacket;

typedef struct
{
	UdpLink* link;
	uint64_t seed;
	double delay, jitter; // s: each packet takes the delay and a random part of the jitter
	double overtaken;     // s: a reordered packet takes this much longer
	int loss, reorder;    // percent of packets
	double last_due;      // s: other packets arrive in order
	double sent, lost;    // numbers of packets
	double bytes;         // without headers of IP and UDP
	int count;            // packets on their way
	WaitingPacket waiting[MOST_WAITING];
} BadNetwork;

// Sends a packet at time `now`, s.
void network_send(BadNetwork* network, double now, const void* bytes, size_t size);
// Hands packets that are due at time `now` to the link. Returns the time at which the next one is due; infinite: none.
double network_release(BadNetwork* network, double now);

#endif
