// SPDX-License-Identifier: MIT
// rollback_session.h -- runs a game with the inputs of two peers: predicts inputs that have not arrived, and rolls back.
//
// A session has no network and no clock. Frame f leads from state f to state f + 1. A frame is confirmed if the inputs of both
// peers up to it are known, and if it was simulated with them.
#ifndef ROLLBACK_SESSION_H
#define ROLLBACK_SESSION_H
#include "rollback_game.h"
#include <stdbool.h>

#define MOST_PREDICTION 8 // largest number of frames that are simulated with a predicted input
#define MOST_DELAY      8 // largest input delay, frames
#define MOST_INTERVAL   8 // states from one hash to the next; states since the last equal hash must still be saved
#define WINDOW          64 // frames for which inputs and hashes are kept: more than twice the sum of the two limits above

typedef struct // counts and times of a session
{
	double rollbacks, longest_rollback;        // number, frames
	double repeated;                           // frames that were simulated again
	double stalls;                             // frames at which the peer waited for inputs
	double hashes;                             // hashes that were compared with those of the other peer
	double rollback_time, worst_rollback_time; // s, sum and largest
	double step_time, save_time, hash_time;    // s, sums over all simulated frames
} SessionCounts;

typedef struct
{
	Game game;
	int self, other; // player of this peer, and of the other one
	int frames;      // length of the game
	int prediction;  // largest number of frames with a predicted input; 0: lockstep
	int frame;       // number of simulated frames
	int given;       // number of own inputs
	int known;       // number of inputs of the other peer
	int first_wrong; // first frame that was simulated with a wrong prediction; INT_MAX: none
	int interval;    // states from one hash to the next; hash k is that of state k * interval
	int taken;       // number of hashes of the other peer
	int compared;    // number of hashes that were compared
	int different;   // state whose two hashes differ; -1: none
	GameInput inputs[GAME_PLAYERS]
	                [WINDOW]; // input of frame f at f % WINDOW; from `known` on, predictions that were used
	uint64_t hashes[WINDOW], other_hashes[WINDOW];
	SessionCounts counts;
} Session;

// Begins with the game of the session, which must be at its start. input_delay: frames from an own input to its effect, 0 to
// MOST_DELAY. prediction: 0 to MOST_PREDICTION; 0 needs an input delay of 1 or more, because peers send an input when they simulate.
// interval: states from one hash to the next, 1 to MOST_INTERVAL.
scree_status session_begin(Session* session, int player, int frames, int input_delay, int prediction, int interval);

// Returns the number of confirmed frames.
int session_get_confirmed(const Session* session);
// Returns the number of hashes of confirmed states.
int session_count_hashes(const Session* session);
// Returns whether the next frame may be simulated.
bool session_may_advance(const Session* session);

// Simulates the frames again that had a wrong prediction, if there are any.
scree_status session_correct(Session* session);
// Simulates the next frame. session_may_advance must be true, and session_correct must have been called. input: own input, which takes
// effect after the input delay.
scree_status session_advance(Session* session, GameInput input);

// Takes inputs of the other peer, from frame `first` on; known ones are skipped. Returns false if they leave out a frame, or are too
// far ahead; then none is taken.
bool session_take_inputs(Session* session, int first, int count, const GameInput* inputs);
// Takes hashes of the other peer in the same way.
bool session_take_hashes(Session* session, int first, int count, const uint64_t* hashes);
// Compares hashes of states that both peers have confirmed, up to the first that differs.
void session_compare(Session* session);

// Goes back to an earlier state. No frame can be simulated after it.
scree_status session_return(Session* session, int state);

#endif
