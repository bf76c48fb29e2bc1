// SPDX-License-Identifier: MIT
// auto.c -- implements device "auto" for a page, where worlds stay on the CPU, the only device. Replaces
// src/world/device/auto.c.
#include "world/device/auto.h"

void auto_open(scree_world* world, TestWorlds* test)
{
	(void)world;
	(void)test;
}

void auto_close(scree_world* world) { (void)world; }

bool auto_choose(scree_world* world)
{
	(void)world;
	return false;
}
scree_status auto_change(scree_world* world)
{
	(void)world;
	return SCREE_OK;
}

double auto_clock(void) { return 0; }

void auto_count(scree_world* world, double since)
{
	(void)world;
	(void)since;
}
