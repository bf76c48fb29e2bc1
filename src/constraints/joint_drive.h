// SPDX-License-Identifier: MIT
// joint_drive.h -- solves limits, springs and motors of a joint, each along one coordinate.
#ifndef JOINT_DRIVE_H
#define JOINT_DRIVE_H
#include "constraints/joint_spring.h"

// rad/s: maximum speed at which limits, and locks outside of chains, correct angles. With 10, sliders in a row that a
// mouse tore apart by 200 m stay apart: forces on the long arms turn the bodies faster than the correction turns them
// back. A limit without this bound lets a body turn by half a turn in a step, and such turns cannot be counted.
#define JOINT_TURNING 30.0f

typedef struct // rows of the drives of one coordinate
{
	Real lower, upper, limit_rate, limit_soft;
	Real target, spring_answer, spring_rate, spring_keeps, spring_relaxes, spring_least, spring_most;
	Real speed, motor_most;
	Real limit_impulse, spring_impulse, motor_impulse;
} JointDrive;

SMALL_BEGIN
INLINE JointDrive joint_drive_load(const Pools* p, int i, int k)
{
	JointDrive d;
	d.lower = load(&joint_drive_row(p, k, lower, i), 0);
	d.upper = load(&joint_drive_row(p, k, upper, i), 0);
	d.limit_rate = load(&joint_drive_row(p, k, limit_rate, i), 0);
	d.limit_soft = load(&joint_drive_row(p, k, limit_soft, i), 0);
	d.target = load(&joint_drive_row(p, k, target, i), 0);
	d.spring_answer = load(&joint_drive_row(p, k, spring_answer, i), 0);
	d.spring_rate = load(&joint_drive_row(p, k, spring_rate, i), 0);
	d.spring_keeps = load(&joint_drive_row(p, k, spring_keeps, i), 0);
	d.spring_relaxes = load(&joint_drive_row(p, k, spring_relaxes, i), 0);
	d.spring_least = load(&joint_drive_row(p, k, spring_least, i), 0);
	d.spring_most = load(&joint_drive_row(p, k, spring_most, i), 0);
	d.speed = load(&joint_drive_row(p, k, speed, i), 0);
	d.motor_most = load(&joint_drive_row(p, k, motor_most, i), 0);
	d.limit_impulse = load(&joint_drive_row(p, k, limit_impulse, i), 0);
	d.spring_impulse = load(&joint_drive_row(p, k, spring_impulse, i), 0);
	d.motor_impulse = load(&joint_drive_row(p, k, motor_impulse, i), 0);
	return d;
}

INLINE void joint_drive_store(const Pools* p, int i, int k, const JointDrive* d)
{
	store(&joint_drive_row(p, k, limit_impulse, i), 0, d->limit_impulse);
	store(&joint_drive_row(p, k, spring_impulse, i), 0, d->spring_impulse);
	store(&joint_drive_row(p, k, motor_impulse, i), 0, d->motor_impulse);
}

INLINE Word joint_drives(const Pools* p, const Joint* u, int k)
{
	return p->step.has_drives ? lane_bits(joint_has(u, JOINT_HAS_DRIVES(k))) : 0u;
}

INLINE Real joint_drive_sum(const JointDrive* d) { return d->spring_impulse + d->motor_impulse + d->limit_impulse; }

// Returns the impulse of a spring in the bias pass (joint_spring.h).
INLINE Real joint_spring(const Step* step, const JointDrive* d, Real yield, Real speed, Real error)
{
	Real change =
	    quotient(-(d->spring_answer * speed + d->spring_rate * error), yield) - d->spring_keeps * d->spring_impulse;
	return joint_bounded(step, d->spring_impulse + change, yield);
}

// Returns a spring's impulse in relax. An impulse at its bound stays: only bias computes the excess over the bound.
INLINE Real joint_spring_relaxed(const Step* step, const JointDrive* d, Real yield, Real speed, Int full)
{
	Real old = d->spring_impulse;
	full = full | (old <= d->spring_least) | (old >= d->spring_most);
	return blend(joint_bounded(step, old - quotient(d->spring_relaxes * speed, yield), yield), old, full);
}

