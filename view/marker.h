// SPDX-License-Identifier: MIT
// marker.h -- draws contacts as strokes: points, normals, impulses.
#ifndef MARKER_H
#define MARKER_H
#include "view/stroke.h"
#include "view/style.h"

// Adds strokes for the contacts in view. size: reach of a typical body, m.
void mark_contacts(Strokes* strokes, const scree_contact* contacts, int count, const Camera* camera, const Style* style,
                   float size);

#endif
