// SPDX-License-Identifier: MIT
// chain_block.h -- one step of cyclic reduction (chain_solve.h), for one joint or for several.
//
// Included once for each way: NUMBER is the type of a number, SOLVES(name) the name of a function; GET, PUT and PICK load, store
// and choose, and NEAR loads from the neighbors of joints.

#define AT(block, n) \
	GET((block) + (n)*MAX_LANES) // component n of a block: components of a joint are MAX_LANES floats apart

// The inverse of a symmetric block: 00, 01, 02, 11, 12, 22, by L D L^T.
INLINE void SOLVES(invert)(GLOBAL float* block)
{
	NUMBER d[6];
	for (int n = 0; n < 6; ++n)
		d[n] = AT(block, n);
	NUMBER d0 = d[0], l1 = d[1] / d0, l2 = d[2] / d0, d1 = d[3] - l1 * d[1], rest = d[4] - l1 * d[2];
	d1 = PICK(CHAIN_PIVOT * d[3], d1, d1 > CHAIN_PIVOT * d[3]);
	NUMBER l12 = rest / d1, d2 = (d[5] - l2 * d[2]) - l12 * rest;
	d2 = PICK(CHAIN_PIVOT * d[5], d2, d2 > CHAIN_PIVOT * d[5]);
	// columns of the inverse of L are (1, -l1, l1 l12 - l2), (0, 1, -l12), (0, 0, 1)
	NUMBER m2 = l1 * l12 - l2, i0 = 1.0f / d0, i1 = 1.0f / d1, i2 = 1.0f / d2;
	PUT(block, i0 + (l1 * i1 * l1 + m2 * i2 * m2));
	PUT(block + MAX_LANES, -l1 * i1 - m2 * i2 * l12);
	PUT(block + 2 * MAX_LANES, m2 * i2);
	PUT(block + 3 * MAX_LANES, i1 + l12 * i2 * l12);
	PUT(block + 4 * MAX_LANES, -l12 * i2);
	PUT(block + 5 * MAX_LANES, i2);
}

// A symmetric block times a vector.
INLINE void SOLVES(times)(const NUMBER d[6], const NUMBER v[3], NUMBER out[3])
{
	out[0] = d[0] * v[0] + d[1] * v[1] + d[2] * v[2];
	out[1] = d[1] * v[0] + d[3] * v[1] + d[4] * v[2];
	out[2] = d[2] * v[0] + d[4] * v[1] + d[5] * v[2];
}

// Prepares the joint at a spot to be taken out: inverts its block, and keeps what couples it with the one behind, if there is one.
INLINE void SOLVES(eliminate)(const Pools* p, int spot, int behind)
{
	SOLVES(invert)(&chain_at(p, d[0], spot));
	for (int n = 0; n < 9 && behind >= 0; ++n)
		PUT(&chain_at(p, m[n], spot), NEAR(l[n], behind));
}

// Takes the joint at spot `other`, eliminated, out of the one at a spot: side is -1 if it comes before, 1 if behind.
INLINE void SOLVES(take)(const Pools* p, int spot, int other, int side)
{
	NUMBER d[6], r[3], row[3][3], times[3][3], coupled[9];
	for (int n = 0; n < 6; ++n)
		d[n] = NEAR(d[n], other);
	for (int i = 0; i < 3; ++i)
	{
		r[i] = NEAR(r[i], other);
		for (int j = 0; j < 3; ++j)
			row[i][j] = side > 0 ? NEAR(l[3 * j + i], other) : GET(&chain_at(p, l[3 * i + j], spot));
	}
	for (int i = 0; i < 3; ++i)
		SOLVES(times)(d, row[i], times[i]); // row i of coupling times inverse
	for (int i = 0; i < 3; ++i)
		PUT(&chain_at(p, r[i], spot),
		    GET(&chain_at(p, r[i], spot)) - (times[i][0] * r[0] + times[i][1] * r[1] + times[i][2] * r[2]));
	for (int i = 0, n = 0; i < 3; ++i)
		for (int j = i; j < 3; ++j, ++n)
			PUT(&chain_at(p, d[n], spot),
			    GET(&chain_at(p, d[n], spot)) -
			        (times[i][0] * row[j][0] + times[i][1] * row[j][1] + times[i][2] * row[j][2]));
	if (side > 0)
		return;
	// what couples it with the joint before the one that was taken out
	for (int j = 0; j < 3; ++j)
	{
		NUMBER c0 = NEAR(l[j], other), c1 = NEAR(l[3 + j], other), c2 = NEAR(l[6 + j], other);
		for (int i = 0; i < 3; ++i)
			coupled[3 * i + j] = -(times[i][0] * c0 + times[i][1] * c1 + times[i][2] * c2);
	}
	for (int n = 0; n < 9; ++n)
		PUT(&chain_at(p, l[n], spot), coupled[n]);
}

// The solution of the joint at a spot, whose neighbors are solved. There may be none behind.
INLINE void SOLVES(back)(const Pools* p, int spot, int before, int behind)
{
	NUMBER r[3], x[3], d[6];
	for (int i = 0; i < 3; ++i)
		r[i] =
		    GET(&chain_at(p, r[i], spot)) - (GET(&chain_at(p, l[3 * i], spot)) * GET(&chain_at(p, x[0], before)) +
		                                     GET(&chain_at(p, l[3 * i + 1], spot)) * GET(&chain_at(p, x[1], before)) +
		                                     GET(&chain_at(p, l[3 * i + 2], spot)) * GET(&chain_at(p, x[2], before)));
	for (int i = 0; i < 3 && behind >= 0; ++i)
		r[i] = r[i] - (GET(&chain_at(p, m[i], spot)) * NEAR(x[0], behind) +
		               GET(&chain_at(p, m[3 + i], spot)) * NEAR(x[1], behind) +
		               GET(&chain_at(p, m[6 + i], spot)) * NEAR(x[2], behind));
	for (int n = 0; n < 6; ++n)
		d[n] = GET(&chain_at(p, d[n], spot));
	SOLVES(times)(d, r, x);
	for (int i = 0; i < 3; ++i)
		PUT(&chain_at(p, x[i], spot), x[i]);
}

// The solution of the joint that is left.
INLINE void SOLVES(last)(const Pools* p, int spot)
{
	NUMBER r[3], x[3], d[6];
	SOLVES(invert)(&chain_at(p, d[0], spot));
	for (int n = 0; n < 6; ++n)
		d[n] = GET(&chain_at(p, d[n], spot));
	for (int i = 0; i < 3; ++i)
		r[i] = GET(&chain_at(p, r[i], spot));
	SOLVES(times)(d, r, x);
	for (int i = 0; i < 3; ++i)
		PUT(&chain_at(p, x[i], spot), x[i]);
}

#undef AT
