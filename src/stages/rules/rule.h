// SPDX-License-Identifier: MIT
// rule.h -- evaluates the user's rules about pairs, which decide which contacts act. Used only in worlds with rules.
//
// A contact that a rule disables has no points, as if only the boxes of its collidables overlapped. Rules are evaluated
// before the narrow phase, from the state of the contact in the last step and the current poses.
#ifndef RULE_H
#define RULE_H
#include "stages/color/joint_edges.h"
#include "stages/rules/one_way.h"

RARE MaterialPair rule_materials(const Pools* p, int i, int j)
{
	MaterialPair pair = {0.0f, 0.0f, 0.0f, 0};
	int a = p->rule[p->collidable_attribute[i]].material, b = p->rule[p->collidable_attribute[j]].material;
	int low = (a < b ? a : b) % MATERIALS, high = (a < b ? b : a) % MATERIALS, place = MATERIAL_PLACE(low, high);
	if (place < p->step.material_pairs)
		pair = p->material_pair[a / MATERIALS * p->step.material_pairs + place];
	return pair;
}

INLINE int rule_ignores(MaterialPair pair) { return pair.sets & MATERIAL_IGNORED; }

// Returns the surface of a contact (contact_surface), with the values that the pair of materials overrides replaced.
INLINE Float4 rule_surface(MaterialPair pair, Float4 surface)
{
	float friction = pair.friction < MOST_FRICTION ? pair.friction : MOST_FRICTION;
	return make_float4(pair.sets & MATERIAL_FRICTION ? friction : surface.x,
	                   pair.sets & MATERIAL_RESTITUTION ? pair.restitution : surface.y, surface.z,
	                   pair.sets & MATERIAL_SPEED ? pair.tangent_speed : surface.w);
}

// Returns whether a is a one-way platform for b. A dynamic platform is solid for static and kinematic collidables, so
// that it can land on them.
INLINE int rule_platform(const Pools* p, int a, int b)
{
	return one_way_is(p, a) && (p->collidable_kind[a] != KIND_DYNAMIC || p->collidable_kind[b] == KIND_DYNAMIC);
}

// Returns the motion of the body of collidable i in the step, from its velocity at the start of the step.
INLINE Advance rule_advance(const Pools* p, int i)
{
	BodyState body = p->body[p->world_shape[i].body];
	return sweep_advance_of(&p->step, vec(body.vx, body.vy), body.w);
}

// m: Returns the displacement in the step of collidable b relative to collidable a, in the rotating frame of a.
INLINE Vec rule_way(const Pools* p, int a, int b)
{
	WorldShape at = p->world_shape[a], to = p->world_shape[b];
	Advance first = rule_advance(p, a), second = rule_advance(p, b);
	// vector from the center of mass of a to that of b
	Vec arm = vec(to.x - at.x + (to.center_x - at.center_x), to.y - at.y + (to.center_y - at.center_y));
	return vec_sub(vec_sub(second.path, first.path), vec_spin(first.turn, arm));
}

// Returns CONTACT_PASSES if a platform lets the other collidable through, otherwise 0. Adds CONTACT_HIGH if the latter
// is above the height of the platform, but not over it, so that the platform may hold it later like a new visitor.
RARE Word rule_passes(const Pools* p, Int2 pair, Word flags)
{
	int known = flags & (CONTACT_FRESH | CONTACT_IGNORED | CONTACT_HIGH) ? ONE_WAY_NEW
	            : flags & CONTACT_PASSES                                 ? ONE_WAY_PAST
	                                                                     : ONE_WAY_HELD;
	int passes = 0, past = 0;
	if (known == ONE_WAY_HELD && flags & CONTACT_COUNT)
		return 0;
	for (int side = 0; side < 2; ++side)
	{
		int a = side ? pair.y : pair.x, b = side ? pair.x : pair.y;
		if (!rule_platform(p, a, b))
			continue;
		int found = one_way_finds(p, a, b, rule_way(p, a, b), 0.0f, known);
		passes |= found != ONE_WAY_HELD;
		past |= found == ONE_WAY_PAST;
	}
	return passes ? CONTACT_PASSES | (past ? 0u : CONTACT_HIGH) : 0u;
}

// Clears the depth of body i in the platforms that hold it.
KERNEL(sunk_begin) { p->sunk[i] = 0; }

// Raises a visitor's depth in its platforms to the larger of `depth`, m, and the depth in the manifold of a contact.
// slot: slot of the contact.
INLINE void sunk_to(const Pools* p, int slot, int visitor, float depth)
{
	if (p->contact_flags[slot] & CONTACT_COUNT)
	{
		Float4 normal = p->contact_manifold[slot].normal;
		depth = maximum(maximum(depth, -minimum(normal.z, normal.w)), ONE_WAY_TOUCH);
	}
	// bits of non-negative floats, as integers, have the same order as the floats
	if (depth > 0.0f)
		atomic_max_int(&p->sunk[p->collidable_body[visitor]], float_bits(depth));
}

