// SPDX-License-Identifier: MIT
// own_rounding.h -- computes correctly rounded quotients and square roots from results that are off by a few ulp.
//
// OpenCL permits errors of 2.5 ulp in a quotient and 3 ulp in a root unless a device has the flag
// -cl-fp32-correctly-rounded-divide-sqrt. Here such a device divides only numbers between 1 and 2, and takes roots of
// numbers between 1 and 4, so neither denormals nor the range of exponents matter. Integers of 32 bits correct its
// result: for a mantissa Q that is off by few units, the remainder is small, and is exact although its terms wrap
// around.
//
// The file that includes this one defines inexact_quotient(a, b) and inexact_root(x).
#ifndef OWN_ROUNDING_H
#define OWN_ROUNDING_H

// inlined at nearly 200 divisions, these functions would take minutes to compile on a GPU
#define ROUNDING_CALL static __attribute__((noinline))

#define ROUNDING_NAN 0x7fc00000u
#define ROUNDING_INF 0x7f800000u
// bound of the error of an inexact result, in units of the last place of a mantissa: 3 ulp can be 6 units just above a
// power of two, and the truncation to an integer adds one
#define ROUNDING_UNITS 8

// Splits a positive finite number into a mantissa of 2^23 to 2^24 - 1 and a biased exponent, which for a denormal is 0
// or less.
INLINE Word rounding_mantissa(Word bits, int* exponent)
{
	int shift = bits < 0x800000u ? leading_zeros((Word64)bits << 32) - 8 : 0;
	*exponent = bits < 0x800000u ? 1 - shift : (int)(bits >> 23);
	return bits < 0x800000u ? bits << shift : (bits & 0x7fffffu) | 0x800000u;
}

// Returns the float of 1 to 2 with a mantissa.
INLINE float rounding_unit(Word mantissa) { return bits_float((int)((mantissa & 0x7fffffu) | 0x3f800000u)); }

// Rounds a positive quotient to nearest, ties to even. mantissa: 2^23 to 2^24 - 1, without the fraction. twice: double
// the fraction compared with 1: -1, 0, 1; none: 1 if the fraction is 0. Results that are too large are infinite, small
// ones are denormal.
INLINE Word rounding_result(Word mantissa, int exponent, int twice, int none)
{
	if (exponent >= 255)
		return ROUNDING_INF;
	if (exponent > 0)
	{
		Word up = (Word)(twice > 0) | ((Word)(twice == 0) & mantissa & 1u);
		return ((Word)exponent << 23) + (mantissa - 0x800000u) + up;
	}
	if (exponent < -23)
		return 0u;
	Word drop = (Word)(1 - exponent), tie = 1u << (drop - 1u), lost = mantissa & (2u * tie - 1u);
	Word kept = mantissa >> drop;
	return kept + (Word)(lost > tie || (lost == tie && (!none || (kept & 1u))));
}

// Returns a / b as IEEE 754 defines it, except that a NaN is always the same one.
ROUNDING_CALL float own_quotient(float a, float b)
{
	Word sign = (float_word(a) ^ float_word(b)) & 0x80000000u;
	Word wa = float_word(a) & 0x7fffffffu, wb = float_word(b) & 0x7fffffffu;
	if (wa > ROUNDING_INF || wb > ROUNDING_INF || (wa == wb && (wa == 0u || wa == ROUNDING_INF)))
		return bits_float((int)ROUNDING_NAN);
	if (wa == ROUNDING_INF || wb == 0u)
		return bits_float((int)(sign | ROUNDING_INF));
	if (wa == 0u || wb == ROUNDING_INF)
		return bits_float((int)sign);
	int ea, eb;
	Word ma = rounding_mantissa(wa, &ea), mb = rounding_mantissa(wb, &eb);
	int shift = ma < mb ? 24 : 23;
	// the quotient of the mantissas, times 2^shift, is 2^23 to 2^24
	Word q = (Word)(inexact_quotient(rounding_unit(ma), rounding_unit(mb)) * (ma < mb ? 16777216.0f : 8388608.0f));
	q -= ROUNDING_UNITS;
	int divisor = (int)mb, rest = (int)((ma << shift) - q * mb);
	for (int units = ROUNDING_UNITS; units > 0; units /= 2)
	{
		int larger = rest >= units * divisor ? units : 0;
		q += (Word)larger;
		rest -= larger * divisor;
	}
	int twice = (2 * rest > divisor) - (2 * rest < divisor);
	return bits_float((int)(sign | rounding_result(q, ea - eb + 150 - shift, twice, rest == 0)));
}

// Returns the square root of x as IEEE 754 defines it, except that a NaN is always the same one.
ROUNDING_CALL float own_root(float x)
{
	Word w = float_word(x);
	if ((w & 0x7fffffffu) == 0u || w == ROUNDING_INF)
		return x;
	if (w > ROUNDING_INF)
		return bits_float((int)ROUNDING_NAN);
	int exponent;
	Word m = rounding_mantissa(w, &exponent);
	// with an even exponent, x is m times 2^(2 power - 23); then m is 2^23 to 2^25
	int odd = (exponent + 1) & 1, power = (exponent - 127 - odd) / 2;
	float unit = rounding_unit(m);
	Word q = (Word)(inexact_root(odd ? 2.0f * unit : unit) * 8388608.0f);
	// the root of m times 2^23 is 2^23 to 2^24
	q -= ROUNDING_UNITS;
	int rest = (int)((m << (23 + odd)) - q * q);
	for (int units = ROUNDING_UNITS; units > 0; units /= 2)
	{
		int square = units * (2 * (int)q + units), larger = rest >= square; // square: (q + units)^2 - q^2
		q += (Word)(larger * units);
		rest -= larger * square;
	}
	// (q + 1/2)^2 is no integer, so there is no tie
	return bits_float((int)(((Word)(power + 127) << 23) + (q - 0x800000u) + (Word)(rest > (int)q)));
}

#endif