INLINE Real joint_spring_bounded(const JointDrive* d, Real impulse)
{
	return minimum(d->spring_most, maximum(d->spring_least, impulse));
}

// Returns the part of a spring's impulse that motor and limit of the same coordinate do not cancel.
INLINE Real joint_spring_left(const JointDrive* d)
{
	Real zero = splat(0.0f), whole = d->spring_impulse, left = joint_drive_sum(d);
	return minimum(maximum(left, minimum(whole, zero)), maximum(whole, zero));
}

// Returns the part of a limit's impulse to which the limit yields: all but the part that opposes the spring of the same
// coordinate, which is already computed. sign: direction of the limit's impulse, 1 or -1; impulse: its absolute value.
INLINE Real joint_limit_load(const JointDrive* d, Real sign, Real impulse)
{
	Real zero = splat(0.0f);
	return maximum(impulse - maximum(-(sign * d->spring_impulse), zero), zero);
}

// Returns the speed at which a coordinate may approach a limit at the distance `ahead`. Beyond the limit `ahead` is
// negative. The result is then negative in bias, because the coordinate must return, and 0 in relax.
INLINE Real joint_limit_speed(const Pools* p, const JointDrive* d, int k, Real ahead, int soft)
{
	Real zero = splat(0.0f), most = splat(k == JOINT_ANGLE ? JOINT_TURNING : p->step.max_speed);
	return blend(soft ? maximum(d->limit_rate * ahead, -most) : zero, p->step.inv_h * ahead, ahead > zero);
}

// Returns the impulse of the nearer limit. Within the limits (s > 0), the impulse stops an approach at the limit;
// beyond the limit, the limit is as soft as a lock.
INLINE Real joint_limit(const Pools* p, const JointDrive* d, int k, Real yield, Real speed, Real value, int soft)
{
	Real zero = splat(0.0f), below = value - d->lower, above = d->upper - value;
	Int low = below < above;
	Real s = blend(above, below, low), sign = blend(splat(-1.0f), splat(1.0f), low);
	Real yields = blend(soft ? d->limit_soft : zero, zero, s > zero);
	Real old = maximum(sign * d->limit_impulse, zero);
	Real back = sign * speed + joint_limit_speed(p, d, k, s, soft) + yields * yield * joint_limit_load(d, sign, old);
	return sign * maximum(joint_bounded(&p->step, old - quotient(back, yield + yields * yield), yield), zero);
}

// Returns the target speed of a motor: the user's speed, reduced so that it does not lead through the nearer limit.
// Otherwise motor and limit would push against each other, and the limit would yield: with a motor of 1e8 N, a body of
// 1 kg moved 29 m. limit: lanes with a limit.
INLINE Real joint_motor_speed(const Pools* p, const JointDrive* d, int k, Real value, Int limit, int soft)
{
	Real below = value - d->lower, above = d->upper - value;
	Int low = below < above;
	Real sign = blend(splat(-1.0f), splat(1.0f), low),
	     least = -joint_limit_speed(p, d, k, blend(above, below, low), soft);
	return blend(d->speed, sign * maximum(sign * d->speed, least), limit);
}

