// SPDX-License-Identifier: MIT
// advance.c -- takes the steps of the world in the viewer: those that are due in real time, and those towards a step of the time line.
#include "view/window/advance.h"
#include "view/window/rewind.h"
#include "view/window/tools.h"
#include "view/window/viewer.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#define LONGEST 0.03 // s: maximum duration of the steps in a frame; a slower world falls behind real time

// Pauses a recording that has ended, or that differs for the first time, and says so. Returns true if it paused.
static bool stop_playback(Viewer* v, bool differed)
{
	const Playback* playback = &v->session.playback;
	char sentence[SENTENCE];
	bool differs = !differed && *playback->difference;
	if (!differs && !playback->ended)
		return false;
	if (differs)
	{
		fprintf(stderr, "scree view: %s: %s\n", scree_world_get_device(v->session.player.world), playback->difference);
		v->code = 1;
		snprintf(sentence, SENTENCE, "%s", playback->difference);
	}
	else
		playback_write_end(playback, sentence);
	v->session.paused = true;
	v->session.accumulator = 0;
	v->session.due = 0;
	viewer_show(v, sentence);
	return true;
}

// Takes one step, and sets *added to true if the world may have other bodies. Returns false if the world has stopped: the step
// failed, which ends the viewer, or a recording pauses.
static bool step_world(Viewer* v, bool* added)
{
	Session* session = &v->session;
	char sentence[SENTENCE];
	bool differed = *session->playback.difference;
	if (grab_pull(&v->grab) != SCREE_OK)
		grab_release(&v->grab); // the held body no longer exists
	bool good = tools_step(v, added);
	if (!good)
		viewer_fail(v, scree_error());
	else if (!(good = session_step(session, sentence)))
		viewer_fail(v, sentence);
	if (!good)
		return false;
	*added = *added || session->playback.changed;
	if (!session->playback.ended)
	{
		if (renderer_step(&v->renderer, &v->camera, &v->style, session->seconds) != SCREE_OK)
		{
			viewer_fail(v, scree_error());
			return false;
		}
		rewind_add(v);
		history_step(&v->history, session->last);
	}
	return !stop_playback(v, differed);
}

bool advance_to_target(Viewer* v)
{
	int64_t target = v->target;
	bool added = true;
	if (!rewind_beyond(v))
		return rewind_step(v);
	rewind_cut(v); // clears the target
	if (step_world(v, &added) && v->session.player.steps < target && !v->past.off)
		v->target = target;
	return !v->done;
}

// Takes steps towards the target, until it is reached or the frame has taken long enough.
static void approach(Viewer* v)
{
	double begin = glfwGetTime();
	v->session.accumulator = 0;
	while (v->target >= 0 && glfwGetTime() - begin < LONGEST)
		if (!advance_to_target(v))
			viewer_show(v, scree_error());
	if (!v->done)
		viewer_update_world(v);
}

// Takes the next step: one of the past, if the world is there. Returns false if the world has stopped.
static bool next_step(Viewer* v, bool* added)
{
	if (v->wall.batch)
		return viewer_step_wall(v);
	if (!rewind_repeats(v) || v->session.player.steps == v->begun + v->past.end)
	{
		rewind_cut(v);
		return step_world(v, added);
	}
	if (!rewind_step(v))
		viewer_show(v, scree_error());
	history_step(&v->history, v->session.last);
	*added = true; // the world may have other bodies
	return true;
}

void advance(Viewer* v, bool scripted, double seconds)
{
	Session* session = &v->session;
	const Scene* scene = session->scene;
	double begin = glfwGetTime();
	bool added = false, goes_on = true;
	if (v->target >= 0)
	{
		approach(v);
		return;
	}
	if (!session->paused && !v->dragging)
		session->accumulator += scripted ? (double)scene->dt : (seconds < 0.1 ? seconds : 0.1) * (double)session->rate;
	while (goes_on && (session->due > 0 || session->accumulator >= (double)scene->dt * 0.999))
	{
		double dt = (double)scene->dt; // a step of a recording may change it
		if (session->due > 0)
			--session->due;
		else
			session->accumulator -= dt;
		v->capture.seconds += dt;
		goes_on = next_step(v, &added);
		if (glfwGetTime() - begin > LONGEST)
			session->accumulator = 0;
	}
	if (added && !v->done)
		viewer_update_world(v);
}
