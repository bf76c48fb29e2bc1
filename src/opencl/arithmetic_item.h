// SPDX-License-Identifier: MIT
// arithmetic_item.h -- computes one result of the test of a device's arithmetic; host and device compile this function.
//
// The file that includes this one defines N(x), which is x. The host marks denormal intermediate results in it.
#ifndef ARITHMETIC_ITEM_H
#define ARITHMETIC_ITEM_H
#include "dialect/dialect.h"
#include "dialect/hash_word.h"

enum
{
#define X(name, type, text, expression) ARITHMETIC_##name,
#include "opencl/arithmetic.def"
#undef X
	ARITHMETIC_OPERATIONS
};

// results per operation: over 100,000 in all, which an EPYC computes in 5 ms
#define ARITHMETIC_CASES   3072
#define ARITHMETIC_RESULTS (ARITHMETIC_OPERATIONS * ARITHMETIC_CASES)

typedef struct
{
	float a, b, c;
} Operands;

enum // kinds of operands
{
	OPERAND_NEAR,    // 2^-8 to 2^8, whose sums and products are rounded
	OPERAND_WIDE,    // any exponent, also with results that are infinite or denormal
	OPERAND_FEW,     // few bits, with quotients near ties
	OPERAND_WHOLE,   // below 2^31
	OPERAND_SMALL,   // denormal, or of one of the least exponents
	OPERAND_SPECIAL, // zeros, infinities, NaN, 1, the largest and the least normal number
};

// Finalizer of MurmurHash3 for 32 bits (Austin Appleby, 2011). Operands are made by integers, which every device has.
INLINE Word operand_word(Word n)
{
	n ^= n >> 16;
	n *= 0x85ebca6bu;
	n ^= n >> 13;
	n *= 0xc2b2ae35u;
	return n ^ n >> 16;
}

INLINE Word operand_special(Word n)
{
	switch (n & 7u)
	{
	case 0:
	case 1:
		return 0u;
	case 2:
		return 0x7f800000u;
	case 3:
		return 0x7fc00000u;
	case 4:
		return 0x3f800000u;
	case 5:
		return 0x7f7fffffu;
	case 6:
		return 0x00800000u;
	default:
		return 0x40400000u;
	}
}

INLINE float operand(Word n, int kind)
{
	Word word = operand_word(2u * n), more = operand_word(2u * n + 1u);
	Word sign = word & 0x80000000u, mantissa = word & 0x7fffffu, exponent = 119u + (more & 15u);
	if (kind == OPERAND_WIDE)
		exponent = 1u + more % 254u;
	if (kind == OPERAND_FEW)
		mantissa &= 0x600003u;
	if (kind == OPERAND_WHOLE)
		exponent = 100u + more % 58u;
	if (kind == OPERAND_SMALL)
		exponent = more & 3u;
	Word number = exponent << 23 | mantissa;
	return bits_float((int)(sign | (kind == OPERAND_SPECIAL ? operand_special(more) : number)));
}

// Returns the operands of a case, a number below ARITHMETIC_CASES, of an operation.
INLINE Operands operands_of(int operation, int number)
{
	Word n = 3u * (Word)(operation * ARITHMETIC_CASES + number);
	int turn = number & 15, others = OPERAND_NEAR;
	if (turn >= 6 && turn <= 8)
		others = OPERAND_WIDE;
	if (turn == 9)
		others = OPERAND_FEW;
	if (turn == 13)
		others = OPERAND_SPECIAL;
	if (turn == 15)
		others = OPERAND_SMALL;
	int first = turn == 11 || turn == 12 ? OPERAND_SPECIAL : turn == 14 ? OPERAND_SMALL : others;
	Operands o;
	o.a = operand(n, operation == ARITHMETIC_WHOLE ? OPERAND_WHOLE : first);
	o.b = operand(n + 1u, others);
	o.c = operand(n + 2u, others);
	if (turn == 10) // differences are zero
	{
		o.b = o.a;
		o.c = -o.a;
	}
	return o;
}

#define FLOAT_RESULT(x) float_word(N(x))
#define WORD_RESULT(x)  ((Word)(x))

// Returns the bits of the result of a case.
INLINE Word arithmetic_result(int operation, int number)
{
	Operands o = operands_of(operation, number);
	float a = o.a, b = o.b, c = o.c;
	Word i = float_word(a), j = float_word(b);
	switch (operation)
	{
#define X(name, type, text, expression) \
	case ARITHMETIC_##name:             \
		return type##_RESULT(expression);
#include "opencl/arithmetic.def"
#undef X
	default:
		return 0u;
	}
}

#endif
