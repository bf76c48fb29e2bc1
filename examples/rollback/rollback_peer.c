// SPDX-License-Identifier: MIT
// rollback_peer.c -- the loop of a peer: receives packets, simulates frames at an even pace, and sends packets.
#include "rollback_peer.h"
#include "mix.h"
#include "peer_clock.h"
#include "rollback_exchange.h"
#include <inttypes.h>
#include <math.h>
#include <signal.h>
#include <stdio.h>

#define LINGER     1.0  // s for which a peer that is done sends acknowledgments, if the other is not done
#define SLOWEST    0.25 // largest share by which a frame becomes longer
#define SLOW_SHARE 0.05 // share for each frame of lead
#define CALL_PAUSE 0.1  // s from one packet to the next while the other peer is missing
#define WARM_UP    200  // frames that are played before the start, so that a driver compiles its kernels

static volatile sig_atomic_t stopped; // signal that ends the program; 0: none
static void stop(int number) { stopped = number; }

static bool peer_fail(const Peer* peer, const char* text)
{
	fprintf(stderr, "rollback: peer %d: %s\n", peer->session.self, text);
	return false;
}

// Returns the next input of a script that changes it now and then.
static GameInput script_next(Peer* peer)
{
	static const GameInput keys[] = {
	    0,          INPUT_LEFT,  INPUT_RIGHT, INPUT_LEFT | INPUT_JUMP, INPUT_RIGHT | INPUT_JUMP, INPUT_JUMP,
	    INPUT_LEFT, INPUT_THROW, INPUT_RIGHT};
	if (peer->held_frames-- == 0)
	{
		uint32_t direction = mix_below(&peer->script, 128); // upward
		peer->held = (GameInput)(keys[mix_below(&peer->script, sizeof keys / sizeof *keys)] | direction << 8);
		peer->held_frames = 5 + (int)mix_below(&peer->script, 25);
	}
	return peer->held;
}

// Prints a line for each frame of the log when it is confirmed. The score of such a frame is final.
static void peer_log(Peer* peer)
{
	const Session* session = &peer->session;
	for (; peer->logged <= session_get_confirmed(session); peer->logged += peer->options->log)
	{
		int frame = peer->logged, hash = frame / session->interval;
		const GameState* state =
		    frame < session->frame ? &session->game.saves[frame % GAME_SAVES] : &session->game.state;
		printf("peer %d: frame %d is confirmed, score %d:%d, hash %016" PRIx64
		       " of frame %d; at frame %d, %.0f rollbacks\n",
		       session->self, frame, state->scores[0], state->scores[1], session->hashes[hash % WINDOW],
		       hash * session->interval, session->frame, session->counts.rollbacks);
	}
}

// Simulates a frame if that is possible, and sends a packet in any case.
static bool peer_tick(Peer* peer)
{
	Session* session = &peer->session;
	scree_status status = session_correct(session);
	if (status == SCREE_OK && session_may_advance(session))
		status = session_advance(session, script_next(peer));
	else if (session->frame < session->frames)
		session->counts.stalls += 1;
	if (status != SCREE_OK)
		return peer_fail(peer, scree_error());
	session_compare(session);
	peer_log(peer);
	int frames = session->frames;
	int hashes = frames / session->interval + 1;
	bool confirmed = session_get_confirmed(session) == frames;
	bool done = confirmed && session->compared == hashes && peer->known == frames && peer->taken == hashes;
	if (done && peer->phase == PEER_PLAYS)
	{
		peer->phase = PEER_IS_DONE;
		peer->done = clock_real();
	}
	peer_send(peer);
	double longer = fmin(fmax(peer->ahead * SLOW_SHARE, 0.0), SLOWEST);
	peer->next += (1.0 + longer) / GAME_RATE;
	if (peer_time(peer) - peer->next > 0.25)
		peer->next = peer_time(peer); // a peer that was held up does not hurry
	peer->ahead_sum += peer->ahead;
	peer->ticks += 1;
	return true;
}

// Writes a snapshot of the state that differs, and sends the hash until the other peer has it too.
static bool peer_differs(Peer* peer)
{
	Session* session = &peer->session;
	int state = session->different, hash = state / session->interval;
	char path[1024];
	const void* bytes;
	size_t size;
	fprintf(stderr,
	        "rollback: peer %d: state %d differs: its hash is %016" PRIx64 " here, and %016" PRIx64 " at peer %d\n",
	        session->self, state, session->hashes[hash % WINDOW], session->other_hashes[hash % WINDOW], session->other);
	for (double end = clock_real() + LINGER; peer->taken <= hash && clock_real() < end;)
	{
		peer->next = peer_time(peer) + 1.0 / GAME_RATE;
		peer_send(peer);
		peer_exchange(peer);
	}
	if (session_return(session, state) != SCREE_OK ||
	    scree_world_snapshot(session->game.world, &bytes, &size) != SCREE_OK)
		return peer_fail(peer, scree_error());
	snprintf(path, sizeof path, "%s/rollback_peer%d_state%d.snapshot", peer->options->out, session->self, state);
	FILE* file = fopen(path, "wb");
	bool written = file && fwrite(bytes, 1, size, file) == size;
	written &= file && fclose(file) == 0;
	if (written)
		fprintf(
		    stderr,
		    "rollback: peer %d: the world of that state is in %s; scree diff compares it with that of the other peer\n",
		    session->self, path);
	else
		fprintf(stderr, "rollback: peer %d: the world of that state cannot be written to %s\n", session->self, path);
	return false;
}

