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

// The inverse of a symmetric block: 00, 01, 02, 11, 12, 22, by L D L^T.
INLINE void chain_invert(GLOBAL float* d)
{
	float d0 = d[0], l1 = d[1] / d0, l2 = d[2] / d0, d1 = d[3] - l1 * d[1], rest = d[4] - l1 * d[2];
	d1 = d1 > CHAIN_PIVOT * d[3] ? d1 : CHAIN_PIVOT * d[3];
	float l12 = rest / d1, d2 = (d[5] - l2 * d[2]) - l12 * rest;
	d2 = d2 > CHAIN_PIVOT * d[5] ? d2 : CHAIN_PIVOT * d[5];
	// columns of the inverse of L are (1, -l1, l1 l12 - l2), (0, 1, -l12), (0, 0, 1)
	float m2 = l1 * l12 - l2, i0 = 1.0f / d0, i1 = 1.0f / d1, i2 = 1.0f / d2;
	d[0] = i0 + (l1 * i1 * l1 + m2 * i2 * m2);
	d[1] = -l1 * i1 - m2 * i2 * l12;
	d[2] = m2 * i2;
	d[3] = i1 + l12 * i2 * l12;
	d[4] = -l12 * i2;
	d[5] = i2;
}

// A symmetric block times a vector.
INLINE void chain_times(const GLOBAL float* d, const float v[3], float out[3])
{
	out[0] = d[0] * v[0] + d[1] * v[1] + d[2] * v[2];
	out[1] = d[1] * v[0] + d[3] * v[1] + d[4] * v[2];
	out[2] = d[2] * v[0] + d[4] * v[1] + d[5] * v[2];
}

// Block l of joint k couples it (rows) with the joint before it (columns). at(l, row, column): turned is the transpose.
INLINE float chain_at(const GLOBAL float* l, int row, int column, int turned)
{
	return turned ? l[3 * column + row] : l[3 * row + column];
}

// Takes joint `other`, eliminated, out of joint k: side is -1 if it comes before, 1 if behind.
INLINE void chain_take(GLOBAL ChainJoint* k, const GLOBAL ChainJoint* other, const GLOBAL float* l, int side,
                       float coupled[9])
{
	float row[3][3], times[3][3], column[3];
	for (int i = 0; i < 3; ++i)
		for (int j = 0; j < 3; ++j)
			row[i][j] = chain_at(l, i, j, side > 0);
	for (int i = 0; i < 3; ++i)
		chain_times(other->d, row[i], times[i]); // row i of coupling times inverse
	for (int i = 0; i < 3; ++i)
		k->r[i] -= times[i][0] * other->r[0] + times[i][1] * other->r[1] + times[i][2] * other->r[2];
	for (int i = 0, n = 0; i < 3; ++i)
		for (int j = i; j < 3; ++j, ++n)
			k->d[n] -= times[i][0] * row[j][0] + times[i][1] * row[j][1] + times[i][2] * row[j][2];
	// what couples k with the joint before the one that was taken out
	for (int i = 0; i < 3 && side < 0; ++i)
	{
		for (int j = 0; j < 3; ++j)
		{
			for (int m = 0; m < 3; ++m)
				column[m] = other->l[3 * m + j];
			coupled[3 * i + j] = -(times[i][0] * column[0] + times[i][1] * column[1] + times[i][2] * column[2]);
		}
	}
}

// Solves the system of so many joints by a group; every joint has d, l and r.
INLINE void chain_solve(GLOBAL ChainJoint* joint, int count)
{
	int top = 1;
	for (; top < count; top *= 2)
	{
		group_meet();
		for (int k = (2 * group_lane() + 1) * top; k < count; k += 2 * top * group_width())
		{
			chain_invert(joint[k].d);
			for (int n = 0; n < 9 && k + top < count; ++n)
				joint[k].m[n] = joint[k + top].l[n];
		}
		group_meet();
		for (int k = 2 * group_lane() * top; k < count; k += 2 * top * group_width())
		{
			float coupled[9] = {0.0f};
			if (k + top < count)
				chain_take(joint + k, joint + k + top, joint[k + top].l, 1, coupled);
			if (k >= top)
			{
				chain_take(joint + k, joint + k - top, joint[k].l, -1, coupled);
				for (int n = 0; n < 9; ++n)
					joint[k].l[n] = coupled[n];
			}
		}
	}
	group_meet();
	if (group_lane() == 0)
	{
		float r[3] = {joint[0].r[0], joint[0].r[1], joint[0].r[2]}, x[3];
		chain_invert(joint[0].d);
		chain_times(joint[0].d, r, x);
		for (int i = 0; i < 3; ++i)
			joint[0].x[i] = x[i];
	}
	for (top /= 2; top >= 1; top /= 2)
	{
		group_meet();
		for (int k = (2 * group_lane() + 1) * top; k < count; k += 2 * top * group_width())
		{
			float r[3], x[3];
			for (int i = 0; i < 3; ++i)
			{
				const GLOBAL float* before = joint[k - top].x;
				r[i] = joint[k].r[i] - (joint[k].l[3 * i] * before[0] + joint[k].l[3 * i + 1] * before[1] +
				                        joint[k].l[3 * i + 2] * before[2]);
				if (k + top < count)
				{
					const GLOBAL float *behind = joint[k + top].x, *m = joint[k].m;
					r[i] -= m[i] * behind[0] + m[3 + i] * behind[1] + m[6 + i] * behind[2];
				}
			}
			chain_times(joint[k].d, r, x);
			for (int i = 0; i < 3; ++i)
				joint[k].x[i] = x[i];
		}
	}
	group_meet();
}

#endif
