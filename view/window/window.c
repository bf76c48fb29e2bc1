// SPDX-License-Identifier: MIT
// window.c -- opens the GLFW window with its OpenGL context, and sends its events to input.c and the panel.
#include "view/window/window.h"
#include "view/window/input.h"
#include "view/window/panel.h"
#include <epoxy/gl.h>
#include <string.h>
#ifdef __linux__
#include <epoxy/glx.h>
#endif

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#define LEAST_SIDE  64  // px: minimum width and height of the window, equal to those of pictures
#define TITLE_STAYS 0.5 // s: minimum time between changes of the title

static char error[256]; // the first error of GLFW; static, because the callback has no user pointer

static void on_error(int code, const char* sentence)
{
	(void)code;
	if (!*error)
		snprintf(error, sizeof error, "%s", sentence);
}

static Viewer* viewer_of(GLFWwindow* window) { return glfwGetWindowUserPointer(window); }

static void on_key(GLFWwindow* window, int key, int code, int action, int modifiers)
{
	events_add(&viewer_of(window)->events,
	           (WindowEvent){.kind = EVENT_KEY, .key = key, .code = code, .action = action, .modifiers = modifiers});
}

static void on_letter(GLFWwindow* window, unsigned letter)
{
	events_add(&viewer_of(window)->events, (WindowEvent){.kind = EVENT_LETTER, .letter = letter});
}

static void on_cursor(GLFWwindow* window, double x, double y)
{
	Viewer* v = viewer_of(window);
	double now = glfwGetTime();
	events_add(&v->events, (WindowEvent){.kind = EVENT_CURSOR, .x = x, .y = y, .seconds = now - v->cursor_time});
	v->cursor_time = now;
}

// Releases all keys, because a key that is released while another window has the focus causes no event.
static void on_focus(GLFWwindow* window, int focused)
{
	Viewer* v = viewer_of(window);
	if (focused)
		return;
	v->session.player.down = 0;
	input_hold(v, ACTION_pour, false);
	v->tools.blasting = false; // the blast ends without an explosion
}

static void on_scale(GLFWwindow* window, float x, float y)
{
	(void)x, (void)y;
	panel_rescale(window);
}

static void on_enter(GLFWwindow* window, int inside) { viewer_of(window)->pointed = inside; }

static void on_button(GLFWwindow* window, int button, int action, int modifiers)
{
	events_add(&viewer_of(window)->events,
	           (WindowEvent){.kind = EVENT_BUTTON, .key = button, .action = action, .modifiers = modifiers});
}

static void on_wheel(GLFWwindow* window, double x, double y)
{
	events_add(&viewer_of(window)->events, (WindowEvent){.kind = EVENT_WHEEL, .x = x, .y = y});
}

// Creates the window with the native context API (GLX on X11) or, if this fails, with EGL.
static GLFWwindow* create(const Viewer* v, const char* title)
{
	const int ways[] = {GLFW_NATIVE_CONTEXT_API, GLFW_EGL_CONTEXT_API};
	GLFWwindow* window = NULL;
	for (int k = 0; k < 2 && !window; ++k)
	{
		glfwDefaultWindowHints();
		glfwWindowHint(GLFW_CONTEXT_CREATION_API, ways[k]);
		glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
		glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
		glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
		glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
		window = glfwCreateWindow(v->options->width, v->options->height, title, NULL, NULL);
	}
	return window;
}

// Sets *opengl to the GLX context of a window on Linux. Returns false if the window has no such context.
static bool glx_context(scree_opengl* opengl)
{
#ifdef __linux__
	*opengl = (scree_opengl){SCREE_WINDOW_GLX, glXGetCurrentContext(), glXGetCurrentDisplay()};
	return opengl->context && opengl->display;
#else
	(void)opengl;
	return false;
#endif
}

const scree_opengl* window_opengl(Viewer* v)
{
	return share_context(&v->opengl) || glx_context(&v->opengl) ? &v->opengl : NULL;
}

