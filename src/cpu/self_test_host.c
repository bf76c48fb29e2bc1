// SPDX-License-Identifier: MIT
// self_test_host.c -- compiles the operations of the self-test with the flags of all files but lanesN.c and
// scalar_avx2.c.
#define SELF_TEST self_test_host
#include "cpu/self_test_lanes.h"
