// SPDX-License-Identifier: MIT
// chain_solve.h -- the linear system of a chain of joints, by cyclic reduction: a work-group eliminates every second joint at once.
//
// The system is symmetric and block tridiagonal with blocks of 3 x 3, one row of blocks for each joint. Its solution is exact, so
// a load at one end acts on the other end within a pass, whatever the masses between them.
//
// This work is based on:
// Bill Buzbee, Gene Golub, Clair Nielson, On Direct Methods for Solving Poisson's Equations, 1970: cyclic reduction.
// David Baraff, Linear-Time Dynamics using Lagrange Multipliers, 1996: direct solution of joints.
#ifndef CHAIN_SOLVE_H
#define CHAIN_SOLVE_H
#include "pools/pools.h"

#define CHAIN_PIVOT 1.0e-6f // least share of its diagonal that a pivot keeps: below it is rounding

// Components of a joint in chain_joints are MAX_LANES floats apart: the n-th one of a block that begins at v.
#define CHAIN_OF(v, n) (v)[(n)*MAX_LANES]

// The inverse of a symmetric block: 00, 01, 02, 11, 12, 22, by L D L^T.
INLINE void chain_invert(GLOBAL float* block)
{
	float d[6];
	for (int n = 0; n < 6; ++n)
		d[n] = CHAIN_OF(block, n);
	float d0 = d[0], l1 = d[1] / d0, l2 = d[2] / d0, d1 = d[3] - l1 * d[1], rest = d[4] - l1 * d[2];
	d1 = d1 > CHAIN_PIVOT * d[3] ? d1 : CHAIN_PIVOT * d[3];
	float l12 = rest / d1, d2 = (d[5] - l2 * d[2]) - l12 * rest;
	d2 = d2 > CHAIN_PIVOT * d[5] ? d2 : CHAIN_PIVOT * d[5];
	// columns of the inverse of L are (1, -l1, l1 l12 - l2), (0, 1, -l12), (0, 0, 1)
	float m2 = l1 * l12 - l2, i0 = 1.0f / d0, i1 = 1.0f / d1, i2 = 1.0f / d2;
	CHAIN_OF(block, 0) = i0 + (l1 * i1 * l1 + m2 * i2 * m2);
	CHAIN_OF(block, 1) = -l1 * i1 - m2 * i2 * l12;
	CHAIN_OF(block, 2) = m2 * i2;
	CHAIN_OF(block, 3) = i1 + l12 * i2 * l12;
	CHAIN_OF(block, 4) = -l12 * i2;
	CHAIN_OF(block, 5) = i2;
}

// A symmetric block times a vector.
INLINE void chain_times(const GLOBAL float* d, const float v[3], float out[3])
{
	out[0] = CHAIN_OF(d, 0) * v[0] + CHAIN_OF(d, 1) * v[1] + CHAIN_OF(d, 2) * v[2];
	out[1] = CHAIN_OF(d, 1) * v[0] + CHAIN_OF(d, 3) * v[1] + CHAIN_OF(d, 4) * v[2];
	out[2] = CHAIN_OF(d, 2) * v[0] + CHAIN_OF(d, 4) * v[1] + CHAIN_OF(d, 5) * v[2];
}

// Takes the joint at spot `other`, eliminated, out of the one at spot k: side is -1 if it comes before, 1 if behind. l is the
// block that couples the two.
INLINE void chain_take(const Pools* p, int k, int other, const GLOBAL float* l, int side, float coupled[9])
{
	const GLOBAL float *d = &chain_at(p, d[0], other), *r = &chain_at(p, r[0], other);
	float row[3][3], times[3][3], column[3];
	for (int i = 0; i < 3; ++i)
		for (int j = 0; j < 3; ++j)
			row[i][j] = side > 0 ? CHAIN_OF(l, 3 * j + i) : CHAIN_OF(l, 3 * i + j);
	for (int i = 0; i < 3; ++i)
		chain_times(d, row[i], times[i]); // row i of coupling times inverse
	for (int i = 0; i < 3; ++i)
		chain_at(p, r[i], k) -=
		    times[i][0] * CHAIN_OF(r, 0) + times[i][1] * CHAIN_OF(r, 1) + times[i][2] * CHAIN_OF(r, 2);
	for (int i = 0, n = 0; i < 3; ++i)
		for (int j = i; j < 3; ++j, ++n)
			chain_at(p, d[n], k) -= times[i][0] * row[j][0] + times[i][1] * row[j][1] + times[i][2] * row[j][2];
	// what couples k with the joint before the one that was taken out
	for (int i = 0; i < 3 && side < 0; ++i)
	{
		for (int j = 0; j < 3; ++j)
		{
			for (int m = 0; m < 3; ++m)
				column[m] = chain_at(p, l[3 * m + j], other);
			coupled[3 * i + j] = -(times[i][0] * column[0] + times[i][1] * column[1] + times[i][2] * column[2]);
		}
	}
}

