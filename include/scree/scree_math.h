// SPDX-License-Identifier: MIT
// scree_math.h -- arithmetic of vectors, rotations and poses, and random numbers, for programs that use Scree, in static inline
// functions.
//
// The library does not need this header. All functions have the units of their arguments and no errors; a NaN gives NaN.
//
// Determinism. Sums of products are computed in double and rounded once to float. The product of two floats is exact in
// double, so the result has the same bits whether or not a compiler fuses products and sums. Angles become rotations in the
// library, by scree_rot_make. A compiler may still fuse a product that a function returns with a sum of the program, and
// -ffast-math changes any bits: docs/manual/determinism.md has the options for a game that gives results to the library.
#ifndef SCREE_MATH_H
#define SCREE_MATH_H

#include "scree.h"
#include <math.h>

#if defined(__GNUC__)
#define SCREE_MATH static inline __attribute__((warn_unused_result)) // a result is all that these functions have
#else
#define SCREE_MATH static inline
#endif

#ifdef __cplusplus
extern "C" {
#endif

// ---------------------------------------------------------------------------------------------------------------
// Vectors
// ---------------------------------------------------------------------------------------------------------------

// Returns the vector (x, y).
SCREE_MATH scree_vec scree_vec_make(float x, float y)
{
	scree_vec v = {x, y};
	return v;
}

// Returns a + b.
SCREE_MATH scree_vec scree_vec_add(scree_vec a, scree_vec b) { return scree_vec_make(a.x + b.x, a.y + b.y); }

// Returns a - b.
SCREE_MATH scree_vec scree_vec_sub(scree_vec a, scree_vec b) { return scree_vec_make(a.x - b.x, a.y - b.y); }

// Returns -v.
SCREE_MATH scree_vec scree_vec_negate(scree_vec v) { return scree_vec_make(-v.x, -v.y); }

// Returns factor * v.
SCREE_MATH scree_vec scree_vec_scale(float factor, scree_vec v) { return scree_vec_make(factor * v.x, factor * v.y); }

// Returns v rotated by a quarter turn, counter-clockwise: (-y, x).
SCREE_MATH scree_vec scree_vec_turn(scree_vec v) { return scree_vec_make(-v.y, v.x); }

// Returns the dot product, |a| |b| cos(angle from a to b).
SCREE_MATH float scree_vec_dot(scree_vec a, scree_vec b)
{
	return (float)((double)a.x * (double)b.x + (double)a.y * (double)b.y);
}

// Returns the cross product, |a| |b| sin(angle from a to b): positive if b is counter-clockwise from a.
SCREE_MATH float scree_vec_cross(scree_vec a, scree_vec b)
{
	return (float)((double)a.x * (double)b.y - (double)a.y * (double)b.x);
}

// Returns the length.
SCREE_MATH float scree_vec_length(scree_vec v)
{
	return (float)sqrt((double)v.x * (double)v.x + (double)v.y * (double)v.y);
}

// Returns the distance between two points.
SCREE_MATH float scree_vec_distance(scree_vec a, scree_vec b) { return scree_vec_length(scree_vec_sub(b, a)); }

// Returns the vector of length 1 with the direction of v; (0, 0) if v is (0, 0).
SCREE_MATH scree_vec scree_vec_normalize(scree_vec v)
{
	double length = sqrt((double)v.x * (double)v.x + (double)v.y * (double)v.y);
	return length == 0.0 ? v : scree_vec_make((float)((double)v.x / length), (float)((double)v.y / length));
}

// Returns (1 - t) a + t b: a for t 0, b for t 1.
SCREE_MATH float scree_lerp(float a, float b, float t)
{
	float rest = 1.0f - t;
	return (float)((double)rest * (double)a + (double)t * (double)b);
}

// Returns (1 - t) a + t b.
SCREE_MATH scree_vec scree_vec_lerp(scree_vec a, scree_vec b, float t)
{
	return scree_vec_make(scree_lerp(a.x, b.x, t), scree_lerp(a.y, b.y, t));
}

// ---------------------------------------------------------------------------------------------------------------
// Rotations
// ---------------------------------------------------------------------------------------------------------------

// Returns the rotation by `first` followed by the rotation by `then`; the order makes no difference.
SCREE_MATH scree_rot scree_rot_multiply(scree_rot then, scree_rot first)
{
	scree_rot r;
	r.c = (float)((double)then.c * (double)first.c - (double)then.s * (double)first.s);
	r.s = (float)((double)then.s * (double)first.c + (double)then.c * (double)first.s);
	return r;
}

// Returns the opposite rotation.
SCREE_MATH scree_rot scree_rot_invert(scree_rot rotation)
{
	scree_rot r = {rotation.c, -rotation.s};
	return r;
}

// Returns a vector rotated by a rotation.
SCREE_MATH scree_vec scree_rot_apply(scree_rot rotation, scree_vec v)
{
	double c = (double)rotation.c, s = (double)rotation.s;
	return scree_vec_make((float)(c * (double)v.x - s * (double)v.y), (float)(s * (double)v.x + c * (double)v.y));
}

// Returns a vector rotated by the opposite of a rotation.
SCREE_MATH scree_vec scree_rot_apply_inverse(scree_rot rotation, scree_vec v)
{
	return scree_rot_apply(scree_rot_invert(rotation), v);
}

// Returns a rotation between two others, with a length of 1: a for t 0, b for t 1. The way from a to b must be less than half
// a turn. Its angle is not proportional to t, but differs from that by at most 4.1 degrees for a quarter turn.
SCREE_MATH scree_rot scree_rot_lerp(scree_rot a, scree_rot b, float t)
{
	scree_vec v = scree_vec_normalize(scree_vec_make(scree_lerp(a.c, b.c, t), scree_lerp(a.s, b.s, t)));
	scree_rot r = {v.x, v.y};
	return r;
}

// ---------------------------------------------------------------------------------------------------------------
// Poses
// ---------------------------------------------------------------------------------------------------------------

// Returns the pose at (x, y), m, that is rotated by an angle, radians.
SCREE_MATH scree_pose scree_pose_make(float x, float y, float radians)
{
	scree_pose pose;
	pose.position = scree_vec_make(x, y);
	pose.rotation = scree_rot_make(radians);
	return pose;
}

// Returns a point of the frame of a pose in the world.
SCREE_MATH scree_vec scree_pose_apply(scree_pose pose, scree_vec local)
{
	return scree_vec_add(scree_rot_apply(pose.rotation, local), pose.position);
}

// Returns a point of the world in the frame of a pose.
SCREE_MATH scree_vec scree_pose_apply_inverse(scree_pose pose, scree_vec point)
{
	return scree_rot_apply_inverse(pose.rotation, scree_vec_sub(point, pose.position));
}

// Returns the world pose of `inner`, which is given in the frame of the pose `outer`.
SCREE_MATH scree_pose scree_pose_multiply(scree_pose outer, scree_pose inner)
{
	scree_pose pose;
	pose.position = scree_pose_apply(outer, inner.position);
	pose.rotation = scree_rot_multiply(outer.rotation, inner.rotation);
	return pose;
}

// Returns the pose of the world in the frame of a pose.
SCREE_MATH scree_pose scree_pose_invert(scree_pose pose)
{
	scree_pose inverse;
	inverse.position = scree_rot_apply_inverse(pose.rotation, scree_vec_negate(pose.position));
	inverse.rotation = scree_rot_invert(pose.rotation);
	return inverse;
}

// Returns a pose between two others, for instance to draw a body between two steps: a for t 0, b for t 1.
SCREE_MATH scree_pose scree_pose_lerp(scree_pose a, scree_pose b, float t)
{
	scree_pose pose;
	pose.position = scree_vec_lerp(a.position, b.position, t);
	pose.rotation = scree_rot_lerp(a.rotation, b.rotation, t);
	return pose;
}

// ---------------------------------------------------------------------------------------------------------------
// Random numbers
//
// They are a function of four counters and have no state, so worlds that are stepped in any order, by any thread and in any
// process get the same numbers. Philox4x32-10 of John Salmon, Mark Moraes, Ron Dror, David Shaw, Parallel Random Numbers: As
// Easy as 1, 2, 3, 2011.
// ---------------------------------------------------------------------------------------------------------------

typedef struct scree_random // four independent random numbers
{
	uint32_t words[4];
} scree_random;

// Returns four random numbers, others for each seed, world, step and index. world: number of a world in all processes; step: for
// instance number of the step or of the episode; index: number of the draw within one world and step.
SCREE_MATH scree_random scree_random_make(uint64_t seed, uint64_t world, uint32_t step, uint32_t index)
{
	uint32_t key[2] = {(uint32_t)seed, (uint32_t)(seed >> 32)};
	scree_random r = {{index, step, (uint32_t)world, (uint32_t)(world >> 32)}};
	for (int round = 0; round < 10; ++round)
	{
		const uint64_t a = (uint64_t)0xd2511f53u * r.words[0], b = (uint64_t)0xcd9e8d57u * r.words[2];
		const scree_random next = {{(uint32_t)(b >> 32) ^ r.words[1] ^ key[0], (uint32_t)b,
		                            (uint32_t)(a >> 32) ^ r.words[3] ^ key[1], (uint32_t)a}};
		r = next;
		key[0] += 0x9e3779b9u;
		key[1] += 0xbb67ae85u;
	}
	return r;
}

// Returns a number from low to high that is proportional to the upper 24 bits of a word of scree_random.
SCREE_MATH float scree_random_between(uint32_t word, float low, float high)
{
	return scree_lerp(low, high, (float)(word >> 8) * (1.0f / 16777216.0f));
}

#ifdef __cplusplus
}
#endif
#endif
