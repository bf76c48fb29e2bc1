// SPDX-License-Identifier: MIT
// tidy.h -- clears values that are left over from earlier and that nothing reads, so that snapshots do not depend on them.
#ifndef TIDY_H
#define TIDY_H
#include "stages/save/saved_bodies.h"
#include "stages/save/saved_collidables.h"
#include "stages/save/saved_joints.h"
#include "stages/save/saved_places.h"

KERNEL(body_tidy) { press_forget(p, i); }

// Clears an old box that the next step stores again before it reads it.
KERNEL(collidable_tidy)
{
	if (saved_renews(p->collidable_flags[i]))
		p->old_box[i] = p->box[i];
}

// Clears a free slot, kept impulses of a contact that has a place, and the pair of padding.
KERNEL(contact_tidy)
{
	const GLOBAL Counters* c = p->counters;
	if (i < c->contacts && p->pair[i].x < 0)
		contact_clear(p, i);
	else if (i < c->contacts && p->contact_place[i] >= 0)
		contact_forget(p, i);
	if (i < c->layout[CONSTRAINT_CONTACT].begin[COLORS + 1] && p->contact_place_slot[i] < 0)
		p->contact_place_pair[i] = make_int2(0, 0);
}

// Clears the kept values of a joint with a place, an event of an earlier step, and padding, whose rows follow from another
// joint.
KERNEL(joint_tidy)
{
	const GLOBAL Counters* c = p->counters;
	const JointEvent none = {0};
	if (i < c->joints && saved_joint_placed(p, i))
		joint_forget(p, i);
	if (i < c->joints && i >= c->joint_events)
		p->joint_event[i] = none;
	if (i < saved_joint_places(p) && p->joint_place_slot[i] < 0)
		joint_pad(p, i);
}

#endif
