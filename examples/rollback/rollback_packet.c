// SPDX-License-Identifier: MIT
// rollback_packet.c -- writes and reads packets, byte by byte, so that they are the same on every processor.
//
// A digest at the end depends on the number of the game, which is not sent. Other bytes that arrive at the port are found by it. The
// digest is no protection from attacks; a game for the internet needs encryption with authentication.
#include "rollback_packet.h"
#include "mix.h"

#define DIGEST_BYTES 8
#define MOST_NUMBER  0x3fffffff // larger numbers are damaged; sums of two do not overflow

_Static_assert(30 + 10 * WINDOW + DIGEST_BYTES <= PACKET_BYTES, "the largest packet must fit");

typedef struct // bytes that are written or read
{
	uint8_t* bytes;
	size_t at, size;
} Cursor;

static void put(Cursor* out, uint64_t value, int count)
{
	for (int k = 0; k < count; ++k)
		out->bytes[out->at++] = (uint8_t)(value >> 8 * k);
}

// Returns 0 beyond the end, and moves on nevertheless, so that the caller sees that bytes are missing.
static uint64_t get(Cursor* in, int count)
{
	uint64_t value = 0;
	for (int k = 0; k < count; ++k, ++in->at)
		value |= (in->at < in->size ? (uint64_t)in->bytes[in->at] : 0) << 8 * k;
	return value;
}

static uint64_t digest_of(uint64_t game, const uint8_t* bytes, size_t size)
{
	for (size_t k = 0; k < size; ++k)
		game = mix(game, bytes[k]);
	return mix(game, size);
}

size_t packet_write(const Packet* packet, uint8_t* bytes)
{
	Cursor out = {bytes, 0, PACKET_BYTES};
	put(&out, (uint64_t)packet->sender, 1);
	put(&out, (uint64_t)packet->phase, 1);
	put(&out, (uint64_t)packet->number, 4);
	put(&out, (uint64_t)packet->frame, 4);
	put(&out, (uint64_t)(packet->lead + 32768), 2);
	put(&out, (uint64_t)packet->known, 4);
	put(&out, (uint64_t)packet->taken, 4);
	put(&out, (uint64_t)packet->first_input, 4);
	put(&out, (uint64_t)packet->first_hash, 4);
	put(&out, (uint64_t)packet->input_count, 1);
	put(&out, (uint64_t)packet->hash_count, 1);
	for (int k = 0; k < packet->input_count; ++k)
		put(&out, packet->inputs[k], 2);
	for (int k = 0; k < packet->hash_count; ++k)
		put(&out, packet->hashes[k], 8);
	put(&out, digest_of(packet->game, bytes, out.at), DIGEST_BYTES);
	return out.at;
}

bool packet_read(Packet* packet, uint64_t game, const uint8_t* bytes, size_t size)
{
	Cursor in = {(uint8_t*)bytes, 0, size}, end = {(uint8_t*)bytes, size - DIGEST_BYTES, size};
	if (size < DIGEST_BYTES || get(&end, DIGEST_BYTES) != digest_of(game, bytes, size - DIGEST_BYTES))
		return false;
	uint64_t sender = get(&in, 1), phase = get(&in, 1), numbers[6], lead;
	numbers[0] = get(&in, 4);
	numbers[1] = get(&in, 4);
	lead = get(&in, 2);
	for (int k = 2; k < 6; ++k)
		numbers[k] = get(&in, 4);
	for (int k = 0; k < 6; ++k)
		if (numbers[k] > MOST_NUMBER)
			return false;
	*packet = (Packet){.game = game, .sender = (int)sender, .phase = (PeerPhase)phase, .lead = (int)lead - 32768};
	packet->number = (int)numbers[0];
	packet->frame = (int)numbers[1];
	packet->known = (int)numbers[2];
	packet->taken = (int)numbers[3];
	packet->first_input = (int)numbers[4];
	packet->first_hash = (int)numbers[5];
	packet->input_count = (int)get(&in, 1);
	packet->hash_count = (int)get(&in, 1);
	if (sender >= GAME_PLAYERS || phase > PEER_LEFT || packet->input_count > WINDOW || packet->hash_count > WINDOW)
		return false;
	for (int k = 0; k < packet->input_count; ++k)
		packet->inputs[k] = (GameInput)get(&in, 2);
	for (int k = 0; k < packet->hash_count; ++k)
		packet->hashes[k] = get(&in, 8);
	return in.at + DIGEST_BYTES == size;
}
