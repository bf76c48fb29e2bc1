// SPDX-License-Identifier: MIT
// page_tools.c -- tools of the page's visitor: drag bodies, throw and pour new bodies, set off explosions.
//
// Coordinates are in metres, in the frame of the world, not of the picture. So the same calls before the same steps
// give the same world, and the camera has no effect on it.
#include "view/blast_tool.h"
#include "web/page.h"

void page_begin_tools(void)
{
	page.grab = page.reached = (Grab){.world = page.player.world};
	page.pour = (Pour){.rate = POUR_RATE};
}

// Returns the tables of the current world. If there is no picture, fills `own` with tables for this call. Returns null
// on failure.
static const RenderTables* open_tables(RenderTables* own, Sprites* sprites)
{
	if (page.drawn && (!page.added || page_show_world()))
		return render_tables_update_bodies(&page.renderer.tables) == SCREE_OK ? &page.renderer.tables : NULL;
	if (page.drawn || !sprites_list(sprites, page.scene, page.player.world))
		return NULL;
	*own = (RenderTables){.world = page.player.world,
	                      .attributes = sprites->attributes,
	                      .attribute_count = sprites->attribute_count,
	                      .bodies = sprites->bodies,
	                      .body_count = sprites->body_count};
	return own;
}

static bool take(Grab* grab, float x, float y, bool (*how)(Grab*, const RenderTables*))
{
	RenderTables own;
	Sprites sprites = {0};
	const RenderTables* tables = page.wall.batch ? NULL : open_tables(&own, &sprites);
	grab->at = (scree_vec){x, y};
	bool good = tables && how(grab, tables);
	sprites_free(&sprites);
	return good;
}

// Finds the dynamic body at a point and starts to drag it. Returns false if there is no such body.
EMSCRIPTEN_KEEPALIVE bool page_pick(float x, float y) { return take(&page.grab, x, y, grab_pick); }

// Finds the dynamic body at a point without changing it. Returns false if there is no such body.
EMSCRIPTEN_KEEPALIVE bool page_reach(float x, float y) { return take(&page.reached, x, y, grab_reach); }

// Returns the current position, m, of the point at which page_reach found a body; null if the body no longer exists.
EMSCRIPTEN_KEEPALIVE const double* page_reached(void)
{
	scree_vec at;
	if (grab_anchor(&page.reached, &at) != SCREE_OK)
		return NULL;
	page.numbers[0] = (double)at.x;
	page.numbers[1] = (double)at.y;
	return page.numbers;
}

EMSCRIPTEN_KEEPALIVE void page_pull(float x, float y) { page.grab.at = (scree_vec){x, y}; }
EMSCRIPTEN_KEEPALIVE bool page_holds(void) { return grab_holds(&page.grab); }

// Ends dragging and pouring.
EMSCRIPTEN_KEEPALIVE void page_release(void)
{
	grab_release(&page.grab);
	pour_end(&page.pour);
}

// Starts to pour bodies around a point; page_pull can move the point. Returns false and stores a sentence if the scene
// has no bodies that can be poured.
EMSCRIPTEN_KEEPALIVE bool page_pour(float x, float y)
{
	grab_release(&page.grab);
	page.grab.at = (scree_vec){x, y};
	return page_check(pour_begin(&page.pour, page.player.world)) &&
	       (page.pour.kind_count > 0 || page_fail("This scene has no bodies of one shape that could be poured."));
}

// Adds a body of about this size (m) at a point, with a velocity. Returns false on failure.
EMSCRIPTEN_KEEPALIVE bool page_throw(float x, float y, float vx, float vy, float size)
{
	const scree_vec held = page.grab.at;
	page.grab.at = (scree_vec){x, y};
	page.grab.velocity = (scree_vec){vx, vy};
	bool good = page_check(grab_launch(&page.grab, size)) && page_show_world();
	page.grab.at = held;
	return good;
}

// Pushes bodies away from a point. Bodies within half of `radius` (m) get the whole `impulse`, N s per metre of width;
// bodies beyond `radius` get no impulse.
EMSCRIPTEN_KEEPALIVE bool page_blast(float x, float y, float radius, float impulse)
{
	scree_blast_def def = scree_blast_def_default();
	def.position = (scree_vec){x, y};
	def.radius = 0.5f * radius;
	def.falloff = 0.5f * radius;
	def.impulse = impulse;
	return page_check(scree_world_blast(page.player.world, &def, NULL));
}

// Return the impulse of an explosion in this world, N s/m (page_blast_impulse), and the radius of an explosion, px,
// after its key was held for a time in seconds (page_blast_radius).
EMSCRIPTEN_KEEPALIVE float page_blast_impulse(void) { return blast_impulse(&page.renderer.tables, BLAST_SPEED); }
EMSCRIPTEN_KEEPALIVE float page_blast_radius(float seconds) { return blast_radius((double)seconds); }
