// SPDX-License-Identifier: MIT
// predicted_manifold.h -- manifolds of future poses: of fast bodies where they will meet, of corners that pass each other, of belts.
#ifndef PREDICTED_MANIFOLD_H
#define PREDICTED_MANIFOLD_H
#include "stages/geometry/sweep.h"

// Cosine of the normals of two poses: what passes a corner turns its normal by a right angle at most, and rounding.
#define PAST_THROUGH (-0.5f)

// poses in the future: where the two meet, or others
#define PREDICT_MEETS 1
#define PREDICT_LATER 2

typedef struct // a manifold and the poses that it is of
{
	Manifold m;
	Frame f;   // of b in the frame of a
	Vec axes;  // rotation of a in the world
	int ahead; // 0 for the poses now, or PREDICT_*
} Prediction;

// m: a manifold whose plane is off by less counts as exact. An approach of less than SWEEP_REST is ignored: a push
// against it would disturb no more than the lack of a push from a floor.
#define PAST_ERROR (0.002f * LINEAR_SLOP)

// A corner is tested at the time of the last relaxing pass (sweep_end), and not before the pair has moved this far (m):
// otherwise a body that sags by less at a seam would seem to meet its side.
#define PAST_MOTION (0.4f * LINEAR_SLOP)

// The manifold of a later pose, if it overlaps much less than now predicts for it (said, m).
RARE Prediction predict_later(const Pools* p, WorldShape a, WorldShape b, Closing closing, Prediction now, Real time,
                              Real said)
{
	Prediction later = now;
	Vec turn = sweep_frame(a, b, closing, time, &later.f);
	later.m = collide(p->attribute + a.attribute, p->attribute + b.attribute, later.f, reach_of(closing.within));
	if (minimum(later.m.separation[0], later.m.separation[1]) - said < PAST_ERROR)
		return now;
	later.axes = vec_turn(turn, now.axes);
	// a thin shape that has not passed a corner but gone through has its normal the other way around, and would be pushed out there
	if (vec_dot(vec_turn(later.axes, later.m.normal), vec_turn(now.axes, now.m.normal)) < PAST_THROUGH)
		return now;
	later.ahead = PREDICT_LATER;
	return later;
}

// A manifold pushes along its normal as if both shapes were flat. If a pair passes by a corner, it predicts an overlap
// that will not happen, and would stop a body that slides over a seam between two floors. Then the manifold of the later
// pose is used.
INLINE Prediction predict_past(const Pools* p, WorldShape a, WorldShape b, Closing closing, Prediction now)
{
	if (now.m.count == 0)
		return now;
	Real closes = -vec_dot(vec_turn(now.axes, now.m.normal), closing.near);
	if (!(closes > SWEEP_REST * closing.grain))
		return now;
	Real time = maximum(sweep_end(&p->step), PAST_MOTION * closing.grain / closing.most);
	Real said = minimum(now.m.separation[0], now.m.separation[1]) - time * closes;
	return said > -PAST_ERROR ? now : predict_later(p, a, b, closing, now, time, said);
}

// Whether a pair is farther apart than it can approach in the step: then it has no manifold, of whatever poses. Shapes are no
// nearer than circles around them; a little more than their distance covers rounding.
INLINE int predict_away(const GLOBAL Attribute* a, const GLOBAL Attribute* b, Closing closing, Vec apart)
{
	Real most = closing.within + closing.swing + root(vec_dot(closing.near, closing.near));
	Real reach = (a->reach + b->reach + most) * 1.001f + LINEAR_SLOP;
	return vec_dot(apart, apart) > reach * reach;
}

// share of its radius: how deep a round shape may pass over a corner; and the cosine of normals that are the same but for rounding.
#define OVER_DEPTH 0.075f
#define OVER_SAME  0.9999f

