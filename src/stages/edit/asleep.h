// SPDX-License-Identifier: MIT
// asleep.h -- puts a body to sleep, ends its sleep, and marks islands that wake in this step or the next one.
//
// A sleeping body has velocity 0, and both of its axes are locked, so that no stage moves it. The pool sleep contains
// the locks that it had before. No constraint refers to it. Its mass is unchanged, so other stages treat it as a body
// that can move.
#ifndef ASLEEP_H
#define ASLEEP_H
#include "dialect/dialect.h"
#include "pools/pools.h"

// Returns the number of the island of a sleeping body; -1 for an awake body.
INLINE int body_island(const Pools* p, int i) { return (p->sleep[i] & SLEEP_ISLAND) - 1; }

// Marks the island of a body, so that it wakes; an awake body counts as an island of its own. strength: WAKE_*.
INLINE void island_wake(const Pools* p, int i, int strength)
{
	int island = body_island(p, i);
	raise_int(p->wake + (island < 0 ? i : island), strength);
	raise_int(&p->counters->woken, 0x7fffffff);
}

// Marks the island of each of two bodies that sleeps.
INLINE void island_wake_both(const Pools* p, Int2 bodies)
{
	if (p->sleep[bodies.x])
		island_wake(p, bodies.x, WAKE_WORLD);
	if (p->sleep[bodies.y])
		island_wake(p, bodies.y, WAKE_WORLD);
}

INLINE int island_is_woken(const Pools* p, int island) { return read_shared(p->wake + island); }

// Ends the sleep of a body, and restores its locks.
INLINE void body_rise(const Pools* p, int i)
{
	int sleep = p->sleep[i];
	p->motion[i].free_x = sleep & SLEEP_LOCK_X ? 0.0f : 1.0f;
	p->motion[i].free_y = sleep & SLEEP_LOCK_Y ? 0.0f : 1.0f;
	p->sleep[i] = 0;
	p->still[i] = 0.0f;
}

// Puts a body to sleep in an island, or moves a sleeping body to another island.
INLINE void body_sleep(const Pools* p, int i, int island)
{
	int locks = p->sleep[i] & ~SLEEP_ISLAND;
	if (p->sleep[i] == 0)
		locks = (p->motion[i].free_x == 0.0f ? SLEEP_LOCK_X : 0) | (p->motion[i].free_y == 0.0f ? SLEEP_LOCK_Y : 0);
	p->sleep[i] = locks | (1 + island);
	p->still[i] = 0.0f;
	p->motion[i].free_x = 0.0f;
	p->motion[i].free_y = 0.0f;
	p->motion[i].fx = 0.0f;
	p->motion[i].fy = 0.0f;
	p->motion[i].torque = 0.0f;
	p->body[i].vx = 0.0f;
	p->body[i].vy = 0.0f;
	p->body[i].w = 0.0f;
}

#endif
