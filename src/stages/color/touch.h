// SPDX-License-Identifier: MIT
// touch.h -- lists begins and ends of touches, and hits, as events for the user.
//
// A touch begins in the first step in which the surfaces push each other or overlap, and ends when the contact loses
// its points or is destroyed. So a body that rests or rolls begins no second touch, even if its impulses vary.
#ifndef TOUCH_H
#define TOUCH_H
#include "constraints/constraint_kinds.h"
#include "stages/color/edge.h"
#include "stages/edit/active.h"
#include "stages/edit/asleep.h"
#include "stages/geometry/box.h"

// Returns the report bits of a contact from those of its collidables.
INLINE Word touch_reports(const Pools* p, Int2 pair)
{
	if (!p->step.reports)
		return 0;
	return ((p->filter[pair.x].reports | p->filter[pair.y].reports) << CONTACT_REPORT) & CONTACT_REPORTS;
}

// Lists the end of the touch of a contact, if one has begun. The contact has lost its points, or is being destroyed.
// flags: flags of the contact.
INLINE void touch_end(const Pools* p, Int2 pair, Word flags)
{
	if (flags & CONTACT_TOUCHED)
		p->touch_ended[atomic_add_int(&p->counters->touches_ended, 1)] = (Word64)pair.x << 32 | (Word64)pair.y;
}

// Ends contact i and restarts it as if its boxes met for the first time. flags: old flags of the contact; kept: flags
// to set in addition to CONTACT_FRESH and the old CONTACT_FIXED bits.
RARE void contact_anew(const Pools* p, int i, Word flags, Word kept)
{
	contact_end(p, i);
	if (flags & CONTACT_ASLEEP)
		contact_forget(p, i);
	if (p->step.sleep)
		active_touch(p, GROUPS_OF_CONTACTS, i);
	island_wake_parted(p, p->contact_bodies[i], flags);
	touch_end(p, p->pair[i], flags);
	p->contact_flags[i] = CONTACT_FRESH | (flags & CONTACT_FIXED) | kept;
	p->contact_feature[i] = make_int2(-1, -1);
}

// Ends the touch of a contact whose boxes parted, before the narrow phase releases the contact. These lines inside the
// kernel narrow_phase would make it slower by a fifth on an H200, even in worlds without events.
KERNEL(touch_part)
{
	Word flags = p->contact_flags[i];
	if (!(flags & CONTACT_TOUCHED) || !box_parted(p, p->pair[i]))
		return;
	touch_end(p, p->pair[i], flags);
	p->contact_flags[i] = flags & ~CONTACT_TOUCHED;
}

// Item: a contact, after the solve. Lists the begin or the end of its touch, and its hit.
KERNEL(touch)
{
	Word flags = p->contact_flags[i];
	if ((flags & (CONTACT_TOUCHED | CONTACT_COUNT)) == CONTACT_TOUCHED)
	{
		touch_end(p, p->pair[i], flags);
		p->contact_flags[i] = flags & ~CONTACT_TOUCHED;
		return;
	}
	int c = flags & CONTACT_REPORTS ? p->contact_place[i] : -1;
	if (c < 0)
		return;
	float total1 = contact_rare(p, total_impulse1, c), total2 = contact_rare(p, total_impulse2, c);
	float speed = maximum(contact_rare(p, approach1, c), contact_rare(p, approach2, c)), pushed = total1 + total2;
	if (!(pushed > 0.0f) && !(flags & MANIFOLD_OVERLAPS))
		return;
	if ((flags & REPORT_TOUCHES << CONTACT_REPORT) && !(flags & CONTACT_TOUCHED))
	{
		p->contact_flags[i] = flags | CONTACT_TOUCHED;
		p->touch_began[atomic_add_int(&p->counters->touches_began, 1)] = i;
	}
	if ((flags & REPORT_HITS << CONTACT_REPORT) && speed > p->step.hit_speed && pushed > p->step.hit_impulse)
		p->hit[atomic_add_int(&p->counters->hits, 1)] = i;
}

#endif
