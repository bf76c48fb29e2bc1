// SPDX-License-Identifier: MIT
// draw_marks.c -- draws contacts, impulses, centers of mass and velocities.
#include "api/draw/draw_marks.h"
#include <math.h>
#include <stdio.h>

#define MOST_LENGTH 1e8f // m: bodies get no farther; a line of a larger impulse might end at infinity

void draw_contacts(const Pen* pen)
{
	for (int k = 0; k < pen->rows->contact_count; ++k)
	{
		const scree_contact* contact = pen->rows->contacts + k;
		for (int i = 0; i < contact->count; ++i)
		{
			const scree_contact_point* point = contact->points + i;
			uint32_t color = point->separation <= 0.0f ? SCREE_COLOR_TOUCHING : SCREE_COLOR_SPECULATIVE;
			pen_point(pen, point->point, LARGE_POINT, color);
			pen_ray(pen, point->point, contact->normal, pen->def->length, color);
		}
	}
}

// Draws an impulse on collidable b along a unit vector, with its size in N s.
static void draw_impulse(const Pen* pen, scree_vec at, scree_vec direction, float impulse, uint32_t color)
{
	float length = fminf(fmaxf(impulse * pen->def->impulse_scale, -MOST_LENGTH), MOST_LENGTH);
	if (impulse == 0.0f)
		return;
	pen_ray(pen, at, direction, length, color);
	pen_number(pen, (scree_vec){at.x + length * direction.x, at.y + length * direction.y}, fabsf(impulse), "N s",
	           color);
}

void draw_impulses(const Pen* pen)
{
	for (int k = 0; k < pen->rows->contact_count; ++k)
	{
		const scree_contact* contact = pen->rows->contacts + k;
		scree_vec tangent = {contact->normal.y, -contact->normal.x}; // as in contact_constraint.h
		for (int i = 0; i < contact->count; ++i)
		{
			const scree_contact_point* point = contact->points + i;
			draw_impulse(pen, point->point, contact->normal, point->normal_impulse, SCREE_COLOR_IMPULSE);
			draw_impulse(pen, point->point, tangent, point->tangent_impulse, SCREE_COLOR_FRICTION);
		}
	}
}

static void draw_center(const Pen* pen, int body)
{
	const Float4* pose = pen->rows->poses + body;
	pen_point(pen, (scree_vec){pose->x, pose->y}, SMALL_POINT, SCREE_COLOR_CENTER);
	pen_ray(pen, (scree_vec){pose->x, pose->y}, (scree_vec){pose->z, pose->w}, pen->def->length, SCREE_COLOR_CENTER);
}

static void draw_speed(const Pen* pen, int body)
{
	const BodyState* state = pen->rows->states + body;
	scree_vec from = {pen->rows->poses[body].x, pen->rows->poses[body].y};
	float scale = pen->def->speed_scale;
	scree_vec to = {from.x + scale * state->vx, from.y + scale * state->vy};
	double speed = sqrt((double)state->vx * state->vx + (double)state->vy * state->vy);
	// a disabled body keeps a velocity that it does not have
	if (speed == 0.0 || pen->world->host_bodies[body].disabled)
		return;
	pen_line(pen, from, to, SCREE_COLOR_SPEED);
	pen_number(pen, to, (float)speed, "m/s", SCREE_COLOR_SPEED);
}

static void draw_index(const Pen* pen, int body)
{
	scree_vec at = {pen->rows->poses[body].x, pen->rows->poses[body].y};
	char index[16];
	if (!pen_labels(pen, at))
		return;
	snprintf(index, sizeof index, "%d", body);
	pen_label(pen, at, index, SCREE_COLOR_CENTER);
}

void draw_bodies(const Pen* pen)
{
	const Slots* slots = &pen->world->bodies;
	for (int k = 1; k < slots->used; ++k)
	{
		if (!slots_in_use(slots, k))
			continue;
		if (pen_draws(pen, SCREE_DRAW_CENTERS))
			draw_center(pen, k);
		draw_index(pen, k);
	}
	for (int k = 1; k < slots->used && pen_draws(pen, SCREE_DRAW_SPEEDS); ++k)
		if (slots_in_use(slots, k))
			draw_speed(pen, k);
}
