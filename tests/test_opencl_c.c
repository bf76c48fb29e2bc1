// SPDX-License-Identifier: MIT
// test_opencl_c.c -- checks that the embedded program is strictly OpenCL C 1.2, because PoCL accepts code that other
// drivers refuse, and that with own rounding it leaves no other quotient or root to the device.
//
// The clang of the system compiles the program, and reports every extension of the standard as an error. This test has
// found variadic macros, which NVIDIA's driver does not support. Quotients and roots are counted in LLVM's language.
#include "opencl/device.h"
#include "support/checks.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

extern const char opencl_program[], arithmetic_program[]; // written by cmake/embed.cmake
extern const size_t opencl_program_length, arithmetic_program_length;

#define CLANG "clang -x cl -cl-std=CL1.2 -target spir64 -Xclang -finclude-default-header"
#define CHECK CLANG " -fsyntax-only -pedantic-errors"

#define NEEDS_CLANG()                                       \
	do                                                      \
	{                                                       \
		if (system("clang --version >/dev/null 2>&1") != 0) \
		{                                                   \
			print_message("skipped: there is no clang\n");  \
			skip();                                         \
		}                                                   \
	} while (0)

static void program_is_standard(void** state)
{
	(void)state;
	const struct
	{
		const char *options, *text;
		size_t length;
	} programs[] = {
	    {"", opencl_program, opencl_program_length},
	    {" -DRESIDENT", opencl_program, opencl_program_length},
	    {" -DRESIDENT -DTILES -DPERSISTENT", opencl_program, opencl_program_length},
	    {" -DRESIDENT -DTILES -DPERSISTENT -DWORLD_ALONE", opencl_program, opencl_program_length},
	    {" -DCALLS", opencl_program, opencl_program_length},
	    {"", arithmetic_program, arithmetic_program_length},
	    {" -DOWN_ROUNDING", arithmetic_program, arithmetic_program_length},
	};
	NEEDS_CLANG();
	for (size_t k = 0; k < sizeof programs / sizeof *programs; ++k)
	{
		char command[512];
		snprintf(command, sizeof command, CHECK "%s - 1>&2", programs[k].options);
		FILE* compiler = popen(command, "w");
		assert_non_null(compiler);
		assert_int_equal(fwrite(programs[k].text, 1, programs[k].length, compiler), programs[k].length);
		if (pclose(compiler) != 0)
			fail_msg("clang refuses program %zu with \"%s\"", k, programs[k].options);
	}
}

typedef struct // instructions of a program in LLVM's language
{
	int quotients, roots;             // in own_quotient and own_root
	int other_quotients, other_roots; // in other functions
	int fused;                        // products that may be fused with sums
} Instructions;

static Instructions count_instructions(const char* options)
{
	char path[512], command[1024], line[4096], function[4096] = "";
	snprintf(path, sizeof path, "%s/test_opencl_c.cl", getenv("SCREE_BUILD"));
	FILE* text = fopen(path, "w");
	assert_non_null(text);
	assert_int_equal(fwrite(opencl_program, 1, opencl_program_length, text), opencl_program_length);
	assert_int_equal(fclose(text), 0);
	snprintf(command, sizeof command, CLANG "%s -O0 -S -emit-llvm -o - '%s'", options, path);
	FILE* compiler = popen(command, "r");
	assert_non_null(compiler);
	Instructions found = {.quotients = 0};
	while (fgets(line, sizeof line, compiler))
	{
		if (strncmp(line, "define ", 7) == 0)
			memcpy(function, line, sizeof function);
		bool root = strstr(line, "call ") && strstr(line, "sqrt");
		bool quotient =
		    strstr(line, " fdiv ") || strstr(line, " frem ") || strstr(line, "divide") || strstr(line, "recip");
		*(strstr(function, "@own_root(") ? &found.roots : &found.other_roots) += root;
		*(strstr(function, "@own_quotient(") ? &found.quotients : &found.other_quotients) += quotient;
		found.fused += strstr(line, "fmuladd") || strstr(line, "llvm.fma") || strstr(line, " contract ");
	}
	assert_int_equal(pclose(compiler), 0);
	remove(path);
	print_message("%s: %d quotients and %d roots in own rounding, %d and %d elsewhere, %d fused products\n", options,
	              found.quotients, found.roots, found.other_quotients, found.other_roots, found.fused);
	return found;
}

static void own_rounding_is_complete(void** state)
{
	(void)state;
	NEEDS_CLANG();
	Instructions own = count_instructions(" -DRESIDENT -DTILES -DPERSISTENT -DCALLS -DOWN_ROUNDING");
	assert_int_equal(own.quotients, 1);
	assert_int_equal(own.roots, 1);
	assert_int_equal(own.other_quotients, 0);
	assert_int_equal(own.other_roots, 0);
	assert_int_equal(own.fused, 0);

	// the count finds quotients, roots and fused products
	Instructions plain = count_instructions(" -DRESIDENT -DTILES -DPERSISTENT -DCALLS -DFUSED");
	assert_int_equal(plain.quotients + plain.roots, 0);
	assert_true(plain.other_quotients > 100 && plain.other_roots > 20 && plain.fused > 100);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(program_is_standard),
	    cmocka_unit_test(own_rounding_is_complete),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
