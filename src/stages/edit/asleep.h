// SPDX-License-Identifier: MIT
// asleep.h -- puts a body to sleep, ends its sleep, and marks islands that wake in this step or the next one.
//
// A sleeping body has velocity 0, and both of its axes are locked, so that no stage moves it. The pool sleep contains
// the locks that it had before. No constraint refers to it. Its mass is unchanged, so other stages treat it as a body
// that can move.
#ifndef ASLEEP_H
#define ASLEEP_H
#include "dialect/dialect.h"
#include "pools/bays.h"

INLINE int body_is_moving(const Pools* p, int i)
{
	BodyState body = p->body[i];
	return body.vx != 0.0f || body.vy != 0.0f || body.w != 0.0f;
}

// Returns the island of a sleeping body, a body of its world; -1 for an awake body. The pool contains the index within the
// bay.
INLINE int body_island(const Pools* p, int i)
{
	int island = (p->sleep[i] & SLEEP_ISLAND) - 1;
	return island < 0 ? -1 : island + bay_first_body(p, i);
}

// Returns the time of rest of a body, or STILL_*. Other work-items may clear STILL_MADE at the same time (island_wake).
INLINE float body_still(const Pools* p, int i) { return bits_float(read_shared((GLOBAL int*)p->still + i)); }

// Marks the island of a sleeping body. strength: WAKE_*.
INLINE void island_wake(const Pools* p, int i, int strength)
{
	if (body_still(p, i) == STILL_MADE)
		write_shared_word((GLOBAL Word*)p->still + i, 0); // the bits of 0.0f
	raise_int(p->wake + body_island(p, i), strength);
	raise_int(&p->counters->woken, 0x7fffffff);
}

// Returns the mark of the island of a body, WAKE_*, or 0.
INLINE int body_mark(const Pools* p, int i)
{
	int island = body_island(p, i);
	return island < 0 || body_still(p, i) == STILL_MADE ? 0 : read_shared(p->wake + island);
}

// Returns whether a body sleeps, and is not marked to wake.
INLINE int body_sleeps_on(const Pools* p, int i) { return p->sleep[i] != 0 && body_mark(p, i) == 0; }

// Keeps an awake body from falling asleep in this step, because it may have lost its support. If it falls, it moves
// faster than the threshold before the next search; if it rests on something else, it falls asleep 8 steps later.
INLINE void body_unsettle(const Pools* p, int i)
{
	if (body_still(p, i) >= SLEEP_TIME)
		write_shared_word((GLOBAL Word*)p->still + i, float_bits(STILL_ALMOST));
}

// Ends the rest of an awake body.
INLINE void body_restless(const Pools* p, int i)
{
	if (body_still(p, i) > 0.0f)
		write_shared_word((GLOBAL Word*)p->still + i, 0); // the bits of 0.0f
}

// Marks the islands of those of two bodies that sleep.
INLINE void island_wake_both(const Pools* p, Int2 bodies)
{
	if (p->sleep[bodies.x])
		island_wake(p, bodies.x, WAKE_WORLD);
	if (p->sleep[bodies.y])
		island_wake(p, bodies.y, WAKE_WORLD);
}

// Does the same when a contact ends; an awake body stays awake in this step. flags: flags of the contact before; an
// overlap, or a pending contact, wakes nothing. A body that was created asleep since the last step did not touch
// anything: the touch was that of an earlier body of its slot.
INLINE void island_wake_parted(const Pools* p, Int2 bodies, Word flags)
{
	if (!p->step.sleep || (flags & (CONTACT_TOUCHING | CONTACT_DETECTED | CONTACT_PENDING)) != CONTACT_TOUCHING)
		return;
	body_unsettle(p, bodies.x);
	body_unsettle(p, bodies.y);
	if (p->sleep[bodies.x] && body_still(p, bodies.x) != STILL_MADE)
		island_wake(p, bodies.x, WAKE_WORLD);
	if (p->sleep[bodies.y] && body_still(p, bodies.y) != STILL_MADE)
		island_wake(p, bodies.y, WAKE_WORLD);
}

// Wakes the island of a body that the user destroys.
INLINE void body_gone_wake(const Pools* p, int i)
{
	if (p->sleep[i] && body_still(p, i) != STILL_MADE)
		island_wake(p, i, WAKE_USER);
}

// Ends the sleep of a body, and restores its locks.
INLINE void body_rise(const Pools* p, int i)
{
	int sleep = p->sleep[i];
	p->motion[i].free_x = sleep & SLEEP_LOCK_X ? 0.0f : 1.0f;
	p->motion[i].free_y = sleep & SLEEP_LOCK_Y ? 0.0f : 1.0f;
	p->sleep[i] = 0;
	p->still[i] = 0.0f;
}

// Marks a body as standing: its pose is not interpolated until the next step that visits it.
INLINE void body_stand(const Pools* p, int i) { p->start_pose[i] = make_float4(0.0f, 0.0f, 0.0f, 0.0f); }

// Puts a body to sleep in an island, or moves a sleeping body to another island.
INLINE void body_sleep(const Pools* p, int i, int island)
{
	int locks = p->sleep[i] & ~SLEEP_ISLAND;
	if (p->sleep[i] == 0)
		locks = (p->motion[i].free_x == 0.0f ? SLEEP_LOCK_X : 0) | (p->motion[i].free_y == 0.0f ? SLEEP_LOCK_Y : 0);
	p->sleep[i] = locks | (1 + island - bay_first_body(p, i));
	p->still[i] = 0.0f;
	p->motion[i].free_x = 0.0f;
	p->motion[i].free_y = 0.0f;
	p->motion[i].fx = 0.0f;
	p->motion[i].fy = 0.0f;
	p->motion[i].torque = 0.0f;
	p->body[i].vx = 0.0f;
	p->body[i].vy = 0.0f;
	p->body[i].w = 0.0f;
	body_stand(p, i);
}

#endif
