// SPDX-License-Identifier: MIT
// exclusions.h -- keeps the pairs of bodies that the user excluded from touching: slots, lists by body, and the upload.
#ifndef EXCLUSIONS_H
#define EXCLUSIONS_H
#include "world/world.h"

// Returns the slot of the exclusion to which an end belongs. End 1 + 2 * slot + k belongs to body k; 0 is no end.
static inline int exclusion_of_end(int end) { return (end - 1) / 2; }
static inline int exclusion_next(const scree_world* world, int end)
{
	return world->exclusions.rows[exclusion_of_end(end)].next[(end - 1) % 2];
}
static inline int exclusion_other(const scree_world* world, int end)
{
	return world->exclusions.rows[exclusion_of_end(end)].bodies[end % 2];
}

// Reserves memory for more pairs, so that exclusion_set cannot fail.
scree_status exclusions_reserve(scree_world* world, const char* function, int more);

// Returns the slot of the pair of bodies a and b, in any order; -1 if there is no such pair.
int exclusion_find(const scree_world* world, int a, int b);
void exclusion_set(scree_world* world, int a, int b, bool excluded);
void body_exclusions_remove(scree_world* world, int body);

scree_status upload_exclusions(scree_world* world);
uint64_t exclusions_hash(const scree_world* world);
void exclusions_close(scree_world* world);

#endif
