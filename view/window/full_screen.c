// SPDX-License-Identifier: MIT
// full_screen.c -- switches the window to full screen, and back to its earlier place on the screen.
#include "view/window/full_screen.h"
#include "view/window/viewer.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

void full_toggle(Viewer* v)
{
	Place* p = &v->place;
	GLFWmonitor* monitor = glfwGetPrimaryMonitor();
	const GLFWvidmode* mode = monitor ? glfwGetVideoMode(monitor) : NULL;
	if (glfwGetWindowMonitor(v->window))
	{
		glfwSetWindowMonitor(v->window, NULL, p->x, p->y, p->width, p->height, GLFW_DONT_CARE);
		return;
	}
	if (!mode)
	{
		viewer_show(v, "the display has no screen that a window could fill");
		return;
	}
	glfwGetWindowPos(v->window, &p->x, &p->y);
	glfwGetWindowSize(v->window, &p->width, &p->height);
	glfwSetWindowMonitor(v->window, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
}
