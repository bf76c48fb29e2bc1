// SPDX-License-Identifier: MIT
// expression.h -- arithmetic in scene files: compiles a text once, and evaluates it for up to millions of items.
//
// A scene gives the same floats on every machine. So expressions use only + - * / sqrt floor and comparisons of
// doubles, Scree's own sine and cosine, and random numbers that are hashes of the item's number.
#ifndef EXPRESSION_H
#define EXPRESSION_H
#include "scene/block_item.h"
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define NAME_SIZE 32
#define MAX_NAMES 128

typedef struct
{
	char text[NAME_SIZE];
	int slot;     // position in Item.indices; -1 for a constant
	double value; // value of a constant
} Name;

typedef struct // names that an expression may use
{
	int count;
	Name names[MAX_NAMES];
} Scope;

typedef struct Expression Expression;

// Compiles a text. On an error it writes a message and returns null. *sites counts the random() calls of a whole scene,
// so that each call gives different numbers. The caller frees the expression with free().
Expression* expression_compile(const char* text, const Scope* scope, uint32_t* sites, char* error, size_t error_size);

// Returns the number of operations, and the size in memory.
int expression_operations(const Expression* expression);
size_t expression_bytes(const Expression* expression);

// Returns true if the value is the same for all items; then *value is set to it.
bool expression_is_constant(const Expression* expression, double* value);

// Sets *value to a finite number and returns null, or returns an error message.
const char* expression_evaluate(const Expression* expression, const Item* item, double* value);

// Returns true if a parameter or an index may have this name: small letters, digits and underscores, not a function.
bool name_is_allowed(const char* name);

// Finds a name in a scope; returns null if the scope does not have the name.
const Name* scope_find(const Scope* scope, const char* name);

#endif
