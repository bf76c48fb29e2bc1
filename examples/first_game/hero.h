// SPDX-License-Identifier: MIT
// hero.h -- the character of the first game: it walks, jumps and pushes crates.
#ifndef HERO_H
#define HERO_H
#include "window.h"
#include <scree/scree_math.h>

#define COLOR_HERO 0x58a8e8d0u

typedef struct Hero
{
	scree_mover mover; // finds its way by queries
	scree_body body;   // follows the mover; crates and sensors touch it
	scree_vec start;   // m: place to which the hero returns
} Hero;

static inline Hero hero_create(scree_world* world, float x, float y)
{
	Hero hero = {.mover = {.position = {x, y}}, .start = {x, y}};
	scree_mover_def size = scree_mover_def_default();
	scree_vec end = {0.0f, 0.5f * size.length};
	scree_body_create_capsule(world, SCREE_BODY_KINEMATIC, scree_pose_make(x, y, 0.0f), scree_vec_negate(end), end,
	                          size.radius, COLOR_HERO, &hero.body);
	return hero;
}

static inline void hero_restart(Hero* hero) { hero->mover = (scree_mover){.position = hero->start}; }

// Returns -1, 0 or 1: the direction of the keys left and right.
static inline float hero_direction(uint8_t keys)
{
	return (keys & KEY_RIGHT ? 1.0f : 0.0f) - (keys & KEY_LEFT ? 1.0f : 0.0f);
}

// Returns the body on which the hero stands; null in the air.
static inline scree_body hero_ground(const Hero* hero, scree_world* world)
{
	scree_body ground = SCREE_NULL_BODY;
	if (!scree_collidable_is_null(hero->mover.ground))
		scree_collidable_get_body(world, hero->mover.ground, &ground);
	return ground;
}

// Moves the hero by the keys of a step; called before the step of the world.
static inline void hero_step(Hero* hero, scree_world* world, uint8_t keys, float dt)
{
	scree_vec* velocity = &hero->mover.velocity; // relative to the ground
	float speed = 5.0f * hero_direction(keys);
	scree_body ground = hero_ground(hero, world);
	if (scree_body_is_null(ground))
		*velocity = scree_vec_make(scree_lerp(velocity->x, speed, 0.1f), velocity->y - 10.0f * dt);
	else
	{
		*velocity = scree_vec_make(speed, 0.0f);
		if (keys & KEY_JUMP)
			*velocity = scree_vec_add(hero->mover.ground_velocity, scree_vec_make(speed, 7.0f));
		// a mover has no weight of its own: 10 N press on the body below
		scree_body_apply_force_at(world, ground, scree_vec_make(0.0f, -10.0f), hero->mover.position);
	}
	// pushes bodies with at most 200 N
	scree_movers_move_bodies(world, NULL, &hero->mover, &hero->body, 1, 200.0f, dt);
	if (hero->mover.position.y < -4.0f)
		hero_restart(hero);
}

#endif
