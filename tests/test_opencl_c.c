// SPDX-License-Identifier: MIT
// test_opencl_c.c -- checks that the embedded program is strictly OpenCL C 1.2, because PoCL accepts code that other
// drivers refuse.
//
// The clang of the system compiles the program, and reports every extension of the standard as an error. This test has
// found variadic macros, which NVIDIA's driver does not support.
#include "opencl/device.h"
#include "support/checks.h"
#include <stdio.h>
#include <stdlib.h>

extern const char opencl_program[]; // written by cmake/embed.cmake
extern const size_t opencl_program_length;

#define CHECK "clang -x cl -cl-std=CL1.2 -target spir64 -Xclang -finclude-default-header -fsyntax-only -pedantic-errors"

static void program_is_standard(void** state)
{
	(void)state;
	static const char* const forms[] = {"", " -DRESIDENT", " -DRESIDENT -DTILES -DPERSISTENT", " -DCALLS"};
	if (system("clang --version >/dev/null 2>&1") != 0)
	{
		print_message("skipped: there is no clang\n");
		skip();
	}
	for (size_t k = 0; k < sizeof forms / sizeof *forms; ++k)
	{
		char command[512];
		snprintf(command, sizeof command, CHECK "%s - 1>&2", forms[k]);
		FILE* compiler = popen(command, "w");
		assert_non_null(compiler);
		assert_int_equal(fwrite(opencl_program, 1, opencl_program_length, compiler), opencl_program_length);
		if (pclose(compiler) != 0)
			fail_msg("clang refuses the program with \"%s\"", forms[k]);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(program_is_standard)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
