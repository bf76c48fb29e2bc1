// SPDX-License-Identifier: MIT
// apart.h -- checks the reasons why two collidables do not collide. Each stage checks some of the reasons.
//
// The broad phase checks the reasons that no step changes, and creates no contact for such a pair. Other reasons may
// end while a contact lasts, so the contact's flags store the result (CONTACT_DETECTED, CONTACT_APART) for all code
// that works with contacts. Continuous collision also tests pairs without a contact, so it checks all reasons. For
// overlaps with sensors only bodies and filters are checked (docs/manual/rules.md).
#ifndef APART_H
#define APART_H
#include "stages/geometry/filter.h"
#include "stages/rules/rule.h"

// reasons, cheap ones first; each stage checks a set of them
#define APART_KIND     1                                        // kinds that do not collide (kinds_meet)
#define APART_BODY     2                                        // both belong to one body
#define APART_FILTER   4                                        // categories and masks, or a group
#define APART_DETECTED 8                                        // one has no body: the contact gets no impulses
#define APART_JOINED   16                                       // a joint, a filter joint or an exclusion by the user
#define APART_MATERIAL 32                                       // the materials of the pair ignore each other
#define APART_REFUSED  64                                       // contact approval was refused
#define APART_PAIR     (APART_KIND | APART_BODY | APART_FILTER) // reasons for which no contact is created
#define APART_LASTING  (APART_PAIR | APART_DETECTED)            // reasons for no contact or for no impulses
#define APART_ALL      (APART_LASTING | APART_JOINED | APART_MATERIAL | APART_REFUSED) // all reasons
#define APART_SEEN     (APART_BODY | APART_FILTER)                                     // reasons for no sensor overlap

// Returns a pair in order: a static or kinematic collidable second; otherwise the smaller one first, and of equally
// large ones that with the lower index. Manifolds and arms are precise near the center of the first one: if a floor
// were first, arms of a circle far from the floor's center would be off by 1e-7 of the distance: it would roll.
INLINE Int2 apart_pair(const Pools* p, int i, int j)
{
	int a = i < j ? i : j, b = i < j ? j : i;
	int still_a = p->collidable_kind[a] < KIND_DYNAMIC, still_b = p->collidable_kind[b] < KIND_DYNAMIC;
	float reach_a = p->attribute[p->collidable_attribute[a]].reach,
	      reach_b = p->attribute[p->collidable_attribute[b]].reach;
	int turned = still_a != still_b ? still_a : reach_b < reach_a;
	return turned ? make_int2(b, a) : make_int2(a, b);
}

// Returns a pair as a number of as few bits as possible, which is fast to sort.
INLINE Word64 apart_key(const Pools* p, Int2 pair) { return (Word64)pair.x << p->step.key_bits | (Word64)pair.y; }

// Returns the first of the given reasons that keeps i and j apart, 0 if there is none. One-way platforms are not among
// these reasons, because apart_lets, which tests them, is slow.
INLINE int apart_by(const Pools* p, int i, int j, int reasons)
{
	int a = p->collidable_body[i], b = p->collidable_body[j];
	if (reasons & APART_BODY && a >= 0 && a == b)
		return APART_BODY;
	if (reasons & APART_KIND && !kinds_meet(p->collidable_kind[i], p->collidable_kind[j]))
		return APART_KIND;
	if (reasons & APART_FILTER && !filter_accepts(p->filter[i], p->filter[j]))
		return APART_FILTER;
	if (reasons & APART_DETECTED && (a < 0 || b < 0))
		return APART_DETECTED;
	if (reasons & APART_JOINED && a >= 0 && b >= 0 && joint_parts(p, make_int2(a, b)))
		return APART_JOINED;
	if (reasons & APART_MATERIAL && p->step.material_pairs > 0 && rule_ignores(rule_materials(p, i, j)))
		return APART_MATERIAL;
	if (reasons & APART_REFUSED && p->step.asks &&
	    approval_finds(p->refused, p->counters->refused, apart_key(p, apart_pair(p, i, j))))
		return APART_REFUSED;
	return 0;
}

// Returns the key, in the list `refused`, of a contact that a one-way platform lets through: its pair in reverse order.
INLINE Word64 apart_passes_key(const Pools* p, Int2 pair) { return apart_key(p, make_int2(pair.y, pair.x)); }

// Returns whether a is a one-way platform that lets collidable b through, for continuous collision. Platform a holds b
// if their boxes overlap and `refused` lacks the apart_passes_key of the pair, or if b is above a or gets there in the
// step. way, swing: as in one_way_place.
RARE int apart_lets(const Pools* p, int a, int b, Vec way, float swing)
{
	if (!rule_platform(p, a, b))
		return 0;
	if (box_overlap(p->box[a], p->box[b]) &&
	    !approval_finds(p->refused, p->counters->refused, apart_passes_key(p, apart_pair(p, a, b))))
		return 0;
	return one_way_finds(p, a, b, way, swing, ONE_WAY_PAST) != ONE_WAY_HELD;
}

#endif
