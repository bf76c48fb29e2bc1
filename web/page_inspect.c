// SPDX-License-Identifier: MIT
// page_inspect.c -- returns data that the visitor of the page inspects: numbers of bodies, legends. The world does not
// change.
//
// Coordinates are px of the picture, from its upper left corner.
#include "view/legend.h"
#include "view/numbers.h"
#include "web/page.h"
#include <stdarg.h>
#include <stdio.h>

static const char* join_lines(const Numbers* numbers)
{
	size_t length = 0;
	for (int k = 0; k < numbers->count; ++k)
		length += (size_t)snprintf(page.text + length, sizeof page.text - length, k ? "\n%s" : "%s", numbers->list[k]);
	return page.text;
}

// In a wall no body is found.
static bool choose(Inspected* inspected, float x, float y, float reach)
{
	scree_collidable found = SCREE_NULL_COLLIDABLE;
	bool good = !page.player.world || page.wall.batch ||
	            page_check(inspect_find(page.player.world, camera_point(&page.camera, x, y), reach / page.camera.scale,
	                                    &found));
	inspect_choose(inspected, page.scene, page.player.world, found);
	return good && inspect_any(inspected);
}

// Returns the few most important numbers of the body within `reach` (px) of a point; empty if there is no such body.
EMSCRIPTEN_KEEPALIVE const char* page_hover(float x, float y, float reach)
{
	Numbers numbers;
	if (!choose(&page.hovered, x, y, reach) || !page_check(inspect_read(&page.hovered, page.scene, page.player.world)))
		return "";
	numbers_write_short(&page.hovered, &numbers);
	return join_lines(&numbers);
}

// Selects the body within `reach` (px) of a point. If there is no such body, clears the selection and returns false.
EMSCRIPTEN_KEEPALIVE bool page_select(float x, float y, float reach)
{
	page.follows = false;
	return choose(&page.selected, x, y, reach);
}

EMSCRIPTEN_KEEPALIVE void page_forget(void)
{
	page.follows = false;
	page.selected = (Inspected){0};
}

// Reads the numbers of the selected body. Returns false on failure, if no body is selected, or if the body no longer
// exists. In the last case page_selected returns a line that reports this.
EMSCRIPTEN_KEEPALIVE bool page_read_selected(void)
{
	return inspect_any(&page.selected) && page_check(inspect_read(&page.selected, page.scene, page.player.world)) &&
	       !page.selected.gone;
}

// Returns the numbers of the selected body at the last page_read_selected. few: true for only the most important
// numbers.
EMSCRIPTEN_KEEPALIVE const char* page_selected(bool few)
{
	Numbers numbers;
	if (few && !page.selected.gone)
		numbers_write_short(&page.selected, &numbers);
	else
		numbers_write(&page.selected, &numbers);
	return join_lines(&numbers);
}

// Appends formatted text to page.text. length: current length of page.text. Returns the new length.
static size_t write(size_t length, const char* format, ...) __attribute__((format(printf, 2, 3)));
static size_t write(size_t length, const char* format, ...)
{
	va_list values;
	va_start(values, format);
	int more = vsnprintf(page.text + length, sizeof page.text - length, format, values);
	va_end(values);
	length += more > 0 ? (size_t)more : 0;
	return length < sizeof page.text ? length : sizeof page.text - 1;
}

static size_t write_colors(size_t length, const char* name, const Color* colors, int count)
{
	length = write(length, ",\"%s\":[", name);
	for (int k = 0; k < count; ++k)
		length = write(length, "%s\"#%02x%02x%02x\"", k ? "," : "", colors[k].r, colors[k].g, colors[k].b);
	return write(length, "]");
}

// Returns a legend as JSON, for the colors of joints if `joints` is true, else for the colors of bodies; empty if there
// is no such legend.
EMSCRIPTEN_KEEPALIVE const char* page_legend(bool joints)
{
	Legend legend;
	if (!page.drawn || !page.player.world ||
	    !(joints ? legend_of_joints : legend_of_paint)(&legend, &page.renderer, &page.style))
		return "";
	size_t length = write(0, "{\"title\":\"%s\",\"blocks\":%s", legend.title, legend.blocks ? "true" : "false");
	length = write_colors(length, "low", legend.low, legend.color_count);
	length = write_colors(length, "high", legend.high, legend.color_count);
	for (int k = 0; k < legend.tick_count; ++k)
		length = write(length, "%s[%.4f,\"%s\"]", k ? "," : ",\"ticks\":[", (double)legend.ticks[k].at,
		               legend.ticks[k].text);
	write(length, legend.tick_count > 0 ? "]}" : "}");
	return page.text;
}