// The solution of joint k, which lies between two that are solved, top joints away.
INLINE void chain_back(const Pools* p, int first, int count, int k, int top)
{
	int spot = first + CHAIN_SPOT(count, k), before = first + CHAIN_SPOT(count, k - top);
	float r[3], x[3];
	for (int i = 0; i < 3; ++i)
		r[i] = chain_at(p, r[i], spot) - (chain_at(p, l[3 * i], spot) * chain_at(p, x[0], before) +
		                                  chain_at(p, l[3 * i + 1], spot) * chain_at(p, x[1], before) +
		                                  chain_at(p, l[3 * i + 2], spot) * chain_at(p, x[2], before));
	if (k + top < count)
	{
		int behind = first + CHAIN_SPOT(count, k + top);
		for (int i = 0; i < 3; ++i)
			r[i] -= chain_at(p, m[i], spot) * chain_at(p, x[0], behind) +
			        chain_at(p, m[3 + i], spot) * chain_at(p, x[1], behind) +
			        chain_at(p, m[6 + i], spot) * chain_at(p, x[2], behind);
	}
	chain_times(&chain_at(p, d[0], spot), r, x);
	for (int i = 0; i < 3; ++i)
		chain_at(p, x[i], spot) = x[i];
}

// Solves the system of a chain by a group: so many joints from spot first on, each of which has d, l and r.
INLINE void chain_solve(const Pools* p, int first, int count)
{
	int top = 1;
	for (; top < count; top *= 2)
	{
		group_meet();
		for (int k = (2 * part_lane() + 1) * top; k < count; k += 2 * top * part_width())
		{
			int spot = first + CHAIN_SPOT(count, k), behind = first + CHAIN_SPOT(count, k + top);
			chain_invert(&chain_at(p, d[0], spot));
			for (int n = 0; n < 9 && k + top < count; ++n)
				chain_at(p, m[n], spot) = chain_at(p, l[n], behind);
		}
		group_meet();
		for (int k = 2 * part_lane() * top; k < count; k += 2 * top * part_width())
		{
			int spot = first + CHAIN_SPOT(count, k), behind = first + CHAIN_SPOT(count, k + top);
			float coupled[9];
			if (k + top < count)
				chain_take(p, spot, behind, &chain_at(p, l[0], behind), 1, coupled);
			if (k < top)
				continue;
			chain_take(p, spot, first + CHAIN_SPOT(count, k - top), &chain_at(p, l[0], spot), -1, coupled);
			for (int n = 0; n < 9; ++n)
				chain_at(p, l[n], spot) = coupled[n];
		}
	}
	group_meet();
	if (group_lane() == 0)
	{
		float r[3] = {chain_at(p, r[0], first), chain_at(p, r[1], first), chain_at(p, r[2], first)}, x[3];
		chain_invert(&chain_at(p, d[0], first));
		chain_times(&chain_at(p, d[0], first), r, x);
		for (int i = 0; i < 3; ++i)
			chain_at(p, x[i], first) = x[i];
	}
	for (top /= 2; top >= 1; top /= 2)
	{
		group_meet();
		for (int k = (2 * part_lane() + 1) * top; k < count; k += 2 * top * part_width())
			chain_back(p, first, count, k, top);
	}
	group_meet();
}

#endif
