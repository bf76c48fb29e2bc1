// SPDX-License-Identifier: MIT
// joint_constraint.h -- a joint as a constraint: three coordinates of a frame of body b in a frame of body a.
//
//     d = anchor of b - anchor of a      u = axis      w = u turned left by 90 degrees
//     along = u . d      across = w . d      angle = angle of b - angle of a
//
// Locked coordinates are solved together, as a symmetric 3 x 3 system, after limits, springs and motors
// (joint_drive.h): the equations that are solved last hold best, and locks have priority.
//
// Arms turn within a step, so the same impulses change velocities by different amounts in each substep, but integrate.h
// assumes equal amounts. Therefore a joint stores the impulses applied to its bodies. The bias pass first computes the
// impulses at the current arms, and applies their difference from the stored ones.
//
// This work is based on:
// Erin Catto, Soft Constraints, GDC 2011; Solver2D, 2024: a bias pass and a relax pass per substep.
#ifndef JOINT_CONSTRAINT_H
#define JOINT_CONSTRAINT_H
#include "constraints/constraint.h"
#include "constraints/solver_body.h"
#include "dialect/finite.h"

#define IN_POSED (IN_WARM_START | IN_BIAS | IN_RELAX)
#define IN_TURNS (IN_BIAS | IN_RELAX)

// Rows of every joint in every step.
#define JOINT_ROWS(X)                                                                \
	/* axis and, in m, anchors from the centers of mass, at the start of the step */ \
	X(axis_x, always, PREPARED, 0.0f, IN_POSED | IN_PREPARE_BOUNCE, IN_PREPARE)      \
	X(axis_y, always, PREPARED, 0.0f, IN_POSED | IN_PREPARE_BOUNCE, IN_PREPARE)      \
	X(arm_a_x, always, PREPARED, 0.0f, IN_POSED | IN_PREPARE_BOUNCE, IN_PREPARE)     \
	X(arm_a_y, always, PREPARED, 0.0f, IN_POSED | IN_PREPARE_BOUNCE, IN_PREPARE)     \
	X(arm_b_x, always, PREPARED, 0.0f, IN_POSED | IN_PREPARE_BOUNCE, IN_PREPARE)     \
	X(arm_b_y, always, PREPARED, 0.0f, IN_POSED | IN_PREPARE_BOUNCE, IN_PREPARE)     \
	/* m: gap from anchor to anchor; target of the lock of a radial joint */         \
	X(gap_x, always, PREPARED, 0.0f, IN_POSED | IN_PREPARE_BOUNCE, IN_PREPARE)       \
	X(gap_y, always, PREPARED, 0.0f, IN_POSED | IN_PREPARE_BOUNCE, IN_PREPARE)       \
	X(length, always, PREPARED, 0.0f, IN_TURNS, IN_PREPARE)                          \
	/* rad: the angle minus the target of its lock */                                \
	X(angle, always, PREPARED, 0.0f, IN_POSED | IN_PREPARE_BOUNCE, IN_PREPARE)       \
	/* rad: the angle over all turns */                                              \
	X(turned, always, KEPT, 0.0f, IN_PREPARE, IN_PREPARE)                            \
	/* JOINT_* bits; softness of each lock: rate (1/s), and 1 / a2 */                \
	X(modes, always, PREPARED, 0.0f, IN_POSED | IN_PREPARE_BOUNCE, IN_PREPARE)       \
	X(rate_along, always, PREPARED, 0.0f, IN_TURNS | IN_PREPARE_BOUNCE, IN_PREPARE)  \
	X(rate_across, always, PREPARED, 0.0f, IN_TURNS | IN_PREPARE_BOUNCE, IN_PREPARE) \
	X(rate_angle, always, PREPARED, 0.0f, IN_TURNS | IN_PREPARE_BOUNCE, IN_PREPARE)  \
	X(soft_along, always, PREPARED, 0.0f, IN_TURNS | IN_PREPARE_BOUNCE, IN_PREPARE)  \
	X(soft_across, always, PREPARED, 0.0f, IN_TURNS | IN_PREPARE_BOUNCE, IN_PREPARE) \
	X(soft_angle, always, PREPARED, 0.0f, IN_TURNS | IN_PREPARE_BOUNCE, IN_PREPARE)  \
	/* N s, N m s: impulses of the locks */                                          \
	X(impulse_along, always, KEPT, 0.0f, IN_POSED, IN_POSED)                         \
	X(impulse_across, always, KEPT, 0.0f, IN_POSED, IN_POSED)                        \
	X(impulse_angle, always, KEPT, 0.0f, IN_POSED, IN_POSED)                         \
	/* velocity change by the warm start, in units of START_SHARE */                 \
	X(carried, always, KEPT, 0.0f, IN_WARM_START, IN_WARM_START)                     \
	/* impulses applied, to body a negated: N s; N m s, separate for each body */    \
	X(given_x, always, PREPARED, 0.0f, IN_POSED, IN_PREPARE | IN_POSED)              \
	X(given_y, always, PREPARED, 0.0f, IN_POSED, IN_PREPARE | IN_POSED)              \
	X(given_a, always, PREPARED, 0.0f, IN_POSED, IN_PREPARE | IN_POSED)              \
	X(given_b, always, PREPARED, 0.0f, IN_POSED, IN_PREPARE | IN_POSED)

