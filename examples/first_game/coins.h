// SPDX-License-Identifier: MIT
// coins.h -- the coins of the first game: sensors that the hero takes.
#ifndef COINS_H
#define COINS_H
#include "hero.h"

#define COLOR_COIN 0xf0d040b0u

static inline void coins_create(scree_world* world)
{
	static const scree_vec places[] = {{-5.0f, 0.6f}, {-2.5f, 2.6f}, {2.0f, 4.4f},  {3.0f, 4.4f},
	                                   {6.0f, 0.6f},  {31.3f, 2.9f}, {16.0f, 0.6f}, {18.5f, 0.6f},
	                                   {21.0f, 0.6f}, {43.0f, 0.6f}, {44.0f, 0.6f}, {37.3f, 2.9f}};
	scree_body_def body = scree_body_def_default();
	scree_attribute_def disc = scree_attribute_def_default();
	scree_shape_make_circle(scree_vec_make(0.0f, 0.0f), 0.25f, &disc.shape);
	body.type = SCREE_BODY_STATIC;
	body.sensor = SCREE_SENSOR_MOVING; // reports bodies that move, and touches nothing
	body.user = COLOR_COIN;
	for (size_t k = 0; k < sizeof places / sizeof *places; ++k)
	{
		body.pose.position = places[k];
		scree_body_create_with_shape(world, &body, &disc, NULL);
	}
}

// Removes the coins that the hero has met in the last step, and returns their number.
static inline int coins_take(scree_world* world, const Hero* hero)
{
	scree_events events;
	int taken = 0;
	scree_world_get_events(world, &events);
	for (int k = 0; k < events.visits_began_count; ++k)
		if (scree_body_equals(events.visits_began[k].body_visitor, hero->body))
		{
			scree_body_destroy(world, events.visits_began[k].body_sensor);
			++taken;
		}
	return taken;
}

#endif
