// SPDX-License-Identifier: MIT
// path_one.h -- finds the position of a joint on its path at the start of a step, for one joint at a time.
//
// A search begins at the position of the last step and follows the path while the distance to anchor b decreases, so a
// joint stays on its branch of a path that crosses itself. Only new joints, and joints of which a body or a frame was
// placed, search the whole path.
#ifndef PATH_ONE_H
#define PATH_ONE_H
#include "constraints/joint_prepare.h"
#include "constraints/path_curve.h"

#define PATH_GOES_ON 0.0f // the next search starts at the last position
#define PATH_SEEKS   1.0f // the same, but then the whole path is searched for a nearer part
#define PATH_NEW     2.0f // the next search starts at JointData.near; then the whole path is searched

// Factor by which another part of the path must be nearer than the current part, so that a joint changes to it; with a
// smaller factor, joints change branch at crossings.
#define PATH_NEARER 2.0f

// Tolerance at the seam, the point at which a closed path begins and ends, as a share of the spacing of samples. If arc
// lengths of a new joint and `near` differ by more than a lap minus this tolerance, the seam is between the two.
#define PATH_SEAM 0.0625f

typedef struct // last position of a joint on its path; `seeks`: PATH_*
{
	float segment, laps, seeks;
} PathCount;

INLINE PathCount path_count_new(void)
{
	PathCount count = {0.0f, 0.0f, PATH_NEW};
	return count;
}

INLINE PathCount path_count_at(const Pools* p, int place)
{
	PathCount count = {joint_rare(p, path_segment, place), joint_rare(p, path_laps, place),
	                   joint_rare(p, path_seeks, place)};
	return count;
}

INLINE void path_count_put(const Pools* p, int place, const PathCount* count)
{
	joint_rare(p, path_segment, place) = count->segment;
	joint_rare(p, path_laps, place) = count->laps;
	joint_rare(p, path_seeks, place) = count->seeks;
}

// Returns the number of the lap in which an arc length over all laps lies; 0 on an open path.
INLINE float path_lap(const PathCurve* curve, float along)
{
	float laps = curve->closed ? (float)(int)quotient(along, curve->length) : 0.0f;
	return curve->closed && along < laps * curve->length ? laps - 1.0f : laps;
}

INLINE float path_spacing(const PathCurve* curve) { return quotient(curve->length, (float)curve->segments); }

// Returns the number of the lap in which a new joint begins: that of `near`, or a neighboring one if the seam is
// between `near` and the joint. near: m, JointData.near, over all laps. along: m, arc length of the joint in a lap.
INLINE float path_first_lap(const PathCurve* curve, float near, float along)
{
	float laps = path_lap(curve, near), ahead = (along + laps * curve->length) - near;
	float lap = curve->length - PATH_SEAM * path_spacing(curve);
	return curve->closed ? laps + (ahead > lap ? -1.0f : ahead < -lap ? 1.0f : 0.0f) : laps;
}

// Returns the point of the path at which the joint in `slot` is now; its arc length is over all laps. Updates *count.
INLINE PathFoot path_follow(const Pools* p, int slot, PathCount* count)
{
	const GLOBAL JointData* data = p->joint_data + slot;
	PathCurve curve =
	    path_curve(p->path_sample + (bay_path(p, slot) + (int)data->path_first), (int)data->path_segments);
	JointFrame a = joint_frame(p, slot, JOINT_AT_FRAME(0), data->body_a, vec(0.0f, 0.0f));
	JointFrame b = joint_frame(p, slot, JOINT_AT_FRAME(1), data->body_b, vec(0.0f, 0.0f));
	Vec anchor = vec_turn_back(a.turn, joint_gap(&a, &b));
	if (count->seeks == PATH_NEW)
		count->segment = (float)path_segment(&curve, data->near[0] - path_lap(&curve, data->near[0]) * curve.length);
	int begin = (int)count->segment, segment = path_descend(&curve, anchor, begin, &count->laps);
	PathFoot foot = path_foot(&curve, segment, anchor);
	if (count->seeks != PATH_GOES_ON)
	{
		float none = 0.0f;
		int other = path_descend(&curve, anchor, path_nearest(&curve, anchor), &none);
		PathFoot nearest = path_foot(&curve, other, anchor);
		if (path_distance(&foot, anchor) > PATH_NEARER * path_distance(&nearest, anchor) + path_spacing(&curve))
		{
			// laps that bring the new arc length as close as possible to that of the last position
			float back = quotient(curve.samples[begin].along - nearest.along, curve.length);
			count->laps = count->laps + (curve.closed ? joint_round(back) : 0.0f);
			segment = other;
			foot = nearest;
		}
	}
	if (count->seeks == PATH_NEW)
		count->laps = path_first_lap(&curve, data->near[0], foot.along);
	count->segment = (float)segment;
	count->seeks = PATH_GOES_ON;
	foot.along = foot.along + count->laps * curve.length;
	return foot;
}

INLINE void path_foot_put(const Pools* p, int place, const PathFoot* foot)
{
	joint_rare(p, foot_x, place) = foot->point.x;
	joint_rare(p, foot_y, place) = foot->point.y;
	joint_rare(p, foot_cos, place) = foot->tangent.x;
	joint_rare(p, foot_sin, place) = foot->tangent.y;
	joint_rare(p, foot_along, place) = foot->along;
	joint_rare(p, bend, place) = foot->bend;
	joint_rare(p, sway, place) = foot->sway;
}

#endif
