// SPDX-License-Identifier: MIT
// bench_whole.h -- scree bench --whole: measures runs from end to end, including the time to open the device.
#ifndef BENCH_WHOLE_H
#define BENCH_WHOLE_H
#include "cli/common/options.h"

// Measures all scenes and prints one row per run. Returns an exit code.
int measure_whole_runs(const Options* options, Scene** scenes, int count);

#endif
