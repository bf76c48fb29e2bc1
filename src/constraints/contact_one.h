// SPDX-License-Identifier: MIT
// contact_one.h -- adds contacts to the counts of their bodies, and sets the rows that stay valid until the next
// layout.
#ifndef CONTACT_ONE_H
#define CONTACT_ONE_H
#include "constraints/contact_constraint.h"

INLINE int contact_in_use(const Pools* p, int slot) { return p->pair[slot].x >= 0; }

// Adds `by` (1 or -1; times KINEMATIC_CONTACT if a body is kinematic) to the contact counts of the bodies. Body 0, for
// a collidable without a body, and the second body of a contact with CONTACT_FIXED are not counted.
INLINE void contact_count(const Pools* p, Int2 bodies, Word flags, int by)
{
	GLOBAL int* count = flags & CONTACT_FIXED ? p->fixed_contacts : p->other_contacts;
	by *= flags & CONTACT_KINEMATIC ? KINEMATIC_CONTACT : 1;
	if (bodies.x > 0)
		atomic_add_int(count + bodies.x, by);
	if (bodies.y > 0 && !(flags & CONTACT_FIXED))
		atomic_add_int(count + bodies.y, by);
}

INLINE void contact_set_surface(const Pools* p, int i, Float4 surface)
{
	contact_row(p, friction, i) = surface.x;
	contact_rare(p, restitution, i) = surface.y;
	contact_rare(p, rolling, i) = surface.z;
	contact_rare(p, tangent_speed, i) = surface.w;
}

// Sets the rows of a contact at place i that are valid until the next layout.
INLINE void contact_set_place(const Pools* p, int slot, int i)
{
	p->contact_place_pair[i] = p->pair[slot];
	contact_set_surface(p, i, p->contact_surface[slot]);
}

#endif
