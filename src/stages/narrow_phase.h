// SPDX-License-Identifier: MIT
// narrow_phase.h -- contacts to manifolds; impulses follow their points; contacts whose boxes parted are released.
//
// Where a pair has hardly moved against each other, its points stay the same places on the two collidables, and nothing
// is written (contact_points.h follows them). In a settled pile that is nearly every pair.
#ifndef NARROW_PHASE_H
#define NARROW_PHASE_H
#include "stages/ahead.h"
#include "stages/box.h"

// a point farther than this from where it was, and of another feature, starts without impulse
#define MATCH_DISTANCE (2.0f * SPECULATIVE_DISTANCE)

// a pair without points of which no point moved farther than this against the other is not looked at, m: a quarter of the
// distance at which contacts begin, so that none can be missed
#define STAY_DISTANCE LINEAR_SLOP

// A manifold is kept while no point moved farther than this against the other, m, nor than so much of the reach of the
// smaller, and neither turned in the world by more than 3.6 degrees (cosine). With one sharp point it is kept for half of
// that, so that a second cannot be missed. Less shakes heaps: where one small body carries many, a manifold that is found
// anew pushes it another way.
#define HOLD_DISTANCE (2.0f * SPECULATIVE_DISTANCE)
#define HOLD_SHARE    0.1f
#define HOLD_COSINE   0.998f

// Counts a contact that begins to touch. A body that may have too many now, and has some with colors, calls for a search
// (spoke.h).
INLINE void contact_count(const Pools* p, int body)
{
	if (atomic_add_int(&p->touching[body], 1) >= HUB_CONTACTS && p->body[body].inv_mass > 0.0f &&
	    read_shared_word64(&p->color_mask[body]) != 0)
		raise_int(&p->counters->gathered, p->counters->contacts);
}

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
	atomic_add_int(&p->touching[bodies.x], -1);
	atomic_add_int(&p->touching[bodies.y], -1);
	p->contact_color[i] = COLOR_NONE;
	p->contact_constraint[i] = -1;
	p->contact_impulse[i] = make_float4(0.0f, 0.0f, 0.0f, 0.0f);
	p->contact_rolling_impulse[i] = 0.0f;
	atomic_add_int(&p->counters->ended, 1);
	raise_int(&p->counters->changed, 1);
}

// which of the old points is new point k: by feature, then the nearest within MATCH_DISTANCE; taken ones are out
INLINE int narrow_phase_match(int feature, Vec point, int old_count, const int* old_feature, const Vec* old_point,
                              int taken)
{
	for (int k = 0; k < old_count; ++k)
		if (old_feature[k] == feature && !(taken & 1 << k))
			return k;
	int best = -1;
	float nearest = MATCH_DISTANCE * MATCH_DISTANCE;
	for (int k = 0; k < old_count; ++k)
	{
		Vec d = vec_sub(point, old_point[k]);
		float square = vec_dot(d, d);
		if (!(taken & 1 << k) && square < nearest)
		{
			nearest = square;
			best = k;
		}
	}
	return best;
}

// How far any point of b may have moved in the frame of a since the manifold was found: with the origin, and by at most
// reach times the turn. The sum of the components bounds the length.
INLINE float narrow_phase_moved(Float4 was, Frame f, float reach)
{
	Vec before = vec(was.z, was.w);
	float moved = absolute(f.position.x - was.x) + absolute(f.position.y - was.y);
	float turned = absolute(vec_cross(before, f.rotation)) + absolute(1.0f - vec_dot(before, f.rotation));
	return moved + reach * turned;
}

// Whether the bodies touch, so that the contact is none that they will pass by.
INLINE int narrow_phase_touches(const Pools* p, int i)
{
	Float4 normal = p->contact_found[i].normal;
	int constraint = p->contact_constraint[i];
	return minimum(normal.z, normal.w) < 0.0f ||
	       (constraint >= 0 && (constraint_at(p, normal_impulse1, constraint) > 0.0f ||
	                            constraint_at(p, normal_impulse2, constraint) > 0.0f));
}

// Whether the pair, placed at f in the frame of a, keeps what was found; moved has their MOVED_* bits.
INLINE int narrow_phase_keeps(const Pools* p, int i, Word flags, Placed a, Placed b, Frame f, int moved)
{
	const GLOBAL Attribute* shape_a = p->attribute + a.attribute;
	const GLOBAL Attribute* shape_b = p->attribute + b.attribute;
	Float4 then = p->contact_found[i].then;
	int made = float_bits(then.z), count = (int)(flags & CONTACT_COUNT);
	if (made & FOUND_AHEAD)
		return 0;
	float shift = narrow_phase_moved(p->contact_found[i].relative, f, shape_b->reach);
	if (count == 0 || (flags & CONTACT_DETECTED))
		return shift < STAY_DISTANCE;
	float reach = minimum(shape_a->reach, shape_b->reach);
	Float4 was = p->contact_found[i].relative;
	Vec then_a = vec(then.x, then.y), then_b = vec_turn(then_a, vec(was.z, was.w));
	if (vec_dot(then_a, vec(a.c, a.s)) < HOLD_COSINE || vec_dot(then_b, vec(b.c, b.s)) < HOLD_COSINE)
		return 0;
	float distance = count == 2 || (made & FOUND_ROLLS) ? HOLD_DISTANCE : 0.5f * HOLD_DISTANCE;
	if (!(shift < minimum(distance, HOLD_SHARE * reach)))
		return 0;
	if (!(moved & MOVED_ON))
		return 1;
	int touches = narrow_phase_touches(p, i);
	if (touches && !(moved & MOVED_FAST))
		return 1;
	// what cannot close the gap in the step is not pushed
	Float4 normal = p->contact_found[i].normal;
	float limit = maximum(touches ? SWEEP_HOLD : SWEEP_REST, (minimum(normal.z, normal.w) - shift) / ahead_time(p));
	return sweep_most(p, a, b, shape_a->reach, shape_b->reach) < limit || sweep_closing(p, a, b).most < limit;
}