// A round shape at a corner that it meets: a loaded wheel on a row of segments is a little below their ends, and would be thrown
// up by the next one as by a step. If it will roll on no deeper than that, it has the manifold of then. A pair alone cannot
// tell a seam from a low step, so such steps push wheels up softly. Only of segments that cannot move: arms that are not those of the
// impact would cost angular momentum. Whether that may be:
INLINE int predict_rolls(const Pools* p, WorldShape a, WorldShape b)
{
	const GLOBAL Attribute* attribute = p->attribute + b.attribute;
	return p->step.segments && OVER_DEPTH * (p->attribute + a.attribute)->radius > SWEEP_DEPTH &&
	       attribute->count == 2 && !(attribute->radius > 0.0f) && !(p->body[b.body].inv_mass > 0.0f);
}

INLINE int predict_rolled(const Pools* p, WorldShape a, const Closing* closing, const Prediction* met,
                          const Prediction* later, Real time)
{
	Real deepest = OVER_DEPTH * (p->attribute + a.attribute)->radius;
	Vec normal = vec_turn(later->axes, later->m.normal);
	Real turned = vec_dot(normal, vec_turn(met->axes, met->m.normal));
	// as deep as then, or as it is now below the plane of then: what it sinks on the way, this plane takes away
	Real deep =
	    minimum(later->m.separation[0], later->m.separation[1]) - time * minimum(vec_dot(normal, closing->near), 0.0f);
	return deep >= -deepest && turned > 1.0f - OVER_DEPTH && turned < OVER_SAME;
}

// The manifold of the end of the step, or a little before, if it rolls then, or a surface of the pair runs: a body on two belts is driven by
// the difference of what they carry, which follows its arms. Arms that lag behind its motion drive it on (rolling.h has the same rule).
// One call of collide for both, as each uses registers of a GPU.
RARE Prediction predict_end(const Pools* p, WorldShape a, WorldShape b, Closing closing, Prediction now,
                            int has_rolling)
{
	Prediction later = now;
	Real time = has_rolling ? sweep_end(&p->step) : 1.0f;
	Vec turn = sweep_frame(a, b, closing, time, &later.f);
	later.m = collide(p->attribute + a.attribute, p->attribute + b.attribute, later.f, reach_of(closing.within));
	later.axes = vec_turn(turn, vec(a.c, a.s));
	later.ahead = PREDICT_LATER;
	return later.m.count > 0 && (!has_rolling || predict_rolled(p, a, &closing, &now, &later, time)) ? later : now;
}

// The manifold of a pair that may approach by more than the speculative distance: of the poses where they meet, with the
// points that may follow in the rest of the step; if they will not meet, of the poses now.
INLINE Prediction predict_meeting(const Pools* p, WorldShape a, WorldShape b, Closing closing, Prediction start)
{
	const GLOBAL Attribute* shape_a = p->attribute + a.attribute;
	const GLOBAL Attribute* shape_b = p->attribute + b.attribute;
	Prediction now = start, then = start;
	now.m = no_manifold();
	if (predict_away(shape_a, shape_b, closing, start.f.position))
		return now;
	Real time = 0.0f, depth = SWEEP_DEPTH * closing.grain;
	for (int round = 0; round < SWEEP_ROUNDS; ++round)
	{
		then.m = collide(shape_a, shape_b, then.f, sweep_reach(closing, then.axes, time));
		Real gap = minimum(then.m.separation[0], then.m.separation[1]);
		if (gap <= (round + 1 < SWEEP_ROUNDS ? -depth : closing.within))
		{
			then.ahead = PREDICT_MEETS;
			return then;
		}
		// an approach that the forces of one step may cause is kept without a meeting, or nothing would roll or slide
		// fast on a floor
		if (round == 0 && gap <= LINEAR_SLOP * closing.grain)
			now.m = then.m;
		Real speed = sweep_speed(closing, vec_turn(then.axes, then.m.normal), time);
		if (then.m.count == 0 || !(speed * (1.0f - time) > gap + 2.0f * depth))
			break;
		time = time + (gap + 2.0f * depth) / speed;
		then.axes = vec_turn(sweep_frame(a, b, closing, time, &then.f), start.axes);
	}
	return predict_past(p, a, b, closing, now);
}

#endif
