// SPDX-License-Identifier: MIT
// marker.c -- draws contacts as strokes: points, normals, impulses.
#include "view/marker.h"
#include <math.h>

#define DOT     5.0f  // px: a contact point
#define NORMAL  14.0f // px: a normal
#define IMPULSE 60.0f // px: the largest impulse in view

static const Color red = {187, 53, 44}, pale = {232, 150, 140}, slate = {52, 62, 80}, green = {30, 122, 84};

// A dot is small and needs more contrast than a body.
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

void mark_contacts(Strokes* strokes, const scree_contact* contacts, int count, const Camera* camera, const Style* style)
{
	scree_box box = camera_box(camera);
	float pixel = 1.0f / camera->scale, largest = 1.0f;
	const bool* layers = style->layers;
	if (layers[LAYER_impulses])
		largest = largest_impulse(contacts, count, box);
	for (int k = 0; k < count; ++k)
	{
		const scree_contact* c = &contacts[k];
		scree_vec across = {-c->normal.y, c->normal.x};
		for (int n = 0; n < c->count; ++n)
		{
			const scree_contact_point* p = &c->points[n];
			if (!is_inside(box, p->point))
				continue;
			if (layers[LAYER_normals])
				strokes_add(strokes, p->point, along(p->point, c->normal, NORMAL * pixel), 1.2f, slate, 220);
			if (layers[LAYER_impulses])
			{
				// the square root makes small impulses visible beside large ones
				float length = IMPULSE * pixel * sqrtf(fmaxf(p->normal_impulse, 0.0f) / largest);
				float slip =
				    IMPULSE * pixel * copysignf(sqrtf(fabsf(p->tangent_impulse) / largest), p->tangent_impulse);
				strokes_add(strokes, p->point, along(p->point, c->normal, length), 1.6f, green, 200);
				strokes_add(strokes, p->point, along(p->point, across, slip), 1.6f, green, 120);
			}
			if (layers[LAYER_contacts])
			{
				Color color = style->graph ? darker(graph_color(c->color)) : p->separation < 0.0f ? red : pale;
				strokes_add(strokes, p->point, p->point, DOT, color, 255);
			}
		}
	}
}
