// SPDX-License-Identifier: MIT
// predicted_manifold.h -- computes manifolds at future poses, for fast pairs, pairs that pass a corner, and belts.
#ifndef PREDICTED_MANIFOLD_H
#define PREDICTED_MANIFOLD_H
#include "stages/geometry/sweep.h"

// minimum cosine of the angle between the normals of a manifold at two poses. With a smaller cosine, one shape has gone
// through the other one, because a corner turns the normal by a right angle at most.
#define PAST_THROUGH (-0.5f)

// values of Prediction.ahead for future poses: those at which the pair meets; other ones
#define PREDICT_MEETS 1
#define PREDICT_LATER 2

typedef struct // manifold, and the poses for which it was computed
{
	Manifold m;
	Frame f;   // pose of shape b in the frame of shape a
	Vec axes;  // rotation of shape a in the world
	int ahead; // 0 for the current poses, or PREDICT_*
} Prediction;

// m: the current manifold counts as exact if a later separation exceeds its prediction by less than this. An
// approach of less than SWEEP_REST is ignored: a wrong push of that size is as harmless as the lack of such a push.
#define PAST_ERROR (0.002f * LINEAR_SLOP)

// m: minimum motion of a pair until the time at which predict_past tests for a corner. This is the time of the last
// relax pass (sweep_end) or, for a slow pair, a later one. With 0, a body that sags at a seam would appear to meet the
// side of the next floor.
#define PAST_MOTION (0.4f * LINEAR_SLOP)

// Returns the manifold at a later time if its separation exceeds the predicted one by at least PAST_ERROR, and no shape
// has gone through the other; else returns `now`. said, m: separation at that time, as predicted from `now`.
RARE Prediction predict_later(const Pools* p, WorldShape a, WorldShape b, Closing closing, Prediction now, Real time,
                              Real said)
{
	Prediction later = now;
	Vec turn = sweep_frame(a, b, closing, time, &later.f);
	later.m = collide(p->attribute + a.attribute, p->attribute + b.attribute, later.f, reach_of(closing.within));
	if (minimum(later.m.separation[0], later.m.separation[1]) - said < PAST_ERROR)
		return now;
	later.axes = vec_turn(turn, now.axes);
	// a thin shape that went through the other shape has the opposite normal, and would be pushed out on the wrong side
	if (vec_dot(vec_turn(later.axes, later.m.normal), vec_turn(now.axes, now.m.normal)) < PAST_THROUGH)
		return now;
	later.ahead = PREDICT_LATER;
	return later;
}

// Returns the manifold of a later pose if the pair passes a corner, else `now`. A manifold pushes along its normal as
// if both shapes were flat, and would stop a body that slides over a seam between two floors.
INLINE Prediction predict_past(const Pools* p, WorldShape a, WorldShape b, Closing closing, Prediction now)
{
	if (now.m.count == 0)
		return now;
	Real closes = -vec_dot(vec_turn(now.axes, now.m.normal), closing.near);
	if (!(closes > SWEEP_REST * closing.grain))
		return now;
	Real time = maximum(sweep_end(&p->step), quotient(PAST_MOTION * closing.grain, closing.most));
	Real said = minimum(now.m.separation[0], now.m.separation[1]) - time * closes;
	return said > -PAST_ERROR ? now : predict_later(p, a, b, closing, now, time, said);
}

// Returns whether a pair cannot meet in the step: circles around both shapes, enlarged by the motion, are apart.
INLINE int predict_away(const GLOBAL Attribute* a, const GLOBAL Attribute* b, Closing closing, Vec apart)
{
	Real most = closing.within + closing.swing + root(vec_dot(closing.near, closing.near));
	Real reach = (a->reach + b->reach + most) * 1.001f + LINEAR_SLOP;
	return vec_dot(apart, apart) > reach * reach;
}

#define OVER_DEPTH 0.075f  // fraction of its radius by which a round shape may be below a corner that it rolls over
#define OVER_SAME  0.9999f // cosine of the angle between normals that differ only by rounding

// Returns whether shape a is round and shape b is a segment that cannot move, so that predict_end may replace the
// manifold at a corner. Without the replacement, the end of the next segment would act on a loaded wheel like a step
// (docs/design/manifolds.md, Seams). On a segment that moves, arms other than those at the impact would change angular
// momentum.
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
	// separation at the later poses, plus any approach until then, because the contact removes this approach
	Real deep =
	    minimum(later->m.separation[0], later->m.separation[1]) - time * minimum(vec_dot(normal, closing->near), 0.0f);
	return deep >= -deepest && turned > 1.0f - OVER_DEPTH && turned < OVER_SAME;
}

// Returns the manifold at a later time or, if it has no points, `now`. If `has_rolling` is 1, a round shape meets a
// corner: the time is that of the last relax pass; returns `now` unless the shape will roll over the corner. If it is
// 0, a surface is a belt: the time is the end of the step, because arms that lag behind a body on two belts would add
// energy (docs/design/hubs.md, Belts). Both cases share one call of collide, because a call uses registers of a GPU.
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

// Returns the manifold of a pair that may approach by more than the speculative distance. If the pair will meet in the
// step, this is the manifold at the poses at which it meets, including points that may meet later in the step.
// Otherwise it is the manifold at the current poses or, if the pair passes a corner, at later ones.
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
		// keeps the manifold of a pair that forces may bring together, so that bodies can roll or slide fast on floors
		if (round == 0 && gap <= LINEAR_SLOP * closing.grain)
			now.m = then.m;
		Real speed = sweep_speed(closing, vec_turn(then.axes, then.m.normal), time);
		if (then.m.count == 0 || !(speed * (1.0f - time) > gap + 2.0f * depth))
			break;
		time = time + quotient(gap + 2.0f * depth, speed);
		then.axes = vec_turn(sweep_frame(a, b, closing, time, &then.f), start.axes);
	}
	return predict_past(p, a, b, closing, now);
}

#endif
