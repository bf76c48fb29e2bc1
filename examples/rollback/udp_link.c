// SPDX-License-Identifier: MIT
// udp_link.c -- sends and receives packets by the sockets of POSIX.
#include "udp_link.h"
#include <arpa/inet.h>
#include <errno.h>
#include <fcntl.h>
#include <netdb.h>
#include <stdio.h>
#include <string.h>
#include <sys/select.h>
#include <sys/socket.h>
#include <unistd.h>

bool link_open(UdpLink* link, int port, bool local)
{
	struct sockaddr_in address = {.sin_family = AF_INET, .sin_port = htons((unsigned short)port)};
	address.sin_addr.s_addr = htonl(local ? INADDR_LOOPBACK : INADDR_ANY);
	*link = (UdpLink){.socket = socket(AF_INET, SOCK_DGRAM, 0)};
	if (link->socket < 0)
		fprintf(stderr, "rollback: a UDP socket cannot be opened: %s\n", strerror(errno));
	else if (link->socket >= FD_SETSIZE || fcntl(link->socket, F_SETFL, O_NONBLOCK) != 0)
		fprintf(stderr, "rollback: socket %d cannot be used\n", link->socket);
	else if (bind(link->socket, (struct sockaddr*)&address, sizeof address) != 0)
		fprintf(stderr, "rollback: UDP port %d cannot be used: %s\n", port, strerror(errno));
	else
		return true;
	link_close(link);
	return false;
}

int link_get_port(const UdpLink* link)
{
	struct sockaddr_in address = {0};
	socklen_t size = sizeof address;
	getsockname(link->socket, (struct sockaddr*)&address, &size);
	return ntohs(address.sin_port);
}

bool link_set_other(UdpLink* link, const char* host, int port)
{
	struct addrinfo hints = {.ai_family = AF_INET, .ai_socktype = SOCK_DGRAM}, *found;
	int failure = getaddrinfo(host, NULL, &hints, &found);
	if (failure)
	{
		fprintf(stderr, "rollback: the address of --host %s is unknown: %s\n", host, gai_strerror(failure));
		return false;
	}
	memcpy(&link->other, found->ai_addr, sizeof link->other);
	link->other.sin_port = htons((unsigned short)port);
	freeaddrinfo(found);
	return true;
}

void link_close(UdpLink* link)
{
	if (link->socket >= 0)
		close(link->socket);
	link->socket = -1;
}

void link_send(UdpLink* link, const void* bytes, size_t size)
{
	// inputs are sent again until they are acknowledged, so that a failure needs no treatment of its own
	(void)!sendto(link->socket, bytes, size, 0, (const struct sockaddr*)&link->other, sizeof link->other);
}

size_t link_receive(UdpLink* link, void* bytes, size_t room)
{
	for (int tries = 0; tries < 1000; ++tries) // a flood of foreign packets must not stop the game
	{
		struct sockaddr_in from = {0};
		socklen_t length = sizeof from;
		ssize_t size = recvfrom(link->socket, bytes, room, 0, (struct sockaddr*)&from, &length);
		if (size < 0 && (errno == EINTR || errno == ECONNREFUSED)) // refused: an earlier packet found no receiver
			continue;
		if (size < 0)
			return 0;
		if (from.sin_addr.s_addr == link->other.sin_addr.s_addr && from.sin_port == link->other.sin_port && size > 0)
			return (size_t)size;
		link->strangers += 1;
	}
	return 0;
}

void link_sleep(const UdpLink* link, double seconds)
{
	fd_set sockets;
	struct timespec limit = {(time_t)seconds, (long)((seconds - (double)(time_t)seconds) * 1e9)};
	FD_ZERO(&sockets);
	FD_SET(link->socket, &sockets);
	if (seconds > 0.0)
		pselect(link->socket + 1, &sockets, NULL, NULL, &limit, NULL);
}
