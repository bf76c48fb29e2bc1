// SPDX-License-Identifier: MIT
// instruction.h -- executes the operations of compiled expressions, on a stack of doubles.
#ifndef INSTRUCTION_H
#define INSTRUCTION_H
#include "scene/block_item.h"

typedef enum
{
	OP_CONSTANT,
	OP_INDEX,
	OP_NEGATE,
	OP_ADD,
	OP_SUBTRACT,
	OP_MULTIPLY,
	OP_DIVIDE,
	OP_ABS,
	OP_FLOOR,
	OP_CEIL,
	OP_SQRT,
	OP_SIN,
	OP_COS,
	OP_MIN,
	OP_MAX,
	OP_MOD,
	OP_RANDOM,
} Op;

typedef struct
{
	Op op;
	uint32_t argument; // slot of OP_INDEX, site of OP_RANDOM
	double value;      // value of OP_CONSTANT
} Instruction;

// Returns the number of values that an operation takes from the stack: 0, 1 or 2. Every operation puts one value on the
// stack.
int instruction_operands(Op op);

// Executes one instruction on a stack; **top is the last value. Returns null, or an error message.
const char* instruction_run(const Instruction* instruction, double** top, const Item* item);

#endif
