// SPDX-License-Identifier: MIT
// rollback_rules.c -- advances the game by a frame: players run, jump and throw; crates fall from the sky and off the platform.
//
// Floats use only + - * / and comparisons, which have the same bits on every machine. A direction comes from scree_rot_make, because
// the cosine of a C library may differ in its last bit.
#include "mix.h"
#include "rollback_game.h"

#define SUBSTEPS     4
#define RUN_SPEED    6.0f  // m/s
#define RUN_CHANGE   0.7f  // largest change of a player's speed in a frame, m/s
#define JUMP_SPEED   8.0f  // m/s
#define THROW_SPEED  14.0f // m/s
#define THROW_PAUSE  20    // frames
#define BALL_FRAMES  150   // life of a ball
#define CRATE_FRAMES 40    // frames from one crate to the next
#define LOWEST       -8.0f // height below which a body has fallen off, m
#define HAND         0.9f  // distance from a player to a new ball, m: more than the radii of both

#define TRY(call)                       \
	do                                  \
	{                                   \
		scree_status try_status = call; \
		if (try_status != SCREE_OK)     \
			return try_status;          \
	} while (0)

// Creates a ball that a player throws. Without a free place the player throws nothing.
static scree_status throw_ball(Game* game, int player, GameInput input, scree_vec from)
{
	GameState* state = &game->state;
	if (!(input & INPUT_THROW) || state->pauses[player] > 0 || state->ball_count == MAX_BALLS)
		return SCREE_OK;
	const float turn = 6.2831853f / 256.0f; // radians in a 256th of a turn
	scree_rot way = scree_rot_make((float)(input >> 8) * turn);
	scree_body_def def = scree_body_def_default();
	def.type = SCREE_BODY_DYNAMIC;
	def.attribute = game->ball;
	def.pose.position = (scree_vec){from.x + HAND * way.c, from.y + HAND * way.s};
	def.velocity.linear = (scree_vec){THROW_SPEED * way.c, THROW_SPEED * way.s};
	TRY(scree_body_create(game->world, &def, &state->balls[state->ball_count]));
	state->ages[state->ball_count++] = 0;
	state->pauses[player] = THROW_PAUSE;
	return SCREE_OK;
}

// Moves a player by its input. standing: the player has ground below.
static scree_status move_player(Game* game, int player, GameInput input, scree_vec velocity, bool standing)
{
	float wanted = RUN_SPEED * (float)(((input & INPUT_RIGHT) != 0) - ((input & INPUT_LEFT) != 0));
	float change = wanted - velocity.x;
	velocity.x += change > RUN_CHANGE ? RUN_CHANGE : change < -RUN_CHANGE ? -RUN_CHANGE : change;
	if ((input & INPUT_JUMP) && standing && velocity.y < 1.0f)
		velocity.y = JUMP_SPEED;
	return scree_body_set_linear_velocity(game->world, game->players[player], velocity);
}

// Puts a player that fell off back to the start; the other one scores.
static scree_status return_player(Game* game, int player)
{
	scree_pose start = {game_start(player), {1.0f, 0.0f}};
	game->state.scores[1 - player] += 5;
	TRY(scree_body_set_pose(game->world, game->players[player], start));
	return scree_body_set_linear_velocity(game->world, game->players[player], (scree_vec){0.0f, 0.0f});
}

// Applies the inputs, in the order of the players.
static scree_status play(Game* game, const GameInput* inputs)
{
	scree_pose poses[GAME_PLAYERS];
	scree_velocity velocities[GAME_PLAYERS];
	scree_ray rays[GAME_PLAYERS] = {0};
	scree_query_result found[GAME_PLAYERS];
	TRY(scree_bodies_get_poses(game->world, game->players, poses, GAME_PLAYERS));
	TRY(scree_bodies_get_velocities(game->world, game->players, velocities, GAME_PLAYERS));
	for (int k = 0; k < GAME_PLAYERS; ++k)
	{
		rays[k].origin = poses[k].position;
		rays[k].translation = (scree_vec){0.0f, -0.95f}; // 0.15 m more than half of a player
		rays[k].ignored = game->players[k];
	}
	TRY(scree_world_cast_rays(game->world, NULL, rays, GAME_PLAYERS, found));
	for (int k = 0; k < GAME_PLAYERS; ++k)
	{
		game->state.pauses[k] -= game->state.pauses[k] > 0;
		TRY(throw_ball(game, k, inputs[k], poses[k].position));
		TRY(move_player(game, k, inputs[k], velocities[k].linear, found[k].hit));
		if (poses[k].position.y < LOWEST)
			TRY(return_player(game, k));
	}
	return SCREE_OK;
}

// Creates a crate above the platform now and then.
static scree_status drop_crate(Game* game)
{
	GameState* state = &game->state;
	if (state->frame % CRATE_FRAMES != 0 || state->crate_count == MAX_CRATES)
		return SCREE_OK;
	scree_body_def def = scree_body_def_default();
	def.type = SCREE_BODY_DYNAMIC;
	def.attribute = game->diverge > 0 && state->frame >= game->diverge ? game->odd_crate : game->crate;
	def.pose.position = (scree_vec){(float)mix_below(&state->random, 161) * 0.125f - 10.0f, 9.0f};
	return scree_body_create(game->world, &def, &state->crates[state->crate_count++]);
}

// Destroys crates that fell off. Each is a point for the player of the other side.
static scree_status clear_crates(Game* game)
{
	GameState* state = &game->state;
	scree_pose poses[MAX_CRATES];
	int kept = 0;
	TRY(scree_bodies_get_poses(game->world, state->crates, poses, state->crate_count));
	for (int k = 0; k < state->crate_count; ++k)
	{
		if (poses[k].position.y < LOWEST)
		{
			++state->scores[poses[k].position.x > 0.0f ? 0 : 1];
			TRY(scree_body_destroy(game->world, state->crates[k]));
		}
		else
			state->crates[kept++] = state->crates[k];
	}
	state->crate_count = kept;
	return SCREE_OK;
}

// Destroys balls at the end of their life.
static scree_status clear_balls(Game* game)
{
	GameState* state = &game->state;
	int kept = 0;
	for (int k = 0; k < state->ball_count; ++k)
	{
		if (++state->ages[k] >= BALL_FRAMES)
		{
			TRY(scree_body_destroy(game->world, state->balls[k]));
			continue;
		}
		state->balls[kept] = state->balls[k];
		state->ages[kept++] = state->ages[k];
	}
	state->ball_count = kept;
	return SCREE_OK;
}

scree_status game_step(Game* game, const GameInput* inputs)
{
	TRY(play(game, inputs));
	TRY(drop_crate(game));
	TRY(clear_crates(game));
	TRY(clear_balls(game));
	TRY(scree_world_step(game->world, 1.0f / GAME_RATE, SUBSTEPS));
	++game->state.frame;
	return SCREE_OK;
}
