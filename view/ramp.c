// SPDX-License-Identifier: MIT
// ramp.c -- computes color ramps, the colors of numbers, for shaders and legends.
#include "view/ramp.h"

// from blue for bodies at rest over yellow to red for fast bodies
static const Color speeds[] = {{84, 115, 168}, {227, 184, 97}, {204, 71, 56}};

// The lightness rises, so that the ramp is readable in gray and with color blindness. The color at the end contrasts
// with dark and with light backgrounds.
static const Color forces[] = {{66, 70, 104}, {120, 64, 128}, {190, 70, 106}, {234, 114, 70}, {255, 201, 92}};

// hues that are easy to distinguish, with about the same lightness
static const Color places[] = {{205, 72, 66}, {222, 150, 58}, {128, 168, 74}, {58, 146, 168}, {112, 92, 176}};

static Color between(Color a, Color b, float share)
{
	const float from[3] = {(float)a.r, (float)a.g, (float)a.b}, to[3] = {(float)b.r, (float)b.g, (float)b.b};
	uint8_t channels[3];
	for (int k = 0; k < 3; ++k)
		channels[k] = (uint8_t)(from[k] + share * (to[k] - from[k]) + 0.5f);
	return (Color){channels[0], channels[1], channels[2]};
}

bool ramp_of(Paint paint, Color colors[RAMP_COLORS])
{
	const Color* stops = paint == PAINT_SPEED    ? speeds
	                     : paint == PAINT_FORCE  ? forces
	                     : paint == PAINT_ORIGIN ? places
	                                             : NULL;
	const int last = paint == PAINT_SPEED ? 2 : 4;
	for (int k = 0; k < RAMP_COLORS && stops; ++k)
	{
		int stop = k * last / (RAMP_COLORS - 1), next = stop < last ? stop + 1 : last;
		float share = (float)(k * last - stop * (RAMP_COLORS - 1)) / (float)(RAMP_COLORS - 1);
		colors[k] = between(stops[stop], stops[next], share);
	}
	return stops != NULL;
}

Color ramp_low(Color color) { return between((Color){0, 0, 0}, color, 0.55f); }
Color ramp_high(Color color) { return between((Color){255, 255, 255}, color, 0.6f); }

Color type_color(scree_body_type type)
{
	return type == SCREE_BODY_KINEMATIC ? (Color){92, 134, 190} : (Color){226, 160, 74};
}
