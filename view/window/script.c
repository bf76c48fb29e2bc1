// SPDX-License-Identifier: MIT
// script.c -- runs a file of user actions, for tests and for pictures of the window.
//
// Before a frame the script runs all lines up to the next "frames N" or "await STATE". "frames N" draws N frames of one
// step each; "await STATE" draws frames until the viewer is in that state.
#include "view/window/script.h"
#include "tools/common/open_input.h"
#include "view/window/advance.h"
#include "view/window/export.h"
#include "view/window/input.h"
#include "view/window/panel.h"
#include "view/window/rewind.h"
#include "view/window/state_file.h"
#include "view/window/viewer.h"
#include <GLFW/glfw3.h>
#include <errno.h>
#include <inttypes.h>
#include <math.h>
#include <string.h>

#define PATIENCE   20.0   // s: maximum duration of "await"
#define MOST_TURNS 100.0f // maximum number of notches in "wheel"

static const char* const shown_keys[ACTIONS] = {
#define X(name, key, shown, help) shown,
#include "view/window/keys.def"
#undef X
};

bool script_open(Script* script, const char* path, char* sentence)
{
	*script = (Script){.path = path};
	if (!path)
		return true;
	script->file = open_input(path);
	if (!script->file)
		snprintf(sentence, SENTENCE, "cannot read %.400s: %s", path, strerror(errno));
	return script->file;
}

void script_close(Script* script)
{
	if (script->file)
		fclose(script->file);
	script->file = NULL;
}

static bool press_key(Viewer* v, const char* shown)
{
	for (int k = 0; k < ACTIONS; ++k)
	{
		if (strcmp(shown_keys[k], shown) != 0)
			continue;
		input_action(v, (Action)k);
		return true;
	}
	return false;
}

// Presses or releases a key. If the scene uses the key, sends it to the scene; else to the tool that works while its
// key is down. Returns false for any other key.
static bool hold_key(Viewer* v, const char* name, bool down)
{
	for (int k = 0; k < SCENE_KEYS; ++k)
		if (strcmp(scene_key_names[k], name) == 0)
			return input_scene_key(v, (SceneKey)k, down);
	const Action held[] = {ACTION_pour, ACTION_blast};
	for (int k = 0; k < 2; ++k)
		if (strcmp(shown_keys[held[k]], name) == 0)
		{
			input_hold(v, held[k], down);
			return true;
		}
	return false;
}

// Goes to a step of the time line.
static bool go_to(Viewer* v, int64_t step)
{
	bool good = !v->wall.batch && rewind_to(v, step);
	while (good && v->target >= 0)
		good = advance_to_target(v);
	return good && v->session.player.steps == step && viewer_update_world(v);
}

static void print_inspected(const char* how, const Inspected* inspected)
{
	if (inspect_any(inspected))
		printf(", %s %s%s", how, inspected->name, inspected->gone ? " (destroyed)" : "");
}

static void print_state(Viewer* v)
{
	uint64_t hash = 0;
	if (viewer_hash(v, &hash) != SCREE_OK)
		hash = 0;
	printf("scene %s, steps %" PRId64 ", bodies %d, %s, hash %016" PRIx64
	       ", middle %.3f %.3f, scale %.3f, %s, painted by %s, %s rows, %.2f ms a frame",
	       v->session.scene->name, v->session.counters.steps, v->session.counters.bodies,
	       v->session.paused ? "paused" : "running", hash, (double)v->camera.middle.x, (double)v->camera.middle.y,
	       (double)v->camera.scale, grab_holds(&v->grab) ? "holding" : "free", paint_names[v->style.paint],
	       scree_sharing_name(v->share.how), (double)v->frame_ms);
	printf(", size %dx%d, %s, panel at %.2f", v->camera.width, v->camera.height, v->style.dark ? "dark" : "light",
	       (double)panel_scale);
	if (v->eye.follows)
		printf(", following");
	print_inspected("hovered", &v->hovered);
	print_inspected("selected", &v->selected);
	if (v->renderer.scan.scene)
		printf(", rays %d of %d", v->renderer.scan.count, v->renderer.scan.in_view);
	if (flashes_shown(&v->style))
		printf(", events %d", v->renderer.flashes.seen);
	if (*v->message)
		printf(", says %s", v->message);
	printf("\n");
	fflush(stdout); // sends the line at once to the program that controls the viewer
}

