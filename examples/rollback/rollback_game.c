// SPDX-License-Identifier: MIT
// rollback_game.c -- creates the world of the game, saves it, and computes its hash.
#include "rollback_game.h"
#include "mix.h"

// Creates an attribute of a shape; density in kg/m^2.
static scree_status attribute_create(Game* game, const scree_shape* shape, float density, scree_attribute* attribute)
{
	scree_attribute_def def = scree_attribute_def_default();
	def.shape = *shape;
	def.density = density;
	return scree_attribute_create(game->world, &def, attribute);
}

// Creates the shapes of a platform, a player, a crate and a ball.
static scree_status create_attributes(Game* game, scree_attribute* platform, scree_attribute* player)
{
	scree_shape shape;
	scree_status status = scree_shape_make_box(12.0f, 0.5f, &shape);
	if (status == SCREE_OK)
		status = attribute_create(game, &shape, 1.0f, platform);
	if (status == SCREE_OK)
		status = scree_shape_make_capsule((scree_vec){0.0f, -0.4f}, (scree_vec){0.0f, 0.4f}, 0.4f, &shape);
	if (status == SCREE_OK)
		status = attribute_create(game, &shape, 2.0f, player);
	if (status == SCREE_OK)
		status = scree_shape_make_box(0.5f, 0.5f, &shape);
	if (status == SCREE_OK)
		status = attribute_create(game, &shape, 1.0f, &game->crate);
	if (status == SCREE_OK)
		status = attribute_create(game, &shape, 1.001f, &game->odd_crate);
	if (status == SCREE_OK)
		status = scree_shape_make_circle((scree_vec){0.0f, 0.0f}, 0.25f, &shape);
	if (status == SCREE_OK)
		status = attribute_create(game, &shape, 4.0f, &game->ball);
	return status;
}

scree_status game_create(Game* game, const scree_world_def* def, uint64_t seed, int diverge)
{
	scree_attribute platform, player;
	scree_body_def body = scree_body_def_default();
	*game = (Game){0};
	game->diverge = diverge;
	game->state.random = seed;
	scree_status status = scree_world_create(def, &game->world);
	if (status == SCREE_OK)
		status = create_attributes(game, &platform, &player);
	if (status != SCREE_OK)
		return status;
	body.attribute = platform;
	body.pose.position = (scree_vec){0.0f, -0.5f}; // its top is at y = 0
	status = scree_body_create(game->world, &body, NULL);
	body.type = SCREE_BODY_DYNAMIC;
	body.attribute = player;
	body.locks = SCREE_LOCK_ROTATION;
	body.stays_awake = true;
	for (int k = 0; k < GAME_PLAYERS && status == SCREE_OK; ++k)
	{
		body.pose.position = game_start(k);
		status = scree_body_create(game->world, &body, &game->players[k]);
	}
	return status;
}

scree_vec game_start(int player) { return (scree_vec){player == 0 ? -6.0f : 6.0f, 0.9f}; }

void game_destroy(Game* game) { scree_world_destroy(game->world); }

scree_status game_save(Game* game, int frame)
{
	game->saves[frame % GAME_SAVES] = game->state;
	return scree_world_save(game->world, frame % GAME_SAVES);
}

scree_status game_load(Game* game, int frame)
{
	game->state = game->saves[frame % GAME_SAVES];
	return scree_world_load(game->world, frame % GAME_SAVES);
}

scree_status game_get_hash(Game* game, uint64_t* hash)
{
	// values one by one, because the padding of a struct may have any content
	const GameState* state = &game->state;
	scree_status status = scree_world_get_hash(game->world, hash);
	*hash = mix(mix(*hash, state->random), (uint64_t)state->frame);
	for (int k = 0; k < GAME_PLAYERS; ++k)
		*hash = mix(mix(*hash, (uint64_t)state->scores[k]), (uint64_t)state->pauses[k]);
	for (int k = 0; k < state->crate_count; ++k)
		*hash = mix(mix(*hash, state->crates[k].index), state->crates[k].generation);
	for (int k = 0; k < state->ball_count; ++k)
		*hash = mix(mix(mix(*hash, state->balls[k].index), state->balls[k].generation), (uint64_t)state->ages[k]);
	return status;
}

scree_status game_warm_up(Game* game, int frames)
{
	uint64_t seed = 0, hash;
	scree_status status = game_save(game, 0);
	for (int k = 0; k < frames && status == SCREE_OK; ++k)
	{
		GameInput inputs[GAME_PLAYERS] = {(GameInput)mix_below(&seed, 65536), (GameInput)mix_below(&seed, 65536)};
		status = game_step(game, inputs);
		if (status == SCREE_OK)
			status = game_get_hash(game, &hash);
	}
	return status == SCREE_OK ? game_load(game, 0) : status;
}
