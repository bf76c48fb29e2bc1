// SPDX-License-Identifier: MIT
// bad_network.c -- keeps packets on their way in a list.
#include "bad_network.h"
#include "mix.h"
#include <math.h>
#include <string.h>

void network_send(BadNetwork* network, double now, const void* bytes, size_t size)
{
	bool lost = mix_below(&network->seed, 100) < (uint32_t)network->loss;
	bool reordered = mix_below(&network->seed, 100) < (uint32_t)network->reorder;
	double due = now + network->delay + network->jitter * mix_below(&network->seed, 1000) / 1000.0;
	network->sent += 1;
	network->bytes += (double)size;
	if (lost || size > MOST_BYTES || network->count == MOST_WAITING)
	{
		network->lost += 1;
		return;
	}
	if (reordered)
		due += network->overtaken;
	else
		network->last_due = due = fmax(due, network->last_due);
	WaitingPacket* packet = &network->waiting[network->count++];
	packet->due = due;
	packet->size = size;
	memcpy(packet->bytes, bytes, size);
}

double network_release(BadNetwork* network, double now)
{
	double next = INFINITY;
	int kept = 0;
	for (int k = 0; k < network->count; ++k)
	{
		WaitingPacket* packet = &network->waiting[k];
		if (packet->due <= now)
		{
			link_send(network->link, packet->bytes, packet->size);
			continue;
		}
		next = fmin(next, packet->due);
		if (kept != k)
			network->waiting[kept] = *packet;
		++kept;
	}
	network->count = kept;
	return next;
}
