// SPDX-License-Identifier: MIT
// contact_one.h -- what takes one contact at a time: rows that the layout sets.
#ifndef CONTACT_ONE_H
#define CONTACT_ONE_H
#include "constraints/contact.h"

// Whether a slot holds a contact.
INLINE int contact_in_use(const Pools* p, int slot) { return p->pair[slot].x >= 0; }

// Rows that come from the surfaces of the two collidables.
INLINE void contact_set_surface(const Pools* p, int i, Float4 surface)
{
	contact_row(p, friction, i) = surface.x;
	contact_rare(p, restitution, i) = surface.y;
	contact_rare(p, rolling, i) = surface.z;
	contact_rare(p, tangent_speed, i) = surface.w;
}

// Rows that are valid until the next layout.
INLINE void contact_set_place(const Pools* p, int slot, int i)
{
	p->contact_place_pair[i] = p->pair[slot];
	contact_set_surface(p, i, p->contact_surface[slot]);
}

#endif
