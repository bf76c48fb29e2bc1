// SPDX-License-Identifier: MIT
// viewer.c -- changes the viewer's state: loads a scene, moves the world to a device, reads the world, shows messages.
#include "view/window/viewer.h"
#include "view/window/framing.h"
#include "view/window/rewind.h"
#include <inttypes.h>
#include <string.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

// Delay until the next reading of numbers, divided by the duration of the last reading.
#define REST 9.0
// px: maximum distance of a shape from the cursor when the user points at it; segments have no area
#define REACH 3.0f

void viewer_show(Viewer* v, const char* message)
{
	if (message != v->message)
		snprintf(v->message, sizeof v->message, "%s", message);
	v->message_time = glfwGetTime();
}

void viewer_fail(Viewer* v, const char* sentence)
{
	fprintf(stderr, "scree view: %s\n", sentence);
	v->code = 1;
	v->done = true;
}

bool viewer_update_world(Viewer* v)
{
	bool good = renderer_update_world(&v->renderer, v->session.scene, v->session.player.world);
	if (!good)
		viewer_fail(v, "the picture of the world cannot be made: memory is short, or its device failed");
	return good;
}

bool viewer_fetch(Viewer* v, const Style* style)
{
	scree_status status = v->wall.batch ? wall_show(&v->wall, &v->share) : share_update(&v->share);
	if (status == SCREE_OK && *v->share.sentence)
		viewer_show(v, v->share.sentence);
	if (status == SCREE_OK)
		*v->share.sentence = 0;
	if (status == SCREE_OK)
		status = renderer_fetch(&v->renderer, &v->camera, style);
	if (status != SCREE_OK)
		viewer_fail(v, share_error(&v->share));
	return status == SCREE_OK;
}

// Finds the collidable under the cursor, at a distance of at most REACH.
static scree_status find_under(Viewer* v, scree_collidable* found)
{
	return inspect_find(v->session.player.world, camera_point(&v->camera, v->x, v->y), REACH / v->camera.scale, found);
}

// Sets *next to the earliest time of the next reading, so that readings take at most a tenth of the time. begin:
// start of the last reading, s. A reading can be slow: the first query after a step computes boxes of all bodies that
// move. For many bodies on a CPU this takes as long as a step. To read the contacts of one body, a CPU scans all
// contacts.
static void rest(double* next, double begin)
{
	double end = glfwGetTime();
	*next = end + REST * (end - begin);
}

static scree_status look_under(Viewer* v)
{
	scree_collidable found;
	double begin = glfwGetTime();
	if (begin < v->look_time)
		return SCREE_OK;
	scree_status status = find_under(v, &found);
	inspect_choose(&v->hovered, v->session.scene, v->session.player.world, found);
	if (status == SCREE_OK)
		status = inspect_read(&v->hovered, v->session.scene, v->session.player.world);
	rest(&v->look_time, begin);
	return status;
}

static scree_status read_selected(Viewer* v)
{
	double begin = glfwGetTime();
	if (begin < v->read_time)
		return SCREE_OK;
	scree_status status = inspect_read(&v->selected, v->session.scene, v->session.player.world);
	rest(&v->read_time, begin);
	return status;
}

bool viewer_inspect(Viewer* v, bool over)
{
	scree_status status = SCREE_OK;
	if (over)
		status = look_under(v);
	else
		v->hovered = (Inspected){0};
	if (status == SCREE_OK)
		status = read_selected(v);
	if (status != SCREE_OK)
		viewer_fail(v, scree_error());
	return status == SCREE_OK;
}

void viewer_select(Viewer* v)
{
	scree_collidable found;
	if (find_under(v, &found) != SCREE_OK)
		viewer_fail(v, scree_error());
	else
		inspect_choose(&v->selected, v->session.scene, v->session.player.world, found);
	v->read_time = 0.0;
}

