// SPDX-License-Identifier: MIT
// joint_one.h -- reads and stores the counts of turns and laps of a joint (angle, coupling, path), one joint at a time.
#ifndef JOINT_ONE_H
#define JOINT_ONE_H
#include "constraints/coupling_one.h"
#include "constraints/path_one.h"

// rad: Returns the last angle of a joint over all turns; 0 for a new joint. It is stored at the joint's place, or at
// the slot if the joint has no place.
INLINE float joint_turned_last(const Pools* p, int slot)
{
	int place = p->joint_place[slot];
	if (p->joint_flags[slot] & JOINT_NEW)
		return 0.0f;
	return place < 0 ? p->joint_kept[slot].turned : joint_row(p, turned, place);
}

INLINE CouplingCount coupling_count_last(const Pools* p, int slot)
{
	int place = p->joint_place[slot];
	if (p->joint_flags[slot] & JOINT_NEW)
		return coupling_count_new(p, slot);
	if (place >= 0)
		return coupling_count_at(p, place);
	const GLOBAL JointRareKept* kept = p->joint_rare_kept + slot;
	CouplingCount count = {{kept->angle_a, kept->angle_b}, {kept->turns_a, kept->turns_b}, kept->geared};
	return count;
}

// Stores the counts at a place, or at the slot of a joint without a place.
INLINE void coupling_count_store(const Pools* p, int slot, int place, const CouplingCount* count)
{
	GLOBAL JointRareKept* kept = p->joint_rare_kept + slot;
	if (place >= 0)
	{
		coupling_count_put(p, place, count);
		return;
	}
	kept->angle_a = count->angle[0];
	kept->angle_b = count->angle[1];
	kept->turns_a = count->turns[0];
	kept->turns_b = count->turns[1];
	kept->geared = count->geared;
}

INLINE PathCount path_count_last(const Pools* p, int slot)
{
	int place = p->joint_place[slot];
	if (p->joint_flags[slot] & JOINT_NEW)
		return path_count_new();
	if (place >= 0)
		return path_count_at(p, place);
	const GLOBAL JointRareKept* kept = p->joint_rare_kept + slot;
	PathCount count = {kept->path_segment, kept->path_laps, kept->path_seeks};
	return count;
}

INLINE void path_count_store(const Pools* p, int slot, int place, const PathCount* count)
{
	GLOBAL JointRareKept* kept = p->joint_rare_kept + slot;
	if (place >= 0)
	{
		path_count_put(p, place, count);
		return;
	}
	kept->path_segment = count->segment;
	kept->path_laps = count->laps;
	kept->path_seeks = count->seeks;
}

INLINE void joint_set_place(const Pools* p, int slot, int i)
{
	(void)p;
	(void)slot;
	(void)i;
}

INLINE int joint_in_use(const Pools* p, int slot) { return (p->joint_flags[slot] & JOINT_THERE) != 0; }

#endif
