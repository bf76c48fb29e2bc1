// SPDX-License-Identifier: MIT
// rollback_exchange.c -- sends and takes packets, and measures which peer is ahead.
//
// The pace. Both peers should simulate the same frame at the same time, otherwise one of them predicts for both. Each measures by how
// many frames it seems to lead: its own frame less that in the packet that arrives. This is the true lead plus the time on the way.
// Each packet has the sender's number, so half of the difference of both numbers is the true lead, if both ways take the same time.
// The peer in front makes its frames longer.
#include "rollback_exchange.h"
#include "peer_clock.h"
#include <math.h>

double peer_time(const Peer* peer) { return (clock_real() - peer->start) * peer->options->speed; }

void peer_send(Peer* peer)
{
	const Session* session = &peer->session;
	Packet packet = {.game = peer->game_number, .sender = session->self, .phase = peer->phase};
	uint8_t bytes[PACKET_BYTES];
	packet.number = ++peer->number;
	packet.frame = session->frame;
	packet.lead = (int)fmax(fmin(peer->lead * 256.0, 32767.0), -32768.0);
	packet.known = session->known;
	packet.taken = session->taken;
	packet.first_input = peer->known;
	packet.first_hash = peer->taken;
	while (packet.input_count < WINDOW && packet.first_input + packet.input_count < session->given)
	{
		int frame = packet.first_input + packet.input_count;
		packet.inputs[packet.input_count++] = session->inputs[session->self][frame % WINDOW];
	}
	// a peer that leaves may have none: its device may be missing
	while (peer->phase != PEER_LEFT && packet.hash_count < WINDOW &&
	       packet.first_hash + packet.hash_count < session_count_hashes(session))
	{
		int hash = packet.first_hash + packet.hash_count;
		packet.hashes[packet.hash_count++] = session->hashes[hash % WINDOW];
	}
	network_send(&peer->network, peer_time(peer), bytes, packet_write(&packet, bytes));
}

static void peer_take(Peer* peer, const Packet* packet)
{
	Session* session = &peer->session;
	if (packet->sender != session->other || packet->known > session->given ||
	    packet->taken > session_count_hashes(session) ||
	    !session_take_inputs(session, packet->first_input, packet->input_count, packet->inputs) ||
	    !session_take_hashes(session, packet->first_hash, packet->hash_count, packet->hashes))
	{
		peer->damaged += 1;
		return;
	}
	peer->received += 1;
	peer->last_packet = clock_real();
	peer->known = packet->known > peer->known ? packet->known : peer->known;
	peer->taken = packet->taken > peer->taken ? packet->taken : peer->taken;
	if (packet->number <= peer->last_number)
	{
		peer->overtaken += 1;
		return;
	}
	double position = session->frame - fmin(fmax((peer->next - peer_time(peer)) * GAME_RATE, 0.0), 1.0);
	double lead = position - packet->frame;
	peer->lead += (peer->met ? 0.1 : 1.0) * (lead - peer->lead);
	peer->ahead = 0.5 * (peer->lead - packet->lead / 256.0);
	peer->last_number = packet->number;
	peer->other_phase = packet->phase;
	peer->met = true;
}

void peer_exchange(Peer* peer)
{
	uint8_t bytes[PACKET_BYTES + 1];
	double now = peer_time(peer), next = fmin(network_release(&peer->network, now), peer->next);
	link_sleep(peer->link, fmin((next - now) / peer->options->speed, 0.1));
	for (size_t size; (size = link_receive(peer->link, bytes, sizeof bytes)) > 0;)
	{
		Packet packet;
		if (packet_read(&packet, peer->game_number, bytes, size))
			peer_take(peer, &packet);
		else
			peer->damaged += 1;
	}
	session_compare(&peer->session);
}