// Solves spring, then motor, then limit of coordinate k. full: lanes whose springs have reached their common bound.
INLINE void joint_drive(const Pools* p, int i, int k, int soft, Int full, Joint* u, JointPose* c)
{
	JointDrive d = joint_drive_load(p, i, k), old = d;
	Real zero = splat(0.0f), yield = joint_yield(c, k), speed = joint_speed(c, k);
	Int yields = yield > zero;
	Real safe = blend(splat(1.0f), yield, yields);
	Int motor = joint_has(u, JOINT_MOTOR(k)) & yields, limit = joint_has(u, JOINT_LIMITED(k)) & yields;
	Int together = joint_has(u, k == JOINT_ANGLE ? 0 : JOINT_ELLIPTIC);
	if (p->step.springs && lane_bits(joint_has(u, JOINT_SPRING(k))))
	{
		Int spring = joint_has(u, JOINT_SPRING(k)) & yields;
		Real pull = soft ? joint_spring(&p->step, &d, safe, speed, c->value[k] - d.target)
		                 : joint_spring_relaxed(&p->step, &d, safe, speed, full & together);
		d.spring_impulse = only(blend(joint_spring_bounded(&d, pull), pull, together), spring);
		speed = blend(speed, speed + yield * (d.spring_impulse - old.spring_impulse), spring);
	}
	if (lane_bits(joint_has(u, JOINT_MOTOR(k))))
	{
		Real drive = joint_bounded(
		    &p->step, d.motor_impulse - quotient(speed - joint_motor_speed(p, &d, k, c->value[k], limit, soft), safe),
		    safe);
		d.motor_impulse = only(blend(grip_of(drive, d.motor_most), drive, together), motor);
		speed = blend(speed, speed + yield * (d.motor_impulse - old.motor_impulse), motor);
	}
	if (lane_bits(joint_has(u, JOINT_LIMITED(k))))
		d.limit_impulse = only(joint_limit(p, &d, k, safe, speed, c->value[k], soft), limit);
	joint_drive_store(p, i, k, &d);
	Real change = joint_drive_sum(&d) - joint_drive_sum(&old);
	JointImpulse j = joint_impulse(c, k == JOINT_ALONG ? change : zero, k == JOINT_ACROSS ? change : zero,
	                               k == JOINT_ANGLE ? change : zero);
	joint_give_where(u, c, j, joint_has(u, JOINT_HAS_DRIVES(k)));
}

#define JOINT_MOST_SHARE 1.0e15f // maximum of joint_share

// Returns impulse / most, limited so that its square is finite; 0 if `most` is 0.
INLINE Real joint_share(Real impulse, Real most)
{
	Int there = most > splat(0.0f);
	Real share = within(quotient(impulse, blend(splat(1.0f), most, there)), splat(JOINT_MOST_SHARE));
	return only(flush_tiny(share), there);
}

// Shortens the impulse (x, y) to the ellipse with the half axes most_x and most_y, if the impulse is outside. Sets a
// component to 0 if its half axis is 0.
INLINE void joint_shorten(Real* x, Real* y, Real most_x, Real most_y)
{
	Real zero = splat(0.0f), one = splat(1.0f);
	Real share_x = joint_share(*x, most_x), share_y = joint_share(*y, most_y);
	Real square = share_x * share_x + share_y * share_y;
	Int beyond = square > one;
	Real back = quotient(one, root(blend(one, square, beyond)));
	Real short_x = flush_tiny(back * within(*x, JOINT_MOST_SHARE * most_x)),
	     short_y = flush_tiny(back * within(*y, JOINT_MOST_SHARE * most_y));
	*x = only(blend(*x, short_x, beyond), most_x > zero);
	*y = only(blend(*y, short_y, beyond), most_y > zero);
}