STAGE(narrow_phase)
{
	Int2 pair = p->pair[i];
	if (pair.x < 0)
		return;
	Word flags = p->contact_flags[i];
	int moved = p->moved[pair.x] | p->moved[pair.y];
	if (!(flags & CONTACT_FRESH) && (moved & MOVED_BOX))
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
	const GLOBAL Attribute* shape_a = p->attribute + a.attribute;
	const GLOBAL Attribute* shape_b = p->attribute + b.attribute;
	Ahead found_at;
	found_at.f = frame_at(vec_turn_back(turn, vec(b.x - a.x, b.y - a.y)), vec_turn_back(turn, vec(b.c, b.s)));
	found_at.axes = turn;
	found_at.made = 0;
	Closing closing;
	closing.most = 0.0f;
	if ((moved & MOVED_FAR) && !(flags & CONTACT_DETECTED))
		closing = sweep_closing(p, a, b);
	if (closing.most > SPECULATIVE_DISTANCE)
		found_at = ahead_meeting(p, a, b, closing, found_at);
	else
	{
		if (!(flags & CONTACT_FRESH) && narrow_phase_keeps(p, i, flags, a, b, found_at.f, moved))
			return;
		found_at.m = collide(shape_a, shape_b, found_at.f, reach_of(SPECULATIVE_DISTANCE));
		if (!(flags & CONTACT_DETECTED))
		{
			found_at = ahead_past(p, a, b, sweep_closing(p, a, b), found_at);
			if (found_at.made == 0 && shape_a->radius + shape_b->radius > 0.0f)
				found_at.made = FOUND_ROLLS | found_at.m.made;
		}
	}
	Manifold m = found_at.m;

	int old_count = (int)(flags & CONTACT_COUNT), constraint = p->contact_constraint[i];
	Int2 features = p->contact_feature[i];
	Float4 on_a = p->contact_found[i].on_a;
	int old_feature[2] = {features.x, features.y};
	Vec old_point[2] = {vec(on_a.x, on_a.y), vec(on_a.z, on_a.w)};
	float normal[2] = {0.0f, 0.0f}, tangent[2] = {0.0f, 0.0f};
	if (constraint >= 0)
	{
		normal[0] = constraint_at(p, normal_impulse1, constraint);
		normal[1] = constraint_at(p, normal_impulse2, constraint);
		tangent[0] = constraint_at(p, tangent_impulse1, constraint);
		tangent[1] = constraint_at(p, tangent_impulse2, constraint);
	}

	float along[2] = {0.0f, 0.0f}, across[2] = {0.0f, 0.0f};
	int feature[2] = {-1, -1}, taken = 0;
	for (int k = 0; k < m.count; ++k)
	{
		feature[k] = m.feature[k];
		int old = narrow_phase_match(feature[k], m.point[k], old_count, old_feature, old_point, taken);
		if (old >= 0)
		{
			taken |= 1 << old;
			along[k] = normal[old];
			across[k] = tangent[old];
		}
	}

	Word touching = m.count > 0 ? CONTACT_TOUCHING : 0u;
	p->contact_flags[i] = (flags & CONTACT_DETECTED) | touching | (Word)m.count;
	p->contact_feature[i] = make_int2(feature[0], feature[1]);
	Found found;
	found.normal = make_float4(m.normal.x, m.normal.y, m.separation[0], m.separation[1]);
	found.on_a = make_float4(m.point[0].x, m.point[0].y, m.point[1].x, m.point[1].y);
	found.relative =
	    make_float4(found_at.f.position.x, found_at.f.position.y, found_at.f.rotation.x, found_at.f.rotation.y);
	found.then = make_float4(found_at.axes.x, found_at.axes.y, bits_float(found_at.made), 0.0f);
	p->contact_found[i] = found;
	if (constraint >= 0)
	{
		constraint_at(p, normal_impulse1, constraint) = along[0];
		constraint_at(p, normal_impulse2, constraint) = along[1];
		constraint_at(p, tangent_impulse1, constraint) = across[0];
		constraint_at(p, tangent_impulse2, constraint) = across[1];
	}
	if (!touching)
		contact_uncolor(p, i);
	else if (!(flags & (CONTACT_TOUCHING | CONTACT_DETECTED)))
	{
		Int2 bodies = p->contact_bodies[i];
		contact_count(p, bodies.x);
		contact_count(p, bodies.y);
		p->began[atomic_add_int(&p->counters->began, 1)] = i;
		raise_int(&p->counters->changed, 1);
	}
}

#endif
