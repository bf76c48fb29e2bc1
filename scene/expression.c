// SPDX-License-Identifier: MIT
// expression.c -- arithmetic in scene files: compiles a text once, and evaluates it for up to millions of items.
//
// The compiler is a recursive descent parser of sums, products, signs and atoms. It writes postfix code for a small
// stack and already executes the operations on constants.
#include "scene/expression.h"
#include "scene/decimal.h"
#include "scene/instruction.h"
#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define STACK_SIZE  32
#define MAX_NESTING 64

struct Expression
{
	int count;
	Instruction code[];
};

static const struct
{
	const char* name;
	Op op;
	int arity;
} functions[] = {
    {"abs", OP_ABS, 1}, {"floor", OP_FLOOR, 1}, {"ceil", OP_CEIL, 1}, {"sqrt", OP_SQRT, 1}, {"sin", OP_SIN, 1},
    {"cos", OP_COS, 1}, {"min", OP_MIN, 2},     {"max", OP_MAX, 2},   {"mod", OP_MOD, 2},   {"random", OP_RANDOM, 2},
};
#define FUNCTION_COUNT (int)(sizeof functions / sizeof functions[0])

typedef struct
{
	const char* text;
	const char* at;
	const Scope* scope;
	uint32_t* sites;
	Expression* expression;
	int capacity, depth, nesting;
	char* error;
	size_t error_size;
} Parser;

static bool set_error(Parser* p, const char* what)
{
	snprintf(p->error, p->error_size, "%s at column %d", what, (int)(p->at - p->text) + 1);
	return false;
}

static bool emit(Parser* p, Op op, uint32_t argument, double value)
{
	Instruction instruction = {op, argument, value};
	int operands = instruction_operands(op);
	Expression* e = p->expression;

	// finds whether all operands are constants; then they are the last instructions of the code, one for each operand
	bool fold = operands > 0 && op != OP_RANDOM;
	for (int k = 1; k <= operands; ++k)
		fold = fold && e->code[e->count - k].op == OP_CONSTANT;
	if (fold)
	{
		double stack[2];
		for (int k = 0; k < operands; ++k)
			stack[k] = e->code[e->count - operands + k].value;
		double* top = stack + operands - 1;
		const char* fault = instruction_run(&instruction, &top, NULL);
		if (fault)
			return set_error(p, fault);
		e->count -= operands;
		instruction = (Instruction){OP_CONSTANT, 0, stack[0]};
	}
	p->depth += 1 - operands;
	if (p->depth >= STACK_SIZE)
		return set_error(p, "too many open operations");
	if (e->count == p->capacity)
	{
		p->capacity *= 2;
		e = realloc(e, sizeof(Expression) + (size_t)p->capacity * sizeof(Instruction));
		if (!e)
			return set_error(p, "out of memory");
		p->expression = e;
	}
	e->code[e->count++] = instruction;
	return true;
}

static bool accept(Parser* p, char c)
{
	while (isspace((unsigned char)*p->at))
		++p->at;
	if (*p->at != c)
		return false;
	++p->at;
	return true;
}

static bool sum(Parser* p);

static bool number(Parser* p)
{
	// finds the end of the number without strtod, which would also accept hexadecimal numbers and "inf"
	char digits[64];
	size_t length = strspn(p->at, "0123456789.");
	if (p->at[length] == 'e' || p->at[length] == 'E')
	{
		size_t sign = p->at[length + 1] == '-' || p->at[length + 1] == '+';
		size_t exponent = strspn(p->at + length + 1 + sign, "0123456789");
		if (exponent > 0)
			length += 1 + sign + exponent;
	}
	if (length >= sizeof digits)
		return set_error(p, "number too long");
	memcpy(digits, p->at, length);
	digits[length] = 0;
	double value;
	if (!decimal_read(digits, &value) || !isfinite(value))
		return set_error(p, "malformed number");
	p->at += length;
	return emit(p, OP_CONSTANT, 0, value);
}

static bool call(Parser* p, int f)
{
	if (!accept(p, '('))
		return set_error(p, "expected (");
	for (int k = 0; k < functions[f].arity; ++k)
	{
		if (k > 0 && !accept(p, ','))
			return set_error(p, "expected ,");
		if (!sum(p))
			return false;
	}
	if (!accept(p, ')'))
		return set_error(p, "expected )");
	uint32_t site = functions[f].op == OP_RANDOM ? (*p->sites)++ : 0;
	return emit(p, functions[f].op, site, 0);
}

