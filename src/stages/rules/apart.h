// SPDX-License-Identifier: MIT
// apart.h -- every reason why two collidables do not collide, and which stages heed which.
//
// The broad phase heeds what no step changes, and makes no contact. A contact is made of a pair that other reasons keep apart, as
// these may end while it lasts: its flags hold the answer (CONTACT_DETECTED, CONTACT_APART), and all that works with contacts goes by
// them: manifolds, sweeps of fast pairs, events. Guard meets pairs that have no contact, and heeds all reasons. A sensor touches
// nothing, whatever joints and rules say, so it heeds bodies and filters alone (docs/events.md).
#ifndef APART_H
#define APART_H
#include "stages/geometry/filter.h"
#include "stages/rules/rule.h"

// reasons, the cheap ones first; a stage heeds a set of them
#define APART_KIND     1  // neither can move, one is a sensor, or disabled
#define APART_BODY     2  // both are of one body
#define APART_FILTER   4  // categories and masks, or a group
#define APART_DETECTED 8  // one has no body: it is made for detection
#define APART_JOINED   16 // a joint, a filter joint, or the user, who excluded the pair of bodies
#define APART_MATERIAL 32 // the pair of their materials is ignored
#define APART_REFUSED  64 // the user was asked, and did not allow it
#define APART_PAIR     (APART_KIND | APART_BODY | APART_FILTER)                        // no contact
#define APART_LASTING  (APART_PAIR | APART_DETECTED)                                   // no contact that acts
#define APART_ALL      (APART_LASTING | APART_JOINED | APART_MATERIAL | APART_REFUSED) // whatever is between them
#define APART_SEEN     (APART_BODY | APART_FILTER)                                     // a sensor does not see it

// Which of two collidables is the first of a pair: a moving one before one that does not move, then the smaller, then
// the lower index. The manifold is found in its frame and the solver's arms are from its center, so they are exact where
// it matters: far from the center of a floor, the arms of a circle would be off by 1e-7 of the distance, and it would
// roll.
INLINE Int2 apart_pair(const Pools* p, int i, int j)
{
	int a = i < j ? i : j, b = i < j ? j : i;
	int still_a = p->collidable_kind[a] < KIND_DYNAMIC, still_b = p->collidable_kind[b] < KIND_DYNAMIC;
	float reach_a = p->attribute[p->collidable_attribute[a]].reach,
	      reach_b = p->attribute[p->collidable_attribute[b]].reach;
	int turned = still_a != still_b ? still_a : reach_b < reach_a;
	return turned ? make_int2(b, a) : make_int2(a, b);
}

// A pair as a number of few bits, which are sorted soon.
INLINE Word64 apart_key(const Pools* p, Int2 pair) { return (Word64)pair.x << p->step.key_bits | (Word64)pair.y; }

// The first of these reasons that keeps i and j apart, or 0. One-way platforms come last, in apart_lets, because their places take
// long to find.
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

// The key of a contact that a one-way platform lets through: among those of contacts that were refused, but the other way round.
INLINE Word64 apart_passes_key(const Pools* p, Int2 pair) { return apart_key(p, make_int2(pair.y, pair.x)); }

// Whether a platform, a, lets b through, for guard. A contact that it holds goes on. What passes, or has no contact as the boxes are
// apart, is held if it is above by the way that it went. way: of b against a in the step, m. swing: by
// how much more its points may move, m.
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
