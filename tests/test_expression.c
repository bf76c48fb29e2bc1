// SPDX-License-Identifier: MIT
// test_expression.c -- checks expressions of scene files: values, constants, random numbers, and bad input with its
// message.
#include "scene/expression.h"
#include "support/checks.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

static double value_of(const char* text)
{
	char error[160];
	Scope scope = {2, {{"rows", -1, 12}, {"i", 0, 0}}};
	const double indices[] = {3};
	uint32_t sites = 0;
	Expression* expression = expression_compile(text, &scope, &sites, error, sizeof error);
	if (!expression)
		fail_msg("%s: %s", text, error);
	Item item = {indices, 1, 0};
	double value = 0;
	const char* fault = expression_evaluate(expression, &item, &value);
	if (fault)
		fail_msg("%s: %s", text, fault);
	free(expression);
	return value;
}

static void test_values(void** state)
{
	(void)state;
	const struct
	{
		const char* text;
		double value;
	} cases[] = {
	    {"1", 1},
	    {" 2 * i + 0.5 * rows ", 12},
	    {"1 - 2 - 3", -4},
	    {"8 / 4 / 2", 1},
	    {"2 + 3 * 4", 14},
	    {"(2 + 3) * 4", 20},
	    {"-i", -3},
	    {"--i", 3},
	    {"2 - -2", 4},
	    {"-2 * -3", 6},
	    {"1.5e2 + 1E-1", 150.1},
	    {".5", 0.5},
	    {"floor(-0.5)", -1},
	    {"ceil(0.2)", 1},
	    {"abs(-i)", 3},
	    {"sqrt(16)", 4},
	    {"min(i, 2)", 2},
	    {"max(i, 2)", 3},
	    {"mod(7, i)", 1},
	    {"mod(-1, 3)", 2},
	    {"mod(i, rows) * (rows - 1) / 2", 16.5},
	    {"random(5, 5)", 5},
	};
	for (size_t k = 0; k < sizeof cases / sizeof cases[0]; ++k)
		assert_true(value_of(cases[k].text) == cases[k].value);
	// sine and cosine are approximated by polynomials in single precision
	assert_true(fabs(value_of("sin(pi / 6)") - 0.5) < 1e-6);
	assert_true(fabs(value_of("cos(pi)") + 1) < 1e-6);
}

static void test_constants_fold(void** state)
{
	(void)state;
	char error[160];
	const Scope scope = {2, {{"rows", -1, 12}, {"i", 0, 0}}};
	uint32_t sites = 0;
	double value;
	Expression* expression = expression_compile("-(rows + 3) * 2 / sqrt(4)", &scope, &sites, error, sizeof error);
	assert_true(expression_is_constant(expression, &value) && value == -15);
	free(expression);
	expression = expression_compile("rows * i", &scope, &sites, error, sizeof error);
	assert_false(expression_is_constant(expression, &value));
	free(expression);
	expression = expression_compile("random(0, 1)", &scope, &sites, error, sizeof error);
	assert_false(expression_is_constant(expression, &value));
	free(expression);
}

static void test_bad_expressions(void** state)
{
	(void)state;
	const struct
	{
		const char* text;
		const char* sentence;
	} cases[] = {
	    {"", "unexpected end at column 1"},
	    {"1 +", "unexpected end at column 4"},
	    {"1 2", "unexpected character at column 3"},
	    {"(1", "expected ) at column 3"},
	    {"1)", "unexpected character at column 2"},
	    {"2 # 3", "unexpected character at column 3"},
	    {"1.2.3", "malformed number"},
	    {"1e999", "malformed number"},
	    {"0x10", "unexpected character"},
	    {"nan", "nan is no parameter"},
	    {"column", "column is no parameter"},
	    {"sin", "expected ("},
	    {"min(1)", "expected ,"},
	    {"abs(1, 2)", "expected )"},
	    {"1 / 0", "division by zero"},
	    {"1 / (i - i)", NULL},
	    {"mod(1, 0)", "division by zero"},
	    {"sqrt(-1)", "square root of a negative number"},
	};
	const Scope scope = {1, {{"i", 0, 0}}};
	for (size_t k = 0; k < sizeof cases / sizeof cases[0]; ++k)
	{
		char error[160] = "";
		uint32_t sites = 0;
		Expression* expression = expression_compile(cases[k].text, &scope, &sites, error, sizeof error);
		if (cases[k].sentence && (expression || !strstr(error, cases[k].sentence)))
			fail_msg("\"%s\": \"%s\" instead of \"%s\"", cases[k].text, error, cases[k].sentence);
		free(expression);
	}

	// errors that depend on an index are found by evaluation, not by compilation
	char error[160], deep[400] = "";
	const double indices[] = {3};
	Item item = {indices, 1, 0};
	uint32_t sites = 0;
	double value;
	Expression* expression = expression_compile("1 / (i - 3)", &scope, &sites, error, sizeof error);
	assert_string_equal(expression_evaluate(expression, &item, &value), "division by zero");
	free(expression);
	memset(deep, '(', 300);
	assert_null(expression_compile(deep, &scope, &sites, error, sizeof error));
	memset(deep, 0, sizeof deep);
	for (int k = 0; k < 60; ++k)
		strcat(deep, "i+(");
	assert_null(expression_compile(deep, &scope, &sites, error, sizeof error));
}

// Each call of random() in an expression has its own random numbers. They are evenly distributed and the same in every
// run.
static void test_random(void** state)
{
	(void)state;
	char error[160];
	const Scope none = {0};
	uint32_t sites = 0;
	Expression* first = expression_compile("random(-1, 1)", &none, &sites, error, sizeof error);
	Expression* second = expression_compile("random(-1, 1)", &none, &sites, error, sizeof error);
	assert_int_equal(sites, 2);
	double sum = 0, product = 0, a = 0, b = 0;
	for (int k = 0; k < 10000; ++k)
	{
		Item item = {NULL, 1, (uint64_t)k};
		assert_null(expression_evaluate(first, &item, &a));
		assert_null(expression_evaluate(second, &item, &b));
		assert_true(a >= -1 && a < 1);
		sum += a;
		product += a * b;
	}
	// the means of 10,000 samples are 0, with standard deviations of 0.0058 for the number and 0.0033 for the product
	assert_true(fabs(sum / 10000) < 0.03 && fabs(product / 10000) < 0.02);
	Item item = {NULL, 1, 0};
	assert_null(expression_evaluate(first, &item, &a));
	assert_true(a == -0x1.ca460c3079e44p-2);
	free(first);
	free(second);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(test_values),
	    cmocka_unit_test(test_constants_fold),
	    cmocka_unit_test(test_bad_expressions),
	    cmocka_unit_test(test_random),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
