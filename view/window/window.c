// SPDX-License-Identifier: MIT
// window.c -- the GLFW window: its OpenGL context, and its events, which go to input.c and the panel.
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

#define LEAST_SIDE 64 // px, as of pictures

static char error[256]; // the first error of GLFW, whose callback has no user pointer

static void on_error(int code, const char* sentence)
{
	(void)code;
	if (!*error)
		snprintf(error, sizeof error, "%s", sentence);
}

static Viewer* viewer_of(GLFWwindow* window) { return glfwGetWindowUserPointer(window); }

static void on_key(GLFWwindow* window, int key, int code, int event, int modifiers)
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
	panel_key(window, key, code, event, modifiers);
	for (int k = 0; k < SCENE_KEYS; ++k)
		if (scene_keys[k] == key && (event == GLFW_RELEASE || !panel_wants_keys()) &&
		    input_scene_key(viewer_of(window), (SceneKey)k, event != GLFW_RELEASE))
			return;
	if (event == GLFW_RELEASE || panel_wants_keys())
		return;
	for (int k = 0; k < ACTIONS; ++k)
	{
		bool repeats = k == ACTION_step || k == ACTION_launch;
		if (keys[k] == key && (event == GLFW_PRESS || repeats))
			input_action(viewer_of(window), (Action)k);
	}
}

static void on_letter(GLFWwindow* window, unsigned letter) { panel_letter(window, letter); }

// GLFW gives window units, which are not always pixels.
static void on_cursor(GLFWwindow* window, double x, double y)
{
	Viewer* v = viewer_of(window);
	int width, height;
	glfwGetWindowSize(window, &width, &height);
	double now = glfwGetTime();
	if (width > 0 && height > 0)
		input_cursor(v, (float)(x * v->camera.width / width), (float)(y * v->camera.height / height),
		             now - v->cursor_time);
	v->cursor_time = now;
}

// Keys that are let go in another window are not told.
static void on_focus(GLFWwindow* window, int focused)
{
	if (!focused)
		viewer_of(window)->session.down = 0;
}

static void on_enter(GLFWwindow* window, int inside) { viewer_of(window)->pointed = inside; }

static void on_button(GLFWwindow* window, int button, int event, int modifiers)
{
	panel_button(window, button, event, modifiers);
	if (event == GLFW_RELEASE || !panel_wants_mouse())
		input_button(viewer_of(window), button != GLFW_MOUSE_BUTTON_LEFT, event == GLFW_PRESS);
}

static void on_wheel(GLFWwindow* window, double x, double y)
{
	panel_wheel(window, x, y);
	if (!panel_wants_mouse())
		input_wheel(viewer_of(window), (float)y);
}

// Tries the native context API (GLX on X11) first, then EGL.
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

// The context of a window that does not use EGL: on Linux it is GLX.
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
	v->window = create(v, "scree");
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
	glfwSetWindowFocusCallback(v->window, on_focus);
	glfwSetCursorEnterCallback(v->window, on_enter);
	glfwSetMouseButtonCallback(v->window, on_button);
	glfwSetScrollCallback(v->window, on_wheel);
	if (panel_open(v->window))
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

void window_events(Viewer* v, double seconds)
{
	if (seconds > 0.0)
		glfwWaitEventsTimeout(seconds);
	else
		glfwPollEvents();
	v->done = v->done || glfwWindowShouldClose(v->window);
}
