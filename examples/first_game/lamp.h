// SPDX-License-Identifier: MIT
// lamp.h -- the lamp of the first game: it swings, and sends the hero back when one of its rays meets the hero.
#ifndef LAMP_H
#define LAMP_H
#include "hero.h"

#define COLOR_LAMP  0x808890e0u
#define COLOR_LIGHT 0xf0e8a050u
#define LAMP_RAYS   48

typedef struct Lamp
{
	scree_body body;
	scree_vec place;           // m
	int steps;                 // number of steps so far
	scree_vec ends[LAMP_RAYS]; // m: points at which the rays end
	int seen;                  // number of times that the lamp has seen the hero
} Lamp;

static inline Lamp lamp_create(scree_world* world, float x, float y)
{
	Lamp lamp = {.place = {x, y}};
	scree_body_create_box(world, SCREE_BODY_STATIC, scree_pose_make(x, y + 0.2f, 0.0f), 0.3f, 0.2f, COLOR_LAMP,
	                      &lamp.body);
	return lamp;
}

// Casts the rays; called after the step of the world.
static inline void lamp_step(Lamp* lamp, scree_world* world, Hero* hero)
{
	// swings by 0.6 radians to both sides, in 240 steps
	int phase = lamp->steps++ % 240;
	float swing = 0.02f * (float)(phase < 120 ? phase - 60 : 180 - phase);
	scree_ray rays[LAMP_RAYS];
	for (int k = 0; k < LAMP_RAYS; ++k)
	{
		float angle = swing + 0.01f * (float)(k - LAMP_RAYS / 2);
		scree_vec down = {0.0f, -12.0f};
		rays[k] = (scree_ray){.origin = lamp->place, .translation = scree_rot_apply(scree_rot_make(angle), down)};
		rays[k].ignored = lamp->body;
	}

	scree_query_result found[LAMP_RAYS];
	bool seen = false;
	scree_world_cast_rays(world, NULL, rays, LAMP_RAYS, found);
	for (int k = 0; k < LAMP_RAYS; ++k)
	{
		scree_body body = SCREE_NULL_BODY;
		lamp->ends[k] = found[k].hit ? found[k].point : scree_vec_add(rays[k].origin, rays[k].translation);
		if (found[k].hit)
			scree_collidable_get_body(world, found[k].collidable, &body);
		seen |= scree_body_equals(body, hero->body);
	}
	if (seen)
	{
		++lamp->seen;
		hero_restart(hero);
	}
}

// Draws the light between the rays.
static inline void lamp_paint(const Lamp* lamp, const DrawView* view)
{
	for (int k = 0; k + 1 < LAMP_RAYS; ++k)
	{
		scree_vec corners[3] = {view_pixels(view, lamp->place), view_pixels(view, lamp->ends[k]),
		                        view_pixels(view, lamp->ends[k + 1])};
		view->fill(corners, 3, COLOR_LIGHT, view->target);
	}
}

#endif
