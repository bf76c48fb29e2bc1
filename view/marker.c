// SPDX-License-Identifier: MIT
// marker.c -- draws contacts as strokes: points, normals, impulses.
#include "view/marker.h"
#include <math.h>

#define DOT     5.0f  // px: diameter of a contact point
#define NORMAL  14.0f // px: length of a normal
#define IMPULSE 60.0f // px: maximum length of the line of the largest impulse in view
#define FEW     4.0f  // px: minimum length of the line of the largest impulse in view
#define DENSE   20.0f // px: lines have no rims if the line of the largest impulse is shorter than this
#define LONG    1.6f  // length of the line of the largest impulse, divided by the reach of a typical body
#define HALO    2.6f  // px: additional width of the rims of lines

static const Color red = {187, 53, 44}, pale = {232, 150, 140}, slate = {52, 62, 80}, mist = {206, 214, 228};

// a dark line with a light rim is visible on bodies of all colors
static const Color core = {38, 20, 58}, halo = {255, 250, 235};

// Returns a darker color than `color`, because a dot is small and needs more contrast than a body.
static Color darker(Color color)
{
	return (Color){(uint8_t)(color.r * 3 / 4), (uint8_t)(color.g * 3 / 4), (uint8_t)(color.b * 3 / 4)};
}

static bool is_inside(scree_box box, scree_vec p)
{
	return p.x >= box.lower.x && p.x <= box.upper.x && p.y >= box.lower.y && p.y <= box.upper.y;
}

static float largest_impulse(const scree_contact* contacts, int count, scree_box box)
{
	float largest = 1.0e-9f;
	for (int k = 0; k < count; ++k)
		for (int n = 0; n < contacts[k].count; ++n)
			if (is_inside(box, contacts[k].points[n].point))
				largest = fmaxf(largest, contacts[k].points[n].normal_impulse);
	return largest;
}

static scree_vec along(scree_vec from, scree_vec direction, float length)
{
	return (scree_vec){from.x + direction.x * length, from.y + direction.y * length};
}

// Adds strokes for impulses: first the rims of all lines, then the lines. If the longest line is shorter than DENSE,
// adds only thin lines.
static void mark_impulses(Strokes* strokes, const scree_contact* contacts, int count, const Camera* camera, float size)
{
	scree_box box = camera_box(camera);
	float largest = largest_impulse(contacts, count, box), most = LONG * size * camera->scale;
	float whole = fminf(fmaxf(most, FEW), IMPULSE) / camera->scale;
	bool dense = most < DENSE;
	for (int line = dense; line < 2; ++line)
	{
		float width = dense ? 1.0f : line ? 2.0f : 2.0f + HALO;
		Color color = line ? core : halo;
		int opacity = dense || !line ? 150 : 255;
		for (int k = 0; k < count; ++k)
		{
			scree_vec normal = contacts[k].normal, across = {normal.y, -normal.x}; // direction of tangent impulses
			for (int n = 0; n < contacts[k].count; ++n)
			{
				const scree_contact_point* p = &contacts[k].points[n];
				if (!is_inside(box, p->point))
					continue;
				// the square root makes small impulses visible in comparison with the largest
				float length = whole * sqrtf(fmaxf(p->normal_impulse, 0.0f) / largest);
				float slip = whole * copysignf(sqrtf(fabsf(p->tangent_impulse) / largest), p->tangent_impulse);
				strokes_add(strokes, p->point, along(p->point, across, slip), width, color, opacity * 3 / 5);
				strokes_add(strokes, p->point, along(p->point, normal, length), width, color, opacity);
			}
		}
	}
}

void mark_contacts(Strokes* strokes, const scree_contact* contacts, int count, const Camera* camera, const Style* style,
                   float size)
{
	scree_box box = camera_box(camera);
	float pixel = 1.0f / camera->scale;
	const bool* layers = style->layers;
	if (layers[LAYER_impulses])
		mark_impulses(strokes, contacts, count, camera, size);
	for (int k = 0; k < count; ++k)
	{
		const scree_contact* c = &contacts[k];
		for (int n = 0; n < c->count; ++n)
		{
			const scree_contact_point* p = &c->points[n];
			if (!is_inside(box, p->point))
				continue;
			if (layers[LAYER_normals])
				strokes_add(strokes, p->point, along(p->point, c->normal, NORMAL * pixel), 1.2f,
				            style->dark ? mist : slate, 220);
			if (layers[LAYER_contacts])
			{
				Color color = style->graph ? darker(graph_color(c->color)) : p->separation < 0.0f ? red : pale;
				strokes_add(strokes, p->point, p->point, DOT, color, 255);
			}
		}
	}
}