static bool name(Parser* p)
{
	char text[NAME_SIZE] = {0};
	const char* start = p->at;
	while (isalnum((unsigned char)*p->at) || *p->at == '_')
		++p->at;
	size_t length = (size_t)(p->at - start);
	memcpy(text, start, length < NAME_SIZE ? length : NAME_SIZE - 1);
	for (int f = 0; f < FUNCTION_COUNT; ++f)
	{
		if (strcmp(text, functions[f].name) == 0)
			return call(p, f);
	}
	if (strcmp(text, "pi") == 0)
		return emit(p, OP_CONSTANT, 0, 3.14159265358979323846);
	const Name* found = length < NAME_SIZE ? scope_find(p->scope, text) : NULL;
	if (!found)
	{
		snprintf(p->error, p->error_size, "%s is no parameter, constant, index or function that is known here", text);
		return false;
	}
	return found->slot < 0 ? emit(p, OP_CONSTANT, 0, found->value) : emit(p, OP_INDEX, (uint32_t)found->slot, 0);
}

static bool atom(Parser* p)
{
	if (accept(p, '('))
		return sum(p) && (accept(p, ')') || set_error(p, "expected )"));
	if (isdigit((unsigned char)*p->at) || *p->at == '.')
		return number(p);
	if (isalpha((unsigned char)*p->at) || *p->at == '_')
		return name(p);
	return set_error(p, *p->at ? "unexpected character" : "unexpected end");
}

static bool sign(Parser* p)
{
	bool negative = false;
	while (accept(p, '-'))
		negative = !negative;
	return atom(p) && (!negative || emit(p, OP_NEGATE, 0, 0));
}

static bool product(Parser* p)
{
	if (!sign(p))
		return false;
	for (;;)
	{
		Op op = accept(p, '*') ? OP_MULTIPLY : accept(p, '/') ? OP_DIVIDE : OP_CONSTANT;
		if (op == OP_CONSTANT)
			return true;
		if (!sign(p) || !emit(p, op, 0, 0))
			return false;
	}
}

static bool sum(Parser* p)
{
	if (++p->nesting > MAX_NESTING)
		return set_error(p, "too many parentheses");
	if (!product(p))
		return false;
	for (;;)
	{
		Op op = accept(p, '+') ? OP_ADD : accept(p, '-') ? OP_SUBTRACT : OP_CONSTANT;
		if (op == OP_CONSTANT)
			break;
		if (!product(p) || !emit(p, op, 0, 0))
			return false;
	}
	--p->nesting;
	return true;
}

Expression* expression_compile(const char* text, const Scope* scope, uint32_t* sites, char* error, size_t error_size)
{
	Parser p = {.text = text, .at = text, .scope = scope, .sites = sites, .error = error, .error_size = error_size};
	p.capacity = 8;
	p.expression = malloc(sizeof(Expression) + (size_t)p.capacity * sizeof(Instruction));
	if (!p.expression)
	{
		set_error(&p, "out of memory");
		return NULL;
	}
	p.expression->count = 0;
	bool good = sum(&p);
	if (good && !accept(&p, 0))
		good = set_error(&p, "unexpected character");
	if (!good)
	{
		free(p.expression);
		return NULL;
	}
	return p.expression;
}

int expression_operations(const Expression* expression) { return expression->count; }

size_t expression_bytes(const Expression* expression)
{
	return sizeof *expression + (size_t)expression->count * sizeof *expression->code;
}

bool expression_is_constant(const Expression* expression, double* value)
{
	bool constant = expression->count == 1 && expression->code[0].op == OP_CONSTANT;
	if (constant)
		*value = expression->code[0].value;
	return constant;
}

const char* expression_evaluate(const Expression* expression, const Item* item, double* value)
{
	double stack[STACK_SIZE + 1];
	double* top = stack;
	*top = 0;
	for (int k = 0; k < expression->count; ++k)
	{
		const char* fault = instruction_run(&expression->code[k], &top, item);
		if (fault)
			return fault;
	}
	*value = *top;
	return isfinite(*top) ? NULL : "not finite";
}

bool name_is_allowed(const char* text)
{
	size_t length = strlen(text);
	if (length == 0 || length >= NAME_SIZE || strspn(text, "abcdefghijklmnopqrstuvwxyz_0123456789") != length ||
	    isdigit((unsigned char)text[0]) || strcmp(text, "pi") == 0)
		return false;
	for (int f = 0; f < FUNCTION_COUNT; ++f)
	{
		if (strcmp(text, functions[f].name) == 0)
			return false;
	}
	return true;
}

const Name* scope_find(const Scope* scope, const char* text)
{
	for (int k = scope->count - 1; k >= 0; --k)
	{
		if (strcmp(scope->names[k].text, text) == 0)
			return &scope->names[k];
	}
	return NULL;
}
