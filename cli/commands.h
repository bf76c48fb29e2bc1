// SPDX-License-Identifier: MIT
// commands.h -- the commands of scree; each returns an exit code.
#ifndef COMMANDS_H
#define COMMANDS_H
#include "options.h"

int run_command(const Options* options);
int hash_command(const Options* options);
int scenes_command(const Options* options);
int devices_command(const Options* options);
int bench_command(const Options* options);
int figure_command(const Options* options, int number);               // 5 or 6; of bench
int whole_command(const Options* options, Scene** scenes, int count); // of bench

#endif