// Rows for limits, spring and motor of a coordinate: positions in m or rad, rates in 1/s, impulses in N s or N m s. For
// a soft lock, spring_relaxes is its softness in the relax pass.
#define JOINT_DRIVE_ROWS(X, of)                                              \
	X(of##_lower, has_drives, PREPARED, 0.0f, IN_TURNS, IN_PREPARE)          \
	X(of##_upper, has_drives, PREPARED, 0.0f, IN_TURNS, IN_PREPARE)          \
	X(of##_limit_rate, has_drives, PREPARED, 0.0f, IN_TURNS, IN_PREPARE)     \
	X(of##_limit_soft, has_drives, PREPARED, 0.0f, IN_TURNS, IN_PREPARE)     \
	X(of##_target, has_drives, PREPARED, 0.0f, IN_TURNS, IN_PREPARE)         \
	X(of##_spring_answer, has_drives, PREPARED, 0.0f, IN_BIAS, IN_PREPARE)   \
	X(of##_spring_rate, has_drives, PREPARED, 0.0f, IN_BIAS, IN_PREPARE)     \
	X(of##_spring_keeps, has_drives, PREPARED, 0.0f, IN_BIAS, IN_PREPARE)    \
	X(of##_spring_relaxes, has_drives, PREPARED, 0.0f, IN_RELAX, IN_PREPARE) \
	X(of##_spring_least, has_drives, PREPARED, 0.0f, IN_TURNS, IN_PREPARE)   \
	X(of##_spring_most, has_drives, PREPARED, 0.0f, IN_TURNS, IN_PREPARE)    \
	X(of##_speed, has_drives, PREPARED, 0.0f, IN_TURNS, IN_PREPARE)          \
	X(of##_motor_most, has_drives, PREPARED, 0.0f, IN_TURNS, IN_PREPARE)     \
	X(of##_limit_impulse, has_drives, KEPT, 0.0f, IN_POSED, IN_POSED)        \
	X(of##_spring_impulse, has_drives, KEPT, 0.0f, IN_POSED, IN_POSED)       \
	X(of##_motor_impulse, has_drives, KEPT, 0.0f, IN_POSED, IN_POSED)

// Rows of gears and pulleys (coupling.h).
#define JOINT_COUPLING_ROWS(X)                                                                  \
	X(gear_ratio, couplings, PREPARED, 0.0f, IN_POSED, IN_PREPARE)                              \
	/* m, rad: the coordinate at the start of the step, without the distances of pulleys */     \
	X(coupled, couplings, PREPARED, 0.0f, IN_POSED, IN_PREPARE)                                 \
	/* for body a, for body b: CouplingMeasure.line */                                          \
	X(line_a_x, couplings, PREPARED, 0.0f, IN_POSED, IN_PREPARE)                                \
	X(line_a_y, couplings, PREPARED, 0.0f, IN_POSED, IN_PREPARE)                                \
	X(line_b_x, couplings, PREPARED, 0.0f, IN_POSED, IN_PREPARE)                                \
	X(line_b_y, couplings, PREPARED, 0.0f, IN_POSED, IN_PREPARE)                                \
	/* last angles, rad; their full turns; contribution of the angles to the coordinate, rad */ \
	X(angle_a, couplings, KEPT, 0.0f, IN_PREPARE, IN_PREPARE)                                   \
	X(angle_b, couplings, KEPT, 0.0f, IN_PREPARE, IN_PREPARE)                                   \
	X(turns_a, couplings, KEPT, 0.0f, IN_PREPARE, IN_PREPARE)                                   \
	X(turns_b, couplings, KEPT, 0.0f, IN_PREPARE, IN_PREPARE)                                   \
	X(geared, couplings, KEPT, 0.0f, IN_PREPARE, IN_PREPARE)                                    \
	/* N s: impulse whose opposite was applied to body a */                                     \
	X(given_a_x, couplings, PREPARED, 0.0f, IN_POSED, IN_PREPARE | IN_POSED)                    \
	X(given_a_y, couplings, PREPARED, 0.0f, IN_POSED, IN_PREPARE | IN_POSED)

// Rows of joints on a path (path_constraint.h).
#define JOINT_PATH_ROWS(X)                                                                               \
	/* foot: the point of the path nearest to anchor b, in frame A, m; cos, sin of the tangent there */  \
	X(foot_x, paths, PREPARED, 0.0f, IN_PREPARE, IN_PREPARE)                                             \
	X(foot_y, paths, PREPARED, 0.0f, IN_PREPARE, IN_PREPARE)                                             \
	X(foot_cos, paths, PREPARED, 0.0f, IN_PREPARE, IN_PREPARE)                                           \
	X(foot_sin, paths, PREPARED, 0.0f, IN_PREPARE, IN_PREPARE)                                           \
	/* m: arc length of the foot from the start of the path, over all laps */                            \
	X(foot_along, paths, PREPARED, 0.0f, IN_PREPARE, IN_PREPARE)                                         \
	/* 1/m, 1/m^2: curvature at the foot, and its change along the path; m: target of the lock across */ \
	X(bend, paths, PREPARED, 0.0f, IN_POSED, IN_PREPARE)                                                 \
	X(sway, paths, PREPARED, 0.0f, IN_POSED, IN_PREPARE)                                                 \
	X(beside, paths, PREPARED, 0.0f, IN_POSED, IN_PREPARE)                                               \
	/* last position on the path: sample before it, laps; PATH_*: start of the next search */            \
	X(path_segment, paths, KEPT, 0.0f, IN_PREPARE, IN_PREPARE)                                           \
	X(path_laps, paths, KEPT, 0.0f, IN_PREPARE, IN_PREPARE)                                              \
	X(path_seeks, paths, KEPT, 0.0f, IN_PREPARE, IN_PREPARE)

#define JOINT_RARE_ROWS(X)                                                      \
	JOINT_DRIVE_ROWS(X, along)                                                  \
	JOINT_DRIVE_ROWS(X, across)                                                 \
	JOINT_DRIVE_ROWS(X, angle)                                                  \
	/* 1 if the joint has springs, and its bodies have no other constraints */  \
	X(springs_alone, has_drives, PREPARED, 0.0f, IN_BIAS, IN_PREPARE)           \
	/* N s, N m s: impulses, the largest of all substeps */                     \
	X(peak_force, has_drives, PREPARED, 0.0f, IN_RELAX, IN_PREPARE | IN_RELAX)  \
	X(peak_torque, has_drives, PREPARED, 0.0f, IN_RELAX, IN_PREPARE | IN_RELAX) \
	JOINT_COUPLING_ROWS(X)                                                      \
	JOINT_PATH_ROWS(X)

#define JOINT_STREAM(QUAD, PAIR)                                         \
	QUAD(0, name, u->modes, u->axis_x, u->axis_y)                        \
	QUAD(1, u->arm_a_x, u->arm_a_y, u->arm_b_x, u->arm_b_y)              \
	QUAD(2, u->gap_x, u->gap_y, u->length, u->angle)                     \
	QUAD(3, u->rate_along, u->rate_across, u->rate_angle, u->soft_along) \
	PAIR(0, IN_TURNS, IN_NONE, u->soft_across, u->soft_angle)            \
	PAIR(1, IN_PASSES, IN_POSED, u->impulse_along, u->impulse_across)    \
	PAIR(2, IN_PASSES, IN_POSED, u->impulse_angle, u->given_x)           \
	PAIR(3, IN_POSED, IN_POSED, u->given_y, u->given_a)                  \
	PAIR(4, IN_PASSES, IN_POSED, u->given_b, u->carried)

// Bytes that prepare gathers for a joint: its JointData, and the pose, pose_low and local_center of both bodies.
#define JOINT_GATHERS(step)  (sizeof(JointData) + 2 * (sizeof(Float4) + 2 * sizeof(Float2)))
#define JOINT_BOUNCE_GATHERS 0

#define JOINT_RARE(step) ((step)->has_drives)

struct JointRows
{
	CONSTRAINT_ENDS
	JOINT_ROWS(ROW_MEMBER)
};
struct JointRareRows
{
	JOINT_RARE_ROWS(ROW_MEMBER)
};
struct JointKept
{
	JOINT_ROWS(ROW_KEPT_MEMBER)
} KEPT_ALIGNED;
struct JointRareKept
{
	JOINT_RARE_ROWS(ROW_KEPT_MEMBER)
};

#define joint_row(p, name, i)  ((p)->joint_rows[(i) / MAX_LANES].name[(i) % MAX_LANES])
#define joint_rare(p, name, i) ((p)->joint_rare_rows[(i) / MAX_LANES].name[(i) % MAX_LANES])

// The drives of the three coordinates are the first rare rows; each drive has the same rows in the same order.
#define DRIVE_NUMBER(name, gate, life, inert, read, written) name,
enum
{
	JOINT_DRIVE_ROWS(DRIVE_NUMBER, DRIVE) DRIVE_ROW_COUNT
};
#define joint_drive_row(p, k, name, i)       \
	(((GLOBAL float*)((p)->joint_rare_rows + \
	                  (i) / MAX_LANES))[(DRIVE_ROW_COUNT * (k) + DRIVE_##name) * MAX_LANES + (i) % MAX_LANES])

typedef struct // a joint in registers
{
	JOINT_ROWS(ROW_REGISTER)
} Joint;

typedef struct // the bodies and the current coordinates of a joint
{
	Body a, b;
	Vec axis[2];                         // directions of the coordinates `along` and `across`
	Vec arm_a, arm_b;                    // arms from centers of mass to the anchor of body b; arm_a may be shortened
	Real lever_a[2], lever_b[2];         // levers of a unit impulse along the axes
	Real mass, value[JOINT_COORDINATES]; // 1/kg: sum of the inverse masses; m, m, rad: coordinates
	Word couples;
	Int coupled;
	Int torn;            // springs hold both translations, and are stretched so far that the arm of body a is shortened
	Vec axis_a, given_a; // for couplings: axis of `along` at body a; N s, impulse whose opposite was applied to body a
	Word rails;
	Int railed;
	Real bend; // in lanes on a path: 1/m, curvature of the parallel curve through anchor b
} JointPose;

// Returns the lanes that have at least one of the given modes.
INLINE Int joint_has(const Joint* u, int mode) { return (whole(u->modes) & mode) != 0; }

// Returns the lanes whose axes are those of the world. If rigid locks hold both translations, any axes are suitable,
// and impulses along axes of the world stay valid longer than impulses along axes of a body.
INLINE Int joint_upright(const Joint* u)
{
	return joint_has(u, JOINT_LOCKED(JOINT_ALONG)) & joint_has(u, JOINT_LOCKED(JOINT_ACROSS)) &
	       (joint_has(u, JOINT_SOFT(JOINT_ALONG) | JOINT_SOFT(JOINT_ACROSS) | JOINT_RAILED) == 0);
}

// Returns the direction of d, the vector between the anchors, in lanes with `radial`. Returns `axis` in other lanes,
// and if d is shorter than 1e-6 m or longer than 1e15 m.
INLINE Vec joint_line(Vec axis, Vec d, Int radial)
{
	Real square = vec_dot(d, d);
	Int apart = radial & (square > splat(1.0e-12f)) & (square < splat(1.0e30f));
	return vec_blend(axis, vec_scale(quotient(1.0f, root(blend(splat(1.0f), square, apart))), d), apart);
}

// Marks all lanes as having no coupling and no path, before coupling.h and path_constraint.h find any.
INLINE void joint_alone(JointPose* c)
{
	c->couples = c->rails = 0;
	c->coupled = c->railed = splat(0.0f) > splat(0.0f);
	c->bend = splat(0.0f);
	c->axis_a = c->given_a = vec(splat(0.0f), splat(0.0f));
}

#define JOINT_FAR 2.0f // error of locks above which the arm of body a is shortened; unit: radius of gyration of body a

// Returns the lanes in which soft locks hold both translations, and d, the vector between the anchors (m), is longer
// than JOINT_FAR radii of gyration. Their axes are those of the world, so that forces do not turn with body a: its arm
// is shortened and takes too little of the opposite torque, so a force that turns would spin body b ever faster.
INLINE Int joint_torn(const Pools* p, const Joint* u, const Body* a, Vec d)
{
	if (!p->step.springs)
		return joint_has(u, 0);
	Int springs = joint_has(u, JOINT_SOFT(JOINT_ALONG)) & joint_has(u, JOINT_SOFT(JOINT_ACROSS));
	springs = springs & (joint_has(u, JOINT_RADIAL | JOINT_COUPLED | JOINT_RAILED) == 0);
	return springs & (a->inv_inertia * vec_dot(d, d) > splat(JOINT_FAR * JOINT_FAR) * a->inv_mass);
}

// m: Returns how far a translation is outside its limits, negative below the lower limit; 0 between or without limits.
INLINE Real joint_beyond(const Pools* p, int i, const Joint* u, int k, Real value)
{
	Real zero = splat(0.0f);
	Int limited = joint_has(u, JOINT_LIMITED(k));
	if (!p->step.has_drives || !lane_bits(limited))
		return zero;
	Real lower = load(&joint_drive_row(p, k, lower, i), 0), upper = load(&joint_drive_row(p, k, upper, i), 0);
	return only(value - minimum(maximum(value, lower), upper), limited);
}

// Shortens the arm of body a if locks or limits have errors above JOINT_FAR. Normally the arm ends at the anchor of
// body b, so that no impulse of the joint changes the angular momentum. But on a very long arm impulses would turn body
// a, against its other joints, rather than pull body b back. So the arm then ends nearer to the anchor of body a.
INLINE void joint_shorten_arm(const Pools* p, int i, const Joint* u, JointPose* c)
{
	Real zero = splat(0.0f), one = splat(1.0f), off[2], square = zero;
	Int others = joint_has(u, JOINT_RADIAL | JOINT_COUPLED | JOINT_RAILED);
	UNROLL
	for (int k = 0; k < 2; ++k)
	{
		Int rigid = joint_has(u, JOINT_LOCKED(k)) & ((joint_has(u, JOINT_SOFT(k)) == 0) | c->torn);
		off[k] = blend(blend(joint_beyond(p, i, u, k, c->value[k]), c->value[k], rigid), zero, others);
		square = square + off[k] * off[k];
	}
	Real bound = splat(JOINT_FAR * JOINT_FAR) * c->a.inv_mass, turns = c->a.inv_inertia * square;
	Int far = turns > bound;
	if (!lane_bits(far))
		return;
	Real less = one - root(quotient(bound, blend(one, turns, far)));
	UNROLL
	for (int k = 0; k < 2; ++k)
	{
		// blend, because adding 0 in the other lanes of a block could change the sign of a zero there
		c->arm_a = vec_blend(c->arm_a, vec_sub(c->arm_a, vec_scale(less * off[k], c->axis[k])), far);
		c->lever_a[k] = blend(c->lever_a[k], c->lever_a[k] + less * (k == 0 ? off[1] : -off[0]), far);
	}
}

// Computes the other members of *c from the bodies c->a and c->b, without the effects of couplings and paths.
OUT_OF_LINE void joint_pose(const Pools* p, int i, const Joint* u, JointPose* c)
{
	const Body *a = &c->a, *b = &c->b;
	Vec arm_a = vec(u->arm_a_x, u->arm_a_y), arm_b = vec(u->arm_b_x, u->arm_b_y), axis = vec(u->axis_x, u->axis_y);
	Vec swing_a = vec_sub(body_displacement(*a, arm_a), a->d), swing_b = vec_sub(body_displacement(*b, arm_b), b->d);
	Vec d = vec_add(vec(u->gap_x, u->gap_y), vec_add(vec_sub(b->d, a->d), vec_sub(swing_b, swing_a)));
	Real angle = u->angle + (b->da - a->da);

	// a body whose state is not finite must not affect the other body
	Int sound = absolute(((d.x + d.y) + (swing_a.x + swing_b.x)) + angle) <= splat(MOST_FLOAT);
	Vec zero = vec(splat(0.0f), splat(0.0f));
	d = vec_blend(zero, d, sound);
	swing_a = vec_blend(zero, swing_a, sound);
	swing_b = vec_blend(zero, swing_b, sound);
	c->arm_a = vec_add(vec_add(arm_a, swing_a), d);
	c->arm_b = vec_add(arm_b, swing_b);

	Vec turned = vec_blend(axis, vec_add(axis, vec_sub(body_displacement(*a, axis), a->d)), sound);
	axis = vec_blend(axis, turned, joint_has(u, JOINT_TURNS));
	Int radial = joint_has(u, JOINT_RADIAL);
	if (lane_bits(radial))
		axis = joint_line(axis, d, radial);
	c->torn = joint_torn(p, u, a, d);
	if (p->step.springs)
		axis = vec_blend(axis, vec(splat(1.0f), splat(0.0f)), c->torn);
	c->axis[0] = axis;
	c->axis[1] = vec(-axis.y, axis.x);
	UNROLL
	for (int k = 0; k < 2; ++k)
	{
		c->lever_a[k] = vec_cross(c->arm_a, c->axis[k]);
		c->lever_b[k] = vec_cross(c->arm_b, c->axis[k]);
		c->value[k] = flush_tiny(vec_dot(d, c->axis[k]));
	}
	c->value[JOINT_ANGLE] = only(flush_tiny(angle), sound);
	c->mass = a->inv_mass + b->inv_mass;
	joint_alone(c);
	joint_shorten_arm(p, i, u, c);
}

// m/s: Returns the speed of coordinate k, along or across; k is a constant at compile time.
INLINE Real joint_speed_linear(const JointPose* c, int k)
{
	Real spin = c->lever_b[k] * c->b.w - c->lever_a[k] * c->a.w;
	Real speed = vec_dot(vec_sub(c->b.v, c->a.v), c->axis[k]) + spin;
	if (k != JOINT_ALONG || !c->couples)
		return speed;
	return blend(speed, (vec_dot(c->b.v, c->axis[0]) - vec_dot(c->a.v, c->axis_a)) + spin, c->coupled);
}

// m/s, rad/s: Returns the speed of coordinate k. On a path, the angle also changes because the tangent turns.
INLINE Real joint_speed(const JointPose* c, int k)
{
	if (k != JOINT_ANGLE)
		return flush_tiny(joint_speed_linear(c, k));
	Real speed = c->b.w - c->a.w;
	if (c->rails)
		speed = blend(speed, speed - c->bend * joint_speed_linear(c, JOINT_ALONG), c->railed);
	return flush_tiny(speed);
}

INLINE Real joint_yield_linear(const JointPose* c, int k)
{
	Real mass = c->mass;
	if (k == JOINT_ALONG && c->couples)
		mass =
		    blend(mass, c->a.inv_mass * vec_dot(c->axis_a, c->axis_a) + c->b.inv_mass * vec_dot(c->axis[0], c->axis[0]),
		          c->coupled);
	return mass + c->a.inv_inertia * c->lever_a[k] * c->lever_a[k] + c->b.inv_inertia * c->lever_b[k] * c->lever_b[k];
}

// 1/(kg m): Returns the change of the angle's speed by a unit impulse along or across, for a joint without a path.
INLINE Real joint_yield_turning(const JointPose* c, int k)
{
	return flush_element(c->a.inv_inertia * c->lever_a[k] + c->b.inv_inertia * c->lever_b[k]);
}

// 1/kg, 1/(kg m^2): Returns the yield of coordinate k: speed change by a unit impulse, the inverse effective mass.
INLINE Real joint_yield(const JointPose* c, int k)
{
	if (k != JOINT_ANGLE)
		return joint_yield_linear(c, k);
	Real own = c->a.inv_inertia + c->b.inv_inertia;
	if (!c->rails)
		return own;
	Real along = c->bend * joint_yield_linear(c, JOINT_ALONG) - 2.0f * joint_yield_turning(c, JOINT_ALONG);
	return blend(own, own + c->bend * along, c->railed);
}

typedef struct // N s, N m s: push and angular_b act on body b, the opposite of push_a and angular_a on body a
{
	Vec push, push_a;
	Real angular_a, angular_b;
} JointImpulse;

INLINE JointImpulse joint_impulse(const JointPose* c, Real along, Real across, Real angle)
{
	JointImpulse j;
	if (c->rails)
		along = blend(along, along - c->bend * angle, c->railed);
	j.push = vec_add(vec_scale(along, c->axis[0]), vec_scale(across, c->axis[1]));
	j.angular_a = along * c->lever_a[0] + across * c->lever_a[1] + angle;
	j.angular_b = along * c->lever_b[0] + across * c->lever_b[1] + angle;
	j.push_a = c->couples ? vec_blend(j.push, vec_scale(along, c->axis_a), c->coupled) : j.push;
	return j;
}

// Applies impulses to both bodies, and adds them to the sums of applied impulses that the joint stores.
INLINE void joint_give(Joint* u, JointPose* c, JointImpulse j)
{
	c->a.v = vec_sub(c->a.v, vec_scale(c->a.inv_mass, j.push_a));
	c->a.w = c->a.w - c->a.inv_inertia * j.angular_a;
	c->b.v = vec_add(c->b.v, vec_scale(c->b.inv_mass, j.push));
	c->b.w = c->b.w + c->b.inv_inertia * j.angular_b;
	u->given_x = u->given_x + j.push.x;
	u->given_y = u->given_y + j.push.y;
	u->given_a = u->given_a + j.angular_a;
	u->given_b = u->given_b + j.angular_b;
	if (c->couples)
		c->given_a = vec_add(c->given_a, j.push_a);
}

INLINE void joint_give_where(Joint* u, JointPose* c, JointImpulse j, Int wanted)
{
	Joint now = *u;
	JointPose then = *c;
	joint_give(&now, &then, j);
	c->a.v = vec_blend(c->a.v, then.a.v, wanted);
	c->a.w = blend(c->a.w, then.a.w, wanted);
	c->b.v = vec_blend(c->b.v, then.b.v, wanted);
	c->b.w = blend(c->b.w, then.b.w, wanted);
	u->given_x = blend(u->given_x, now.given_x, wanted);
	u->given_y = blend(u->given_y, now.given_y, wanted);
	u->given_a = blend(u->given_a, now.given_a, wanted);
	u->given_b = blend(u->given_b, now.given_b, wanted);
	c->given_a = vec_blend(c->given_a, then.given_a, wanted);
}

// Returns an impulse, or 0 if it changes the speed of a coordinate with this yield by less than TINY; for heavy bodies.
INLINE Real joint_felt(Real impulse, Real yield) { return only(impulse, absolute(impulse) * yield >= splat(TINY)); }

// Returns an impulse as bounded_impulse does and, beside heavy bodies, as joint_felt.
OUT_OF_LINE Real joint_bounded(const Step* step, Real impulse, Real yield)
{
	impulse = bounded_impulse(impulse);
	return step->heavy ? joint_felt(impulse, yield) : impulse;
}

#endif
