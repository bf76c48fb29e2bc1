// SPDX-License-Identifier: MIT
// legend.c -- writes legends: explanations of the colors of a picture, with numbers and units.
#include "view/legend.h"
#include "view/ramp.h"
#include "view/theme.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

static void add_tick(Legend* legend, float at, const char* text)
{
	legend->ticks[legend->tick_count].at = at;
	snprintf(legend->ticks[legend->tick_count++].text, sizeof legend->ticks->text, "%s", text);
}

// Writes a force in N as a short text: "0.5", "250", "20 k".
static void write_force(char text[20], double force)
{
	if (force >= 1.0e6)
		snprintf(text, 20, "%.3g M", force * 1.0e-6);
	else if (force >= 1.0e4)
		snprintf(text, 20, "%.3g k", force * 1.0e-3);
	else
		snprintf(text, 20, force >= 100.0 ? "%.0f" : "%.3g", force);
}

// Adds three ticks. The position of a force in the color bar is the square root of force / largest, as in the colors.
static void add_force_ticks(Legend* legend, float largest)
{
	for (int k = 0; k < 3; ++k)
	{
		char text[20];
		float share = 0.5f * (float)k;
		write_force(text, (double)(share * share * largest));
		add_tick(legend, share, text);
	}
}

static void add_speeds(Legend* legend)
{
	const float speeds[] = {0.0f, 1.0f, 3.0f, 9.0f};
	for (int k = 0; k < 4; ++k)
	{
		char text[20];
		snprintf(text, sizeof text, "%.0f", (double)speeds[k]);
		add_tick(legend, speeds[k] / (speeds[k] + RAMP_SPEED), text);
	}
	add_tick(legend, 1.0f, "\u221e");
}

// Adds an entry for each graph color of a touching contact, in ascending order, at most LEGEND_COLORS.
static void add_graph(Legend* legend, const Renderer* r)
{
	bool used[GRAPH_COLORS] = {false};
	for (int k = 0; k < r->contact_count; ++k)
		if (r->contacts[k].color >= 0 && r->contacts[k].color < GRAPH_COLORS)
			used[r->contacts[k].color] = true;
	for (int k = 0; k < GRAPH_COLORS && legend->color_count < LEGEND_COLORS; ++k)
	{
		if (!used[k])
			continue;
		legend->low[legend->color_count] = legend->high[legend->color_count] = graph_color(k);
		snprintf(legend->ticks[legend->color_count].text, sizeof legend->ticks->text,
		         k == GRAPH_COLORS - 1 ? "hub" : "%d", k);
		++legend->color_count;
	}
	legend->tick_count = legend->color_count;
}

static void add_types(Legend* legend, const Style* style)
{
	static const char* const names[] = {"static", "kinematic", "dynamic"};
	legend->color_count = legend->tick_count = 3;
	for (int k = 0; k < 3; ++k)
	{
		legend->low[k] = k == SCREE_BODY_STATIC ? theme_of(style->dark)->still : type_color((scree_body_type)k);
		legend->high[k] = legend->low[k];
		snprintf(legend->ticks[k].text, sizeof legend->ticks->text, "%s", names[k]);
	}
}

bool legend_of_paint(Legend* legend, const Renderer* r, const Style* style)
{
	static const char* const titles[PAINTS] = {
	    [PAINT_SPEED] = "speed, m/s",
	    [PAINT_SOLVER] = "group of the contacts in the solver",
	    [PAINT_FORCE] = "contact force, N",
	    [PAINT_ORIGIN] = "where bodies began",
	    [PAINT_TYPE] = "type",
	};
	*legend = (Legend){.blocks = style->paint == PAINT_SOLVER || style->paint == PAINT_TYPE};
	if (!titles[style->paint])
		return false;
	snprintf(legend->title, sizeof legend->title, "%s", titles[style->paint]);
	if (ramp_of(style->paint, legend->low))
		legend->color_count = RAMP_COLORS;
	memcpy(legend->high, legend->low, sizeof legend->high);
	if (style->paint == PAINT_SPEED)
		add_speeds(legend);
	if (style->paint == PAINT_FORCE)
		add_force_ticks(legend, r->tables.force_range);
	if (style->paint == PAINT_SOLVER)
		add_graph(legend, r);
	if (style->paint == PAINT_TYPE)
		add_types(legend, style);
	for (int k = 0; k < legend->tick_count && legend->blocks; ++k)
		legend->ticks[k].at = ((float)k + 0.5f) / (float)legend->tick_count;
	if (style->paint != PAINT_ORIGIN)
		return legend->color_count > 0;
	for (int k = 0; k < RAMP_COLORS; ++k)
	{
		legend->high[k] = ramp_high(legend->low[k]);
		legend->low[k] = ramp_low(legend->low[k]);
	}
	add_tick(legend, 0.0f, "left");
	add_tick(legend, 1.0f, "right");
	return true;
}

bool legend_of_joints(Legend* legend, const Renderer* r, const Style* style)
{
	*legend = (Legend){.title = "force of joints, N", .color_count = RAMP_COLORS};
	if (!style->layers[LAYER_joints] || r->joint_lines.links.count == 0)
		return false;
	for (int k = 0; k < RAMP_COLORS; ++k)
		legend->low[k] = legend->high[k] = joint_color((float)k / (float)(RAMP_COLORS - 1), style->dark);
	add_force_ticks(legend, r->joint_lines.largest);
	return true;
}
