// SPDX-License-Identifier: MIT
// instruction.c -- executes the operations of compiled expressions, on a stack of doubles.
//
// Each operation is a separate statement, so that no compiler can contract two operations into one.
#include "scene/instruction.h"
#include "scree/scree.h"
#include <math.h>

int instruction_operands(Op op)
{
	return op <= OP_INDEX ? 0 : op == OP_NEGATE || (op >= OP_ABS && op <= OP_COS) ? 1 : 2;
}

// Returns a uniform random number in [0, 1), which depends only on the arguments. The mixing steps are those of
// splitmix64 (Steele, Lea, Flood, Fast Splittable Pseudorandom Number Generators, 2014).
static double random_unit(uint64_t seed, uint64_t site, uint64_t number)
{
	uint64_t x = seed * 0x9e3779b97f4a7c15u + site * 0xd1b54a32d192ed03u + number;
	for (int round = 0; round < 2; ++round)
	{
		x += 0x9e3779b97f4a7c15u;
		x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
		x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
		x ^= x >> 31;
	}
	return (double)(x >> 11) * 0x1p-53;
}

// Replaces *value by the result of an operation with one operand. Returns null, or an error message.
static const char* run_unary(Op op, double* value)
{
	double a = *value;
	switch (op)
	{
	case OP_NEGATE:
		*value = -a;
		break;
	case OP_ABS:
		*value = a < 0 ? -a : a;
		break;
	case OP_FLOOR:
		*value = floor(a);
		break;
	case OP_CEIL:
		*value = ceil(a);
		break;
	case OP_SQRT:
		if (a < 0)
			return "square root of a negative number";
		*value = sqrt(a);
		break;
	case OP_SIN:
		*value = scree_rot_make((float)a).s;
		break;
	default: // OP_COS
		*value = scree_rot_make((float)a).c;
		break;
	}
	return NULL;
}

static const char* divide(Op op, double* a, double b)
{
	if (b == 0)
		return "division by zero";
	double quotient = *a / b;
	if (op == OP_DIVIDE)
		*a = quotient;
	else // OP_MOD
	{
		double multiple = floor(quotient) * b;
		*a -= multiple;
	}
	return NULL;
}

// Replaces *a by the result of an operation with the operands *a and b. Returns null, or an error message.
static const char* run_binary(const Instruction* i, double* a, double b, const Item* item)
{
	switch (i->op)
	{
	case OP_ADD:
		*a += b;
		break;
	case OP_SUBTRACT:
		*a -= b;
		break;
	case OP_MULTIPLY:
		*a *= b;
		break;
	case OP_DIVIDE:
	case OP_MOD:
		return divide(i->op, a, b);
	case OP_MIN:
		*a = b < *a ? b : *a;
		break;
	case OP_MAX:
		*a = *a < b ? b : *a;
		break;
	default: // OP_RANDOM
	{
		double span = b - *a;
		span *= random_unit(item->seed, i->argument, item->number);
		*a += span;
	}
	}
	return NULL;
}

const char* instruction_run(const Instruction* i, double** top, const Item* item)
{
	switch (instruction_operands(i->op))
	{
	case 0:
		*++*top = i->op == OP_CONSTANT ? i->value : item->indices[i->argument];
		return NULL;
	case 1:
		return run_unary(i->op, *top);
	default:
		--*top;
		return run_binary(i, *top, (*top)[1], item);
	}
}
