// SPDX-License-Identifier: MIT
// commands.h -- declares the commands of scree. Each function returns an exit code.
#ifndef COMMANDS_H
#define COMMANDS_H
#include "cli/common/options.h"

int run_command(const Options* options);
int hash_command(const Options* options);
int scenes_command(const Options* options);
int devices_command(const Options* options);
int bench_command(const Options* options);
int frames_command(const Options* options);  // the command bench frames
int queries_command(const Options* options); // the command bench queries
int view_command(const Options* options);
int replay_command(const Options* options);
int diff_command(const Options* options);
int validate_command(const Options* options);

#endif
