// SPDX-License-Identifier: MIT
// page_change.c -- changes of the world by the visitor: gravity, removed bodies.
#include "view/remove_tool.h"
#include "web/page.h"
#include <stdlib.h>

// Sets the vertical acceleration of gravity, m/s^2. Returns false on failure.
EMSCRIPTEN_KEEPALIVE bool page_set_gravity(float y)
{
	scree_vec gravity;
	return page_check(scree_world_get_gravity(page.player.world, &gravity)) &&
	       page_check(scree_world_set_gravity(page.player.world, (scree_vec){gravity.x, y}));
}

// Returns the vertical acceleration of gravity, m/s^2.
EMSCRIPTEN_KEEPALIVE float page_gravity(void)
{
	scree_vec gravity = {0.0f, 0.0f};
	if (page.player.world)
		scree_world_get_gravity(page.player.world, &gravity);
	return gravity.y;
}

// Returns the index of the selected body, 0 if none is selected.
EMSCRIPTEN_KEEPALIVE int page_selected_body(void) { return (int)page.selected.body.index; }

static scree_body find_body(uint32_t index)
{
	scree_body found = SCREE_NULL_BODY, *bodies;
	int count = 0;
	if (scree_world_get_bodies(page.player.world, NULL, 0, &count) != SCREE_OK ||
	    !(bodies = malloc(((size_t)count + 1) * sizeof *bodies)))
		return found;
	if (scree_world_get_bodies(page.player.world, bodies, count, &count) == SCREE_OK)
		for (int k = 0; k < count; ++k)
			if (bodies[k].index == index)
				found = bodies[k];
	free(bodies);
	return found;
}

// Removes the body with this index. Returns false and stores a sentence if there is none, or if it must stay.
EMSCRIPTEN_KEEPALIVE bool page_remove(int index)
{
	const char* reason;
	if (page.grab.body.index == (uint32_t)index)
		grab_release(&page.grab);
	if (!remove_body(page.player.world, find_body((uint32_t)index), &reason))
		return page_fail(reason ? reason : scree_error());
	return page_show_world();
}
