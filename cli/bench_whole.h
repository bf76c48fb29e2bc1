// SPDX-License-Identifier: MIT
// bench_whole.h -- scree bench --whole: times runs from end to end, the opening of the device included.
#ifndef BENCH_WHOLE_H
#define BENCH_WHOLE_H
#include "cli/common/options.h"

// Measures all scenes and prints one row a run. Returns an exit code.
int measure_whole_runs(const Options* options, Scene** scenes, int count);

#endif