// Bounds the two springs along and across by an ellipse, and the two motors by another, in joints with JOINT_ELLIPTIC.
// With separate bounds, a friction of F would be 1.41 F on the diagonal and deflect bodies that slide obliquely.
INLINE void joint_drive_together(const Pools* p, int i, Joint* u, JointPose* c)
{
	JointDrive x = joint_drive_load(p, i, JOINT_ALONG), y = joint_drive_load(p, i, JOINT_ACROSS);
	Real zero = splat(0.0f), old_x = joint_drive_sum(&x), old_y = joint_drive_sum(&y);
	Int together = joint_has(u, JOINT_ELLIPTIC);
	JointDrive now_x = x, now_y = y;
	joint_shorten(&now_x.spring_impulse, &now_y.spring_impulse, maximum(x.spring_most, -x.spring_least),
	              maximum(y.spring_most, -y.spring_least));
	joint_shorten(&now_x.motor_impulse, &now_y.motor_impulse, x.motor_most, y.motor_most);
	x.spring_impulse = blend(x.spring_impulse, joint_spring_bounded(&x, now_x.spring_impulse), together);
	y.spring_impulse = blend(y.spring_impulse, joint_spring_bounded(&y, now_y.spring_impulse), together);
	x.motor_impulse = blend(x.motor_impulse, now_x.motor_impulse, together);
	y.motor_impulse = blend(y.motor_impulse, now_y.motor_impulse, together);
	joint_drive_store(p, i, JOINT_ALONG, &x);
	joint_drive_store(p, i, JOINT_ACROSS, &y);
	JointImpulse j = joint_impulse(c, joint_drive_sum(&x) - old_x, joint_drive_sum(&y) - old_y, zero);
	joint_give_where(u, c, j, together);
}

#define JOINT_FULL 0.9999f // squared share of the bound from which springs count as at the bound, despite rounding

INLINE Int joint_springs_full(const Pools* p, int i)
{
	JointDrive x = joint_drive_load(p, i, JOINT_ALONG), y = joint_drive_load(p, i, JOINT_ACROSS);
	Real share_x = joint_share(x.spring_impulse, maximum(x.spring_most, -x.spring_least));
	Real share_y = joint_share(y.spring_impulse, maximum(y.spring_most, -y.spring_least));
	return share_x * share_x + share_y * share_y > splat(JOINT_FULL);
}

OUT_OF_LINE void joint_drive_all(const Pools* p, int i, int soft, Joint* u, JointPose* c)
{
	Int full = splat(0.0f) > splat(0.0f);
	if (!soft && p->step.springs && lane_bits(joint_has(u, JOINT_ELLIPTIC)))
		full = joint_springs_full(p, i);
	UNROLL
	for (int k = 0; k < JOINT_COORDINATES; ++k)
	{
		// bounds along and across come before the angle, whose motor would else oppose impulses that the bounds remove
		if (k == JOINT_ANGLE && p->step.has_drives && lane_bits(joint_has(u, JOINT_ELLIPTIC)))
			joint_drive_together(p, i, u, c);
		if (joint_drives(p, u, k))
			joint_drive(p, i, k, soft, full, u, c);
	}
}

// Computes for each coordinate the sum of the impulses of lock, limit, spring and motor.
OUT_OF_LINE void joint_sums(const Pools* p, int i, const Joint* u, Real sum[JOINT_COORDINATES])
{
	sum[JOINT_ALONG] = u->impulse_along;
	sum[JOINT_ACROSS] = u->impulse_across;
	sum[JOINT_ANGLE] = u->impulse_angle;
	UNROLL
	for (int k = 0; k < JOINT_COORDINATES; ++k)
	{
		if (!joint_drives(p, u, k))
			continue;
		JointDrive d = joint_drive_load(p, i, k);
		// blend, because adding 0 in the other lanes of a block could change the sign of a zero there
		sum[k] = blend(sum[k], sum[k] + joint_drive_sum(&d), joint_has(u, JOINT_HAS_DRIVES(k)));
	}
}

OUT_OF_LINE void joint_scale(const Pools* p, int i, Joint* u, Real part)
{
	u->impulse_along = part * u->impulse_along;
	u->impulse_across = part * u->impulse_across;
	u->impulse_angle = part * u->impulse_angle;
	UNROLL
	for (int k = 0; k < JOINT_COORDINATES; ++k)
	{
		if (!joint_drives(p, u, k))
			continue;
		JointDrive d = joint_drive_load(p, i, k);
		d.limit_impulse = part * d.limit_impulse;
		d.spring_impulse = part * d.spring_impulse;
		d.motor_impulse = part * d.motor_impulse;
		joint_drive_store(p, i, k, &d);
	}
}

SMALL_END
#endif