// Returns 1 if the viewer is in a state, 0 if it is not, -1 for an unknown state. The name of a paint is also a state.
static int in_state(const Viewer* v, const char* state)
{
	const struct
	{
		const char* name;
		bool current;
	} states[] = {{"paused", v->session.paused},
	              {"running", !v->session.paused},
	              {"holding", grab_holds(&v->grab)},
	              {"free", !grab_holds(&v->grab)},
	              {"selected", inspect_any(&v->selected)},
	              {"unselected", !inspect_any(&v->selected)},
	              {"pushing", v->session.player.down != 0},
	              {"pushed", v->session.player.down == 0},
	              {"minimized", glfwGetWindowAttrib(v->window, GLFW_ICONIFIED)},
	              {"restored", !glfwGetWindowAttrib(v->window, GLFW_ICONIFIED)}};
	for (size_t k = 0; k < sizeof states / sizeof *states; ++k)
		if (strcmp(states[k].name, state) == 0)
			return states[k].current;
	int paint = find_name(paint_names, PAINTS, state, strlen(state));
	return paint < 0 ? -1 : (int)v->style.paint == paint;
}

// Ends the viewer with an error in the current line. Returns true, so that run_line reports no other error.
static bool fail_line(const Script* script, Viewer* v, const char* what, const char* why, int code)
{
	fprintf(stderr, "scree view: %s:%d: \"%.100s\" %s%s%s\n", script->path, script->line, what, why,
	        *v->message ? ": " : "", v->message);
	v->done = true;
	v->code = code;
	return true;
}

// Runs one line of the script. Returns false if the command is unknown or failed.
static bool run_line(Script* script, Viewer* v, const char* line)
{
	char word[256], rest = 0;
	float x, y;
	int n, m;
	if (sscanf(line, "frames %d %c", &n, &rest) == 1 && n > 0)
		script->frames = n;
	else if (sscanf(line, "await %15s %c", script->awaited, &rest) == 1)
	{
		script->until = glfwGetTime() + PATIENCE;
		return in_state(v, script->awaited) >= 0;
	}
	else if (sscanf(line, "key %255s %c", word, &rest) == 1)
		return press_key(v, word);
	else if (sscanf(line, "hold %255s %c", word, &rest) == 1)
		return hold_key(v, word, true);
	else if (sscanf(line, "release %255s %c", word, &rest) == 1)
		return hold_key(v, word, false);
	else if (sscanf(line, "cursor %f %f %c", &x, &y, &rest) == 2 && isfinite(x) && isfinite(y))
		input_cursor(v, x, y, 1.0 / 60.0);
	else if (sscanf(line, "button %255s %c", word, &rest) == 1 &&
	         (strcmp(word, "down") == 0 || strcmp(word, "up") == 0))
		input_button(v, false, strcmp(word, "down") == 0);
	else if (sscanf(line, "wheel %f %c", &x, &rest) == 1 && fabsf(x) <= MOST_TURNS)
		input_wheel(v, x);
	else if (sscanf(line, "size %d %d %c", &n, &m, &rest) == 2 && n > 0 && m > 0)
		glfwSetWindowSize(v->window, n, m);
	else if (sscanf(line, "rewind %d %c", &n, &rest) == 1)
		return go_to(v, n);
	else if (sscanf(line, "load %255s %c", word, &rest) == 1)
		return state_load(v, word);
	else if (strcmp(line, "minimize") == 0)
		glfwIconifyWindow(v->window);
	else if (strcmp(line, "restore") == 0)
		glfwRestoreWindow(v->window);
	else if (sscanf(line, "picture %255s %c", word, &rest) == 1)
		return export_picture(v, word) || fail_line(script, v, line, "cannot be done", 1);
	else if (sscanf(line, "scene %255s %c", word, &rest) == 1)
		return viewer_load(v, word, true);
	else if (sscanf(line, "device %255[^\n]", word) == 1)
		return viewer_move(v, word);
	else if (strcmp(line, "print") == 0)
		print_state(v);
	else
		return *line == 0 || *line == '#';
	return true;
}

void script_run(Script* script, Viewer* v)
{
	char line[512];
	if (!script->file)
		return;
	while (!v->done)
	{
		if (*script->awaited && in_state(v, script->awaited))
			*script->awaited = 0;
		if (*script->awaited && glfwGetTime() > script->until)
			fail_line(script, v, script->awaited, "was awaited too long", 2);
		if (*script->awaited || script->frames-- > 0)
			return;
		script->frames = 0;
		if (!fgets(line, sizeof line, script->file))
		{
			v->done = true;
			return;
		}
		++script->line;
		line[strcspn(line, "\r\n")] = 0;
		if (strcmp(line, "print") != 0) // the message is kept for "print", which prints it
			*v->message = 0;
		if (!run_line(script, v, line))
			fail_line(script, v, line, "cannot be done", 2);
	}
}
