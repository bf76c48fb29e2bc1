// SPDX-License-Identifier: MIT
// wrong_flags.c -- prints the fault that the self-test finds in operations with the compiler flags of this file.
//
// test_flags.sh compiles it with wrong flags, without the checks of exact_floats.h, and links it with the library.
#define SELF_TEST self_test_wrong
#include "cpu/self_test_lanes.h"
#include <stdio.h>

int main(void)
{
	SelfTest found = self_test_find(self_test_wrong);
	if (found == SELF_TESTS)
		puts("no fault");
	else
		printf("%s; %s\n", self_test_fault(found), self_test_remedy(found));
	return 0;
}
