// SPDX-License-Identifier: MIT
// narrow_phase.h -- contacts to manifolds; impulses follow their points; contacts whose boxes parted are released.
//
// Where a pair has hardly moved against each other, its points stay the same places on the two collidables, and nothing
// is written (contact_points.h follows them). In a settled pile that is nearly every pair.
#ifndef NARROW_PHASE_H
#define NARROW_PHASE_H
#include "stages/box.h"
#include "stages/contact_points.h"
#include "stages/sweep.h"

// a point farther than this from where it was, and of another feature, starts without impulse
#define MATCH_DISTANCE (2.0f * SPECULATIVE_DISTANCE)

// a pair of which no point moved farther than this against the other keeps its manifold, m: a quarter of the distance at
// which contacts begin, so that none can be missed
#define STAY_DISTANCE LINEAR_SLOP

// Counts a contact that begins to touch. A body that may have too many now, and has some with colors, calls for a search
// (spoke.h).
INLINE void contact_count(const Pools* p, int body)
{
	if (atomic_add_int(&p->touching[body], 1) >= HUB_CONTACTS && p->body[body].inv_mass > 0.0f &&
	    read_shared_word64(&p->color_mask[body]) != 0)
		raise_int(&p->counters->crowded, p->counters->contacts);
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

// Whether every point of b is within STAY_DISTANCE of where it was in the frame of a: it moved with the origin, and by
// at most reach times the turn. The sum of the components bounds the length.
INLINE int narrow_phase_stayed(Float4 was, Vec position, Vec rotation, float reach)
{
	Vec before = vec(was.z, was.w);
	float moved = absolute(position.x - was.x) + absolute(position.y - was.y);
	float turned = absolute(vec_cross(before, rotation)) + absolute(1.0f - vec_dot(before, rotation));
	return moved + reach * turned < STAY_DISTANCE;
}

// The manifold of a pair that may draw near by more than the speculative distance: as it will be where they meet, with
// what may follow in the rest of the step; if they will not, as it is now. f is the frame in which it was found.
INLINE Manifold narrow_phase_ahead(const Pools* p, Placed a, Placed b, Closing closing, Frame* f, Float4* relative)
{
	const GLOBAL Attribute* shape_a = p->attribute + a.attribute;
	const GLOBAL Attribute* shape_b = p->attribute + b.attribute;
	Manifold now = no_manifold();
	Frame start = *f;
	Vec turn = vec(1.0f, 0.0f);
	Real time = 0.0f;
	for (int round = 0; round < SWEEP_ROUNDS; ++round)
	{
		Vec axes = vec_turn(turn, vec(a.c, a.s));
		Manifold m = collide(shape_a, shape_b, *f, sweep_reach(closing, axes, time));
		Real gap = minimum(m.separation[0], m.separation[1]);
		if (gap <= (round + 1 < SWEEP_ROUNDS ? -SWEEP_DEPTH : SPECULATIVE_DISTANCE))
		{
			// contact_points turns it with a as it is now
			m.normal = vec_turn(turn, m.normal);
			relative->y = time * closing.a.turn;
			relative->z = time * closing.b.turn;
			return m;
		}
		// what the forces of a step may close is kept without a meeting, or nothing would roll or slide fast on a floor
		if (round == 0 && gap <= LINEAR_SLOP)
			now = m;
		Real speed = sweep_speed(closing, vec_turn(axes, m.normal), time);
		if (m.count == 0 || !(speed * (1.0f - time) > gap + 2.0f * SWEEP_DEPTH))
			break;
		time = time + (gap + 2.0f * SWEEP_DEPTH) / speed;
		turn = sweep_frame(a, b, closing, time, f);
	}
	*f = start;
	return now;
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
	Frame f = frame_at(vec_turn_back(turn, vec(b.x - a.x, b.y - a.y)), vec_turn_back(turn, vec(b.c, b.s)));
	const GLOBAL Attribute* shape_a = p->attribute + a.attribute;
	const GLOBAL Attribute* shape_b = p->attribute + b.attribute;
	Float4 was = p->contact_found[i].relative,
	       relative = make_float4(f.position.x, f.position.y, f.rotation.x, f.rotation.y);
	Manifold m;
	Closing closing;
	closing.most = 0.0f;
	if ((moved & MOVED_FAR) && !(flags & CONTACT_DETECTED))
		closing = sweep_closing(p, a, b);
	if (closing.most > SPECULATIVE_DISTANCE)
	{
		relative = make_float4(NO_POINT, 0.0f, 0.0f, 0.0f);
		m = narrow_phase_ahead(p, a, b, closing, &f, &relative);
	}
	else
	{
		if (!(flags & CONTACT_FRESH) && narrow_phase_stayed(was, f.position, f.rotation, shape_b->reach))
			return;
		m = collide(shape_a, shape_b, f, reach_of(SPECULATIVE_DISTANCE));
	}

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

	Vec on_b[2];
	float along[2] = {0.0f, 0.0f}, across[2] = {0.0f, 0.0f};
	int feature[2] = {-1, -1}, taken = 0;
	on_b[0] = vec(0.0f, 0.0f);
	on_b[1] = on_b[0];
	for (int k = 0; k < m.count; ++k)
	{
		on_b[k] = vec_turn_back(f.rotation, vec_sub(m.point[k], f.position));
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
	found.on_b = make_float4(on_b[0].x, on_b[0].y, on_b[1].x, on_b[1].y);
	found.relative = relative;
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
