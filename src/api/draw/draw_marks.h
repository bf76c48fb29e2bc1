// SPDX-License-Identifier: MIT
// draw_marks.h -- draws contacts, impulses, centers of mass and velocities.
#ifndef DRAW_MARKS_H
#define DRAW_MARKS_H
#include "api/draw/draw_pen.h"

void draw_contacts(const Pen* pen);
void draw_impulses(const Pen* pen);

// Draws the centers of mass, the indices of bodies and the velocities: those of the three that the flags name.
void draw_bodies(const Pen* pen);

#endif
