// SPDX-License-Identifier: MIT
// style.c -- reads the style of a picture: the coloring of bodies, and the layers over them.
#include "view/style.h"
#include "scene/scan_picture.h"
#include "view/shader.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

const char* const paint_names[PAINTS] = {
#define X(enumerator, name, help) name,
#include "view/paints.def"
#undef X
};
const char* const layer_names[LAYERS] = {
#define X(name, key, shown, help) #name,
#include "view/layers.def"
#undef X
};

Color graph_color(int color)
{
	if (color >= GRAPH_COLORS - 1)
		return (Color){40, 40, 44};
	const float phases[3] = {0.02f, 0.69f, 0.36f};
	uint8_t channels[3];
	for (int k = 0; k < 3; ++k)
	{
		float turn = (float)color * 0.61803399f + phases[k];
		float hue = fabsf((turn - floorf(turn)) * 6.0f - 3.0f) - 1.0f;
		hue = hue < 0.0f ? 0.0f : hue > 1.0f ? 1.0f : hue;
		channels[k] = (uint8_t)(255.0f * 0.92f * (0.82f + 0.62f * (hue - 0.82f)));
	}
	return (Color){channels[0], channels[1], channels[2]};
}

static void list_names(const char* const* names, int count, char* text, size_t size)
{
	size_t length = 0;
	*text = 0;
	for (int k = 0; k < count && length < size; ++k)
		length += (size_t)snprintf(text + length, size - length, "%s%s", k ? ", " : "", names[k]);
}

int find_name(const char* const* names, int count, const char* text, size_t length)
{
	for (int k = 0; k < count; ++k)
		if (strlen(names[k]) == length && strncmp(names[k], text, length) == 0)
			return k;
	return -1;
}

bool style_read(Style* style, const char* paint, const char* layers, char* sentence)
{
	char names[200];
	*style = (Style){.detail = 1.0f, .rays = RAYS_DRAWN};
	style->layers[LAYER_joints] = style->layers[LAYER_fields] = style->layers[LAYER_sensors] = !layers;
	style->layers[LAYER_rays] = !layers;
	int found = paint ? find_name(paint_names, PAINTS, paint, strlen(paint)) : PAINT_KIND;
	if (found < 0)
	{
		list_names(paint_names, PAINTS, names, sizeof names);
		snprintf(sentence, SENTENCE, "--paint %.60s: must be one of %s", paint, names);
		return false;
	}
	style->paint = (Paint)found;
	style->graph = style->paint == PAINT_SOLVER;
	while (layers && *layers)
	{
		size_t length = strcspn(layers, ",");
		found = find_name(layer_names, LAYERS, layers, length);
		if (found < 0)
		{
			list_names(layer_names, LAYERS, names, sizeof names);
			snprintf(sentence, SENTENCE, "--layers %.*s: must be some of %s, with commas between them",
			         (int)(length < 60 ? length : 60), layers, names);
			return false;
		}
		style->layers[found] = true;
		layers += length + (layers[length] == ',');
	}
	return true;
}
