// SPDX-License-Identifier: MIT
// rollback_game.h -- a game for two players: they push each other and crates off a platform, and throw balls.
//
// The game follows the rules of docs/manual/determinism.md: a frame is a function of the state and of the inputs, and nothing else.
#ifndef ROLLBACK_GAME_H
#define ROLLBACK_GAME_H
#include <scree/scree.h>

#define GAME_RATE    60          // frames per second
#define GAME_PLAYERS 2           // number of players
#define GAME_SAVES   SCREE_SAVES // number of frames to which a game can go back

#define MAX_CRATES 24
#define MAX_BALLS  12

// The input of a player in a frame. The four lowest bits are keys; the eight highest are the direction of a throw, in 256ths of a
// turn. Whole numbers have the same value for all peers.
typedef uint16_t GameInput;
enum
{
	INPUT_LEFT = 1,
	INPUT_RIGHT = 2,
	INPUT_JUMP = 4,
	INPUT_THROW = 8,
};

typedef struct // state of the game that is not in the world
{
	uint64_t random; // seed of the next random number; it goes back with the rest
	int frame;       // number of frames since the start
	int crate_count, ball_count;
	int scores[GAME_PLAYERS];
	int pauses[GAME_PLAYERS]; // frames until a player may throw again
	scree_body crates[MAX_CRATES], balls[MAX_BALLS];
	int ages[MAX_BALLS]; // frames since the ball was thrown
} GameState;

typedef struct
{
	scree_world* world;
	scree_attribute crate, ball, odd_crate;
	scree_body players[GAME_PLAYERS];
	int diverge; // frame from which new crates have another density, so that a test has a difference to find; 0: never
	GameState state;
	GameState saves[GAME_SAVES];
} Game;

// Creates the world and the state at the start. seed: the same for all peers. Fails as functions of Scree do; the caller calls
// game_destroy in any case.
scree_status game_create(Game* game, const scree_world_def* def, uint64_t seed, int diverge);
void game_destroy(Game* game);

// Advances by one frame. inputs: one for each player.
scree_status game_step(Game* game, const GameInput* inputs);

// Returns the position at which a player starts, m.
scree_vec game_start(int player);

// Saves the state with the number frame % GAME_SAVES, and goes back to it.
scree_status game_save(Game* game, int frame);
scree_status game_load(Game* game, int frame);

// Plays some frames with random inputs and goes back, so that a driver compiles its kernels before another peer waits for a frame.
scree_status game_warm_up(Game* game, int frames);

// Computes a hash of the whole state.
scree_status game_get_hash(Game* game, uint64_t* hash);

#endif
