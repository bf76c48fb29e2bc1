// SPDX-License-Identifier: MIT
// path_constraint.h -- computes axes and coordinates of joints on a path; in a step, the path is nearly a circle.
//
//     d = (x, y) from the foot (the point of the path at the start of the step) to anchor b, along tangent and normal
//     k = curvature at the foot, l = change of curvature along the path, 1/m^2
//     c = 1 - k y      s = k x      r = sqrt(c^2 + s^2)      cos = c / r      sin = s / r
//     along = x / r * asin(sin) / sin      across = (1 - r) / k = (2 y - k (x^2 + y^2)) / (1 + r)      turn = k along
//
// The change of curvature adds l along^2 / 2 to the turn of the tangent, and subtracts l along^3 / 6 from across. The
// axes follow the path in each substep, because an outdated tangent would cost energy. The angle is measured from the
// tangent, which turns with the speed along: its Jacobian is that of other angles minus k times that of along.
#ifndef PATH_CONSTRAINT_H
#define PATH_CONSTRAINT_H
#include "constraints/angle.h"
#include "constraints/joint_constraint.h"

#define PATH_SERIES    0.01f   // square of the sine up to which the series of asin is exact to a float
#define PATH_MOST_SWAY 0.5f    // rad: maximum turn of the tangent due to `sway`; series of larger angles are inexact
#define PATH_CENTER    1.0e-4f // minimum of r^2; nearer to the center of the circle, the axes of the foot are used

typedef struct // a point of the circle
{
	Vec turn;        // cos, sin of the tangent
	Real along, out; // m: `along`; r of the formulas above
} PathArc;

INLINE PathArc path_arc(Real bend, Real x, Real y)
{
	Real one = splat(1.0f), c = one - bend * y, s = bend * x, square = c * c + s * s;
	Int off = (square > splat(PATH_CENTER)) & (square < splat(1.0e30f));
	PathArc arc;
	arc.out = root(blend(one, square, off));
	arc.turn = vec_blend(vec(one, splat(0.0f)), vec(quotient(c, arc.out), quotient(s, arc.out)), off);
	Real q = arc.turn.y * arc.turn.y;
	arc.along =
	    quotient(x, arc.out) * (one + q * (splat(1.0f / 6.0f) + q * (splat(3.0f / 40.0f) + q * splat(15.0f / 336.0f))));
	Int far = off & ((q > splat(PATH_SERIES)) | (arc.turn.x < splat(0.0f)));
	if (lane_bits(far))
		arc.along = blend(arc.along, quotient(vec_angle(arc.turn), blend(one, bend, far)), far);
	return arc;
}

// Replaces axes, levers and coordinates in lanes on a path, and sets c->bend.
OUT_OF_LINE void path_pose(const Pools* p, int i, const Joint* u, JointPose* c)
{
	if (!p->step.paths)
		return;
	c->railed = joint_has(u, JOINT_RAILED);
	c->rails = lane_bits(c->railed);
	if (!c->rails)
		return;
	Real zero = splat(0.0f), one = splat(1.0f), x = c->value[JOINT_ALONG], y = c->value[JOINT_ACROSS];
	Real bend = load(&joint_rare(p, bend, i), 0), sway = load(&joint_rare(p, sway, i), 0);
	PathArc arc = path_arc(bend, x, y);
	Real across = quotient(2.0f * y - bend * (x * x + y * y), one + arc.out);
	Real more = within(0.5f * sway * arc.along * arc.along, splat(PATH_MOST_SWAY)), q = more * more;
	Vec turn = vec_turn(arc.turn, vec(one - q * (0.5f - q * (1.0f / 24.0f)), more * (one - q * (1.0f / 6.0f))));
	Real angle = c->value[JOINT_ANGLE] - (bend * arc.along + more);
	across = across - (more * arc.along * (1.0f / 3.0f) + load(&joint_rare(p, beside, i), 0));
	// lanes that are not finite keep their axes, so that the other body of the joint is not affected
	Int sound = c->railed & (absolute((across + arc.along) + (angle + (turn.x + turn.y))) <= splat(MOST_FLOAT));
	turn = vec_blend(vec(one, zero), turn, sound);
	c->bend = only(quotient(bend + sway * arc.along, maximum(arc.out, splat(0.1f))), sound);
	c->value[JOINT_ALONG] = blend(c->value[JOINT_ALONG], arc.along, sound);
	c->value[JOINT_ACROSS] = blend(c->value[JOINT_ACROSS], across, sound);
	c->value[JOINT_ANGLE] = blend(c->value[JOINT_ANGLE], angle, sound);
	// both axes and their levers turn by the same angle
	Vec axis = c->axis[0], levers_a = vec(c->lever_a[0], c->lever_a[1]), levers_b = vec(c->lever_b[0], c->lever_b[1]);
	axis = vec_blend(axis, vec_turn(turn, axis), sound);
	levers_a = vec_blend(levers_a, vec_turn_back(turn, levers_a), sound);
	levers_b = vec_blend(levers_b, vec_turn_back(turn, levers_b), sound);
	c->axis[0] = axis;
	c->axis[1] = vec_blend(c->axis[1], vec(-axis.y, axis.x), sound);
	c->lever_a[0] = levers_a.x;
	c->lever_a[1] = levers_a.y;
	c->lever_b[0] = levers_b.x;
	c->lever_b[1] = levers_b.y;
}

#endif
