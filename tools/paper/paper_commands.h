// SPDX-License-Identifier: MIT
// paper_commands.h -- declares the commands of scree_paper. Each returns an exit code.
#ifndef PAPER_COMMANDS_H
#define PAPER_COMMANDS_H
#include "cli/common/options.h"

int paper_run_command(const Options* options);
int paper_hash_command(const Options* options);
int paper_bench_command(const Options* options);
int figure5_command(const Options* options);
int figure6_command(const Options* options);

#endif
