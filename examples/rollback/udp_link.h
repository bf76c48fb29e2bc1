// SPDX-License-Identifier: MIT
// udp_link.h -- sends packets to one address and receives packets from it, by UDP.
#ifndef UDP_LINK_H
#define UDP_LINK_H
#include <netinet/in.h>
#include <stdbool.h>
#include <stddef.h>

typedef struct
{
	int socket; // -1: closed
	struct sockaddr_in other;
	double strangers; // number of packets from other addresses, which are ignored
} UdpLink;

// Opens a socket of a port, 0 for any free one. Only packets of this machine arrive if local is true. Prints a message and returns
// false on failure.
bool link_open(UdpLink* link, int port, bool local);
// Returns the port of an open socket.
int link_get_port(const UdpLink* link);
// Sets the address of the other peer: an IPv4 address or the name of a machine. Prints a message and returns false if it is unknown.
bool link_set_other(UdpLink* link, const char* host, int port);
void link_close(UdpLink* link);

// Sends a packet. A packet that the system does not take counts as lost on the way.
void link_send(UdpLink* link, const void* bytes, size_t size);
// Receives a packet from the other peer, and returns its size; 0: none has arrived. A larger packet than `room` is cut off.
size_t link_receive(UdpLink* link, void* bytes, size_t room);
// Sleeps until a packet arrives, at most this time, s.
void link_sleep(const UdpLink* link, double seconds);

#endif