bool viewer_load(Viewer* v, const char* name, bool fresh)
{
	if (v->wall.batch && !viewer_may_change(v))
		return false;
	bool other = strcmp(name, v->session.name) != 0;
	rewind_end(v);
	share_close(&v->share); // session_load may destroy the world, whose rows are shared
	bool begun = session_load(&v->session, name, fresh, v->message);
	share_open(&v->share, v->session.player.world, false);
	if (!begun)
	{
		rewind_begin(v);
		viewer_show(v, v->message);
		return false;
	}
	v->recorded = NULL; // its recording has ended with the world
	v->grab = (Grab){.world = v->session.player.world,
	                 .hardest = v->grab.hardest,
	                 .hertz = v->grab.hertz,
	                 .density = v->grab.density};
	v->tools = (Tools){.blast = v->tools.blast, .pour.rate = v->tools.pour.rate};
	v->eye.follows = false;
	v->selected = v->hovered = (Inspected){0};
	v->next_device = -1;
	rewind_begin(v);
	if (!viewer_update_world(v))
		return false;
	if (other)
		eye_fit_scene(v);
	*v->message = 0;
	return true;
}

bool viewer_may_change(Viewer* v)
{
	bool replays = session_replays(&v->session);
	if (v->wall.batch)
		viewer_show(v, "this is a wall of worlds, each of which gets its own inputs: nothing else changes them");
	else if (replays)
		viewer_show(v, "this is a recording, whose calls are only repeated: nothing else changes its world");
	return !replays && !v->wall.batch;
}

bool viewer_move(Viewer* v, const char* device)
{
	char sentence[SENTENCE];
	if (v->wall.batch && !viewer_may_change(v))
		return false;
	v->next_device = -1;
	bool moved = session_hash(&v->session, sentence);
	uint64_t before = v->session.hash;
	moved = moved && session_move(&v->session, device, sentence) && session_hash(&v->session, sentence);
	if (moved)
		snprintf(sentence, SENTENCE, "moved to %s: the hash %s %016" PRIx64, device,
		         v->session.hash == before ? "stays" : "must not change, but is now", v->session.hash);
	viewer_show(v, sentence);
	return moved;
}

bool viewer_open_wall(Viewer* v, char* sentence)
{
	const Session* session = &v->session;
	if (!wall_paints(v->style.paint))
	{
		snprintf(sentence, SENTENCE, "--paint %s cannot show a wall of worlds", paint_names[v->style.paint]);
		return false;
	}
	scree_batch_def def = scree_batch_def_default();
	def.worlds = v->options->worlds;
	def.device = strcmp(session->device, "auto") == 0 ? "cpu" : session->device;
	def.threads = v->options->threads;
	def.lanes = v->options->lanes;
	def.allow_unequal_bits = v->options->allow_unequal_bits;
	if (!wall_open(&v->wall, session->scene, session->player.world, &def, sentence))
		return false;
	wall_place(&v->wall, render_tables_view(&v->renderer.tables, session->scene));
	v->renderer.tiles = (Tiles){v->wall.worlds, v->wall.row_count, v->wall.boxes};
	v->session.counters.bodies *= v->wall.worlds;
	v->panel = v->hovers = false;
	memset(v->style.layers, 0, sizeof v->style.layers); // most of them show only the template
	return true;
}

bool viewer_step_wall(Viewer* v)
{
	double begin = glfwGetTime();
	if (wall_step(&v->wall, &v->session.counters) != SCREE_OK)
	{
		viewer_fail(v, scree_error());
		return false;
	}
	int stopped = wall_stopped(&v->wall);
	if (stopped >= 0)
	{
		char sentence[SENTENCE];
		snprintf(sentence, sizeof sentence, "world %d is paused, because it has too many contacts", stopped);
		viewer_show(v, sentence);
	}
	v->session.hashed = false;
	v->session.seconds += (double)v->session.scene->dt;
	history_step(&v->history, (float)(1000.0 * (glfwGetTime() - begin)));
	return true;
}

scree_status viewer_hash(Viewer* v, uint64_t* hash)
{
	return v->wall.batch ? wall_hash(&v->wall, hash) : scree_world_get_hash(v->session.player.world, hash);
}