// Raises the depth of visitor b if a is a platform for b. found: 1 if the depth at the current poses is included.
RARE void sunk_by(const Pools* p, int slot, int a, int b, int found)
{
	if (rule_platform(p, a, b))
		sunk_to(p, slot, b, found ? 0.0f : one_way_sunk(p, p->world_shape[a], p->world_shape[b]));
}

// Raises the depth of each collidable of contact i for which the other one is a platform. found: as in sunk_by.
INLINE void sunk_find(const Pools* p, int i, Word flags, int found)
{
	Int2 pair = p->pair[i];
	if (pair.x < 0 || flags & (CONTACT_FRESH | CONTACT_DETECTED | CONTACT_APART | CONTACT_PENDING))
		return;
	int by_a = one_way_is(p, pair.x), by_b = one_way_is(p, pair.y);
	// box_parted: a destroyed collidable may have any attribute, so one_way_is may be wrong for it
	if (!(by_a || by_b) || box_parted(p, pair))
		return;
	if (by_a)
		sunk_by(p, i, pair.x, pair.y, found);
	if (by_b)
		sunk_by(p, i, pair.y, pair.x, found);
	if (!found)
		p->contact_flags[i] = flags | CONTACT_SUNK;
}

// Raises the depths (sunk_find) from the last manifold of contact i and the current poses, before contact_rule.
// approval_request repeats this with the new manifold, for the kernel continuous.
KERNEL(contact_sunk)
{
	if (i < p->counters->live)
		sunk_find(p, i, p->contact_flags[i] & ~CONTACT_SUNK, 0);
}

INLINE Word64 approval_key(Int2 pair) { return (Word64)pair.x << 32 | (Word64)pair.y; }

INLINE int approval_finds(const GLOBAL Word64* keys, int count, Word64 key)
{
	int at = key_bound(keys, 0, count, key);
	return at < count && keys[at] == key;
}

// Returns the new CONTACT_APPROVALS bits of a contact. flags: its current flags.
RARE Word rule_answer(const Pools* p, Int2 pair, Word flags)
{
	if (!((p->filter[pair.x].reports | p->filter[pair.y].reports) & REPORT_APPROVAL))
		return 0;
	if (flags & CONTACT_FRESH)
		return CONTACT_PENDING;
	if (flags & CONTACT_WAITED && p->step.request_again)
		return CONTACT_PENDING;
	if (flags & CONTACT_WAITED)
		return approval_finds(p->allowed, p->step.allowed, approval_key(pair)) ? CONTACT_APPROVED
		                                                                       : CONTACT_PENDING | CONTACT_REFUSED;
	// without points the pair has parted, and approval starts again; a contact that touched before keeps acting
	if (!(flags & CONTACT_COUNT))
		return CONTACT_PENDING;
	return flags & CONTACT_APPROVALS ? flags & CONTACT_APPROVALS : CONTACT_APPROVED;
}

// Decides whether contact i acts in this step.
KERNEL(contact_rule)
{
	Word flags = p->contact_flags[i];
	Int2 pair = p->pair[i];
	if (i >= p->counters->live || pair.x < 0 || flags & (CONTACT_DETECTED | CONTACT_JOINED))
		return;
	Word apart = 0, answer = p->step.asks ? rule_answer(p, pair, flags) : 0u;
	if (p->step.material_pairs > 0)
	{
		MaterialPair materials = rule_materials(p, pair.x, pair.y);
		if (flags & CONTACT_FRESH)
			p->contact_surface[i] = rule_surface(materials, p->contact_surface[i]);
		apart = rule_ignores(materials) ? CONTACT_IGNORED : 0u;
	}
	// early exit: most contacts keep their state
	int platform = !apart && (one_way_is(p, pair.x) || one_way_is(p, pair.y));
	if (!platform && (flags & (CONTACT_PASSES | CONTACT_IGNORED | CONTACT_APPROVALS)) == (apart | answer))
		return;
	// the narrow phase releases a contact whose boxes parted, unless it is fresh
	if (!(flags & CONTACT_FRESH) && box_parted(p, pair))
		return;
	if (platform)
		apart = rule_passes(p, pair, flags);
	int acts = flags & CONTACT_PENDING && !(answer & CONTACT_PENDING);
	if (((flags ^ apart) & (CONTACT_PASSES | CONTACT_IGNORED)) || acts)
		contact_anew(p, i, flags, apart | answer | (flags & CONTACT_REPORTS));
	else
		p->contact_flags[i] = (flags & ~(CONTACT_APPROVALS | CONTACT_HIGH)) | answer | apart;
	// the depth in one platform decides about the next one, so one change may follow another without motion
	if (p->contact_flags[i] != flags)
		raise_int(&p->counters->rule_changes, 1);
}

#endif