// Sends a packet before the game, which begins when both peers are there. Counts of packets begin with the last one.
static void peer_call(Peer* peer)
{
	peer->network.sent = peer->network.lost = peer->network.bytes = 0.0;
	peer->begun = peer_time(peer);
	peer_send(peer);
	peer->next = peer->begun + CALL_PAUSE * peer->options->speed;
}

// Returns whether the game has to end before its last frame, and writes the reason.
static bool peer_broken(const Peer* peer, char* reason, size_t room)
{
	const Session* session = &peer->session;
	int limit = peer->met ? peer->options->timeout : peer->options->wait; // ms
	double silence = clock_real() - peer->last_packet;
	bool others = peer->damaged + peer->link->strangers > 0.0;
	if (peer->other_phase == PEER_LEFT)
		snprintf(reason, room, "peer %d has left, at frame %d", session->other, session->frame);
	else if (stopped)
		snprintf(reason, room, "stopped by signal %d, at frame %d", (int)stopped, session->frame);
	else if (silence > 1e-3 * limit)
		snprintf(reason, room, "no packet of peer %d for %.1f s, at frame %d%s", session->other, silence,
		         session->frame,
		         others ? "; other packets were ignored: both peers need the same version, --seed, --frames, "
		                  "--hash-interval and --port"
		                : "");
	else
		return false;
	return true;
}

// Plays until all frames are confirmed by both peers.
static bool peer_play(Peer* peer)
{
	char reason[256];
	peer->last_packet = clock_real();
	for (;;)
	{
		peer_exchange(peer);
		if (peer->session.different >= 0)
			return peer_differs(peer);
		if (peer->phase == PEER_IS_DONE && (peer->other_phase == PEER_IS_DONE || clock_real() > peer->done + LINGER))
			return true;
		if (peer_broken(peer, reason, sizeof reason))
			return peer_fail(peer, reason);
		if (peer_time(peer) < peer->next)
			continue;
		if (!peer->met)
			peer_call(peer);
		else if (!peer_tick(peer))
			return false;
	}
}

// Creates the game and begins the session.
static bool peer_begin(Peer* peer, Report* report)
{
	const RollbackOptions* options = peer->options;
	Session* session = &peer->session;
	int player = session->self;
	scree_world_def def = scree_world_def_default();
	scree_record_def record = scree_record_def_default();
	char path[1024];
	def.device = options->device[player];
	def.threads = options->threads[player];
	def.lanes = options->lanes[player];
	snprintf(path, sizeof path, "%s/rollback_peer%d.rec", options->out, player);
	record.path = path;
	scree_status status = game_create(&session->game, &def, (uint64_t)options->seed, options->diverge[player]);
	if (status == SCREE_OK)
		status = game_warm_up(&session->game, WARM_UP);
	if (status == SCREE_OK && options->record)
		status = scree_world_record(session->game.world, &record);
	if (status == SCREE_OK)
		status = session_begin(session, player, options->frames, options->input_delay[player],
		                       options->prediction[player], options->hash_interval);
	if (status != SCREE_OK)
		return peer_fail(peer, scree_error());
	snprintf(report->device, sizeof report->device, "%s", scree_world_get_device(session->game.world));
	return true;
}

bool peer_run(const RollbackOptions* options, int player, UdpLink* link, Report* report)
{
	static Peer peer; // too large for the stack
	uint64_t seed = (uint64_t)options->seed;
	peer.options = options;
	peer.link = link;
	peer.script = mix(seed, 1 + (uint64_t)player);
	peer.game_number = mix(mix(seed, (uint64_t)options->frames), (uint64_t)options->hash_interval);
	for (const char* letter = scree_version(); *letter; ++letter) // other versions may have other bits
		peer.game_number = mix(peer.game_number, (uint64_t)*letter);
	peer.session.self = player;
	peer.session.other = 1 - player;
	peer.logged = options->log;
	peer.network = (BadNetwork){
	    .link = link, .seed = mix(seed, 3 + (uint64_t)player), .loss = options->loss, .reorder = options->reorder};
	peer.network.delay = 1e-3 * options->delay;
	peer.network.jitter = 1e-3 * options->jitter;
	peer.network.overtaken = 2.5 / GAME_RATE;
	*report = (Report){.peer = player};
	signal(SIGINT, stop);
	signal(SIGTERM, stop);
	bool good = peer_begin(&peer, report);
	peer.start = clock_real();
	good = good && peer_play(&peer);
	peer.phase = good ? PEER_IS_DONE : PEER_LEFT;
	network_release(&peer.network, INFINITY);
	for (int k = 0; k < 3; ++k) // several, because a packet may be lost
		peer_send(&peer);
	network_release(&peer.network, INFINITY);
	report_fill(report, &peer);
	if (good && options->record && scree_world_end_recording(peer.session.game.world) != SCREE_OK)
		good = peer_fail(&peer, scree_error());
	report->good = good;
	game_destroy(&peer.session.game);
	return good;
}
