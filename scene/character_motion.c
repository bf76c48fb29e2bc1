// SPDX-License-Identifier: MIT
// character_motion.c -- moves the characters of a scene before each step, by their scripts or by the keys of the user.
#include "scene/character_motion.h"
#include "scene/block.h"
#include "scene/scene_keys.h"
#include <math.h>
#include <stdlib.h>

#define GROUND_PULL 10.0f // 1/s: maximum acceleration of a character on ground, divided by its walking speed
#define AIR_PULL    4.0f  // 1/s: the same for a character in the air, while the key left or right is down

// m: a character that drops through a one-way platform is moved down by this depth, so that it is inside the platform
// and the platform no longer holds it
#define DROP 0.05f

#define DOWN(keys, name) ((keys) >> SCENE_KEY_##name & 1)

uint32_t characters_keys(const Scene* scene)
{
	return scene->character_count == 0
	           ? 0
	           : 1u << SCENE_KEY_left | 1u << SCENE_KEY_right | 1u << SCENE_KEY_up | 1u << SCENE_KEY_down;
}

scree_status characters_open(Characters* characters, const Scene* scene, scree_world* world)
{
	*characters = (Characters){.scene = scene};
	if (scene->character_count == 0)
		return SCREE_OK;
	characters->bodies = malloc(((size_t)scene->body_count + 1) * sizeof *characters->bodies);
	characters->movers = calloc((size_t)scene->character_count, sizeof *characters->movers);
	if (!characters->bodies || !characters->movers)
		return SCREE_ERROR_OUT_OF_MEMORY;
	scree_status status = scree_world_get_bodies(world, characters->bodies, scene->body_count, &characters->body_count);
	for (int k = 0; k < scene->character_count && status == SCREE_OK; ++k)
	{
		scree_pose pose;
		scree_body body = characters->bodies[block_first(scene, scene->characters[k].block)];
		status = scree_body_get_pose(world, body, &pose);
		characters->movers[k] = (scree_mover){.position = pose.position, .ignored = body};
	}
	return status;
}

void characters_close(Characters* characters)
{
	free(characters->bodies);
	free(characters->movers);
	*characters = (Characters){0};
}

static uint32_t script_keys(const Character* character, int64_t step)
{
	uint32_t down = 0;
	for (int k = 0; k < character->cue_count && character->cues[k].step <= step; ++k)
		down = character->cues[k].down;
	return down;
}

// Computes the velocity of a character's mover from the keys. down: all keys that are down; fresh: keys that were not
// down in the last step.
static void steer(const Character* character, scree_vec gravity, float dt, uint32_t down, uint32_t fresh,
                  scree_mover* mover)
{
	float g = sqrtf(gravity.x * gravity.x + gravity.y * gravity.y);
	scree_vec up = character->def.up, v = mover->velocity;
	bool stands = !scree_collidable_is_null(mover->ground);
	float along = v.x * up.y - v.y * up.x, rises = v.x * up.x + v.y * up.y;
	float wish = (float)((int)DOWN(down, right) - (int)DOWN(down, left)) * character->speed;
	float most = (stands ? GROUND_PULL : AIR_PULL) * character->speed * dt;
	if (stands || wish != 0.0f) // in the air without left or right, the velocity along the ground stays unchanged
		along = fminf(fmaxf(wish, along - most), along + most);
	rises -= stands ? 0.0f : g * dt;
	scree_vec carried = {0};
	if (stands && DOWN(fresh, up))
	{
		rises = character->jump;
		carried = mover->ground_velocity;
	}
	else if (stands && DOWN(fresh, down))
		mover->position = (scree_vec){mover->position.x - DROP * up.x, mover->position.y - DROP * up.y};
	mover->velocity = (scree_vec){along * up.y + rises * up.x + carried.x, -along * up.x + rises * up.y + carried.y};
}

static scree_status walk(Characters* characters, scree_world* world, int k, uint32_t down, uint32_t fresh)
{
	const Scene* scene = characters->scene;
	Character character = scene->characters[k];
	scree_mover* mover = &characters->movers[k];
	scree_vec gravity = scene->world.gravity;
	float g = sqrtf(gravity.x * gravity.x + gravity.y * gravity.y);
	if (g > 0.0f)
		character.def.up = (scree_vec){-gravity.x / g, -gravity.y / g};
	bool enabled = scree_body_is_enabled(world, mover->ignored);
	steer(&character, gravity, scene->dt, down, fresh, mover);
	if (character.push > 0.0f)
		return scree_movers_move_bodies(world, &character.def, mover, &mover->ignored, 1, character.push, scene->dt);
	scree_status status = scree_movers_move(world, &character.def, mover, 1, scene->dt);
	// target of the body: the mover's position plus the motion of its ground during the next step
	scree_pose pose = {{mover->position.x + mover->ground_velocity.x * scene->dt,
	                    mover->position.y + mover->ground_velocity.y * scene->dt},
	                   scree_rot_make(atan2f(-character.def.up.x, character.def.up.y))};
	return status == SCREE_OK && enabled ? scree_body_set_target(world, mover->ignored, pose) : status;
}

// Disables the bodies that characters take. A character takes a body of its block `takes` if it began to visit a
// sensor of that body in the last step.
static scree_status take(Characters* characters, scree_world* world)
{
	const Scene* scene = characters->scene;
	scree_events events;
	scree_status status = scree_world_get_events(world, &events);
	for (int i = 0; i < events.visits_began_count && status == SCREE_OK; ++i)
	{
		const scree_visit* visit = &events.visits_began[i];
		for (int k = 0; k < scene->character_count && status == SCREE_OK; ++k)
		{
			int takes = scene->characters[k].takes, first = takes < 0 ? 0 : block_first(scene, takes);
			int count = takes < 0 ? 0 : (int)scene->blocks[takes].count;
			if (!scree_body_equals(visit->body_visitor, characters->movers[k].ignored))
				continue;
			for (int n = 0; n < count && status == SCREE_OK; ++n)
				if (scree_body_equals(visit->body_sensor, characters->bodies[first + n]))
				{
					++characters->state.taken;
					status = scree_body_set_enabled(world, characters->bodies[first + n], false);
				}
		}
	}
	return status;
}

scree_status characters_move(Characters* characters, scree_world* world, int64_t step, uint32_t down)
{
	const Scene* scene = characters->scene;
	if (scene->character_count == 0)
		return SCREE_OK;
	characters->state.played |= (down & characters_keys(scene)) != 0;
	scree_status status = step > 0 ? take(characters, world) : SCREE_OK;
	uint32_t all = 0;
	for (int k = 0; k < scene->character_count && status == SCREE_OK; ++k)
	{
		uint32_t keys = characters->state.played ? down : script_keys(&scene->characters[k], step);
		status = walk(characters, world, k, keys, keys & ~characters->state.before);
		all |= keys;
	}
	characters->state.before = all;
	return status;
}