bool window_open(Viewer* v, char* sentence)
{
	glfwSetErrorCallback(on_error);
	if (!glfwInit())
	{
		snprintf(sentence, SENTENCE,
		         "there is no display to open a window on (%s); scree run SCENE --picture FILE.png needs none", error);
		return false;
	}
	v->window = create(v, "scree: opening");
	if (!v->window)
	{
		snprintf(sentence, SENTENCE, "there is no OpenGL 3.3 on this display (%s)", error);
		glfwTerminate();
		return false;
	}
	glfwSetWindowSizeLimits(v->window, LEAST_SIDE, LEAST_SIDE, GLFW_DONT_CARE, GLFW_DONT_CARE);
	glfwMakeContextCurrent(v->window);
	glfwSwapInterval(v->options->script ? 0 : 1);
	glfwSetWindowUserPointer(v->window, v);
	glfwSetKeyCallback(v->window, on_key);
	glfwSetCharCallback(v->window, on_letter);
	glfwSetCursorPosCallback(v->window, on_cursor);
	glfwSetWindowContentScaleCallback(v->window, on_scale);
	glfwSetWindowFocusCallback(v->window, on_focus);
	glfwSetCursorEnterCallback(v->window, on_enter);
	glfwSetMouseButtonCallback(v->window, on_button);
	glfwSetScrollCallback(v->window, on_wheel);
	if (panel_open(v->window, v->options->scale))
		return true;
	snprintf(sentence, SENTENCE, "the panel does not open");
	window_close(v);
	return false;
}

void window_close(Viewer* v)
{
	panel_close();
	if (v->window)
		glfwDestroyWindow(v->window);
	v->window = NULL;
	glfwTerminate();
}

static void handle_key(Viewer* v, const WindowEvent* event)
{
	static const int keys[ACTIONS] = {
#define X(name, key, shown, help) GLFW_KEY_##key,
#include "view/window/keys.def"
#undef X
	};
	static const int scene_keys[SCENE_KEYS] = {
#define X(name, glfw) GLFW_KEY_##glfw,
#include "scene/scene_keys.def"
#undef X
	};
	bool released = event->action == GLFW_RELEASE, ours = !panel_wants_keys();
	panel_key(v->window, event->key, event->code, event->action, event->modifiers);
	for (int k = 0; k < SCENE_KEYS; ++k)
		if (scene_keys[k] == event->key && (released || ours) && input_scene_key(v, (SceneKey)k, !released))
			return;
	for (int k = 0; k < ACTIONS; ++k)
	{
		if (keys[k] != event->key)
			continue;
		bool held = k == ACTION_pour || k == ACTION_blast;
		// a held key repeats two actions: throws, and steps if no step is due
		bool repeats = (k == ACTION_step && v->session.due == 0) || k == ACTION_launch;
		if (held && (released || (ours && event->action == GLFW_PRESS)))
			input_hold(v, (Action)k, !released);
		else if (!held && ours && (event->action == GLFW_PRESS || (event->action == GLFW_REPEAT && repeats)))
			input_action(v, (Action)k);
	}
}

static void handle_button(Viewer* v, const WindowEvent* event)
{
	panel_button(v->window, event->key, event->action, event->modifiers);
	if (event->action == GLFW_RELEASE || !panel_wants_mouse())
		input_button(v, event->key != GLFW_MOUSE_BUTTON_LEFT, event->action == GLFW_PRESS);
}

// Moves the cursor, after converting its position from window units of GLFW to pixels.
static void handle_cursor(Viewer* v, const WindowEvent* event)
{
	int width, height;
	glfwGetWindowSize(v->window, &width, &height);
	if (width > 0 && height > 0)
		input_cursor(v, (float)(event->x * v->camera.width / width), (float)(event->y * v->camera.height / height),
		             event->seconds);
}

// Takes the events of this frame from the queue and handles them.
static void handle_events(Viewer* v)
{
	WindowEvent event;
	events_begin(&v->events);
	while (events_take(&v->events, &event))
	{
		if (event.kind == EVENT_KEY)
			handle_key(v, &event);
		else if (event.kind == EVENT_LETTER)
			panel_letter(v->window, event.letter);
		else if (event.kind == EVENT_CURSOR)
			handle_cursor(v, &event);
		else if (event.kind == EVENT_BUTTON)
			handle_button(v, &event);
		else
		{
			panel_wheel(v->window, event.x, event.y);
			if (!panel_wants_mouse())
				input_wheel(v, (float)event.y);
		}
	}
}

void window_title(Viewer* v)
{
	char title[160];
	double now = glfwGetTime();
	if (now < v->title_time)
		return;
	v->title_time = now + TITLE_STAYS;
	snprintf(title, sizeof title, "scree: %.63s%s, %.0f fps", v->session.scene->name,
	         v->session.paused ? " (paused)" : "", v->frame_ms > 0.0f ? 1000.0 / (double)v->frame_ms : 0.0);
	glfwSetWindowTitle(v->window, title);
}

void window_events(Viewer* v, double seconds)
{
	if (seconds > 0.0 && !events_wait(&v->events))
		glfwWaitEventsTimeout(seconds);
	else
		glfwPollEvents();
	handle_events(v);
	v->done = v->done || glfwWindowShouldClose(v->window);
}
