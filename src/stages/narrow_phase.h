// SPDX-License-Identifier: MIT
// narrow_phase.h -- contacts to manifolds; impulses follow their points; contacts whose boxes parted are released.
#ifndef NARROW_PHASE_H
#define NARROW_PHASE_H
#include "stages/box.h"
#include "stages/manifold.h"

// a point farther than this from where it was, and of another feature, starts without impulse
#define MATCH_DISTANCE (2.0f * SPECULATIVE_DISTANCE)

// gives the color of a contact that no longer touches back to its bodies
INLINE void contact_uncolor(const Pools* p, int i)
{
	int color = p->contact_color[i];
	if (color == COLOR_NONE)
		return;
	Int2 bodies = p->contact_bodies[i];
	if (color < COLORS)
	{
		Word64 others = ~((Word64)1 << color);
		atomic_and_word64(&p->color_mask[bodies.x], others);
		atomic_and_word64(&p->color_mask[bodies.y], others);
	}
	p->contact_color[i] = COLOR_NONE;
	p->contact_constraint[i] = -1;
	atomic_add_int(&p->counters->ended, 1);
}

// which of the old points is new point k: by feature, then the nearest within MATCH_DISTANCE; taken ones are out
INLINE int narrow_phase_match(int feature, Vec anchor, int old_count, const int* old_feature, const Vec* old_anchor, int taken)
{
	for (int k = 0; k < old_count; ++k)
		if (old_feature[k] == feature && !(taken & 1 << k))
			return k;
	int best = -1;
	float nearest = MATCH_DISTANCE * MATCH_DISTANCE;
	for (int k = 0; k < old_count; ++k)
	{
		Vec d = vec_sub(anchor, old_anchor[k]);
		float square = vec_dot(d, d);
		if (!(taken & 1 << k) && square < nearest)
		{
			nearest = square;
			best = k;
		}
	}
	return best;
}

STAGE(narrow_phase)
{
	Int2 pair = p->pair[i];
	if (pair.x < 0)
		return;
	Word flags = p->contact_flags[i];
	if (!(flags & CONTACT_FRESH) && (p->moved[pair.x] | p->moved[pair.y]))
	{
		// one of them was made anew when the old boxes do not overlap
		if (!box_overlap(p->box[pair.x], p->box[pair.y]) || !box_overlap(p->old_box[pair.x], p->old_box[pair.y]))
		{
			contact_uncolor(p, i);
			p->pair[i] = make_int2(-1, -1);
			p->contact_flags[i] = 0;
			atomic_add_int(&p->counters->released, 1);
			return;
		}
	}

	// in the frame of a, so that nothing depends on how far the pair is from the origin
	Placed a = p->placed[pair.x], b = p->placed[pair.y];
	Vec turn = vec(a.c, a.s);
	Vec position = vec_turn_back(turn, vec(b.x - a.x, b.y - a.y));
	Vec rotation = vec_turn_back(turn, vec(b.c, b.s));
	Manifold m = collide(p->attribute + a.attribute, p->attribute + b.attribute, position, rotation);

	int old_count = (int)(flags & CONTACT_COUNT);
	Int2 features = p->contact_feature[i];
	Float4 anchors = p->contact_anchor[i], impulses = p->contact_impulse[i];
	int old_feature[2] = {features.x, features.y};
	Vec old_anchor[2] = {vec(anchors.x, anchors.y), vec(anchors.z, anchors.w)};

	Vec normal = vec_turn(turn, m.normal), anchor[2];
	float separation[2] = {NO_POINT, NO_POINT}, along[2] = {0.0f, 0.0f}, across[2] = {0.0f, 0.0f};
	int feature[2] = {-1, -1}, taken = 0;
	anchor[0] = vec(0.0f, 0.0f);
	anchor[1] = anchor[0];
	for (int k = 0; k < m.count; ++k)
	{
		anchor[k] = vec_sub(vec_turn(turn, m.point[k]), vec(a.center_x, a.center_y));
		separation[k] = m.separation[k];
		feature[k] = m.feature[k];
		int old = narrow_phase_match(feature[k], anchor[k], old_count, old_feature, old_anchor, taken);
		if (old >= 0)
		{
			taken |= 1 << old;
			along[k] = old == 0 ? impulses.x : impulses.y;
			across[k] = old == 0 ? impulses.z : impulses.w;
		}
		int depth = float_bits(-separation[k]);
		if (separation[k] < 0.0f && !(flags & CONTACT_DETECTED) && depth > read_shared(&p->counters->penetration))
			atomic_max_int(&p->counters->penetration, depth);
	}

	Word touching = m.count > 0 ? CONTACT_TOUCHING : 0u;
	p->contact_flags[i] = (flags & CONTACT_DETECTED) | touching | (Word)m.count;
	p->contact_feature[i] = make_int2(feature[0], feature[1]);
	p->contact_normal[i] = make_float4(normal.x, normal.y, separation[0], separation[1]);
	p->contact_anchor[i] = make_float4(anchor[0].x, anchor[0].y, anchor[1].x, anchor[1].y);
	p->contact_impulse[i] = make_float4(along[0], along[1], across[0], across[1]);
	if (!touching)
	{
		p->contact_rolling_impulse[i] = 0.0f;
		contact_uncolor(p, i);
	}
	else if (!(flags & (CONTACT_TOUCHING | CONTACT_DETECTED)))
		p->began[atomic_add_int(&p->counters->began, 1)] = i;
}

#endif
