// SPDX-License-Identifier: MIT
// rollback_session.c -- predicts inputs, rolls back, and compares hashes.
#include "rollback_session.h"
#include "peer_clock.h"
#include <limits.h>

_Static_assert(WINDOW > 2 * (MOST_PREDICTION + MOST_DELAY), "inputs and hashes on their way must fit");
_Static_assert(GAME_SAVES >= 2 * (MOST_PREDICTION + MOST_DELAY) + 2 * MOST_INTERVAL,
               "a state whose hashes are compared must still be saved");

scree_status session_begin(Session* session, int player, int frames, int input_delay, int prediction, int interval)
{
	session->self = player;
	session->other = 1 - player;
	session->frames = frames;
	session->prediction = prediction;
	session->interval = interval;
	session->given = input_delay < frames ? input_delay : frames; // inputs of the first frames are 0
	session->first_wrong = INT_MAX;
	session->different = -1;
	return game_get_hash(&session->game, &session->hashes[0]);
}

int session_get_confirmed(const Session* session)
{
	int confirmed = session->known < session->frame ? session->known : session->frame;
	return session->first_wrong < confirmed ? session->first_wrong : confirmed;
}

int session_count_hashes(const Session* session) { return session_get_confirmed(session) / session->interval + 1; }

bool session_may_advance(const Session* session)
{
	// the second limit is reached only if the other peer sends no hashes; own ones must not be overwritten
	return session->frame < session->frames && session->frame - session->known < session->prediction &&
	       session->frame / session->interval - session->compared < WINDOW - 1;
}

// Simulates a frame from state `frame`. saved: the state is saved already.
static scree_status simulate(Session* session, int frame, bool saved)
{
	GameInput both[GAME_PLAYERS];
	double begin = clock_real();
	GameInput* others = session->inputs[session->other];
	if (frame >= session->known) // predicts that the other player goes on as before
		others[frame % WINDOW] = session->known > 0 ? others[(session->known - 1) % WINDOW] : 0;
	for (int k = 0; k < GAME_PLAYERS; ++k)
		both[k] = session->inputs[k][frame % WINDOW];
	scree_status status = saved ? SCREE_OK : game_save(&session->game, frame);
	double saved_at = clock_real();
	session->counts.save_time += saved_at - begin;
	if (status == SCREE_OK)
		status = game_step(&session->game, both);
	double stepped_at = clock_real();
	session->counts.step_time += stepped_at - saved_at;
	int state = frame + 1, hash = state / session->interval;
	if (status == SCREE_OK && state % session->interval == 0)
		status = game_get_hash(&session->game, &session->hashes[hash % WINDOW]);
	session->counts.hash_time += clock_real() - stepped_at;
	return status;
}

scree_status session_correct(Session* session)
{
	if (session->first_wrong >= session->frame)
		return SCREE_OK;
	SessionCounts* counts = &session->counts;
	double begin = clock_real();
	int first = session->first_wrong, length = session->frame - first;
	scree_status status = game_load(&session->game, first);
	for (int frame = first; frame < session->frame && status == SCREE_OK; ++frame)
		status = simulate(session, frame, frame == first);
	session->first_wrong = INT_MAX;
	double time = clock_real() - begin;
	counts->rollbacks += 1;
	counts->repeated += length;
	counts->longest_rollback = length > counts->longest_rollback ? length : counts->longest_rollback;
	counts->rollback_time += time;
	counts->worst_rollback_time = time > counts->worst_rollback_time ? time : counts->worst_rollback_time;
	return status;
}

scree_status session_advance(Session* session, GameInput input)
{
	if (session->given < session->frames)
		session->inputs[session->self][session->given++ % WINDOW] = input;
	scree_status status = simulate(session, session->frame, false);
	session->frame += status == SCREE_OK;
	return status;
}

bool session_take_inputs(Session* session, int first, int count, const GameInput* inputs)
{
	int end = first + count;
	if (first > session->known || end > session->frames || end - session->frame > WINDOW / 2)
		return false;
	for (int frame = session->known; frame < end; ++frame)
	{
		GameInput* place = &session->inputs[session->other][frame % WINDOW];
		if (frame < session->frame && *place != inputs[frame - first] && frame < session->first_wrong)
			session->first_wrong = frame;
		*place = inputs[frame - first];
	}
	session->known = end > session->known ? end : session->known;
	return true;
}

bool session_take_hashes(Session* session, int first, int count, const uint64_t* hashes)
{
	int end = first + count;
	if (first > session->taken || end > session->frames / session->interval + 1 || end - session->compared > WINDOW)
		return false;
	for (int hash = session->taken; hash < end; ++hash)
		session->other_hashes[hash % WINDOW] = hashes[hash - first];
	session->taken = end > session->taken ? end : session->taken;
	return true;
}

void session_compare(Session* session)
{
	int count = session_count_hashes(session);
	while (session->different < 0 && session->compared < session->taken && session->compared < count)
	{
		int hash = session->compared++;
		if (session->hashes[hash % WINDOW] != session->other_hashes[hash % WINDOW])
			session->different = hash * session->interval;
		session->counts.hashes += 1;
	}
}

scree_status session_return(Session* session, int state)
{
	return state == session->frame ? SCREE_OK : game_load(&session->game, state);
}
